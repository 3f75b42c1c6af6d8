"""Programs in Python that the page starts and that the tree does not have, where nothing else is the default."""

from __future__ import annotations

import posixpath
from difflib import get_close_matches

from roslab.config.model import Config
from roslab.decide.decision import Choice
from roslab.decide.reasons import warn
from roslab.decide.written_commands import TOOLS
from roslab.evidence.facts import Evidence
from roslab.values.pattern import pattern

_PROGRAM = pattern(r"(?:\./)?(?:[A-Za-z_][\w-]*/)*[A-Za-z_][\w-]*\.py")


def decide_absent_programs(evidence: Evidence, config: Config, command: tuple[str, ...] | str) -> Choice[None]:
    """Return a warning for the first that a page at the root starts; a clone or a submodule may bring it."""
    cloned = any(git.kind != "link" for git in evidence.sources)
    if command != ("bash",) or cloned or config.compatible or config.command is not None:
        return Choice(answer=None)
    ours = {script.file for script in evidence.programs} | {each.file for each in evidence.code}
    names = {posixpath.basename(file) for file in ours}
    for mention in evidence.mentions:
        words = mention.value.split() if mention.topic == "command" and mention.source == "readme" else []
        here = "/" not in mention.file and len(words) > 1 and words[0].startswith("python") and not mention.files
        if not here or not _PROGRAM.fullmatch(words[1]) or posixpath.basename(words[1]) in {*names, *TOOLS}:
            continue
        path = posixpath.normpath(words[1])
        near = get_close_matches(path, sorted(ours), n=1)
        hint = f"; it has {near[0]}" if near else ""
        message = f"the page starts {path}, which the tree does not have{hint}: set `command` in roslab.yaml"
        return Choice(answer=None, warnings=(warn(message, mention),))
    return Choice(answer=None)
