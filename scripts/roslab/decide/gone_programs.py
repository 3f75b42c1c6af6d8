"""Programs that the page at the root runs and that its tree no longer has, where nothing else is started."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from roslab.config.model import Kind
from roslab.decide.candidate import program_of
from roslab.decide.decision import Warning_
from roslab.decide.filled_in import PLACEHOLDER
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence


def gone_programs(evidence: Evidence, kind: Kind) -> Iterator[Warning_]:
    """Yield a warning for the first such file of Python: its folder, or that one's, holds other programs of the tree.

    What lies elsewhere is another repository's, or a name that the reader fills in.
    """
    if kind not in {"python", "cuda"}:
        return
    programs = {program.file for program in evidence.programs}
    folders = {file.partition("/")[0] for file in programs if "/" in file}
    unread = tuple(f"{git.name}/" for git in evidence.sources if git.kind == "submodule" and git.absent)
    for said in evidence.mentions:
        if said.topic != "command" or said.source != "readme" or "/" in said.file or said.inside:
            continue
        *_, name = program_of(tuple(said.value.split()))
        path = posixpath.normpath(name)
        known = path in {*programs, *said.files} or any(file.endswith(f"/{path}") for file in programs)
        of_tree = (
            path.endswith(".py") and "/" in path and path.partition("/")[0] in folders and not path.startswith(unread)
        )
        if of_tree and not known and not PLACEHOLDER.search(path):
            from difflib import get_close_matches  # noqa: PLC0415 - few pages name a program that is gone

            near = "".join(f" (it has {each})" for each in get_close_matches(path, sorted(programs), n=1))
            then = "the image starts a shell: name the program that took its place under `command` in roslab.yaml"
            yield warn(f"the page runs {path}, which the tree does not have{near}; {then}", said)
            return
