"""A version that a page in another language names as the oldest one that works."""

from __future__ import annotations

import pytest

from roslab.decide.python.ranges import only_lowest
from roslab.decide.ros.lower_bounds import bounds
from roslab.evidence.facts import Mention
from roslab.values.open_ended import OF_LANGUAGES
from roslab.values.pattern import pattern

HIGHER = (
    *(
        "{} 及以上版本",
        "{}以上",
        "{}\uff08或更高\uff09",
        "{} 以降",
        "{} 이상",
        "{} o superior",
        "{} ou supérieure",
        "{} oder höher",
    ),
    *("{} или выше", "{} ou superior", "{} o successiva", "{} (oder neuer)", "{} 或更新", "{}之后的版本", "{}及以后"),
)
EXACT = (
    "{}",
    "{} 以下",
    "{} を使う",
    "{} o 3.7",
    "{} und 3.7",
    "{} ou 3.8",
    "{}, später mehr",
    "{} 之后安装",
    "{} 更新源",
)


@pytest.mark.parametrize("said", [*HIGHER, "{}+", "{} or newer"])
def test_later_ones_will_do(said: str) -> None:
    text = f"- Python {said.format('3.6')}"
    assert only_lowest(Mention(topic="python", value="3.6", source="readme", text=text, file="README.md", line=1))
    text = f"Ubuntu {said.format('18.04')}"
    assert bounds(Mention(topic="ubuntu", value="18.04", source="readme", text=text, file="README.md", line=1))


@pytest.mark.parametrize("said", EXACT)
def test_that_one_is_meant(said: str) -> None:
    text = f"- Python {said.format('3.6')}"
    assert not only_lowest(Mention(topic="python", value="3.6", source="readme", text=text, file="a", line=1))
    text = f"Ubuntu {said.format('18.04')}"
    assert not bounds(Mention(topic="ubuntu", value="18.04", source="readme", text=text, file="a", line=1))


def test_no_word_takes_long() -> None:
    assert not pattern(OF_LANGUAGES).search("o " * 50_000 + "(" * 50_000)
