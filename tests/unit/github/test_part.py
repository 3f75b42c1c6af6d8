"""A folder of the repository is built as if it were the whole, and what is wrong in it is named by its whole path."""

from __future__ import annotations

import json
import re
import subprocess
from pathlib import Path

import pytest

from roslab.errors import ConfigurationError, RefusedError
from roslab.github import checkout, inputs, steps
from roslab.github.run import from_line


@pytest.fixture
def environment(tmp_path: Path) -> dict[str, str]:
    tree = tmp_path / "tree"
    for path, text in {
        "robots/arm/main.py": "import numpy\n",
        "robots/arm/requirements.txt": "numpy\n",
        "package.xml": "<package/>",
        "robots/arm/roslab.yaml": "format: 3\nkind: python\ntags: {suffix: -arm}\n",
    }.items():
        (tree / path).parent.mkdir(parents=True, exist_ok=True)
        (tree / path).write_text(text)
    who = ["-c", "user.name=a", "-c", "user.email=a@example.org"]
    for words in (["init", "--quiet"], ["add", "--all"], ["commit", "--quiet", "--message", "x"]):
        subprocess.run(["git", "-C", tree, *who, *words], check=True, capture_output=True)
    return {
        "GITHUB_WORKSPACE": str(tree),
        "GITHUB_OUTPUT": str(tmp_path / "outputs"),
        "GITHUB_EVENT_NAME": "push",
        "GITHUB_REPOSITORY": "lab/robot",
        "GITHUB_REF": "refs/heads/main",
        "RUNNER_TEMP": str(tmp_path),
        "INPUT_PATH": "./robots/arm/",
    }


def outputs(environment: dict[str, str]) -> dict[str, str]:
    text = Path(environment["GITHUB_OUTPUT"]).read_text()
    pattern = r"^(\S+)<<(\S+)\n(.*?)\n\2$"
    return {name: value for name, _, value in re.findall(pattern, text, flags=re.MULTILINE | re.DOTALL)}


def test_the_folder_is_planned_as_the_whole(environment: dict[str, str]) -> None:
    steps.plan({**environment, "INPUT_TAG_PREFIX": "ros-"})
    found = outputs(environment)
    assert found["image"] == "ghcr.io/lab/robot-robots-arm"
    plan = json.loads(Path(found["plan-file"]).read_text())
    assert plan["kind"] == "python"
    assert plan["python"]["requirements"] == ["requirements.txt"]
    assert plan["tags"] == {"prefix": "ros-", "suffix": "-arm"}


def test_mistakes_of_inputs_and_file_are_reported_together(environment: dict[str, str]) -> None:
    Path(environment["GITHUB_WORKSPACE"], "robots/arm/roslab.yaml").write_text("format: 3\nkind: pythn\n")
    wrong = {"INPUT_PUSH": "yes", "INPUT_REGISTRY": "https://ghcr.io", "INPUT_CACHE": "all", "INPUT_RUNNERS": "[]"}
    with pytest.raises(ConfigurationError) as caught:
        steps.plan({**environment, **wrong, "INPUT_PLATFORMS": "amd64", "INPUT_IMAGE": "A B"})
    said = [str(problem) for problem in caught.value.problems]
    starts = [f"input {name}: " for name in ("push", "cache", "registry", "image", "runners")]
    assert [line for line, start in zip(said, starts, strict=False) if not line.startswith(start)] == []
    assert said[5].startswith("robots/arm/roslab.yaml:2:7: ")
    assert said[6].startswith("input platforms: ")
    assert len(said) == 7
    Path(environment["GITHUB_WORKSPACE"], "robots/arm/roslab.yaml").unlink()
    with pytest.raises(ConfigurationError, match="input push: ") as caught:
        steps.plan({**environment, "INPUT_PUSH": "yes"})
    assert len(caught.value.problems) == 1


def test_a_mistake_is_named_by_its_path_in_the_repository(environment: dict[str, str]) -> None:
    Path(environment["GITHUB_WORKSPACE"], "robots/arm/roslab.yaml").write_text("format: 3\nkind: pythn\n")
    with pytest.raises(ConfigurationError, match=r"robots/arm/roslab\.yaml:2:7"):
        steps.plan(environment)


@pytest.mark.parametrize("path", ["..", "../other", "/etc", "link", ".git", "robots/../../x"])
def test_nothing_outside_the_checkout_is_built(environment: dict[str, str], path: str) -> None:
    tree = Path(environment["GITHUB_WORKSPACE"])
    (tree / "link").symlink_to("/etc")
    with pytest.raises(RefusedError, match="leads out of the repository"):
        checkout.part(tree, inputs.part({"INPUT_PATH": path}))


def test_a_folder_that_is_not_there(environment: dict[str, str]) -> None:
    with pytest.raises(ConfigurationError, match="no folder nothing"):
        checkout.part(Path(environment["GITHUB_WORKSPACE"]), "nothing")


def test_an_old_tag_is_planned_as_that_tag(environment: dict[str, str]) -> None:
    tree = environment["GITHUB_WORKSPACE"]
    subprocess.run(["git", "-C", tree, "tag", "v1.2.3"], check=True)
    steps.plan({**environment, "INPUT_REF": "v1.2.3", "GITHUB_SHA": "a" * 40})
    found = outputs(environment)
    commit = subprocess.check_output(["git", "-C", tree, "rev-parse", "HEAD"], text=True).strip()
    assert found["ref"] == commit
    assert found["latest"] == "false"
    run = from_line(found["run"])
    assert (run.rebuilt, run.revision) == ("refs/tags/v1.2.3", commit)


def test_nothing_is_fetched_for_a_strangers_code_that_holds_rights(
    environment: dict[str, str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its .gitmodules would choose what the repository's tokens fetch."""
    head = {"ref": "change", "repo": {"full_name": "stranger/robot", "fork": True}}
    (tmp_path / "event.json").write_text(json.dumps({"pull_request": {"number": 7, "head": head}}))
    Path(environment["GITHUB_WORKSPACE"], ".gitmodules").write_text('[submodule "x"]\n\tpath = x\n\turl = ../x\n')
    privileged = {"GITHUB_EVENT_NAME": "pull_request_target", "GITHUB_EVENT_PATH": str(tmp_path / "event.json")}
    (tmp_path / "git").write_text(f"#!/bin/sh\necho >>{tmp_path}/asked\nexit 1\n")
    (tmp_path / "git").chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(RefusedError, match="refused: pull_request_target"):
        steps.source({**environment, **privileged})
    assert not (tmp_path / "asked").exists()
    steps.source(environment)
    assert (tmp_path / "asked").exists(), "without a refusal it is asked, so the check above means something"
