"""Explains a failed build or proof: annotations on the lines that asked, lines to paste, a suggestion."""

from __future__ import annotations

import io
import posixpath
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from roslab.config import Config, locate
from roslab.config import read as read_configuration
from roslab.config.addition import added
from roslab.engine.asking import ask
from roslab.errors import BuildError, ConfigurationError, Problem, RoslabError
from roslab.explain import words
from roslab.explain.answer import Answer
from roslab.explain.answer import explain as explained
from roslab.github import access, builder, checkout, event, kept, secrets, suggestion, workflow
from roslab.github.run import Folder, Run
from roslab.render.dockerfile import holders as question_of_files
from roslab.render.dockerfile import wheels as question_of_wheels
from roslab.render.outcome import Repair as Lines
from roslab.repair import dockerfile
from roslab.repair import words as repair_words
from roslab.repair.chain import NOBODY, Asking, proposed
from roslab.repair.change import Given, Repair
from roslab.repair.hunk import Hunk, hunk
from roslab.repository.checkout import Repository
from roslab.values.dataclass import dataclass, replace
from roslab.values.origin import Place


@dataclass(frozen=True, kw_only=True, slots=True)
class Mending:
    """What a failed run hands to its author."""

    problems: tuple[Problem, ...]
    repairs: tuple[Lines, ...] = ()
    """The lines to paste, or the diff of the author's own Dockerfile."""
    hunk: Hunk | None = None
    """The lines to replace, if they are next to each other."""


def explain(environment: Mapping[str, str]) -> None:
    """Read the log of the build that has just failed and raise a ``BuildError`` that explains it."""
    folder = Folder.of(environment)
    run = folder.run
    log = builder.failed_log(environment)
    what = event.read(environment)
    if refused := access.refusal(log):
        access.require(refused, image=run.image, event=what)
    if not log:
        raise BuildError(Problem(message="the build failed", hint="the log of the step above says why"))
    mending = mend(_answer(log), run, _root(run, environment), asking(folder, environment))
    _hand_over(folder, mending, environment)
    raise BuildError(*mending.problems)


def explain_proof(folder: Folder, failure: Problem, output: str, environment: Mapping[str, str]) -> Problem:
    """Return a proof's failure with the cause that its output shows, and hand over the lines that repair it.

    A failure whose cause is unknown comes back unchanged.
    """
    answer = _answer(output)
    if not answer.explanations or answer.explanations[0].id is None:
        return failure
    run = folder.run
    mending = mend(answer, run, _root(run, environment), asking(folder, environment))
    _hand_over(folder, mending, environment)
    first = mending.problems[0]
    return replace(first, message=f"{failure.message}: {first.message}")


def explain_start(folder: Folder, platform: str, output: str, environment: Mapping[str, str]) -> None:
    """Warn of what lets the default command of a good image die, and keep the lines with which it starts.

    Nothing is said where the cause is not known.
    """
    answer = _answer(output)
    if not answer.explanations or answer.explanations[0].id is None:
        return
    run = folder.run
    mending = mend(answer, run, _root(run, environment), asking(folder, environment), start=True)
    for problem in mending.problems:
        workflow.warn(replace(problem, message=f"the default command does not start on {platform}: {problem.message}"))
    if mending.repairs:
        kept.mend(folder.artifact, [replace(each, start=True) for each in mending.repairs])


def _answer(log: str) -> Answer:
    return explained(io.BytesIO(log.encode("utf-8", errors="replace")))


def asking(folder: Folder, environment: Mapping[str, str], run: Run | None = None) -> Asking:
    """Return who is asked: the apt of the image's base, and pip's index."""
    run = run or folder.run

    def answered(question: str) -> str:
        return ask(question, run.here(environment), secrets=secrets.held(folder, run, environment))

    def files(paths: Sequence[str]) -> str:
        workflow.say("asking apt which package holds what is missing")
        return answered(question_of_files(run.plan, paths))

    def wheels(lines: Sequence[str]) -> str:
        workflow.say("asking pip's index for which Python it has a wheel")
        return answered(question_of_wheels(run.plan, lines))

    return Asking(files=files, wheels=wheels)


