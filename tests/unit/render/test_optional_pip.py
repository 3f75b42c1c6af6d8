"""Packages that are only guessed replace nothing that was named; the script runs against a stand-in of pip."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

from roslab.render import image_scripts

SCRIPT = Path(image_scripts.__path__[0]) / "install-optional-pip.sh"
STAND_IN = """#!/bin/bash
# A stand-in of Python with pip: it notes each call, lists what a file says, and refuses what another file says
case "$*" in
  "-c "*) echo {folder}/site-packages ;;
  "- "*) grep --quiet --line-regexp -- "$2" {folder}/modules ;;
  "-m pip show"*) echo "Version: $(cat {folder}/version)" ;;
  "-m pip list"*) echo "$*" >>{folder}/calls; cat {folder}/installed ;;
  *)
    if [ "${{5:-}}" = --constraint ]; then cp "${{6}}" {folder}/kept; fi
    echo "$*" | sed 's|--constraint [^ ]*|--constraint KEPT|; s/^-m pip install //' >>{folder}/calls
    if [ "${{@: -1}}" = egl_probe ] && ! grep --quiet 'dir cmake<4$' {folder}/calls; then
      echo "2026-11-27T10:00:00,000   RuntimeError: CMake must be installed." >"${{PIP_LOG}}"
      exit 1
    fi
    if grep --quiet --line-regexp --fixed-strings -- "${{@: -1}}" {folder}/refused; then exit 1; fi
    while read -r package _ module; do
      if [ "${{package}}" = "${{@: -1}}" ]; then echo "${{module}}" >>{folder}/modules; fi
    done <{folder}/brought ;;
