"""What the code itself tells of the versions that it is for, whatever a page says."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.facts import Mention
from roslab.evidence.gather import gather
from roslab.evidence.lex.balance import unbalanced
from roslab.plan.plan import make_plan
from roslab.render.dockerfile import dockerfile
from roslab.repository.checkout import Repository

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>{}</buildtool_depend></package>"
CMAKE = "cmake_minimum_required(VERSION 3.5)\nproject(demo)\nfind_package({} REQUIRED)\n{}add_executable(a a.cpp)\n"


def ros1(page: str, code: str = "", cmake: str = "") -> dict[str, str]:
    return {
        "package.xml": PACKAGE.format("catkin"),
        "CMakeLists.txt": CMAKE.format("catkin", cmake),
        "a.cpp": f"{code}\nint main() {{}}\n",
        "README.md": page,
    }


@pytest.mark.parametrize(
    ("code", "distro"),
    [
        ("", "melodic"),
        ("#include <boost/beast.hpp>", "noetic"),
        ("#include <boost/process.hpp>", "melodic"),
        ("Eigen::Vector<double, 3> v;", "melodic"),  # no Ubuntu of ROS 1 has it
    ],
)
def test_the_code_excludes_what_it_does_not_compile_with(tree: Tree, code: str, distro: str) -> None:
    assert tree(ros1("ROS Melodic\n", code)).ros_distro == distro


def test_a_library_that_the_tree_builds_excludes_nothing(tree: Tree) -> None:
    page = "ROS Melodic\n```\ngit clone https://github.com/boostorg/boost.git\ncd boost\nmake install\n```\n"
    assert tree(ros1(page, "#include <boost/beast.hpp>")).ros_distro == "melodic"


@pytest.mark.parametrize(
    ("header", "ref"),
    [
        ("sophus/se3.h", "a621ff2e56c56c839a6c40418d42c3c254424b5c"),
        ("sophus/se3.hpp", "1.22.10"),
    ],
)
def test_the_release_of_a_library_is_the_one_that_the_code_includes(tree: Tree, header: str, ref: str) -> None:
    cmake = (
        "cmake_minimum_required(VERSION 3.5)\nproject(demo)\nfind_package(Sophus REQUIRED)\nadd_executable(a a.cpp)\n"
    )
    decision = tree({"CMakeLists.txt": cmake, "a.cpp": f"#include <{header}>\nint main() {{}}\n"})
    assert [(source.name, source.ref) for source in decision.source] == [("sophus", ref)]


def test_ros_has_the_newer_sophus(tree: Tree) -> None:
    decision = tree(ros1("ROS Noetic\n", "#include <sophus/se3.h>", "find_package(Sophus REQUIRED)\n"))
    assert [source.name for source in decision.source] == ["sophus"]
    assert "ros-noetic-sophus" not in decision.apt_guessed
    decision = tree(ros1("ROS Noetic\n", "#include <sophus/se3.hpp>", "find_package(Sophus REQUIRED)\n"))
    assert "ros-noetic-sophus" in decision.apt_guessed


@pytest.mark.parametrize(
    ("header", "ref"), [("gtsam/base/Vector.h", "4.0.3"), ("gtsam/nonlinear/GncOptimizer.h", "4.1.1")]
)
def test_gtsam_is_new_enough_for_the_code(tree: Tree, header: str, ref: str) -> None:
    decision = tree(ros1("ROS Noetic\n", f"#include <{header}>", "find_package(GTSAM REQUIRED)\n"))
    assert [(source.name, source.ref) for source in decision.source] == [("gtsam", ref)]


LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package="demo", {}="a")])
"""


@pytest.mark.parametrize(
    ("page", "word", "distro"),
    [
        ("ROS 2 Eloquent\n", "executable", "jazzy"),
        ("ROS 2 Eloquent\n", "node_executable", "eloquent"),
        ("ROS 2 Foxy\n", "executable", "foxy"),
        ("ROS 2 Foxy\n", "node_executable", "foxy"),
    ],
)
def test_the_words_of_a_launch_file(tree: Tree, page: str, word: str, distro: str) -> None:
    decision = tree(
        {
            "package.xml": PACKAGE.format("ament_cmake"),
            "CMakeLists.txt": CMAKE.format("ament_cmake", ""),
            "launch/a.launch.py": LAUNCH.format(word),
            "README.md": page,
        }
    )
    assert decision.ros_distro == distro


