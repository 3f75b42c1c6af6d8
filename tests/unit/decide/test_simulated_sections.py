"""What a page starts in simulation, in a section about hardware, which is passed by else."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "package.xml": "<package><name>arm</name><buildtool_depend>catkin</buildtool_depend>"
    "<run_depend>rospy</run_depend></package>",
    "CMakeLists.txt": "project(arm)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
    "launch/arm.launch": '<launch><node pkg="arm" type="drive.py" name="a"/></launch>\n',
    "launch/arm_sim.launch": '<launch><node pkg="arm" type="drive.py" name="a"/></launch>\n',
    "scripts/drive.py": "#!/usr/bin/env python\nimport rospy\n",
    "scripts/teach.py": "#!/usr/bin/env python\nimport rospy\n",
}
SIM = ("roslaunch", "arm", "arm_sim.launch")
TEACH = ("rosrun", "arm", "teach.py")


def _page(lead: str, title: str = "Hardware Bringup") -> str:
    return (
        f"# Arm\nROS Kinetic\n\n## {title}\n\nFor the arm itself:\n\n    roslaunch arm arm.launch\n\n{lead}\n \n"
        "    roslaunch arm arm_sim.launch\n\n## Utilities\n\nOnce it runs:\n\n    rosrun arm teach.py\n"
    )


@pytest.mark.parametrize("lead", ["In case of a simulation launch:", "**Simulated arm:**", "Or use the simulator:"])
def test_what_is_simulated_counts_in_a_section_about_hardware(tree: Tree, lead: str) -> None:
    assert tree(FILES | {"README.md": _page(lead)}).command == SIM


@pytest.mark.parametrize(
    ("lead", "title"),
    [
        ("Then the second arm:", "Hardware Bringup"),
        ("Unlike in the simulation, with the real arm:", "Hardware Bringup"),
        ("In simulation this is not needed:", "Hardware Bringup"),
        ("There is a simulation.", "Hardware Bringup"),
        ("In case of a simulation launch:", "Citation"),
        ("In case of a simulation launch:", "Windows"),
        ("In case of a simulation launch:", "Hardware on Windows"),
    ],
)
def test_what_is_not_is_passed_by(tree: Tree, lead: str, title: str) -> None:
    assert tree(FILES | {"README.md": _page(lead, title)}).command == TEACH
