"""Lists of system packages that a Dockerfile, a script or a page gives to apt."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PROGRAM = {"main.py": "import numpy\nif __name__ == '__main__':\n    pass\n", "requirements.txt": "numpy\n"}
LIST = "# for sound\nlibsndfile1 portaudio19-dev\n"


@pytest.mark.parametrize(
    ("by", "line"),
    [
        ("sim/Dockerfile", "FROM ubuntu:22.04\nCOPY ./dep /app/dep\nRUN xargs apt -y install < /app/dep/names.txt\n"),
        ("sim/Dockerfile", "FROM ubuntu:22.04\nRUN apt-get update && \\\n  apt-get install -y $(cat dep/names.txt)\n"),
        ("setup.sh", 'cd "$DIR"\nxargs -a "$DIR/sim/dep/names.txt" sudo apt-get install -y\n'),
        ("setup.sh", "grep -v '^#' sim/dep/names.txt | xargs sudo apt-get install -y\n"),
        ("README.md", "# Setup\n```\nsudo apt install `cat sim/dep/names.txt`\n```\n"),
    ],
)
def test_a_list_that_apt_is_given(tree: Tree, by: str, line: str) -> None:
    found = tree({**PROGRAM, by: line, "sim/dep/names.txt": LIST, "other/dep/more.txt": "nano\n"})
    assert {"libsndfile1", "portaudio19-dev"} <= {*found.apt, *found.apt_guessed}
    assert "nano" not in {*found.apt, *found.apt_guessed}


@pytest.mark.parametrize(
    ("by", "line", "text"),
    [
        ("setup.sh", "xargs sudo apt-get install -y < names.txt\n", "one: two\nlibsndfile1\n"),  # no list of names
        ("setup.sh", "apt install $(lsb_release -cs)-tools; pip install -r names.txt\n", LIST.partition("\n")[2]),
        ("docs/Dockerfile", "FROM ubuntu:22.04\nRUN apt-get install -y $(cat names.txt)\n", LIST),
        ("docker/jetson/Dockerfile", "FROM ubuntu:22.04\nRUN apt-get install -y $(cat names.txt)\n", LIST),
    ],
)
def test_other_files_are_no_lists(tree: Tree, by: str, line: str, text: str) -> None:
    found = tree({**PROGRAM, by: line, "names.txt": text})
    assert "libsndfile1" not in {*found.apt, *found.apt_guessed}


def test_of_two_lists_that_of_its_folder(tree: Tree) -> None:
    docker = "FROM ubuntu:22.04\nRUN xargs apt-get install -y < /names.txt\n"
    found = tree({**PROGRAM, "sim/Dockerfile": docker, "sim/names.txt": LIST, "robot/names.txt": "nano\n"})
    assert "libsndfile1" in found.apt_guessed
    assert "nano" not in found.apt_guessed
