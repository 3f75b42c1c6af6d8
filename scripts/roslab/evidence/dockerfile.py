"""The author's Dockerfiles, under any usual name.

Instructions are cut here, not by a library: the one that is kept (dockerfile-parse) knows neither here-documents nor the
line of a word inside a continuation, and both are what a reason has to show.
"""

from __future__ import annotations

import json
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
    r"(?:^|[/._-])ci(?:[/._-]|$)|\.circleci|\.github|\.gitlab|jenkins|travis|azure|clang-tidy|coverage|lint",
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
            collector.text(instruction.text, instruction.line)
    return tuple(collector.mentions)


def instructions(text: str) -> Iterator[Instruction]:
    """Yield the instructions of a Dockerfile; a line that is none has the name ``""``."""
    heredoc, pending = "", Instruction("", "", 0)
    body: list[str] = []
    for line, logical in logical_lines(text):
        if heredoc:
            if logical.strip() == heredoc:
                yield Instruction(pending.name, "\n".join((pending.text, *body)), pending.line)
                heredoc, body = "", []
            else:
                body += [""] * max(0, line - pending.line - 1 - sum(part.count("\n") + 1 for part in body)) + [logical]
            continue
        if not logical.strip():
            continue
        match = _INSTRUCTION.match(logical)
        name = match[1].upper() if match else ""
        pending = Instruction(name if name in _KNOWN else "", match[2] if match else logical, line)
        start = _HEREDOC.search(pending.text) if name in {"RUN", "COPY"} else None
        if start:
            heredoc = start[1]
            pending = pending._replace(text=pending.text[: start.start()] if name == "RUN" else pending.text)
        else:
            yield pending


def _recipe(repository: Repository, file: File) -> Recipe:
    text = repository.read(file, limit=MAX_SIZE)
    arguments: dict[str, str | None] = {}
    known: dict[str, str] = {}
    stages: dict[str, str] = {}
    collector = Collector(file.path, "recipe", known)
    base, base_line, copies, context = None, 1, False, None
    command: tuple[str, ...] = ()
    problem = needs = None
    started = False
    for name, body, line in instructions(text):
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
            collector.text(re.sub(r"^(?:--\S+\s+)+", "", body), line)
            if _PRIVATE.search(body):
                needs = needs or f"line {line} needs a private key or token"
        elif name in {"COPY", "ADD"}:
            copied, where, missing = _copied(repository, file, body)
            needs = needs or (missing and f"line {line} copies {missing}, which the repository does not hold") or None
            copies, context = copies or copied, context if context is not None else where
        elif name in {"CMD", "ENTRYPOINT"}:
            command = _argv(body) if name == "CMD" or not command else command
    if not started:
        problem = problem or "no FROM"
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
        problem=problem or needs,
        context=context,
        clones_itself=any(_itself(repository, clone) for clone in clones),
    )


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


def _copied(repository: Repository, file: File, body: str) -> tuple[bool, str | None, str | None]:
    """Tell whether a COPY brings the repository's own source, from which context, and what of it is missing."""
    words = [word for word in body.replace("\n", " ").split() if word]
    if any(word.startswith("--from") for word in words):
        return False, None, None
    sources = [word for word in words if not word.startswith("--")][:-1]
    if body.lstrip().startswith("["):
        sources = [part for part in _argv(body)[:-1] if not part.startswith("--")]
    for source in sources:
        path = source.removeprefix("./").strip("/") if source not in {".", "./", "*", "/"} else ""
        if "://" in source or "$" in source or source.startswith("git@"):
            continue
        if path in {"", "*", "src", "."} and path != "src":
            return True, "", None
        if re.search(r"[*?\[]", path):
            continue
        for context in ("", file.folder, file.folder.rpartition("/")[0]):
            where = f"{context}/{path}".strip("/") if context else path
            if where in repository.folders and _holds_source(repository, where):
                return True, context, None
            if repository.has(where) or where in repository.folders:
                return False, context, None
        return False, None, path
    return False, None, None


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
