"""What pip installs of projects that take their version from git, in a tree without .git as a build has it."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

BACKENDS = {
    "setuptools_scm": '[build-system]\nrequires = ["setuptools", "setuptools_scm>=8"]\n'
    'build-backend = "setuptools.build_meta"\n[tool.setuptools_scm]\n',
    "hatch-vcs": '[build-system]\nrequires = ["hatchling", "hatch-vcs"]\nbuild-backend = "hatchling.build"\n'
    '[tool.hatch.version]\nsource = "vcs"\n',
    "versioningit": '[build-system]\nrequires = ["setuptools", "versioningit"]\n'
    'build-backend = "setuptools.build_meta"\n[tool.versioningit]\n',
}
PROJECT = '[project]\nname = "robot"\ndynamic = ["version"]\n'


def tree(folder: Path, backend: str) -> Path:
    (folder / "robot").mkdir(parents=True)
    (folder / "robot/__init__.py").write_text("")
    (folder / "pyproject.toml").write_text(BACKENDS[backend] + PROJECT)
    return folder


def tagged(folder: Path, tag: str) -> None:
    who = ["-c", "user.name=a", "-c", "user.email=a@example.org"]
    for words in (["init", "--quiet"], ["add", "--all"], ["commit", "--quiet", "--message", "x"], ["tag", tag]):
        subprocess.run(["git", "-C", folder, *who, *words], check=True, capture_output=True)


def run_versions(text: str, folder: Path) -> None:
    """Run the Dockerfile's lines that tell the version, in a folder."""
    (block,) = re.findall(r"^# These take their version.*?(?=\n\n)", text, flags=re.MULTILINE | re.DOTALL)
    arguments = dict(re.findall(r"^ARG (\w+)=(.*)$", block, flags=re.MULTILINE))
    command = block[block.index("RUN ") + 4 :]
    subprocess.run(["bash", "-euc", command], cwd=folder, env={**os.environ, **arguments}, check=True)


@pytest.mark.parametrize("backend", BACKENDS)
def test_pip_installs_the_tags_version_without_git(tmp_path: Path, backend: str) -> None:
    folder = tree(tmp_path / "source", backend)
    tagged(folder, "v1.2.3")
    text = dockerfile(plan_repository(folder).plan)
    subprocess.run(["rm", "-rf", folder / ".git"], check=True)
    install: list[str | Path] = [
        sys.executable,
        "-m",
        "pip",
        "install",
        "--quiet",
        "--no-deps",
        "--target",
        tmp_path / "into",
        folder,
    ]
    without = subprocess.run(install, capture_output=True, text=True, check=False)
    assert without.returncode != 0, "without the version it fails, so the check below means something"
    run_versions(text, folder)
    subprocess.run(install, check=True, capture_output=True)
    assert (tmp_path / "into/robot-1.2.3.dist-info").is_dir()
