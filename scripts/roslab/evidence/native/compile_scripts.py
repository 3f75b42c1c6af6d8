"""Scripts of the shell that call a compiler, in place of a Makefile: what they make, link and ask for."""

from __future__ import annotations

import posixpath
import shlex
from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.makefile import Makefile
from roslab.repository.checkout import Repository
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
_CALL = pattern(r"(?:(?:^|[\s/])(?:g\+\+|gcc|clang(?:\+\+)?|nvcc)(?:-[\d.]+)?|\$\{?(?:CXX|CC|NVCC)\}?)\s([^\n;]*)")
_OUTPUT = pattern(r"(?:^|\s)-o\s+(?:[\w.-]+/){0,4}([A-Za-z][\w-]{0,60})(?=\s|$)")
_OBJECT = pattern(r"(?:^|\s)-(?:c|shared|E|S|M)(?=\s|$)")
_NVCC = pattern(r"\b(?:nvcc|NVCC)\b")
_LINKED = pattern(r"(?<![\w-])-l([A-Za-z][\w+.-]{0,60})")
_ASKS = pattern(r"(?:`|\$\((?:shell\s+)?)\s*pkg-config\b([^`)\n;|&>]{0,400})")
_MODULE = pattern(r"[A-Za-z][\w.+-]*")
_PLAIN = pattern(r"[\w./=+-]+")
_COMMENT = pattern(r"(?:^|(?<=\s))#[^\n]*")


def read(repository: Repository, mentions: Iterable[Mention]) -> tuple[Makefile, ...]:
    """Return the scripts that pages run and that compile programs, each as a page first calls it."""
    found: dict[str, Makefile] = {}
    for mention in mentions:
        script = mention.files[0] if mention.topic == "build_script" and mention.files else ""
        if (
            script.endswith(SHELL_SCRIPTS)
            and mention.source == "readme"
            and not _aside(script)
            and not _aside(mention.file)
        ):
            for made in _script(script, mention, repository):
                found.setdefault(script, made)
    return tuple(found.values())


def linked(text: str) -> tuple[str, ...]:
    """Return the libraries that calls of a compiler link: ``fftw3`` of ``-lfftw3``."""
    return tuple(dict.fromkeys(_LINKED.findall(text)))


def for_cuda(text: str) -> bool:
    """Tell whether CUDA's compiler is called."""
    return bool(_NVCC.search(text))


def modules(text: str) -> tuple[str, ...]:
    """Return what pkg-config is asked for where its answer goes to a compiler."""
    words = (word for asked in _ASKS.findall(text) for word in asked.split()) if "pkg-config" in text else ()
    return tuple(dict.fromkeys(word for word in words if _MODULE.fullmatch(word)))


def _script(path: str, mention: Mention, repository: Repository) -> Iterator[Makefile]:
    folder, _, *words = mention.value.split()
    folder = "" if folder == "." else folder
    text = _COMMENT.sub("", repository.read(path, limit=MAX_SIZE).replace("\\\n", " "))
    calls = [call for call in _CALL.findall(text) if not _OBJECT.search(call)]
    programs = tuple(dict.fromkeys(name for call in calls for name in _OUTPUT.findall(call)))
    if programs and all(map(_PLAIN.fullmatch, words)):
        yield Makefile(
            file=path,
            line=1,
            programs=programs,
            linked=linked(text),
            cuda=for_cuda(text),
            modules=modules(text),
            script=shlex.join(("bash", posixpath.relpath(path, folder or "."), *words)),
            called_in=folder,
        )


def _aside(path: str) -> bool:
    return places.vendored(path) or places.test(path) or places.documentation(path) or places.example(path)
