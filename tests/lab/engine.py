"""The Docker engine: one that is there already, else one of the lab's own on a socket in the lab's home."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
from pathlib import Path

from . import facts, packages, processes
from .command import LabError, run, succeeds
from .home import folder, home

NAME = "engine"
LIMITS = ("defaultReservedSpace", "defaultMaxUsedSpace", "defaultMinFreeSpace")


def own_host() -> str:
    """Return the address of the lab's own engine, running or not."""
    return f"unix://{home() / 'run' / 'docker.sock'}"


def host() -> str | None:
    """Return the address of a working engine, preferring the lab's own; None when there is none."""
    candidates = (own_host(), os.environ.get("DOCKER_HOST", ""), "unix:///var/run/docker.sock")
    return next((address for address in candidates if address and works(address)), None)


def works(address: str) -> bool:
    """Tell whether an engine that is new enough, with buildx, answers at this address."""
    if address.startswith("unix://") and not Path(address.removeprefix("unix://")).is_socket():
        return False  # a socket that is not there need not be asked, which takes the client a while
    env = {"DOCKER_HOST": address}
    try:
        version = run(["docker", "info", "--format", "{{.ServerVersion}}"], env=env, timeout=60)
    except LabError:
        return False
    major = re.match(r"(\d+)\.", version.strip())
    if major is None or int(major[1]) < facts.number("engine", "minimum"):
        return False
    return succeeds(["docker", "buildx", "version"], env=env)


def up() -> str:
    """Make sure that an engine works, and say in a few words which and whose."""
    address = host()
    if address:
        whose = "the lab's own" if address == own_host() else "found"
        return f"was there, {whose}: {address}"
    suite = ""
    if not packages.installed(facts.texts("engine", "own_packages")):
        packages.install(facts.texts("engine", "own_packages"))
    newer = facts.texts("engine", "newer_packages")
    if not packages.installed(newer) or not succeeds(["docker", "buildx", "version"]):
        suite = packages.install_from(facts.texts("engine", "suites"), newer)
    _sweep()
    _control_groups()
    start()
    return f"started{', packages of ' + suite if suite else ''}: {own_host()}"


def start() -> None:
    """Start the lab's own engine and wait until it answers."""
    mirror = f"http://127.0.0.1:{facts.number('registry', 'mirror_port')}"
    settings = {
        "data-root": str(folder("engine")),
        "exec-root": str(folder("run", "engine")),
        "pidfile": str(home() / "run" / "engine.pid"),
        "hosts": [own_host()],
        # The containerd image store lets the plain `docker` driver build and hold several platforms.
        "features": {"containerd-snapshotter": True},
        # Names that are not tagged in the engine are looked for among the lab's stand-ins, for every platform.
        "registry-mirrors": [mirror],
        # Packets larger than the way out allows would get lost in the bridge's address translation.
        "mtu": outward_mtu(),
        # Left to itself its builder keeps layers until the disk is full, and the next build fails.
        "builder": {"gc": {"enabled": True, **{key: facts.text("engine", key) for key in LIMITS}}},
    }
    configuration = folder("run") / "engine-daemon.json"
    configuration.write_text(json.dumps(settings, indent=2))
    daemon = shutil.which("dockerd", path=os.environ.get("PATH", "") + ":/usr/sbin:/usr/local/sbin")
    if not daemon:
        raise LabError("dockerd is not on PATH, though its package is installed")
    _read_database()
    processes.start(NAME, [daemon, "--config-file", configuration], ready=lambda: works(own_host()), seconds=60)


def _read_database() -> None:
    """Read the database of the engine's containerd once, from end to end, so that it lies in memory.

    After many builds it has some hundred MB. containerd reads it page by page, in no order, to open it, and dockerd
    waits for that 15 s (``startupTimeout`` in moby's ``libcontainerd/supervisor``), which is too short on a slow disk.
    """
    for database in folder("engine", "containerd").glob("daemon/io.containerd.metadata.*/meta.db"):
        with database.open("rb") as stream:
            while stream.read(1 << 20):
                pass


def make_room() -> str:
    """Empty the lab's own builder where the disk is nearly full, and say how much is free, in a few words."""
    wanted = facts.number("engine", "room_gb")
    freed = ""
    if _free_gb() < wanted and works(own_host()):
        env = {"DOCKER_HOST": own_host()}
        run(["docker", "image", "prune", "--force"], env=env)
        run(["docker", "builder", "prune", "--force"], env=env, timeout=600)
        freed = "after the builder's store was emptied, "
    free = _free_gb()
    short = (
        "" if free >= wanted else f"; all tests want {wanted} GB, without them some fail with 'no space left on device'"
    )
    return f"{freed}{free:.0f} GB free in {home()}{short}"


def _free_gb() -> float:
    return shutil.disk_usage(home()).free / 1e9


def down() -> bool:
    """End the lab's own engine and what it would leave behind; an engine that was found is left alone."""
    was = processes.stop(NAME)
    _sweep()
    if was:
        _unplug()
    return was


def outward_mtu() -> int:
    """Return the packet size of the interface that has the default route, 1500 when that cannot be told."""
    for line in Path("/proc/net/route").read_text().splitlines()[1:]:
        interface, destination = line.split()[:2]
        if destination == "00000000":
            return int((Path("/sys/class/net") / interface / "mtu").read_text())
    return 1500


def _control_groups() -> None:
    """Mount control groups where nothing else has; runc cannot start a container without."""
    place = Path("/sys/fs/cgroup")
    if not any(place.iterdir()):
        run(["mount", "-t", "cgroup2", "none", place])
        (folder("run") / "control-groups-mounted").touch()


def _sweep() -> None:
    """Remove what an engine that died left under the lab's home: its socket, its pid file, its mounts."""
    if processes.running(NAME) is None:
        processes.end_orphans(home() / "run" / "engine")
        for name in ("docker.sock", "engine.pid"):
            (home() / "run" / name).unlink(missing_ok=True)
        unmount_below(home() / "engine")
        unmount_below(home() / "run")
        marker = home() / "run" / "control-groups-mounted"
        if marker.exists():
            subprocess.run(["umount", "/sys/fs/cgroup"], check=False)
            marker.unlink()


def unmount_below(place: Path) -> None:
    """Unmount a folder and everything below it, the innermost first."""
    points = [line.split()[4].replace("\\040", " ") for line in Path("/proc/self/mountinfo").read_text().splitlines()]
    for point in sorted((p for p in points if p == str(place) or p.startswith(f"{place}/")), key=len, reverse=True):
        subprocess.run(["umount", "-l", point], check=False)


def _unplug() -> None:
    """Remove the bridge and the packet filter chains of the lab's own engine, which it leaves when it ends."""
    subprocess.run(["ip", "link", "delete", "docker0"], check=False, capture_output=True)
    for command in ("iptables", "ip6tables"):
        for table in ("nat", "filter", "raw"):
            _drop_rules(command, table)


def _drop_rules(command: str, table: str) -> None:
    """Drop every rule and chain of one packet filter table that names Docker's chains or its bridge."""
    saved = subprocess.run(
        [command, "-t", table, "-S"], capture_output=True, text=True, check=False
    ).stdout.splitlines()
    ours = [line.split() for line in saved if re.search(r"DOCKER|docker0", line)]
    for words in ours:
        if words[0] == "-A":
            subprocess.run([command, "-t", table, "-D", *words[1:]], check=False, capture_output=True)
    for words in ours:
        if words[0] == "-N":
            subprocess.run([command, "-t", table, "-F", words[1]], check=False, capture_output=True)
            subprocess.run([command, "-t", table, "-X", words[1]], check=False, capture_output=True)
