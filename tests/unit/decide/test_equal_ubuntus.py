"""Of the Ubuntus of one matrix of CI, the newest that has not ended is taken."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

Tree = Callable[[dict[str, str]], Decision]
CI = ".github/workflows/build.yml"
MATRIX = (
    "jobs:\n  build:\n    runs-on: ${{{{ matrix.os }}}}\n"
    "    strategy:\n      matrix:\n{}    steps:\n      - run: make\n"
)
JOB = (
    "  {}:\n    runs-on: ubuntu-{}\n    steps:\n"
    "      - uses: actions/checkout@v4\n      - run: cmake .\n      - run: make\n"
)
CODE = {"CMakeLists.txt": "project(demo)\nadd_executable(demo a.cpp)\n", "a.cpp": "int main() { return 0; }\n"}


def _list(*numbers: str) -> str:
    return MATRIX.format(f"        os: [{', '.join(f'ubuntu-{number}' for number in numbers)}]\n")


def _lines(*numbers: str) -> str:
    entries = "".join(f"          - os: ubuntu-{number}\n            compiler: gcc\n" for number in numbers)
    return MATRIX.format(f"        include:\n{entries}")


@pytest.mark.parametrize(
    ("ci", "page", "ubuntu"),
    [
        (_list("20.04", "22.04"), "", "jammy"),
        (_list("22.04", "20.04"), "", "jammy"),
        (_list("20.04", "24.04", "22.04"), "", "noble"),
        (_lines("20.04", "22.04"), "", "jammy"),
        (_list("18.04", "20.04"), "", "bionic"),  # both have ended
        (_list("20.04"), "", "focal"),
        (f"jobs:\n{JOB.format('build', '20.04')}{JOB.format('lint', '22.04')}", "", "focal"),  # no matrix
        (_list("20.04", "22.04"), "It needs Python 3.8.\n", "focal"),
    ],
)
def test_the_newest_of_a_matrix(tree: Tree, ci: str, page: str, ubuntu: str) -> None:
    decision = tree({**CODE, CI: ci, "README.md": f"# Demo\n\n{page}"})
    assert (decision.kind, decision.ubuntu) == ("cpp", ubuntu)


def test_a_page_that_names_several_is_read_in_its_order(tree: Tree) -> None:
    assert tree({**CODE, "README.md": "Tested on Ubuntu 20.04 and Ubuntu 22.04.\n"}).ubuntu == "focal"


def test_for_the_image_of_a_day_what_had_not_ended_then(tree: Tree, tmp_path: Path) -> None:
    tree({**CODE, CI: _list("18.04", "20.04", "22.04")})
    dated = decide(gather(Repository.open(tmp_path)), Config(date="2021-06-01"), folder_name="demo")
    assert dated.ubuntu == "focal"


def test_an_ubuntu_whose_packages_hold_a_newer_compiler_is_not_said_to_have_none(tmp_path: Path) -> None:
    """Focal comes with GCC 9 and packages g++-10, which is installed where focal is taken all the same."""
    code = {**CODE, "a.cpp": "#include <span>\nint main() { return 0; }\n", "README.md": "Ubuntu 20.04.\n"}
    for name, text in code.items():
        (tmp_path / name).write_text(text)
    decision = decide(gather(Repository.open(tmp_path)), Config(), folder_name="demo")
    said = [reason.reason for reason in decision.reasons if reason.question == "ubuntu" and reason.answer == "focal"]
    assert any("; but focal comes without GCC 10 or newer" in reason for reason in said), said
