"""GitLab's door: the lines of its job, run by a shell as GitLab's runner does, against a real engine and registry.

GitLab itself, its docker image and Alpine's packages are not here: what those lines would bring is there already.
"""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import yaml

from .doors import tags
from .laboratory import Laboratory

ROOT = Path(__file__).resolve().parent.parent.parent
JOB = yaml.safe_load((ROOT / "workflows/gitlab-ci.yml").read_text(encoding="utf-8"))["repro-action"]


def run(lab: Laboratory, tmp_path: Path, repository: str, **variables: str) -> str:
    """Run the job in a checkout of an example; return what it printed."""
    project = tmp_path / "project"
    if not project.exists():
        shutil.copytree(ROOT / "examples/no_config", project)
        program = tmp_path / "repro-action"
        shutil.copytree(ROOT / "scripts", program / "scripts", ignore=shutil.ignore_patterns("__pycache__"))
        who = ("git", "-c", "user.name=a", "-c", "user.email=a@example.org")
        for command in (["init", "--quiet", "--initial-branch=v1"], ["add", "."], ["commit", "--quiet", "-m", "x"]):
            subprocess.run([*who, *command], cwd=program, check=True)
    brought = ("apk ", "git clone") if (tmp_path / "opt").exists() else ("apk ",)
    lines = [line for line in (*JOB["before_script"], *JOB["script"]) if not line.startswith(brought)]
    script = "set -eo pipefail\n" + "\n".join(lines).replace("/opt/", f"{tmp_path}/opt/")
    environment = {
        **lab.environment,
        **JOB["variables"],
        "REPRO_ACTION": str(tmp_path / "repro-action"),
        "CI_DEFAULT_BRANCH": "main",
        "CI_PIPELINE_SOURCE": "push",
        "CI_REGISTRY": lab.registry,
        "CI_REGISTRY_IMAGE": repository,
        "CI_REGISTRY_USER": lab.username,
        "CI_REGISTRY_PASSWORD": lab.password,
        **variables,
    }
    answer = subprocess.run(
        ["bash", "-c", script], cwd=project, env=environment, capture_output=True, text=True, timeout=1800, check=False
    )
    said = answer.stdout + answer.stderr
    assert answer.returncode == 0, said[-4000:]
    assert lab.password not in said
    return said


def test_a_merge_request_a_branch_the_default_branch_and_a_tag(lab: Laboratory, tmp_path: Path) -> None:
    repository = lab.fresh_repository("gitlab")
    name = repository.partition("/")[2]
    request = run(
        lab,
        tmp_path,
        repository,
        CI_PIPELINE_SOURCE="merge_request_event",
        CI_COMMIT_REF_NAME="try/it",
        CI_COMMIT_REF_SLUG="try-it",
    )
    assert "was built and proved" in request
    assert tags(name) == {}
    run(lab, tmp_path, repository, CI_COMMIT_BRANCH="try/it", CI_COMMIT_REF_NAME="try/it", CI_COMMIT_REF_SLUG="try-it")
    assert tags(name).keys() == {"try-it"}
    run(lab, tmp_path, repository, CI_COMMIT_BRANCH="main", CI_COMMIT_REF_NAME="main", CI_COMMIT_REF_SLUG="main")
    found = tags(name)
    assert found.keys() == {"try-it", "main", "latest"}
    assert found["main"] == found["latest"] != ""
    run(lab, tmp_path, repository, CI_COMMIT_TAG="v1.2.0", CI_COMMIT_REF_NAME="v1.2.0", CI_COMMIT_REF_SLUG="v1-2-0")
    assert tags(name).keys() == {"try-it", "main", "latest", "v1.2.0"}