@pytest.mark.parametrize(
    ("own", "page", "distro"),
    [(3, "ROS 2 Eloquent\n", "jazzy"), (2, "ROS 2 Eloquent\n", "eloquent"), (3, "ROS 2 Humble\n", "humble")],
)
def test_a_launch_file_that_came_with_a_driver_tells_nothing_beside_many_others(
    tree: Tree, own: int, page: str, distro: str
) -> None:
    decision = tree(
        {
            "package.xml": PACKAGE.format("ament_cmake"),
            "CMakeLists.txt": CMAKE.format("ament_cmake", ""),
            "launch/old.launch.py": LAUNCH.format("node_executable"),
            **{f"launch/{number}.launch.py": LAUNCH.format("executable") for number in range(own)},
            "README.md": page,
        }
    )
    assert decision.ros_distro == distro


@pytest.mark.parametrize(
    ("header", "distro"),
    [
        ("message_filters/subscriber.h", "jazzy"),
        ("message_filters/sync_policies/approximate_time.h", "jazzy"),
        ("tf2_ros/buffer.h", "jazzy"),
        ("message_filters/subscriber.hpp", "lyrical"),
    ],
)
def test_headers_that_a_newer_ros_2_has_by_another_name(tree: Tree, header: str, distro: str) -> None:
    decision = tree(
        {
            "package.xml": PACKAGE.format("ament_cmake"),
            "CMakeLists.txt": CMAKE.format("ament_cmake", ""),
            "src/a.cpp": f"#include <{header}>\n",
            "README.md": "ROS 2 Lyrical\n",
        }
    )
    assert decision.ros_distro == distro


@pytest.mark.parametrize(
    ("line", "page", "distro"),
    [
        ("#include <cv_bridge/cv_bridge.hpp>", "", "jazzy"),
        ("#include <cv_bridge/cv_bridge.hpp>", "Tested with ROS 2 Humble\n", "jazzy"),
        ("#include <cv_bridge/cv_bridge.hpp>", "Tested with ROS 2 Iron\n", "iron"),
        ("#include <cv_bridge/cv_bridge.hpp>", "The branch for ROS 2 Rolling\n", "rolling"),
        ("#include <image_geometry/pinhole_camera_model.hpp>", "", "jazzy"),
        ("#include <tf2_geometry_msgs/tf2_geometry_msgs.hpp>", "Tested with ROS 2 Foxy\n", "jazzy"),
        ("#include <tf2_geometry_msgs/tf2_geometry_msgs.h>", "Tested with ROS 2 Jazzy\n", "humble"),
        ("#include <cv_bridge/cv_bridge.h>", "Tested with ROS 2 Jazzy\n", "humble"),
        ("#include <cv_bridge/cv_bridge.h>", "", "humble"),
        ("#ifdef NEW\n#include <cv_bridge/cv_bridge.hpp>\n#endif", "", "humble"),
        ("#if __has_include(<cv_bridge/cv_bridge.hpp>)\n#include <cv_bridge/cv_bridge.hpp>\n#endif", "", "humble"),
    ],
)
def test_headers_that_rule_a_distribution_of_ros_2_out(tree: Tree, line: str, page: str, distro: str) -> None:
    files = {"package.xml": PACKAGE.format("ament_cmake"), "CMakeLists.txt": CMAKE.format("ament_cmake", "")}
    assert tree({**files, "src/a.cpp": f"{line}\n", "README.md": page}).ros_distro == distro


