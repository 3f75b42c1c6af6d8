"""A missing package is looked for in submodules first; thanks, and pages of others, say nothing of where it is."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend><depend>{}</depend></package>"
CMAKE = "project(demo)\nfind_package(catkin REQUIRED)\n"
MODULE = '[submodule "{0}"]\n\tpath = {0}\n\turl = https://github.com/lab/{0}.git\n'


def _tree(package: str, page: str, submodule: str = "", nested: str = "") -> dict[str, str]:
    files = {"demo/package.xml": PACKAGE.format(package), "demo/CMakeLists.txt": CMAKE}
    files |= {"README.md": f"# Demo\n\nROS Noetic\n\n{page}"}
    files |= {".gitmodules": MODULE.format(submodule)} if submodule else {}
    return files | ({"demo/README.md": nested} if nested else {})


def _cloned(decision: Decision) -> list[str]:
    return [each.name for each in decision.source]


@pytest.mark.parametrize(
    ("package", "submodule", "cloned"),
    [
        ("gcopter", "", ["GCOPTER"]),
        ("gcopter", "GCOPTER_F250", []),
        ("gcopter", "gcopter", []),
        ("gcopter", "quad_control", ["GCOPTER"]),
    ],
)
def test_a_submodule_comes_before_a_link(tree: Tree, package: str, submodule: str, cloned: list[str]) -> None:
    page = "It plans with [GCOPTER](https://github.com/other/GCOPTER).\n"
    decision = tree(_tree(package, page, submodule))
    assert _cloned(decision) == cloned
    told = [each.message for each in decision.warnings if f"no key {package}" in each.message]
    if submodule.lower().startswith("gcopter"):
        assert told
        assert f"the submodule {submodule} may hold it" in told[0]


@pytest.mark.parametrize(("submodule", "cloned"), [("kq_arm_control", []), ("quad_control", ["arm_tools"])])
def test_names_that_begin_with_the_same_two_words_are_a_family(tree: Tree, submodule: str, cloned: list[str]) -> None:
    page = "```\ngit clone https://github.com/lab/arm_tools.git\n```\n"
    assert _cloned(tree(_tree("kq_arm_msgs", page, submodule, f"# Tools\n\n{page}"))) == cloned


@pytest.mark.parametrize(
    ("title", "cloned"),
    [("Acknowledgements", []), ("Special thanks", []), ("Credits", []), ("Planning", ["gcopter"]), ("", ["gcopter"])],
)
def test_thanks_are_no_sources(tree: Tree, title: str, cloned: list[str]) -> None:
    page = f"## {title}\n\nIt is based on [gcopter](https://github.com/other/gcopter).\n"
    assert _cloned(tree(_tree("gcopter", page))) == cloned


@pytest.mark.parametrize(("title", "cloned"), [("Fast-Planner", []), ("Demo of the planner", ["Fast-Planner"])])
def test_the_page_of_another_project_says_nothing(tree: Tree, title: str, cloned: list[str]) -> None:
    nested = f"# {title}\n\n```\ngit clone https://github.com/other/Fast-Planner.git\n```\n"
    assert _cloned(tree(_tree("swarm_msgs", "", nested=nested))) == cloned


@pytest.mark.parametrize(("others", "looked"), [(2, True), (1, False)])
def test_a_word_of_many_packages_of_the_tree_tells_of_no_submodule(tree: Tree, others: int, looked: bool) -> None:
    needs = CMAKE.replace("REQUIRED", "REQUIRED COMPONENTS acme_msgs")
    files = _tree("acme_msgs", "    roslaunch acme_demo a.launch\n", "demo/acme_models") | {
        ".git/config": '[remote "origin"]\n\turl = https://github.com/lab/demo.git\n',
        ".git/HEAD": "ref: refs/heads/a\n",
        "demo/package.xml": PACKAGE.format("acme_msgs").replace(">demo<", ">acme_demo<"),
        "demo/CMakeLists.txt": needs,
        "demo/launch/a.launch": '<launch><node pkg="acme_demo" type="a" name="a"/></launch>\n',
    }
    for name in [f"acme_{number}" for number in range(others)]:
        files |= {f"{name}/package.xml": PACKAGE.format("acme_msgs").replace(">demo<", f">{name}<")}
        files[f"{name}/CMakeLists.txt"] = needs.replace("demo", name)
    decision = tree(files)
    assert ("acme_msgs" in _cloned(decision)) is looked
    if looked:  # the command needs it, so that it is looked for: others are left out only where it is not there
        assert (decision.left_out, decision.lacking) == ((), (("acme_msgs", ("acme_0", "acme_1")),))
