"""The author's Dockerfiles, under any usual name.

Instructions are cut here, not by a library: the one that is kept (dockerfile-parse) knows neither here-documents nor the
line of a word inside a continuation, and both are what a reason has to show.
"""

from __future__ import annotations

import json
import posixpath
import re
from collections.abc import Iterator
from typing import Literal, NamedTuple

from roslab.evidence import mentions, places
from roslab.evidence.facts import Dependency, GitSource, Mention, Prose, Recipe
from roslab.evidence.installs import Collector, merge
from roslab.evidence.shell import expand, logical_lines
from roslab.repository import File, Repository

MAX_SIZE = 256 * 1024
_NAME = re.compile(r"^(?:dockerfile(?:[-_.].*)?|.*\.dockerfile|.*[-_.]dockerfile|containerfile)$")
_NOT = re.compile(
    r"\.(?:md|rst|html?|py|ya?ml|json|sh|png|jpe?g|svg|j2|jinja2?|em|in|template|tmpl|erb|dockerignore|txt)$"
)
_INSTRUCTION = re.compile(r"^\s*([A-Za-z]+)\s+(.*)$", re.DOTALL)
_DOCKER_FOLDER = re.compile(
    r"^(?:.*/)?\.?(?:docker\w*|container\w*|devcontainer|build\w*|images?|env\w*|recipes?|images?/\w+)(?:/[^/]+)*$|^$",
    re.IGNORECASE,
)
"""Folders that only hold recipes: what they copy is the root."""
_KNOWN = frozenset(
    {"ADD", "ARG", "CMD", "COPY", "ENTRYPOINT", "ENV", "EXPOSE", "FROM", "HEALTHCHECK", "LABEL", "MAINTAINER", "ONBUILD", "RUN", "SHELL", "STOPSIGNAL", "USER", "VOLUME", "WORKDIR"}
)  # fmt: skip
_HEREDOC = re.compile(r"<<-?\s*[\"']?(\w+)[\"']?")
_FROM = re.compile(r"^(?:--\S+\s+)*(\S+)(?:\s+as\s+(\S+))?\s*$", re.IGNORECASE)
_PAIR = re.compile(r"(\w+)=(\"[^\"]*\"|'[^']*'|\S*)")
_DEPLOY = re.compile(
    r"jetson|l4t|deploy|tegra|raspberry|\brpi\b|arm64|aarch64|armhf|production|release|simulator|\bursim\b",
    re.IGNORECASE,
)
_CI = re.compile(
    r"(?:^|[/._-])ci(?:[/._-]|$)|\.circleci|\.?devcontainer|\.github|\.gitlab|jenkins|travis|azure|clang-tidy|coverage|lint",
    re.IGNORECASE,
)
_DOCS = re.compile(r"sphinx|mkdocs|doxygen|jekyll|readthedocs|(?:^|[/._-])docs?(?:[/._-]|$)", re.IGNORECASE)
_PRIVATE = re.compile(
    r"--mount=type=(?:ssh|secret)|id_rsa|GITHUB_TOKEN|ACCESS_TOKEN|OAUTH|:\$\{?\w*(?:TOKEN|PASSWORD)\w*\}?@",
    re.IGNORECASE,
)
_REPOSITORY_FILES = (".py", ".cpp", "CMakeLists.txt", "package.xml")


class Instruction(NamedTuple):
    """One instruction: its name in capitals, the text after it, its line."""

    name: str
    text: str
    line: int
    script: bool = False
    """The text is a here-document: lines of its own, not one line with continuations."""


def read(repository: Repository) -> tuple[Recipe, ...]:
    """Return every Dockerfile of the tree, sorted by path; what they mention is in ``mentions_of``."""
    return tuple(_recipe(repository, file) for file in _files(repository))


def prose(repository: Repository) -> Prose:
    """Return the versions and build commands that the recipes name."""
    return merge(
        Prose(mentions=(*mentions.read(_uncommented(text), file.path, "recipe"), *_built(text, file.path)))
        for file in _files(repository)
        if (text := repository.read(file, limit=MAX_SIZE))
    )


