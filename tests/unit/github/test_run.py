"""What is decided in one job arrives whole in the next."""

from __future__ import annotations

import dataclasses
import json
import os
import re
import secrets
from pathlib import Path

import pytest

from roslab.decide.decision import Reason
from roslab.errors import ConfigurationError
from roslab.github import steps
from roslab.github.run import PORTABLE, Folder, Run, from_line, reports, to_line
from roslab.pipeline import plan_repository
from roslab.plan.plan import from_json
from roslab.render.sizes import LayerSize
from roslab.render.summary import PlatformReport, ProofReport

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


@pytest.mark.parametrize("text", ["", "[]", "{}", "not base64", "e30=", "eJyrVipJLS5RslJQykjNyclXSMsvUkjKSSxOBQBRzAcR"])
def test_something_else_is_refused(text: str) -> None:
    with pytest.raises(ConfigurationError):
        from_line(text)


def report(platform: str, digest: str = "sha256:0") -> PlatformReport:
    proof = ProofReport(name="a", command="b", passed=True, summary="c", output="d")
    layer = LayerSize(size=1, text="RUN x", base=False)
    return PlatformReport(
        platform=platform, digest=digest, source="", layers=(layer,), proofs=(proof,), build_seconds=1.5
    )


def test_reports_of_several_jobs(tmp_path: Path) -> None:
    for number, platform in enumerate(("linux/amd64", "linux/arm64")):
        folder = Folder(path=tmp_path / str(number))
        folder.path.mkdir()
        folder.write_report(report(platform))
    assert set(reports(tmp_path)) == {report("linux/amd64"), report("linux/arm64")}


def test_of_two_reports_for_a_platform_the_newer_counts(tmp_path: Path) -> None:
    for number in (0, 1):
        folder = Folder(path=tmp_path / str(number))
        folder.path.mkdir()
        folder.write_report(report("linux/amd64", f"sha256:{number}"))
        os.utime(folder.artifact / "report-linux-amd64.json", (100 - number, 100 - number))
    assert reports(tmp_path) == (report("linux/amd64", "sha256:0"),)


def test_no_report(tmp_path: Path) -> None:
    (tmp_path / "report-linux-amd64.json").write_text(json.dumps({"platform": 1}))
    with pytest.raises(ConfigurationError, match="is no report"):
        reports(tmp_path)


def test_two_thousand_packages_stay_below_the_limit_of_a_jobs_outputs(tmp_path: Path) -> None:
    tree = tmp_path / "tree"
    for number in range(2000):
        name = f"package_with_a_name_of_its_own_{number:04}"
        folder = tree / "src/some_group_of_packages" / name
        folder.mkdir(parents=True)
        depends = "".join(f"<depend>library_{number}_{i}</depend>" for i in range(4))
        (folder / "package.xml").write_text(
            f'<package format="3"><name>{name}</name><version>1.0.0</version>'
            "<description>x</description><maintainer email='a@example.org'>a</maintainer><license>MIT</license>"
            f"<buildtool_depend>ament_cmake</buildtool_depend><depend>rclcpp</depend>{depends}"
            "<export><build_type>ament_cmake</build_type></export></package>"
        )
        (folder / "CMakeLists.txt").write_text(
            f"project({name})\nfind_package(ament_cmake REQUIRED)\nament_package()\n"
        )
    written = tmp_path / "outputs"
    environment = {
        "GITHUB_WORKSPACE": str(tree),
        "GITHUB_OUTPUT": str(written),
        "GITHUB_EVENT_NAME": "push",
        "GITHUB_REPOSITORY": "lab/robot",
        "GITHUB_REF": "refs/heads/main",
        "RUNNER_TEMP": str(tmp_path),
    }
    steps.plan(environment)
    assert len(written.read_text().encode("utf-16")) < 1024 * 1024
    said = _outputs(written.read_text())
    assert len(said["run"]) <= PORTABLE
    assert json.loads(said["plan"])["counts"]["packages"] == 2000
    whole = json.loads(Path(said["plan-file"]).read_text())
    assert len(whole["rosdep"]["manifests"]) == 2000
    assert from_line(said["run"]).plan.rosdep == from_json(Path(said["plan-file"]).read_text()).rosdep


def _outputs(text: str) -> dict[str, str]:
    return {
        name: value for name, _, value in re.findall(r"^(\S+)<<(\S+)\n(.*?)\n\2$", text, flags=re.MULTILINE | re.DOTALL)
    }
