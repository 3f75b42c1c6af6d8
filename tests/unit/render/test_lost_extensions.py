"""A project whose extension lacks a library: pip tries it, and installs what it requires where it stops."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.plan.plan import Plan
from roslab.render.dockerfile import dockerfile

Made = Callable[..., Plan]


@pytest.mark.parametrize(
    ("folder", "lines", "end"),
    [
        (".", ("numpy",), "extension of the repository; what that requires is installed alone' \\\n"),
        ("bind", ("numpy",), "extension of bind; what that requires is installed alone' \\\n"),
        ("bind", (), "extension of bind' \\\n"),
    ],
)
def test_what_it_requires_is_installed_where_pip_stops(
    plan: Made, folder: str, lines: tuple[str, ...], end: str
) -> None:
    text = dockerfile(plan(python_projects=(folder, "other"), lost_extensions=((folder, lines),)))
    path = "." if folder == "." else f"./{folder}"
    own = text[text.index("# The repository's own Python packages") :]
    assert " --editable ./other \\\n && { python3 -m pip install" in own
    assert f" --editable {path} \\\n      || " in own
    assert f"echo 'roslab: left out: pip cannot compile the {end}" in own
    assert (" numpy \\\n      && printf" in own) == bool(lines)
    below = "" if folder == "." else f"/{folder}"
    assert f'"${{PWD}}"{below} "${{PWD}}"{below}/src >' in own
    assert f"/roslab{below.replace('/', '-')}.pth; }}; }}\n" in own


def test_a_project_that_lacks_nothing_must_install(plan: Made) -> None:
    text = dockerfile(plan(python_projects=(".", "other")))
    assert "pip cannot compile the extension" not in text
    assert " --editable . --editable ./other\n" in text
