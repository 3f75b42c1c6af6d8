"""A library that CMake files spell with capitals or without comes from the same package."""

from __future__ import annotations

from collections import defaultdict

import pytest

from roslab.knowledge.distros import ubuntus
from roslab.knowledge.libraries import Naming, library, names

APART = {"libzip": "the one is its configuration file, the other a search by pkg-config"}
"""Names that are not the same thing in another case, and why."""


def _spellings(naming: Naming) -> list[tuple[str, ...]]:
    found: dict[str, list[str]] = defaultdict(list)
    for name in names(naming):
        found[name.lower()].append(name)
    return [tuple(same) for plain, same in found.items() if len(same) > 1 and plain not in APART]


@pytest.mark.parametrize("naming", ["cmake", "link", "pkg-config"])
def test_spellings_that_differ_in_case_alone_have_the_same_packages(naming: Naming) -> None:
    for spellings in _spellings(naming):
        for ubuntu in ubuntus().values():
            found = [library(naming, name, ubuntu) for name in spellings]
            packaged = {each.apt for each in found if each and each.apt}  # another may be compiled: no package has it
            assert len(packaged) <= 1, (spellings, ubuntu, packaged)
            lacking = [name for name, each in zip(spellings, found, strict=True) if each and each.elsewhere]
            assert not (packaged and lacking and naming == "cmake"), (lacking, ubuntu, packaged)


def test_an_old_ubuntu_has_another_package_however_the_library_is_spelt() -> None:
    found = [library("cmake", name, "trusty") for name in ("PCL", "pcl", "PCL_ROS")]
    assert {each.apt for each in found if each} == {("libpcl-1.7-all-dev",)}
