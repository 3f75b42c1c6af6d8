"""Lists that another one includes by a path which the tree does not have."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
TOP = "# All\nscipy\n-r parts/eyes/requirements.txt\n"


def test_the_one_list_further_down_is_taken(tree: Tree) -> None:
    found = tree({"run.py": "import yaml\n", "requirements.txt": TOP, "parts/eyes/eyes/requirements.txt": "tqdm>=4\n"})
    assert {"scipy", "tqdm>=4"} <= {each.written for each in found.python.pip}
    assert not found.python.pip_tried
    assert "requirements.txt" not in found.python.requirements  # pip would refuse it
    (told,) = (each for each in found.warnings if "is included" in each.message)
    assert (told.file, told.line) == ("requirements.txt", 3)
    assert "parts/eyes/eyes/requirements.txt is taken for it" in told.message


@pytest.mark.parametrize(
    "others",
    [
        {"parts/eyes/a/requirements.txt": "tqdm\n", "parts/eyes/b/requirements.txt": "tqdm\n"},
        {"parts/eyes/third_party/lab/requirements.txt": "tqdm\n"},
        {"parts/ears/requirements.txt": "tqdm\n"},
        {"parts/eyes/eyes/requirements-dev.txt": "tqdm\n"},
        {},
    ],
)
def test_where_none_or_several_may_be_meant_it_is_told(tree: Tree, others: dict[str, str]) -> None:
    found = tree({"run.py": "import yaml\n", "requirements.txt": TOP, **others})
    assert "tqdm" not in {each.written for each in found.python.pip}
    (told,) = (each for each in found.warnings if "is included" in each.message)
    assert (told.file, told.line) == ("requirements.txt", 3)
    assert "what it names is not installed" in told.message


def test_of_a_missing_list_at_the_root_no_other_is_taken(tree: Tree) -> None:
    found = tree({"run.py": "import yaml\n", "requirements.txt": "-r base.txt\nscipy\n", "lab/base.txt": "tqdm\n"})
    (told,) = (each for each in found.warnings if "is included" in each.message)
    assert (told.line, "base.txt is included" in told.message) == (1, True)
    assert "tqdm" not in {each.written for each in found.python.pip}


def test_the_line_of_a_list_that_is_included_itself_is_told(tree: Tree) -> None:
    lists = {"requirements.txt": "-r more/list.txt\n", "more/list.txt": "scipy\n\n-r lost/list.txt\n"}
    (told,) = (each for each in tree({"run.py": "import yaml\n", **lists}).warnings if "is included" in each.message)
    assert (told.file, told.line) == ("more/list.txt", 3)
