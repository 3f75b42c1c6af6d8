"""The script that installs packages of the repository, and what it leaves in the image where one fails."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from roslab.render import image_scripts

SCRIPT = Path(image_scripts.__path__[0]) / "install-own-packages.sh"
APT = """\
file="${!#}"
case "$*" in
  *--simulate*) [[ -e ${file} || ${file} != /* ]] && [[ ${file} != *_arm64.deb ]] ;;
  *install*) echo libfoo >>installed; [[ ${file} != *broken* ]] ;;
esac
"""
CURL = """\
[[ ${!#} != *gone* ]] || exit 22
while [ "$1" != --output ]; do shift; done
echo >"$2"
"""
DPKG = """\
if [ "$1" = --status ]; then grep -qx "$2" installed && echo "Status: install ok installed"; exit; fi
echo "$*" >>calls
sed -i "/^${!#}$/d" installed
"""


def installed(folder: Path, before: str, *files: str) -> tuple[str, list[str], str]:
    """Return what is installed then, what was removed, and the list of what was left out."""
    text = SCRIPT.read_text(encoding="utf-8").replace("/usr/local/share/roslab", ".").replace("/var/", "./var/")
    (folder / "var/log/apt").mkdir(parents=True)
    (folder / "installed").write_text(before)
    (folder / "calls").touch()
    (folder / "left-out.txt").touch()
    (folder / "bin").mkdir()
    for name, lines in (("apt-get", APT), ("dpkg", DPKG), ("dpkg-deb", "echo libfoo\n"), ("curl", CURL)):
        (folder / "bin" / name).write_text(f"#!/bin/bash\n{lines}")
        (folder / "bin" / name).chmod(0o755)
    path = f"{folder / 'bin'}:{os.environ['PATH']}"
    argv = ["bash", "-c", text, "install-own-packages", *files]
    subprocess.run(argv, cwd=folder, env={"PATH": path}, capture_output=True, check=True)
    there = sorted({*(folder / "installed").read_text().split()})
    return " ".join(there), (folder / "calls").read_text().splitlines(), (folder / "left-out.txt").read_text()


@pytest.mark.parametrize(
    ("before", "files", "there"),
    [
        ("", ["libfoo_1_amd64.deb", "libfoo_1_arm64.deb"], "libfoo"),
        ("libfoo\n", ["libfoo_1_arm64.deb"], "libfoo"),
        ("libfoo\n", ["libfoo_broken_amd64.deb"], "libfoo"),
        ("", ["libfoo_1_arm64.deb"], ""),
    ],
)
def test_what_was_there_before_stays(tmp_path: Path, before: str, files: list[str], there: str) -> None:
    assert installed(tmp_path, before, *files) == (there, [], f"apt {files[-1]}\n")


@pytest.mark.parametrize(
    ("url", "there", "left"),
    [
        ("https://x.example/libfoo_1_amd64.deb", "libfoo", ""),
        ("https://x.example/libfoo_1_arm64.deb", "", "apt libfoo_1_arm64.deb\n"),
        ("https://gone.example/libfoo_1_amd64.deb", "", "apt libfoo_1_amd64.deb\n"),
    ],
)
def test_what_has_an_address_is_fetched_first(tmp_path: Path, url: str, there: str, left: str) -> None:
    assert installed(tmp_path, "", url) == (there, [], left)


def test_what_fails_half_way_is_removed(tmp_path: Path) -> None:
    file = "libfoo_broken_amd64.deb"
    assert installed(tmp_path, "", file) == ("", ["--purge --force-all libfoo"], f"apt {file}\n")
