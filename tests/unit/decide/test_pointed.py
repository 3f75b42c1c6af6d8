"""Launch files and scripts that a page only names, choices in braces, and the compiler of a page."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
ROS1 = {
    "package.xml": PACKAGE,
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
    "launch/track.launch": "<launch/>",
    "launch/drive.launch": "<launch/>",
    "launch/debug.launch": "<launch/>",
}
CPP = {
    "CMakeLists.txt": "project(Demo)\nadd_executable(a a.cpp)\nadd_executable(b b.cpp)\n",
    "a.cpp": "#include <vector>\n",
    "scripts/run_stereo.sh": "./a\n",
    "scripts/run_mono.sh": "./b\n",
    "scripts/make_docs.sh": "doxygen\n",
    "scripts/push.sh": "./a --push\n",
}


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("The track.launch file loads the parameters.\n", "roslaunch demo track.launch"),
        ("See `launch/track.launch`.\n", "roslaunch demo track.launch"),
        ("See [it](./launch/track.launch).\n", "roslaunch demo track.launch"),
        ("Edit track.launch or drive.launch.\n", "bash"),
        ("Edit track.launch.\n# Usage\nStart drive.launch, then track.launch.\n", "roslaunch demo drive.launch"),
        ("See how to tune these for your joystick in `launch/track.launch`.\n", "bash"),
        ("> **Note** The gains can be adjusted in track.launch.\n", "bash"),
        ("Adjust the gains, then start track.launch.\n", "roslaunch demo track.launch"),
        ("To launch it with tuned gains, see track.launch.\n", "roslaunch demo track.launch"),
        ("After editing the parameters, use track.launch.\n", "roslaunch demo track.launch"),
        ("Once the gains are adjusted, try the launch file `track.launch`.\n", "roslaunch demo track.launch"),
        ("Edit the parameters that your robot uses in track.launch.\n", "bash"),
        ("Change the map to use in track.launch.\n", "bash"),
        ("The gains are tuned. See track.launch.\n", "roslaunch demo track.launch"),
        ("See other.launch.\n", "bash"),
        ("A sample is in [doc](doc/camera_sample.launch).\n", "bash"),
        ("```\ncat track.launch\n```\n", "bash"),
        ("See track.launch.\n```\nroslaunch demo drive.launch\n```\n", "roslaunch demo drive.launch"),
    ],
)
def test_a_launch_file_that_a_sentence_names(tree: Tree, page: str, command: str) -> None:
    sample = {"doc/camera_sample.launch": "<launch/>"}
    assert " ".join(tree(ROS1 | sample | {"README.md": f"ROS Noetic\n{page}"}).command) == command


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("## The launch files:\n- `demo/track.launch`: all\n- `debug.launch`\n", "roslaunch demo track.launch"),
        ("## Files\n- `demo/track.launch`: all\n- `debug.launch`\n", "roslaunch demo drive.launch"),
        ("## Launch files\nFor parameters of track.launch see there.\n", "roslaunch demo drive.launch"),
        (
            "## Launch files\n- `track.launch`\n## Run\n\n    roslaunch demo debug.launch\n",
            "roslaunch demo debug.launch",
        ),
    ],
)
def test_a_list_of_launch_files_at_the_root_goes_before_pages_below(tree: Tree, page: str, command: str) -> None:
    files = {f"demo/{path}": text for path, text in ROS1.items()}
    below = {"demo/README.md": "# Usage\n\n    roslaunch demo drive.launch\n"}
    assert " ".join(tree(files | below | {"README.md": f"ROS Noetic\n{page}"}).command) == command


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("# Run\nRefer to scripts/run_stereo.sh, or scripts/run_mono.sh.\n", "bash scripts/run_stereo.sh"),
        ("# About\nRefer to scripts/run_stereo.sh.\n", "bash"),
        ("# Run\nRefer to scripts/make_docs.sh.\n", "bash"),
        ("# Run\n`scripts/push.sh`, ``make_docs.sh`` contain the commands.\n", "bash scripts/push.sh"),
        ("# Run\nscripts/push.sh has all commands.\n", "bash scripts/push.sh"),
        ("# Run\nscripts/push.sh uploads the results.\n", "bash"),
        ("# Results\nscripts/push.sh, scripts/make_docs.sh contain the commands.\n", "bash"),
    ],
)
def test_a_script_that_a_section_about_running_names(tree: Tree, page: str, command: str) -> None:
    assert " ".join(tree(CPP | {"README.md": page}).command) == command


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("The example.py files shows the basic functionality. A rosbag is there.\n", "python3 scripts/example.py"),
        ("`scripts/plot_demo.py` demonstrates the plots.\n", "python3 scripts/plot_demo.py"),
        ("Change example.py to your needs.\n", "bash"),
        ("See how tools.py shows it.\n", "bash"),
        ("example.py shows it.\n```\nroslaunch demo drive.launch\n```\n", "roslaunch demo drive.launch"),
    ],
)
def test_an_example_of_which_a_sentence_says_what_it_shows(tree: Tree, page: str, command: str) -> None:
    names = ("example", "plot_demo", "tools")
    scripts = {f"scripts/{name}.py": "import matplotlib.pyplot as plt\nplt.show()\n" for name in names}
    decision = tree({**ROS1, **scripts, "README.md": f"ROS Noetic\n{page}"})
    assert " ".join(decision.command) == command
    assert decision.gui is command.startswith("python3")


@pytest.mark.parametrize("choice", ["{true, false}", "{true|false}", "{true,false}"])
def test_the_first_of_a_choice_is_taken(tree: Tree, choice: str) -> None:
    page = f"ROS Noetic\n```\nroslaunch demo track.launch rviz:={choice} rate:=9\n```\n"
    command = tree(ROS1 | {"README.md": page}).command
    assert command == ("roslaunch", "demo", "track.launch", "rviz:=true", "rate:=9")


@pytest.mark.parametrize(
    ("options", "exported"),
    [
        ("-D CMAKE_CXX_COMPILER=g++-10", ['export CXX="$(command -v g++-10 || command -v c++)"']),
        ("-DCMAKE_C_COMPILER:STRING=/usr/bin/clang-12", ['export CC="$(command -v clang-12 || command -v cc)"']),
        ("-DCMAKE_CXX_COMPILER=/opt/mine/g++", []),
    ],
)
def test_the_compiler_of_the_page(tmp_path: Path, options: str, exported: list[str]) -> None:
    for path, text in (CPP | {"README.md": f"```\ncmake -B build {options}\n```\n"}).items():
        target = tmp_path / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
    lines = dockerfile(plan_repository(tmp_path).plan).split("\n")
    found = [line.strip(" &\\") for line in lines if "command -v" in line and "export C" in line]
    assert found == exported


def test_a_page_that_speaks_of_cuda_changes_no_ubuntu(tree: Tree) -> None:
    files = CPP | {"README.md": "Ubuntu 18.04. CUDA 7.0 is optional.\n"}
    assert (tree(files).kind, tree(files).ubuntu) == ("cpp", "bionic")


def demanding(*arguments: str) -> dict[str, str]:
    """Return a package whose track.launch has these arguments and whose drive.launch has none."""
    return ROS1 | {"launch/track.launch": f"<launch>{''.join(arguments)}</launch>"}


@pytest.mark.parametrize(
    ("arguments", "stopped"),
    [
        ('<arg name="eye" doc="the arm\'s, if any"/>', True),
        ('<arg doc="a > b"\n  name="eye" />', True),
        ('<arg name="eye" default=""/>', False),
        ("<arg default='' name='eye'/>", False),
        ('<arg name="eye" value="left"/>', False),
        ('<arg name="eye" if="$(arg left)"/>', False),
        ('<!-- <arg name="eye"/> -->', False),
    ],
)
def test_a_launch_file_that_demands_an_argument_is_not_started_without(
    tree: Tree, arguments: str, stopped: bool
) -> None:
    decision = tree(demanding(arguments) | {"README.md": "ROS Noetic\n# Usage\nSee track.launch.\n"})
    assert " ".join(decision.command) == ("bash" if stopped else "roslaunch demo track.launch")
    assert ("roslaunch", "demo", "track.launch") in decision.command_candidates


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("roslaunch demo track.launch\nroslaunch demo drive.launch\n", "roslaunch demo drive.launch"),
        (
            "roslaunch demo track.launch\nroslaunch demo track.launch eye:=left\n",
            "roslaunch demo track.launch eye:=left",
        ),
        (
            "roslaunch demo track.launch eye:=left\nroslaunch demo drive.launch\n",
            "roslaunch demo track.launch eye:=left",
        ),
        ("roslaunch demo track.launch\n", "bash"),
        ("roslaunch demo track.launch eye:=<the eye>\n", "bash"),
    ],
)
def test_a_call_that_gives_what_its_launch_file_demands_comes_first(tree: Tree, page: str, command: str) -> None:
    files = demanding('<arg name="eye"/>') | {"README.md": f"ROS Noetic\n# Usage\n```\n{page}```\n"}
    assert " ".join(tree(files).command) == command


def test_the_shell_tells_what_the_launch_file_of_the_page_demands(tree: Tree) -> None:
    page = "ROS Noetic\n```\nroslaunch demo track.launch eye:=<the eye>\n```\n"
    decision = tree(demanding('<arg name="eye"/>') | {"README.md": page})
    told = [f"{each.file}:{each.line}: {each.message}" for each in decision.warnings if "eye" in each.message]
    runs = "README.md:3: the README runs roslaunch demo track.launch, which stops without eye"
    assert told == [f"{runs}: give the whole command under `command` in roslab.yaml"]


@pytest.mark.parametrize(
    ("argument", "page", "command"),
    [
        ("robot_ip", "roslaunch demo track.launch robot_ip:=<IP>\n", "roslaunch demo track.launch robot_ip:=127.0.0.1"),
        ("hostname", "roslaunch demo track.launch\n", "roslaunch demo track.launch hostname:=127.0.0.1"),
        ("robot_ip", "roslaunch demo track.launch\nroslaunch demo drive.launch\n", "roslaunch demo drive.launch"),
        ("mac_address", "roslaunch demo track.launch\n", "bash"),
        ("ship", "roslaunch demo track.launch\n", "bash"),
    ],
)
def test_an_address_that_a_launch_file_demands_is_the_machines_own(
    tree: Tree, argument: str, page: str, command: str
) -> None:
    files = demanding(f'<arg name="{argument}"/>') | {"README.md": f"ROS Noetic\n# Usage\n```\n{page}```\n"}
    decision = tree(files)
    assert " ".join(decision.command) == command
    here = [each.message for each in decision.warnings if "127.0.0.1 for" in each.message]
    assert len(here) == command.count("127.0.0.1")


OF_ROBOTS = (
    '<arg name="robot" default="panda"/><arg name="arm" default="$(arg robot)"/>'
    "<group if=\"$(eval arg('arm') == 'panda')\"><arg name=\"hand\"/></group>"
)


@pytest.mark.parametrize(
    ("arguments", "given", "whole"),
    [
        (OF_ROBOTS, "", False),
        (OF_ROBOTS, " robot:=pr2", True),
        (OF_ROBOTS, " arm:=pr2", True),
        (OF_ROBOTS, " robot:=pr2 arm:=panda", False),
        (OF_ROBOTS.replace("==", "!="), "", True),
        (OF_ROBOTS.replace("==", "!="), " robot:=pr2", False),
        (OF_ROBOTS.replace("arg('arm')", "robot"), " robot:=pr2", True),
        (OF_ROBOTS.replace("<group if", "<group unless"), "", True),
        ('<arg name="real" default="false"/><group if="$(arg real)"><arg name="ip"/></group>', "", True),
        ('<arg name="real" default="false"/><group if="$(arg real)"><arg name="ip"/></group>', " real:=true", False),
        ('<arg name="real" default="false"/><group if="$(arg real)"><arg name="a" value=""/></group>', "", True),
        ('<arg name="real" default="false"/><include file="a" if="$(arg real)"/><arg name="ip"/>', "", False),
        ('<arg name="real"/><group if="$(arg real)"><arg name="ip"/></group>', " real:=false", True),
        (f'{OF_ROBOTS}<group unless="$(arg robot)"><arg name="hand"/></group>', " robot:=pr2", False),
    ],
)
def test_an_argument_in_a_part_that_is_left_out_is_not_demanded(
    tree: Tree, arguments: str, given: str, *, whole: bool
) -> None:
    page = f"ROS Noetic\n```\nroslaunch demo track.launch{given}\nroslaunch demo drive.launch\n```\n"
    decision = tree(demanding(arguments) | {"README.md": page})
    assert " ".join(decision.command) == (
        f"roslaunch demo track.launch{given}" if whole else "roslaunch demo drive.launch"
    )


IN_PYTHON = (
    "from launch import LaunchDescription\ndef generate_launch_description():\n    return LaunchDescription([{}])\n"
)
ROS2 = {
    "package.xml": "<package><name>demo</name><export><build_type>ament_python</build_type></export></package>",
    "setup.py": "from setuptools import setup\nsetup(name='demo')\n",
}


@pytest.mark.parametrize(
    ("declared", "stopped"),
    [
        ("DeclareLaunchArgument('map', description='the map (a file)')", True),
        (
            (
                "DeclareLaunchArgument('real', default_value='false'), GroupAction([DeclareLaunchArgument('map')], "
                "condition=IfCondition(LaunchConfiguration('real')))"
            ),
            False,
        ),
        ('DeclareLaunchArgument(\n        name="map",\n        description=str(1),\n    )', True),
        ("DeclareLaunchArgument('map', default_value=os.path.join(get('demo'), 'a.yaml'), description='b')", False),
        ("DeclareLaunchArgument('map', **options)", False),
        ("DeclareLaunchArgument('map', condition=IfCondition(known))", False),
        ("DeclareLaunchArgument(name)", False),
    ],
)
def test_a_launch_file_in_python_may_demand_an_argument(tree: Tree, declared: str, stopped: bool) -> None:
    files = ROS2 | {"launch/demo.launch.py": IN_PYTHON.format(declared), "launch/bring.launch.py": IN_PYTHON.format("")}
    first = "bring" if stopped else "demo"
    assert tree(files | {"README.md": "ROS Humble\n"}).command[-1] == f"{first}.launch.py"
    page = "```\nros2 launch demo demo.launch.py\nros2 launch demo bring.launch.py\n```\n"
    assert tree(files | {"README.md": f"ROS Humble\n{page}"}).command[-1] == f"{first}.launch.py"


@pytest.mark.parametrize(
    ("inside", "command"),
    [
        (
            '><arg name="eye" value="left"/><arg name="rate" value="9"/></include>',
            "roslaunch demo track.launch eye:=left",
        ),
        ('>\n  <!-- yours -->\n  <arg name="eye" value="left" />\n</include>', "roslaunch demo track.launch eye:=left"),
        ('><arg name="eye" value="$(arg eye)"/></include>', "bash"),
        ("/>", "bash"),
    ],
)
def test_a_launch_file_that_the_page_shows_how_to_include(tree: Tree, inside: str, command: str) -> None:
    page = f'ROS Noetic\n```xml\n<launch>\n  <include file="$(find demo)/launch/track.launch"{inside}\n</launch>\n```\n'
    assert " ".join(tree(demanding('<arg name="eye"/>') | {"README.md": page}).command) == command


def test_what_a_page_runs_comes_before_what_it_shows_how_to_include(tree: Tree) -> None:
    page = '```xml\n<include file="$(find demo)/launch/track.launch"/>\n```\n```\nroslaunch demo drive.launch\n```\n'
    assert tree(ROS1 | {"README.md": f"ROS Noetic\n{page}"}).command == ("roslaunch", "demo", "drive.launch")
    page = page.partition("```\n```")[0]
    assert tree(ROS1 | {"README.md": f"ROS Noetic\n{page}"}).command == ("roslaunch", "demo", "track.launch")


@pytest.mark.parametrize(
    ("said", "command"),
    [
        ("The main file to check the landing is ./fly_eval.py - on CUDA.", "python3 fly_eval.py"),
        ("The main script is `fly.py`.", "python3 fly.py"),
        ("`fly.py` is the entry point.", "python3 fly.py"),
        ("Just run fly.py and wait.", "python3 fly.py"),
        ("Do not run fly.py by itself.", "bash"),
        ("The network is in fly.py.", "bash"),
        ("The main file is gone.py.", "bash"),
        ("The main file is fly.py.\n```\npython fly_eval.py\n```", "python fly_eval.py"),
    ],
)
def test_a_program_that_a_sentence_calls_the_main_one(tree: Tree, said: str, command: str) -> None:
    main = "import numpy\nif __name__ == '__main__':\n    pass\n"
    files = {"fly.py": main, "fly_eval.py": main, "core.py": main, "requirements.txt": "numpy\n"}
    assert " ".join(tree({**files, "README.md": f"# Fly\n{said}\n"}).command) == command


def test_a_notebook_that_a_link_from_the_page_has_one_run(tree: Tree) -> None:
    page = "# Usage\n- Run the [tutorial](./tutorials/first.ipynb) to get started\n"
    files = {"requirements.txt": "numpy\n", "src/lab/run.py": "import numpy\nif __name__ == '__main__':\n    pass\n"}
    decision = tree({**files, "README.md": page, "tutorials/first.ipynb": "{}", "tutorials/second.ipynb": "{}"})
    assert decision.command == ("jupyter", "notebook", "--ip=0.0.0.0", "--no-browser", "tutorials/first.ipynb")
    assert "notebook" in [each.key for each in decision.python.pip_guessed]
