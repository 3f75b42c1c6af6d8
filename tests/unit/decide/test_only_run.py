"""The only node that the README runs is the use of a repository, though its name says that it serves others."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CMAKE = "project(lens)\nfind_package(catkin REQUIRED COMPONENTS roscpp)\ncatkin_package()\n"
COMPILED = "".join(f"add_executable({name} src/{name}.cpp)\n" for name in ("fit_calibrate", "corner_view"))
TREE = {
    "package.xml": "<package><name>lens</name><buildtool_depend>catkin</buildtool_depend>"
    "<depend>roscpp</depend></package>",
    "CMakeLists.txt": CMAKE + COMPILED,
    "src/fit_calibrate.cpp": "int main() {}\n",
    "src/corner_view.cpp": "int main() {}\n",
}
IMAGE = (
    "FROM ros:noetic\nCOPY . /ws/src/lens\nRUN . /opt/ros/noetic/setup.sh && cd /ws && catkin_make\n"
    "ENTRYPOINT . /ws/devel/setup.sh && /bin/bash\n"
)
PAGE = "# Lens\n\nROS Noetic\n\n{}\n\n    rosrun lens {} --bag /path/to/a.bag --models pinhole\n"
HEADING = "## Usage\n\n### Run calibration"
RUN = ("rosrun", "lens", "fit_calibrate")


@pytest.mark.parametrize(
    ("page", "more", "taken"),
    [
        (PAGE.format(HEADING, "fit_calibrate"), {}, True),
        (PAGE.format(HEADING, "fit_calibrate"), {"Dockerfile": IMAGE}, True),
        (PAGE.format(HEADING, "fit_calibrate"), {"launch/a.launch": "<launch/>\n"}, False),
        (PAGE.format("## Usage\n\n### Test of the calibration", "fit_calibrate"), {}, False),
        (PAGE.format("## License", "fit_calibrate"), {}, False),
    ],
)
def test_the_only_one_of_the_page(tree: Tree, page: str, more: dict[str, str], *, taken: bool) -> None:
    command = tree({**TREE, "README.md": page, **more}).command
    assert (tuple(command[:3]) == RUN) is taken


def test_one_that_steers_is_none(tree: Tree) -> None:
    page = PAGE.format(HEADING, "keyboard_teleop")
    cmake = CMAKE + COMPILED.replace("fit_calibrate", "keyboard_teleop")
    assert tree({**TREE, "README.md": page, "CMakeLists.txt": cmake}).command == ("bash",)


USE = "# Lens\n\nROS Noetic\n\n## {}\n\n    roslaunch lens {}.launch\n"
TRIED = "## Services\n\n### Test of the service\n\n    roslaunch lens gen_path.launch\n"


@pytest.mark.parametrize(
    ("pages", "taken"),
    [
        ({"README.md": USE.format("Usage", "gen_path")}, True),
        ({"README.md": USE.format("License", "gen_path")}, False),
        ({"README.md": USE.format("Usage", "gen_path") + "\n    roslaunch lens record.launch\n"}, False),
        (
            {
                "README.md": "ROS Noetic\n",
                "srv/README.md": TRIED,
                "docs/use/installation.md": USE.format("Start", "gen_path"),
            },
            True,
        ),
        ({"README.md": "ROS Noetic\n", "srv/README.md": TRIED}, False),
    ],
)
def test_a_launch_file_that_pages_alone_start_is_the_use(tree: Tree, pages: dict[str, str], taken: bool) -> None:
    """Its name begins with what serves another, and a page above the other only tries it."""
    launch = '<launch><node pkg="lens" type="fit_calibrate" name="a"/></launch>\n'
    names = ("gen_path", "record", "show", "watch")
    files = {**TREE, **{f"launch/{name}.launch": launch for name in names}, **pages}
    assert (tree(files).command == ("roslaunch", "lens", "gen_path.launch")) is taken
