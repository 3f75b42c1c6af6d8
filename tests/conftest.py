"""What every test may use: the command line as a user runs it, the examples, and a count of what passed."""

from __future__ import annotations

import gc
import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile
from collections import Counter, defaultdict
from collections.abc import Callable, Generator, Iterator, Mapping
from contextlib import suppress
from functools import cache
from itertools import count
from pathlib import Path
from typing import Any

import pytest

from lab import durations, why
from lab.home import memory

ROOT = Path(__file__).resolve().parent.parent
KINDS = ("unit", "golden", "bad_input", "lab", "lint")
"""Folders of tests; each is a marker of the same name."""
Roslab = Callable[..., "subprocess.CompletedProcess[str]"]


@pytest.fixture(scope="session")
def checkout() -> Path:
    """Return the root of this repository."""
    return ROOT


@pytest.fixture(scope="session")
def examples() -> Path:
    """Return the folder of the examples."""
    return ROOT / "examples"


@pytest.fixture(scope="session")
def shared() -> Path:
    """Return the folder of material that lies beside the checkout, not in it; without it the test is skipped."""
    folder = Path(os.environ.get("REPRO_SHARED") or ROOT.parent / "shared")
    if not folder.is_dir():
        pytest.skip(f"no folder {folder}: name it with REPRO_SHARED")
    return folder


@pytest.fixture(scope="session")
def in_memory() -> Iterator[Path | None]:
    """Give a folder of this process whose files lie in memory, ``None`` where there can be none."""
    room = memory()
    if room is None:
        yield None
        return
    folder = Path(tempfile.mkdtemp(prefix="repro-tests-", dir=room))
    yield folder
    with suppress(OSError):  # what a test that failed wrote is kept
        folder.rmdir()


@pytest.fixture
def tmp_path(request: pytest.FixtureRequest, in_memory: Path | None) -> Iterator[Path]:
    """Give a test its own folder as pytest does, but in memory: nearly every test writes a small tree and removes it.

    Those of the lab, whose files may be large, have theirs on the disk, and those that are marked so.
    """
    if in_memory is None or _kind(request.node.nodeid) == "lab" or request.node.get_closest_marker("on_disk"):
        yield request.getfixturevalue("tmp_path")
        return
    name = re.sub(r"\W", "_", request.node.name)[:30]  # as pytest names it
    folder = next(place for number in count() if not (place := in_memory / f"{name}{number}").exists())
    folder.mkdir()
    failed = request.session.testsfailed
    yield folder
    if request.session.testsfailed == failed:
        shutil.rmtree(folder, ignore_errors=True)


@pytest.fixture(scope="session")
def roslab() -> Roslab:
    """Return a function that runs ``roslab ARGUMENTS`` in a process of its own, as the action does.

    It takes ``cwd``, ``env`` (added to the environment of the tests, ``None`` removes a name), ``memory`` (bytes of
    address space) and ``timeout`` (seconds). No run may show a traceback, whatever it was given.
    """

    def run(
        *arguments: str | Path,
        cwd: Path | None = None,
        env: Mapping[str, str | None] | None = None,
        memory: int | None = None,
        timeout: float = 300.0,
    ) -> subprocess.CompletedProcess[str]:
        # The tests may themselves run in a workflow: the program must not take that for a run of the action
        settings = {name: value for name, value in os.environ.items() if not name.startswith(("GITHUB_", "ROSLAB_"))}
        settings = {name: value for name, value in {**settings, **(env or {})}.items() if value is not None}

        def limit() -> None:
            if memory:
                resource.setrlimit(resource.RLIMIT_AS, (memory, memory))

        answer = subprocess.run(
            [sys.executable, "-I", str(ROOT / "scripts"), *map(str, arguments)],
            cwd=cwd,
            env=settings,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            errors="surrogateescape",
            timeout=timeout,
            check=False,
            preexec_fn=limit if memory else None,
        )
        assert "Traceback" not in answer.stderr, answer.stderr
        assert "roslab: a bug" not in answer.stderr, answer.stderr
        return answer

    return run