def _root(run: Run, environment: Mapping[str, str]) -> Path:
    return checkout.part(Path(environment.get("GITHUB_WORKSPACE") or ".").resolve(), run.path)


def _hand_over(folder: Folder, mending: Mending, environment: Mapping[str, str]) -> None:
    if mending.repairs:
        kept.mend(folder.artifact, mending.repairs)
        what = event.read(environment)
        suggestion.suggest(what, mending.problems, mending.repairs, mending.hunk, environment)


def mend(
    answer: Answer,
    run: Run,
    root: Path,
    asking: Asking = NOBODY,
    *,
    start: bool = False,
) -> Mending:
    """Return what an explained log says about the checkout it was built from.

    What the image could be built without is told, and among no lines: only who knows what the image is for can say.
    ``start``: the answer is that to the default command's log.
    """
    from roslab.evidence.gather import gather  # noqa: PLC0415 - every step that may fail imports this module

    try:
        repository = Repository.open(root)
        text = locate.text(repository, run.config) if run.config else None
        config = read_configuration(text, file=run.config) if text is not None else Config()
        files = frozenset(file.path for file in repository.files)
        given = Given(plan=run.plan, evidence=gather(repository), config=config, files=files, read=repository.read)
        found = proposed(answer, given, asking=asking, start=start)
        problems = tuple(_problems(answer, found, run))
        if run.plan.author_dockerfile:
            return _own(answer, problems, repository, run)
        return _configuration(found, problems, text, run)
    except RoslabError as error:  # the checkout changed, or its roslab.yaml was read under other inputs
        workflow.say(f"no lines for roslab.yaml: {error}")
        return Mending(problems=words.problems(answer) or (Problem(message="the build failed"),))


def _problems(answer: Answer, found: Repair, run: Run) -> Iterator[Problem]:
    """Yield a problem for each failed step, at the line of the checkout that asked for what it lacks."""
    known = words.problems(answer, lines=False)
    for explanation, problem, place in zip(answer.explanations, known, found.places, strict=True):
        changes = [str(change) for change in found.changes if change.failure == explanation.id]
        lines = f" In roslab.yaml: `{'; '.join(changes)}`." if changes and not run.plan.author_dockerfile else ""
        left = [change for change in found.left if change.failure == (explanation.id or "")]
        lines += "".join(f" It could be built {repair_words.without(each)}: `{each}` in roslab.yaml." for each in left)
        origin = Place(file=posixpath.join(run.path, place.file), line=place.line) if place else None
        yield replace(problem, hint=f"{problem.hint}{lines}", origin=origin)
    if not known:
        yield Problem(message="the build failed", hint="the log of the step above says why")


def _own(answer: Answer, problems: tuple[Problem, ...], repository: Repository, run: Run) -> Mending:
    """Return the diff of the author's own Dockerfile."""
    author = run.plan.author_dockerfile
    file = author.dockerfile if author else ""
    text = repository.read(file)
    edits = dockerfile.edits(answer, text)
    if not edits:
        return Mending(problems=problems)
    path = posixpath.join(run.path, file)
    shown = Lines(file=path, text=dockerfile.diff(path, text, edits), diff=True)
    return Mending(problems=problems, repairs=(shown,), hunk=hunk(path, text, dockerfile.edited(text, edits)))


def _configuration(found: Repair, problems: tuple[Problem, ...], text: str | None, run: Run) -> Mending:
    """Return the lines for roslab.yaml, those that are only likely as well: nothing is written here."""
    if not found.changes:
        return Mending(problems=problems)
    path = posixpath.join(run.path, run.config or locate.NAMES[0])
    lines = repair_words.lines(found.changes, begin=text is None)
    shown = (Lines(file=path, text=lines, new=text is None),)
    try:
        change = hunk(path, text or "", added(text, found.certain.entries, file=path))
    except ConfigurationError:  # an old format, or a layout that is edited by hand
        change = None
    return Mending(problems=problems, repairs=shown, hunk=change)
