"""The program that is meant where no page runs one: what a page names, or what launch files are called and bring."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator

from roslab.config.model import Kind
from roslab.decide.brought_launches import Brings, all_brought
from roslab.decide.candidate import LAUNCHERS, Candidate, launched_by
from roslab.decide.launch_calls import demanded, launch_calls, started_launch
from roslab.decide.notebook_server import server
from roslab.decide.reasons import page_of
from roslab.decide.scripts import RUNS
from roslab.decide.sections import about_running
from roslab.decide.startable_launches import known
from roslab.evidence.facts import Evidence, Mention
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.name import bare_name
from roslab.values.pattern import pattern

_DEMONSTRATION = ("run", "demo", "main", "bringup", "start", "all", "default", "simulation", "sim", "system", "example")
_SAMPLE = pattern(r"(?:^|/)\.?docs?/")
"""Where a launch file is a sample, often for another package, that the page explains."""
MANY = 8
FEWEST_OTHERS = 3
"""Fewest packages beside a demonstration."""
_SHOWS = pattern(r"(?:^|_)(?:demos?|tutorials?|examples?|samples?)(?:_|$)", re.IGNORECASE)
"""The name of a package that shows something."""
FEWEST_OF_A_RIVAL = 3
"""Fewest launch files of a package for its programs to be as much of the tree as another's."""
_OF_NODE = pattern(r"[_-](?:node|main|ros2?)$")
"""What a node is called beside the name of its package."""
FEWEST = 2
"""Fewest launch files that the one for the whole brings."""
LARGE = 40
"""Of more launch files it brings one of ``LEAST_SHARE``: what brings fewer is the whole of a part."""
LEAST_SHARE = 5
_LAUNCH_FILES = pattern(r"\blaunch[ -]?files?\b", re.IGNORECASE)
_ITEM = pattern(r"(?:[-*+]|\d+[.)])\s+[`*_\[]*[\w/-]+\.launch")
"""An item of a list that begins with a launch file."""
_COMMANDS = pattern(
    r"\.(?:ba)?sh\W.*?\b(?:contains?|lists?|holds?|ha(?:s|ve)|includes?|provides?)\s+(?:\w+\s+){0,3}commands?\b",
    re.IGNORECASE,
)
"""A sentence on scripts: ``a.sh and b.sh contain the commands for both``."""
_SUFFIX = pattern(r"(?:\.launch)?\.(?:launch|py|xml|ya?ml)$|_launch(?:\.\w+)?$")


def pointed_at(evidence: Evidence, kind: Kind) -> Candidate | None:
    """Return the launch file, script or notebook that a page at the root names without running it.

    A section about running it names the first; elsewhere it must be the only one.
    """
    found = [candidate for candidate, _ in _pointed(evidence, kind)]
    shown = [c for c in found if about_running(c.heading) > 0]
    return next(iter(shown or (found if len(found) == 1 and found[0].argv[0] != "bash" else [])), None)


def started_below(evidence: Evidence, kind: Kind, command: tuple[str, ...]) -> tuple[Candidate, ...]:
    """Return the script that a page names so, where it is the command and starts in a folder of its own."""
    found = pointed_at(evidence, kind) if command[0] == "bash" and len(command) > 1 else None
    return (found,) if found and found.inside and found.argv == command else ()


def listed(evidence: Evidence, kind: Kind) -> Candidate | None:
    """Return the first launch file of a list of them at the root: of that, pages below it tell no more than parts."""
    for candidate, said in _pointed(evidence, kind):
        title = candidate.heading.rpartition(" / ")[2]
        if candidate.argv[0] in LAUNCHERS and _ITEM.match(said) and _LAUNCH_FILES.search(title):
            return candidate
    return None


def _pointed(evidence: Evidence, kind: Kind) -> Iterator[tuple[Candidate, str]]:
    """Yield what pages at the root name without running it, each with the line that does."""
    ours = (each for each in evidence.launch if each.package and kind == f"ros{each.ros}")
    owners = {launch.file: launch for launch in ours if not (launch.idle or launch.to_fill or demanded(launch))}
    calls = launch_calls(evidence)
    for said in evidence.mentions:
        argv: tuple[str, ...] = ()
        if _SAMPLE.search(said.value):
            continue
        if said.topic == "pointed" and (launch := owners.get(said.value)):
            start = ("roslaunch",) if kind == "ros1" else ("ros2", "launch")
            argv = (*start, *calls[launch.file])
        elif said.topic == "pointed" and kind not in {"ros1", "ros2"} and _runs(said):
            argv = ("bash", said.value)
        elif said.topic == "pointed" and kind in {"python", "cuda"} and said.value.endswith(".ipynb"):
            argv = (*server(evidence), said.value)
        if argv:
            why = f"{page_of(said.file)} names it"
            there = said.inside if argv[0] == "bash" else ""
            candidate = Candidate(
                argv=argv,
                why=why,
                file=said.file,
                line=said.line,
                strong=True,
                heading=said.heading,
                inside=there,
                files=(said.value,),
            )
            yield candidate, said.text


def _runs(said: Mention) -> bool:
    """Tell whether a script is named like one that starts something, or its sentence says that it has the commands."""
    name = said.value.rpartition("/")[2]
    return name.endswith(SHELL_SCRIPTS) and bool(RUNS.match(name) or _COMMANDS.search(said.text))


