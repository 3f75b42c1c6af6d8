"""A virtual X server for the proof of a program with windows, which ends with the proof.

Why it works this way:

- The server is Xvfb on the machine that runs the proof, not in the image: the image stays as its author wants it, and
  every base works the same way, even an emulated one, since only bytes pass through the socket. GitHub's Ubuntu runners
  have Xvfb. Where there is none, the proof runs without a screen and says what to install.
- The container gets the server's socket and a key to it, both to be read only, and two variables. It gets no device, no
  network and no memory of the host: MIT-SHM is off in the server, so that every toolkit draws through the socket.
- The socket's folder is a small file system of the container's own, open to all as X wants it: a test that starts
  another X server inside finds the folder as on any machine.
- The key is a fresh cookie in a folder that no other user of the machine can enter. It names no host, since a
  container's name is not the machine's. The server listens on that one socket: neither on the network nor on a name
  that other containers could reach.
- The user's own screen is never used: DISPLAY is not read. The number is one at which nothing answers, taken by X's own
  lock file: a server that is left to pick one (``-displayfd``) takes no lock, and takes the socket of another away.
- The kernel ends the server when this program is killed, ``finally`` ends it otherwise; either way it removes its
  socket.
"""

from __future__ import annotations

import secrets
import shutil
import socket
import struct
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from roslab.engine.docker import last_line, output
from roslab.errors import BuildError, Problem
from roslab.values.dataclass import dataclass

SIZE = "1920x1080x24"
START_SECONDS = 30.0
"""Seconds that the server may take to start; on an idle machine it takes less than one."""
NUMBERS = range(99, 600)
"""Display numbers to use; people's screens and those forwarded by ssh have lower ones."""
SOCKETS = Path("/tmp/.X11-unix")  # noqa: S108 - where X keeps its sockets
KEY = "/run/roslab/Xauthority"
"""Path of the key in a container, the same as in docker_run.sh."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Display:
    """A running X server."""

    number: int
    key: Path
    """File with the cookie, in the format of XAUTHORITY."""

    @property
    def name(self) -> str:
        """Value of DISPLAY."""
        return f":{self.number}"

    def options(self) -> tuple[str, ...]:
        """Return the options of ``docker run`` that give a container this display, and nothing else of the machine."""
        path = SOCKETS / f"X{self.number}"
        words = ["--mount", f"type=tmpfs,destination={SOCKETS},tmpfs-mode=1777"]
        for source, target in ((path, path), (self.key, KEY)):
            words += ["--mount", f"type=bind,source={source},destination={target},readonly"]
        for setting in (f"DISPLAY={self.name}", f"XAUTHORITY={KEY}", "LIBGL_ALWAYS_SOFTWARE=1"):
            words += ["--env", setting]
        return tuple(words)


@contextmanager
def virtual_display(folder: Path) -> Iterator[Display]:
    """Run an X server as long as the context lasts; ``folder`` is a private one for its key and its log.

    Raises ``BuildError``, with what to install where that helps, when there can be none here.
    """
    if not shutil.which("Xvfb"):
        raise BuildError(Problem(message="Xvfb is not installed", hint="on Debian and Ubuntu: apt install xvfb"))
    _require_engine_here()
    key = folder / "Xauthority"
    key.write_bytes(_entry(secrets.token_bytes(16)))
    key.chmod(0o644)  # the image's user reads it; on this machine the folder keeps others away
    server, number = _start(key, folder / "xvfb.log")
    try:
        yield Display(number=number, key=key)
    finally:
        _end(server)


def _start(key: Path, log: Path) -> tuple[subprocess.Popen[bytes], int]:
    """Start a server at the first free number; if another process takes it first, go on with the next.

    Raises ``BuildError`` with the server's own words where it does not start.
    """
    for number in NUMBERS:
        if _answers(number):
            continue
        with log.open("wb") as said:
            server = subprocess.Popen(
                _command(key, number),
                stdin=subprocess.DEVNULL,
                stdout=said,
                stderr=said,
                start_new_session=True,  # Ctrl-C ends the proof first, and the proof its server
            )
        try:
            ready = _ready(server, number)
        except BaseException:
            _end(server)
            raise
        if ready:
            return server, number
        _end(server)
        text = log.read_text(encoding="utf-8", errors="replace")
        if "already active" not in text:
            raise BuildError(Problem(message=f"Xvfb does not start: {last_line(text)}"))
    raise BuildError(Problem(message=f"Xvfb does not start: displays {NUMBERS[0]} to {NUMBERS[-1]} are all in use"))


def _ready(server: subprocess.Popen[bytes], number: int) -> bool:
    """Wait until the server has the lock of a number and its socket answers; tell whether that happened in time."""
    lock = SOCKETS.with_name(f".X{number}-lock")
    deadline = time.monotonic() + START_SECONDS
    while server.poll() is None and time.monotonic() < deadline:
        with suppress(OSError):
            if lock.read_text(encoding="ascii", errors="replace").strip() == str(server.pid) and _answers(number):
                return True
        time.sleep(0.02)
    return False


def _answers(number: int) -> bool:
    """Tell whether any server answers at a display's socket; a killed one may have left the file."""
    with socket.socket(socket.AF_UNIX) as asked:
        try:
            asked.connect(str(SOCKETS / f"X{number}"))
        except (FileNotFoundError, ConnectionRefusedError):
            return False
        except OSError:  # it exists, but may not be used
            return True
    return True


def _command(key: Path, number: int) -> list[str]:
    """Return the server's command: https://www.x.org/releases/current/doc/man/man1/Xvfb.1.xhtml and Xserver.1."""
    # setpriv is part of util-linux, which every distribution with apt has: it makes the kernel end an orphan
    guard = ["setpriv", "--pdeathsig", "TERM"] if shutil.which("setpriv") else []
    # Without -noreset the server forgets everything when its last client leaves, which may be our camera
    listening = ["-nolisten", "tcp", "-nolisten", "local", "-noreset", "-extension", "MIT-SHM"]
    return [*guard, "Xvfb", f":{number}", "-auth", str(key), "-screen", "0", SIZE, *listening]


def _require_engine_here() -> None:
    """Raise ``BuildError`` where containers run on another machine: no socket of this one can be put into them."""
    host = output(["docker", "context", "inspect", "--format", "{{.Endpoints.docker.Host}}"]).stdout.strip()
    if not host.startswith("unix://"):
        raise BuildError(Problem(message=f"the Docker engine at {host or 'an unknown address'} is on another machine"))
    # Its engine is in a virtual machine, behind a socket of this one: https://docs.docker.com/desktop/setup/install/linux/
    if output(["docker", "info", "--format", "{{.OperatingSystem}}"]).stdout.startswith("Docker Desktop"):
        raise BuildError(Problem(message="Docker Desktop's engine is in a virtual machine"))


def _entry(cookie: bytes) -> bytes:
    """Return the one entry of a key file, for any host (family 65535) and any number: Xsecurity(7), AuRead.c."""
    fields = (b"", b"", b"MIT-MAGIC-COOKIE-1", cookie)
    return struct.pack(">H", 0xFFFF) + b"".join(struct.pack(">H", len(field)) + field for field in fields)


def _end(server: subprocess.Popen[bytes]) -> None:
    server.terminate()
    try:
        server.wait(10)
    except subprocess.TimeoutExpired:
        server.kill()
        server.wait()
