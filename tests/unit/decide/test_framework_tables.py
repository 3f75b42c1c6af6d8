"""The tables of the Python side: every row complete, sourced and dated."""

from __future__ import annotations

import re

import pytest
from packaging.utils import canonicalize_name
from packaging.version import Version

from roslab.knowledge import frameworks
from roslab.knowledge.arm64 import arm64_wheels
from roslab.knowledge.distros import python_of_ubuntu
from roslab.knowledge.table import rows

TABLES = (
    "amd64_only", "arm64_since", "arm64_wheels", "build_needs", "conda_limits", "cuda_images", "framework_names",
    "frameworks", "imports", "old_setuptools", "wheels", "with_numpy_2",
)  # fmt: skip
NAME = re.compile(r"^[a-z0-9][a-z0-9+.-]+$")


@pytest.mark.parametrize("table", TABLES)
def test_every_row_has_its_source_and_date(table: str) -> None:
    for row in rows(table):
        assert row["source"].startswith(("https://", "http://", "PyPI: ")), row
        assert re.fullmatch(r"\d{4}-\d\d-\d\d", row["date"]), row


@pytest.mark.parametrize(
    ("table", "key"), [("wheels", "pip"), ("imports", "module"), ("cuda_images", "cuda"), ("arm64_wheels", "pip")]
)
def test_no_key_stands_twice(table: str, key: str) -> None:
    keys = [row[key] for row in rows(table)]
    assert sorted(set(keys)) == sorted(keys)


def test_apt_names_are_names() -> None:
    named = [apt for packages in frameworks.wheels().values() for apt in packages]
    named += [apt for _, apt in frameworks.imports().values() if apt]
    assert [apt for apt in named if not NAME.match(apt)] == []


def test_pip_names_of_wheels_are_as_the_index_compares_them() -> None:
    names = [*frameworks.wheels(), *arm64_wheels()]
    assert [name for name in names if canonicalize_name(name) != name] == []


def test_frameworks_grow_and_never_end_before_they_begin() -> None:
    for row in rows("frameworks"):
        assert Version(row["python_min"]) <= Version(row["python_max"]), row
        for cuda in f"{row['cuda']} {row['other_cuda']}".split():
            assert frameworks.cuda_image(cuda), row


def test_a_release_finds_the_row_of_its_series() -> None:
    row = frameworks.framework("torch", "1.10.2+cu113")
    assert row is not None
    assert (row.first, row.python_max) == ("1.10", "3.9")
    assert frameworks.framework("torch", "0.1") is None
    assert frameworks.framework("nothing", "1") is None


def test_images_name_known_releases() -> None:
    for image in frameworks.cuda_images():
        assert set(image.ubuntu) <= set(python_of_ubuntu())
        assert not image.tag or image.tag.startswith(image.cuda + ".")
