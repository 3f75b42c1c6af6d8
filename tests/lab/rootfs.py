"""Root file systems of the stand-in images, made from the machine's own Debian sources, and their way out."""

from __future__ import annotations

import os
import re
import shutil
from pathlib import Path

from . import facts, packages
from .command import LabError, run
from .home import folder, recipe

CERTIFICATES = "etc/lab/certificates.pem"


def make(architecture: str, suite: str | None = None) -> Path:
    """Return the tar of a minimal Debian for this architecture, made once; a foreign one needs emulation.

    `suite` is Debian's name of a release, the usual one unless said.
    """
    suite, variant = suite or facts.text("rootfs", "suite"), facts.text("rootfs", "variant")
    sources, settings = _sources(suite), _apt_settings()
    path = folder("rootfs") / f"{architecture}-{recipe(suite, variant, sources, settings)}.tar"
    if path.exists():
        return path
    packages.install(facts.texts("rootfs", "packages"))
    written = folder("rootfs") / f"{architecture}-{suite}.sources"
    written.write_text(sources)
    unfinished = path.with_suffix(".part.tar")
    options = [f"--aptopt={line}" for line in settings]
    run(
        ["nice", "mmdebstrap", f"--variant={variant}", f"--architectures={architecture}", "--format=tar", *options,
         suite, unfinished, written],
        log=f"rootfs-{architecture}",
    )  # fmt: skip
    unfinished.rename(path)
    return path


def machine(place: Path) -> None:
    """Write into `place` the files a stand-in needs to reach this machine's package registries from inside a build.

    They are read off the machine when the images are made and are in no file of the repository: certificates and pip's
    settings here, apt's sources and settings already in the root file system.
    """
    shutil.rmtree(place, ignore_errors=True)
    bundle = Path(os.environ.get("SSL_CERT_FILE") or "/etc/ssl/certs/ca-certificates.crt")
    target = place / CERTIFICATES
    target.parent.mkdir(parents=True)
    target.write_bytes(bundle.read_bytes() if bundle.is_file() else b"")
    lines = [f"cert = /{CERTIFICATES}", *_pip_settings()]
    (place / "etc" / "pip.conf").write_text("[global]\n" + "\n".join(lines) + "\n")
    # Older installers read this one only.
    (place / "etc" / "xdg" / "pip").mkdir(parents=True)
    shutil.copy(place / "etc" / "pip.conf", place / "etc" / "xdg" / "pip" / "pip.conf")


def _pip_settings() -> list[str]:
    wanted = ("index-url", "extra-index-url", "trusted-host", "proxy", "default-timeout", "timeout")
    try:
        listed = run(["python3", "-m", "pip", "config", "list"])
    except LabError:
        listed = ""
    found = {}
    for line in listed.splitlines():
        key, _, value = line.partition("=")
        name = key.rpartition(".")[2]
        if name in wanted:
            found["timeout" if name == "default-timeout" else name] = value.strip("'\"")
    return [f"{name} = {value}" for name, value in sorted(found.items())]


def _sources(suite: str) -> str:
    """Return the machine's own apt sources of this suite and its updates; a source of anything else is left out."""
    wanted = []
    for path in sorted((packages.SOURCES / "sources.list.d").glob("*.sources")):
        for stanza in re.split(r"\n\s*\n", path.read_text()):
            if re.search(rf"^Suites:.*\b{suite}(?![\w])", stanza, re.MULTILINE):
                lines = [line for line in stanza.splitlines() if not line.startswith(("#", "Architectures:"))]
                wanted.append("\n".join(lines).strip())
    if not wanted:
        wanted.append(packages.newer_source(suite).strip())
    if not wanted[0].startswith("deb "):
        wanted = [stanza for stanza in wanted if "Types:" in stanza and "/debian" in stanza]
    return "\n\n".join(wanted) + "\n"


def _apt_settings() -> list[str]:
    """Return the machine's settings of how apt fetches (proxies, certificates, checks), whichever file they are in."""
    dumped = run(["apt-config", "dump", "--format", '%F "%v";%n', "Acquire"])
    wanted = re.compile(r"Acquire::(http|https|Check|Max-|Retries)[\w:-]*.* \"[^\"]+\";$", re.IGNORECASE)
    return [line for line in dumped.splitlines() if wanted.match(line)]
