"""Names that a release dropped: the message of a program that misses one, and code that uses one, tell one bound."""

from __future__ import annotations

import re

from roslab.knowledge.table import rows


def test_a_message_and_code_that_tell_of_a_name_have_the_same_bound() -> None:
    compared = [
        (dropped["limit"], removed["bound"], name)
        for dropped in rows("dropped_names")
        for removed in rows("removals")
        for name in removed["hints"].split("|")
        if removed["package"].lower() == re.split("[<>=]", dropped["limit"])[0] != name
        and re.search(rf"(?<!\w){re.escape(name)}(?!\w)", dropped["pattern"])
    ]
    assert len(compared) > 8
    assert [each for each in compared if each[0] != each[1]] == []
