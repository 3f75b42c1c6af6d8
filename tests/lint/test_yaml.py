"""The action, the workflows and the starters: pinned, alike in both doors, linted, and naming only what exists."""

from __future__ import annotations

import os
import re
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import yaml

ROOT = Path(__file__).resolve().parent.parent.parent
WORKFLOWS = sorted((ROOT / ".github/workflows").glob("*.yml")) + sorted((ROOT / ".github/workflows").glob(".*.yml"))
CALLABLE = [path for path in WORKFLOWS if not path.name.startswith(".")]
STARTERS = sorted(path for path in (ROOT / "workflows").glob("*.yml") if path.name != "gitlab-ci.yml")
THIN = [path for path in CALLABLE if path.name not in ("image.yml", "clean.yml", "drift.yml")]
EVERYTHING = [ROOT / "action.yml", *WORKFLOWS, *STARTERS]
USES = re.compile(r"^\s*(?:-\s+)?uses:\s*(?P<what>[^\s#]+)(?:\s*#\s*(?P<comment>.*))?$", re.MULTILINE)
OURS = "org/repro-action"
Tool = Callable[[str], str]


def load(path: Path) -> dict[Any, Any]:
    found = yaml.safe_load(path.read_text())
    assert isinstance(found, dict)
    return found


def called(path: Path) -> dict[str, Any]:
    """Return the ``workflow_call`` of a workflow; PyYAML reads the key ``on`` as true."""
    found: dict[str, Any] = load(path)[True]["workflow_call"]
    return found


def run(*command: str | Path) -> None:
    answer = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert answer.returncode == 0, answer.stdout + answer.stderr


@pytest.mark.parametrize("path", EVERYTHING, ids=lambda path: str(path.relative_to(ROOT)))
def test_every_action_is_pinned_with_its_version(path: Path) -> None:
    for match in USES.finditer(path.read_text()):
        what, comment = match["what"], match["comment"] or ""
        if what.startswith(("./", OURS)):
            continue
        assert re.fullmatch(r"[\w.-]+/[\w./-]+@[0-9a-f]{40}", what), f"{what} is not pinned by its full SHA"
        assert re.fullmatch(r"v\d+\.\d+\.\d+", comment), f"{what} names no version"


def test_an_action_has_one_version_everywhere() -> None:
    found: dict[str, set[str]] = {}
    for path in EVERYTHING:
        for match in USES.finditer(path.read_text()):
            name, _, ref = match["what"].partition("@")
            if ref and not name.startswith(OURS):
                found.setdefault(name, set()).add(f"{ref} {match['comment']}")
    assert "docker/build-push-action" in found
    assert {name: refs for name, refs in found.items() if len(refs) > 1} == {}


def test_both_doors_do_the_same() -> None:
    """The same actions with the same settings, the job's and the step's names for one value apart."""
    small = {step["name"]: step for step in load(ROOT / "action.yml")["runs"]["steps"]}
    jobs = load(ROOT / ".github/workflows/image.yml")["jobs"]
    wide = {step["name"]: step for job in ("build", "publish") for step in jobs[job]["steps"]}
    shared = ("Set up emulation", "Set up the builder", "Build, and push without a tag", "Sign the image")
    for name in shared:
        for key in ("uses", "with", "if", "env", "id"):
            assert _of_a_job(small[name].get(key)) == wide[name].get(key), f"{name}: {key}"
    named = _of_a_job(small["Name the tags"]["with"]["tags"])
    assert named == wide["Name the tags"]["with"]["tags"]
    assert small["Name the tags"]["with"]["flavor"] == wide["Name the tags"]["with"]["flavor"]


def _of_a_job(value: Any) -> Any:
    """Return a setting of the action as a workflow says it, where the plan is another job's."""
    if isinstance(value, dict):
        return {name: _of_a_job(each) for name, each in value.items()}
    return value.replace("steps.plan.", "needs.plan.") if isinstance(value, str) else value


ROOM, PROGRAM, READY, TREE = (
    "Make room for the program",
    "Check out the program",
    "Prepare the program, out of the workspace",
    "Check out the repository",
)


def _jobs() -> dict[str, list[dict[str, Any]]]:
    paths = [ROOT / ".github/workflows" / name for name in ("image.yml", "clean.yml", "drift.yml")]
    return {name: job["steps"] for path in paths for name, job in load(path)["jobs"].items()}


