"""Commands as pages write them: served pages, remarks behind a continuation, the author's own Python."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


def page(*lines: str) -> str:
    return "\n".join(("# Demo", "## Usage", "```bash", *lines, "```", ""))


@pytest.mark.parametrize(
    ("line", "command", "ports"),
    [
        ("streamlit run app.py", ("streamlit", "run", "app.py"), ("8501",)),
        ("poetry run streamlit run app.py -- --small", ("streamlit", "run", "app.py", "--", "--small"), ("8501",)),
        ("streamlit run https://example.org/app.py", ("bash",), ()),
        ("streamlit run other.py", ("bash",), ()),
    ],
    ids=["file", "manager", "address", "missing"],
)
def test_a_page_that_streamlit_serves_is_a_program(
    tree: Tree, line: str, command: tuple[str, ...], ports: tuple[str, ...]
) -> None:
    files = {"requirements.txt": "streamlit\n", "app.py": "import streamlit\n", "two.py": "import streamlit\n"}
    decision = tree({**files, "README.md": page(line)})
    assert (decision.command, decision.ports) == (command, ports)


def test_a_remark_behind_a_continuation_does_not_end_the_command(tree: Tree) -> None:
    files = {"requirements.txt": "numpy\n", "train.py": "import numpy\n", "cfg/a.yaml": "a: 1\n"}
    readme = page("python train.py first \\  # name of the run", "    --conf cfg/a.yaml")
    assert tree({**files, "README.md": readme}).command == ("python", "train.py", "first", "--conf", "cfg/a.yaml")


def test_a_note_in_wide_brackets_is_no_argument(tree: Tree) -> None:
    files = {"requirements.txt": "numpy\n", "train.py": "import numpy\n"}
    readme = page("python train.py \uff08\u8bad\u7ec3\uff09")
    assert tree({**files, "README.md": readme}).command == ("python", "train.py")


def test_a_python_that_is_given_privileges_is_the_authors(tree: Tree) -> None:
    build = "cmake_minimum_required(VERSION 3.10)\nproject(demo)\nadd_executable(run run.cpp)\n"
    files = {"CMakeLists.txt": build, "run.cpp": "int main() {}\n"}
    readme = page("./run") + "\nTake them back by:\n```\nsudo setcap -r /usr/bin/python3.6\n```\n"
    assert tree({**files, "README.md": readme}).python.version is None


@pytest.mark.parametrize(
    ("name", "command"),
    [("flow_demo.sh", ("bash", "scripts/flow_demo.sh")), ("flow_evaluate.sh", ("bash",))],
)
def test_a_script_that_is_named_as_a_demonstration_is_meant(tree: Tree, name: str, command: tuple[str, ...]) -> None:
    files = {"requirements.txt": "numpy\n", "flow.py": "import numpy\n", f"scripts/{name}": "python flow.py --fast\n"}
    readme = f"# Flow\n## Demo\nPlease refer to [scripts/{name}](scripts/{name}) for its use.\n"
    assert tree({**files, "README.md": readme}).command == command


@pytest.mark.parametrize("choice", ["[indoor|outdoor]", "{indoor|outdoor}", "<indoor|outdoor>"])
def test_of_names_to_choose_from_in_a_word_the_first_is_taken(tree: Tree, choice: str) -> None:
    files = {"requirements.txt": "numpy\n", "sfm/run_indoor.py": "import numpy\n", "sfm/run_outdoor.py": ""}
    readme = page(f"python -m sfm.run_{choice}  # choose one")
    assert tree({**files, "README.md": readme}).command == ("python", "-m", "sfm.run_indoor")


def test_a_pipe_is_no_choice(tree: Tree) -> None:
    files = {"requirements.txt": "numpy\n", "talk.py": "import numpy\n"}
    assert tree({**files, "README.md": page("python talk.py|tee log")}).command[:2] == ("python", "talk.py")
