"""A module that only tests itself is no program; one with the markers of a merge is told."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MAIN = 'if __name__ == "__main__":\n'
CAREFUL = """    import doctest
    try:
        np.set_printoptions(precision=5)
    except TypeError:
        pass
    # all of them
    doctest.testmod()
"""


@pytest.mark.parametrize(
    ("guard", "program"),
    [
        (f"{MAIN}    import doctest\n    doctest.testmod()\n", False),
        (f"{MAIN}{CAREFUL}", False),
        (f"{MAIN}    unittest.main(verbosity=2)\n", False),
        (f"{MAIN}    sys.exit(doctest.testmod()[0])\n", False),
        (f"{MAIN}    doctest.testmod()\n    main()\n", True),
        (f"{MAIN}    main()\n", True),
        ('if __name__ == "__main__": main()\n', True),
    ],
)
def test_a_guard_that_only_runs_its_own_tests(tree: Tree, guard: str, *, program: bool) -> None:
    decision = tree({"rotations.py": f"import numpy as np\n\n{guard}", "train.py": "import rotations\n"})
    assert (decision.command == ("python3", "rotations.py")) is program


def test_such_a_module_is_started_where_the_page_says_so(tree: Tree) -> None:
    page = "# Demo\n## Run\n```\npython rotations.py\n```\n"
    files = {"rotations.py": f"import numpy\n\n{MAIN}    unittest.main()\n", "README.md": page}
    assert tree(files).command == ("python", "rotations.py")


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("import numpy\nx = [\n<<<<<<< HEAD\n    1]\n=======\n    2]\n>>>>>>> 1340608\n", [3]),
        ("<<<<<<< HEAD\n=======\nimport numpy\n>>>>>>> main\n", [1]),
        ('import numpy\nTEXT = """\n=======\nTitle\n"""\n', []),
        ("import numpy\nMARK = '<<<<<<< HEAD'\n", []),
    ],
)
def test_the_markers_of_a_merge_are_told(tree: Tree, text: str, told: list[int]) -> None:
    warnings = tree({"train.py": text}).warnings
    assert [w.line for w in warnings if "merge" in w.message] == told
