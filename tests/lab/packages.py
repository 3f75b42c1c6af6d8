"""Install from the machine's own package clients: apt, pip in private environments, go into the lab's bin."""

from __future__ import annotations

import os
import re
import shutil
import sys
import threading
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from . import facts
from .command import LabError, run, succeeds
from .home import folder, recipe

SOURCES = Path("/etc/apt")
# Without these apt also fetches icons and component descriptions, four times as much as the index itself.
LEAN = ("-o", "Acquire::IndexTargets::deb::DEP-11::DefaultEnabled=false", "-o", "Acquire::Languages=none")
QUIET = {"DEBIAN_FRONTEND": "noninteractive"}
_apt = threading.RLock()
"""Two threads of the lab never run apt at once: the second would fail at dpkg's own lock."""


def installed(names: Sequence[str]) -> bool:
    """Tell whether dpkg has every package of the list configured."""
    return all(_version(name) for name in names)


def _version(name: str) -> str:
    try:
        state, _, version = run(["dpkg-query", "-W", "-f", "${db:Status-Status} ${Version}", name]).partition(" ")
    except LabError:
        return ""
    return version if state == "installed" else ""


def install(names: Sequence[str]) -> bool:
    """Install what is missing of Debian packages from the machine's own sources; tell whether anything was missing."""
    with _apt:
        if installed(names):
            return False
        update()
        run(["apt-get", "install", "-y", "--no-install-recommends", *names], log=f"apt-{names[0]}", env=QUIET)
        return True


@cache
def update() -> None:
    """Refresh the machine's package lists, once per run of the lab."""
    run(["apt-get", "update"], log="apt-update", env=QUIET)


def install_from(suites: Sequence[str], names: Sequence[str]) -> str:
    """Install exactly these packages from the first newer suite that can give them; return that suite.

    The machine's own configuration of apt is not touched: the newer source, its pin (everything else of that suite is
    refused) and its package lists live in the lab's home and are named on the command line.
    Raises LabError when no suite can give them.
    """
    tried = []
    for suite in suites:
        options = _beside(suite, names)
        command = ["apt-get", *options, "install", "-y", "--no-install-recommends", *names]
        with _apt:
            run(["apt-get", *options, "update"], log=f"apt-update-{suite}", env=QUIET)
            if succeeds([*command, "-s"]):
                run(command, log=f"apt-{suite}", env=QUIET)
                return suite
        tried.append(suite)
    raise LabError(f"no suite of {', '.join(tried)} has {', '.join(names)} for this machine")


def _beside(suite: str, names: Sequence[str]) -> tuple[str, ...]:
    """Write a private configuration of apt: the machine's sources, the same once more for `suite`, and the pins."""
    place = folder("apt", suite)
    for name in ("sources", "lists/partial"):
        shutil.rmtree(place / name, ignore_errors=True)
        (place / name).mkdir(parents=True)
    newer = newer_source(suite)
    (place / "sources" / f"lab-{suite}.{'sources' if 'URIs:' in newer else 'list'}").write_text(newer)
    for path in (SOURCES / "sources.list", *sorted((SOURCES / "sources.list.d").glob("*"))):
        if path.suffix in {".list", ".sources"} and path.is_file():
            shutil.copy(path, place / "sources" / path.name)
    pins = f"Package: *\nPin: release n={suite}\nPin-Priority: -1\n\n"
    pins += f"Package: {' '.join(names)}\nPin: release n={suite}\nPin-Priority: 990\n"
    (place / "preferences").write_text(pins)
    return (
        "-o", "Dir::Etc::SourceList=/dev/null", "-o", f"Dir::Etc::SourceParts={place / 'sources'}",
        "-o", f"Dir::Etc::Preferences={place / 'preferences'}", "-o", f"Dir::State::Lists={place / 'lists'}",
        "-o", "Dir::Cache::pkgcache=", "-o", "Dir::Cache::srcpkgcache=", *LEAN,
    )  # fmt: skip


def newer_source(suite: str) -> str:
    """Return an apt source for `suite` of Debian, derived from the source the machine already has for its own suite.

    Raises LabError when the machine has no Debian source.
    """
    own = re.search(r"^VERSION_CODENAME=\"?(\w+)", Path("/etc/os-release").read_text(), re.MULTILINE)
    codename = own.group(1) if own else "stable"
    for path in (*sorted((SOURCES / "sources.list.d").glob("*.sources")), SOURCES / "sources.list"):
        if not path.is_file():
            continue
        for stanza in re.split(r"\n\s*\n", path.read_text()):
            suites = re.search(rf"^Suites:.*\b{codename}(?![\w-])", stanza, re.MULTILINE)
            if suites:
                return re.sub(r"^Suites:.*$", f"Suites: {suite}", stanza, flags=re.MULTILINE) + "\n"
            for line in stanza.splitlines():
                if re.match(rf"deb\s.*\s{codename}\s", line):
                    return re.sub(rf"\s{codename}\s", f" {suite} ", line) + "\n"
    raise LabError("no apt source for Debian itself under /etc/apt; the lab derives its newer source from it")


def environment(name: str, requirements: Sequence[str]) -> Path:
    """Return a private Python environment that holds these requirements, made anew when they change."""
    place = folder("venv") / f"{name}-{recipe(list(requirements), sys.version)}"
    if not (place / "done").exists():
        shutil.rmtree(place, ignore_errors=True)
        run([sys.executable, "-m", "venv", place])
        run([place / "bin" / "python", "-m", "pip", "install", "--quiet", *requirements], log=f"pip-{name}")
        (place / "done").touch()
    return place


def go_install(package: str, version: str) -> Path:
    """Return the program that `go install PACKAGE@VERSION` makes, compiled once into the lab's home."""
    name = package.rsplit("/", 1)[-1]
    place = folder("go", f"{name}-{recipe(package, version)}")
    if not (place / name).exists():
        run(["nice", "go", "install", f"{package}@{version}"], log=f"go-{name}", env=go_environment(GOBIN=str(place)))
    return place / name


def go_environment(**more: str) -> dict[str, str]:
    """Return what go needs here besides the machine's own settings: no C compiler, no cross-compilation left set.

    Installs Go beside the machine's own packages where there is none, or one too old to fetch a newer toolchain.
    """
    own = shutil.which("go")
    path = os.environ.get("PATH", os.defpath)
    if not own or not _recent(own):
        program = Path(facts.text("go", "program"))
        if not program.exists():
            install_from(facts.texts("go", "suites"), facts.texts("go", "packages"))
        path = os.pathsep.join([str(program.parent), path])
    settings = {k: v for k, v in os.environ.items() if k == "GOPROXY"}
    return {"CGO_ENABLED": "0", "GOWORK": "off", "GOTOOLCHAIN": "auto", "PATH": path, **settings, **more}


def _recent(program: str) -> bool:
    version = re.search(r"go1\.(\d+)", run([program, "version"]))
    return version is not None and int(version[1]) >= facts.number("go", "minimum")