def test_the_program_is_out_of_the_workspace_before_the_repository_comes() -> None:
    """A link of the repository's at the program's place would lead what is checked out there, and run, elsewhere."""
    first = [ROOM, PROGRAM, READY]
    for name, steps in _jobs().items():
        names = [step["name"] for step in steps]
        assert names[:3] == first, name
        assert names[3:4] == [TREE] or TREE not in names, name
    prepared = [[{**step, "if": None} for step in steps[:3]] for steps in _jobs().values()]
    assert all(steps == prepared[0] for steps in prepared)


@pytest.mark.parametrize(
    ("repository", "commit", "act", "code"),
    [
        ("org/repro-action", "0" * 40, "", 0),
        ("", "", "", 4),
        ("org/repro-action", "", "", 4),
        ("", "0" * 40, "", 4),
        ("", "", "true", 0),
    ],
)
def test_a_runner_that_does_not_say_what_it_runs_is_told_so(
    tmp_path: Path, repository: str, commit: str, act: str, code: int
) -> None:
    """With nothing to check out by, actions/checkout would take the caller's repository for the program."""
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "elsewhere/kept").touch()
    (tmp_path / ".repro-action").symlink_to("elsewhere")
    script = _jobs()["plan"][0]["run"]
    environment = {
        "PATH": os.environ["PATH"], "RUNNER_TEMP": str(tmp_path), "REPOSITORY": repository, "COMMIT": commit, "ACT": act
    }  # fmt: skip
    answer = subprocess.run(
        ["bash", "-e", "-c", script], cwd=tmp_path, env=environment, capture_output=True, text=True, check=False
    )
    assert answer.returncode == code
    assert answer.stdout.count("::error::") == (1 if code else 0)
    assert (tmp_path / ".repro-action").is_symlink() == bool(code)
    assert (tmp_path / "elsewhere/kept").exists()


NARROW = (
    "ref", "registry", "image", "tag-prefix", "tag-suffix", "path", "config", "date", "kind", "distro",
    "build-tool", "cuda", "python", "platforms",
)  # fmt: skip


def test_a_concurrency_group_is_of_one_workflow_one_branch_and_one_call() -> None:
    """Two that differ in anything by which the image differs would cancel or hold up each other."""
    group = load(ROOT / ".github/workflows/image.yml")["concurrency"]["group"]
    parts = ["github.workflow_ref", "github.ref", *(f"inputs.{name}" for name in NARROW)]
    assert group == "repro-action:" + ":".join(f"${{{{ {part} }}}}" for part in parts)


TOKEN = re.compile(r"github\.token|secrets\.GITHUB_TOKEN")
API = re.compile(r"^\s*(?:ROSLAB_GITHUB_TOKEN|ROSLAB_SOURCE_TOKEN): ")
"""Settings that send it to GitHub itself: its API, and its repositories."""


@pytest.mark.parametrize("path", [ROOT / "action.yml", *CALLABLE], ids=lambda path: path.name)
def test_the_runs_own_token_goes_to_ghcr_alone(path: Path) -> None:
    """Where an expression can yield the run's token, it does so for ghcr.io only; GitHub's own API is no registry."""
    for line in path.read_text().splitlines():
        if TOKEN.search(line) and "_GIVEN:" not in line and not API.search(line):
            own = r"(outputs\.registry == 'ghcr\.io'|\(inputs\.registry == 'ghcr\.io' \|\| inputs\.registry == ''\))"
            assert re.search(own + r" && github\.token\) \|\| '' \}\}$", line), line


PINNED = {
    "docker/setup-buildx-action": ("version", "driver-opts"),
    "docker/setup-qemu-action": ("image",),
    "docker/build-push-action": ("sbom",),
}
"""Settings by which an action is told which program or image to fetch, and fetches the newest where it is not."""
FLOATING = re.compile(r"moby/buildkit|tonistiigi/binfmt|buildkit-syft-scanner|:latest\b|:stable\b")


def _steps(path: Path) -> list[dict[str, Any]]:
    found = load(path)
    return (
        found["runs"]["steps"] if "runs" in found else [s for j in found["jobs"].values() for s in j.get("steps", [])]
    )


