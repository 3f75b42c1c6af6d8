"""What is decided in one job arrives whole in the next."""

from __future__ import annotations

import dataclasses
import secrets
from pathlib import Path

import pytest

from roslab.decide.decision import Reason
from roslab.errors import ConfigurationError
from roslab.github import steps
from roslab.github.run import PORTABLE, Run, from_line, to_line
from roslab.pipeline import plan_repository

NAMES = (
    "ros1_talker",
    "ros2_filter",
    "ros2_talker",
    "python_filter",
    "cuda_saxpy",
    "own_dockerfile",
    "monorepo",
    "no_config",
)


def run(examples: Path, name: str = "ros2_filter") -> Run:
    plan = plan_repository(examples / name).plan
    return Run(plan=plan, image="ghcr.io/lab/robot", username="lab", push=True, reason="why", cache="auto")


@pytest.mark.parametrize("name", NAMES)
def test_there_and_back(examples: Path, name: str) -> None:
    decided = run(examples, name)
    line = to_line(decided)
    assert "\n" not in line
    assert from_line(line) == decided


def test_a_large_plan_still_fits_into_an_environment_variable(examples: Path) -> None:
    decided = run(examples)
    reasons = tuple(
        Reason(question="dependencies", answer=secrets.token_hex(50), reason=secrets.token_hex(200), decisive=True)
        for _ in range(2000)
    )
    large = dataclasses.replace(decided, plan=dataclasses.replace(decided.plan, reasons=reasons))
    line = to_line(large)
    assert len(line) <= PORTABLE
    assert from_line(line).plan.base_image == decided.plan.base_image


def test_two_thousand_packages_fit_into_the_outputs(tmp_path: Path) -> None:
    """All outputs of a job may hold 1 MiB, counted as UTF-16, or the job fails; the whole plan is a file beside them.

    https://docs.github.com/en/actions/reference/workflows-and-actions/workflow-syntax#jobsjob_idoutputs
    """
    tree = tmp_path / "tree"
    for number in range(2000):
        folder = tree / f"src/group_{number % 40}/package_number_{number}"
        folder.mkdir(parents=True)
        needs = "".join(f"<depend>package_number_{(number * 7 + each) % 2000}</depend>" for each in range(5))
        about = "<version>1.0.0</version><description>x</description><license>MIT</license>"
        about += f"<name>package_number_{number}</name><maintainer email='a@example.org'>A</maintainer>"
        needs += f"<depend>rclcpp</depend><depend>library-{number}</depend>"
        export = "<export><build_type>ament_cmake</build_type></export>"
        (folder / "package.xml").write_text(f'<package format="3">{about}{needs}{export}</package>\n')
        (folder / "CMakeLists.txt").write_text(f"project(package_number_{number})\nfind_package(rclcpp REQUIRED)\n")
    (tree / "roslab.yaml").write_text("format: 3\nbase: {ros: jazzy}\n")
    (tmp_path / "temp").mkdir()
    steps.plan(
        {
            "GITHUB_WORKSPACE": str(tree),
            "GITHUB_OUTPUT": str(tmp_path / "outputs"),
            "GITHUB_EVENT_NAME": "push",
            "GITHUB_REPOSITORY": "lab/robot",
            "GITHUB_REF": "refs/heads/main",
            "RUNNER_TEMP": str(tmp_path / "temp"),
        }
    )
    said = (tmp_path / "outputs").read_text()
    assert len(said.encode("utf-16")) < 1024 * 1024
    (whole,) = (tmp_path / "temp").glob("roslab-*/plan.json")
    assert len(whole.read_text().encode("utf-16")) > 1024 * 1024, "it would fit by itself, so the test means nothing"


@pytest.mark.parametrize("text", ["", "[]", "{}", "not base64", "e30=", "eJyrVipJLS5RslJQykjNyclXSMsvUkjKSSxOBQBRzAcR"])
def test_something_else_is_refused(text: str) -> None:
    with pytest.raises(ConfigurationError):
        from_line(text)