esac
"""


def _run(folder: Path, *packages: str, installed: str = "", refused: str = "", brought: str = "") -> list[str]:
    """Return the calls of pip that install, with what was kept below them."""
    (folder / "installed").write_text(installed)
    (folder / "refused").write_text(refused)
    (folder / "brought").write_text(brought)
    (folder / "modules").touch()
    (folder / "python3").write_text(STAND_IN.format(folder=folder))
    (folder / "python3").chmod(0o755)
    again = (SCRIPT.parent / "ask-pip-again.sh").read_text().replace("/dev/shm", str(folder))
    (folder / "ask-pip-again").write_text(again.replace("/usr/local/share/roslab", str(folder)))
    (folder / "ask-pip-again").chmod(0o755)
    script = SCRIPT.read_text().replace("/usr/local/share/roslab/left-out.txt", f"{folder}/left-out.txt")
    subprocess.run(
        ["bash", "-c", script, "install-optional-pip", f"{folder}/python3", "--no-cache-dir", "--", *packages],
        env={**os.environ, "TMPDIR": str(folder), "PATH": f"{folder}:{os.environ['PATH']}"},
        capture_output=True,
        check=True,
    )
    calls = (folder / "calls").read_text().replace(str(folder), "").splitlines()
    return [call for call in calls if "pip list" not in call]


def test_what_a_page_names_comes_first_and_is_kept(tmp_path: Path) -> None:
    installed = "torch==1.7.1+cu110\ndistro-info==0.23ubuntu1\nnumpy==1.19.5\nlab @ file:///lab\n"
    calls = _run(tmp_path, "timm", "torch==1.7.1+cu110", "scipy", "numpy<1.20", installed=installed)
    assert calls == [
        "--no-cache-dir --constraint KEPT torch==1.7.1+cu110",
        "--no-cache-dir --constraint KEPT numpy<1.20",
        "--no-cache-dir --constraint KEPT timm",
        "--no-cache-dir --constraint KEPT scipy",
    ]
    assert (tmp_path / "kept").read_text() == "torch==1.7.1+cu110\nnumpy==1.19.5\n"
    assert not [*tmp_path.glob("tmp.*")]  # two builds would differ by the name


def test_a_version_that_cannot_be_had_beside_what_is_there_is_tried_without_that(tmp_path: Path) -> None:
    """The stand-in refuses by the last word alone, so that the call without the kept releases fails here, too."""
    calls = _run(tmp_path, "mediapipe>=0.10.0", installed="numpy==1.26.4\n", refused="mediapipe>=0.10.0\n")
    assert calls == [
        "--no-cache-dir --constraint KEPT mediapipe>=0.10.0",
        "--no-cache-dir mediapipe>=0.10.0",
        "--no-cache-dir --no-build-isolation mediapipe>=0.10.0",
    ]
    assert (tmp_path / "kept").read_text() == "numpy==1.26.4\n"


def test_a_version_with_options_of_its_own_is_tried_with_them_beside_what_is_there(tmp_path: Path) -> None:
    calls = _run(tmp_path, "--no-build-isolation=sdf==1.0", "--no-deps=lab<2", installed="numpy==1.26.4\n")
    assert calls == [
        "--no-cache-dir --no-build-isolation --constraint KEPT sdf==1.0",
        "--no-cache-dir --no-deps --constraint KEPT lab<2",
    ]


def test_what_is_cloned_keeps_its_place_and_is_built_beside_torch(tmp_path: Path) -> None:
    clone = "lab @ git+https://example.org/lab.git@v1"
    (tmp_path / "left-out.txt").touch()
    calls = _run(tmp_path, "torch", clone, refused=f"{clone}\n")
    assert calls == [
        "--no-cache-dir --constraint KEPT torch",
        f"--no-cache-dir {clone}",
        f"--no-cache-dir --no-build-isolation {clone}",
    ]
    assert (tmp_path / "left-out.txt").read_text() == f"pip {clone}\n"


def test_what_a_page_builds_beside_torch_is_built_so_first(tmp_path: Path) -> None:
    clone = "git+https://example.org/lab.git@v1"
    calls = _run(tmp_path, f"--no-build-isolation={clone}", "--no-build-isolation=sdf==1.0")
    assert calls == [
        "--no-cache-dir --no-build-isolation sdf==1.0",
        f"--no-cache-dir --no-build-isolation {clone}",
    ]
    (tmp_path / "left-out.txt").touch()
    calls = _run(tmp_path, f"--no-build-isolation={clone}", refused=f"{clone}\n")
    assert calls[-1] == f"--no-cache-dir {clone}"
    assert (tmp_path / "left-out.txt").read_text() == f"pip {clone}\n"


def test_of_a_version_that_is_gone_another_one_is_taken(tmp_path: Path) -> None:
    calls = _run(tmp_path, "carla==0.9.10", refused="carla==0.9.10\ncarla==0.9.10.*\n")
    assert calls[:4] == ["--no-cache-dir carla==0.9.10", "--no-cache-dir --no-build-isolation carla==0.9.10",
                         "--no-cache-dir carla==0.9.10.*", "--no-cache-dir carla"]  # fmt: skip
    assert not (tmp_path / "left-out.txt").exists()


def test_of_a_version_whose_releases_have_more_numbers_one_of_them_is_taken(tmp_path: Path) -> None:
    calls = _run(tmp_path, "carla==0.9.10", "torch==1.7.1+cu110", refused="carla==0.9.10\ntorch==1.7.1+cu110\n")
    assert calls[2:3] == ["--no-cache-dir carla==0.9.10.*"]
    assert calls[3:6] == ["--no-cache-dir torch==1.7.1+cu110", "--no-cache-dir --no-build-isolation torch==1.7.1+cu110",
                          "--no-cache-dir torch"]  # fmt: skip


def test_a_program_that_a_build_lacks_comes_first(tmp_path: Path) -> None:
    (tmp_path / "build-programs.txt").write_text("cmake<4 CMake must be installed\n")
    calls = _run(tmp_path, "egl_probe")
    assert calls == [
        "--no-cache-dir --constraint KEPT egl_probe",
        "--no-cache-dir cmake<4",
        "--no-cache-dir --constraint KEPT egl_probe",
    ]


def test_by_its_own_name_nothing_is_tried_where_another_package_brought_the_module(tmp_path: Path) -> None:
    (tmp_path / "modules").write_text("prediction\n")
    calls = _run(tmp_path, "--by-name=prediction", "--by-name=predictions", brought="predictions brings predictions\n")
    assert calls == ["--no-cache-dir --constraint KEPT predictions"]
    assert not (tmp_path / "left-out.txt").exists()


def test_where_the_newest_release_renamed_the_module_the_major_version_before_is_taken(tmp_path: Path) -> None:
    (tmp_path / "version").write_text("2.4.0\n")
    calls = _run(tmp_path, "--by-name=drawSvg", brought="drawSvg brings drawsvg\ndrawSvg<2 brings drawSvg\n")
    assert calls == ["--no-cache-dir --constraint KEPT drawSvg", "--no-cache-dir --constraint KEPT drawSvg<2"]
    assert not (tmp_path / "left-out.txt").exists()


@pytest.mark.parametrize(("version", "older"), [("0.3", []), ("2.4.0", ["drawSvg<2"]), ("unknown", [])])
def test_a_package_without_the_module_of_its_name_is_named(tmp_path: Path, version: str, older: list[str]) -> None:
    (tmp_path / "version").write_text(f"{version}\n")
    calls = _run(tmp_path, "--by-name=drawSvg")
    assert [call.split()[-1] for call in calls] == ["drawSvg", *older]
    assert (tmp_path / "left-out.txt").read_text() == "pip drawSvg\n"


def test_what_is_bare_is_installed_without_what_it_asks_for(tmp_path: Path) -> None:
    clone = "lab @ git+https://example.org/lab-api"
    (tmp_path / "left-out.txt").touch()
    calls = _run(tmp_path, f"--no-deps={clone}", "--no-build-isolation=--no-deps=sdf==1.0", refused=f"{clone}\n")
    assert calls == [
        "--no-cache-dir --no-deps --no-build-isolation sdf==1.0",
        f"--no-cache-dir --no-deps {clone}",
        f"--no-cache-dir --no-deps --no-build-isolation {clone}",
    ]
    assert (tmp_path / "left-out.txt").read_text() == f"pip {clone}\n"


def test_another_version_of_what_is_bare_is_installed_so_too(tmp_path: Path) -> None:
    calls = _run(tmp_path, "--no-deps=sdf==1.0", refused="sdf==1.0\nsdf==1.0.*\n")
    assert [call for call in calls if "list" not in call] == [
        "--no-cache-dir --no-deps sdf==1.0",
        "--no-cache-dir --no-deps --no-build-isolation sdf==1.0",
        "--no-cache-dir --no-deps sdf==1.0.*",
        "--no-cache-dir --no-deps sdf",
    ]