@pytest.mark.parametrize(
    ("lines", "distro"),
    [
        ("ament_target_dependencies(a rclcpp)", "jazzy"),
        ("# ament_target_dependencies(a rclcpp)", "rolling"),
        ('if($ENV{ROS_DISTRO} STREQUAL "humble")\nament_target_dependencies(a rclcpp)\nendif()', "rolling"),
        ("macro(ament_target_dependencies)\nendmacro()\nament_target_dependencies(a rclcpp)", "rolling"),
    ],
)
def test_a_command_that_rolling_dropped_rules_it_out(tree: Tree, lines: str, distro: str) -> None:
    cmake = CMAKE.format("ament_cmake", "") + f"add_executable(a src/a.cpp)\n{lines}\n"
    files = {"package.xml": PACKAGE.format("ament_cmake"), "CMakeLists.txt": cmake, "src/a.cpp": ""}
    assert tree({**files, "README.md": "The branch for ROS 2 Rolling\n"}).ros_distro == distro


def test_a_command_that_a_file_of_the_tree_defines_rules_nothing_out(tree: Tree) -> None:
    lines = "add_executable(a src/a.cpp)\ninclude(cmake/compat.cmake)\nament_target_dependencies(a rclcpp)\n"
    files = {"package.xml": PACKAGE.format("ament_cmake"), "src/a.cpp": "", "README.md": "For ROS 2 Rolling\n"}
    files["CMakeLists.txt"] = CMAKE.format("ament_cmake", "") + lines
    files["cmake/compat.cmake"] = "function(other)\nendfunction()\n"
    assert tree(files).ros_distro == "jazzy"
    files["cmake/compat.cmake"] = "function(ament_target_dependencies target)\nendfunction()\n"
    assert tree(files).ros_distro == "rolling"


def test_a_header_does_not_outweigh_what_the_authors_image_starts_from(tree: Tree) -> None:
    files = {"package.xml": PACKAGE.format("ament_cmake"), "CMakeLists.txt": CMAKE.format("ament_cmake", "")}
    files["src/a.cpp"] = "#include <cv_bridge/cv_bridge.h>\n"
    files["README.md"] = "Tested with ROS 2 Humble\n"
    files["Dockerfile"] = "FROM ros:jazzy\nCOPY . /ws/src/demo\nRUN colcon build\n"
    assert tree(files).ros_distro == "jazzy"


def test_a_header_of_what_is_cloned_says_nothing_of_the_distribution(tree: Tree) -> None:
    files = {"package.xml": PACKAGE.format("ament_cmake"), "CMakeLists.txt": CMAKE.format("ament_cmake", "")}
    files["src/a.cpp"] = "#include <cv_bridge/cv_bridge.hpp>\n"
    files["README.md"] = "For ROS 2 Humble\n"
    assert tree(files).ros_distro == "jazzy"
    module = '[submodule "vision_opencv"]\npath = src/vision_opencv\nurl = https://github.com/lab/vision_opencv\n'
    assert tree({**files, ".gitmodules": module}).ros_distro == "humble"


def test_headers_of_a_package_of_ros_1_say_nothing_of_ros_2(tree: Tree) -> None:
    files = {
        "two/package.xml": PACKAGE.format("ament_cmake"),
        "two/CMakeLists.txt": CMAKE.format("ament_cmake", ""),
        "one/package.xml": PACKAGE.format("catkin").replace("demo", "one"),
        "one/CMakeLists.txt": CMAKE.format("catkin", ""),
        "one/a.cpp": "#include <cv_bridge/cv_bridge.h>\n",
        "README.md": "For ROS 2 Jazzy\n",
    }
    assert tree(files).ros_distro == "jazzy"


def test_a_launch_file_that_names_a_library_of_nodes_is_none_of_them(tree: Tree) -> None:
    made = LAUNCH.replace("from launch_ros", "import rclpy\nfrom launch_ros").format("executable")
    files = {"package.xml": PACKAGE.format("ament_cmake"), "CMakeLists.txt": CMAKE.format("ament_cmake", "")}
    assert tree(files | {"launch/a.launch.py": made, "README.md": "ROS 2 Eloquent\n"}).ros_distro == "jazzy"


