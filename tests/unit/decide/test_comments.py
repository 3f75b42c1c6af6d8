"""What a page comments out is not read."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.evidence.prose.comments import without_comments

MAIN = "if __name__ == '__main__':\n    print(1)\n"
Tree = Callable[[dict[str, str]], Decision]


@pytest.mark.parametrize(
    ("page", "said"),
    [
        ("a <!-- b --> c <!---->d", "a  c d"),
        ("a\n<!--- b\n```\nc\n```\n-->\nd", "a\n\n\n\n\n\nd"),
        ("a <!-- b", "a <!-- b"),
        ("`<!--` a <!-- b --> `-->`", "`<!--` a  `-->`"),
        ("```xml\n<!-- a\n```\nb <!-- c -->\n", "```xml\n<!-- a\n```\nb \n"),
        ("a ```b``` <!-- c -->", "a ```b``` "),
    ],
)
def test_a_comment_is_left_out_and_lines_keep_their_numbers(page: str, said: str) -> None:
    assert without_comments(page) == said


def test_a_page_without_a_comment_is_the_same_text() -> None:
    page = "# Demo\n" * 10
    assert without_comments(page) is page


def test_what_a_page_comments_out_is_neither_installed_nor_run(tree: Tree) -> None:
    page = "# Demo\n<!-- TODO: again\n## Install\n```\nsudo add-apt-repository ppa:them/odd\n"
    page += "sudo apt install libodd-dev\npython3 old.py\n```\n-->\n"
    page += "```\nsudo apt install libxml2-dev\npython3 new.py\n```\n"
    found = tree({"README.md": page, "old.py": MAIN, "new.py": MAIN})
    named = {reason.answer for reason in found.reasons if "an install line names" in reason.reason}
    assert named == {"libxml2-dev"}
    assert found.command == ("python3", "new.py")
    assert not [warning for warning in found.warnings if "ppa:" in warning.message]
