"""A list of exact releases tells the Python that it was written on, where nothing names one."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
LAST = "numpy==1.24.4\nscipy==1.10.1\npandas==2.0.3\n"


@pytest.mark.parametrize(
    ("lines", "page", "python"),
    [
        (LAST, "", "3.8"),
        (LAST, "python=3.10", "3.10"),  # a page names one
        (LAST.replace("==", ">="), "", "3.10"),
        (LAST.replace("pandas==2.0.3", "pandas==2.0.2"), "", "3.10"),  # two are chance
        (f"{LAST}torch==2.9.0\n", "", "3.10"),  # never was for it
        ("numpy==2.0.2\nscipy==1.13.1\nmatplotlib==3.9.4\n", "", "3.9"),
        ("numpy==1.24.4\nopencv-python==4.12.0.88\n", "", "3.10"),  # one last release shows nothing
    ],
)
def test_where_nothing_names_the_python(tree: Tree, lines: str, page: str, python: str) -> None:
    readme = f"# Net\n```\nconda create -n net {page}\npip install -r requirements.txt\n```\n"
    found = tree({"requirements.txt": lines, "README.md": readme, "main.py": "import numpy\n"})
    assert (found.python.version or "3.10") == python


def test_the_reason_names_them(tree: Tree) -> None:
    found = tree({"requirements.txt": f"{LAST}matplotlib==3.7.5\nh5py==3.11.0\n", "main.py": "import numpy\n"})
    said = [reason.reason for reason in found.reasons if reason.question == "python"]
    named = "numpy==1.24.4, scipy==1.10.1, pandas==2.0.3, matplotlib==3.7.5 and 1 more are each the last release for it"
    assert named in said
    assert "fits every pin below" in said


@pytest.mark.parametrize(
    ("pins", "python"),
    [
        (("pytest==5.3.5", "numpy==1.24.2"), "3.8"),
        (("pytest==6.2.4", "numpy==1.26.0"), "3.9"),
        (("pytest==6.2.5", "numpy==1.24.2"), "3.10"),
        (("pytest>=5", "numpy==1.24.2"), "3.10"),
        (("pytest==5.3.5", "numpy==2.1.0"), "3.10"),  # which is for no older one
        (("pytest==5.3.5",), "3.8"),
    ],
)
def test_an_old_pytest_asks_for_an_old_python(tree: Tree, pins: tuple[str, ...], python: str) -> None:
    files = {"requirements.txt": "\n".join(pins), "main.py": "print(1)\n"}
    assert tree(files).python.version == python
