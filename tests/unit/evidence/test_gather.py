"""Everything that a repository may hold is read soon, in little memory, and without a traceback."""

from __future__ import annotations

import os
import resource
from pathlib import Path

import pytest

from hanging import ends
from roslab.config.model import Config
from roslab.decide import decide
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

MEGABYTES = 300


def links(root: Path) -> None:
    (root / "setup.py").write_text("from setuptools import setup\nsetup(name='x')\n")
    (root / "loop").symlink_to(".")
    (root / "up").symlink_to("..")
    (root / "package.xml").symlink_to("/etc/passwd")
    (root / "a").symlink_to("b")
    (root / "b").symlink_to("a")


def huge_requirements(root: Path) -> None:
    with (root / "requirements.txt").open("wb") as stream:
        stream.truncate(2 * 1024**3)
    (root / "main.py").write_text("if __name__ == '__main__':\n    pass\n")


def million_lines(root: Path) -> None:
    (root / "CMakeLists.txt").write_text("project(x)\n" + "find_package(Boost REQUIRED)\n" * 1_000_000)


def billion_laughs(root: Path) -> None:
    bomb = "".join(f'<!ENTITY {b} "{f"&{a};" * 10}">' for a, b in zip("abcdefgh", "bcdefghi", strict=True))
    (root / "package.xml").write_text(f'<!DOCTYPE p [<!ENTITY a "ha">{bomb}]><package><name>&i;</name></package>')
    (root / "CMakeLists.txt").write_text("project(x)\nfind_package(catkin REQUIRED)\n")


def yaml_bomb(root: Path) -> None:
    lines = [f"{b}: &{b} [{','.join([f'*{a}'] * 9)}]" for a, b in zip("abcdefgh", "bcdefghi", strict=True)]
    (root / "x.repos").write_text("a: &a [x, x, x]\n" + "\n".join(lines) + "\nrepositories: *i\n")
    (root / "main.py").write_text("import numpy\n")


def stray_bytes(root: Path) -> None:
    for name in (
        "package.xml",
        "CMakeLists.txt",
        "requirements.txt",
        "README.md",
        "Dockerfile",
        "x.repos",
        "a.launch",
        "a.py",
    ):
        (root / name).write_bytes(b"<package>\xff\xfe\x80 find_package(\xe9) FROM \xe9 import \xe9\n" * 50)


def newlines(root: Path) -> None:
    folder = root / "a\nb"
    folder.mkdir()
    (folder / "package.xml").write_text("<package><name>foo</name><depend>roscpp\nRUN x</depend></package>")
    (folder / "CMakeLists.txt").write_text("project(foo)\nfind_package(catkin REQUIRED)\n")
    (root / "x\ny.py").write_text("import numpy\n")
    (root / "deps\n.repos").write_text(
        'repositories:\n  "a\\nb": {type: git, url: "https://x.org/a;rm -rf /", version: "--x=y"}\n'
    )
    os.mkfifo(root / "README.md")


def blanks(root: Path) -> None:
    """A line of blanks, where a pattern could try each beginning with each end."""
    names = ("README.md", "Dockerfile", ".github/workflows/ci.yml", "params.yaml", "a.launch", "install.sh", "a.repos")
    for name in (*names, "main.py", "CMakeLists.txt", "package.xml", "setup.py", "environment.yml"):
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(" " * 250_000 + "x\n")


def hyphens(root: Path) -> None:
    """Words that hang together: the end of a name is looked for from each of its beginnings."""
    for name in ("README.md", "install.sh", "Dockerfile", "requirements.txt", "main.py"):
        (root / name).write_text("# robot\nsix\n" + "-".join(["word"] * 1_000_000) + "\n" + "ros-" * 60_000)


@pytest.mark.parametrize(
    "make",
    [blanks, hyphens, links, huge_requirements, million_lines, billion_laughs, yaml_bomb, stray_bytes, newlines],
    ids=lambda f: f.__name__,
)
def test_hostile_trees_end_soon_and_in_little_memory(tmp_path: Path, make: object) -> None:
    make(tmp_path)  # type: ignore[operator]
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    with ends():
        decision = decide(gather(Repository.open(tmp_path)), Config(), folder_name="demo")
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < MEGABYTES * 1024
    names = (*decision.apt, *decision.apt_guessed, *(source.ref or "" for source in decision.source))
    assert not any(c in name for name in names for c in "\n;$ ")
    assert not any(name.startswith("-") for name in names)


@pytest.mark.parametrize(
    ("inside", "told"),
    [("<depend>a b</depend></package>", False), ("<depend>a</depend>", True)],
)
def test_only_xml_that_is_cut_off_is_called_not_well_formed(tmp_path: Path, inside: str, told: bool) -> None:
    (tmp_path / "package.xml").write_text(f"<package><name>demo</name>{inside}")
    (message, *_), *_ = gather(Repository.open(tmp_path)).problems
    assert message.startswith("not well-formed: ") is told
