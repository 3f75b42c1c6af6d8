"""Programs that the shell script of the default command calls."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PROGRAMS = {"tmux", "tmuxinator", "jq", "xterm", "screen"}
FILES = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
}
PAGE = "ROS Noetic\n## Usage\n```\n./run.sh\n```\n"


def decided(tree: Tree, script: str, **more: str) -> Decision:
    return tree(FILES | {"README.md": PAGE, "run.sh": f"#!/bin/bash\n{script}\n"} | more)


@pytest.mark.parametrize(
    ("script", "asked"),
    [
        ("tmuxinator start -p a.yml", {"tmuxinator"}),
        ("tmux new-session -d -s demo; jq . a.json", {"tmux", "jq"}),
        ("names=$(tmux list-sessions | jq -r .)", {"tmux", "jq"}),
        ("names=$(cat a.json | jq)\nothers=`ls | screen`", {"jq", "screen"}),
        ("case $1 in\nstart|screen) true ;;\njq) true ;;\nesac", set()),
        ('mode=$(case "$1" in fast|screen) echo 1;; slow|jq) echo 2;; esac)', set()),
        ('mode=$(case "$1" in fast|screen) cat a | jq;; esac)', {"jq"}),
        ("a=$(awk \"/a|jq)/\" f)\nb=$(grep -E '(a|screen)' f)", set()),
        ('a=$(cat "a b" | jq)', {"jq"}),
        ('a="$(cat a | jq)"', {"jq"}),
        ("if ! screen -ls; then xterm -e roscore & fi", {"screen", "xterm"}),
        ("echo 'tmux attach; jq .'\n# tmux attach\nprintf \"a; tmux b\"", set()),
        ("tmux() { true; }\ntmux new", set()),
        ("session=tmux\nrun-tmux a\n./tmux b", set()),
    ],
)
def test_what_it_calls(tree: Tree, script: str, asked: set[str]) -> None:
    decision = decided(tree, script)
    assert decision.command == ("bash", "run.sh")
    assert {*decision.apt_guessed} & PROGRAMS == asked


def test_what_another_script_calls_is_not_needed(tree: Tree) -> None:
    page = f"{PAGE}## Evaluation\n```\n./tools/plot.sh\n```\n"
    decision = decided(tree, "roscore", **{"README.md": page, "tools/plot.sh": "#!/bin/bash\ntmux new\nyq r a.yml\n"})
    assert not {*decision.apt_guessed} & PROGRAMS
    assert not any("yq" in each.message for each in decision.warnings)


def test_what_no_package_brings_is_told(tree: Tree) -> None:
    told = [each for each in decided(tree, "roscore &\na=$(yq r a.yml b)\nyq v a.yml").warnings if "yq" in each.message]
    assert [(each.file, each.line) for each in told] == [("run.sh", 3)]
    assert "bring it from https://github.com/mikefarah/yq/releases" in told[0].message


@pytest.mark.parametrize(
    ("script", "ros", "added", "told"),
    [
        ("python main.py", "Noetic", True, False),
        ("exec python main.py", "Noetic", True, False),
        ("python3 main.py", "Noetic", False, False),
        ("source venv/bin/activate\npython main.py", "Noetic", False, False),
        ("echo python main.py", "Noetic", False, False),
        ("python main.py", "Melodic", False, True),
        ("python3 main.py", "Melodic", False, False),
    ],
)
def test_python_by_that_name(tree: Tree, script: str, ros: str, added: bool, told: bool) -> None:
    more = {"README.md": PAGE.replace("Noetic", ros), "requirements.txt": "numpy\n", "main.py": "import numpy\n"}
    decision = decided(tree, script, **more)
    assert decision.command == ("bash", "run.sh")
    assert ("python-is-python3" in decision.apt_guessed) == added
    assert any("calls `python`, which is Python 2" in each.message for each in decision.warnings) == told


def test_python_of_a_virtual_environment_needs_no_name(tree: Tree) -> None:
    files = {"README.md": "## Usage\n```\n./run.sh\n```\n", "run.sh": "#!/bin/bash\npython main.py\n"}
    decision = tree({**files, "requirements.txt": "numpy\n", "main.py": "import numpy\n"})
    assert decision.kind == "python"
    assert "python-is-python3" not in decision.apt_guessed
