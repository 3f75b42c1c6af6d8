"""Packages that are never left out of a workspace: those without which the default command does not start."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

INCLUDES = '<include file="$(find {0})/launch/{0}.launch"{1}/>'
NODE = '<node pkg="{}" type="a" name="a"{}/>'
ONLY_IF = ' if="$(arg real)"'


def _package(name: str, *, launch: str = "", needs: str = "") -> dict[str, str]:
    depends = f"<depend>{needs}</depend>" if needs else ""
    files = {
        "package.xml": f"<package><name>{name}</name><buildtool_depend>catkin</buildtool_depend>{depends}</package>",
        "CMakeLists.txt": f"project({name})\nfind_package(catkin REQUIRED COMPONENTS {needs})\ncatkin_package()\n",
    }
    if launch:
        files[f"launch/{name}.launch"] = f"<launch>\n{launch}\n</launch>\n"
    return {f"{name}/{path}": text for path, text in files.items()}


def planned(root: Path, run: str, files: dict[str, str]) -> tuple[tuple[str, ...], str]:
    """Return the packages that must build where a README runs a command, and the Dockerfile."""
    page = f"ROS Noetic\n```\ncd src\ngit clone https://github.com/lab/stack\ncatkin_make\n{run}\n```\n"
    for path, text in {**files, "README.md": page}.items():
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(text)
    plan = plan_repository(root).plan
    return plan.workspace.must_build, dockerfile(plan)


TREE = {
    **_package("mine", launch=INCLUDES.format("arm", "") + NODE.format("rviz", "") + NODE.format("tools", ONLY_IF)),
    **_package("arm", launch=INCLUDES.format("driver", "") + NODE.format("acme_hand", "")),
    **_package("driver", launch=NODE.format("driver", ""), needs="acme_control"),
    **_package("tools", needs="acme_control"),
}
"""``acme_control`` and ``acme_hand`` are of nobody but perhaps of the clone."""


def test_what_its_launch_file_starts_or_includes_is_never_left_out(tmp_path: Path) -> None:
    must, text = planned(tmp_path, "roslaunch mine mine.launch", TREE)
    assert must == ("mine", "arm", "acme_hand"), "driver lacks what nobody has: the others start without it"
    folder = f"src/{tmp_path.name}"
    kept = "".join(f" --keep {name}" for name in must)
    assert f"leave-out-failed{kept} src/stack {folder}/driver {folder}/tools -- " in text


@pytest.mark.parametrize(
    ("run", "must"),
    [
        ("rosrun mine a", ("mine",)),
        ("roslaunch driver driver.launch real:=true", ("driver",)),
    ],
)
def test_another_command_needs_less(tmp_path: Path, run: str, must: tuple[str, ...]) -> None:
    assert planned(tmp_path, run, TREE)[0] == must


@pytest.mark.parametrize(
    "command", ["[bash, -c, roslaunch arm arm.launch]", "sleep 1 && roslaunch arm arm.launch a:=b; true"]
)
def test_a_launch_file_that_a_shell_starts(tmp_path: Path, command: str) -> None:
    (tmp_path / "roslab.yaml").write_text(f"format: 3\ncommand: {command}\n")
    assert planned(tmp_path, "", TREE)[0] == ("arm", "acme_hand")


def test_what_a_launch_file_of_ros_2_includes(tmp_path: Path) -> None:
    included = 'IncludeLaunchDescription(os.path.join(get_package_share_directory("arm"), "launch", "arm.launch.py"))'
    files = {
        path: text.replace("catkin", "ament_cmake").replace("ament_cmake_package", "ament_package")
        for path, text in {**_package("mine"), **_package("arm"), **_package("driver")}.items()
    }
    head = (
        "from launch import LaunchDescription\ndef generate_launch_description():\n    return LaunchDescription([{}])\n"
    )
    files["mine/launch/mine.launch.py"] = head.format(included)
    files["arm/launch/arm.launch.py"] = head.format('Node(package="driver", executable="a")')
    page = "ROS 2 Humble\n```\ncolcon build\nros2 launch mine mine.launch.py\n```\n"
    for path, text in {**files, "README.md": page}.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    assert plan_repository(tmp_path).plan.workspace.must_build == ("mine", "arm", "driver")


RUN = "<run_depend>task_0</run_depend><run_depend>task_1</run_depend>"
RUNS_TASKS = {"task_5/package.xml": f"<package><name>task_5</name>{RUN}</package>"}
LISTS_TASKS = {
    "all/package.xml": f"<package><name>all</name>{RUN}<export><metapackage/></export></package>",
    "all/CMakeLists.txt": "project(all)\nfind_package(catkin REQUIRED)\ncatkin_metapackage()\n",
}
SIX = {path: text for number in range(6) for path, text in _package(f"task_{number}").items()}


@pytest.mark.parametrize(
    ("more", "spare"),
    [
        ({}, 6),
        (_package("task_5", needs="task_0"), 5),
        (_package("task_0", launch=NODE.format("task_0", "")) | {"README.md": "`roslaunch task_0 task_0.launch`"}, 0),
        (RUNS_TASKS | LISTS_TASKS, 6),
        ({"roslab.yaml": "format: 3\ntest: rospack list\n"}, 0),
        ({"task_5/CATKIN_IGNORE": ""}, 0),
    ],
)
def test_what_no_other_package_needs_is_spare_where_a_shell_is_started(
    tmp_path: Path, more: dict[str, str], spare: int
) -> None:
    for path, text in {**SIX, **more}.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    plan = plan_repository(tmp_path).plan
    assert (len(plan.workspace.spare), plan.workspace.most_spare) == (spare, spare // 3)
    assert (f"leave-out-failed --most {spare // 3} --spare src/" in dockerfile(plan)) == bool(spare)


BRINGS = "".join(INCLUDES.format(f"task_{number}", "") for number in (1, 2))
LAUNCHED = {
    path: text
    for number in range(8)
    for path, text in _package(
        f"task_{number}", launch=NODE.format(f"task_{number}", "") + BRINGS * (not number), needs="lib" * (number == 3)
    ).items()
} | _package("lib")
ASKS = LAUNCHED["task_0/package.xml"].replace("</package>", "<run_depend>task_7</run_depend></package>")


@pytest.mark.parametrize(
    ("page", "more", "spare"),
    [
        ("# Tasks\n", {}, 5),
        ("# Tasks\n", {"task_0/package.xml": ASKS}, 4),
        ("`roslaunch task_0 task_0.launch`\n", {}, 0),
        ("Start it with task_0.launch of task_0\n", {}, 0),
    ],
)
def test_what_a_command_does_not_need_that_no_page_says_is_spare(
    tmp_path: Path, page: str, more: dict[str, str], spare: int
) -> None:
    for path, text in {**LAUNCHED, **more, "README.md": page}.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    plan = plan_repository(tmp_path).plan
    assert plan.run.command == ("roslaunch", "task_0", "task_0.launch")
    assert plan.workspace.must_build == ("task_0", "task_1", "task_2")
    folder = f"src/{tmp_path.name}/task_"
    asked = "".join(f" --spare {folder}{number}" for number in range(3, 3 + spare))
    assert (f" --keep task_2 --most {spare // 3}{asked} -- " in dockerfile(plan)) == bool(spare)


@pytest.mark.parametrize(
    ("code", "run", "said"),
    [
        ("#include <acme_tools/a.h>\n", "rosrun mine node", "stops without it at mine"),
        ("#ifdef WITH_ACME_TOOLS\n#include <acme_tools/a.h>\n#endif\n", "rosrun mine node", "goes on without it"),
        ("#include <other_tools/a.h>\n", "rosrun mine node", "goes on without it"),
        ("#include <acme_tools/a.h>\n", "", "goes on without it"),
    ],
)
def test_what_the_code_of_the_command_includes_stops_the_build(tmp_path: Path, code: str, run: str, said: str) -> None:
    git = {
        ".git/config": '[remote "origin"]\n\turl = https://github.com/lab/demo\n',
        ".git/HEAD": "ref: refs/heads/a\n",
    }
    page = {"README.md": f"ROS Noetic\n```\ncatkin_make\n{run}\n```\n"}
    cmake = {"mine/CMakeLists.txt": _package("mine")["mine/CMakeLists.txt"]}  # what CMake requires stops it anyway
    for path, text in {**_package("mine", needs="acme_tools"), **cmake, "mine/a.cpp": code, **git, **page}.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    warnings = [each.message for each in plan_repository(tmp_path).plan.warnings]
    assert [said in each for each in warnings if "no key acme_tools" in each] == [True]


@pytest.mark.parametrize(
    ("script", "must"),
    [
        ('import os\nos.system("roslaunch driver driver.launch real:=true")\n', ("driver",)),
        ('run = ["roslaunch", "driver", "driver.launch"]\n', ("driver",)),
        ("run = 'rosrun  driver a'\n", ("driver",)),
        ("run = f'sleep 1 && roslaunch --wait driver driver.launch a:={1}'\n", ("driver",)),
        ('run = "roslaunch acme a.launch"\n', ()),
        ('# "roslaunch driver driver.launch"\n', ()),
    ],
)
def test_what_the_started_script_launches_is_never_left_out(tmp_path: Path, script: str, must: tuple[str, ...]) -> None:
    guard = "if __name__ == '__main__':\n    pass\n"
    files = {**TREE, "demos/plan.py": f"{script}{guard}", "demos/other.py": f'x = "rosrun tools a"\n{guard}'}
    assert planned(tmp_path, "python3 demos/plan.py", files)[0] == must
