"""Why a command of a page is one of the repository's."""

from __future__ import annotations

import pytest

from roslab.decide.run_by_page import why_run
from roslab.evidence.facts import Mention

NEARLY = "README.md runs one of almost this name, which nothing compiles"


@pytest.mark.parametrize(
    ("argv", "said", "why"),
    [
        (("demo", "-a"), "./demo -a", "the README runs it"),
        (("demo",), "./demos", "the README runs it"),
        (("demo2",), "./demo", NEARLY.replace("README.md", "the README")),
        (("bash", "tools/run.sh", "-d"), "tools/run.sh -d", "the README runs it"),
    ],
)
def test_a_script_is_called_by_its_own_name(argv: tuple[str, ...], said: str, why: str) -> None:
    mention = Mention(topic="command", value=said, source="readme", file="README.md", line=1, text=said)
    assert why_run(argv, mention, "cpp") == why
