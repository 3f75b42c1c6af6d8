"""Images that the author's own Dockerfile starts from and no registry has, with what its build takes in their place.

That is an image that no longer answers, and one that a page builds first from another Dockerfile of the tree.
"""

from __future__ import annotations

import posixpath
from collections.abc import Sequence

from roslab.config.model import Config
from roslab.decide.decision import Choice, MendedBase, Reason
from roslab.decide.reasons import because
from roslab.evidence.facts import AuthorDockerfile, Evidence, Mention
from roslab.values.dataclass import dataclass, replace
from roslab.values.origin import Place

_WEIGHT = 900
"""Above that of the FROM itself: it is what the build starts from."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Local:
    """An image that is built on the author's machine first."""

    said: Mention
    """The command that builds it."""
    problem: str | None = None
    """Why it cannot be built here."""
    dockerfile: AuthorDockerfile | None = None
    """What it is built from, if that is one file of the tree."""


def local_bases(evidence: Evidence) -> dict[str, Local]:
    """Return how a page builds the base of each Dockerfile first, by the Dockerfile's path."""
    if all(mention.topic != "image_built" for mention in evidence.mentions):
        return {}
    found = ((each.file, local(each.base, each, evidence)) for each in evidence.dockerfiles if each.base)
    return {file: made for file, made in found if made}


def local(image: str, authored: AuthorDockerfile, evidence: Evidence) -> Local | None:
    """Return how a page builds an image that a Dockerfile starts from, ``None`` where no page does."""
    whole = _tagged(image)
    if any(m.topic == "image_pulled" and _tagged(m.value) == whole for m in evidence.mentions):
        return None
    built = (m for m in evidence.mentions if m.topic == "image_built" and _tagged(m.value) == whole)
    said = next(built, None)
    if said is None:
        return None
    file = wanted(said.text.split())
    others = [each for each in evidence.dockerfiles if each is not authored]
    ending = [each for each in others if f"/{each.file}".endswith(f"/{file}")]
    found = [each for each in others if each.file == file] or ending
    if len(found) != 1:
        return Local(said=said, problem=f"from {file}, which is not one file of the tree")
    return Local(said=said, problem=_problem(found[0], said), dockerfile=found[0])


def wanted(words: Sequence[str]) -> str:
    """Return the path of the Dockerfile that a ``docker build`` reads, as it is written."""
    for index, word in enumerate(words[:-1]):
        if word in {"-f", "--file"}:
            return posixpath.normpath(words[index + 1])
        if word.startswith("--file="):
            return posixpath.normpath(word.removeprefix("--file="))
    return posixpath.normpath(posixpath.join(words[-1], "Dockerfile"))


def _problem(base: AuthorDockerfile, said: Mention) -> str | None:  # noqa: PLR0911 - one reason a line
    from roslab.decide.mended_bases import mended  # noqa: PLC0415 - most trees have no Dockerfile
    from roslab.knowledge.ended_bases import ended  # noqa: PLC0415 - most trees have no Dockerfile
    from roslab.knowledge.official_images import published  # noqa: PLC0415 - as above

    if base.problem:
        return f"from {base.file}: {base.problem}"
    if base.recipe is None:
        return f"from {base.file}, which copies files of its own"
    if base.secrets:
        return f"from {base.file}, which mounts a secret"
    if "--build-arg" in said.text:
        return f"from {base.file} with arguments of its own"
    if base.base is None or "$" in base.base or not published(base.base):
        return f"from {base.file}, whose base {base.base} is not known"
    instead = mended(base.base, base)
    if gone := ended(base.base) or (instead and instead.why):
        return f"from {base.file}: {gone}"
    return None


