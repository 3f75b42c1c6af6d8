"""The folders in which a Makefile calls make."""

from __future__ import annotations

import pytest

from hanging import ends
from roslab.evidence.native.recursive_make import MOST, called

CALL = "\tfor a in $$a; do make -C $$a; done\n"


def test_a_loop_over_a_list_that_repeats_itself() -> None:
    assert called("all:\n\tfor a in x y x; do make -C $$a; done\n") == ("x", "y")


@pytest.mark.parametrize("times", [2, 40])
def test_a_variable_in_its_own_list_does_not_double(times: int) -> None:
    loops = "\tfor a in $$a $$a; do echo; done\n" * times
    with ends():
        assert called(f"all:\n\tfor a in x y; do echo; done\n{loops}{CALL}") == ("x", "y")


def test_lists_that_grow_from_each_other_end() -> None:
    """Each name has the words of the one before and some of its own."""
    first = "\tfor v0 in $$v0; do echo; done\n"
    loops = "".join(
        f"\tfor v{at} in $$v{at - 1} {' '.join(f'd{at}x{each}' for each in range(20))}; do echo; done\n"
        for at in range(1, 50)
    )
    assert len(called(f"all:\n{first}{loops}\tmake -C $$v49\n")) == MOST
