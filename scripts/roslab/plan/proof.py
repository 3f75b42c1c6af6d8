"""What is run inside an image before it gets a tag: the repository's own test, else a default one for its kind."""

from __future__ import annotations

import shlex
from collections.abc import Iterable
from dataclasses import replace
from typing import Literal

from packaging.version import Version

from roslab.decide.decision import Decision
from roslab.knowledge.distros import python_of_ubuntu
from roslab.plan.workspace import ROS_TOOLS
from roslab.values.dataclass import dataclass
from roslab.values.interpreter import Interpreter
from roslab.values.requirement import Requirement

ProofRung = Literal[0, 1, 4]
"""Rungs of the ladder with commands of their own; 2, 3 and 5 are seen while the default command runs."""
LONGEST = 200
"""Most characters of a command that are shown."""
IMPORT_SCRIPT = """\
import importlib, importlib.metadata as metadata, sys
names, failed = sys.argv[1:], {}
for name in names:
    try:
        distribution = metadata.distribution(name)
    except metadata.PackageNotFoundError:
        failed[name] = "not installed"
        continue
    listed = (distribution.read_text("top_level.txt") or "").split()
    packages = {str(f).split("/")[0] for f in distribution.files or () if str(f).endswith("/__init__.py")}
    for module in listed or sorted(packages):
        if not module.isidentifier() or module.startswith("_") or module in ("docs", "examples", "test", "tests"):
            continue
        try:
            importlib.import_module(module)
        except Exception as error:
            failed[name] = f"import {module}: {type(error).__name__}: {error}"
print("imported", len(names) - len(failed), "of", len(names), "packages")
sys.exit("\\n".join(f"{name}: {why}" for name, why in failed.items()) or 0)
"""
"""A package and its module may have different names (``opencv-python``, ``cv2``): the package's files tell."""

AMENT_SCRIPT = """\
import os, sys
prefixes = os.environ.get("AMENT_PREFIX_PATH", "").split(":")
failed = 0
for name in sys.argv[1:]:
    marker = os.path.join("share", "ament_index", "resource_index", "packages", name)
    found = [prefix for prefix in prefixes if os.path.exists(os.path.join(prefix, marker))]
    print(name, "in", found[0] if found else "none of AMENT_PREFIX_PATH")
    failed |= not found
sys.exit(failed)
"""
"""The index that ``ros2 pkg`` and ament_index_python read; a base without ros2cli has it too.
https://github.com/ament/ament_cmake/blob/rolling/ament_cmake_core/doc/resource_index.md"""


ROSTEST_SCRIPT = 'failed=0; for file in "$@"; do rostest "$file" || failed=1; done; exit $failed'
MOST_TESTS = 3
"""Most launch files with tests that are tried; each starts a ROS of its own."""
TEST_SECONDS = 120
"""Seconds that tests of the tree may take together, which nobody asked for."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Proof:
    """One command that is run in a container of the image."""

    name: str
    command: tuple[str, ...]
    """An argv, started through the image's entry point."""
    required: bool = True
    """If it fails, the image gets no tag; otherwise it is only tried and told."""
    limit: int | None = None
    """Seconds after which it has failed, ``None`` for the usual."""
    guessed: bool = False
    """Nobody named the command, and it may be a wrong one."""
    may_run_on: bool = False
    """It may run without an end: still running after the proof's seconds counts as passed, like exit code 0."""
    display: bool = False
    """It opens windows: it runs with a virtual display, of which a picture is kept."""
    rung: ProofRung | None = None
    """The rung of the ladder that it belongs to; ``None``: an image without a program, of which a shell is started."""
    graph: Literal["ros1", "ros2"] | None = None
    """Whose nodes and topics are looked at while it runs."""


def proofs(decision: Decision) -> tuple[Proof, ...]:
    """Return the proofs of an image, in the order in which they are run: that of the ladder.

    The repository's own test decides alone: whoever writes one says what has to work. The rest is then only told.
    """
    installed, start = _installed(decision), _start(decision)
    if not decision.test:
        return (*installed, start, *_found_tests(decision))
    command = ("bash", "-c", decision.test) if isinstance(decision.test, str) else decision.test
    test = Proof(name="the repository's test", command=command, display=decision.gui, rung=4)
    told = (replace(proof, required=False) for proof in (*installed, *([start] if start.rung else [])))
    return (*told, test)


