"""Commands that a sentence names without a mark of code."""

from __future__ import annotations

from pathlib import Path

import pytest

from hanging import ends
from roslab.evidence.prose.in_sentences import in_sentence
from roslab.pipeline import plan_repository

FILES = {
    "main.py": "import numpy\nif __name__ == '__main__':\n    print('a')\n",
    "other.py": "if __name__ == '__main__':\n    print('a')\n",
    "run.sh": "echo a\n",
    "requirements.txt": "numpy\n",
}


@pytest.mark.parametrize(
    ("said", "command"),
    [
        ("Run **python main.py --fast** to start.", "python main.py --fast"),
        ("Use **python main.py** to start and **python other.py** for more.", "python main.py"),
        ("Start it by **bash run.sh** now.", "bash run.sh"),
        ("<code>python main.py --fast</code> starts it.", "python main.py --fast"),
        ("To run the demo use python main.py --data a.npz --fast.", "python main.py --data a.npz --fast"),
        ("**Run:** python main.py --data few", "python main.py --data few"),
        ('You can use "python main.py --fast" to start.', "python main.py --fast"),
    ],
)
def test_a_sentence_runs(tmp_path: Path, said: str, command: str) -> None:
    assert command_of(tmp_path, said) == tuple(command.split())


@pytest.mark.parametrize(
    "said",
    [
        "Do not use python main.py.",
        "Use the path with which python main.py is run.",
        "**Note**: if python main.py fails, start **again**.",
        "If **python main.py** fails, reboot.",
        "**Important:** main.py reads a file.",
        "Use **main** and **python**.",
    ],
)
def test_a_sentence_that_runs_nothing(tmp_path: Path, said: str) -> None:
    assert command_of(tmp_path, said) == ("bash",)


def test_a_command_in_bold_letters_installs(tmp_path: Path) -> None:
    for name, text in {**FILES, "README.md": "# Usage\n\nCall **pip install einops** before.\n"}.items():
        (tmp_path / name).write_text(text)
    assert "einops" in plan_repository(tmp_path).plan.python.pip_guessed


def test_a_long_line_takes_no_long_time() -> None:
    with ends():
        for line in ("run python a.py " + "-a b.c " * 600 + "(", "run " * 1_500 + "python a.py x", "**python a" * 500):
            assert not [*in_sentence(line)]


def command_of(folder: Path, said: str) -> tuple[str, ...] | str:
    for name, text in {**FILES, "README.md": f"# Demo\n\n## Usage\n\n{said}\n"}.items():
        (folder / name).write_text(text)
    return plan_repository(folder).plan.run.command


@pytest.mark.parametrize(
    ("said", "commands"),
    [
        ("Start the viewer with rosrun demo viewer.", ["rosrun demo viewer"]),
        ("Then ros2 run demo viewer_node _rate:=5 shows it.", ["ros2 run demo viewer_node _rate:=5"]),
        ("Call rosrun demo view-er.py, then look.", ["rosrun demo view-er.py"]),
        ('"rosrun demo viewer" shows the map.', ["rosrun demo viewer"]),
        ("Do not use rosrun demo viewer.", []),
        ("You don't have to call rosrun demo viewer.", []),
        ("Call the script instead of rosrun demo viewer.", []),
        ("If rosrun demo viewer says no executable found, source it.", []),
        ("If roslaunch demo map.launch fails, wait.", []),
        ("Never start roslaunch demo map.launch.", []),
        ("Use rosrun with /opt/demo/viewer.", []),
        ("Use rosrun to start the nodes.", []),
        ("Start them by rosrun or roslaunch.", []),
        ("The command ros2 run is found there.", []),
        ("Give ros2 run demo and the name of a node.", []),
        ("Then rosrun tools is_ready checks it.", ["rosrun tools is_ready"]),
        ("It does not need a map: rosrun demo viewer shows it.", ["rosrun demo viewer"]),
    ],
)
def test_a_sentence_starts_a_node(said: str, commands: list[str]) -> None:
    assert list(in_sentence(said)) == commands


def test_a_node_in_a_sentence_is_the_default(tmp_path: Path) -> None:
    package = (
        "<package format='2'><name>demo</name><version>0</version><buildtool_depend>catkin</buildtool_depend></package>"
    )
    cmake = "find_package(catkin REQUIRED)\ncatkin_package()\nadd_executable(a a.cpp)\nadd_executable(viewer b.cpp)\n"
    page = "# Demo for ROS Noetic\n\n## Usage\n\nOpen a terminal and start rosrun demo viewer there.\n"
    for name, text in {"package.xml": package, "CMakeLists.txt": cmake, "README.md": page}.items():
        (tmp_path / name).write_text(text)
    assert plan_repository(tmp_path).plan.run.command == ("rosrun", "demo", "viewer")
