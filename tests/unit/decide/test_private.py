"""Repositories that not everybody can clone: told at once, and left out of the image where they are refused."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]

LIST = "- git:\n    local-name: quad\n    uri: https://{user}{host}/lab/quad.git\n"
PACKAGE = {
    "mine/package.xml": "<package><name>mine</name><buildtool_depend>catkin</buildtool_depend>"
    "<depend>quad</depend></package>",
    "mine/CMakeLists.txt": "project(mine)\nfind_package(catkin REQUIRED COMPONENTS quad)\n",
}
LINK = "[quad](https://github.com/lab/quad)"


@pytest.mark.parametrize(
    ("user", "host", "page", "told"),
    [
        ("", "github.com", "", False),
        ("jane@", "github.com", "", True),
        ("jane@", "git.example.org", "", True),
        ("", "github.com", f"The driver moved to a private repository {LINK}.\n", True),
        ("", "github.com", f"The driver moved to {LINK} (private).\n", True),
        ("", "github.com", f"{LINK} has private members. It is a private joke.\n", False),
        ("", "github.com", f"Not a private repository: {LINK}\n", False),
        ("", "github.com", "It uses the private repository [maps](https://github.com/lab/maps).\n", False),
    ],
)
def test_what_only_its_authors_can_clone_is_told(tree: Tree, user: str, host: str, page: str, told: bool) -> None:
    files = {"dependencies.rosinstall": LIST.format(user=user, host=host), "README.md": f"ROS Noetic.\n{page}"}
    decision = tree(PACKAGE | files)
    (source,) = decision.source
    public = "github.com" in host
    assert (source.repo, source.listed) == (f"https://{'' if public else user}{host}/lab/quad.git", True)
    assert any("quad may not be there for everybody" in each.message for each in decision.warnings) == told
