"""An engine that is absent, silent, too old or failing: each has its own message, and exit code 5."""

from __future__ import annotations

import shlex
from collections.abc import Callable
from pathlib import Path
from subprocess import CompletedProcess

import pytest

Roslab = Callable[..., CompletedProcess[str]]
EXAMPLE = Path(__file__).resolve().parent.parent.parent / "examples" / "python_filter"

ANSWERS = """\
#!/bin/sh
# A stand-in: it answers as docker's own client would in one situation, and does nothing.
case "$1 $2" in
{cases}
*) echo "the stand-in was not told what to say to: $*" >&2; exit 99 ;;
esac
"""


def stand_in(folder: Path, *cases: str) -> dict[str, str | None]:
    """Return an environment in which ``docker`` is a stand-in that knows these cases, and nothing else is on PATH."""
    place = folder / "stand-in"
    place.mkdir()
    program = place / "docker"
    program.write_text(ANSWERS.format(cases="\n".join(f"{case} ;;" for case in cases)))
    program.chmod(0o755)
    return {"PATH": str(place), "DOCKER_HOST": None}


def last(answer: CompletedProcess[str]) -> str:
    """Return the message at the end, after the progress."""
    return "roslab: error:" + answer.stderr.rpartition("roslab: error:")[2]


@pytest.mark.parametrize("command", ["build", "run"])
def test_absent(roslab: Roslab, command: str, tmp_path: Path) -> None:
    answer = roslab(command, EXAMPLE, env={"PATH": str(tmp_path)})
    assert answer.returncode == 5
    assert answer.stderr.startswith("roslab: error: docker is not installed\n  ")
    assert "https://docs.docker.com/engine/install/" in answer.stderr
    assert answer.stdout == ""


def test_not_answering(roslab: Roslab, tool: Callable[[str], str], tmp_path: Path) -> None:
    tool("docker")
    answer = roslab("build", EXAMPLE, env={"DOCKER_HOST": f"unix://{tmp_path}/nobody.sock", "DOCKER_CONTEXT": None})
    assert answer.returncode == 5
    assert answer.stderr.startswith("roslab: error: the Docker engine does not answer: ")
    assert f"unix://{tmp_path}/nobody.sock" in answer.stderr
    assert answer.stderr.endswith("\n  start it, or set DOCKER_HOST to one that runs\n")


@pytest.mark.parametrize("version", ["20.10.24+dfsg1", "22.06.0-beta.0", "19.03.15", "nonsense"])
def test_too_old(roslab: Roslab, version: str, tmp_path: Path) -> None:
    answer = roslab("build", EXAMPLE, env=stand_in(tmp_path, f'"version --format") echo "{version}"'))
    assert answer.returncode == 5
    assert answer.stderr == f"roslab: error: Docker engine {version} is too old\n  version 23 or newer is needed\n"


def test_without_buildx(roslab: Roslab, tmp_path: Path) -> None:
    environment = stand_in(
        tmp_path,
        '"version --format") echo 28.5.2',
        '"buildx version") echo "docker: unknown command: docker buildx" >&2; exit 1',
    )
    answer = roslab("build", EXAMPLE, env=environment)
    assert answer.returncode == 5
    assert answer.stderr == "roslab: error: docker has no buildx\n  install the docker-buildx-plugin package\n"


WORKING = (
    '"version --format") [ "$3" = "{{.Server.Version}}" ] && echo 28.5.2 || echo linux/amd64',
    '"buildx version") echo v0.29.1',
)


def test_a_build_that_fails(roslab: Roslab, tmp_path: Path) -> None:
    log = (
        "#9 [4/6] RUN make-the-thing --quickly",
        "#9 0.412 the thing cannot be made today",
        '#9 ERROR: process "/bin/sh -c make-the-thing --quickly" did not complete successfully: exit code: 3',
    )
    failed = f'"buildx build") printf "%s\\n" {" ".join(map(shlex.quote, log))}; exit 1'
    answer = roslab("build", EXAMPLE, env=stand_in(tmp_path, *WORKING, failed, '"image rm") exit 1'))
    assert answer.returncode == 5
    assert last(answer) == (
        "roslab: error: the build failed in `RUN make-the-thing --quickly`: the thing cannot be made today\n"
        "  no known cause: the lines before it in the log say more\n"
    )
    assert answer.stdout == ""


def test_an_image_that_fails_its_proof(roslab: Roslab, tmp_path: Path) -> None:
    """It gets no name, and what was built goes away again."""
    record = tmp_path / "removed"
    environment = stand_in(
        tmp_path,
        *WORKING,
        '"buildx build") exit 0',
        '"run --init") echo "Segmentation fault"; exit 139',
        f'"image rm") echo "$3" >>{record}',
    )
    answer = roslab("build", EXAMPLE, env=environment)
    assert answer.returncode == 5
    assert last(answer).startswith("roslab: error: python_filter:latest was not named: on linux/amd64, ")
    assert "failed with exit code 139" in last(answer)
    assert "    Segmentation fault\n" in answer.stderr
    assert record.read_text().startswith("python_filter:roslab-candidate-")
    assert answer.stdout == ""


def test_an_old_engine_is_no_reason_not_to_plan(roslab: Roslab, tmp_path: Path) -> None:
    for command in ("inspect", "plan", "check"):
        answer = roslab(command, EXAMPLE, env={"PATH": str(tmp_path)})
        assert answer.returncode == 0, answer.stderr
