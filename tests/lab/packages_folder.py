"""Packages of a distribution that somebody built for Debian 12: a folder of .deb files that becomes an apt source.

The lab builds none of them. Debian packages no rclcpp, so without such a folder its stand-ins for ROS 2 have only
ament, the message generators and colcon.
"""

from __future__ import annotations

import hashlib
import os
import shutil
from functools import cache
from pathlib import Path

from .command import LabError, run
from .home import folder

VARIABLE = "REPRO_LAB_ROS2"
INDEX = "Packages"


def place(distro: str) -> Path | None:
    """Return the apt source of this distribution's packages in the lab's home; ``None`` where nobody gave any.

    $REPRO_LAB_ROS2 names the folder they are taken from; what was taken once stays for later calls without it.
    Raises LabError when that folder has no `ros-DISTRO-ros-base`, which the stand-in installs.
    """
    given = os.environ.get(VARIABLE)
    if given:
        _take(Path(given), distro)
    kept = folder("ros2") / distro
    return kept if (kept / INDEX).exists() else None


def _take(source: Path, distro: str) -> None:
    """Copy the packages of one distribution into the home with an index, if they are others than those there."""
    files = sorted(source.glob(f"ros-{distro}-*.deb"))
    stanzas = [_stanza(file, file.stat().st_mtime_ns) for file in files]
    if not any(text.startswith(f"Package: ros-{distro}-ros-base\n") for text in stanzas):
        raise LabError(
            f"{VARIABLE}={source} has no package ros-{distro}-ros-base: it has to be a folder of .deb files for "
            f"Debian 12 that are named ros-{distro}-*.deb, that one among them"
        )
    index = "\n".join(stanzas)
    kept = folder("ros2") / distro
    if (kept / INDEX).exists() and (kept / INDEX).read_text() == index:
        return
    unfinished = folder("ros2") / f"{distro}.part"
    shutil.rmtree(unfinished, ignore_errors=True)
    unfinished.mkdir()
    for file in files:
        shutil.copy(file, unfinished)
    (unfinished / INDEX).write_text(index)
    shutil.rmtree(kept, ignore_errors=True)
    unfinished.rename(kept)


@cache
def _stanza(file: Path, changed: int) -> str:
    """Return one entry of an index of packages, made once for each state of a file, which `changed` tells.

    https://wiki.debian.org/DebianRepository/Format
    """
    del changed
    control, content = run(["dpkg-deb", "--field", file]), file.read_bytes()
    digest = hashlib.sha256(content).hexdigest()
    return f"{control.rstrip()}\nFilename: ./{file.name}\nSize: {len(content)}\nSHA256: {digest}\n"
