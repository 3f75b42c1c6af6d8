"""A fault of the network, a server or the machine says nothing of the source."""

from __future__ import annotations

import io

import pytest

from roslab.explain.answer import explain
from roslab.github.blame import by_machine

LOG = """\
#8 [3/4] RUN {command}
#8 1.0 {line}
#8 ERROR: process "/bin/sh -c {command}" did not complete successfully: exit code: 1
"""


@pytest.mark.parametrize(
    ("command", "line", "expected"),
    [
        ("curl https://example.org/a", "curl: (7) Failed to connect to example.org port 443: Connection refused", True),
        ("make", "/bin/sh: 1: cannot create /tmp/a: No space left on device", True),
        ("apt-get install -y gone", "E: Unable to locate package gone", False),
        ("make", "main.cpp:3:10: fatal error: gone.h: No such file or directory", False),
        ("./mine", "something that nobody knows", False),
    ],
)
def test_what_failed_is_judged_by_its_cause(command: str, line: str, expected: bool) -> None:
    answer = explain(io.BytesIO(LOG.format(command=command, line=line).encode()))
    assert by_machine(answer, {"GITHUB_API_URL": "http://127.0.0.1:9"}) is expected


def test_no_host_is_gone_where_no_name_is_known() -> None:
    """Names below `invalid` are never known, https://www.rfc-editor.org/rfc/rfc6761; where GitHub's is not, none is."""
    line = "curl: (6) Could not resolve host: packages.invalid"
    answer = explain(io.BytesIO(LOG.format(command="curl http://packages.invalid/a", line=line).encode()))
    assert answer.explanations[0].id == "host-unknown"
    unknown_too = {"GITHUB_API_URL": "http://api.invalid"}
    assert by_machine(answer, unknown_too)