@pytest.mark.parametrize("path", [ROOT / "action.yml", *CALLABLE], ids=lambda path: path.name)
def test_what_a_build_fetches_is_pinned_in_one_table(path: Path) -> None:
    for step in _steps(path):
        for name in PINNED.get(str(step.get("uses")).partition("@")[0], ()):
            assert re.fullmatch(r"\$\{\{ steps\.(ready|dockerfile)\.outputs\.[a-z-]+ \}\}", step["with"][name]), name
    assert not FLOATING.search(path.read_text())


def test_no_module_names_an_image_of_the_builders() -> None:
    for path in (ROOT / "scripts").rglob("*.py"):
        assert not re.search(r"moby/buildkit[:@]|tonistiigi/binfmt[:@]|syft-scanner[:@]", path.read_text()), path


@pytest.mark.parametrize(
    "path", [ROOT / "action.yml", ROOT / ".github/workflows/image.yml"], ids=lambda path: path.name
)
def test_only_the_program_writes_the_summary(path: Path) -> None:
    """The action that builds adds one of its own, with labels and arguments as they are, HTML included."""
    (build,) = (step for step in _steps(path) if str(step.get("uses")).startswith("docker/build-push-action@"))
    assert build["env"]["DOCKER_BUILD_SUMMARY"] == "false"


DOCKER = re.compile(r"^docker/(?!metadata-action)| github (?:dockerfile|explain|prove|index|tag)\b")


@pytest.mark.parametrize(
    "path", [ROOT / "action.yml", ROOT / ".github/workflows/image.yml"], ids=lambda path: path.name
)
def test_every_step_that_speaks_with_docker_has_the_private_folder(path: Path) -> None:
    found = load(path)
    jobs = [found["runs"]["steps"]] if "runs" in found else [job["steps"] for job in found["jobs"].values()]
    expected = "${{ steps.ready.outputs.docker-config }}"
    for steps in jobs:
        speaking = [step for step in steps if DOCKER.search(str(step.get("uses")) + str(step.get("run")))]
        assert [step["name"] for step in speaking if step.get("env", {}).get("DOCKER_CONFIG") != expected] == []
        assert not speaking or steps[-1]["name"] == "Forget the passwords"
        assert not speaking or steps[-1]["if"].startswith("always()")


def test_the_action_has_at_most_twelve_inputs_and_each_has_a_sentence() -> None:
    found = load(ROOT / "action.yml")
    assert len(found["inputs"]) <= 12
    for name, entry in {**found["inputs"], **found["outputs"]}.items():
        assert re.fullmatch(r"[a-z]+(-[a-z]+)*", name)
        assert re.fullmatch(r"[A-Z].*\.", entry["description"]), f"{name}: no sentence"


@pytest.mark.parametrize("path", CALLABLE, ids=lambda path: path.name)
def test_a_callable_workflow_takes_its_rights_from_its_caller(path: Path) -> None:
    found = load(path)
    assert set(found[True]) == {"workflow_call"}
    assert "permissions" not in found
    assert not [name for name, job in found["jobs"].items() if "permissions" in job]
    for name, entry in {**called(path)["inputs"], **called(path)["outputs"]}.items():
        assert re.fullmatch(r"[A-Z].*\.", entry["description"]), f"{name}: no sentence"


@pytest.mark.parametrize("path", THIN, ids=lambda path: path.name)
def test_a_thin_workflow_hands_on_every_input_as_it_is(path: Path) -> None:
    (job,) = load(path)["jobs"].values()
    assert job["uses"] == "./.github/workflows/image.yml"
    own, common = called(path)["inputs"], called(ROOT / ".github/workflows/image.yml")["inputs"]
    assert job["with"] == {"kind": path.stem, **{name: f"${{{{ inputs.{name} }}}}" for name in own}}
    assert {name: entry["default"] for name, entry in own.items()} == {name: common[name]["default"] for name in own}


def test_no_expression_in_a_script() -> None:
    for path in EVERYTHING:
        found = load(path)
        steps = (
            found["runs"]["steps"]
            if "runs" in found
            else [s for j in found["jobs"].values() for s in j.get("steps", [])]
        )
        for step in steps:
            assert "${{" not in step.get("run", ""), f"{path.name}: {step['name']}"