def _installed(decision: Decision) -> list[Proof]:
    if decision.dockerfile is not None:
        return []
    found = _workspace_proofs(decision)
    distributions = _declared_distributions(decision)
    if distributions:
        version = decision.python.version or python_of_ubuntu().get(decision.ubuntu or "")
        found.append(_import_proof(version, distributions))
    on_python2 = Interpreter(pythons=("2.7",), platforms=decision.platforms)
    if beside := _names(decision.python.python2, on_python2):
        command = ("python2", "-m", "pip", "show", *beside)
        found.append(Proof(name="declared packages of Python 2 are installed", command=command))
    return [replace(proof, rung=0) for proof in found]


def _found_tests(decision: Decision) -> list[Proof]:
    """Return tests of the tree, which nobody promised to pass: they are tried and told."""
    files = decision.rostests[:MOST_TESTS]
    if not files or decision.workspace == "none" or decision.build_tool not in ROS_TOOLS:
        return []
    all_of = len(decision.rostests)
    name = (
        "the repository's rostests" if len(files) == all_of else f"{len(files)} of the repository's {all_of} rostests"
    )
    command = ("bash", "-c", ROSTEST_SCRIPT, "proof", *files)
    return [Proof(name=name, command=command, required=False, rung=4, limit=TEST_SECONDS)]


def _start(decision: Decision) -> Proof:
    # The author's Dockerfile has a CMD of its own, which an empty command runs.
    start: tuple[str, ...] | str = () if decision.dockerfile else decision.command
    argv = ("bash", "-c", start) if isinstance(start, str) else start
    said = bool(decision.dockerfile or decision.command_named) or argv[:1] == ("bash",)
    name = "the default command starts"
    shell = argv == ("bash",)  # without a terminal it ends at once: no program of the repository has started
    return Proof(
        name=name,
        command=argv,
        required=said,
        guessed=not said,
        may_run_on=True,
        display=decision.gui and not shell,
        rung=None if shell else 1,
        graph=None if shell or decision.kind not in ("ros1", "ros2") else decision.kind,
    )


def _workspace_proofs(decision: Decision) -> list[Proof]:
    if decision.kind not in ("ros1", "ros2") or not decision.package_names or decision.workspace == "none":
        return []
    if decision.build_tool not in ROS_TOOLS:  # the repository is no package of a workspace
        return []
    if decision.kind == "ros1":
        script = 'failed=0; for package in "$@"; do rospack find "$package" || failed=1; done; exit $failed'
        command = ("bash", "-c", script, "proof", *decision.package_names)
    else:
        command = ("python3", "-c", AMENT_SCRIPT, *decision.package_names)
    return [Proof(name="the workspace's packages are found", command=command)]


def _import_proof(version: str | None, distributions: list[str]) -> Proof:
    if version and Version(version) < Version("3.8"):
        # No importlib.metadata before 3.8: ask pip for each package
        python = "python2" if version.startswith("2") else "python3"
        return Proof(
            name="declared Python packages are installed", command=(python, "-m", "pip", "show", *distributions)
        )
    return Proof(name="declared Python packages import", command=("python3", "-c", IMPORT_SCRIPT, *distributions))


def _declared_distributions(decision: Decision) -> list[str]:
    """Return the declared packages, without guesses and without conda packages, which have names of their own."""
    python = decision.python
    others = {*python.pip_guessed, *python.python2} - {*python.pip}
    asked = python.pip if python.manager == "conda" else decision.pip
    return _names((each for each in asked if each not in others), python.interpreter.on(*decision.platforms))


def _names(asked: Iterable[Requirement], image: Interpreter) -> list[str]:
    """Return the packages that pip installs on every platform: the same proof runs on all of them.

    Bare URLs are left out: the name was only guessed from the URL.
    """
    return sorted({each.name for each in asked if each.package and each.name and not each.url and image.must(each)})


def describe(proof: Proof) -> str:
    """Return the command as a person would type it; of a script only the first line, of a long one only the start."""
    words = [
        f"{first} …" if (first := word.partition("\n")[0]) != (whole := word.rstrip("\n")) else whole
        for word in proof.command
    ]
    text = shlex.join(words) or "(the image's own command)"
    return text if len(text) <= LONGEST else text[: LONGEST - 1] + "…"