@pytest.mark.parametrize(
    ("code", "distro"),
    [
        ("print(f'{1}')", "melodic"),
        ("if (n := 1):\n    print(n)", "noetic"),
        ("# if (n := 1):", "melodic"),
        ("print('if (n := 1)')", "melodic"),
    ],
)
def test_the_syntax_of_nodes_excludes_an_older_ubuntu(tree: Tree, code: str, distro: str) -> None:
    files = ros1("ROS Melodic\n")
    assert tree(files | {"node.py": f"{code}\n"}).ros_distro == "melodic"
    assert tree(files | {"node.py": f"import rospy\n{code}\n"}).ros_distro == distro


@pytest.mark.parametrize(
    ("code", "python"),
    [
        ("print(f'{a}')\nprint(f'{a[0]} of {len(a)}', a['x'])\n", "3.8"),
        ("print(f'runs/{a['x']}/log')\n", "3.12"),
        ('print(f"runs/{a.b["x"]}/log")\n', "3.12"),
        ("def first[T](items: list[T]) -> T:\n    return items[0]\n", "3.12"),
    ],
)
def test_a_page_names_a_python_that_cannot_read_the_code(tree: Tree, code: str, python: str) -> None:
    page = "- Create an environment with: conda create -n demo python=3.8\n"
    assert tree({"play.py": code, "requirements.txt": "numpy\n", "README.md": page}).python.version == python


def test_the_syntax_of_the_code_bounds_its_python(tree: Tree) -> None:
    match = "def f(a):\n    match a:\n        case 1:\n            return 2\n"
    files = {"requirements.txt": "numpy==1.22.0\n", "main.py": "import numpy\n"}
    older = tree(files).python.version
    newer = tree(files | {"main.py": f"import numpy\n{match}"}).python.version
    assert older
    assert newer
    assert tuple(map(int, newer.split("."))) >= (3, 10)


EXAMPLE = """\
Install ROS. Replace XXX by your distribution, for example, if you use ROS-kinetic, the command is:<br>
```
sudo apt-get install ros-kinetic-cv-bridge
```
"""


@pytest.mark.parametrize(
    ("page", "distro"),
    [("ROS Kinetic\n", "kinetic"), (EXAMPLE, "noetic"), (EXAMPLE + "Tested on ROS melodic.\n", "melodic")],
)
def test_an_example_in_a_sentence_names_no_target(tmp_path: Path, page: str, distro: str) -> None:
    for path, text in ros1(page).items():
        (tmp_path / path).write_text(text, encoding="utf-8")
    evidence = gather(Repository.open(tmp_path))
    date = Mention(topic="date", value="2024-01-25", source="commit", file=".git/HEAD", line=1, text="2024-01-25")
    dated = replace(evidence, mentions=(*evidence.mentions, date))
    assert decide(dated, Config(), folder_name="demo").ros_distro == distro


@pytest.mark.parametrize(
    ("text", "wrong"),
    [
        ("cd a && {curl -O x; cd -; }", True),
        ("cd a && { curl -O x; cd -; }", False),
        ("if [ -f a ]; then b; fi", False),
        ("b; fi", True),
        ("for i in 1 2; do echo $i; done", False),
        ("for i in 1 2\ndo\n  if a; then { b; }; fi\ndone | c", False),
        ("case $x in\n  a) b ;;\n  *) c ;;\nesac", False),
        ("echo done fi }", False),
        ("find . -exec rm {} \\; && awk '{print}' x", False),
        ("f() { a; }; f", False),
    ],
)
def test_what_no_shell_reads(text: str, wrong: bool) -> None:
    assert bool(unbalanced(text)) is wrong


def test_a_dockerfile_with_a_step_that_no_shell_reads_is_not_built(tree: Tree) -> None:
    files = {"main.py": "print(1)\n", "requirements.txt": "numpy\n"}
    good = "FROM python:3.9\nCOPY . /app\nRUN --network=none cd /app && { pip install numpy; cd -; }\n"
    assert tree(files | {"Dockerfile": good}).dockerfile == "Dockerfile"
    assert tree(files | {"Dockerfile": good.replace("{ pip", "{pip")}).dockerfile is None


