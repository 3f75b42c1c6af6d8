"""The watch under act: one issue when a source no longer makes its image, updated, closed, and none for the network."""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import Any

from . import doors
from .act import Result, run_workflow
from .laboratory import Laboratory
from .old_world import serving

WORKFLOW = """
on: [schedule]
jobs:
  image:
    uses: org/repro-action/.github/workflows/drift.yml@v1
    permissions: {{contents: read, packages: read, issues: write}}
    with:
      registry: {registry}
      username: {username}
    secrets:
      registry-token: ${{{{ secrets.REGISTRY_PASSWORD }}}}
"""


def watched(lab: Laboratory, folder: Path, name: str, files: dict[str, str], issues: list[dict[str, Any]]) -> Result:
    """Run the watch once; the issues are GitHub's, and stay from run to run."""
    caller = doors.write(
        folder,
        {
            **doors.FILES,
            **files,
            ".github/workflows/caller.yml": WORKFLOW.format(registry=lab.registry, username=lab.username),
        },
    )
    github: dict[str, Any] = {"heads": {"main": "0" * 40}, "issues": issues, "posted": []}
    ran = run_workflow(lab, caller, "schedule", doors.payload(name), github=github)
    for path, body in github["posted"]:
        issues[int(path.split("/")[-2]) - 1].setdefault("comments", []).append(body["body"])
    return ran


def docker(lab: Laboratory, *arguments: str) -> None:
    answer = subprocess.run(
        ["docker", *arguments], env=dict(lab.environment), capture_output=True, text=True, timeout=600, check=False
    )
    assert answer.returncode == 0, answer.stderr[-4000:]


def test_one_issue_for_a_source_that_rots(lab: Laboratory, tmp_path: Path) -> None:
    name = lab.fresh_repository(f"{doors.OWNER}/robot").rpartition("/")[2]
    image = f"{lab.registry}/{doors.OWNER}/{name}:latest"
    served = {"/data": b"what the paper needs\n"}
    issues: list[dict[str, Any]] = []
    with serving(served) as address:
        own = doors.FILES["Dockerfile"].replace("COPY", f"ADD {address}/data /data\nCOPY")
        files = {"Dockerfile": own}
        docker(lab, "build", "--tag", image, str(doors.write(tmp_path / "archived", {**doors.FILES, **files})))
        docker(lab, "push", image)

        good = watched(lab, tmp_path / "good", name, files, issues)
        assert good.exit_code == 0, good.log
        assert good.output("state") == "proved"
        assert "0 of " in good.summary
        assert issues == []

        del served["/data"]
        first = watched(lab, tmp_path / "first", name, files, issues)
        assert first.exit_code == 0, first.log
        assert first.output("state") == "archived only"
        (issue,) = issues
        assert (issue["state"], issue["changes"]) == ("open", 0)
        assert "404" in issue["body"]
        assert "docker run --rm -it" in issue["body"]

        second = watched(lab, tmp_path / "second", name, {**files, "README.md": "still broken\n"}, issues)
        assert second.exit_code == 0, second.log
        (issue,) = issues
        assert (issue["state"], issue["changes"]) == ("open", 1)

        repaired = {**files, "Dockerfile": doors.FILES["Dockerfile"]}
        third = watched(lab, tmp_path / "third", name, repaired, issues)
        assert third.exit_code == 0, third.log
        (issue,) = issues
        assert issue["state"] == "closed"
        assert "proved again" in issue["comments"][0]
    # Nothing listens there any more: neither the source nor its author is to blame
    fault = watched(lab, tmp_path / "fault", name, files, issues)
    assert fault.exit_code != 0
    assert fault.output("state") == "unknown"
    assert [each["state"] for each in issues] == ["closed"]
    docker(lab, "image", "rm", "--force", image)


def test_what_moved_and_changed_the_proof_is_named(lab: Laboratory, tmp_path: Path) -> None:
    """The base has another library today, with which the program no longer runs."""
    name = lab.fresh_repository(f"{doors.OWNER}/robot").rpartition("/")[2]
    image, base = f"{lab.registry}/{doors.OWNER}/{name}:latest", f"repro-lab/{name}:base"
    files = {
        "Dockerfile": f'FROM {base}\nCMD ["true"]\n',
        "roslab.yaml": "format: 3\nkind: cpp\ndockerfile: Dockerfile\n"
        "test: python3 -c 'import robot_core; robot_core.old()'\n",
    }
    folder = "/usr/local/lib/python3/dist-packages"

    def make(version: str, body: str) -> None:
        text = (
            f"FROM python:3.12-slim\nENV PYTHONPATH={folder}\nRUN mkdir -p {folder}/robot_core-{version}.dist-info"
            f" && printf 'Metadata-Version: 2.1\\nName: robot-core\\nVersion: {version}\\n'"
            f" >{folder}/robot_core-{version}.dist-info/METADATA && echo '{body}' >{folder}/robot_core.py\n"
        )
        docker(lab, "build", "--tag", base, str(doors.write(tmp_path / f"base-{version}", {"Dockerfile": text})))

    make("1.0", "def old(): pass")
    docker(lab, "build", "--tag", image, str(doors.write(tmp_path / "archived", files)))
    docker(lab, "push", image)
    make("2.0", "def new(): pass")
    issues: list[dict[str, Any]] = []
    ran = watched(lab, tmp_path / "ran", name, files, issues)
    assert ran.exit_code == 0, ran.log
    assert ran.output("state") == "archived only"
    assert ran.output("moved") == "1"
    (issue,) = issues
    assert "1 of " in issue["body"]
    assert "of these 1 changed the proof: `robot-core`" in issue["body"]
    assert "`robot-core==1.0`" in issue["body"]
    docker(lab, "image", "rm", "--force", image, base)
