"""The launch file that a page shows how to include, with the arguments that it demands."""

from __future__ import annotations

from roslab.config.model import Kind
from roslab.decide.candidate import Candidate
from roslab.decide.launch_calls import demanded
from roslab.decide.reasons import page_of
from roslab.evidence.facts import Evidence


def included(evidence: Evidence, kind: Kind) -> Candidate | None:
    """Return the call of the first launch file of the tree that a page at the root includes.

    Only what has no default is given: what else the page sets belongs to the reader's system. ``None`` if the page
    leaves an argument open that the file demands.
    """
    start = ("roslaunch",) if kind == "ros1" else ("ros2", "launch")
    files = {(each.package, each.file.rpartition("/")[2]): each for each in evidence.launch}
    for said in evidence.mentions:
        if said.topic != "included" or kind not in {"ros1", "ros2"}:
            continue
        package, name, *rest = said.value.split()
        launch = files.get((package, name))
        given = {word.partition(":=")[0]: word for word in rest}
        if launch is not None and not demanded(launch, rest):
            asked = dict.fromkeys(each.name for each in launch.demands)
            argv = (*start, package, name, *(given[each] for each in asked if each in given))
            why = f"{page_of(said.file)} includes it"
            return Candidate(argv=argv, why=why, file=said.file, line=said.line, strong=True)
    return None
