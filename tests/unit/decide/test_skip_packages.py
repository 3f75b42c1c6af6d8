"""``skip_packages`` in roslab.yaml: what it leaves out of the build, and what it says."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from trees import tree_of


def package(name: str, *needs: str) -> dict[str, str]:
    depends = "".join(f"<depend>{each}</depend>" for each in needs)
    return {
        f"{name}/package.xml": f'<package format="2"><name>{name}</name><version>1.0.0</version>'
        f"<buildtool_depend>catkin</buildtool_depend><depend>roscpp</depend>{depends}</package>",
        f"{name}/CMakeLists.txt": "cmake_minimum_required(VERSION 3.0)\n"
        f"project({name})\nfind_package(catkin REQUIRED)\ncatkin_package()\nadd_executable({name}_node main.cpp)\n",
        f"{name}/main.cpp": "int main() { return 0; }\n",
    }


def decided(folder: Path, config: str, files: dict[str, str]) -> Decision:
    tree_of(folder, files | ({"roslab.yaml": f"format: 3\n{config}"} if config else {}))
    return plan_repository(folder).decision


THREE = {**package("arm_core"), **package("arm_view", "arm_core"), **package("arm_demo")}


@pytest.mark.parametrize(
    ("said", "left"),
    [
        ("[arm_view]", ("arm_view",)),
        ("arm_demo", ("arm_demo",)),
        ("[arm_core]", ("arm_core", "arm_view")),
    ],
)
def test_a_package_is_left_out_with_what_cannot_be_built_without_it(
    tmp_path: Path, said: str, left: tuple[str, ...]
) -> None:
    decision = decided(tmp_path, f"skip_packages: {said}\n", THREE)
    assert decision.left_out == left
    assert not {*left} & {*decision.package_names}
    assert not any(file.startswith(f"{name}/") for name in left for file in decision.packages)
    reasons = {reason.answer: reason for reason in decision.reasons if reason.question == "workspace"}
    assert all((reasons[name].file, reasons[name].line) == ("roslab.yaml", 2) for name in left)


@pytest.mark.parametrize(
    ("config", "said"),
    [
        ("skip_packages: [arm_other]\n", "catkin_make leaves it out where a clone has it"),
        ("build: catkin_tools\nskip_packages: [arm_other]\n", "catkin_tools is told by markers in folders"),
        ("command: rosrun arm_demo arm_demo_node\nskip_packages: [arm_demo]\n", "the default command starts arm_demo"),
        ("skip_packages: [arm_core, arm_demo]\n", "leaves out every package of the repository"),
        ("build: none\nskip_packages: [arm_core]\n", "does nothing with none: it is for colcon, catkin_make"),
        ("kind: python\nbuild: pip\nskip_packages: [arm_core]\n", "does nothing with pip"),
    ],
)
def test_what_makes_no_sense_is_told(tmp_path: Path, config: str, said: str) -> None:
    decision = decided(tmp_path, config, {**THREE, "main.py": "print(1)\n"})
    assert any(said in warning.message for warning in decision.warnings), decision.warnings


def test_nothing_is_said_without_it(tmp_path: Path) -> None:
    decision = decided(tmp_path, "", THREE)
    assert decision.left_out == ()
    assert not any("skip_packages" in warning.message for warning in decision.warnings)
