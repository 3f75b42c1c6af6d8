"""Lists of sister repositories whose entries are called alike, and public twins of private lists."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = {
    "base/package.xml": "<package format='3'><name>base</name><buildtool_depend>ament_cmake</buildtool_depend>"
    "<depend>base_core</depend></package>",
    "base/CMakeLists.txt": "project(base)\nfind_package(ament_cmake REQUIRED)\nfind_package(base_core REQUIRED)\n",
    ".git/config": '[remote "origin"]\n\turl = https://github.com/lab/ros2-base\n',
    ".git/HEAD": "ref: refs/heads/a\n",
    "README.md": "ROS 2 Humble\n",
}


def _list(*entries: tuple[str, str]) -> str:
    lines = (f"  {path}:\n    type: git\n    url: {url}\n    version: main\n" for path, url in entries)
    return f"repositories:\n{''.join(lines)}"


def _cloned(decision: Decision) -> list[tuple[str, str]]:
    return [(each.name, (each.repo or "").removesuffix(".git")) for each in decision.source if not each.holding]


LAB = "https://github.com/lab"


def test_entries_of_one_last_name_are_cloned_each(tree: Tree) -> None:
    listed = _list(
        ("core/common", f"{LAB}/core-common.git"),
        ("core/base", f"{LAB}/core-base.git"),
        ("ros2/common", f"{LAB}/ros2-common.git"),
        ("ros2/base", f"{LAB}/ros2-base.git"),  # the repository itself
        ("ros2/again", f"{LAB}/ros2-common.git"),
    )
    assert _cloned(tree({**PACKAGE, "all.repos": listed})) == [
        ("common", f"{LAB}/core-common"),
        ("base", f"{LAB}/core-base"),
        ("ros2_common", f"{LAB}/ros2-common"),
    ]


def test_an_entry_that_is_called_like_the_repository_is_it(tree: Tree) -> None:
    listed = _list(("ros2/base", "https://forge.lab.org/ros2/base.git"), ("ros2/common", f"{LAB}/ros2-common.git"))
    assert _cloned(tree({**PACKAGE, "all.repos": listed})) == [("common", f"{LAB}/ros2-common")]


@pytest.mark.parametrize(
    ("host", "other", "path", "found"),
    [
        ("forge.lab.org", "all.repos.public", "common", LAB),
        ("forge.lab.org", "all_public.repos", "common", LAB),
        ("forge.lab.org", "all_public.repos", "else", "https://forge.lab.org/lab"),
        ("github.com", "other.repos", "common", LAB),
    ],
)
def test_the_public_twin_of_a_private_list_is_imported(
    tree: Tree, host: str, other: str, path: str, found: str
) -> None:
    private = _list(("ros2/common", f"git@{host}:lab/common.git"))
    public = _list((f"ros2/{path}", f"{LAB}/common.git"))
    page = {"README.md": "ROS 2 Humble\n\n    vcs import src < all.repos\n"}
    assert _cloned(tree({**PACKAGE, **page, "all.repos": private, other: public})) == [("common", f"{found}/common")]


def test_a_list_that_the_page_spells_otherwise_is_in_the_tree(tree: Tree) -> None:
    listed = _list(("ros2/common", f"{LAB}/common.git"))
    page = f"ROS 2 Humble\n\n    wget {LAB.replace('github', 'raw.githubusercontent')}/base/main/all_public.repos\n"
    decision = tree(
        {**PACKAGE, "README.md": f"{page}    vcs import src < all_public.repos\n", "all.repos.public": listed}
    )
    assert _cloned(decision) == [("common", f"{LAB}/common")]
    assert not any("not imported" in each.message for each in decision.warnings)
