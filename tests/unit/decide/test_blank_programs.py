"""A program that a page names with a blank is the file of the tree that fits, by the values that the page names."""

from __future__ import annotations

import time
from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "arm_test.py": "import numpy\n",
    "pendulum_test_data.py": "import numpy\n",
    "pendulum_show.py": "import numpy\n",
    "arm_show.py": "import numpy\n",
}


@pytest.mark.parametrize(
    ("page", "command"),
    [
        (
            'Choose the system ("pendulum", "arm"):\n```\npython3 <system>_show.py\n```\n',
            ("python3", "pendulum_show.py"),
        ),
        ("```\npython3 ./<system>_show.py --fast\n```\n", ("python3", "arm_show.py", "--fast")),
        ('("pendulum") ("show")\n```\npython3 <system>_<what>.py\n```\n', ("python3", "pendulum_show.py")),
    ],
)
def test_a_blank_is_filled_by_a_file(tree: Tree, page: str, command: tuple[str, ...]) -> None:
    assert tree({**FILES, "README.md": f"# Demo\n{page}"}).command == command


@pytest.mark.parametrize("said", ["<script>.py", "<system>_<what>.py", "<system>_fly.py"])
def test_a_blank_that_says_nothing_stays_one(tree: Tree, said: str) -> None:
    found = tree({**FILES, "README.md": f"# Demo\n```\npython3 {said}\n```\n"})
    assert found.command == ("bash",)


def test_one_blank_has_one_value(tree: Tree) -> None:
    files = {"run/a_fly_b.py": "import numpy\n", "run/a_fly_a.py": "import numpy\n"}
    found = tree({**files, "README.md": "# Demo\n```\npython3 run/<x>_fly_<x>.py\n```\n"})
    assert found.command == ("python3", "run/a_fly_a.py")


def test_many_blanks_take_no_time(tree: Tree) -> None:
    files = {f"run/{'a_' * 40}{number}.py": "import numpy\n" for number in range(30)}
    said = "".join(f"python3 run/{'_'.join(f'<{each}>' for each in 'abcdefgh')}x{n}.py\n" for n in range(3))
    before = time.process_time()
    assert tree({**files, "README.md": f"# Demo\n```\n{said}```\n"}).command == ("bash",)
    assert time.process_time() - before < 5
