"""Packages that nothing known brings, and where the build looks for them."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]

LAB = "https://github.com/lab"
THIRD = "https://github.com/third"
OTHER = "Used with https://github.com/other/control"


def _package(name: str, *needed: str) -> dict[str, str]:
    """Return the files of a package of ROS 1 whose manifest and CMake ask for others."""
    depends = "".join(f"<depend>{each}</depend>" for each in needed)
    return {
        f"{name}/package.xml": f"<package><name>{name}</name><buildtool_depend>catkin</buildtool_depend>{depends}"
        "</package>",
        f"{name}/CMakeLists.txt": f"project({name})\nfind_package(catkin REQUIRED COMPONENTS {' '.join(needed)})\n"
        "catkin_package()\n",
    }


def _git(origin: str) -> dict[str, str]:
    config = f'[remote "origin"]\n\turl = {origin}\n' if origin else ""
    return {".git/config": config, ".git/HEAD": "ref: refs/heads/a\n"}


def _sought(decision: Decision) -> dict[str, tuple[str, ...]]:
    return {(s.repo or "").removesuffix(".git"): s.holding for s in decision.source if s.holding}


@pytest.mark.parametrize(
    ("page", "linked"),
    [
        (f"Used with {LAB}/control.\nSee [it]({LAB}/control).\n", [f"{LAB}/control"]),
        (f"Used with {LAB}/control.\nSee [it]({LAB}/other).\n", [f"{LAB}/control", f"{LAB}/other"]),
        (f"Used with {LAB}/control.\nClone {LAB}/mpc.\n", [f"{LAB}/control"]),
        (f"Used with {LAB}/control.\nMade from https://github.com/other/mpc.\n", [f"{LAB}/control"]),
        (f"Used with {LAB}/control.\nAs https://github.com/ros-planning/navigation.\n", [f"{LAB}/control"]),
        ("Used with https://github.com/other/control.\n", ["https://github.com/other/control"]),
        ("Used with https://github.com/other/control and https://github.com/third/more.\n", []),
        (
            f"{OTHER}. The whole dependencies and a demo can be found in: **https://github.com/third/whole**\n",
            ["https://github.com/third/whole"],
        ),
        (
            f"Used with {LAB}/control. All required packages are available\nat [whole](https://github.com/third/whole).\n",
            ["https://github.com/third/whole", f"{LAB}/control"],
        ),
        (
            f"Dependencies can be found below. {OTHER} and https://github.com/third/more.\n",
            [],
        ),
        ("The paper can be found in https://github.com/other/a and https://github.com/third/more.\n", []),
        (
            f"# Prerequisites\n* Eigen\n* [whole]({THIRD}/whole)\n* [cv]({THIRD}/OpenCV)\n* [more]({THIRD}/more)",
            [f"{THIRD}/whole", f"{THIRD}/more"],
        ),
        (f"# Prerequisites\n* [whole]({THIRD}/whole)\n* [demo]({THIRD}/demo) (optional)\n", [f"{THIRD}/whole"]),
        (
            f"# References\n## Related packages\n* a\n{THIRD}/whole\n* b\n{THIRD}/more\n",
            [f"{THIRD}/whole", f"{THIRD}/more"],
        ),
        (f"# Related packages\n* {THIRD}/more\n* {THIRD}/quad_y\n", [f"{THIRD}/quad_y", f"{THIRD}/more"]),
        (f"# Related packages\n* {THIRD}/more\n* {LAB}/control\n", [f"{LAB}/control", f"{THIRD}/more"]),
        (f"# Related packages\n* {THIRD}/more (private)\n* {THIRD}/opencv\n", []),
        (f"# Related packages\n## Papers\n* {THIRD}/whole\n* {THIRD}/more\n", []),
        (f"# References\n* [whole]({THIRD}/whole)\n* [more]({THIRD}/more)\n", []),
        (f"[quad_x]({LAB}/drivers_to_real)\n", [f"{LAB}/drivers_to_real"]),
        ("", []),
    ],
)
def test_what_pages_link_to_may_hold_it_then_a_repository_of_its_name(tree: Tree, page: str, linked: list[str]) -> None:
    files = _git(f"{LAB}/mpc.git") | _package("mpc", "quad_x", "roscpp")
    decision = tree(files | {"README.md": f"ROS Noetic.\n{page}"})
    assert _sought(decision) == dict.fromkeys([*linked, f"{LAB}/quad_x"], ("quad_x",))
    told = next(each.message for each in decision.warnings if "nothing is known that brings quad_x" in each.message)
    assert f"looks for it in {' and '.join([*linked, f'{LAB}/quad_x'])}," in told
    assert not [each for each in decision.warnings if "no key quad_x" in each.message]  # it is told once


@pytest.mark.parametrize(
    ("origin", "address"),
    [
        ("git@github.com:lab/acme_nav.git", f"{LAB}/acme_io"),
        ("https://gitlab.com/lab/acme_nav", "https://gitlab.com/lab/acme_io"),
        ("/home/somebody/acme_nav", ""),
        ("", ""),
    ],
)
def test_the_owner_is_known_by_the_origin(tree: Tree, origin: str, address: str) -> None:
    decision = tree(_git(origin) | _package("acme_nav", "acme_io") | {"README.md": "ROS Noetic.\n"})
    assert [*_sought(decision)] == ([address] if address else [])
    told = next(each.message for each in decision.warnings if "nothing is known that brings acme_io" in each.message)
    assert address in told
    assert address or "looks for it" not in told


@pytest.mark.parametrize(
    ("origin", "needed", "found"),
    [
        ("nav", ("base_msgs",), {"base_msgs": ("base_msgs",), "base": ("base_msgs",)}),
        ("nav", ("base", "base_msgs"), {"base_msgs": ("base_msgs",), "base": ("base", "base_msgs")}),
        ("nav", ("arm_ros",), {"arm_ros": ("arm_ros",), "arm": ("arm_ros",)}),
        ("nav", ("armpy",), {"armpy": ("armpy",), "arm": ("armpy",)}),
        ("nav", ("arm_py",), {"arm_py": ("arm_py",), "arm": ("arm_py",)}),
        ("nav", ("xpy",), {"xpy": ("xpy",)}),
        ("nav", ("plan_lib",), {"plan_lib": ("plan_lib",), "plan": ("plan_lib",)}),
        ("nav", ("nav_x_msgs",), {"nav_x_msgs": ("nav_x_msgs",), "nav_x": ("nav_x_msgs",)}),
        ("base", ("base_msgs",), {"base_msgs": ("base_msgs",)}),  # the repository itself
        (
            "old",
            ("nav_msg_lib", "mpc_msgs"),
            {"nav_msg_lib": ("nav_msg_lib",), "nav_msg": ("nav_msg_lib",), "mpc_msgs": ("mpc_msgs",)},
        ),
        ("nav", ("navigation_msgs",), {"navigation_msgs": ("navigation_msgs",)}),  # others publish that
    ],
)
def test_a_part_may_be_in_the_repository_of_the_whole(
    tree: Tree, origin: str, needed: tuple[str, ...], found: dict[str, tuple[str, ...]]
) -> None:
    decision = tree(_git(f"{LAB}/{origin}") | _package("mpc", *needed) | {"README.md": "ROS Noetic.\n"})
    assert _sought(decision) == {f"{LAB}/{name}": held for name, held in found.items()}


@pytest.mark.parametrize(("role", "looked"), [("exec_depend", True), ("test_depend", False), ("doc_depend", False)])
def test_what_only_tests_or_documentation_need_is_not_looked_for(tree: Tree, role: str, looked: bool) -> None:
    files = _git(f"{LAB}/robo") | {"README.md": "# Robo\n\nROS 2 humble\n"}
    files["package.xml"] = (
        '<package format="3"><name>robo</name><buildtool_depend>ament_cmake</buildtool_depend>'
        f"<{role}>demo_msgs</{role}><export><build_type>ament_cmake</build_type></export></package>"
    )
    files["CMakeLists.txt"] = "project(robo)\nfind_package(ament_cmake REQUIRED)\n"
    assert bool(_sought(tree(files))) == looked


@pytest.mark.parametrize("key", ["libacme-dev", "python-acme", "Acme", "roscpp", "opencv_apps"])
def test_nothing_is_looked_for_that_is_known_or_no_package_of_ros(tree: Tree, key: str) -> None:
    decision = tree(_git(f"{LAB}/mpc") | _package("mpc", key) | {"README.md": "ROS Noetic.\n"})
    assert not _sought(decision)


@pytest.mark.parametrize(("name", "looked"), [("libarm_ros", True), ("libarm_msgs", True), ("libarm_rosy", False)])
def test_what_ends_as_packages_of_ros_do_is_no_library_of_the_system(tree: Tree, name: str, looked: bool) -> None:
    decision = tree(_git(f"{LAB}/mpc") | _package("mpc", name) | {"README.md": "ROS Noetic.\n"})
    assert (f"{LAB}/{name}" in _sought(decision)) is looked


@pytest.mark.parametrize(
    ("header", "looked"), [("libarm/Arm.hpp", True), ("libarm.h", False), ("arm/Arm.hpp", False), ("vector", False)]
)
def test_a_package_may_be_called_like_a_library_where_the_code_includes_its_headers(
    tree: Tree, header: str, looked: bool
) -> None:
    files = _git(f"{LAB}/mpc") | _package("mpc", "libarm") | {"README.md": "ROS Noetic.\n"}
    decision = tree(files | {"mpc/src/a.cpp": f"#include <{header}>\nint main() {{}}\n"})
    assert (_sought(decision) == {f"{LAB}/libarm": ("libarm",)}) is looked
    assert bool(_sought(decision)) is looked


@pytest.mark.parametrize(
    ("code", "looked"),
    [
        ('auto uri = "package://mpc_description/urdf/a.urdf";\n', True),
        ("// package://mpc_description/urdf/a.urdf\n", False),
        ("", False),
    ],
)
def test_a_declared_key_that_the_code_alone_names_is_looked_for_at_the_owner(
    tree: Tree, code: str, looked: bool
) -> None:
    files = _git(f"{LAB}/mpc") | _package("mpc", "roscpp") | {"README.md": "ROS Noetic.\n"}
    manifest = files["mpc/package.xml"].replace("</package>", "<depend>mpc_description</depend></package>")
    decision = tree(files | {"mpc/package.xml": manifest, "mpc/src/a.cpp": f"{code}int main() {{}}\n"})
    assert (_sought(decision).get(f"{LAB}/mpc_description") == ("mpc_description",)) is looked


def test_a_package_may_be_in_the_owners_repository_of_its_first_words_though_others_publish_that(tree: Tree) -> None:
    files = _git(f"{LAB}/mpc") | _package("mpc", "grid_map_comp", "quad_x") | {"README.md": "ROS Noetic.\n"}
    assert _sought(tree(files)) == {
        f"{LAB}/grid_map_comp": ("grid_map_comp",),
        f"{LAB}/quad_x": ("quad_x",),
        f"{LAB}/grid_map": ("grid_map_comp",),
    }


def test_nothing_is_looked_for_where_a_clone_may_hold_it(tree: Tree) -> None:
    page = "ROS Noetic.\n\n    cd ~/catkin_ws/src\n    git clone https://github.com/lab/mpc\n"
    page += "    git clone https://github.com/other/drivers\n    catkin_make\n"
    decision = tree(_git(f"{LAB}/mpc") | _package("mpc", "quad_x") | {"README.md": page})
    assert [source.name for source in decision.source] == ["drivers"]
    assert not _sought(decision)


@pytest.mark.parametrize(
    ("name", "text", "found"),
    [
        ("b.launch", '<launch>{}<include file="$(find acme_arm)/a.launch"/></launch>', True),
        ("b.launch", '<launch>{}<param name="a" value="$(find acme_arm)/cfg/"/></launch>', True),
        ("b.launch", '<launch>{}<node pkg="acme_arm" type="a" name="a"/></launch>', True),
        ("b.launch", '<launch>{}<node pkg="acme_arm" type="a" name="a" if="$(arg real)"/></launch>', False),
        ("b.launch", '<launch>{}<!-- <node pkg="acme_arm" type="a" name="a"/> --></launch>', False),
        ("b.launch", '<launch>{}<node pkg="gazebo_ros" type="a" name="a"/></launch>', False),
        ("b.launch", '<launch>{}<node pkg="robo_arm" type="a" name="a"/></launch>', False),  # itself
        ("b.launch", '<launch>{}<node pkg="mpcc_nav" type="a" name="a"/></launch>', False),  # a slip of its own
    ],
)
def test_what_only_another_launch_file_needs_is_looked_for_by_its_name(
    tree: Tree, name: str, text: str, found: bool
) -> None:
    files = _git(f"{LAB}/robo_arm") | _package("mpc_nav", "roscpp")
    node = '<node pkg="mpc_nav" type="mpc" name="mpc"/>'
    files["mpc_nav/launch/mpc.launch"] = f"<launch>{node}</launch>\n"
    files[f"mpc_nav/launch/{name}"] = text.format(node)
    page = "ROS Noetic.\nUsed with https://github.com/other/control.\n\n    roslaunch mpc_nav mpc.launch\n"
    decision = tree(files | {"README.md": page})
    assert decision.command == ("roslaunch", "mpc_nav", "mpc.launch")
    assert _sought(decision) == ({f"{LAB}/acme_arm": ("acme_arm",)} if found else {})
    said = f"the build looks for acme_arm in {LAB}/acme_arm; where one is not there, they stop"
    assert any(said in each.message for each in decision.warnings) == found


@pytest.mark.parametrize(
    "asked",
    [
        "FindPackageShare('acme_arm')",
        "get_package_share_directory('acme_arm')",
        "Node(package='acme_arm', executable='a')",
    ],
)
def test_so_is_what_a_launch_file_of_ros2_finds(tree: Tree, asked: str) -> None:
    files = _git(f"{LAB}/robo") | {"README.md": "ROS 2 humble\n"}
    files["package.xml"] = (
        '<package format="3"><name>robo</name><buildtool_depend>ament_cmake</buildtool_depend>'
        "<export><build_type>ament_cmake</build_type></export></package>"
    )
    files["CMakeLists.txt"] = "project(robo)\nfind_package(ament_cmake REQUIRED)\n"
    begin = "from launch import LaunchDescription\ndef generate_launch_description():\n    return LaunchDescription(["
    for name, node in (("a", "Node(package='robo', executable='a')"), ("b", asked)):
        files[f"launch/{name}.launch.py"] = f"{begin}{node}])\n"
    assert _sought(tree(files)) == {f"{LAB}/acme_arm": ("acme_arm",)}


def test_the_repository_of_a_family_may_be_called_like_one_of_it(tree: Tree) -> None:
    nodes = "".join(f'<node pkg="{name}" type="a" name="a"/>' for name in ("zork_arm", "zork_arm_utils", "zork_arm_v"))
    files = _git(f"{LAB}/robo") | _package("robo", "roscpp")
    started = '<launch><node pkg="robo" type="a" name="b"/>{}</launch>\n'
    files |= {f"robo/launch/{name}.launch": started.format(each) for name, each in (("a", ""), ("b", nodes))}
    files["README.md"] = "ROS Noetic.\n\n    roslaunch robo a.launch\n"
    assert _sought(tree(files))[f"{LAB}/zork_arm"] == ("zork_arm", "zork_arm_utils", "zork_arm_v")


@pytest.mark.parametrize(
    ("needed", "looked"),
    [
        (("catkin_simple", "quad_catkin"), "quad_catkin"),  # catkin is the word of no family
        (("ament_acme", "quad_ament"), "quad_ament"),
        (("acme_drive", "acme_plan"), "acme_plan"),  # the clone is called like another of the family
        (("acme_drive", "acme_drive"), ""),
    ],
)
def test_a_clone_of_one_package_hides_no_other_of_the_owner(tree: Tree, needed: tuple[str, ...], looked: str) -> None:
    page = (
        f"ROS Noetic.\n\n    cd ~/catkin_ws/src\n    git clone https://github.com/other/{needed[0]}\n    catkin_make\n"
    )
    decision = tree(_git(f"{LAB}/mpc") | _package("mpc", *needed) | {"README.md": page})
    assert needed[0] in {source.name for source in decision.source if not source.holding}
    assert _sought(decision) == ({f"{LAB}/{looked}": (looked,)} if looked else {})
    assert not any("one of the cloned repositories may hold it" in each.message for each in decision.warnings)


@pytest.mark.parametrize(
    ("clone", "looked"),
    [
        (f"{LAB}/quad2_stuff", True),  # the owner's
        ("https://github.com/other/best_widgets", True),  # a word of the name
        ("https://github.com/other/stuff", True),  # the page at the root clones few others
        ("https://github.com/other/opencv", False),
        ("https://github.com/other/acme_node", False),  # it has the name of another package
    ],
)
def test_what_a_page_clones_may_hold_a_package_that_it_is_not_called_like(tree: Tree, clone: str, looked: bool) -> None:
    page = "ROS Noetic.\n\n    cd ~/src\n    git clone https://github.com/lab/drivers\n"
    page += f"    git clone {clone}.git\n    git clone {LAB}/mpc\n"
    files = _git(f"{LAB}/mpc") | _package("mpc", "drivers", "acme_widgets", "acme_node")
    decision = tree(files | {"README.md": page})
    assert {"drivers"} <= {source.name for source in decision.source if not source.holding}
    assert any("acme_widgets" in names for url, names in _sought(decision).items() if url == clone) == looked


def test_what_no_clone_is_called_like_is_tried_in_what_the_page_at_the_root_clones_unless_that_is_much(
    tree: Tree,
) -> None:
    named = [f"https://github.com/third/{name}-ros-pkg" for name in ("px", "tool", "cam", "gps")]
    files = _git(f"{LAB}/mpc") | _package("mpc", "px_comm", "roscpp")
    for count, tried in ((3, True), (4, False)):
        page = "ROS Noetic.\n\n" + "".join(f"    git clone {url}\n" for url in (f"{LAB}/mpc", *named[:count]))
        decision = tree(files | {"README.md": page})
        assert any(_sought(decision).get(url) == ("px_comm",) for url in named) is tried
        assert any("not cloned" in each.message for each in decision.warnings) is not tried


@pytest.mark.parametrize(
    ("clones", "looked"),
    [
        (("https://github.com/maker/mpc",), ["https://github.com/maker/quad_x"]),
        (
            ("https://bitbucket.org/maker/mpc", "https://github.com/maker/roscpp"),
            ["https://bitbucket.org/maker/quad_x", "https://github.com/maker/quad_x"],
        ),
        ((f"{LAB}/mpc",), []),
        (("https://github.com/maker/other",), []),
        (("https://git.maker.org/maker/mpc",), []),
        (("git:mpc",), []),
    ],
)
def test_what_belongs_to_a_copy_is_looked_for_with_its_author(
    tree: Tree, clones: tuple[str, ...], looked: list[str]
) -> None:
    page = "ROS Noetic.\n\n" + "".join(f"    git clone {each}.git\n" for each in clones)
    decision = tree(_git(f"{LAB}/mpc") | _package("mpc", "quad_x", "roscpp") | {"README.md": page})
    assert sorted(url for url in _sought(decision) if url.endswith("/quad_x")) == sorted([*looked, f"{LAB}/quad_x"])


def test_a_link_with_a_slash_at_its_end_is_one_to_a_repository(tree: Tree) -> None:
    page = f"ROS Noetic. Have [it]({LAB}/quad-ros-wrapper/) and see [issues]({LAB}/more/issues/).\n"
    decision = tree(_git(f"{LAB}/mpc") | _package("mpc", "quad_wrapper") | {"README.md": page})
    assert [*_sought(decision)] == [f"{LAB}/quad-ros-wrapper", f"{LAB}/quad_wrapper"]


@pytest.mark.parametrize(("more", "looked"), [("", True), ("find_package(AcmeSDK REQUIRED)\n", False)])
def test_a_package_that_the_command_does_not_need_is_built_where_the_owner_has_what_it_lacks(
    tree: Tree, more: str, looked: bool
) -> None:
    files = _git(f"{LAB}/mpc") | _package("mpc", "roscpp") | _package("extra", "quad_x")
    files["extra/CMakeLists.txt"] += more
    files["mpc/launch/mpc.launch"] = '<launch><node pkg="mpc" type="mpc" name="mpc"/></launch>\n'
    decision = tree(files | {"README.md": "ROS Noetic.\n\n    roslaunch mpc mpc.launch\n"})
    assert (decision.left_out, decision.lacking) == (() if looked else ("extra",), (("quad_x", ("extra",)),) * looked)
    assert [*_sought(decision)] == [f"{LAB}/quad_x"] * looked
    assert any("the build looks for it" in each.message for each in decision.warnings) == looked
    assert any(each.question == "source" for each in decision.reasons) == looked


def test_what_a_package_lacks_is_looked_for_first_where_a_page_names_a_repository(tree: Tree) -> None:
    files = _git(f"{LAB}/mpc") | _package("mpc", "roscpp") | _package("extra", "quad_x")
    decision = tree(files | {"README.md": f"ROS Noetic. Used with {LAB}/control.\n"})
    assert (decision.left_out, decision.lacking) == ((), (("quad_x", ("extra",)),))
    assert [*_sought(decision)] == [f"{LAB}/control", f"{LAB}/quad_x"]
    told = next(each.message for each in decision.warnings if "CMake requires" in each.message)
    assert "and where it is not there, extra is left out of the build, which no other package needs" in told


def test_what_lacks_more_than_may_be_there_is_left_out(tree: Tree) -> None:
    files = _git(f"{LAB}/mpc") | _package("mpc", "roscpp") | _package("extra", "quad_x")
    files["extra/CMakeLists.txt"] += "find_package(AcmeSDK REQUIRED)\n"
    decision = tree(files | {"README.md": f"ROS Noetic. Used with {LAB}/control.\n"})
    assert (decision.left_out, decision.lacking, _sought(decision)) == (("extra",), (), {})
    assert not any("CMake requires; the build looks" in each.message for each in decision.warnings)


def test_a_metapackage_alone_is_nothing_that_is_kept(tree: Tree) -> None:
    meta = _package("all", "mpc")
    meta["all/package.xml"] = meta["all/package.xml"].replace("</package>", "<export><metapackage/></export></package>")
    meta["all/CMakeLists.txt"] = "project(all)\nfind_package(catkin REQUIRED)\ncatkin_metapackage()\n"
    decision = tree(_git(f"{LAB}/all") | meta | _package("mpc", "quad_x") | {"README.md": "ROS Noetic.\n"})
    assert (decision.left_out, [*_sought(decision)]) == ((), [f"{LAB}/quad_x"])
    assert any("catkin_make will stop at mpc" in each.message for each in decision.warnings)


def test_a_clone_that_is_looked_for_is_as_old_as_the_repository(tree: Tree) -> None:
    files = _git(f"{LAB}/mpc") | _package("mpc", "quad_x") | {"README.md": "ROS Melodic.\n"}
    files["CITATION.cff"] = "cff-version: 1.2.0\ntitle: MPC\ndate-released: 2019-05-20\n"
    (source,) = (each for each in tree(files).source if each.holding)
    assert (source.name, source.build, source.ref) == ("quad_x", "catkin_make", None)


def test_of_keys_that_a_clone_may_hold_one_warning_tells(tree: Tree) -> None:
    page = "ROS Noetic.\n\n    cd ~/catkin_ws/src\n    git clone https://github.com/lab/mpc\n"
    page += "    git clone https://github.com/other/drivers\n    catkin_make\n"
    decision = tree(_git(f"{LAB}/mpc") | _package("mpc", "quad_x", "quad_y", "quad_z") | {"README.md": page})
    told = [each for each in decision.warnings if "rosdep has no key" in each.message]
    assert [(each.file, each.line) for each in told] == [("mpc/package.xml", 1)]
    assert told[0].message.startswith("rosdep has no keys quad_x, quad_y and quad_z for ROS noetic: one of the cloned")
    assert "may hold them; else correct the names, or give" in told[0].message


_CODE = "#include <ros/ros.h>\n#include <acme_msgs/SetGrid.h>\nint main() {}\n"


def _including(code: str, more: str = "") -> dict[str, str]:
    files = _git(f"{LAB}/mpc") | _package("mpc", "roscpp") | {"README.md": "ROS Noetic.\n"}
    return files | {"mpc/src/mpc.cpp": code} | ({"mpc/msg/State.msg": "int8 a\n"} if more else {})


def test_a_package_whose_messages_the_code_includes_is_looked_for(tree: Tree) -> None:
    decision = tree(_including(_CODE))
    assert _sought(decision) == dict.fromkeys([f"{LAB}/acme_msgs", f"{LAB}/acme"], ("acme_msgs",))
    told = next(each for each in decision.warnings if "acme_msgs" in each.message)
    assert (told.file, told.line) == ("mpc/src/mpc.cpp", 2)
    assert f"the build looks for it in {LAB}/acme_msgs" in told.message
    assert decision.left_out == ()


@pytest.mark.parametrize(
    "header",
    [
        "nav_msgs/GridCells.h",  # of the distribution
        "mpc/State.h",  # its own
        "acme/Grid.h",  # a library's
        "acme_msgs/set_grid.h",
        "acme_msgs/detail/SetGrid.h",
        "octomap_msgs/Octomap.h",
    ],
)
def test_other_headers_name_no_package(tree: Tree, header: str) -> None:
    decision = tree(_including(_CODE.replace("acme_msgs/SetGrid.h", header)))
    assert not _sought(decision)
    assert not any("includes messages" in warning.message for warning in decision.warnings)


@pytest.mark.parametrize(
    ("path", "code"),
    [
        ("mpc/src/mpc.cpp", "#ifdef WITH_ACME\n#include <acme_msgs/SetGrid.h>\n#endif\n"),
        ("mpc/src/mpc.cpp", "// #include <acme_msgs/SetGrid.h>\n"),
        ("other/mpc.cpp", _CODE),
        ("mpc/test/mpc.cpp", _CODE),
    ],
)
def test_what_is_not_always_compiled_names_none(tree: Tree, path: str, code: str) -> None:
    files = _including("int main() {}\n") | {path: code}
    assert not _sought(tree(files))


def test_a_message_that_one_file_always_includes(tree: Tree) -> None:
    files = _including("#ifdef WITH_ACME\n#include <acme_msgs/SetGrid.h>\n#endif\n") | {"mpc/src/z.cpp": _CODE}
    assert [*_sought(tree(files))] == [f"{LAB}/acme_msgs", f"{LAB}/acme"]


def test_the_headers_of_messages_of_ros_2(tree: Tree) -> None:
    files = _git(f"{LAB}/robo") | {"README.md": "# Robo\n\nROS 2 humble\n"}
    files["package.xml"] = (
        '<package format="3"><name>robo</name><buildtool_depend>ament_cmake</buildtool_depend>'
        "<export><build_type>ament_cmake</build_type></export></package>"
    )
    files["CMakeLists.txt"] = "project(robo)\nfind_package(ament_cmake REQUIRED)\n"
    files["src/a.cpp"] = "#include <acme_msgs/msg/set_grid.hpp>\n#include <std_msgs/msg/string.hpp>\n"
    assert [*_sought(tree(files))] == [f"{LAB}/acme_msgs", f"{LAB}/acme"]


@pytest.mark.parametrize(
    ("condition", "lacks"),
    [
        ("catkin_FOUND", True),
        ("ament_cmake_FOUND", False),
        ("NOT ament_cmake_FOUND", True),
        ("catkin_FOUND AND WITH_QUAD", False),
        ("WITH_QUAD", False),
    ],
)
def test_what_a_file_requires_that_cmake_includes_for_this_ros(tree: Tree, condition: str, lacks: bool) -> None:
    """Of ROS 1, in the ways of packages for both."""
    files = _git(f"{LAB}/mpc") | _package("mpc", "roscpp") | _package("extra", "quad_x")
    files["extra/CMakeLists.txt"] = (
        f"project(extra)\nfind_package(catkin QUIET COMPONENTS roscpp)\nif({condition})\n"
        "include(${CMAKE_CURRENT_SOURCE_DIR}/cmake/ROS1.cmake)\nendif()\n"
    )
    files["extra/cmake/ROS1.cmake"] = "find_package(quad_x REQUIRED)\ncatkin_package()\n"
    decision = tree(files | {"README.md": f"ROS Noetic. Used with {LAB}/control.\n"})
    assert decision.lacking == ((("quad_x", ("extra",)),) if lacks else ())


@pytest.mark.parametrize(
    ("line", "sought"),
    [
        ("sudo apt-get install acme-dev", []),
        (
            "git clone https://github.com/other/acme\ncd acme\nmkdir build\ncd build\ncmake ..\nsudo make install",
            [],
        ),
        ("sudo apt-get install acme-tools", [f"{LAB}/acme"]),
    ],
)
def test_what_a_page_installs_is_looked_for_nowhere_else(tree: Tree, line: str, sought: list[str]) -> None:
    page = f"# Robo\n\nROS noetic\n\n```\n{line}\n```\n"
    decision = tree({**_package("mpc", "acme"), **_git(f"{LAB}/robo"), "README.md": page})
    assert [*_sought(decision)] == sought
    assert any("no key acme" in warning.message for warning in decision.warnings) is bool(sought)


@pytest.mark.parametrize("source", ["", "deb https://apt.acme.org/focal focal main"])
def test_what_apt_brings_from_a_source_of_the_page_is_not_compiled_as_well(tree: Tree, source: str) -> None:
    add = f'echo "{source}" | sudo tee /etc/apt/sources.list.d/acme.list\n' if source else ""
    page = f"# Robo\n\nROS noetic\n\n```\n{add}sudo apt-get install acme-dev\n```\n"
    steps = "git clone -b v1.2 https://github.com/other/acme\ncd acme\nmkdir build\ncd build\ncmake ..\nmake install\n"
    files = _package("mpc", "acme")
    files["mpc/CMakeLists.txt"] += "find_package(acme REQUIRED)\n"
    decision = tree({**files, **_git(f"{LAB}/robo"), "README.md": page, "install.sh": steps})
    assert ("acme" in {each.name for each in decision.source}) is not bool(source)


@pytest.mark.parametrize(
    ("started", "found"),
    [
        ('<include file="$(find acme_base)/launch/a.launch"/>', [f"{LAB}/acme_base"]),
        ('<include file="$(find acme_base)/launch/a.launch" if="$(arg real)"/>', []),
        ('<include file="$(find gazebo_ros)/launch/empty_world.launch"/>', []),
    ],
)
def test_what_the_default_launch_file_needs_is_looked_for(tree: Tree, started: str, found: list[str]) -> None:
    files = _git(f"{LAB}/mpc") | _package("mpc", "roscpp")
    node = '<node pkg="mpc" type="mpc" name="mpc"/>'
    files["mpc/launch/mpc.launch"] = f"<launch>{node}{started}</launch>\n"
    decision = tree(files | {"README.md": "ROS Noetic.\n\n    roslaunch mpc mpc.launch\n"})
    assert decision.command == ("roslaunch", "mpc", "mpc.launch")
    assert [*_sought(decision)] == found
    told = [each.message for each in decision.warnings if "needs the package" in each.message]
    assert all(
        f"stops without it: the build looks for it in {url};" in each for each, url in zip(told, found, strict=True)
    )


@pytest.mark.parametrize(
    ("needed", "looked"),
    [("acme-util", True), ("other-util", False), ("acme-util-dev", False), ("acme-pip", False), ("acme_x-util", False)],
)
def test_a_sibling_may_have_a_dash_in_its_name(tree: Tree, needed: str, looked: bool) -> None:
    decision = tree(_git(f"{LAB}/acme-core") | _package("acme-core", needed) | {"README.md": "ROS Noetic.\n"})
    assert _sought(decision) == ({f"{LAB}/{needed}": (needed,)} if looked else {})


@pytest.mark.parametrize(("folder", "found"), [("acme_stack", []), ("acme", ["https://github.com/other/acme_stack"])])
def test_a_clone_is_not_looked_in_where_the_tree_has_its_folder(tree: Tree, folder: str, found: list[str]) -> None:
    page = "ROS Noetic.\n\n    git clone https://github.com/other/acme_stack\n"
    package = {f"src/{path}": text for path, text in _package("mpc", "big_acme").items()}
    copied = {f"src/{folder}/{path.rpartition('/')[2]}": text for path, text in _package("acme_stacks").items()}
    decision = tree({**package, **copied, "src/mpc/README.md": page})
    assert [*_sought(decision)] == found
    assert not any("not cloned" in each.message for each in decision.warnings)


@pytest.mark.parametrize(
    ("needed", "cloned", "found"),
    [("mav_acts", "mav_comm", ["https://github.com/other/mav_comm"]), ("ros_acts", "ros_comm", [])],
)
def test_a_clone_that_begins_with_the_same_word_may_hold_it(
    tree: Tree, needed: str, cloned: str, found: list[str]
) -> None:
    page = f"ROS Noetic.\n\n    git clone https://github.com/other/{cloned}\n"
    decision = tree(_package("mpc", needed) | {"README.md": page})
    assert [*_sought(decision)] == found
    assert any("not cloned" in each.message for each in decision.warnings) is not bool(found)


@pytest.mark.parametrize(
    ("where", "tried"),
    [("mpc/README.md", True), ("other/README.md", False)],
)
def test_what_no_clone_is_called_like_is_tried_in_the_clones_of_the_page(tree: Tree, where: str, tried: bool) -> None:
    clones = [f"https://github.com/third/{name}-pkgs.git" for name in ("convenience", "general")]
    lines = "\n".join(f"git clone {each}" for each in clones)
    page = f"# Install\nOn ROS Noetic.\n```\nmkdir -p ~/catkin_ws/src\ncd ~/catkin_ws/src\n{lines}\n```\n"
    files = _git(f"{LAB}/mpc.git") | _package("mpc", "convenience_functions", "quad_x")
    found = _sought(tree(files | _package("other") | {"README.md": "# Robots\n", where: page}))
    assert (found.get("https://github.com/third/general-pkgs") == ("quad_x",)) is tried


def test_a_collection_of_the_table_holds_no_package_of_another_family(tree: Tree) -> None:
    files = _git(f"{LAB}/scan.git") | _package("scan", "moveit_calibration_plugins", "quad_x")
    decision = tree(files | {"README.md": "ROS Noetic.\n"})
    assert [source.name for source in decision.source if not source.holding] == ["moveit_calibration"]
    assert _sought(decision) == {f"{LAB}/quad_x": ("quad_x",)}
    assert any("nothing is known that brings quad_x" in each.message for each in decision.warnings)


def test_a_package_that_only_a_launch_file_starts_comes_from_the_table(tree: Tree) -> None:
    launch = '<launch><include file="$(find rm_bringup)/launch/rm_robot.launch"/></launch>'
    files = _git(f"{LAB}/pick.git") | _package("pick") | {"pick/launch/start.launch": launch}
    decision = tree(files | {"README.md": "ROS Noetic.\n```\nroslaunch pick start.launch\n```\n"})
    assert [source.repo for source in decision.source] == ["https://github.com/RealManRobot/rm_robot.git"]


@pytest.mark.parametrize(
    ("comment", "found"),
    [
        ("// BUG : https://github.com/other/quad/issues/136", ["https://github.com/other/quad"]),
        ("// from https://github.com/other/quad_x/blob/main/a.cpp", ["https://github.com/other/quad_x"]),
        ("// from https://github.com/other/squad", []),
        ("// from https://github.com/lab/mpc", []),
    ],
)
def test_an_address_in_the_code_that_is_called_like_what_is_unknown(tree: Tree, comment: str, found: list[str]) -> None:
    files = _git(f"{LAB}/mpc.git") | _package("mpc", "quad_x", "roscpp") | {"mpc/src/a.cpp": f"{comment}\n"}
    assert _sought(tree(files | {"README.md": "ROS Noetic.\n"})) == dict.fromkeys(
        [*found, f"{LAB}/quad_x"], ("quad_x",)
    )


def test_a_listed_link_to_what_pip_installs_holds_none(tree: Tree) -> None:
    files = _git(f"{LAB}/mpc.git") | _package("mpc", "quad_x", "roscpp") | {"requirements.txt": "dynamixel-sdk\n"}
    page = f"ROS Noetic.\n# Dependencies\n* [a]({THIRD}/DynamixelSDK)\n* [b]({THIRD}/whole)\n"
    assert list(_sought(tree(files | {"README.md": page}))) == [f"{THIRD}/whole", f"{LAB}/quad_x"]


@pytest.mark.parametrize(("needed", "looked"), [("quad_x", False), ("quad_airsim", True)])
def test_a_listed_link_to_a_module_that_pip_brings_holds_what_is_called_like_it(
    tree: Tree, needed: str, looked: bool
) -> None:
    files = _git(f"{LAB}/mpc.git") | _package("mpc", needed, "roscpp")
    page = f"ROS Noetic.\n# Dependencies\n* [a]({THIRD}/AirSim)\n* [b]({THIRD}/whole)\n"
    found = _sought(tree(files | {"README.md": page}))
    assert (f"{THIRD}/AirSim" in found, f"{THIRD}/whole" in found) == (looked, True)


@pytest.mark.parametrize(("name", "looked"), [("drone_ws", False), ("drone_parts", True)])
def test_nothing_is_looked_for_in_the_repository_itself_under_its_former_owner(
    tree: Tree, name: str, looked: bool
) -> None:
    page = f"```\ncd ~/\ngit clone --recurse-submodules https://github.com/former/{name}.git\n```\n"
    decision = tree(_git(f"{LAB}/drone_ws.git") | _package("src/mpc", "quad_x") | {"README.md": f"ROS Noetic.\n{page}"})
    assert (f"https://github.com/former/{name}" in _sought(decision)) is looked


@pytest.mark.parametrize(
    ("lines", "ref"),
    [
        (("git clone -b mbzirc {}",), "mbzirc"),
        (("git clone {}",), None),
        (("# git clone -b mbzirc {}", "git clone {}"), None),
        (("git clone -b melodic-devel {}", "git clone -b noetic-devel {}"), "noetic-devel"),
        (("git clone -b melodic-devel {}",), None),
        (("git clone {} && cd arm_tools && git checkout v1.2",), "v1.2"),
    ],
)
def test_the_branch_that_a_script_clones_is_looked_in(tree: Tree, lines: tuple[str, ...], ref: str | None) -> None:
    script = "\n".join(line.format(f"{LAB}/arm_tools.git") for line in lines)
    files = _git(f"{LAB}/mpc") | _package("mpc", "quad_x") | {"script/setup_ws.sh": f"cd src\n{script}\n"}
    decision = tree(files | {"README.md": "ROS Noetic.\n"})
    (found,) = [source for source in decision.source if source.name == "arm_tools"]
    assert (found.holding, found.ref) == (("quad_x",), ref)


def test_no_more_than_five_of_a_section_about_other_packages_are_tried(tree: Tree) -> None:
    page = "ROS Noetic.\n# Other relevant packages\n" + "".join(f"* {THIRD}/part{n}\n" for n in range(9))
    decision = tree(_git(f"{LAB}/mpc") | _package("mpc", "quad_x") | {"README.md": page})
    assert list(_sought(decision)) == [*(f"{THIRD}/part{n}" for n in range(5)), f"{LAB}/quad_x"]


@pytest.mark.parametrize(
    ("link", "ref"),
    [
        (f"{LAB}/control", None),
        (f"{LAB}/control/tree/our-branch", "our-branch"),
        (f"{LAB}/control/tree/main", None),
        (f"{LAB}/control/tree/noetic-devel", "noetic-devel"),
        (f"{LAB}/control/tree/melodic-devel", None),
    ],
)
def test_the_branch_that_a_link_names_is_taken(tree: Tree, link: str, ref: str | None) -> None:
    page = {"README.md": f"ROS Noetic.\nUsed with {link}\n"}
    decision = tree(_git(f"{LAB}/mpc") | _package("mpc", "quad_x") | page)
    assert [each.ref for each in decision.source if each.name == "control"] == [ref]


@pytest.mark.parametrize(
    ("title", "needed", "looked"),
    [
        ("## Dependencies", "voice_menu", True),
        ("## Dependencies", "stack_menu", False),  # a clone is called like it
        ("## Related work", "voice_menu", False),
    ],
)
def test_what_a_clone_may_hold_is_looked_for_in_what_a_page_lists_as_needed(
    tree: Tree, title: str, needed: str, looked: bool
) -> None:
    listed = f"{title}\n\n- talking: https://github.com/other/talking\n"
    clone = "    cd ~/catkin_ws/src\n    git clone https://github.com/other/stack\n    catkin_make\n"
    page = f"ROS Noetic.\n\n{listed}\n## Build\n\n{clone}"
    decision = tree(_git(f"{LAB}/mpc") | _package("mpc", needed) | {"README.md": page})
    assert "stack" in {source.name for source in decision.source if not source.holding}
    assert _sought(decision) == ({"https://github.com/other/talking": (needed,)} if looked else {})


@pytest.mark.parametrize(("folder", "looked"), [("arm_common", False), ("arm_other", True)])
def test_a_repository_of_which_the_tree_has_a_copy_is_not_looked_into(tree: Tree, folder: str, looked: bool) -> None:
    """Its clone would lie in the folder of the copy."""
    copied = {f"src/{folder}/{path}": text for name in ("arm", "arm_msgs") for path, text in _package(name).items()}
    own = {f"src/{path}": text for path, text in _package("quad", "arm_sim").items()}
    page = "# Quad\nROS Noetic, with the model of https://github.com/arms/arm-common\n"
    found = _sought(tree({**copied, **own, "README.md": page}))
    assert ("https://github.com/arms/arm-common" in found) is looked


@pytest.mark.parametrize(
    ("own", "sought"),
    [
        ("lab-ros1-common", ["lab-core-common", "lab_core_common", "lab-core", "lab_core"]),
        ("lab_ros1-common", ["lab_core_common", "lab_core"]),
        ("common", ["lab_core_common", "lab_core"]),
    ],
)
def test_an_owner_who_writes_repositories_with_dashes_does_so_for_others(
    tree: Tree, own: str, sought: list[str]
) -> None:
    files = _package("lab_utils", "lab_core_common") | _git(f"{LAB}/{own}.git")
    assert list(_sought(tree(files))) == [f"{LAB}/{each}" for each in sought]
