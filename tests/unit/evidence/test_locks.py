"""A lock is read the same whether its lists are written as its tool writes them or in any other way of TOML."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.python import locks
from roslab.repository.checkout import Repository

UV = """version = 1

[[package]]
name = "first"
version = "1.2"
source = { registry = "https://index.example" }
dependencies = [
    { name = "second" },
    { name = "Third.One", extra = ["all"], marker = "python_full_version < '3.13'" },
]
sdist = { url = "https://files.example/first-1.2.tar.gz", hash = "sha256:00", size = 1 }
wheels = [
    { url = "https://files.example/a/first-1.2-cp310-cp310-manylinux_2_17_x86_64.whl", hash = "sha256:00", size = 1 },
    { url = "https://files.example/b/first-1.2-cp311-cp311-manylinux_2_17_x86_64.whl", hash = "sha256:01", size = 2 },
]

[[package]]
name = "second"
version = "3"
source = { registry = "https://index.example" }
"""
POETRY = """[[package]]
name = "first"
version = "1.2"
files = [
    {file = "first-1.2-py3-none-any.whl", hash = "sha256:00"},
    {file = "first-1.2.tar.gz", hash = "sha256:01"},
]

[package.dependencies]
Second = ">=2"
"""
PDM = """[[package]]
name = "first"
version = "1.2"
dependencies = [
    "second>=2",
    "third; python_version < '3.8'",
]
files = [
    {file = "first-1.2-py3-none-any.whl", hash = "sha256:00"},
]
"""


@pytest.mark.parametrize(("name", "text"), [("uv.lock", UV), ("poetry.lock", POETRY), ("pdm.lock", PDM)])
def test_another_spelling_of_a_list_gives_the_same(tmp_path: Path, name: str, text: str) -> None:
    (tmp_path / name).write_text(text)
    usual = locks.read(Repository.open(tmp_path))
    assert [each.requirement.written for each in usual][:1] == ["first==1.2"]
    assert all(wheel.startswith("first-1.2-") and wheel.endswith(".whl") for wheel in usual[0].wheels)
    assert usual[0].wheels
    assert usual[0].needs[0] == "second"
    for other in (
        text.replace("= [\n", "= [ # a list\n"),
        text.replace(",\n]", "\n]"),
        text.replace("[\n    ", "[  \n    "),
        text.replace(" = ", "=").replace("registry=", "registry = "),
    ):
        assert other != text
        (tmp_path / name).write_text(other)
        assert locks.read(Repository.open(tmp_path)) == usual


def test_a_lock_that_is_no_toml_tells_nothing(tmp_path: Path) -> None:
    (tmp_path / "uv.lock").write_text(UV.replace("version = 1", "version ="))
    assert locks.read(Repository.open(tmp_path)) == ()


def test_a_quotation_mark_in_an_address_ends_no_text(tmp_path: Path) -> None:
    (tmp_path / "uv.lock").write_text(UV.replace("example/a/", "example/it's/").replace("first-1.2-cp311", "1'2-cp311"))
    [first, _] = locks.read(Repository.open(tmp_path))
    assert [wheel[:5] for wheel in first.wheels] == ["first", "1'2-c"]
