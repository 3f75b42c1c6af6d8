"""Repositories in which there is nothing to build."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from roslab.config.model import Config
from roslab.decide.ros.source_names import plain
from roslab.errors import NothingToBuildError, Problem
from roslab.evidence.facts import Evidence
from roslab.evidence.prose.octave import file_of
from roslab.repository.checkout import File, printable
from roslab.values.dataclass import replace

ROOT = "is this the root of the repository? a roslab.yaml can say what it needs"
MOST_BRANCHES = 8
"""Most branches that are named."""
MOST = 3
"""Most files that are named."""


def require_something(evidence: Evidence, config: Config, folder_name: str) -> None:
    """Raise ``NothingToBuildError`` where neither the folder nor roslab.yaml gives anything to build.

    A page of it that links to others, or has the repository itself cloned, is nothing.
    """
    sources = [git for git in evidence.sources if git.kind != "link" and plain(git.name) != plain(folder_name)]
    found = (
        *(evidence.manifests, evidence.cmake, evidence.python, evidence.requirements, evidence.conda),
        *(evidence.makefiles, evidence.dockerfiles, evidence.programs, evidence.notebooks),
        *(sources, evidence.code, evidence.cuda_files),
        *(mention for mention in evidence.mentions if file_of(mention)),
    )
    if any(found) or config.file:
        return
    tools = {each.value: each.file for each in evidence.mentions if each.topic == "other_builder"}
    hint = ROOT
    if tools:
        named = " and ".join(f"{tool} builds {file}" for tool, file in tools.items())
        hint = (
            f"{named}, and no step of the image calls it: give a Dockerfile, or call it under `custom` in roslab.yaml"
        )
    raise NothingToBuildError(
        Problem(
            message="nothing to build was found: no package.xml, CMakeLists.txt, setup.py, pyproject.toml, "
            "requirements file, conda environment, Dockerfile, Python program or C++ source",
            hint=hint,
        )
    )


def with_branches(problems: tuple[Problem, ...], branches: Sequence[str]) -> tuple[Problem, ...]:
    """Return problems with the other branches of the repository in their hint, if there are any."""
    if not branches:
        return problems
    more = f" and {len(branches) - MOST_BRANCHES} more" if len(branches) > MOST_BRANCHES else ""
    named = ", ".join(map(printable, branches[:MOST_BRANCHES]))
    first = printable(branches[0])
    hint = (
        f"the code may be on another branch: {named}{more}; check it out (`git checkout {first}`), or give a workflow"
        f" `ref: {first}`"
    )
    return tuple(replace(each, hint=hint) if each.hint == ROOT else each for each in problems)


def of_ros(evidence: Evidence, lists: Iterable[File]) -> str:
    """Return which launch files and ``lists`` of repositories there are, ``""`` for none."""
    files = sorted({*(each.file for each in evidence.launch), *(each.path for each in lists)})
    if not files:
        return ""
    more = f" and {len(files) - MOST} more" if len(files) > MOST else ""
    named = ", ".join(map(printable, files[:MOST]))
    return f"; what is there of ROS ({named}{more}) names packages of others alone"


def of_node(found: str) -> Problem:
    """Return the problem of a tree that is a project of Node.js alone; ``found`` says what there is."""
    return Problem(
        message=f"nothing to build was found but a Node.js project (package.json), which this program does not build; "
        f"{found}",
        hint="give a Dockerfile, or install Node.js and build it under `custom` in roslab.yaml",
    )


def of_matlab(files: int, found: str, *, octave: bool) -> Problem:
    """Return the problem of a tree whose only code are files of MATLAB; ``found`` says what else there is.

    ``octave``: nothing shows that Octave cannot run them.
    """
    otherwise = "; if it runs with Octave: `apt: [octave]` and `command: octave`" if octave else ""
    return Problem(
        message=f"nothing to build was found but MATLAB code: {files} .m file{'s' * (files > 1)}; "
        f"MATLAB is licensed and never in an image; {found}",
        hint="to start it with the MATLAB of the host, write its folder in roslab.yaml: `matlab: {host_path: "
        f"/usr/local/MATLAB/R2020b}}`{otherwise}",
    )
