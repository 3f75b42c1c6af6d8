"""A program of Python that a page only names in its sentences, and one at the root without a guard."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PLAN = "import numpy\nsteps = {\n    'a': 1,\n}\nfor step in steps:\n    print(step)\n"
NEEDS = {"requirements.txt": "numpy\n"}
LIBRARY = "import numpy\ndef plan():\n    return 1\n"


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("Adjust the options in `sub/plan.py` and execute it to plan.", "python3 sub/plan.py"),
        ("Adjust the options in the\nupper part of `sub/plan.py` and then\nstart it.", "python3 sub/plan.py"),
        ("Edit `sub/plan.py` and run the script.", "python3 sub/plan.py"),
        ("You see it by executing `sub/plan.py`.", "python3 sub/plan.py"),
        ("Then call the script `plan.py`.", "python3 sub/plan.py"),
        ("`sub/plan.py` can be used to plan a lap.", "python3 sub/plan.py"),
        ("The script `sub/plan.py` can be\nused to plan a lap.", "python3 sub/plan.py"),
        ("- `sub/plan.py`\n- execute it", "bash"),
        ("Do not execute `sub/plan.py`.", "bash"),
        ("Never run `sub/plan.py`, it is old.", "bash"),
        ("Adjust the options in `sub/plan.py`.", "bash"),
        ("`sub/library.py` can be used to plan a lap.", "bash"),
        ("They call `sub/library.py`.", "bash"),
        ("`sub/convert_tracks.py` can be used to convert them.", "bash"),
        ("Execute `sub/convert_tracks.py`, then execute `sub/plan.py`.", "python sub/plan.py"),
        (
            "Edit `sub/other.py` and run it.\n\n# Running the code\nEdit `sub/plan.py` and run it.",
            "python3 sub/plan.py",
        ),
        ("`sub/plan.py` can be used to plan.\n\n# Usage\n```\npython sub/other.py\n```", "python sub/other.py"),
    ],
)
def test_a_program_that_a_sentence_has_run(tree: Tree, page: str, command: str) -> None:
    code = {f"sub/{name}.py": PLAN for name in ("plan", "other", "convert_tracks")} | {"sub/library.py": LIBRARY}
    assert " ".join(tree({**NEEDS, **code, "README.md": f"# Planner\n{page}\n"}).command) == command


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("For how to use it see [our usage example](sub/plan.py).", "python3 sub/plan.py"),
        ("See the [`minimal example`](./sub/plan.py) and\n[the same example](sub/plan.py).", "python3 sub/plan.py"),
        ("See the [demo script](sub/plan.py).", "python3 sub/plan.py"),
        ("See [an example](sub/plan.py) and [another example](sub/other.py).", "bash"),
        ("See the [example of settings](sub/plan.py).", "bash"),
        ("See the [planner](sub/plan.py).", "bash"),
        ("See [our usage example](sub/library.py).", "bash"),
        ("See [our usage example](sub/gone.py).", "bash"),
    ],
)
def test_a_program_that_a_page_links_as_its_example(tree: Tree, page: str, command: str) -> None:
    code = {f"sub/{name}.py": PLAN for name in ("plan", "other")} | {"sub/library.py": LIBRARY}
    assert " ".join(tree({**NEEDS, **code, "README.md": f"# Planner\n{page}\n"}).command) == command


@pytest.mark.parametrize(
    ("name", "code", "command"),
    [
        ("main_plan.py", PLAN, "python3 main_plan.py"),
        ("run.py", "import numpy as np\nprint(np.zeros(3))\n", "python3 run.py"),
        ("demo2.py", "import numpy\nwith open('a') as a:\n    pass\n", "python3 demo2.py"),
        ("main_plan.py", LIBRARY, "bash"),
        ("main_plan.py", "import sys\nimport numpy\nsys.path.append('a')\nA = 1\n", "bash"),
        ("main_plan.py", 'import numpy\n"""\nfor all:\nplot(a)\n"""\n', "bash"),
        ("runtime.py", PLAN, "bash"),
        ("plan.py", PLAN, "bash"),
        ("sub/main_plan.py", PLAN, "bash"),
        ("run_preprocessing.py", PLAN, "bash"),
        ("main_download.py", PLAN, "bash"),
    ],
)
def test_a_file_at_the_root_that_does_something(tree: Tree, name: str, code: str, command: str) -> None:
    found = tree({**NEEDS, name: code, "README.md": "# Planner\nIt plans.\n"})
    assert " ".join(found.command) == command


def test_what_a_page_says_of_a_program_is_none_of_the_nodes(tree: Tree) -> None:
    package = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
    files = {"package.xml": package, "CMakeLists.txt": "project(demo)\n", "launch/demo.launch": "<launch/>"}
    page = "ROS Noetic\n\n`tools/plan.py` can be used to plan.\n"
    assert tree({**files, "tools/plan.py": PLAN, "README.md": page}).command[0] == "roslaunch"


INSTALLER = "#!/bin/bash\nif [[ $2 ]]; then\n  bash $(dirname $0)/deps/install_all.sh\nfi\n"


@pytest.mark.parametrize(
    ("call", "script", "runs"),
    [
        ("all.sh", f"{INSTALLER}cmake --install build\n", False),
        ("all.sh", "cmake -B build\nsudo make -j4 install\n", False),
        ("all.sh --with-deps", INSTALLER, False),
        ("all.sh --fast", f"{INSTALLER}bash ${{DIR}}/cpp/setup.sh\npip install .\n", False),
        ("all.sh --with-deps", f"{INSTALLER}python plan.py\n", True),
        ("all.sh --fast", "bash steps/first.sh\n", True),
        ("all.sh --fast", f"{INSTALLER}bash steps/first.sh\npip install .\n", True),
        ("all.sh --fast -d ${PLAN_ws}", "bash steps/first.sh\n", False),
    ],
)
def test_a_script_that_installs_or_lacks_a_variable_is_no_command(
    tree: Tree, call: str, script: str, *, runs: bool
) -> None:
    page = f"# Usage\n```\nbash {call}\n```\n"
    found = tree({**NEEDS, "plan.py": LIBRARY, "all.sh": script, "README.md": page})
    assert any("all.sh" in argv for argv in found.command_candidates) is runs
