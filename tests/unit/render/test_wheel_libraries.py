"""The script that installs the libraries of the system which Python packages are linked with."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

from roslab.knowledge.shared_objects import table

SCRIPT = Path(__file__).parents[3] / "scripts/roslab/render/image_scripts/install-wheel-libraries.sh"
MODULE = next(Path(yaml.__file__).parent.glob("_yaml*.so"), None)
"""A module that is linked with the library of threads, whose name the tests change."""
THREADS = b"libpthread.so.0\0"
OWN = f"cpython-{sys.version_info.major}{sys.version_info.minor}-x86_64-linux-gnu.so"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A Python whose packages all lie in one folder, and an apt that writes down what it is asked for."""
    if MODULE is None or THREADS not in MODULE.read_bytes() or not all(map(shutil.which, ("bash", "ldd"))):
        pytest.skip("PyYAML brings a module for Linux's C library, and ldd reads it")
    (tmp_path / "shared-objects.txt").write_text(table() + "\nlibodd-2.so.0 libodd2.0-0\n")
    text = SCRIPT.read_text().replace(
        "/usr/local/share/roslab/shared-objects.txt", str(tmp_path / "shared-objects.txt")
    )
    programs = {
        "install-wheel-libraries": text,
        "install-optional-apt": f'#!/bin/sh\necho "$@" >{tmp_path}/asked\n',
        "own-python": f'#!/bin/sh\nexec {sys.executable} -S "$@"\n',
    }
    for name, program in programs.items():
        (tmp_path / name).write_text(program)
        (tmp_path / name).chmod(0o755)
    (tmp_path / "site-packages/demo").mkdir(parents=True)
    return tmp_path


def link(folder: Path, name: str, library: str) -> None:
    """Write a module that is linked with a library, whose name has 15 letters at most."""
    assert MODULE
    changed = MODULE.read_bytes().replace(THREADS, library.encode().ljust(len(THREADS), b"\0"))
    (folder / "site-packages/demo" / name).write_bytes(changed)


def asked(folder: Path) -> list[str]:
    """Return the packages that apt is asked for."""
    environment = os.environ | {
        "PATH": f"{folder}:{os.environ['PATH']}",
        "PYTHONPATH": str(folder / "site-packages"),
    }
    command = [str(folder / "install-wheel-libraries"), "own-python"]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stderr
    return (folder / "asked").read_text().split() if (folder / "asked").exists() else []


@pytest.mark.parametrize(
    ("library", "package"),
    [
        ("libQq.so.1", "libqq1"),
        ("libX77.so.6", "libx77-6"),
        ("lib_q_q.so.2.1", "lib-q-q2.1"),
        ("libqq3.so", "libqq3"),
        ("libodd-2.so.0", "libodd2.0-0"),
    ],
)
def test_a_library_that_is_missing_is_installed(folder: Path, library: str, package: str) -> None:
    link(folder, f"part.{OWN}", library)
    link(folder, f"other.{OWN}", library)
    assert asked(folder) == [package]


@pytest.mark.parametrize("library", ["libpthread.so.0", "libcuda.so.1", "libcudart.so.9", "libnvinfer.so.8"])
def test_what_is_there_or_comes_from_elsewhere_is_not_asked_for(folder: Path, library: str) -> None:
    link(folder, f"part.{OWN}", library)
    assert asked(folder) == []


def test_what_a_package_brings_itself_is_not_asked_for(folder: Path) -> None:
    link(folder, f"part.{OWN}", "libown.so.1")
    (folder / "site-packages/demo/libown.so.1").symlink_to("libown.so.1.2")
    assert asked(folder) == []


def test_what_only_a_plugin_is_linked_with_is_not_asked_for(folder: Path) -> None:
    link(folder, f"part.{OWN}", "libpthread.so.0")
    link(folder, "libplugin.so", "libQq.so.1")
    assert asked(folder) == []


def test_packages_without_modules_ask_for_nothing(folder: Path) -> None:
    (folder / "site-packages/demo/part.py").write_text("")
    assert asked(folder) == []
