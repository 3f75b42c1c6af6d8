"""What a package from git needs and only its own list names is installed, too; the script runs against stand-ins."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from roslab.render import image_scripts

SCRIPT = Path(image_scripts.__path__[0]) / "install-optional-pip.sh"
STAND_IN = """#!/bin/bash
# A stand-in of Python with pip, which has no release 9 of anything and no nowhere at all
case "$*" in
  "-c "*) echo {folder}/site-packages ;;
  "- "*) cat {folder}/asked ;;
  "-m pip list"*) cat {folder}/installed ;;
  *)
    echo "$*" | sed 's|--constraint [^ ]*|KEPT|; s/^-m pip install //' >>{folder}/calls
    case "$*" in
      *arm*) echo 'lab_arm==1.0' >>{folder}/installed ;;
      *nowhere* | *==9*) exit 1 ;;
      *) echo "${{!#}}" >>{folder}/installed ;;
    esac ;;
esac
"""
GIT = """#!/bin/bash
# A stand-in of git
echo "$*" | sed 's|{folder}/[^ ]*|FOLDER|g' >>{folder}/cloned
case "$1" in clone) mkdir -p "${{!#}}/python" && cp {folder}/list "${{!#}}/python/requirements.txt" ;; esac
"""
PACKAGE = "git+https://github.com/lab/arm@v1#subdirectory=python"
LISTED = """\
# what it needs
numpy==1.26.4
PyYAML>=6  # read by it
stag_python==9.1\r
torch == 2.0 ; python_version < "4"
-r more.txt
./own
git+https://github.com/lab/other
nowhere
seaborn"""


@pytest.mark.parametrize("asked", ["", "scipy\n"])
def test_what_its_list_names_and_is_not_there(tmp_path: Path, asked: str) -> None:
    (tmp_path / "asked").write_text(asked)
    (tmp_path / "list").write_text(LISTED)
    many = "".join(f"other-{each}==1\n" for each in range(20_000))  # more than a pipe holds
    (tmp_path / "installed").write_text(f"numpy==1.24.4\nTorch==1.13.1\n{many}")
    (tmp_path / "python3").write_text(STAND_IN.format(folder=tmp_path))
    (tmp_path / "git").write_text(GIT.format(folder=tmp_path))
    again = (SCRIPT.parent / "ask-pip-again.sh").read_text().replace("/dev/shm", str(tmp_path))
    (tmp_path / "ask-pip-again").write_text(again.replace("/usr/local/share/roslab", str(tmp_path)))
    for name in ("python3", "git", "ask-pip-again"):
        (tmp_path / name).chmod(0o755)
    script = SCRIPT.read_text().replace("/usr/local/share/roslab/left-out.txt", f"{tmp_path}/left-out.txt")
    subprocess.run(
        ["bash", "-c", script, "install-optional-pip", f"{tmp_path}/python3", "--", PACKAGE],
        env={**os.environ, "TMPDIR": str(tmp_path), "PATH": f"{tmp_path}:{os.environ['PATH']}"},
        capture_output=True,
        check=True,
    )
    calls = (tmp_path / "calls").read_text().splitlines()
    if asked:  # it says itself what it needs
        assert calls == [PACKAGE]
        assert not (tmp_path / "cloned").exists()
        return
    pyyaml, stag, seaborn = ["PyYAML>=6"], ["stag_python==9.1", "stag_python"], ["seaborn"]
    assert calls == [PACKAGE, *(f"KEPT {each}" for each in (*pyyaml, *stag, "nowhere", "nowhere", *seaborn))]
    assert (tmp_path / "left-out.txt").read_text() == "pip nowhere\n"
    assert (tmp_path / "cloned").read_text().splitlines() == [
        "clone --quiet --filter=blob:none https://github.com/lab/arm FOLDER",
        "-C FOLDER checkout --quiet v1 --",
    ]
    assert not [*tmp_path.glob("tmp.*")]
