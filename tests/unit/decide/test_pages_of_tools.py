"""The page of a tool beside the packages of a repository for ROS gives no default command."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
CMAKE = "project(demo)\nfind_package(catkin REQUIRED)\n"
LAUNCH = {"src/demo/launch/demo.launch": "<launch/>"}
START = ("roslaunch", "demo", "demo.launch")
SCRIPT = ("bash", "trainer/start_server.sh")


@pytest.mark.parametrize(
    ("package", "page", "more", "command"),
    [
        ("src/demo", "trainer/README.md", LAUNCH, START),
        ("src/demo", "trainer/README.md", {}, SCRIPT),
        ("src/demo", "README.md", LAUNCH, SCRIPT),
        ("src/demo", "docs/usage.md", LAUNCH, SCRIPT),
        ("src/demo", "src/demo/README.md", LAUNCH, SCRIPT),
        ("src/demo", "src/README.md", LAUNCH, SCRIPT),
        ("", "trainer/README.md", {"launch/demo.launch": "<launch/>"}, SCRIPT),
    ],
)
def test_a_script_that_a_page_runs(
    tree: Tree, package: str, page: str, more: dict[str, str], command: tuple[str, ...]
) -> None:
    names = {"package.xml": PACKAGE, "CMakeLists.txt": CMAKE}
    own = {f"{package}/{name}".lstrip("/"): text for name, text in names.items()}
    script = {"trainer/start_server.sh": "python3 -m http.server\n", "trainer/a.py": "import numpy\n"}
    there = "./" if page.startswith("trainer") else "../" * page.count("/") + "trainer/"
    text = f"# Usage\n```\nbash {there}start_server.sh\n```\n"
    found = tree({**own, **script, **more, page: text}).command
    words = found.split() if isinstance(found, str) else found  # a script is started in the folder of its page
    assert words[-1].rpartition("/")[2] == command[-1].rpartition("/")[2]
