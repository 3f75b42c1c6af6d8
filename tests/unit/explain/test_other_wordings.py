"""What clang, nvcc, lld and mold say otherwise than gcc and GNU ld do, and what newer compilers refuse."""

from __future__ import annotations

import io

import pytest

from failed_builds import log
from roslab.explain.answer import explain


@pytest.mark.parametrize(
    ("said", "cause", "name"),
    [
        ("ld.lld: error: undefined symbol: arm::start(int)", "link-undefined", ("symbol", "arm::start(int)")),
        ("mold: error: undefined symbol: arm::start(int)", "link-undefined", ("symbol", "arm::start(int)")),
        ("ld.lld: error: unable to find library -lglog", "link-library", ("library", "glog")),
        ("mold: fatal: library not found: glog", "link-library", ("library", "glog")),
        ("ld.lld: error: duplicate symbol: arm_speed", "defined-twice", ("symbol", "arm_speed")),
        (
            "a.cpp:3:9: error: use of undeclared identifier 'CV_LOAD_IMAGE_COLOR'; did you mean 'IMREAD_COLOR'?",
            "api-known",
            ("setting", "env.CXXFLAGS"),
        ),
        (
            "a.cpp:3:9: error: no template named 'shared_ptr' in namespace 'std'",
            "api-known",
            ("setting", "env.CXXFLAGS"),
        ),
        ("a.cpp:3:9: error: no member named 'speed' in 'arm::Joint'", "api-member", ("library", "arm")),
        ('a.cu(3): error: namespace "arm" has no member "speed"', "api-member", ("library", "arm")),
        ('a.cu(3): error: identifier "arm_speed" is undefined', "api-call", ("symbol", "arm_speed")),
        (
            "a.cpp:3:9: error: \u2018Speed\u2019 {aka \u2018arm::Speed\u2019} has no member named \u2018top\u2019",
            "api-member",
            ("symbol", "top"),
        ),
        (
            "/usr/include/c++/12/bits/stl_iterator.h:5:5: error: no type named 'kind' in 'struct std::traits<arm::It>'",
            "api-member",
            ("library", "arm"),
        ),
    ],
)
def test_other_compilers_and_linkers_are_understood(said: str, cause: str, name: tuple[str, str]) -> None:
    (found,) = explain(io.BytesIO(log("make", said, "make: *** [all] Error 1").encode())).explanations
    assert found.id == cause
    assert name in found.names


@pytest.mark.parametrize("kind", ["implicit-function-declaration", "int-conversion"])
def test_what_gcc_14_no_longer_takes_comes_with_flags(kind: str) -> None:
    said = f"a.c:3:9: error: implicit declaration of function 'arm_speed' [-W{kind}]"
    (found,) = explain(io.BytesIO(log("make", said).encode())).explanations
    assert ("setting", "env.CFLAGS") in found.names
    (found,) = explain(io.BytesIO(log("make", said.replace("[-W", "[-Werror=")).encode())).explanations
    assert ("setting", "env.CFLAGS") not in found.names


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("\u00e2\u20ac\u02dc", "\u00e2\u20ac\u2122"),
        ("<E2><80><98>", "<E2><80><99>"),
        (r"\342\200\230", r"\342\200\231"),
        ("M-bM-^@M-^X", "M-bM-^@M-^Y"),
        ("?", "?"),
    ],
)
def test_quotation_marks_of_another_encoding_are_read(before: str, after: str) -> None:
    said = f"/ws/src/a.cpp:15:25: error: {before}turn{after} is not a member of {before}arm::Joint{after}\n"
    log = f'#8 [3/4] RUN make\n#8 1.2 {said}#8 ERROR: process "/bin/sh -c make" did not complete: exit code: 2\n'
    (found,) = explain(io.BytesIO(log.encode())).explanations
    assert found.id == "api-member"
    assert dict(found.names)["symbol"] == "turn"
