"""What its author changes by sed in a library before he builds it is changed in the image, too."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CMAKE = "cmake_minimum_required(VERSION 3.5)\nproject(demo)\nfind_package(g2o REQUIRED)\nadd_executable(a a.cpp)\n"
FILES = {"CMakeLists.txt": CMAKE, "a.cpp": "int main() {}\n"}
URL = "https://github.com/RainerKuemmerle/g2o.git"
START = (
    f"FROM ubuntu:22.04\nRUN cd /tmp && git clone {URL} && cd g2o && {{}} && mkdir build && cd build && cmake .. && "
)
END = "make install\nCOPY . /demo\n"


def prepared(decision: Decision) -> str:
    return next(source.prepare for source in decision.source if source.name == "g2o")


@pytest.mark.parametrize(
    ("step", "call"),
    [
        ("sed -i 's/a b/virtual c/' g2o/core/a.h", "'--expression=s/a b/virtual c/' -- g2o/core/a.h"),
        (
            "sed -i.bak -E -e 's/a/b/' -e /c/d CMakeLists.txt",
            "-E --expression s/a/b/ --expression /c/d -- CMakeLists.txt",
        ),
        ("sed -Ei s/a/b/ /tmp/g2o/g2o/x.h y.h", "-E --expression=s/a/b/ -- g2o/x.h y.h"),
        ("cd g2o && sed --in-place s/a/b/ core/x.h && cd ..", "--expression=s/a/b/ -- g2o/core/x.h"),
    ],
)
def test_what_a_dockerfile_changes(tree: Tree, step: str, call: str) -> None:
    decision = tree({**FILES, "docker/Dockerfile": START.format(step) + END})
    told = "'roslab: left out: g2o is not changed as by docker/Dockerfile:2'"
    assert prepared(decision) == f"{{ sed --in-place {call} || echo {told}; }}"
    assert any("in it by sed" in each.reason and each.answer == "g2o" for each in decision.reasons)


@pytest.mark.parametrize(
    "step",
    [
        "sed s/a/b/ g2o/core/a.h",
        "sed -i s/a/$B/ g2o/core/a.h",
        "sed -i s/a/b/ *.h",
        "sed -i s/a/b/ /etc/apt/sources.list",
        "sed -i s/a/b/",
        "sed -i",
        "sed -i -f script.sed a.h",
    ],
)
def test_what_changes_nothing_of_the_library(tree: Tree, step: str) -> None:
    assert prepared(tree({**FILES, "docker/Dockerfile": START.format(step) + END})) == ""


def test_a_page_changes_it_and_the_call_is_one_of_the_shell(tree: Tree, tmp_path: Path) -> None:
    steps = f'git clone {URL}\ncd g2o\nsed -i "s/it\'s/its/" a.h b.h\nmkdir build && cd build\ncmake ..\nmake install\n'
    step = prepared(tree({**FILES, "README.md": f"```\n{steps}```\n"}))
    (tmp_path / "a.h").write_text("it's\n")
    ran = subprocess.run(["bash", "-euc", step], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert (tmp_path / "a.h").read_text() == "its\n"
    assert "g2o is not changed as by README.md" in ran.stdout


def test_help_against_errors_is_not_for_everybody(tree: Tree) -> None:
    steps = f"git clone {URL}\ncd g2o\nmkdir build && cd build\ncmake ..\nmake install\n"
    page = f"# Demo\n## Build\n```\n{steps}```\n## Troubleshooting\n```\ncd g2o\nsed -i s/a/b/ a.h\n```\n"
    assert prepared(tree({**FILES, "README.md": page})) == ""
