"""A command without an option that the reader fills in, and what the program's argparse says of the option."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
SUBMIT = (
    "import argparse\nparser = argparse.ArgumentParser()\nparser.add_argument({call})\nargs = parser.parse_args()\n"
)
DEMO = SUBMIT.format(call="'--net', '-n', help='a file (of weights)', default='nets/a.pt'")
WHOLE = "python demo.py --image data/a.png"
FIRST = ("python", "submit.py")


def command(tree: Tree, call: str, page: str, demo: str = DEMO) -> object:
    files = {"submit.py": SUBMIT.format(call=call), "demo.py": demo, "data/a.png": "", "requirements.txt": "numpy\n"}
    return tree({**files, "README.md": f"# Use\n```\npython submit.py --net path/to/net\n{page}\n```\n"}).command


@pytest.mark.parametrize(
    ("call", "page"),
    [
        ("'--net', required=True", WHOLE),
        ("'--net', required=True", "python demo.py"),
        ("'--net', help='the file (of weights)'", WHOLE),
        ("'-n', '--net', type=str, default=None", WHOLE),
        ("'--net'", f"{WHOLE} --net path/to/net"),
    ],
)
def test_it_is_behind_what_the_page_starts_whole(tree: Tree, call: str, page: str) -> None:
    assert command(tree, call, page) == tuple(page.replace(" --net path/to/net", "").split())


@pytest.mark.parametrize(
    ("call", "page"),
    [
        ("'--net', default='a.pt'", WHOLE),
        ("'--net', action='append'", WHOLE),
        ("'--other', required=True", WHOLE),
        ("'--net'", "python demo.py"),  # it may go on without
        ("'--net'", "python demo.py --image gone/a.png"),
        ("'--net', required=True", "python demo.py --image gone/a.png"),
        ("'--net', required=True", "python demo.py --other path/to/other"),
        ("'--net', required=True", "python eval.py"),
    ],
)
def test_the_first_program_counts_where_it_may_start_or_no_other_is_whole(tree: Tree, call: str, page: str) -> None:
    assert command(tree, call, page) == FIRST
