"""Which stand-in images the lab makes, and under which names."""

from __future__ import annotations

import pytest

from lab import images
from lab.command import LabError

ALL = images.wanted(("amd64",))


@pytest.mark.parametrize(
    ("name", "identity"),
    [
        ("ros:indigo-ros-base", "indigo"),
        ("ros:noetic-ros-base", "noetic"),
        ("ubuntu:14.04", "ubuntu-oldest"),
        ("nvidia/cuda:11.3.1-cudnn8-devel-ubuntu20.04", "ubuntu-oldest"),
        ("nvidia/cuda:12.4.1-devel-ubuntu22.04", "ubuntu-old"),
    ],
)
def test_a_base_that_is_asked_for_has_its_stand_in(name: str, identity: str) -> None:
    made = images.needed(ALL, [name])
    assert made[-1].id == identity
    assert name in made[-1].names
    assert all(name not in image.names for image in made[:-1])


def test_what_nothing_stands_in_for_is_told() -> None:
    with pytest.raises(LabError, match="no stand-in for conda/miniconda3"):
        images.needed(ALL, ["conda/miniconda3"])


def test_the_usual_ones_are_not_based_on_one_that_is_made_on_request() -> None:
    asked = {image.id for image in ALL if image.on_request}
    assert asked
    assert not [image.id for image in ALL if not image.on_request and image.base in asked]