CPP = {
    "CMakeLists.txt": "cmake_minimum_required(VERSION 3.5)\nproject(demo CXX)\nadd_executable(a a.cpp)\n",
    "a.cpp": "#include <Eigen/Core>\nint main() {}\n",
    "setup.py": "from setuptools import setup\nsetup(name='demo')\n",
}


@pytest.mark.parametrize(
    ("page", "kind"),
    [
        ("```\nmkdir build\ncd build\ncmake ..\nmake\n```\n", "cpp"),
        ("```\nmkdir build\ncd build\ncmake ..\n```\nor\n```\npip install .\n```\n", "python"),
        ("```\nmkdir build\ncd build\ncmake ..\n```\nor\n```\npython setup.py install\n```\n", "python"),
        ("```\nmkdir build\ncd build\ncmake ..\n```\nor\n```\npip install demo\n```\n", "python"),
        ("", "python"),
    ],
)
def test_a_page_that_builds_with_cmake_beside_a_setup_py(tree: Tree, page: str, kind: str) -> None:
    assert tree(CPP | {"README.md": page}).kind == kind


@pytest.mark.parametrize(
    ("environment", "kind"), [(".github/conda/environment.yml", "cpp"), ("tools/environment.yml", "python")]
)
def test_an_environment_of_conda_below_the_ci_is_not_the_program(tree: Tree, environment: str, kind: str) -> None:
    files = {f"core/{path}": text for path, text in CPP.items() if path != "setup.py"}
    assert tree(files | {environment: "name: a\ndependencies:\n  - eigen\n"}).kind == kind


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ('set(CMAKE_CXX_FLAGS "-O3 -march=native")', True),
        ("# set(CMAKE_CXX_FLAGS -march=native)", False),
        ('set(CMAKE_CXX_FLAGS "-march=x86-64")', False),
    ],
)
def test_an_option_for_the_processor_of_one_machine_is_told(tree: Tree, line: str, told: bool) -> None:
    files = {"CMakeLists.txt": f"project(demo CXX)\n{line}\nadd_executable(a a.cpp)\n", "a.cpp": "int main() {}\n"}
    found = [(w.file, w.line) for w in tree(files).warnings if "-march=native" in w.message]
    assert found == ([("CMakeLists.txt", 2)] if told else [])


@pytest.mark.parametrize(
    ("code", "gui"),
    [('cv::imshow("a", b);', True), ('  imshow("a", b);', True), ('// cv::imshow("a", b);', False), ("read();", False)],
)
def test_a_call_that_opens_a_window(tree: Tree, code: str, gui: bool) -> None:
    made = "project(demo CXX)\nadd_executable(a a.cpp)\n"
    assert tree({"CMakeLists.txt": made, "a.cpp": f"int main() {{\n{code}\n}}\n"}).gui is gui


@pytest.mark.parametrize(
    ("base", "built"),
    [("python:3.9", True), ("lab/base:1", True), ("demo_base", False), ("demo_base:latest", False)],
)
def test_a_base_that_only_the_author_has(tree: Tree, base: str, built: bool) -> None:
    files = {"main.py": "print(1)\n", "requirements.txt": "numpy\n"}
    decision = tree(files | {"Dockerfile": f"FROM {base}\nCOPY . /app\nRUN pip install numpy\n"})
    assert (decision.dockerfile == "Dockerfile") is built
    if not built:
        assert any(f"its base {base} is built on the author's machine" in r.reason for r in decision.reasons)


@pytest.mark.parametrize(
    ("cmake", "told"),
    [
        ("set(G2O_ROOT /home/ann/libs/g2o)\ninclude_directories(${G2O_ROOT})\n", "/home/ann/libs/g2o is a folder of"),
        (
            'set(A "/home/ann/a")\nlink_directories(/home/ann/b)\n',
            "/home/ann/a is a folder of its author's computer, and so is",
        ),
        ("# set(G2O_ROOT /home/ann/libs/g2o)\n", ""),
        ("set(A ${ROOT}/home/ann/a)\n", ""),
    ],
)
def test_a_folder_of_the_authors_computer_is_told(tree: Tree, cmake: str, told: str) -> None:
    warnings = tree({"CMakeLists.txt": f"project(demo CXX)\n{cmake}", "a.cpp": "int main() {}\n"}).warnings
    found = [(w.file, w.line, w.message) for w in warnings if "computer" in w.message]
    assert [(file, line) for file, line, _ in found] == ([("CMakeLists.txt", 2)] if told else [])
    assert all(message.startswith(told) for *_, message in found)


