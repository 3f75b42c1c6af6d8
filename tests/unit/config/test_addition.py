"""Entries added to a roslab.yaml: everything else in it stays, and what it is read as afterwards has them."""

from __future__ import annotations

import pytest

from roslab.config.addition import Entry, added
from roslab.config.reader import read
from roslab.errors import ConfigurationError

WANTED = (Entry(key="apt", value="libglog-dev"),)


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (None, "format: 3\napt:\n  - libglog-dev\n"),
        ("", "format: 3\napt:\n  - libglog-dev\n"),
        ("format: 3\nname: robot", "format: 3\nname: robot\napt:\n  - libglog-dev\n"),
        ("format: 3\napt: [git] # tools\n", "format: 3\napt: [git, libglog-dev] # tools\n"),
        (
            "format: 3\napt:\n  - git # for vcs\n  # no more\nname: robot\n",
            "format: 3\napt:\n  - git # for vcs\n  - libglog-dev\n  # no more\nname: robot\n",
        ),
        ("format: 3\napt:\n- git", "format: 3\napt:\n- git\n- libglog-dev"),
        ("format: 3\napt: git\n", "format: 3\napt: [git, libglog-dev]\n"),
        ("format: 3\napt: []\n", "format: 3\napt: [libglog-dev]\n"),
        ("format: 3\napt:\nname: robot\n", "format: 3\napt: [libglog-dev]\nname: robot\n"),
        ("format: 3\napt: # later\n", "format: 3\napt: [libglog-dev] # later\n"),
        ("format: 3\napt: [git, libglog-dev]\n", "format: 3\napt: [git, libglog-dev]\n"),
    ],
)
def test_an_entry_is_added_where_its_key_stands(before: str | None, after: str) -> None:
    result = added(before, WANTED)
    assert result == after
    assert "libglog-dev" in read(result).apt
    assert added(result, WANTED) == result


def test_what_yaml_would_take_for_something_else_is_quoted() -> None:
    wanted = (("pip", "numpy<2"), ("pip", "yes"), ("build_args", "-j1"))
    result = added(None, [Entry(key=key, value=value) for key, value in wanted])
    assert read(result).pip == ("numpy<2", "yes")
    assert read(result).build_args == ("-j1",)


def test_an_old_file_is_migrated_first() -> None:
    with pytest.raises(ConfigurationError, match="today's format"):
        added("base: {ros: noetic}\napt: [git]\n", WANTED)


def test_a_wrong_file_is_not_written_to() -> None:
    with pytest.raises(ConfigurationError):
        added("format: 3\nappt: [git]\n", WANTED)


@pytest.mark.parametrize(
    ("before", "entry", "after"),
    [
        (None, Entry(key="base.python", value="3.10"), 'format: 3\nbase:\n  python: "3.10"\n'),
        (
            "format: 3\nbase:\n  ubuntu: jammy # LTS\nname: robot\n",
            Entry(key="base.python", value="3.9"),
            'format: 3\nbase:\n  ubuntu: jammy # LTS\n  python: "3.9"\nname: robot\n',
        ),
        (
            "format: 3\nbase: {ubuntu: jammy}\n",
            Entry(key="base.python", value="3.9"),
            'format: 3\nbase: {ubuntu: jammy, python: "3.9"}\n',
        ),
        (
            "format: 3\nbase:\n  python: '3.12' # new\n",
            Entry(key="base.python", value="3.9"),
            'format: 3\nbase:\n  python: "3.9" # new\n',
        ),
        ("format: 3\n", Entry(key="gui", value="true"), "format: 3\ngui: true\n"),
        ("format: 3\ngui: false\n", Entry(key="gui", value="true"), "format: 3\ngui: true\n"),
        (
            "format: 3\ncmake_options: -DA=1\n",
            Entry(key="cmake_options", value="-DB=2"),
            'format: 3\ncmake_options: "-DA=1 -DB=2"\n',
        ),
        (
            "format: 3\napt:\n  - git libold # both\n",
            Entry(key="apt", value="libnew", instead="libold"),
            "format: 3\napt:\n  - git libnew # both\n",
        ),
        (
            "format: 3\napt: [libold=1.2-3, git]\n",
            Entry(key="apt", value="libold", instead="libold=1.2-3"),
            "format: 3\napt: [libold, git]\n",
        ),
        (
            "format: 3\r\napt:\r\n  - git\r\n",
            Entry(key="apt", value="libglog-dev", note="glog/logging.h\n(a.cpp:3)"),
            "format: 3\r\napt:\r\n  - git\n  - libglog-dev  # glog/logging.h (a.cpp:3)\r\n",
        ),
    ],
)
def test_a_value_is_written_as_its_key_demands(before: str | None, entry: Entry, after: str) -> None:
    result = added(before, [entry])
    assert result == after
    assert added(result, [entry]) == result


@pytest.mark.parametrize(
    ("before", "wanted", "after"),
    [
        ("", (("base.python", "3.9", ""), ("base.python", "3.8", "")), 'base:\n  python: "3.8"\n'),
        ("", (("base.ubuntu", "24.04", ""),), 'base:\n  ubuntu: "24.04"\n'),
        ("base: {ubuntu: jammy}\n", (("base.ubuntu", "24.04", ""),), 'base: {ubuntu: "24.04"}\n'),
        ("base: {ubuntu: noble}\n", (("base.ubuntu", "24.04", ""),), "base: {ubuntu: noble}\n"),
        (
            "env:\n  A: b\n",
            (("env.PYTHONPATH", "/a", ""), ("env.PYTHONPATH", "/b", "")),
            "env:\n  A: b\n  PYTHONPATH: {}\n",
        ),
        (
            "env: {PYTHONPATH: /c}\n",
            (("env.PYTHONPATH", "/a", ""), ("env.PYTHONPATH", "/b", "")),
            'env: {PYTHONPATH: "/b"}\n',
        ),
        ("", (("pip", "six==1", ""), ("pip", "six==2", "six==1")), 'pip:\n  - "six==2"\n'),
        ("pip: [six==1]\n", (("pip", "six==2", "six==1"), ("pip", "six==3", "six==2")), "pip: [six==3]\n"),
        ("", (("pip", "six==1", ""), ("pip", "attrs", "")), 'pip:\n  - "six==1"\n  - attrs\n'),
    ],
)
def test_of_values_that_replace_each_other_the_last_is_written(
    before: str, wanted: tuple[tuple[str, str, str], ...], after: str
) -> None:
    entries = [Entry(key=key, value=value, instead=instead) for key, value, instead in wanted]
    assert added(f"format: 3\n{before}", entries) == "format: 3\n" + after.replace("{}", '"/b"')


def test_a_note_cannot_begin_a_line_of_its_own() -> None:
    entry = Entry(key="apt", value="git", note="a\nname: other\x1b[31m")
    assert read(added(None, [entry])).name is None
