"""Nodes that the default command starts and that their package, which is of the tree, does not install."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.brought_launches import all_brought, brought, with_brought
from roslab.decide.decision import Warning_
from roslab.evidence.facts import Evidence
from roslab.evidence.launch_file import LaunchFile

MOST = 3


def with_unmade(evidence: Evidence) -> frozenset[str]:
    """Return the paths of the launch files that start such a node, or bring one that does."""
    if not any(launch.unmade for launch in evidence.launch):
        return frozenset()
    brings = brought(evidence)
    whole = ((launch, *all_brought(launch, brings)) for launch in evidence.launch)
    return frozenset(files[0].file for files in whole if any(each.unmade for each in files))


def unmade_nodes(evidence: Evidence, launch: LaunchFile) -> Iterator[Warning_]:
    """Yield a warning for each of a launch file and those that it includes, with the name that is most like it."""
    found = {(each[:2]): (one, each[2]) for one in with_brought(evidence, launch) for each in one.unmade}
    for (package, program), (file, near) in [*found.items()][:MOST]:
        hint = f" (it has {near})" if near else ""
        message = f"the default command starts {program} of the package {package}, which installs no such program{hint}"
        then = "install it in its CMakeLists.txt or setup.py, or set `command` in roslab.yaml"
        yield Warning_(message=f"{message}: {then}", file=file.file, line=file.line)