def named_like_it(candidates: Iterable[Candidate], evidence: Evidence, brings: Brings) -> Candidate | None:
    """Return the one launch file that is named like its package, else the one named like a demonstration.

    Of many launch files, none is told apart by its name. What another package of the tree includes is a part of that.
    Where there is none, it is the node that is named like the only package which has nodes.
    """
    candidates = tuple(candidates)
    launched = _launched(candidates)
    if not launched:
        return _node_like_its_package(candidates)
    if len(launched) > MANY:
        return None
    launched = [c for c in launched if not _part(c, evidence, brings)]
    launched = [c for c in launched if not _shows_others(c.argv[-2], evidence)]
    own = [c for c in launched if _like_its_package(c)]
    shown = [c for c in launched if _stem(c) in _DEMONSTRATION]
    if len(own) == 1 and _beside_others(own[0], launched, evidence):
        return None
    return own[0] if len(own) == 1 else shown[0] if not own and len(shown) == 1 else None


def _beside_others(candidate: Candidate, launched: Iterable[Candidate], evidence: Evidence) -> bool:
    """Tell whether the name of a launch file is all that it has before those of other packages.

    One of these has as many, and more than a driver's one or two. Its own neither needs or starts any of them, nor is
    needed by one, nor has the name of the repository, of a metapackage or of the whole family: ``planner`` beside
    ``planner_msgs``.
    """
    package = candidate.argv[-2]
    counts = Counter(each.argv[-2] for each in launched)
    fewest = max(counts[package], FEWEST_OF_A_RIVAL)
    rivals = {name for name, count in counts.items() if name != package and count >= fewest}
    whole = {manifest.name for manifest in evidence.manifests if manifest.metapackage}
    whole |= {evidence.origin.rstrip("/").rpartition("/")[2].removesuffix(".git")}
    if not rivals or package in whole or all(name.startswith(package) for name in rivals):
        return False
    asked = {m.name: {d.name for d in m.dependencies} for m in evidence.manifests if m.name and not m.metapackage}
    started = {
        d.name for each in evidence.launch if each.package == package for d in (*each.dependencies, *each.reached)
    }
    related = rivals & (asked.get(package, set()) | started)
    return not related and not any(package in asked.get(name, ()) for name in rivals)


def _shows_others(package: str, evidence: Evidence) -> bool:
    """Tell whether a package is called a demonstration and has nothing to do with the many others of the tree.

    What it shows is then somebody else's: ``tf_demo`` beside a planner and a referee.
    """
    if not _SHOWS.search(package):
        return False
    asked = {m.name: {d.name for d in m.dependencies} for m in evidence.manifests if m.name and not m.metapackage}
    started = {
        d.name for each in evidence.launch if each.package == package for d in (*each.dependencies, *each.reached)
    }
    others = asked.keys() - {package}
    related = others & (started | asked.get(package, set())) or any(package in asked[name] for name in others)
    return len(others) >= FEWEST_OTHERS and not related


def _launched(candidates: Iterable[Candidate]) -> list[Candidate]:
    return [c for c in candidates if launched_by(c.argv)]


def _node_like_its_package(candidates: Iterable[Candidate]) -> Candidate | None:
    """Return the one node that has the name of its package, where no other package has nodes and no page runs any."""
    nodes = [c for c in candidates if c.argv[0] in LAUNCHERS]
    own = [c for c in nodes if bare_name(_OF_NODE.sub("", c.argv[-1])) == bare_name(_OF_NODE.sub("", c.argv[-2]))]
    lone = len({c.argv[:-1] for c in nodes}) == 1 and not any(c.strong for c in nodes)
    return own[0] if lone and len(own) == 1 else None


def _stem(candidate: Candidate) -> str:
    return _SUFFIX.sub("", candidate.argv[-1]).lower()


def _like_its_package(candidate: Candidate) -> bool:
    return _stem(candidate) == candidate.argv[-2].lower()


def _part(candidate: Candidate, evidence: Evidence, brings: Brings) -> bool:
    """Tell whether a launch file of another package brings one; a package's own may only give it other arguments."""
    started, package = started_launch(evidence, candidate.argv), candidate.argv[-2]
    others = (launch for launch in evidence.launch if launch.package not in {None, package} and not launch.tests)
    return any(started in brings[launch.file] for launch in others)


_SHOWN = pattern(r"^(?:examples?|tests?)[_.-]", re.IGNORECASE)
"""A launch file that shows how others are written, or tests them."""


def whole_of(candidates: Iterable[Candidate], evidence: Evidence, brings: Brings) -> Candidate | None:
    """Return the launch file that brings most of the others, itself brought by none: it starts the whole.

    It has to bring two or more, or one of another package that is named like that, of a large collection a fifth, and
    more than any other that nothing brings, and nothing of a package that neither the tree has, nor a package.xml asks
    for, nor any distribution of ROS released. What MoveIt's assistant writes for a demonstration in Gazebo comes behind
    the one beside it without.
    """
    parts = {part.file for brought in brings.values() for part in brought}
    sizes: list[tuple[int, Candidate]] = []
    launched = _launched(candidates)
    plain = {c.argv[-2] for c in launched if _stem(c) == "demo"}
    launched = [c for c in launched if _stem(c) != "demo_gazebo" or c.argv[-2] not in plain]
    fewest = 1 if any(_like_its_package(c) and _part(c, evidence, brings) for c in launched) else FEWEST
    calls = launch_calls(evidence)
    for candidate in launched:
        started = None if candidate.strong else started_launch(evidence, candidate.argv, calls)
        if started and started.file not in parts and not _SHOWN.search(started.file.rpartition("/")[2]):
            below = all_brought(started, brings)
            if all(known(each, evidence) for each in (started, *below)):
                sizes.append((len(below), candidate))
    sizes.sort(key=lambda each: -each[0])
    alone = sizes and sizes[0][0] >= fewest and (len(sizes) == 1 or sizes[1][0] < sizes[0][0])
    part = len(launched) > LARGE and sizes and sizes[0][0] * LEAST_SHARE < len(launched)
    return sizes[0][1] if alone and not part else None
