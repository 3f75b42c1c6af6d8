"""The version of projects that take it from git: what the tags say, and what a build without .git then installs."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.plan.version import from_tag
from roslab.render.dockerfile import dockerfile
from roslab.repository.git import describe


@pytest.mark.parametrize(
    ("tag", "distance", "version"),
    [
        ("v1.2.3", 0, "1.2.3"),
        ("1.2.3", 5, "1.2.4.dev5"),
        ("robot-2.0", 0, "2.0"),
        ("release/2.0", 1, "2.1.dev1"),
        ("v1.0rc1", 3, "1.0rc2.dev3"),
        ("v2020.01.05", 0, "2020.1.5"),
        ("iros2019", 0, None),
        ("paper-v1-final", 0, None),
    ],
)
def test_what_a_tag_says(tag: str, distance: int, version: str | None) -> None:
    assert from_tag(tag, distance) == version


def git(folder: Path, *arguments: str) -> None:
    who = ["-c", "user.name=a", "-c", "user.email=a@example.org"]
    environment = {"PATH": os.environ["PATH"], "HOME": str(folder)}
    subprocess.run(["git", "-C", folder, *who, *arguments], env=environment, check=True, capture_output=True)


def commit(folder: Path, *tags: str) -> None:
    if not (folder / ".git").exists():
        git(folder, "init", "--quiet")
    git(folder, "add", "--all")
    git(folder, "commit", "--quiet", "--allow-empty", "--message", "x")
    for tag in tags:
        git(folder, "tag", tag)


def test_the_nearest_tag(tmp_path: Path) -> None:
    assert describe(tmp_path) is None
    commit(tmp_path)
    assert describe(tmp_path) is None
    commit(tmp_path, "v1.0")
    commit(tmp_path, "submitted")
    assert describe(tmp_path) == ("v1.0", 1)


BACKENDS = {
    "setuptools_scm": '[build-system]\nrequires = ["setuptools", "setuptools_scm>=8"]\n'
    'build-backend = "setuptools.build_meta"\n[tool.setuptools_scm]\n',
    "hatch-vcs": '[build-system]\nrequires = ["hatchling", "hatch-vcs"]\nbuild-backend = "hatchling.build"\n'
    '[tool.hatch.version]\nsource = "vcs"\n',
    "versioningit": '[build-system]\nrequires = ["setuptools", "versioningit"]\n'
    'build-backend = "setuptools.build_meta"\n[tool.versioningit]\n',
    "versioneer": '[build-system]\nrequires = ["setuptools", "versioneer[toml]"]\n'
    'build-backend = "setuptools.build_meta"\n',
}
PROJECT = '[project]\nname = "robot"\ndynamic = ["version"]\n'


def tree(folder: Path, backend: str) -> Path:
    (folder / "robot").mkdir(parents=True)
    (folder / "robot/__init__.py").write_text("")
    (folder / "pyproject.toml").write_text(BACKENDS[backend] + PROJECT)
    if backend == "versioneer":
        (folder / "robot/_version.py").write_text('def get_keywords():\n    git_refnames = "$Format:%d$"\n')
    return folder


TABLES = {
    "scikit-build": (
        '[tool.scikit-build]\nmetadata.version.provider = "scikit_build_core.metadata.setuptools_scm"\n',
        "ARG SOURCE_VERSION=1.2.3",
    ),
    "setuptools_scm": ("[tool.setuptools_scm]\n", "ARG SOURCE_VERSION=1.2.3"),
    "hatch": ('[tool.hatch.version]\nsource = "vcs"\n', "ARG SOURCE_VERSION=1.2.3"),
    "pdm": ('[tool.pdm.version]\nsource = "scm"\n', "ARG PDM_BUILD_SCM_VERSION=1.2.3"),
    "poetry": ("[tool.poetry-dynamic-versioning]\nenable = true\n", "ARG POETRY_DYNAMIC_VERSIONING_BYPASS=1.2.3"),
    "pdm's own": ('[tool.pdm.version]\nsource = "file"\n', None),
    "switched off": ("[tool.poetry-dynamic-versioning]\nenable = false\n", None),
}


@pytest.mark.parametrize("name", TABLES)
def test_tables_that_take_the_version_from_git(tmp_path: Path, name: str) -> None:
    table, line = TABLES[name]
    (tmp_path / "robot").mkdir()
    (tmp_path / "robot/__init__.py").write_text("")
    (tmp_path / "pyproject.toml").write_text(table + PROJECT)
    commit(tmp_path, "v1.2.3")
    text = dockerfile(plan_repository(tmp_path).plan)
    assert ("# These take their version from git" in text) is (line is not None)
    assert line is None or f"\n{line}\n" in text
    assert line is None or text.index(line) < text.index("pip install", text.index(line))
    (tmp_path / "pyproject.toml").write_text(table + PROJECT.replace('dynamic = ["version"]', 'version = "1"'))
    assert plan_repository(tmp_path).plan.source_version is None


@pytest.mark.parametrize("backend", BACKENDS)
def test_the_dockerfile_says_the_tags_version(tmp_path: Path, backend: str) -> None:
    commit(tree(tmp_path, backend), "v1.2.3")
    planned = plan_repository(tmp_path)
    assert planned.plan.source_version
    assert planned.plan.source_version.version == "1.2.3"
    text = dockerfile(planned.plan)
    assert ("ARG SOURCE_TAG=v1.2.3" if backend == "versioneer" else "ARG SOURCE_VERSION=1.2.3") in text
    run_versions(text, tmp_path)
    if backend == "versioneer":
        assert "git_refnames = '(tag: v1.2.3)'" in (tmp_path / "robot/_version.py").read_text()
    else:
        assert "Name: robot\nVersion: 1.2.3\n" in (tmp_path / "PKG-INFO").read_text()


def run_versions(text: str, folder: Path) -> None:
    """Run the Dockerfile's lines that tell the version, in a folder."""
    (block,) = re.findall(r"^# These take their version.*?(?=\n\n)", text, flags=re.MULTILINE | re.DOTALL)
    arguments = dict(re.findall(r"^ARG (\w+)=(.*)$", block, flags=re.MULTILINE))
    command = block[block.index("RUN ") + 4 :]
    subprocess.run(["bash", "-euc", command], cwd=folder, env={**os.environ, **arguments}, check=True)


def test_a_checkout_without_a_version_says_so(tmp_path: Path) -> None:
    commit(tree(tmp_path, "setuptools_scm"), "submitted")
    planned = plan_repository(tmp_path)
    assert planned.plan.source_version
    assert planned.plan.source_version.version == "0.1.dev0"
    assert [w for w in planned.plan.warnings if "no tag here has one" in w.message]


def test_a_project_with_a_version_of_its_own_asks_no_git(tmp_path: Path) -> None:
    (tmp_path / "setup.py").write_text("from setuptools import setup\nsetup(name='robot', version='1')\n")
    commit(tmp_path, "v1.2.3")
    assert plan_repository(tmp_path).plan.source_version is None
