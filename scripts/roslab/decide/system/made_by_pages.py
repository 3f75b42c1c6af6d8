"""Folders of a workspace's repository in which a page calls make: no build tool does.

It is called once the workspace is built, or before it where a package links what is made there.
"""

from __future__ import annotations

from roslab.decide.decision import Choice, OwnScript
from roslab.decide.reasons import because, page_of
from roslab.decide.ros.linked_in_place import linked_files
from roslab.decide.system.run_by_pages import ASIDE, MOST
from roslab.evidence import places
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.native.recursive_make import compiled_targets
from roslab.values.dataclass import replace

_WEIGHT = 300


def with_made_by_pages(choice: Choice[tuple[OwnScript, ...]], evidence: Evidence) -> Choice[tuple[OwnScript, ...]]:
    """Return the scripts with a call of make in each of those folders; what fails there is told and stops nothing."""
    linked = tuple(path for path, _ in linked_files(evidence))
    found: dict[str, tuple[OwnScript, Mention]] = {}
    for mention in evidence.mentions:
        script = _script(mention)
        if script is not None:
            first = any(path.startswith(f"{script.folder}/") for path in linked)
            found.setdefault(script.folder, (replace(script, after=not first), mention))
    made = list(found.values())[:MOST]
    return replace(
        choice,
        answer=(*choice.answer, *(script for script, _ in made)),
        reasons=(
            *choice.reasons,
            *(
                because("source", script.path, f"{page_of(mention.file)} calls make there", mention, weight=_WEIGHT)
                for script, mention in made
            ),
        ),
    )


def _script(mention: Mention) -> OwnScript | None:
    """Return the call of make for one of a page's; what lies compiled beside the Makefile is made anew."""
    if mention.topic != "make" or mention.source != "readme" or not mention.files:
        return None
    targets = compiled_targets(mention.value.split()[1:])
    if targets is None or ASIDE.search(mention.heading) or places.vendored(mention.file):
        return None
    makefile, *compiled = mention.files
    command = " ".join(("make", *(("--always-make",) if compiled else ()), *targets))
    return OwnScript(folder=makefile.rpartition("/")[0], path=makefile, command=command, after=True, by_compiler=True)
