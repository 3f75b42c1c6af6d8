"""Emulation of arm64, so that its containers run on an amd64 machine."""

from __future__ import annotations

import platform
import subprocess
from pathlib import Path

from . import facts, packages
from .command import LabError, run
from .home import folder

PLACE = Path("/proc/sys/fs/binfmt_misc")


def works() -> bool:
    """Tell whether arm64 programs run here, natively or because an emulator is registered with flag F."""
    if platform.machine() in {"aarch64", "arm64"}:
        return True
    entry = PLACE / facts.text("emulation", "entry")
    return entry.exists() and "enabled" in entry.read_text() and "F" in _flags(entry.read_text())


def up() -> str:
    """Make sure that arm64 programs run, in containers too."""
    if works():
        return "was there"
    packages.install(facts.texts("emulation", "packages"))
    if not (PLACE / "register").exists():
        run(["mount", "-t", "binfmt_misc", "none", PLACE])
        (folder("run") / "binfmt-mounted").touch()
    if not works():
        entry = PLACE / facts.text("emulation", "entry")
        if entry.exists():
            entry.write_text("-1")
        (PLACE / "register").write_text(_registration())
        (folder("run") / "binfmt-registered").touch()
    if not works():
        raise LabError("the kernel took the emulator of arm64 but does not list it")
    return "registered"


def down() -> bool:
    """Take back what `up` registered and mounted; tell whether there was anything."""
    registered, mounted = folder("run") / "binfmt-registered", folder("run") / "binfmt-mounted"
    was = registered.exists() or mounted.exists()
    if registered.exists():
        entry = PLACE / facts.text("emulation", "entry")
        if entry.exists():
            entry.write_text("-1")
        registered.unlink()
    if mounted.exists():
        subprocess.run(["umount", PLACE], check=False)
        mounted.unlink()
    return was


def _registration() -> str:
    """Return the package's own line, with flag F: the kernel opens the emulator now, so containers need none."""
    line = Path(facts.text("emulation", "definition")).read_text().strip().splitlines()[-1]
    head, _, flags = line.rpartition(":")
    return f"{head}:{flags if 'F' in flags else flags + 'F'}"


def _flags(entry: str) -> str:
    return next((line.partition(":")[2] for line in entry.splitlines() if line.startswith("flags")), "")
