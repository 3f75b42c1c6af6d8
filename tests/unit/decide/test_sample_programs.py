"""What a tool wrote into a new project is no program of it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PYCHARM = """# This is a sample Python script.

# Press Shift+F10 to execute it or replace it with your code.


def print_hi(name):
    # Use a breakpoint in the code line below to debug your script.
    print(f'Hi, {name}')  # Press Ctrl+F8 to toggle the breakpoint.


# Press the green button in the gutter to run the script.
if __name__ == '__main__':
    print_hi('PyCharm')
"""
UV = 'def main():\n    print("Hello from a-project!")\n\n\nif __name__ == "__main__":\n    main()\n'
ROS2 = UV.replace('"Hello from a-project!"', "'Hi from a_package.'")
LIBRARY = {"requirements.txt": "numpy\n", "lib/__init__.py": "", "lib/planner.py": "import numpy\n"}


@pytest.mark.parametrize("text", [PYCHARM, UV, ROS2])
def test_what_a_tool_wrote_is_no_default(tree: Tree, text: str) -> None:
    assert tree({**LIBRARY, "main.py": text}).command == ("bash",)


@pytest.mark.parametrize(
    "text",
    [
        PYCHARM.replace("print_hi('PyCharm')", "print_hi('PyCharm')\n    plan(3)"),
        PYCHARM.replace("print_hi('PyCharm')", "plan(3)"),
        "import numpy\n" + UV,
        UV.replace("    main()", "    main()\n    print(1)"),
        UV.replace("Hello from a-project!", "Hello, world!"),
    ],
)
def test_what_was_made_of_it_is_one(tree: Tree, text: str) -> None:
    assert tree({**LIBRARY, "main.py": text}).command == ("python3", "main.py")


def test_what_a_page_runs_is_run(tree: Tree) -> None:
    page = "# A\n\n## Usage\n\n```sh\npython3 main.py\n```\n"
    assert tree({**LIBRARY, "main.py": UV, "README.md": page}).command == ("python3", "main.py")


def test_the_program_beside_it_is_the_default(tree: Tree) -> None:
    files = {**LIBRARY, "main.py": PYCHARM, "plan.py": "if __name__ == '__main__':\n    print(2)\n"}
    assert tree(files).command == ("python3", "plan.py")
