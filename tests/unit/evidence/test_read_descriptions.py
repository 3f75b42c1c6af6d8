"""What is read of robot descriptions whose macros call themselves."""

from __future__ import annotations

from hanging import ends
from roslab.evidence.ros.read_descriptions import always_read


def test_a_macro_that_calls_itself_with_ever_longer_values_ends() -> None:
    condition = '<xacro:if value="${y == 1}"><link/></xacro:if>'
    calls = '<xacro:a x="${[x, x]}" y="${y}"/>'
    text = f'<robot><xacro:macro name="a" params="x y">{condition}{calls}</xacro:macro><xacro:a x="1" y="2"/></robot>'
    with ends():
        read = list(always_read("a.xacro", lambda path: text if path == "a.xacro" else None, lambda _: ()))
    assert read[0][0] == "a.xacro"
    assert not any("<link/>" in part for _, part in read)
