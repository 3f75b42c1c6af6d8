"""What the default command's launch file cannot do without is told where nothing gives it: a variable, a package."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
}
NODE = '<node pkg="demo" type="a" name="a"/>'


def told(tree: Tree, launch: str, more: dict[str, str] | None = None) -> list[tuple[str, int]]:
    decision = tree({**PACKAGE, "launch/demo.launch": f"<launch>\n{launch}{NODE}</launch>", **(more or {})})
    assert decision.command == ("roslaunch", "demo", "demo.launch")
    found = [warning for warning in decision.warnings if "needs the variable" in warning.message]
    assert all(warning.file == "launch/demo.launch" and "`env` in roslab.yaml" in warning.message for warning in found)
    return [(warning.message.partition("variable ")[2].partition(",")[0], warning.line or 0) for warning in found]


@pytest.mark.parametrize(
    ("launch", "found"),
    [
        ('<param name="a" value="$(env ROBOT)/a"/>\n', [("ROBOT", 2)]),
        ('<arg name="robot" default="$(optenv ROBOT)"/>\n<group ns="$(arg robot)"/>\n', [("ROBOT", 3)]),
        ('<include ns="$(optenv ROBOT)" file="a.xml"/>\n', [("ROBOT", 2)]),
        ('<arg name="a" default="$(optenv FILE)"/>\n<rosparam file="$(arg a)"/>\n', [("FILE", 3)]),
        ('<arg name="robot" default="$(optenv ROBOT uav1)"/>\n<group ns="$(arg robot)"/>\n', []),
        ('<arg name="robot" default="$(optenv ROBOT)"/>\n<group ns="/$(arg robot)"/>\n', []),
        ('<arg name="robot" default="$(optenv ROBOT)"/>\n<param name="a" value="$(arg robot)"/>\n', []),
        ('<arg name="real" default="0"/><group if="$(arg real)"><param name="a" value="$(env ROBOT)"/></group>\n', []),
        ('<!-- $(env ROBOT) -->\n<param name="a" value="$(env HOME)/$(env ROS_DISTRO)"/>\n', []),
        ('<param name="a" value="/home/$(env USER)/$(env LOGNAME)"/>\n', []),
    ],
)
def test_what_nothing_sets(tree: Tree, launch: str, found: list[tuple[str, int]]) -> None:
    assert told(tree, launch) == found


def test_what_is_set_is_not_told(tree: Tree) -> None:
    launch = '<param name="a" value="$(env ROBOT)"/>\n'
    page = {"README.md": "ROS Noetic\n```\nexport ROBOT=uav1\nroslaunch demo demo.launch\n```\n"}
    assert not told(tree, launch, page)


@pytest.mark.parametrize(("package", "found"), [("turtlebot_gazebo", []), ("turtlebot_msgs", [("TURTLEBOT_BASE", 2)])])
def test_what_a_hook_of_an_installed_package_sets_is_not_told(
    tree: Tree, package: str, found: list[tuple[str, int]]
) -> None:
    base = '<arg name="base" value="$(env TURTLEBOT_BASE)"/>\n'
    assert told(tree, f'{base}<include file="$(find {package})/a.launch"/>\n') == found
    manifest = PACKAGE["package.xml"].replace("</package>", f"<run_depend>{package}</run_depend></package>")
    assert told(tree, base, {"package.xml": manifest}) == found


def test_that_of_another_launch_file_is_not_told(tree: Tree) -> None:
    launch = '<param name="a" value="$(env ROBOT)"/>\n'
    assert not told(tree, "", {"launch/other.launch": f"<launch>{launch}</launch>"})


@pytest.mark.parametrize(
    ("launch", "more", "found"),
    [
        ('<include file="$(find demo_extras)/a.launch"/>\n', "", [("demo_extras", 2)]),
        ('<node pkg="demo_extras" type="a" name="b"/>\n', "", [("demo_extras", 2)]),
        ('<include file="$(find rviz)/a.launch"/>\n', "", []),
        (
            '<arg name="b" default="0"/><group if="$(arg b)"><node pkg="demo_extras" type="a" name="b"/></group>\n',
            "",
            [],
        ),
        (
            """<arg name="b" default="n"/><include if="$(eval (b in ['y', 'n']))" file="$(find extras)/a.launch"/>\n""",
            "",
            [("extras", 2)],
        ),
        (
            """<arg name="b" default="off"/><include if="$(eval (b == 'on'))" file="$(find extras)/a.launch"/>\n""",
            "",
            [],
        ),
        (
            '<include file="$(find demo_extras)/a.launch"/>\n',
            "cd src\ngit clone https://github.com/lab/demo_extras\n",
            [],
        ),
    ],
)
def test_packages_that_nothing_brings(tree: Tree, launch: str, more: str, found: list[tuple[str, int]]) -> None:
    page = f"ROS Noetic\n```\n{more}catkin_make\nroslaunch demo demo.launch\n```\n"
    files = {**PACKAGE, "launch/demo.launch": f"<launch>\n{launch}{NODE}</launch>", "README.md": page}
    warnings = [each for each in tree(files).warnings if "needs the package" in each.message]
    assert all(each.file == "launch/demo.launch" and "`source` in roslab.yaml" in each.message for each in warnings)
    assert [(each.message.partition("package ")[2].partition(",")[0], each.line) for each in warnings] == found


@pytest.mark.parametrize(("key", "held"), [("", True), ("demo_extras", False)])
def test_packages_that_clones_may_hold_and_keys_that_nothing_brings(tree: Tree, key: str, held: bool) -> None:
    launch = '<include file="$(find demo_extras)/a.launch"/>'
    manifest = PACKAGE["package.xml"].replace("</package>", f"<exec_depend>{key}</exec_depend></package>")
    clone = "cd src\ngit clone https://github.com/lab/stack\n" if held else ""
    page = f"ROS Noetic\n```\n{clone}catkin_make\nroslaunch demo demo.launch\n```\n"
    files = {**PACKAGE, "package.xml": manifest} if key else PACKAGE
    decision = tree({**files, "launch/demo.launch": f"<launch>{launch}{NODE}</launch>", "README.md": page})
    told = [each.message for each in decision.warnings if "needs the package demo_extras" in each.message]
    assert ["one of the cloned repositories may hold it" in each for each in told] == [held]


GAZEBO = '<param name="robot_description" command="xacro $(find demo)/urdf/a.xacro"/>\n'
INCLUDE = '<include file="$(find demo)/launch/b.launch"/>\n'
WORLD = '<node pkg="demo" type="world.py" name="w"/>\n'
FOUND = '<xacro:include filename="$(find demo_arms)/a.xacro"/>'
MACRO = f'<xacro:macro params="x" name="b">{FOUND}</xacro:macro>'
CALLED = '<xacro:b x="1"><origin/></xacro:b>'
INDIRECT = f'<xacro:macro name="c" params="x">{CALLED}</xacro:macro>'
IF = f'<xacro:if value="{{}}">{FOUND}</xacro:if>'
ARG = '<xacro:arg name="sim" default="{}"/>' + IF.format("$(arg sim)")
PROPERTY = '<xacro:property name="on" value="{}"/>'
SWITCHED = '<xacro:macro name="d" params="a on:=true kind:=\'ur5\' *o">{}</xacro:macro>'
IN_MACRO = SWITCHED.format(IF.format("${on}"))
DECIDED = [
    (IF.format("true"), True),
    (IF.format("0"), False),
    (f'<xacro:unless value="false">{FOUND}</xacro:unless>', True),
    (f'<xacro:unless value="${{lost}}">{FOUND}</xacro:unless>', False),
    (ARG.format("true"), True),
    (ARG.format("false"), False),
    (PROPERTY.format("true") + IF.format("${on}"), True),
    (PROPERTY.format("false") + PROPERTY.format("true") + IF.format("${on}"), False),
    (PROPERTY.format("$(arg lost)") + IF.format("${on}"), False),
    (PROPERTY.format("a") + IF.format("${on == 'a' and not 1 == 2}"), True),
    (IN_MACRO, False),
    (IN_MACRO + '<xacro:d a="1"/>', True),
    (IN_MACRO + '<xacro:d a="1" on="false"/>', False),
    (IN_MACRO + '<xacro:d a="1" on="false"/><xacro:d a="2" on="true"/>', True),
    (IN_MACRO + '<xacro:d a="1" on="${lost}"/>', False),
    (PROPERTY.format("true") + IN_MACRO + '<xacro:d a="1" on="${on}"/>', True),
    (SWITCHED.format(IF.format("${kind == 'ur5'}")) + '<xacro:d a="1"/>', True),
    (SWITCHED.format(IF.format("${kind == 'ur5'}")) + '<xacro:d a="1" kind="ur3"/>', False),
    (SWITCHED.format(IF.format("${a == 1}")) + '<xacro:d a="1"/>', True),
    (SWITCHED.format('<xacro:if value="${on}"><xacro:if value="$(arg x)">' + FOUND) + '<xacro:d a="1"/>', False),
    (
        SWITCHED.format('<xacro:if value="${on}"><xacro:e/></xacro:if>') + MACRO.replace('"b"', '"e"') + "<xacro:d/>",
        True,
    ),
    (IN_MACRO + '<xacro:if value="$(arg x)"><xacro:d a="1"/></xacro:if>', False),
    (
        '<xacro:macro name="r" params="n"><xacro:if value="1"><xacro:r n="${n}1"/></xacro:if></xacro:macro><xacro:r/>',
        False,
    ),
]
LOADED = '<xacro:include filename="$(find demo)/urdf/b.xacro"/>'
ASKS = "import rospkg\ndef main():\n    {before}rospkg.RosPack().get_path('demo_arms')\n"


@pytest.mark.parametrize(
    ("launch", "files", "where"),
    [
        (
            INCLUDE,
            {"launch/b.launch": '<launch>\n<node pkg="demo_arms" type="a" name="b"/></launch>'},
            "launch/b.launch",
        ),
        (
            INCLUDE,
            {"launch/b.launch": f"<launch>{GAZEBO}</launch>", "urdf/a.xacro": f"<robot>\n{FOUND}"},
            "urdf/a.xacro",
        ),
        (GAZEBO, {"urdf/a.xacro": f"<robot>{FOUND}</robot>"}, "urdf/a.xacro"),
        (GAZEBO, {"urdf/a.xacro": f'<robot><xacro:if value="$(arg b)">{FOUND}</xacro:if></robot>'}, ""),
        (GAZEBO, {"urdf/a.xacro": f'<robot><xacro:macro name="b">{FOUND}</xacro:macro></robot>'}, ""),
        (GAZEBO, {"urdf/a.xacro": MACRO + CALLED}, "urdf/a.xacro"),
        (GAZEBO, {"urdf/a.xacro": MACRO + INDIRECT + '<xacro:c x="1"/>'}, "urdf/a.xacro"),
        (GAZEBO, {"urdf/a.xacro": MACRO + INDIRECT}, ""),
        (GAZEBO, {"urdf/a.xacro": f'{MACRO}<xacro:if value="$(arg b)">{CALLED}</xacro:if>'}, ""),
        (GAZEBO, {"urdf/a.xacro": LOADED + CALLED, "urdf/b.xacro": MACRO}, "urdf/b.xacro"),
        *((GAZEBO, {"urdf/a.xacro": text}, "urdf/a.xacro" if read else "") for text, read in DECIDED),
        (GAZEBO.replace(".xacro", ".xacro sim:=$(arg s)"), {"urdf/a.xacro": ARG.format("true")}, ""),
        (GAZEBO, {"urdf/a.xacro": LOADED, "urdf/b.xacro": MACRO}, ""),
        (GAZEBO, {"urdf/a.xacro": LOADED + MACRO, "urdf/b.xacro": CALLED}, "urdf/a.xacro"),
        (GAZEBO, {"urdf/a.xacro": f"<robot><!-- {FOUND} --></robot>"}, ""),
        (GAZEBO, {"urdf/a.xacro": FOUND.replace("demo_arms", "rviz")}, ""),
        (GAZEBO, {"urdf/a.xacro": FOUND.replace("demo_arms", "sns_ik_lib")}, "urdf/a.xacro"),
        (GAZEBO, {"urdf/b.xacro": FOUND}, ""),
        (GAZEBO.replace("<param", '<param if="$(arg b)"'), {"urdf/a.xacro": FOUND}, ""),
        (WORLD, {"scripts/world.py": ASKS.format(before="")}, "scripts/world.py"),
        (WORLD, {"scripts/world.py": ASKS.format(before="if a:\n        ")}, ""),
        (WORLD, {"scripts/world.py": ASKS.format(before="try:\n        ")}, ""),
        (WORLD, {"scripts/world.py": ASKS.replace("demo_arms", "tf").format(before="")}, ""),
    ],
)
def test_packages_that_what_it_starts_needs(tree: Tree, launch: str, files: dict[str, str], where: str) -> None:
    page = {"README.md": "ROS Noetic\n```\ncatkin_make\nroslaunch demo demo.launch\n```\n"}
    decision = tree({**PACKAGE, "launch/demo.launch": f"<launch>\n{launch}{NODE}</launch>", **page, **files})
    found = [each.file for each in decision.warnings if "needs the package" in each.message]
    assert found == ([where] if where else [])


def test_what_a_program_looks_for_is_installed(tree: Tree) -> None:
    files = {"launch/demo.launch": f"<launch>\n{WORLD}</launch>", "scripts/world.py": ASKS.format(before="")}
    files["scripts/world.py"] = files["scripts/world.py"].replace("demo_arms", "rviz")
    decision = tree({**PACKAGE, **files, "README.md": "ROS Noetic\n"})
    assert "ros-noetic-rviz" in (*decision.apt, *decision.apt_guessed)


@pytest.mark.parametrize(("asked", "command"), [("demo_arms", ("bash",)), ("tf", ("roslaunch", "demo", "demo.launch"))])
def test_a_lone_launch_file_whose_program_stops_is_no_command(tree: Tree, asked: str, command: tuple[str, ...]) -> None:
    program = ASKS.replace("demo_arms", asked).format(before="")
    files = {"launch/demo.launch": f"<launch>\n{WORLD}</launch>", "scripts/world.py": program}
    assert tree({**PACKAGE, **files, "README.md": "ROS Noetic\n"}).command == command


CONDA = "/home/somebody/anaconda2/bin/python"


@pytest.mark.parametrize(
    ("first", "made", "linked", "told"),
    [
        (f"#!{CONDA}", "", [(CONDA, "python3")], []),
        ("#! /opt/miniconda3/envs/a/bin/python3.8", "", [("/opt/miniconda3/envs/a/bin/python3.8", "python3")], []),
        ("#!/root/miniconda3/bin/python", "", [], ["/root/miniconda3/bin/python"]),
        ("#!/home/somebody/bin/run-it", "", [], ["/home/somebody/bin/run-it"]),
        ("#!/usr/bin/env python", "", [], []),
        ("#!/usr/bin/python3", "", [], []),
        (f"#!{CONDA}", "catkin_install_python(PROGRAMS scripts/a.py DESTINATION bin)\n", [], []),
    ],
)
def test_an_interpreter_of_the_author_s_machine(
    tree: Tree, first: str, made: str, linked: list[tuple[str, str]], told: list[str]
) -> None:
    files = {**PACKAGE, "scripts/a.py": f"{first}\nprint(1)\n"}
    files["CMakeLists.txt"] += made
    files["launch/b.launch"] = '<launch><node pkg="demo" type="a.py" name="b"/></launch>'
    files["launch/demo.launch"] = f'<launch>{NODE}<include file="$(find demo)/launch/b.launch"/></launch>'
    files["README.md"] = "ROS Noetic\n```\nroslaunch demo demo.launch\n```\n"
    decision = tree(files)
    warnings = [warning for warning in decision.warnings if "first line names" in warning.message]
    assert [each.message.partition("first line names ")[2].partition(",")[0] for each in warnings] == told
    assert all((each.file, each.line) == ("scripts/a.py", 1) for each in warnings)
    assert list(decision.interpreters) == linked


def test_the_python_of_an_older_ros_stands_for_it(tree: Tree) -> None:
    files = {**PACKAGE, "scripts/a.py": f"#!{CONDA}\n", "README.md": "ROS Melodic\n"}
    files["launch/b.launch"] = '<launch><node pkg="demo" type="a.py" name="b"/></launch>'
    assert tree(files).interpreters == ((CONDA, "python2"),)
    rospy = "#!/home/joe/bin/python3\nimport rospy\n"
    assert tree({**files, "scripts/a.py": rospy}).interpreters == (), "rospy is Python 2's there"


@pytest.mark.parametrize(
    ("name", "imports", "page", "linked"),
    [
        ("python3", "import numpy, sys", "ROS Melodic\n", True),
        ("python3.6", "import odd_things\nfrom scipy.stats import entropy", "ROS Melodic\n", True),
        ("python3.5", "import numpy", "ROS Kinetic\n", True),
        ("python3.8", "import numpy", "ROS Melodic\n", False),
        ("python3.6", "import numpy\nfrom std_msgs.msg import Header", "ROS Melodic\n", False),
        ("python3.6", "import numpy, demo.more", "ROS Melodic\n", False),
        ("python3.6", "import rospkg", "ROS Melodic\n", True),
    ],
)
def test_a_program_for_python_3_that_imports_nothing_of_ros(
    tree: Tree, name: str, imports: str, page: str, *, linked: bool
) -> None:
    path = f"/home/joe/env/bin/{name}"
    files = {**PACKAGE, "scripts/a.py": f"#!{path}\n{imports}\n", "README.md": page}
    files["launch/b.launch"] = '<launch><node pkg="demo" type="a.py" name="b"/></launch>'
    decision = tree(files)
    assert decision.interpreters == (((path, "python3"),) if linked else ())
    assert any(path in each.message for each in decision.warnings) is not linked
    assert ("python3-numpy" in decision.apt_guessed) == ("numpy" in imports)
    assert ("python3-scipy" in decision.apt_guessed) == ("scipy" in imports)


@pytest.mark.parametrize(
    ("program", "told"),
    [
        ("import sys\nsys.path.insert(0, '/home/me/rl')\nfrom Manager import Manager\n", True),
        ("import sys\nrl = '/home/me/rl'\nsys.path.append(rl)\nimport Manager\n", True),
        ("import sys\nrl = '/home/me/rl'\nrl = find('rl')\nsys.path.append(rl)\nimport Manager\n", False),
        ("import sys\nsys.path.append('/home/me/rl')\nimport numpy, rospy, other\n", False),
        ("import sys\nif sys.argv[1:]:\n    sys.path.append('/home/me/rl')\nimport Manager\n", False),
        ("import sys\nsys.path.append('../rl')\nimport Manager\n", False),
    ],
)
def test_what_a_program_imports_from_a_folder_of_the_author_s(tree: Tree, program: str, told: bool) -> None:
    files = {**PACKAGE, "scripts/a.py": program, "other/other.py": ""}
    files["launch/demo.launch"] = '<launch><node pkg="demo" type="a.py" name="b"/></launch>'
    files["README.md"] = "ROS Noetic\n```\nroslaunch demo demo.launch\n```\n"
    found = [each for each in tree(files).warnings if "imports Manager and looks in /home/me/rl," in each.message]
    assert len(found) == told


INCLUDE = '<include file="$(find demo)/launch/{name}.launch"{more}/>\n'


@pytest.mark.parametrize(
    ("launch", "more", "where"),
    [
        (INCLUDE.format(name="map", more=""), {}, ("launch/demo.launch", 2)),
        (
            INCLUDE.format(name="other", more=""),
            {"launch/other.launch": f"<launch>\n\n{INCLUDE.format(name='map', more='')}</launch>"},
            ("launch/other.launch", 3),
        ),
        (INCLUDE.format(name="map", more=' if="$(arg a)"'), {}, None),
        (f"<!-- {INCLUDE.format(name='map', more='')} -->", {}, None),
        (INCLUDE.format(name="map", more=""), {"launch/map.launch.in": "<launch/>"}, None),
        (INCLUDE.format(name="map", more=""), {"files/map.launch": "<launch/>"}, None),  # it may be installed there
        (INCLUDE.format(name="map", more="").replace("demo", "nav2_bringup"), {}, None),
        ('<rosparam command="load" file="$(find demo)/config/a.yaml"/>', {}, None),
    ],
)
def test_launch_files_that_are_nowhere(
    tree: Tree, launch: str, more: dict[str, str], where: tuple[str, int] | None
) -> None:
    page = {"README.md": "`roslaunch demo demo.launch`\n"}
    decision = tree({**PACKAGE, **page, **more, "launch/demo.launch": f"<launch>\n{launch}{NODE}</launch>"})
    told = [w for w in decision.warnings if "includes map.launch of the package demo" in w.message]
    assert [(w.file, w.line) for w in told] == ([where] if where else [])


def test_one_that_includes_what_is_nowhere_is_no_guess(tree: Tree) -> None:
    files = {**PACKAGE, "launch/demo.launch": f"<launch>{INCLUDE.format(name='map', more='')}{NODE}</launch>"}
    assert tree(files).command == ("bash",)


@pytest.mark.parametrize(
    ("arg", "value", "found"),
    [
        ("", "true", True),
        ('<arg name="gui" default="True"/>', "$(arg gui)", True),
        ('<arg name="gui" default="false"/>', "$(arg gui)", False),
        ("", "false", False),
    ],
)
def test_the_window_of_the_joints_is_a_package_of_its_own(tree: Tree, arg: str, value: str, found: bool) -> None:
    node = f'<node pkg="joint_state_publisher" type="a" name="b"><param name="use_gui" value="{value}"/></node>'
    files = {"launch/demo.launch": f"<launch>{arg}{node}{NODE}</launch>", "README.md": "ROS Melodic\n"}
    assert ("ros-melodic-joint-state-publisher-gui" in tree({**PACKAGE, **files}).apt_guessed) is found
    older = tree({**PACKAGE, **files, "README.md": "ROS Indigo\n"})
    assert not any("joint-state-publisher-gui" in name for name in older.apt_guessed)
    assert not any("joint_state_publisher_gui" in each.message for each in older.warnings)


@pytest.mark.parametrize(
    ("launch", "more", "named"),
    [
        ('<include file="$(find demo_extras)/a.launch"/>', "", "demo_extras"),
        ('<node pkg="demo_a" type="a" name="b"/><node pkg="demo_b" type="a" name="c"/>', "", "demo_a, demo_b"),
        ('<node pkg="demo_a" type="a" name="b"/>', "cd src\ngit clone https://github.com/lab/demo_a\n", ""),
        ('<group if="$(arg b)"><node pkg="demo_a" type="a" name="b"/></group>', "", ""),
        ('<node pkg="tf" type="a" name="b"/>', "", ""),
    ],
)
def test_packages_of_other_launch_files(tree: Tree, launch: str, more: str, named: str) -> None:
    page = f"ROS Noetic\n```\n{more}catkin_make\nroslaunch demo demo.launch\n```\n"
    other = f"<launch>{NODE}\n{launch}</launch>"
    files = {"launch/demo.launch": f"<launch>{NODE}</launch>", "launch/other.launch": other, "README.md": page}
    decision = tree({**PACKAGE, **files})
    assert decision.command == ("roslaunch", "demo", "demo.launch")
    said = [w for w in decision.warnings if "launch files need packages" in w.message]
    assert [(w.message.partition("them: ")[2].partition(";")[0], w.file) for w in said] == (
        [(named, "launch/other.launch")] if named else []
    )


@pytest.mark.parametrize(
    ("given", "part", "told_of"),
    [
        ("true", "", ["acme_arm_description"]),
        ("false", "", []),
        ("true", "<!-- {} -->", []),
        ("$(arg load)", "", []),
    ],
)
def test_what_the_including_file_switches_on_is_needed(tree: Tree, given: str, part: str, told_of: list[str]) -> None:
    include = '<xacro:include filename="$(find acme_arm_description)/urdf/arm.xacro"/>'
    more = {
        "launch/context.launch": '<launch><arg name="load" default="false"/>\n<param if="$(arg load)" name="robot" '
        "command=\"xacro '$(find demo)/urdf/robot.urdf.xacro'\"/></launch>\n",
        "urdf/robot.urdf.xacro": f"<robot>{part.format(include) if part else include}</robot>\n",
        "README.md": "ROS Noetic\n```\nroslaunch demo demo.launch\n```\n",
    }
    launch = f'<include file="$(find demo)/launch/context.launch">\n<arg name="load" value="{given}"/>\n</include>\n'
    decision = tree({**PACKAGE, "launch/demo.launch": f"<launch>\n{launch}{NODE}</launch>", **more})
    words = [w.message for w in decision.warnings if w.message.startswith("the default command needs the package")]
    assert [message.split()[6].rstrip(",") for message in words] == told_of


def test_a_description_that_another_distribution_released_comes_from_its_repository(tree: Tree) -> None:
    more = {"README.md": "ROS Melodic\n```\nroslaunch demo demo.launch\n```\n"}
    load = '<param name="robot" command="xacro $(find demo)/robot.xacro"/>'
    more["robot.xacro"] = '<robot><xacro:include filename="$(find ur_e_description)/urdf/ur5e.urdf.xacro"/></robot>'
    decision = tree({**PACKAGE, "launch/demo.launch": f"<launch>{load}{NODE}</launch>", **more})
    assert [(each.name, each.ref) for each in decision.source] == [("universal_robot", "1.2.7")]
    assert not [w for w in decision.warnings if "ur_e_description" in w.message]


def test_moveits_demonstration_comes_before_the_one_in_gazebo(tree: Tree) -> None:
    parts = {f"launch/{name}.launch": f"<launch>{NODE}</launch>\n" for name in ("move_group", "rviz", "gazebo")}
    load = '<include file="$(find demo)/launch/{}.launch"/>'
    demo = {"launch/demo.launch": f"<launch>{load.format('move_group')}{load.format('rviz')}</launch>\n"}
    demo["launch/demo_gazebo.launch"] = demo["launch/demo.launch"].replace("</l", f"{load.format('gazebo')}</l")
    more = {f"launch/start_{number}.launch": f"<launch>{NODE}</launch>\n" for number in range(6)}
    manifest = PACKAGE["package.xml"].replace("demo", "arm")
    files = {
        file: text.replace("find demo", "find arm").replace('"demo"', '"arm"')
        for file, text in (parts | demo | more).items()
    }
    decision = tree({**PACKAGE, **files, "package.xml": manifest})
    assert decision.command == ("roslaunch", "arm", "demo.launch")


@pytest.mark.parametrize(("folder", "told_of"), [("", True), ("demo/", False)])
def test_a_submodule_inside_of_a_package_holds_no_other(tree: Tree, folder: str, *, told_of: bool) -> None:
    launches = {
        "launch/demo.launch": f"<launch>{NODE}</launch>",
        "launch/sim.launch": f'<launch><arg name="a" default="$(find px4)/a"/>{NODE}</launch>',
    }
    modules = '[submodule "a"]\n\tpath = external/solver\n\turl = https://github.com/lab/solver.git\n'
    files = {f"{folder}{path}": text for path, text in {**PACKAGE, **launches}.items()}
    decision = tree({**files, ".gitmodules": modules})
    found = [each for each in decision.warnings if "stop without them: px4" in each.message]
    assert bool(found) is told_of


TABLED = "<depend>kr_mav_manager</depend>"
GIT = {
    ".git/config": '[remote "origin"]\n\turl = https://github.com/lab/demo\n',
    ".git/HEAD": "ref: refs/heads/a\n",
}


def _launching(*names: str, depends: str = "") -> dict[str, str]:
    nodes = "".join(f'<node pkg="{name}" type="a" name="{name}"/>' for name in names)
    files = {"launch/demo.launch": f"<launch>{NODE}</launch>", "launch/other.launch": f"<launch>{NODE}{nodes}</launch>"}
    manifest = PACKAGE["package.xml"].replace("</package>", f"{depends}</package>")
    page = "ROS Noetic\n```\ncatkin_make\nroslaunch demo demo.launch\n```\n"
    return {**PACKAGE, **GIT, **files, "package.xml": manifest, "README.md": page}


def test_what_a_clone_has_under_a_longer_name_is_told_and_not_guessed(tree: Tree) -> None:
    decision = tree(_launching("trackers_manager", "best_widgets", "launch", depends=TABLED))
    assert [source.repo for source in decision.source if source.holding] == ["https://github.com/lab/best_widgets.git"]
    told = [each for each in decision.warnings if "write kr_trackers_manager for trackers_manager" in each.message]
    assert [(each.file, each.line) for each in told] == [("launch/other.launch", 1)]
    assert not [each for each in decision.warnings if "bring" in each.message and "trackers_manager" in each.message]


def test_a_key_that_the_table_finds_in_a_clone_is_there(tree: Tree) -> None:
    keys = f"{TABLED}<exec_depend>kr_trackers_manager</exec_depend><exec_depend>kr_other_part</exec_depend>"
    decision = tree(_launching(depends=keys))
    assert "kr_trackers_manager" in decision.skip_keys
    assert not [each for each in decision.warnings if "kr_trackers_manager" in each.message]
    assert "kr_other_part" not in decision.skip_keys


def test_packages_that_begin_alike_are_looked_for_together_first(tree: Tree) -> None:
    decision = tree(_launching("big_quad_utils", "big_quad_description", "big_tools", "small_quad_utils"))
    sought = [(source.name, source.holding) for source in decision.source]
    assert sought[0] == ("big_quad", ("big_quad_description", "big_quad_utils"))
    assert {name for name, _ in sought[1:]} == {
        "big_quad_utils",
        "big_quad_description",
        "big_tools",
        "small_quad_utils",
    }
