"""Forks that a page lists among what is needed, and links of which it doubts that they lead anywhere."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]

LAB = "https://github.com/lab"
GIT = {
    ".git/config": f'[remote "origin"]\n\turl = {LAB}/mapper\n',
    ".git/HEAD": "ref: refs/heads/a\n",
}


def _files(item: str, *needed: str) -> dict[str, str]:
    depends = "".join(f"<depend>{name}</depend>" for name in needed)
    return {
        "README.md": f"# Mapper\nROS Noetic\n\n## Dependencies\n* Eigen\n{item}\n* GTSAM\n",
        "package.xml": f"<package><name>mapper</name><buildtool_depend>catkin</buildtool_depend>{depends}</package>",
        "CMakeLists.txt": f"project(mapper)\nfind_package(catkin REQUIRED COMPONENTS {' '.join(needed)})\n"
        "catkin_package()\nadd_executable(mapper a.cpp)\n",
        "a.cpp": "#include <ros/ros.h>\nint main() {}\n",
    }


def _sought(decision: Decision) -> dict[str, tuple[str, ...]]:
    return {source.repo or "": source.holding for source in decision.source}


@pytest.mark.parametrize(
    "item",
    [
        f"* grid_map (Forked version) {LAB}/grid_map",
        f"* grid_map: our fork, {LAB}/grid_map",
        f"* [grid_map]({LAB}/grid_map) (modified version)",
        f"* [our own version of grid_map]({LAB}/grid_map)",
        f"* [grid_map]({LAB}/grid_map)\n  is a fork with a layer of its own",
        f"* [semantic grid map]({LAB}/grid_map): Modified grid_map with labels",
    ],
)
def test_packages_of_a_fork_are_compiled_though_the_distribution_has_them(tree: Tree, item: str) -> None:
    files = _files(item, "grid_map_core", "grid_map_msgs", "roscpp")
    files["package.xml"] = files["package.xml"].replace(
        "</package>", "<test_depend>grid_map_pcl</test_depend></package>"
    )
    decision = tree(files)
    assert _sought(decision) == {f"{LAB}/grid_map": ("grid_map_core", "grid_map_msgs")}
    assert {"grid_map_core", "grid_map_msgs"} <= {*decision.rosdep}, "apt has them where the fork is gone"


@pytest.mark.parametrize(
    ("item", "needed"),
    [
        (f"* [grid_map]({LAB}/grid_map)", "grid_map_core"),
        (f"* grid_map is a fork of {LAB}/grid_map", "grid_map_core"),
        (f"* [the robot]({LAB}/my_robot)", "robot_state_publisher"),
        (f"* [a controller]({LAB}/custom_controller)", "controller_manager"),
        (f"* grid_map: please fork {LAB}/grid_map", "grid_map_core"),
        (f"* grid_map (forked version, not yet public) {LAB}/grid_map", "grid_map_core"),
        (f"* grid_map (forked version) {LAB}/grid_map", "roscpp"),
        (f"* grid_map {LAB}/grid_map\n* another one (forked version) {LAB}/another", "grid_map_core"),
        (f"\n## Other work\n* grid_map (forked version) {LAB}/grid_map", "grid_map_core"),
        (f"* [grid_map]({LAB}/grid_map): modified files are in maps", "grid_map_core"),
        (f"* [tools]({LAB}/customized_tools)", "grid_map_core"),
    ],
)
def test_what_is_no_fork_that_is_needed_is_not_cloned(tree: Tree, item: str, needed: str) -> None:
    assert _sought(tree(_files(item, needed))) == {}


@pytest.mark.parametrize("name", ["customized_grid_map", "grid_map_fork", "modified-grid-map", "grid_map_custom"])
@pytest.mark.parametrize(
    "item", ["* [grid_map]({})", "* Please install [grid_map]({}).", "* Install it from [here]({})"]
)
def test_the_name_of_a_repository_may_say_that_it_is_a_fork(tree: Tree, name: str, item: str) -> None:
    decision = tree(_files(item.format(f"{LAB}/{name}"), "grid_map_core"))
    assert _sought(decision) == {f"{LAB}/{name}": ("grid_map_core",)}


def test_what_cmake_alone_requires_is_taken_from_a_fork(tree: Tree) -> None:
    files = _files(f"* [octomap]({LAB}/octomap): Modified octomap", "octomap_ros")
    files["CMakeLists.txt"] += "find_package(octomap REQUIRED)\n"
    assert _sought(tree(files)) == {f"{LAB}/octomap": ("octomap_ros", "octomap")}


@pytest.mark.parametrize(
    ("sentence", "taken"),
    [
        ("Make sure that Grid is there (highly suggested to use [this forked version of Grid_Map]({}/maps)).", True),
        ("You need [our fork of the original Grid Map]({}/maps) for it.", False),
        ("You need [our fork of `grid_map`]({}/maps) for it.", True),
        ("Please install [the modified version of grid_map]({}/maps).", True),
        ("Use apt. You need not use [this forked version of grid_map]({}/maps).", False),
        ("If you want labels, use [this forked version of grid_map]({}/maps).", False),
        ("There is also [this forked version of grid_map]({}/maps).", False),
        ("Use [this forked version of the]({}/maps) planner.", False),
        ("Use [this fork of ros]({}/maps).", False),
    ],
)
def test_a_sentence_may_have_the_reader_use_a_fork_of_another_name(tree: Tree, sentence: str, taken: bool) -> None:
    """What the launch files start of its family is compiled with it: apt's would be for what was released."""
    files = _files("* Boost", "grid_map_core", "grid_map_msgs", "ros_control")
    files["README.md"] = f"# Mapper\nROS Noetic\n\n## Requirements\n{sentence.format(LAB)}\n"
    files["launch/a.launch"] = (
        '<launch><node pkg="grid_map_visualization" type="grid_map_visualization" name="a"/></launch>'
    )
    holding = ("grid_map_core", "grid_map_msgs", "grid_map_visualization")
    assert _sought(tree(files)) == ({f"{LAB}/maps": holding} if taken else {})