def _files(repository: Repository) -> list[File]:
    named = [
        file
        for name, files in repository.by_name.items()
        if _NAME.match(name) and not _NOT.search(name)
        for file in files
    ]
    return sorted((file for file in named if file.size < 4 * MAX_SIZE), key=lambda file: file.path)[:200]


def _uncommented(text: str) -> str:
    return re.sub(r"^[ \t]*#.*$", "", text, flags=re.MULTILINE)


def _built(text: str, path: str) -> tuple[Mention, ...]:
    collector = Collector(path, "recipe")
    for instruction in instructions(text):
        if instruction.name in {"RUN", "CMD"}:
            _collect(collector, instruction)
    return tuple(collector.mentions)


def instructions(text: str) -> Iterator[Instruction]:
    """Yield the instructions of a Dockerfile; a line that is none has the name ``""``."""
    heredoc, pending, following = "", Instruction("", "", 0), 0
    body: list[str] = []
    for line, logical in logical_lines(text):
        if heredoc:
            if logical.strip() == heredoc:
                yield Instruction(pending.name, "\n".join((pending.text, *body)), pending.line, script=True)
                heredoc, body = "", []
            else:
                body.extend("" for _ in range(line - following))  # comment lines, which carry no text
                body.append(logical)
                following = line + logical.count("\n") + 1
            continue
        if not logical.strip():
            continue
        match = _INSTRUCTION.match(logical)
        name = match[1].upper() if match else ""
        pending = Instruction(name if name in _KNOWN else "", match[2] if match else logical, line)
        start = _HEREDOC.search(pending.text) if name in {"RUN", "COPY"} else None
        if start:
            heredoc, following = start[1], line + 1
            pending = pending._replace(text=pending.text[: start.start()] if name == "RUN" else pending.text)
        else:
            yield pending


def _recipe(repository: Repository, file: File) -> Recipe:
    text = repository.read(file, limit=MAX_SIZE)
    arguments: dict[str, str | None] = {}
    known: dict[str, str] = {}
    stages: dict[str, str] = {}
    collector = Collector(file.path, "recipe", known)
    base, base_line = None, 1
    copied: list[tuple[str, int]] = []
    command: tuple[str, ...] = ()
    problem = needs = None
    started = False
    for instruction in instructions(text):
        name, body, line = instruction.name, instruction.text, instruction.line
        if not name:
            problem = problem or f"line {line} is no instruction: {body.strip()[:60]!r}"
        elif not started and name not in {"ARG", "FROM"}:
            problem = problem or f"line {line}: {name} before FROM"
        if name == "FROM":
            started = True
            if match := _FROM.match(expand(body.strip(), known)):
                image = stages.get(match[1].lower(), match[1])
                base, base_line = image, line
                if match[2]:
                    stages[match[2].lower()] = image
        elif name == "ARG":
            variable, _, default = body.strip().partition("=")
            arguments[variable] = default.strip("\"'") or None
            if default:
                known.setdefault(variable, expand(default.strip().strip("\"'"), known))
        elif name == "ENV":
            known.update((key, expand(value.strip("\"'"), known)) for key, value in _PAIR.findall(body))
            if len(words := body.split(None, 1)) == 2 and "=" not in words[0]:
                known[words[0]] = expand(words[1].strip(), known)
        elif name == "RUN":
            _collect(collector, instruction)
            if _PRIVATE.search(body):
                needs = needs or f"line {line} needs a private key or token"
        elif name in {"COPY", "ADD"}:
            copied += [(source, line) for source in _sources(body)]
        elif name in {"CMD", "ENTRYPOINT"}:
            command = _argv(body) if name == "CMD" or not command else command
    if not started:
        problem = problem or "no FROM"
    copies, context, missing = _context(repository, file, copied)
    clones = tuple(collector.sources)
    tools = [mention.value for mention in collector.mentions if mention.topic == "build_tool"]
    return Recipe(
        file=file.path,
        line=1,
        base=base,
        base_line=base_line,
        copies_repository=copies or any(_itself(repository, clone) for clone in clones),
        clones=clones,
        build_tool=next((tool for tool in tools if tool != "cmake"), tools[0] if tools else None),
        dependencies=tuple(dict.fromkeys(_own(collector.dependencies))),
        command=command,
        purpose=_purpose(file.path, base or "", problem),
        arguments=tuple(arguments.items()),
        problem=problem or needs or missing,
        context=context,
        clones_itself=any(_itself(repository, clone) for clone in clones),
    )


