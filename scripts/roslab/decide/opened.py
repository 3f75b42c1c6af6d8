"""Files that the default command opens as soon as it is loaded, and programs that it calls, that nothing brings."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from roslab.config.model import Config
from roslab.decide.decision import Choice, Download, Warning_
from roslab.decide.reasons import warn
from roslab.decide.system.guards import runs, starts
from roslab.evidence.facts import Evidence
from roslab.knowledge.latex import latex
from roslab.knowledge.unpackaged_programs import unpackaged_programs

_TEX = "texlive"


def decide_opened(
    evidence: Evidence, config: Config, command: tuple[str, ...] | str, downloads: Iterable[Download]
) -> Choice[None]:
    """Return a warning for each; what is downloaded is there, and a command of roslab.yaml is its author's."""
    if config.compatible or config.custom or config.command is not None:
        return Choice(answer=None)
    words = command.split() if isinstance(command, str) else command
    called = (*_called(evidence, words), *_set_by_latex(evidence, config, command))
    if isinstance(command, str):
        return Choice(answer=None, warnings=called)
    started = {word for word in command if word.endswith(".py")}
    there = {each.path for each in downloads}
    told = []
    for mention in evidence.mentions:
        if mention.topic == "opened" and started & {*mention.files} and mention.value not in there:
            message = f"the default command opens {mention.value} as soon as it is loaded, which the tree does not have"
            told.append(warn(f"{message}: it stops without it; add the file, or make it by `custom`", mention))
    return Choice(answer=None, warnings=(*told, *called))


def _set_by_latex(evidence: Evidence, config: Config, command: tuple[str, ...] | str) -> Iterator[Warning_]:
    """Yield a warning for the first program that has text set by LaTeX, unless the default command is one.

    Not where a page or roslab.yaml installs LaTeX.
    """
    set_by = [mention for mention in evidence.mentions if mention.topic == "usetex" and mention.files]
    by_apt = (*config.apt, *(each.name for each in evidence.prose if each.namespace == "apt"))
    had = any(name.startswith(_TEX) for name in by_apt)
    started = starts(evidence, command)
    if set_by and not had and not any(started(file) for mention in set_by for file in mention.files):
        message = (
            "matplotlib has text set by LaTeX here, which is not in the image: it is large, and the default command"
        )
        yield warn(f"{message} needs none; name {', '.join(latex())} under `apt` in roslab.yaml", set_by[0])


def _called(evidence: Evidence, words: Sequence[str]) -> Iterator[Warning_]:
    """Yield a warning for each program that its script calls and that no package of Ubuntu brings."""
    for mention in evidence.mentions:
        if mention.topic == "unpackaged" and runs(words, mention.file):
            message = f"the script of the default command calls {mention.value}, which no package of Ubuntu brings"
            releases = unpackaged_programs()[mention.value]
            yield warn(f"{message}: bring it from {releases} by `custom` in roslab.yaml", mention)
