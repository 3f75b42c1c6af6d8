"""What rosdep would install by apt is installed by one call of apt, and the rest by rosdep."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

import pytest

from roslab.render import image_scripts

SCRIPT = Path(image_scripts.__path__[0]) / "install-rosdep-keys.sh"
PAIR = "#[apt] Installation commands:\n  apt-get install -y libfoo-dev\n  apt-get install -y python3-foo"
PIP = "#[pip] Installation commands:\n  pip3 install -U foo"
CHOICE = "#[apt] Installation commands:\n  'apt-get install -y foo' (alternative 1/2)"
SUDO = "#[apt] Installation commands:\n  sudo -H apt-get install -y foo"
SIMULATED = "rosdep install --simulate --default-yes"
ROSDEP = "rosdep install --default-yes"
APT = "apt-get install -y libfoo-dev python3-foo"


def ran(folder: Path, commands: str, *, apt: int = 0, rosdep: int = 0) -> tuple[int, list[str]]:
    """Run the function where rosdep would run these commands; return its code and what was called."""
    found = re.search(r"^install_together\(\) \{\n.*?^\}\n", SCRIPT.read_text(), re.MULTILINE | re.DOTALL)
    assert found
    simulated = f'if [[ "$*" = *--simulate* ]]; then echo "{commands}"; fi; exit {rosdep}'
    for name, body in {"rosdep": simulated, "apt-get": f"exit {apt}"}.items():
        (folder / name).write_text(f'#!/bin/bash\necho "{name} $*" >>{folder}/calls\n{body}\n')
        (folder / name).chmod(0o755)
    said = f'install_keys() {{ rosdep install "$@"; }}\n{found[0]}if install_together; then exit 0; fi\nexit 3'
    env = {"PATH": f"{folder}:{os.environ['PATH']}"}
    done = subprocess.run(
        ["bash", "-euo", "pipefail", "-c", said], env=env, capture_output=True, text=True, check=False
    )
    return done.returncode, (folder / "calls").read_text().splitlines()


@pytest.mark.parametrize(
    ("commands", "calls"),
    [
        ("", [SIMULATED]),
        (PAIR, [SIMULATED, APT]),
        (f"{PAIR}\n{PIP}", [SIMULATED, APT, ROSDEP]),
        (f"{PAIR}\n{CHOICE}", [SIMULATED, APT, ROSDEP]),
        (PIP, [SIMULATED, ROSDEP]),
        (SUDO, [SIMULATED, ROSDEP]),
    ],
)
def test_apt_is_called_once_and_rosdep_for_the_rest(tmp_path: Path, commands: str, calls: list[str]) -> None:
    assert ran(tmp_path, commands) == (0, calls)


def test_where_apt_does_not_take_them_together_rosdep_installs_each(tmp_path: Path) -> None:
    assert ran(tmp_path, PAIR, apt=100) == (0, [SIMULATED, APT, ROSDEP])


def test_rosdep_says_itself_what_it_cannot_install(tmp_path: Path) -> None:
    assert ran(tmp_path, PAIR, rosdep=1) == (3, [SIMULATED, ROSDEP])