def _collect(collector: Collector, instruction: Instruction) -> None:
    text = re.sub(r"^(?:--\S+\s+)+", "", instruction.text)
    if instruction.script:
        collector.text(text, instruction.line)
    else:
        collector.logical(text, instruction.line)


def _own(dependencies: list[Dependency]) -> list[Dependency]:
    return [dependency for dependency in dependencies if not dependency.name.startswith("$")]


def _itself(repository: Repository, clone: GitSource) -> bool:
    origin = (repository.origin or "").rstrip("/").removesuffix(".git").rpartition("/")[2].lower()
    folder = repository.root.name.rpartition("__")[2].lower()
    return clone.name.lower() in {origin, folder} - {""}


def _argv(text: str) -> tuple[str, ...]:
    text = text.strip()
    if text.startswith("["):
        try:
            value = json.loads(text)
        except ValueError:
            return ()
        return tuple(str(part) for part in value) if isinstance(value, list) else ()
    return ("bash", "-c", text) if text else ()


def _sources(body: str) -> list[str]:
    """Return what a COPY or ADD takes from the build context; what is fetched or unknown is left out."""
    words = body.replace("\n", " ").split()
    if any(word.startswith("--from") for word in words) or "<<" in body:
        return []
    sources = [word for word in words if not word.startswith("--")][:-1]
    if "[" in body and body[body.index("[") :].strip().endswith("]"):
        sources = list(_argv(body[body.index("[") :]))[:-1]
    found = (
        source for source in sources if "://" not in source and "$" not in source and not source.startswith("git@")
    )
    return [source.removeprefix("./").strip("/") if source not in {".", "./", "/"} else "" for source in found]


def _context(repository: Repository, file: File, copied: list[tuple[str, int]]) -> tuple[bool, str | None, str | None]:
    """Tell whether the recipe brings the repository's own source, from which context, and what of it is missing.

    The context is the folder in which everything that is copied lies: the root, the folder above, the recipe's own.
    """
    if not copied:
        return False, None, None
    everything = any(source in {"", "*"} for source, _ in copied)
    named = [(source, line) for source, line in copied if source and not re.search(r"[*?\[]", source)]
    own = file.folder
    order = ["", own.rpartition("/")[0], own] if _DOCKER_FOLDER.search(own) or named else [own, ""]

    def lies(context: str, source: str) -> bool:
        where = posixpath.normpath(f"{context}/{source}".strip("/"))
        return repository.has(where) or where in repository.folders

    fitting = [context for context in dict.fromkeys(order) if all(lies(context, source) for source, _ in named)]
    if not fitting:
        best = min(dict.fromkeys(order), key=lambda context: sum(not lies(context, source) for source, _ in named))
        source, line = next((source, line) for source, line in named if not lies(best, source))
        return everything, best, f"line {line} copies {source}, which the repository does not hold"
    context = fitting[0]
    held = (f"{context}/{source}".strip("/") for source, _ in named)
    return everything or any(w in repository.folders and _holds_source(repository, w) for w in held), context, None


def _holds_source(repository: Repository, folder: str) -> bool:
    prefix = folder + "/"
    return any(file.path.startswith(prefix) and file.name.endswith(_REPOSITORY_FILES) for file in repository.files)


def _purpose(
    path: str, base: str, problem: str | None
) -> Literal["project", "documentation", "vendored", "ci", "deploy", "broken"]:
    if problem:
        return "broken"
    if places.vendored(path):
        return "vendored"
    if places.documentation(path) or _DOCS.search(path):
        return "documentation"
    if _CI.search(path):
        return "ci"
    if _DEPLOY.search(path) or re.search(r"l4t|jetson|arm32v7|arm64v8|ursim", base):
        return "deploy"
    return "project"
