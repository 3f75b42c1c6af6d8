"""A runner with a small disk: an engine and a BuildKit whose stores share one file system of a given size."""

from __future__ import annotations

import dataclasses
import json
import os
import secrets
import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

from . import buildkit, engine, facts
from .command import LabError, run
from .laboratory import Laboratory


@contextmanager
def small_disk(lab: Laboratory, megabytes: int) -> Iterator[Laboratory]:
    """Yield the lab with an engine and a BuildKit of their own on a new file system, which is gone afterwards.

    Needs root, a loop device and an engine that the machine can start; raises LabError where one is missing.
    """
    place = Path(tempfile.mkdtemp(prefix="lab-"))  # a short name: a socket's path may have 104 characters
    image, disk = place / "disk.img", place / "disk"
    disk.mkdir()
    run(["truncate", f"--size={megabytes}M", image])
    run(["mkfs.ext4", "-q", "-m", "0", "-O", "^has_journal", image])
    run(["mount", "-o", "loop", image, disk])
    try:
        with ExitStack() as stack:
            address = stack.enter_context(buildkit.fresh(disk / "buildkit", on_disk=True))
            host = stack.enter_context(_engine(disk / "engine", place / "run"))
            yield dataclasses.replace(lab, docker_host=host, buildkit=address)
    finally:
        engine.unmount_below(disk)
        shutil.rmtree(place, ignore_errors=True)


@contextmanager
def _engine(store: Path, place: Path) -> Iterator[str]:
    """Run one more engine on a bridge of its own, and yield its address.

    Without a bridge it would take the other engine's away: ``bridge: none`` removes docker0. Its name and its addresses
    are nobody else's: another run may be at work, or one that was killed may have left its own.
    """
    place.mkdir()
    bridge = f"lab-{secrets.token_hex(4)}"  # at most 15 characters
    run(["ip", "link", "add", "name", bridge, "type", "bridge"])
    run(["ip", "address", "add", f"172.31.{secrets.randbelow(256)}.1/24", "dev", bridge])
    run(["ip", "link", "set", bridge, "up"])
    host = f"unix://{place}/docker.sock"
    settings = {
        "data-root": str(store),
        "exec-root": str(place / "exec"),
        "pidfile": str(place / "pid"),
        "hosts": [host],
        "features": {"containerd-snapshotter": True},
        "registry-mirrors": [f"http://127.0.0.1:{facts.number('registry', 'mirror_port')}"],
        "bridge": bridge,
        "iptables": False,
        "ip6tables": False,
    }
    (place / "daemon.json").write_text(json.dumps(settings))
    daemon = shutil.which("dockerd", path=os.environ.get("PATH", "") + ":/usr/sbin:/usr/local/sbin")
    if not daemon:
        raise LabError("dockerd is not on PATH: a second engine cannot be started")
    with (place / "log").open("w") as log:
        process = subprocess.Popen(
            [daemon, "--config-file", str(place / "daemon.json")], stdin=subprocess.DEVNULL, stdout=log, stderr=log
        )
    try:
        deadline = time.monotonic() + 60
        while not engine.works(host):
            if process.poll() is not None or time.monotonic() > deadline:
                raise LabError(f"a second engine does not answer; its log: {(place / 'log').read_text()}")
            time.sleep(0.2)
        yield host
    finally:
        process.terminate()
        process.wait(60)
        engine.unmount_below(place)
        subprocess.run(["ip", "link", "delete", bridge], check=False, capture_output=True)
