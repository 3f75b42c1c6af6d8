"""A Dockerfile of the author's that compiles what stops without a GPU, which no build of an image sees."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.decision import Warning_
from roslab.decide.newest_pip import project_of
from roslab.decide.reasons import warn
from roslab.evidence.facts import AuthorDockerfile, Evidence
from roslab.values.dataclass import dataclass
from roslab.values.origin import Place

_OWN = frozenset({"gpu", "gpu asked"})


@dataclass(frozen=True, kw_only=True, slots=True)
class Stop:
    """Why the build of a Dockerfile stops, and what its author should know."""

    why: str
    warning: Warning_


def without_gpu(authored: AuthorDockerfile, evidence: Evidence) -> Stop | None:
    """Return what a Dockerfile compiles that stops without a GPU, ``None`` if nothing known does.

    Where its steps change the setup.py of something, what that asks for is not known any more.
    """
    if authored.changes_setup:
        return None
    found = next(iter((*_fetched(authored, evidence), *_own(authored, evidence))), None)
    if found is None:
        return None
    line, what, package = found
    why = f"line {line} compiles {what}, whose setup.py ends where torch sees no GPU, as in every build of an image"
    then = f"`pip install --no-build-isolation {package}` in a container with --gpus all compiles it"
    if_given = f"where docker's default runtime is nvidia, `dockerfile: {authored.file}` in roslab.yaml builds it"
    message = f"{authored.file} is not built: {why}; {then}; {if_given}"
    return Stop(why=why, warning=warn(message, Place(file=authored.file, line=line)))


def _steps(authored: AuthorDockerfile, evidence: Evidence) -> Iterator[tuple[int, str]]:
    """Yield the folders in which the steps install or run a script that builds, with the line."""
    yield from ((each.line, each.written) for each in authored.requirements if each.role == "project")
    for mention in evidence.mentions:
        if mention.topic == "build_script" and mention.file == authored.file:
            yield mention.line, mention.value.partition(" ")[0]


def _fetched(authored: AuthorDockerfile, evidence: Evidence) -> Iterator[tuple[int, str, str]]:
    """Yield what is known of other repositories: the line, the words for it, and what pip is given instead."""
    from roslab.knowledge.stops_without_gpu import stops_without_gpu  # noqa: PLC0415 - most trees have no Dockerfile

    for clone in authored.clones:
        for folder in stops_without_gpu().get(_address(clone.url), ()):
            package = f"'git+{clone.url}#subdirectory={folder}'"
            inside = (
                line
                for line, path in _steps(authored, evidence)
                if f"/{path}/".replace("/./", "/").endswith(f"/{folder}/")
            )
            yield from ((line, f"{folder} of {clone.url}", package) for line in inside)
    for asked in authored.requirements:
        for folder in stops_without_gpu().get(_address(asked.url), ()) if asked.vcs else ():
            if asked.url.endswith(f"subdirectory={folder}"):
                repository = asked.url.removeprefix("git+").partition("#")[0].removesuffix(".git")
                yield asked.line, f"{folder} of {repository}", f"'{asked.url}'"


def _own(authored: AuthorDockerfile, evidence: Evidence) -> Iterator[tuple[int, str, str]]:
    """Yield the projects in folders of the tree that the steps install; one at the root stops any other build, too."""
    for line, path in _steps(authored, evidence):
        project = project_of(path, authored, evidence)
        if project and project.folder and not _OWN.isdisjoint(project.extensions):
            yield line, project.folder, project.folder


def _address(url: str) -> str:
    """Return the host and the path of an address, without the revision."""
    address = url.removeprefix("git+").partition("#")[0].partition("://")[2].lower()
    return address.partition("@")[0].removesuffix("/").removesuffix(".git")