@pytest.fixture(scope="session")
def tool() -> Callable[[str], str]:
    """Return a function that finds a program; without it the test is skipped, or fails where all must be there."""

    def find(name: str) -> str:
        places = os.pathsep.join([str(Path(sys.executable).parent), os.environ.get("PATH", os.defpath)])
        if found := shutil.which(name, path=places):
            return found
        message = f"{name} is not installed: `bash tests/setup` does it"
        if os.environ.get("REPRO_REQUIRE_ALL") == "1":
            pytest.fail(message)
        pytest.skip(message)

    return find


def _kind(nodeid: str) -> str | None:
    parts = nodeid.split("/")
    return parts[1] if parts[0] == "tests" and len(parts) > 2 and parts[1] in KINDS else None


@cache
def _seconds() -> dict[str, float]:
    return durations.known()


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Look for no garbage while the tests are collected, nor among them later: all of them stay until the end."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.enable()


@pytest.hookimpl(optionalhook=True)
def pytest_configure_node(node: Any) -> None:
    """Have every process of pytest-xdist sort by the same durations, whatever another run writes meanwhile."""
    node.workerinput["durations"] = _seconds()


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Give every test the marker of its folder, so that `-m unit` needs no line in any file.

    A test of the lab that fails is run once more: an engine, a builder, two registries and emulated machines work for
    four at once, and one of them may fail for once. What fails by the project's own fault fails twice.
    """
    for item in items:
        if kind := _kind(item.nodeid):
            item.add_marker(kind)
        if kind == "lab":
            item.add_marker(pytest.mark.flaky(reruns=1))
    known = config.workerinput["durations"] if hasattr(config, "workerinput") else _seconds()
    took = durations.of_files((item.nodeid for item in items if _kind(item.nodeid) == "lab"), known)
    items.sort(key=lambda item: _turn(item.nodeid, took))


def _turn(nodeid: str, took: Mapping[str, float]) -> tuple[int, float]:
    """Return when a test has its turn: what takes milliseconds first, of the lab's files the longest first.

    A wrong word is then told before the engine has warmed up, and no process is left alone with a long file at the end.
    ``took`` are the seconds of each file.
    """
    return (1, -took[_file(nodeid)]) if _kind(nodeid) == "lab" else (0, 0.0)


def _file(nodeid: str) -> str:
    return nodeid.partition("::")[0]


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Name the number of tests of each kind that passed, as the last word on a run; keep how long the lab's took.

    Before that comes what ended each run of a workflow: its whole log stands above, and may be cut where that is shown.
    So does that of a test that passed when it was run once more: why it failed at first may be worth a look.
    """
    _keep_durations(terminalreporter)
    for outcome, what in (("failed", "the run"), ("rerun", "the first run")):
        for report in terminalreporter.getreports(outcome):
            terminalreporter.write_sep("-", f"what ended {what} of {report.nodeid}")
            said = why.of_run(report.longreprtext) or "\n".join(report.longreprtext.splitlines()[-why.BEFORE :])
            terminalreporter.write_line(said)
    passed = Counter(_kind(report.nodeid) for report in terminalreporter.getreports("passed"))
    counts = ", ".join(f"{passed[kind]} {kind.replace('_', '-')}" for kind in KINDS)
    terminalreporter.write_sep("=", f"passed: {counts} tests")


def _keep_durations(reporter: pytest.TerminalReporter) -> None:
    took: dict[str, float] = defaultdict(float)
    ended = [report for kind in ("passed", "skipped") for report in reporter.getreports(kind)]
    lab = {report.nodeid for report in ended if _kind(report.nodeid) == "lab"}
    for report in (*ended, *reporter.getreports("")):  # "": set-up and what comes after
        if report.nodeid in lab:
            took[report.nodeid] += report.duration
    durations.keep(took)