def test_an_id_is_read_somewhere() -> None:
    for path in EVERYTHING:
        text = path.read_text()
        for name in re.findall(r"^\s+id: (\S+)$", text, flags=re.MULTILINE):
            assert f"steps.{name}." in text, f"{path.name}: nothing reads the id {name}"


def _uses_of_ours(text: str) -> list[tuple[str, dict[str, Any]]]:
    """Return what a YAML text uses of this repository, and the settings it gives."""
    found: list[tuple[str, dict[str, Any]]] = []

    def walk(node: Any) -> None:
        if isinstance(node, dict):
            uses = node.get("uses")
            if isinstance(uses, str) and uses.startswith(OURS):
                found.append((uses.partition("@")[0].removeprefix(OURS).strip("/"), node.get("with") or {}))
            for child in node.values():
                walk(child)
        elif isinstance(node, list):
            for child in node:
                walk(child)

    walk(yaml.safe_load(text))
    return found


def _snippets() -> list[tuple[str, str]]:
    pages = [ROOT / "README.md", ROOT / "workflows/README.md", *sorted((ROOT / "docs").glob("*.md"))]
    found = [(path.name, path.read_text()) for path in STARTERS]
    for page in pages:
        blocks = re.findall(r"^```ya?ml\n(.*?)^```", page.read_text(), flags=re.MULTILINE | re.DOTALL)
        found += [(str(page.relative_to(ROOT)), block) for block in blocks]
    return found


@pytest.mark.parametrize(("name", "text"), _snippets())
def test_what_a_caller_copies_names_only_what_exists(name: str, text: str) -> None:
    for path, settings in _uses_of_ours(text):
        inputs = load(ROOT / "action.yml")["inputs"] if not path else called(ROOT / path)["inputs"]
        assert set(settings) <= set(inputs), f"{name}: {path or 'action.yml'}"


def test_there_is_a_starter_for_every_workflow() -> None:
    used = {path for starter in STARTERS for path, _ in _uses_of_ours(starter.read_text())}
    assert used == {f".github/workflows/{path.name}" for path in CALLABLE} | {""}


def test_no_starter_asks_for_more_than_it_needs() -> None:
    for path in STARTERS:
        found = load(path)
        assert found["permissions"] == {}
        publishes = path.name not in ("pull-request.yml", "watch.yml", "drift.yml")
        cleans = path.name in ("clean.yml", "pull-request-closed.yml")
        expected = {"contents": "read", "packages": "write"} if publishes else {"contents": "read"}
        expected |= {"id-token": "write", "attestations": "write"} if publishes and not cleans else {}
        expected |= {"pull-requests": "read"} if path.name == "clean.yml" else {}
        expected |= {"packages": "read", "issues": "write"} if path.name == "drift.yml" else {}
        *others, last = (job["permissions"] for job in found["jobs"].values())
        assert last == expected, path.name
        assert [each for each in others if each != {"contents": "read"}] == [], path.name


def test_actionlint(tool: Tool) -> None:
    run(tool("actionlint"))
    run(tool("actionlint"), "-config-file", ".github/actionlint.yaml", *STARTERS)


def test_zizmor(tool: Tool) -> None:
    strict = ("--offline", "--no-progress", "--persona", "pedantic", "--strict-collection")
    run(tool("zizmor"), *strict, ".")
    run(tool("zizmor"), *strict, *STARTERS)


def test_schemas(tool: Tool) -> None:
    check = tool("check-jsonschema")
    run(check, "--builtin-schema", "vendor.github-actions", "action.yml")
    run(check, "--builtin-schema", "vendor.github-workflows", *WORKFLOWS, *STARTERS)
    run(check, "--builtin-schema", "vendor.gitlab-ci", "workflows/gitlab-ci.yml")
    run(check, "--builtin-schema", "vendor.dependabot", ".github/dependabot.yml")


def test_shellcheck(tmp_path: Path, tool: Tool) -> None:
    """actionlint checks the scripts of workflows only: those of the action are written out and checked here."""
    for number, step in enumerate(load(ROOT / "action.yml")["runs"]["steps"]):
        if "run" in step:
            script = tmp_path / f"{number}.sh"
            script.write_text(f"#!/usr/bin/env bash\nset -eo pipefail\nexport PYTHON=\n{step['run']}\n")
            run(tool("shellcheck"), "--exclude=SC2250", script)
