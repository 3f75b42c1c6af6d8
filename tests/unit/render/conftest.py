"""What the tests of this room share: a plan to render, and docker as a script sees it."""

from __future__ import annotations

import dataclasses
import os
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from roslab.config.model import Config
from roslab.decide.decision import Decision
from roslab.decide.python.image_python import Python
from roslab.plan.plan import Plan, make_plan
from roslab.plan.python import PythonPlan
from roslab.plan.run import Run
from roslab.plan.workspace import Workspace
from roslab.render import image_scripts


def make(**changes: Any) -> Plan:
    """Return the plan of a small Python repository; ``changes`` are fields of Plan, Run, Workspace or Python."""
    decision = Decision(
        kind="python",
        ros_distro=None,
        ubuntu="noble",
        base_image="ubuntu:24.04",
        build_tool="pip",
        python=Python(version="3.12", manager="venv"),
        command=("python3", "demo.py"),
    )
    found = make_plan(decision, Config(), folder_name="filter")
    for name, part in (("run", Run), ("workspace", Workspace), ("python", PythonPlan)):
        fields = {field.name for field in dataclasses.fields(part)} - {field.name for field in dataclasses.fields(Plan)}
        inner = {key: changes.pop(key) for key in list(changes) if key in fields}
        found = dataclasses.replace(found, **{name: dataclasses.replace(getattr(found, name), **inner)})
    return dataclasses.replace(found, **changes)


@pytest.fixture
def plan() -> Callable[..., Plan]:
    """Return a function that makes plans."""
    return make


STAND_IN = """\
#!/usr/bin/env bash
# A stand-in for docker: it records what it was called with, and runs nothing
case "$1 ${2:-}" in
  "--version "*) echo "${STAND_IN_PRODUCT:-Docker version 28.2.2, build e6534b4}" ;;
  "version "*)
    if [[ -n "${STAND_IN_DOWN:-}" ]]; then echo "Cannot connect to the Docker daemon at unix:///x" >&2; exit 1; fi
    echo "${STAND_IN_VERSION:-28.2.2}" ;;
  "buildx "*) [[ -z "${STAND_IN_NO_BUILDX:-}" ]] ;;
  "info "*) echo "${STAND_IN_RUNTIMES:-{\\"runc\\":{\\}\\}}" ;;
  "image inspect") [[ -z "${STAND_IN_NO_IMAGE:-}" ]] ;;
  *)
    printf '%s\\0' "$@" >"${STAND_IN_RECORD}/argv"
    printf '%s' "${JUPYTER_TOKEN:-}" >"${STAND_IN_RECORD}/token"
    for word in "$@"; do
      case "${word}" in
        */Xauthority:*)
          key="${word%%:*}"
          cp -- "${key}" "${STAND_IN_RECORD}/key"
          stat -c '%a %u' "$(dirname -- "${key}")" >"${STAND_IN_RECORD}/key-folder"
          ;;
      esac
    done
    exit "${STAND_IN_STATUS:-0}"
    ;;
esac
"""


class Called(NamedTuple):
    """What a script did: its exit code and output, and what docker was given (``None``: it was not called)."""

    status: int
    out: str
    err: str
    argv: list[str] | None
    record: Path

    @property
    def arguments(self) -> list[str]:
        """The arguments, where docker was called."""
        assert self.argv is not None, self.err
        return self.argv

    def values(self, option: str) -> list[str]:
        """Return the words after each ``option``."""
        return [after for word, after in zip(self.arguments, self.arguments[1:], strict=False) if word == option]


@pytest.fixture
def call(tmp_path: Path) -> Callable[..., Called]:
    """Return a function that runs a script's text with a recording stand-in for docker on its PATH.

    It takes the arguments, ``env`` (added to a bare environment), ``name`` of the script, and ``folder``.
    """
    programs = tmp_path / "programs"
    programs.mkdir()
    (programs / "docker").write_text(STAND_IN)
    (programs / "docker").chmod(0o755)

    def run(
        text: str,
        *arguments: str,
        env: dict[str, str] | None = None,
        folder: Path | None = None,
        name: str = "docker_run.sh",
        stdin: int | None = subprocess.DEVNULL,
    ) -> Called:
        record = tmp_path / "record"
        shutil.rmtree(record, ignore_errors=True)
        record.mkdir()
        home = tmp_path / "home"
        home.mkdir(exist_ok=True)
        script = (folder or tmp_path) / name
        script.write_text(text)
        settings = {"PATH": f"{programs}:{os.environ['PATH']}", "HOME": str(home), "STAND_IN_RECORD": str(record)}
        answer = subprocess.run(
            ["bash", str(script), *arguments],
            env={**settings, **(env or {})},
            stdin=stdin,
            capture_output=True,
            text=True,
            check=False,
            timeout=30,
        )
        recorded = record / "argv"
        argv = recorded.read_text().split("\0")[:-1] if recorded.exists() else None
        return Called(answer.returncode, answer.stdout, answer.stderr, argv, record)

    return run


@pytest.fixture
def scripts_on_path(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Put the scripts of an image on PATH, under the names that they have there; return their folder."""
    folder = tmp_path / "scripts"
    folder.mkdir()
    for script in Path(image_scripts.__path__[0]).glob("*.sh"):
        (folder / script.stem).write_text(script.read_text())
        (folder / script.stem).chmod(0o755)
    monkeypatch.setenv("PATH", f"{folder}:{os.environ['PATH']}")
    return folder