def test_a_fork_in_which_the_build_looks_for_another_package_is_cloned_once(tree: Tree) -> None:
    files = _files(f"* [grid_map]({LAB}/customized_grid_map)", "grid_map_core", "mapper_x")
    assert _sought(tree(files | GIT))[f"{LAB}/customized_grid_map.git"] == ("grid_map_core", "mapper_x")


@pytest.mark.parametrize(
    ("owner", "name", "told"), [("lab", "grid_map", 1), ("third", "grid_map", 0), ("lab", "eigen", 0)]
)
def test_a_repository_of_the_same_owner_in_place_of_the_listed_one_is_told(
    tree: Tree, owner: str, name: str, told: int
) -> None:
    decision = tree(_files(f"* https://github.com/{owner}/{name}", "grid_map_core") | GIT)
    assert _sought(decision) == {}
    found = [
        each for each in decision.warnings if "grid_map_core of ROS, from https://github.com/anybotics" in each.message
    ]
    assert [(each.file, each.line) for each in found] == [("README.md", 6)] * told


@pytest.mark.parametrize(
    ("said", "doubted"),
    [
        ("**The fork is not yet publicly available, and I don't know if the original version works.**", True),
        ("Build it first. This code isn't public yet.", True),
        ("The original version may not work.", True),
        ("It is not needed on Ubuntu.", False),
        ("Data sets are not available any more.", False),
        ("It works.", False),
        ("This package is not available on Windows.", False),
        ("It is not released for ROS Humble.", False),
        ("This code does not work with older compilers.", False),
        ("The simulator does not work without it.", False),
        ("This package won't work without its data.", False),
    ],
)
def test_a_page_may_doubt_what_it_links_to(tree: Tree, said: str, doubted: bool) -> None:
    decision = tree(_files(f"* [solver_x]({LAB}/solver_x): see there. {said}", "solver_x"))
    (source,) = decision.source
    assert (source.repo, source.unasked) == (f"{LAB}/solver_x", doubted)
    told = [each for each in decision.warnings if "the page says of it" in each.message]
    assert [(each.file, each.line) for each in told] == [("README.md", 6)] * doubted
    assert all(said.strip("*.") in each.message or "public yet" in each.message for each in told)


def test_a_link_by_the_name_of_what_a_table_brings_is_not_looked_through(tree: Tree) -> None:
    decision = tree(_files(f"* [catkin_simple]({LAB}/catkin_simple)", "catkin_simple", "mapper_x"))
    assert f"{LAB}/catkin_simple.git" not in _sought(decision)
