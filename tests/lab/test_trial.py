"""A pull request's image to be tried: published under its own tag, or an archive that ``docker load`` reads."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from lab import doors, registry
from lab.act import Result, run_workflow
from lab.kept_artifacts import artifacts
from lab.laboratory import Laboratory

DOORS = pytest.mark.parametrize("door", [doors.through_action, doors.through_workflow], ids=["action", "image"])
RECIPE = doors.RECIPE + "pr: {pr}\ntags: {{suffix: -humble}}\n"
HEAD = "0" * 40


@pytest.fixture
def name(lab: Laboratory) -> str:
    """Return the name of a repository that nothing was pushed to yet, without its owner."""
    return lab.fresh_repository(f"{doors.OWNER}/robot").rpartition("/")[2]


def proposed(  # noqa: PLR0917 - what a pull request is made of
    lab: Laboratory, caller: Path, name: str, head: str, at: str | None = HEAD, artifacts: Path | None = None
) -> Result:
    """Run a pull request that comes from a repository and was at the commit HEAD; its branch is at another now."""
    heads: Mapping[str, str] = {"change": at} if at else {}
    return run_workflow(
        lab, caller, "pull_request", doors.payload(name, head=head), env=doors.builder(lab), github={"heads": heads},
        artifacts=artifacts,
    )  # fmt: skip


@DOORS
def test_our_own_pull_request_is_published_as_its_number(
    lab: Laboratory, tmp_path: Path, name: str, door: Callable[..., Path]
) -> None:
    inputs = {"registry": lab.registry, "platforms": "linux/amd64"}
    caller = door(tmp_path / "caller", inputs, {"roslab.yaml": RECIPE.format(pr="image")})
    ran = proposed(lab, caller, name, f"{doors.OWNER}/{name}")
    assert ran.exit_code == 0, ran.log
    assert registry.tags(f"{doors.OWNER}/{name}") == ("pr-7-humble",)
    assert ran.output("tags") == f"{lab.registry}/{doors.OWNER}/{name}:pr-7-humble"
    assert registry.digest(f"{doors.OWNER}/{name}:pr-7-humble") == ran.output("digest")
    assert ran.log.index("Main Prove the image") < ran.log.index("Main Put the")
    assert "Main Sign the image" not in ran.log
    assert f"Published as `{lab.registry}/{doors.OWNER}/{name}:pr-7-humble`" in ran.summary
    # The same run, started again when the branch has another commit: the tag stays
    again = proposed(lab, caller, name, f"{doors.OWNER}/{name}", "f" * 40)
    assert again.exit_code == 0, again.log
    assert "its tag stays where it is" in again.summary
    assert again.output("tags") == ""
    assert registry.digest(f"{doors.OWNER}/{name}:pr-7-humble") == ran.output("digest")


@DOORS
def test_a_strangers_is_an_archive_that_loads(
    lab: Laboratory, tmp_path: Path, name: str, door: Callable[..., Path]
) -> None:
    inputs = {"registry": lab.registry, "platforms": "linux/amd64"}
    caller = door(tmp_path / "caller", inputs, {"roslab.yaml": RECIPE.format(pr="image")})
    store = tmp_path / "store"
    ran = proposed(lab, caller, name, "stranger/robot", artifacts=store)
    assert ran.exit_code == 0, ran.log
    assert f"{doors.OWNER}/{name}" not in registry.repositories()
    assert "Main Log in" not in ran.log
    ((kept, data),) = ((kept, data) for kept, data in artifacts(store).items() if kept.endswith(".tar.gz"))
    file = tmp_path / Path(kept).name
    file.write_bytes(data)
    assert f"docker load \\\n  --input {file.name}\n" in ran.summary
    assert re.search(rf"gh run download \d+ \\\n  --repo {doors.OWNER}/{name} \\\n  --name try-\S+-1\n", ran.summary)
    assert "outside this repository" in ran.summary
    docker = ["docker", "--host", lab.docker_host]
    loaded = subprocess.run([*docker, "load", "--input", file], capture_output=True, text=True, check=True).stdout
    image = f"{name}:pr-7-humble"
    assert image in loaded
    try:
        said = subprocess.run([*docker, "run", "--rm", image], capture_output=True, text=True, check=True).stdout
        assert said.strip() == "x86_64"
    finally:
        subprocess.run([*docker, "image", "rm", image], capture_output=True, check=False)
