"""A buildkitd of the lab's own: the engine's builder cannot push by digest, this one can."""

from __future__ import annotations

import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from . import engine, facts, packages, processes, registry
from .command import LabError, run, succeeds
from .home import folder, home, memory, recipe

NAME = "buildkitd"

# The command cannot be had by `go install`: its module has replace directives. A module that imports it can build it.
IMPORTER = """//go:build tools

package tools

import _ "{package}"
"""


def address() -> str:
    """Return the address of the lab's buildkitd, running or not."""
    return f"unix://{home() / 'run' / 'buildkitd.sock'}"


def program() -> Path:
    """Return the compiled program, compiled once for the version of facts.toml."""
    module, package, version = (facts.text("buildkit", key) for key in ("module", "package", "version"))
    # Clients ask its version for what it can do; a build outside its own repository has to be told
    named = f"-X {module}/version.Version={version}"
    place = folder("go", f"buildkitd-{recipe(module, package, version, IMPORTER, named)}")
    if not (place / NAME).exists():
        (place / "go.mod").write_text("module lab.example.org/buildkitd\n")
        (place / "tools.go").write_text(IMPORTER.format(package=package))
        environment = packages.go_environment()
        run(["go", "get", f"{package}@{version}"], log="go-get-buildkitd", cwd=place, env=environment)
        command = ["nice", "go", "build", "-trimpath", "-ldflags", named, "-o", f"{NAME}.part", package]
        run(command, log="go-buildkitd", cwd=place, env=environment)
        (place / f"{NAME}.part").rename(place / NAME)
    return place / NAME


def up() -> str:
    """Make sure that buildkitd answers."""
    if processes.running(NAME) and answers():
        return f"was there: {address()}"
    daemon = program()
    Path(address().removeprefix("unix://")).unlink(missing_ok=True)
    engine.unmount_below(home() / "buildkit")
    known = home() / "buildkit" / "knows-the-bases"
    if not known.exists():
        forget()  # of a layer it notes some 200 repositories and no more: the one of `mounts` must be among them
    processes.start(NAME, [daemon, "--config", _configuration()], ready=answers)
    known.touch()
    return f"started: {address()}"


def down() -> bool:
    """End the lab's buildkitd and what it would leave mounted."""
    was = processes.stop(NAME)
    engine.unmount_below(home() / "buildkit")
    return was


def forget() -> None:
    """Throw its store away; only while it does not run."""
    shutil.rmtree(home() / "buildkit", ignore_errors=True)


@contextmanager
def fresh(place: Path, *, on_disk: bool = False) -> Iterator[str]:
    """Run one more buildkitd whose store is empty, as a runner of GitHub's has it; yield its address.

    The store lies in memory where that has room: a disk may take longer to remove it than a build takes. Else, or
    ``on_disk``, it lies in ``place``. Raises LabError when the daemon does not answer within half a minute.
    """
    socket = place / "buildkitd.sock"
    place.mkdir(parents=True)
    store = Path(tempfile.mkdtemp(prefix="repro-lab-", dir=(None if on_disk else memory()) or place))
    configuration = _configuration(root=store, socket=socket, path=place / "buildkitd.toml")
    command = [str(program()), "--config", str(configuration)]
    with (place / "buildkitd.log").open("w") as log:
        daemon = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=log, stderr=log, cwd="/")
    try:
        deadline = time.monotonic() + 30
        while not answers(f"unix://{socket}"):
            if daemon.poll() is not None or time.monotonic() > deadline:
                raise LabError(f"a fresh buildkitd does not answer; its log: {(place / 'buildkitd.log').read_text()}")
            time.sleep(0.1)
        yield f"unix://{socket}"
    finally:
        daemon.terminate()
        daemon.wait(30)
        engine.unmount_below(store)
        shutil.rmtree(store, ignore_errors=True)


def answers(where: str = "") -> bool:
    """Tell whether something listens on its socket; buildx's own client says whether it is sound when it is used."""
    return succeeds(["python3", "-c", _KNOCK, (where or address()).removeprefix("unix://")], timeout=5)


_KNOCK = "import socket, sys; socket.socket(socket.AF_UNIX).connect(sys.argv[1])"


def _configuration(*, root: Path | None = None, socket: Path | None = None, path: Path | None = None) -> Path:
    """Write the configuration of the lab's own buildkitd, or of one with another store, socket and file."""
    local = [registry.address(registry.PROTECTED), registry.address(registry.MIRROR)]
    lines = [
        f'root = "{root or folder("buildkit")}"',
        "[grpc]",
        f'  address = ["{f"unix://{socket}" if socket else address()}"]',
        "[worker.oci]",
        "  enabled = true",
        # Left to itself it keeps less where a fifth of the disk is not free: a second run finds little of the first
        *(f'  {key} = "{facts.text("buildkit", key)}"' for key in ("reservedSpace", "maxUsedSpace", "minFreeSpace")),
        # Builds use the machine's own network: it knows the way to the package registries.
        '  networkMode = "host"',
        '  platforms = ["linux/amd64", "linux/arm64"]',
        "[worker.containerd]",
        "  enabled = false",
        '[registry."docker.io"]',
        f'  mirrors = ["{registry.address(registry.MIRROR)}"]',
    ]
    for place in local:
        lines += [f'[registry."{place}"]', "  http = true", "  insecure = true"]
    path = path or folder("run") / "buildkitd.toml"
    path.write_text("\n".join(lines) + "\n")
    return path
