"""hadolint on every Dockerfile that is generated, those of the examples and one for each block they do not show."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Callable
from pathlib import Path
from subprocess import CompletedProcess

import pytest

from golden_files import names, of_distros, whole
from roslab.pipeline import plan_repository
from roslab.render.bases import bases

ROOT = Path(__file__).resolve().parent.parent.parent
GENERATED = [name for name in names() if "Dockerfile" in whole(name)]

PACKAGE = """\
<package format="2"><name>part</name><version>1.0.0</version><description>.</description>
<maintainer email="a@example.org">A</maintainer><license>Apache-2.0</license>
<buildtool_depend>catkin</buildtool_depend><depend>roscpp</depend></package>
"""
ROS = {"package.xml": PACKAGE, "CMakeLists.txt": "project(part)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"}
PYTHON = {"main.py": "import numpy\n\nif __name__ == '__main__':\n    print(numpy.zeros(3))\n"}
VARIANTS = {
    "catkin_tools": ROS
    | {"roslab.yaml": "format: 3\nbase:\n  ros: noetic\nbuild: catkin_tools\nbuild_args: [--verbose]\n"},
    "catkin_make_isolated": ROS | {"roslab.yaml": "format: 3\nbase:\n  ros: noetic\nbuild: catkin_make_isolated\n"},
    "past_day": ROS | {"roslab.yaml": "format: 3\nbase:\n  ros: noetic\ndate: 2024-05-20\npip: [numpy]\n"},
    "old_distro": ROS | {"roslab.yaml": "format: 3\nbase:\n  ros: melodic\nskip_keys: [some_key]\n"},
    "sister_source": ROS
    | {
        "roslab.yaml": "format: 3\nbase:\n  ros: noetic\nsource:\n  - name: sister\n    repo: https://example.org/sister.git\n"
        "    ref: v1\n    build: catkin_make\n"
    },
    "library": PYTHON
    | {
        "roslab.yaml": "format: 3\nsource:\n  - name: first\n    repo: https://example.org/first.git\n    ref: v1\n"
        "    depends: [libeigen3-dev]\n    cmake_options: -DBUILD_TESTS=OFF\n"
        "  - name: second\n    zip: https://example.org/second.zip\n"
    },
    "notebook": PYTHON | {"roslab.yaml": "format: 3\nnotebook: true\nenv:\n  GREETING: it's $HOME\ngpu: true\n"},
    "custom": PYTHON | {"roslab.yaml": "format: 3\ncustom:\n  - echo one\n  - echo two\nrepo: [ppa:some/thing]\n"},
    "secrets": PYTHON
    | {
        "roslab.yaml": "format: 3\nsecrets: [pip_index, netrc, ssh, apt_auth, map_key]\npip: [requests]\n"
        "source: [{name: first, repo: 'git@example.org:lab/first.git', ref: v1}]\ncustom: [ls /run/secrets]\n"
    },
    "old_python": PYTHON | {"roslab.yaml": 'format: 3\nbase:\n  python: "3.6"\n'},
    "conda": PYTHON | {"environment.yml": "name: part\nchannels: [conda-forge]\ndependencies: [python=3.9, numpy]\n"},
    "pyproject": PYTHON
    | {
        "pyproject.toml": "[build-system]\nrequires = ['setuptools']\nbuild-backend = 'setuptools.build_meta'\n"
        "[project]\nname = 'part'\nversion = '1'\ndependencies = ['numpy']\n"
    },
    "later_format": PYTHON
    | {
        "roslab.yaml": "name: part\nbase:\n  ubuntu: 18.04\napt: [libeigen3-dev]\npip: [numpy]\npip3: [scipy]\n"
        "source:\n  - name: first\n    repo: https://example.org/first.git\ncustom:\n  - cd /tmp\n  - ls\n"
    },
    "paper_format": {
        "roslab.yaml": "name: part\ndistro: kinetic\nbuild: catkin_make\npackages: [libeigen3-dev]\n",
        **ROS,
    },
}


def lint(text: str, hadolint: str) -> None:
    if shell := re.search(r"^SHELL .*$", text, re.MULTILINE):
        # hadolint forgets the shell at the next ENV, ARG or stage and then reads bash as sh; docker does not
        text = re.sub(r"^RUN ", lambda found: f"{shell[0]}\n{found[0]}", text, flags=re.MULTILINE)
    answer = subprocess.run(
        [hadolint, "--no-color", "--config", str(ROOT / ".hadolint.yaml"), "-"],
        input=text,
        capture_output=True,
        text=True,
        check=False,
    )
    assert answer.returncode == 0, answer.stdout + answer.stderr
    assert answer.stdout == ""


@pytest.mark.parametrize("name", GENERATED)
def test_examples(name: str, tool: Callable[[str], str]) -> None:
    lint(whole(name)["Dockerfile"], tool("hadolint"))


def test_every_distribution(tool: Callable[[str], str]) -> None:
    for text in of_distros().values():
        lint(text, tool("hadolint"))


def test_what_replaces_the_bases_of_an_authors_dockerfile(tmp_path: Path, tool: Callable[[str], str]) -> None:
    files = {
        "Dockerfile": "FROM ros:kinetic AS one\nFROM nvidia/cuda:10.0-devel-ubuntu18.04\nCOPY . /source\n",
        "CMakeLists.txt": "project(robot CXX)\n",
        "roslab.yaml": "format: 3\nkind: cpp\ndockerfile: Dockerfile\n",
    }
    for path, text in files.items():
        (tmp_path / path).write_text(text)
    authored = plan_repository(tmp_path).plan.author_dockerfile
    assert authored
    assert len(authored.bases) == 2
    lint(bases(authored.bases, "robot"), tool("hadolint"))


@pytest.mark.parametrize("name", VARIANTS)
def test_variants(
    name: str, roslab: Callable[..., CompletedProcess[str]], tool: Callable[[str], str], tmp_path: Path
) -> None:
    tree = tmp_path / name
    for path, text in VARIANTS[name].items():
        (tree / path).parent.mkdir(parents=True, exist_ok=True)
        (tree / path).write_text(text)
    answer = roslab("create", tree)
    assert answer.returncode == 0, answer.stderr
    lint((tree / "Dockerfile").read_text(), tool("hadolint"))


@pytest.mark.parametrize("name", GENERATED)
def test_it_can_fail(name: str, tool: Callable[[str], str]) -> None:
    """At the end of each file: a heredoc that hadolint does not see the end of would hide what follows."""
    for wrong in ("RUN cd /tmp && sudo ls $HOME\n", "COPY --from=nowhere a b c\n"):
        with pytest.raises(AssertionError):
            lint(whole(name)["Dockerfile"] + wrong, tool("hadolint"))
