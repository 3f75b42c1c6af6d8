"""The one place where a value becomes a word of a shell script or a token of a Dockerfile.

A value that would end its line, or make the line look different from what it does, is an error, whatever its origin:
no quoting protects a newline in a Dockerfile.
"""

from __future__ import annotations

import json
import re
import shlex
from collections.abc import Iterable, Sequence

from roslab.errors import ConfigurationError, Problem
from roslab.values.pattern import pattern

USER = "${NB_USER}"
"""The only variable allowed in a path: the name of the image's user, which is an ARG and ENV of every image."""
_FORBIDDEN = pattern("[\x00-\x1f\x7f-\x9f\u2028\u2029\u202a-\u202e\u2066-\u2069\ud800-\udfff]")
"""Control characters, line separators, bytes that are not UTF-8, and marks that change the reading direction: they
make a line look different from what it does (https://trojansource.codes)."""
_BARE = pattern(r"[A-Za-z0-9_@%+=:,./-]+")
_IMAGE = pattern(
    r"[A-Za-z0-9][A-Za-z0-9._-]*(?::[0-9]+(?=/))?(?:/[a-z0-9][a-z0-9._-]*)*(?::\w[\w.-]*)?(?:@\w+:[0-9a-f]+)?", re.ASCII
)
"""A reference as in https://github.com/distribution/reference/blob/main/regexp.go, but slightly more permissive;
spaces and ``$`` are not allowed."""


def checked(text: str) -> str:
    """Return the text unchanged. Raises ``ConfigurationError`` for a newline or another invisible character."""
    if found := _FORBIDDEN.search(text):
        raise ConfigurationError(
            Problem(
                message=f"{text!a} holds {_name(found[0])}: it cannot be written to a Dockerfile or a script",
                hint="write the value on one line, without control characters",
            )
        )
    return text


def _name(character: str) -> str:
    return {"\n": "a newline", "\r": "a carriage return", "\t": "a tab", "\0": "a NUL"}.get(
        character, f"the character U+{ord(character):04X}"
    )


def shell(text: str) -> str:
    """Return the text quoted as one word of a POSIX shell."""
    return shlex.quote(checked(text))


def words(argv: Iterable[str]) -> str:
    """Return a command line that a shell splits into exactly these words."""
    quoted = [shell(word) for word in argv]
    if quoted and "=" in quoted[0] and not quoted[0].startswith("'"):
        quoted[0] = f"'{quoted[0]}'"  # a program's name, not an assignment
    return " ".join(quoted)


def shell_with_user(path: str) -> str:
    """Return a path quoted as one word of a shell, in which only ``${NB_USER}`` is expanded."""
    parts = (re.sub(r'([\\"$`])', r"\\\1", part) for part in checked(path).split(USER))
    text = USER.join(parts)
    return text if _BARE.fullmatch(text.replace(USER, "u")) else f'"{text}"'


def path(name: str) -> str:
    """Return a relative path, still unquoted, that no program mistakes for an option."""
    return f"./{checked(name)}" if name.startswith("-") else checked(name)


def docker(text: str) -> str:
    """Return the text quoted as the value of an ENV, ARG or LABEL; a ``$`` stays as it is.

    Inside double quotes only the quote, ``$`` and the backslash have a meaning for BuildKit:
    https://github.com/moby/buildkit/blob/master/frontend/dockerfile/shell/lex.go
    """
    return text if _BARE.fullmatch(checked(text)) else '"' + re.sub(r'([\\"$])', r"\\\1", text) + '"'


def docker_path(text: str) -> str:
    """Return the path of a WORKDIR, or the target of a COPY, in which only ``${NB_USER}`` is expanded.

    BuildKit splits a COPY at spaces before it removes quotes, so use ``copy`` for a path with spaces.
    """
    return USER.join(re.sub(r"""([\\"'$])""", r"\\\1", part) for part in checked(text).split(USER))


def copy(sources: Sequence[str], target: str) -> str:
    """Return the paths of a COPY; every path is possible, and wildcards count as plain characters.

    The result is plain words if that is enough, otherwise the JSON form.
    """
    if all(_BARE.fullmatch(checked(item)) and not item.startswith("-") for item in (*sources, target)):
        return " ".join((*sources, target))
    plain = [re.sub(r"([*?\[])", r"[\1]", source.replace("\\", "\\\\")) for source in sources]
    return json.dumps([docker_path(item) for item in (*plain, target)], ensure_ascii=False)


def json_form(items: Iterable[str]) -> str:
    """Return the exec form of CMD, ENTRYPOINT, RUN or SHELL: an argv that neither a shell nor BuildKit changes."""
    return json.dumps([checked(item) for item in items], ensure_ascii=False)


def image(reference: str) -> str:
    """Return an image reference for FROM. Raises ``ConfigurationError`` for an invalid one."""
    if not _IMAGE.fullmatch(reference):
        raise ConfigurationError(
            Problem(
                message=f"{reference!a} is no image reference",
                hint="write [REGISTRY/]NAME[:TAG][@sha256:DIGEST], as `docker pull` takes it",
            )
        )
    return reference