PROJECT = "cmake_minimum_required(VERSION 3.5)\nproject(demo CXX)\nadd_executable(a a.cpp)\n"


def projects(*folders: str) -> dict[str, str]:
    files = {f"{folder}/CMakeLists.txt": PROJECT for folder in folders}
    return files | {f"{folder}/a.cpp": "#include <vector>\nint main() {}\n" for folder in folders}


@pytest.mark.parametrize(
    ("folders", "told"),
    [
        (("one", "two", "two/part", "tools/three", "examples/four"), "one is compiled, not tools/three;"),
        (("one", "one/part"), ""),
        ((".", "one", "tools/two"), ""),
    ],
)
def test_cmake_projects_that_are_not_compiled_are_told(tree: Tree, folders: tuple[str, ...], told: str) -> None:
    messages = [w.message for w in tree(projects(*folders)).warnings if "is compiled, not" in w.message]
    assert [told in message for message in messages] == ([True] if told else [])


@pytest.mark.parametrize(
    ("folders", "beside"),
    [
        (("part 1", "part 2", "part 2/lib", "part 3", "tests"), ["part 2", "part 3"]),
        (("src/core", "src/gui", "tools"), []),
        ((".", "part 1", "part 2"), []),
    ],
)
def test_cmake_projects_beside_the_first_are_compiled_too(
    tree: Tree, folders: tuple[str, ...], beside: list[str]
) -> None:
    found = tree(projects(*folders))
    assert [script.folder for script in found.scripts] == beside
    text = dockerfile(make_plan(found, Config(), folder_name="demo"))
    assert "python3-dev" not in text
    for folder in beside:
        assert (
            f'RUN cd "/home/${{NB_USER}}/demo/{folder}" \\\n && {{ mkdir --parents build && cd build && cmake ' in text
        )


def test_a_project_that_another_one_finds_is_installed_before_it(tree: Tree) -> None:
    finds = {"b_app/CMakeLists.txt": PROJECT.replace("demo", "b_app") + "find_package(z_core REQUIRED)\n"}
    core = {"z_core/CMakeLists.txt": PROJECT.replace("demo", "z_core")}
    found = tree(projects("a_tool", "b_app", "z_core") | finds | core)
    assert [script.folder for script in found.scripts] == ["z_core", "b_app"]
    assert [script.command.endswith(" install") for script in found.scripts] == [True, False]


@pytest.mark.parametrize(
    ("code", "page", "distro"),
    [
        ("void goal_response_callback(std::shared_future<GoalHandle::SharedPtr> future)", "", "foxy"),
        ("void goal_response_callback(std::shared_future<G> future)", "Tested with ROS 2 Foxy\n", "foxy"),
        (
            "void goal_response_callback(std::shared_future<GoalHandle::SharedPtr> future)",
            "Tested with ROS 2 Foxy\n",
            "foxy",
        ),
        ("void goal_response_callback(const GoalHandle::SharedPtr & goal)", "", "humble"),
        ("void goal_response_callback(const GoalHandle::SharedPtr & goal)", "Tested with ROS 2 Jazzy\n", "jazzy"),
        ("// void goal_response_callback(std::shared_future<G> future)", "", "humble"),
        ("#if OLD\nvoid goal_response_callback(std::shared_future<G> future)\n#endif", "", "humble"),
    ],
)
def test_the_callback_of_an_actions_client_tells_the_distribution(
    tree: Tree, code: str, page: str, distro: str
) -> None:
    files = {"package.xml": PACKAGE.format("ament_cmake"), "CMakeLists.txt": CMAKE.format("ament_cmake", "")}
    assert tree({**files, "src/a.cpp": f"{code}\n{{}}\n", "README.md": page}).ros_distro == distro
