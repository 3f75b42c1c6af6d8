"""Packages of Ubuntu that a page names without a command that installs them."""

from __future__ import annotations

import pytest

from roslab.evidence.prose.apt_lists import said

NAMES = ["libyaml-cpp-dev", "libzmq3-dev"]


@pytest.mark.parametrize(
    "text",
    [
        "## Dependencies\n- libyaml-cpp-dev\n- libzmq3-dev\n",
        "Install the following:\n```\nlibyaml-cpp-dev\nlibzmq3-dev\n```\n",
        "On Ubuntu you need:\n\n    libyaml-cpp-dev libzmq3-dev\n",
        "This needs **libyaml-cpp-dev**, and `libzmq3-dev`.\n",
        "# Tests of a robot\n* yaml-cpp (libyaml-cpp-dev)\n* ZeroMQ: libzmq3-dev\n* [yaml](libyaml-cpp-dev)\n",
    ],
)
def test_lists_and_sentences(text: str) -> None:
    assert [asked.name for asked in said(text, "README.md")] == NAMES


@pytest.mark.parametrize(
    "text",
    [
        "## Optional\n- libyaml-cpp-dev\n",
        "## Troubleshooting\n### A\nInstall libyaml-cpp-dev.\n",
        "## macOS\n- libyaml-cpp-dev\n",
        "Do not install libyaml-cpp-dev.\n",
        "```\nsudo apt-get autoremove libyaml-cpp-dev\n```\n",
        "See https://packages.ubuntu.com/libyaml-cpp-dev and lib/libyaml-cpp-dev.so\n",
        "The branch is ros2-dev, install libyaml-cpp-dev-arm or libyaml-*-dev\n",
    ],
)
def test_what_is_no_need_is_left_out(text: str) -> None:
    assert list(said(text, "README.md")) == []


def test_each_stands_at_its_first_place() -> None:
    (asked,) = said("a\nlibzmq3-dev\nlibzmq3-dev\n", "README.md")
    assert (asked.namespace, asked.strength, asked.line) == ("apt", "prose", 2)
