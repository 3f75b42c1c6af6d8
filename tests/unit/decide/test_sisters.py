"""What a page links to of the same owner is cloned for a package that CMake requires and nobody released."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

PACKAGE = (
    '<package format="3"><name>robo</name><buildtool_depend>ament_cmake</buildtool_depend>'
    "<{role}>demo_msgs</{role}><export><build_type>ament_cmake</build_type></export></package>"
)
REQUIRED = "find_package(demo_msgs REQUIRED)\n"
CONFIG = '[remote "origin"]\n\turl = git@github.com:Me/robo_demo.git\n'


@pytest.mark.parametrize(
    ("page", "role", "build", "found"),
    [
        ("Needs [ours](https://github.com/me/demo_interfaces).", "depend", REQUIRED, ["demo_interfaces"]),
        ("Needs [theirs](https://github.com/other/demo_interfaces).", "depend", REQUIRED, []),
        ("Like [ours](https://github.com/me/walker_msgs).", "depend", REQUIRED, []),
        ("Clone https://github.com/me/robo_demo in a workspace.", "depend", REQUIRED, []),
        ("Needs [ours](https://github.com/me/demo_interfaces).", "exec_depend", "", []),
        ("Needs [ours](https://github.com/me/demo_interfaces).", "test_depend", "", []),
        (
            "See https://github.com/me/demo_docs and https://github.com/me/demo_msgs.",
            "depend",
            REQUIRED,
            ["demo_msgs"],
        ),
    ],
)
def test_a_link_to_the_same_owner(tmp_path: Path, page: str, role: str, build: str, found: list[str]) -> None:
    files = {
        ".git/config": CONFIG,
        ".git/HEAD": "ref: refs/heads/main\n",
        "package.xml": PACKAGE.format(role=role),
        "CMakeLists.txt": f"project(robo)\nfind_package(ament_cmake REQUIRED)\n{build}",
        "README.md": f"# Robo\n\nROS 2 humble\n\n{page}\n",
    }
    for path, text in files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    decision = decide(gather(Repository.open(tmp_path)), Config(), folder_name="robo_demo")
    assert [source.name for source in decision.source] == found
