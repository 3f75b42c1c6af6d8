"""A rosdep key whose packages this Ubuntu's apt does not have stops nothing: it is told and left out."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from roslab.render import image_scripts

SCRIPT = Path(image_scripts.__path__[0]) / "install-rosdep-keys.sh"
ROSDEP = """\
echo "$*" >>"${HERE}/calls"
case "$1" in
  install) for key in ${FAILING}; do
    if [[ " $* " == *" --skip-keys "*"${key}"* ]]; then continue; fi
    if [[ "$*" == *--simulate* ]]; then echo "  apt-get install -y ${key}"; else exit 1; fi
  done ;;
  keys) printf 'roscpp\\nlibgazebo7-dev\\nvirtual\\nnumpy\\n' ;;
  resolve) for key in "${@:2}"; do
    rule=apt && [ "${key}" != numpy ] || rule=pip
    printf '#ROSDEP[%s]\\n#%s\\n%s\\n' "${key}" "${rule}" "${key}"
  done ;;
esac
"""


def ran(folder: Path, failing: str, *options: str) -> tuple[int, str, str]:
    """Run the script where only the keys of ``failing`` stop rosdep; return its code, words and what was left out."""
    stand_ins = {
        "rosdep": ROSDEP,
        "apt-cache": '[ "$2" = roscpp ]',
        "apt-get": '[ "$1" != install ] || [ "$3" = virtual ]',
        "rm": "exit 0",
        "find": "exit 0",
    }
    (folder / "bin").mkdir()
    for name, body in stand_ins.items():
        (folder / "bin" / name).write_text(f"#!/bin/bash\n{body}\n")
        (folder / "bin" / name).chmod(0o755)
    script = SCRIPT.read_text().replace("/usr/local/share/roslab", str(folder)).replace("/etc/", f"{folder}/etc/")
    script = script.replace("/tmp/apt-update", f"{folder}/lists").replace("/tmp/rosdep-install", f"{folder}/said")
    (folder / "etc/apt/apt.conf.d").mkdir(parents=True)
    path = {"PATH": f"{folder / 'bin'}:{os.environ['PATH']}", "ROS_DISTRO": "kinetic"}
    env = {**path, "HERE": str(folder), "FAILING": failing}
    words = ["bash", "-c", script, "x", *options, str(folder)]
    done = subprocess.run(words, env=env, capture_output=True, text=True, check=False)
    left = folder / "left-out.txt"
    return done.returncode, done.stdout, left.read_text() if left.exists() else ""


@pytest.mark.parametrize(
    ("failing", "options", "code", "left"),
    [
        ("", (), 0, ""),
        ("libgazebo7-dev", (), 0, "rosdep libgazebo7-dev\n"),
        ("libgazebo7-dev", ("--skip", "virtual more"), 0, "rosdep libgazebo7-dev\n"),
        ("libgazebo7-dev roscpp", (), 1, "rosdep libgazebo7-dev\n"),
        ("roscpp", ("--skip", "libgazebo7-dev"), 1, ""),
    ],
)
def test_only_what_apt_does_not_have_is_left_out(
    tmp_path: Path, failing: str, options: tuple[str, ...], code: int, left: str
) -> None:
    done, said, written = ran(tmp_path, failing, *options)
    assert (done, written) == (code, left)
    assert ("roslab: left out: rosdep libgazebo7-dev" in said) == bool(left)
