"""Lines of C++ that include headers."""

from __future__ import annotations

from roslab.evidence.lex.includes import includes

CODE = """#include <a.h>
  #  include "b/c.hpp"
// #include <not.h>
int x; #include <nor.h>
#include <a.h>
"""


def test_an_include_begins_its_line() -> None:
    assert [each[1] for each in includes(CODE)] == ["a.h", "b/c.hpp", "a.h"]


def test_what_is_passed_over_meanwhile_is_no_longer_told() -> None:
    known: set[str] = set()
    found = []
    for each in includes(CODE, known):
        found.append(each[1])
        known.add(each[1])
    assert found == ["a.h", "b/c.hpp"]
