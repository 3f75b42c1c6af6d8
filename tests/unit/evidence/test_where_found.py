"""Headers under a condition that their library was found."""

from __future__ import annotations

import re
import time

import pytest

from roslab.evidence.native.where_found import where_found


@pytest.mark.parametrize(
    ("above", "expected"),
    [
        ("#if XTENSOR_FOUND\n", True),
        ("#ifdef HAVE_XTENSOR\n#if 1\n", True),
        ("#if 0\n#elif defined(USE_XTENSOR)\n", True),
        ("#if !defined( XTENSOR_FOUND )\n", False),
        ("#if ! XTENSOR_FOUND\n", False),
        ("#ifndef XTENSOR_FOUND\n", False),
        ("#ifdef XTENSOR_FOUND\n#else\n", False),
        ("#ifdef XTENSOR_FOUND\n#endif\n", False),
        ("#endif\n", False),
        ("", False),
    ],
)
def test_a_condition_asks_for_the_library(above: str, expected: bool) -> None:
    text = f"{above}#include <xtensor/xarray.hpp>\n#ifdef HAVE_OTHER\n#endif\n"
    assert where_found(text, text.index("#include"), "xtensor/xarray.hpp") is expected


def test_many_headers_and_long_conditions_take_no_time() -> None:
    text = f"#if {'! ' * 3_000}{'HAVE_A ' * 9_000}\n" + "#if HAVE_A\n#include <a.h>\n#endif\n" * 9_000
    before = time.process_time()
    assert all(where_found(text, match.start(), "a.h") for match in re.finditer("#include", text))
    assert time.process_time() - before < 2
