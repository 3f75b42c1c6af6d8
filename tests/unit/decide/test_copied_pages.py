"""Pages of copies of others' repositories run nothing for a tree with packages of its own."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = (
    "<package format='3'><name>{}</name><buildtool_depend>ament_cmake</buildtool_depend>"
    "<export><build_type>ament_cmake</build_type></export></package>"
)
LAUNCH = "from launch import LaunchDescription\n"
CMAKE = "project(demo)\nfind_package(ament_cmake REQUIRED)\n"
COPY = {
    "camera/LICENSE": "text",
    "camera/README.md": "# Usage\n\n    ros2 launch driver camera.launch.py\n",
    "camera/driver/package.xml": PACKAGE.format("driver"),
    "camera/driver/CMakeLists.txt": CMAKE,
    "camera/driver/launch/camera.launch.py": LAUNCH,
}
PACKED = {path.replace("camera/", "camera-main/", 1): text for path, text in COPY.items() if "LICENSE" not in path} | {
    "camera-main/io/package.xml": PACKAGE.format("io"),
    "camera-main/io/CMakeLists.txt": CMAKE,
}
OWN = {"arm/package.xml": PACKAGE.format("arm"), "arm/CMakeLists.txt": CMAKE, "arm/launch/arm.launch.py": LAUNCH}
MSGS = {"msgs/package.xml": PACKAGE.format("msgs"), "msgs/CMakeLists.txt": CMAKE}
"""A package that starts nothing."""
MORE = {
    f"camera/{name}/{file}": text
    for name in ("io", "view", "drawing", "tools")
    for file, text in (("package.xml", PACKAGE.format(name)), ("CMakeLists.txt", CMAKE))
}
CAMERA = ("ros2", "launch", "driver", "camera.launch.py")


@pytest.mark.parametrize(
    ("files", "command"),
    [
        ({**COPY, **OWN}, ("ros2", "launch", "arm", "arm.launch.py")),
        ({**COPY, **MSGS}, ("bash",)),
        ({**COPY, **MSGS, **MORE}, CAMERA),  # a workspace of copies, but for messages
        ({**COPY, **OWN, **MORE}, ("ros2", "launch", "arm", "arm.launch.py")),
        ({**COPY, **OWN, "README.md": "    ros2 launch driver camera.launch.py\n"}, CAMERA),
        (COPY, CAMERA),  # all that there is
        ({**PACKED, **OWN}, ("ros2", "launch", "arm", "arm.launch.py")),
        ({f"src/{path}": text for path, text in {**PACKED, **OWN}.items()}, ("ros2", "launch", "arm", "arm.launch.py")),
        (PACKED, CAMERA),
        ({**PACKED, **OWN, "camera-main/io/package.xml": None}, CAMERA),  # a part of its own
        ({path.replace("-main", "-arm"): text for path, text in {**PACKED, **OWN}.items()}, CAMERA),
        ({**COPY, **OWN, "camera/LICENSE": None}, CAMERA),  # a part of its own
        *(
            ({**COPY, **OWN, "camera/LICENSE": None, f"camera/{path}": ""}, command)
            for path, command in (
                (".github/workflows/ci.yml", ("ros2", "launch", "arm", "arm.launch.py")),
                (".gitmodules", ("ros2", "launch", "arm", "arm.launch.py")),
                (".github/dependabot.yml", CAMERA),
                (".gitlab-ci.yml", CAMERA),  # another one may include it, and Jenkins is told a path
                ("Jenkinsfile", CAMERA),
                ("driver/.travis.yml", CAMERA),  # a package that tests itself
            )
        ),
    ],
)
def test_the_page_of_a_copy_gives_no_command(
    tree: Tree, files: dict[str, str | None], command: tuple[str, ...]
) -> None:
    found = tree({path: text for path, text in files.items() if text is not None})
    assert found.command == command
    assert CAMERA in found.command_candidates


@pytest.mark.parametrize(
    ("folder", "needed"), [("sdk-main", False), ("sdk-1.2.0", False), ("sdk", True), ("demo-main", True)]
)
def test_what_the_pages_of_a_packed_repository_install_is_no_need(tree: Tree, folder: str, *, needed: bool) -> None:
    files = {f"{folder}/LICENSE": "text", f"{folder}/README.md": "# Build\n\n    sudo apt-get install doxygen\n"}
    files[".git/config"] = '[remote "origin"]\n\turl = https://github.com/lab/demo.git\n'
    assert any(each.answer == "doxygen" for each in tree({**OWN, **files}).reasons) == needed


def test_a_page_that_lacks_arguments_is_not_why_where_others_lack_none(tree: Tree) -> None:
    asks = "from launch.actions import DeclareLaunchArgument\nDeclareLaunchArgument('model')\n" + LAUNCH
    shown = {
        "show/package.xml": PACKAGE.format("show"),
        "show/CMakeLists.txt": CMAKE,
        "show/launch/show.launch.py": asks,
        "show/README.md": "# Usage\n\n    ros2 launch show show.launch.py\n",
    }
    why = "what pages run lacks arguments"
    assert why in shell(tree(shown))
    found = tree({**COPY, **shown})
    said = {reason.answer for reason in found.reasons if reason.question == "command"}
    assert "ros2 launch driver camera.launch.py" in said
    assert why not in shell(found)


def shell(decision: Decision) -> str:
    """Return why the command is a shell."""
    return next(each.reason for each in decision.reasons if (each.question, each.answer) == ("command", "bash"))