def decide_bases(evidence: Evidence, config: Config, dockerfile: str | None) -> Choice[tuple[MendedBase, ...]]:
    """Return the bases to replace in the author's Dockerfile; ``repair: false`` leaves those that are built first."""
    authored = next((each for each in evidence.dockerfiles if each.file == dockerfile), None)
    if authored is None:
        return Choice(answer=())
    pips = {} if config.repair is False else _pips(authored, evidence)
    pip_days, git_days = ({}, {}) if config.repair is False else _days(authored, evidence)
    found = [
        (base, line)
        for name, line in dict(authored.bases).items()
        if (
            base := _local(name, authored, evidence)
            or _of_day(
                _mended(name, authored, config, pips.get(name)),
                name,
                evidence.pip_day,
                pip_days.get(name),
                git_days.get(name),
            )
        )
    ]
    return Choice(answer=tuple(base for base, _ in found), reasons=tuple(_reason(authored, *each) for each in found))


def _pips(authored: AuthorDockerfile, evidence: Evidence) -> dict[str, str]:
    if not authored.newest_pips:
        return {}
    from roslab.decide.newest_pip import bounded_pips  # noqa: PLC0415 - most Dockerfiles leave pip as it is

    return bounded_pips(authored, evidence)


def _days(authored: AuthorDockerfile, evidence: Evidence) -> tuple[dict[str, str], dict[str, str]]:
    """Return why what pip installs, and why what git clones, is to be of the day, by the image in which it is."""
    if evidence.pip_day is None:
        return {}, {}
    from roslab.decide.authors_heads import heads_of_the_day  # noqa: PLC0415 - most trees have no Dockerfile
    from roslab.decide.authors_pip import of_the_day  # noqa: PLC0415 - as above

    return of_the_day(authored, evidence, evidence.pip_day), heads_of_the_day(authored, evidence.pip_day)


def _of_day(
    base: MendedBase | None, name: str, day: str | None, by_pip: str | None, by_git: str | None
) -> MendedBase | None:
    """Return a base with pip's index or git's heads of a day, where something tells why these are to be of it."""
    said = [why for why in (by_pip, by_git) if why]
    if not said:
        return base
    found = base or MendedBase(name=name, image=name, why="", answers=True)
    why = "; ".join(filter(None, (found.why, *said)))
    return replace(found, why=why, pip_day=day if by_pip else None, git_day=day if by_git else None)


def _mended(name: str, authored: AuthorDockerfile, config: Config, pip: str | None) -> MendedBase | None:
    """Return what replaces an image that no longer answers, or in which a newer pip than the author's builds nothing.

    ``pip``: why that is so.
    """
    if config.repair is False:
        return None
    from roslab.decide.mended_bases import mended  # noqa: PLC0415 - most trees have no Dockerfile
    from roslab.knowledge.tools import ALWAYS_ISOLATED  # noqa: PLC0415 - as above

    base = mended(name, authored)
    if not pip or "$" in name:
        return base
    if base is None:
        return MendedBase(name=name, image=name, why=pip, answers=True, pip_below=ALWAYS_ISOLATED)
    return replace(base, why=f"{base.why}; {pip}", pip_below=ALWAYS_ISOLATED)


def _reason(authored: AuthorDockerfile, base: MendedBase, line: int) -> Reason:
    may = (
        ("an older pip", base.pip_below),
        ("pip's index of that day", base.pip_day),
        ("git's heads of that day", base.git_day),
    )
    given = [what for what, is_so in may if is_so]
    what = f"gives {base.name} {' and '.join(given)}" if base.answers else f"replaces {base.name}"
    replaced = f"; the build {what} and changes no line of the Dockerfile"
    text = base.why + (replaced if base.recipe is None else ", and so does the build here")
    place = Place(file=authored.file, line=line)
    return because("mended_base", base.image, text, place, weight=_WEIGHT)


def _local(name: str, authored: AuthorDockerfile, evidence: Evidence) -> MendedBase | None:
    first = local(name, authored, evidence)
    if first is None or first.problem or first.dockerfile is None or first.dockerfile.base is None:
        return None
    why = f"line {first.said.line} of {first.said.file} builds it first, from {first.dockerfile.file}"
    return MendedBase(name=name, image=first.dockerfile.base, why=why, recipe=first.dockerfile.recipe)


def _tagged(image: str) -> str:
    return image if ":" in image.rpartition("/")[2] else f"{image}:latest"
