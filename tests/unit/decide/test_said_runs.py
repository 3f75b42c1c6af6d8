"""A script that a sentence says is to be run, without a command, and the folder that it starts in."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PLAN = "import numpy\nif __name__ == '__main__':\n    main()\n"
FILES = {"requirements.txt": "numpy\n", "test/test_plan.py": PLAN, "demo/plan.py": PLAN, "demo/settings.py": "A = 1\n"}


@pytest.mark.parametrize(
    ("sentence", "file"),
    [
        ("The script you need run is `./test/test_plan.py`. It takes long.", "test/test_plan.py"),
        ("The main file to start is `demo/plan.py`.", "demo/plan.py"),
        ("Script to execute: `demo/plan.py`", "demo/plan.py"),
        ("Experiments are run using `demo/plan.py`.", "demo/plan.py"),
        ("`demo/plan.py` is the entry point that you have to run.", "demo/plan.py"),
        ("`demo/plan.py` is the script to run.", "demo/plan.py"),
        ("The script that is run by the server is `demo/plan.py`.", None),
        ("The script to run all tests is `test/test_plan.py`.", None),
        ("The file to run is `demo/gone.py`.", None),
        ("The script you should not run is `demo/plan.py`.", None),
        ("The old script is no longer run: `demo/plan.py`", None),
        ("Running it reads `demo/settings.py`.", None),
    ],
)
def test_a_sentence_runs_it(tree: Tree, sentence: str, file: str | None) -> None:
    decision = tree({**FILES, "README.md": f"# Demo\n\n## Plans\n\n{sentence}\n"})
    said = [each for each in decision.reasons if each.question == "command" and "README" in each.reason]
    assert [each.answer for each in said if not each.decisive] == ([f"python {file}"] if file else [])


@pytest.mark.parametrize(
    ("title", "text", "runs"),
    [
        ("How to run", "It is all in one script, `./demo/plan.py`.", True),
        ("Usage", "- `demo/plan.py`", True),
        ("Usage", "Please refer to `demo/plan.py`", True),
        ("Usage", "Please refer to `demo/plan.py` and `demo/settings.py`", False),
        ("Usage", "First edit `demo/plan.py`", False),
        ("Usage", "The size is defined in `demo/plan.py`", False),
        ("Usage", "`demo/plan.py`\n\n```\nmake\n```", False),
        ("Structure", "- `demo/plan.py`", False),
        ("Running order", "| Nr | Plan |\n|---|---|\n| 1 | Extract the boot to `demo/plan.py` |", False),
        ("Running order", "| Script | Takes |\n|---|---|\n| `demo/plan.py` | a map |", True),
        ("Running the tests", "- `test/test_plan.py`", False),
    ],
)
def test_a_section_names_it_alone(tree: Tree, title: str, text: str, runs: bool) -> None:
    decision = tree({**FILES, "README.md": f"# Demo\n\n## {title}\n\n{text}\n"})
    said = [each.answer for each in decision.reasons if each.question == "command" and "README" in each.reason]
    assert ("python demo/plan.py" in said) is runs
    assert runs or not any("test_plan" in each for each in said)


@pytest.mark.parametrize(
    ("opens", "settings", "command"),
    [
        ("conf/a.yaml", ("test/conf/a.yaml",), "cd test && exec python test_plan.py"),
        ("conf/a.yaml", ("test/conf/a.yaml", "conf/a.yaml"), ("python", "test/test_plan.py")),
        ("conf/a.yaml", ("conf/a.yaml",), ("python", "test/test_plan.py")),
    ],
)
def test_it_starts_where_what_it_opens_is(tree: Tree, opens: str, settings: tuple[str, ...], command: object) -> None:
    script = f"from planner.core import Planner\nimport sys\nsys.path.append('..')\nopen('{opens}')\n{PLAN}"
    files = {
        "planner/core.py": "class Planner:\n    pass\n",
        "test/test_plan.py": script,
        "requirements.txt": "numpy\n",
    }
    page = "# Demo\n\n## How to run\n\nThe script you need to run is `./test/test_plan.py`.\n"
    decision = tree({**files, **dict.fromkeys(settings, "a: 1\n"), "README.md": page})
    assert decision.command == command
    assert decision.python_path == (".",)


def test_a_path_that_is_added_before_the_import_is_enough(tree: Tree) -> None:
    script = f"import sys\nsys.path.append('..')\nfrom planner.core import Planner\n{PLAN}"
    files = {"planner/core.py": "", "test/test_plan.py": script, "requirements.txt": "numpy\n"}
    page = "# Demo\n\nThe script you need to run is `./test/test_plan.py`.\n"
    assert tree({**files, "README.md": page}).python_path == ()


def test_what_the_script_has_from_the_root_comes_before_what_lies_beside_it(tree: Tree) -> None:
    script = f"open('conf/a.yaml')\n{PLAN}"
    files = {"test/test_plan.py": script, "test/other.py": "open('../conf/b.yaml')\n", "conf/a.yaml": "a: 1\n"}
    page = "# Demo\n\nThe script you need to run is `./test/test_plan.py`.\n"
    decision = tree({**files, "requirements.txt": "numpy\n", "README.md": page})
    assert decision.command == ("python", "test/test_plan.py")


IN_BIN = "project(a)\nset(EXECUTABLE_OUTPUT_PATH ${PROJECT_SOURCE_DIR}/bin)\n"
TWO = f"{IN_BIN}add_executable(go a.cpp)\nadd_executable(see a.cpp)\n"
COMPILED = {"CMakeLists.txt": TWO, "a.cpp": "int main() {}\n"}


@pytest.mark.parametrize(
    ("text", "command"),
    [
        ("Run `./bin/go`", ("go",)),
        ("To see it, execute the program `bin/see --fast`.", ("see", "--fast")),
        ("Run `./bin/other`", ("bash",)),
        ("Do not run `./bin/go`", ("bash",)),
        ("Run `./bin/go` for the unit tests", ("bash",)),
        ("Run `./bin/go` to begin.", ("go",)),
        ("The map is in `./bin/go`", ("bash",)),
        ("```\n./bin/go --all\n```\n\nThen run `./bin/go`", ("go", "--all")),
        ("You can begin by running `./bin/go`. A window opens.", ("go",)),
        ("Call `./bin/go --all` for it", ("go", "--all")),
        ("Then type: `./bin/go`", ("go",)),
        ("After this it can be started with `./bin/go`.", ("go",)),
        ("It is executed by calling `./bin/go`.", ("go",)),
        ("`./bin/go` starts the viewer.", ("go",)),
        ("`./bin/go` lists the files.", ("bash",)),
        ("The map is opened while running `./bin/other`, see `./bin/go`.", ("bash",)),
    ],
)
def test_a_sentence_runs_what_is_compiled_by_its_path(tree: Tree, text: str, command: tuple[str, ...]) -> None:
    assert tree({**COMPILED, "README.md": f"# Demo\n\n## Use\n\n{text}\n"}).command == command


@pytest.mark.parametrize(
    ("sentence", "runs"),
    [
        ("- execute run.sh", True),
        ("Then run the script `./run.sh`.", True),
        ("1. Install it. Then execute: run.sh", True),
        ("- do not run run.sh", False),
        ("- execute install_all.sh", False),
        ("- execute gone.sh", False),
        ("- execute run.sh only for the tests", False),
        ("- see how tools start run.sh", False),
        ("- execute run.sh\n\n```bash\npython demo/plan.py\n```", False),
    ],
)
def test_a_sentence_runs_a_script_of_the_shell(tree: Tree, sentence: str, runs: bool) -> None:
    """All that the script runs is meant, and not its first program."""
    script = "python demo/plan.py\npython demo/next.py\n"
    scripts = {"run.sh": script, "install_all.sh": script, "demo/next.py": PLAN}
    decision = tree({**FILES, **scripts, "README.md": f"# Demo\n\n{sentence}\n"})
    said = [each for each in decision.reasons if each.question == "command" and "README runs it" in each.reason]
    assert ("bash run.sh" in [each.answer for each in said]) is runs


@pytest.mark.parametrize(
    ("sentence", "command"),
    [
        ("- `demo/all.sh` provides an example how to run the simulation", "cd demo && exec bash all.sh"),
        ("`demo/plan.py` is an example of how to start it.", "python demo/plan.py"),
        ("`demo/plan.py` shows how to run the planner.", "python demo/plan.py"),
        ("`demo/all.sh` provides an example how to run the unit tests", ""),
        ("`demo/plan.py` no longer shows how to run the planner.", ""),
        ("`demo/plan.py` shows how the planner is made.", ""),
        ("`demo/plan.py` shows how to install the planner.", ""),
    ],
)
def test_an_example_of_how_to_run_it_is_run(tree: Tree, sentence: str, command: str) -> None:
    names = {"demo/all.sh": "python3 next.py --fast\n", "demo/next.py": PLAN, "demo/second.py": PLAN}
    found = tree({**FILES, **names, "README.md": f"# Demo\n\n## About\n\n{sentence}\n"})
    said = [each for each in found.reasons if each.question == "command" and "README runs it" in each.reason]
    assert bool(said) is bool(command)
    if command:
        assert (found.command if isinstance(found.command, str) else " ".join(found.command)) == command
