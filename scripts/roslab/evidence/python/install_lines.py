"""What pip and conda are asked for on a command line, word by word."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import NamedTuple

from roslab.evidence.lex.shell import UNKNOWN, Command
from roslab.knowledge.frameworks import conda_names

STOP = frozenset(
    [
        "and", "or", "the", "to", "for", "if", "on", "with", "then", "is", "as", "in", "it", "a", "an", "from",
        "via", "by", "into", "version", "you", "your", "this", "that", "sudo", "apt", "apt-get", "pip", "pip3",
        "will", "should", "can", "which", "using", "command", "following",
    ]
)  # fmt: skip
PIP = re.compile(r"^pip(?:x|[23](?:\.\d+)?)?$")
_PIP_VALUED = frozenset(
    {
        "-c", "--constraint", "-t", "--target", "--prefix", "--root", "--python", "--timeout", "--default-timeout",
        "--retries", "--proxy", "--trusted-host", "--cache-dir", "--src", "--progress-bar", "--global-option",
        "--install-option", "--config-settings", "-C", "--log", "--upgrade-strategy", "--only-binary", "--no-binary",
        "--platform", "--python-version", "--abi", "--implementation",
    }
)  # fmt: skip
_PIP_OPTIONS = {
    "-f": "--find-links", "--find-links": "--find-links", "-i": "--index-url", "--index-url": "--index-url",
    "--extra-index-url": "--extra-index-url",
}  # fmt: skip
_PIP_SPEC = re.compile(r"^[A-Za-z0-9][A-Za-z0-9._-]*(?:\[[\w\s,.-]*\])?\s*(?:(?:[=<>!~]=|[<>]|@|;)\s*[^\s].*)?$")
_URL = re.compile(r"^(?:git\+)?(?:https?|ssh|git|file)://\S+$|^git@\S+:\S+$")
CONDA = frozenset({"conda", "mamba", "micromamba"})
_CONDA_VALUED = frozenset({"-n", "-c", "--name", "--channel", "-p", "--prefix", "-f", "--file"})
_CUDA = frozenset({"cudatoolkit", "pytorch-cuda", "cuda", "cuda-toolkit"})
_VERSION = re.compile(r"\d+(?:\.\d+)*")


class Asked(NamedTuple):
    """One thing that an install command names."""

    name: str
    """A requirement line, a path, a URL, an option; ``3.8`` for Python and CUDA themselves."""
    line: int
    role: str = ""
    """``file``, ``project``, ``option``, ``python2``, ``conda``; ``python`` and ``cuda`` for versions that conda is
    asked for."""


def pip_asks(command: Command, here: Callable[[str], str]) -> Iterator[Asked]:
    """Yield what ``pip install`` or ``pipx install`` is given; ``here`` makes a path one from where the text began."""
    words = command.words
    if "install" not in words:
        return
    two = "python2" if words[0].rpartition("/")[2].startswith("pip2") else ""
    index = words.index("install") + 1
    while index < len(words):
        word, line = words[index].strip(), command.lines[index]
        following = words[index + 1] if index + 1 < len(words) else ""
        index += 1
        if word in _PIP_VALUED:
            index += 1
            continue
        flag, _, glued = word.partition("=") if word.startswith("--") else (word, "", "")
        if flag in _PIP_OPTIONS:
            index += not glued
            if UNKNOWN not in (glued or following) and (glued or following):
                yield Asked(f"{_PIP_OPTIONS[flag]} {glued or following}", line, "option")
        elif flag in {"-r", "--requirement", "--requirements"} or (
            word.startswith("-r") and len(word) > 2 and not word.startswith("--")
        ):
            target = glued or (word[2:] if word.startswith("-r") and len(word) > 2 else following)
            index += target == following
            yield Asked(here(target), line, "file")
        elif not word.startswith("-") and UNKNOWN not in word:  # what `-e` names is a word like the others
            asked = _pip_word(word, line, here, two)
            if asked is None:
                break  # the sentence goes on in prose
            if asked.name:
                yield asked


def _pip_word(word: str, line: int, here: Callable[[str], str], two: str) -> Asked | None:
    """Return one argument, without a name where it is none, ``None`` where it is a word of the sentence around it."""
    if _URL.match(word):
        return Asked(word, line, two)
    if word.startswith((".", "/", "~")) or word.endswith((".whl", ".tar.gz", "/")):
        return Asked(here(word), line, "project")
    name = word.rstrip(",:)") if not word.endswith(".") else word.rstrip(".")
    if name.lower() in STOP:
        return None
    return Asked(name if _PIP_SPEC.match(name) else "", line, two)


def conda_asks(command: Command) -> Iterator[Asked]:
    """Yield what ``conda install`` or ``conda create`` is given."""
    words = command.words
    if not {"install", "create"} & set(words[1:3]):
        return
    skip = False
    for word, line in zip(words[2:], command.lines[2:], strict=True):
        if skip or word.startswith("-") or UNKNOWN in word:
            skip = not skip and word in _CONDA_VALUED
            continue
        name, _, version = word.rpartition("::")[2].strip("\"'").replace("==", "=").partition("=")
        number = _VERSION.match(version)
        name = name.lower().partition(">")[0].partition("<")[0]
        if name == "python" and number:
            yield Asked(number[0], line, "python")
        elif name in _CUDA and number:
            yield Asked(number[0], line, "cuda")
        elif (
            (package := conda_names().get(name, name))
            and re.fullmatch(r"[a-z][a-z0-9._-]*", name)
            and name not in STOP
            and name not in {"install", "create"}
        ):
            exact = f"=={number[0]}" if number and number[0] == version else ""
            exact += ".*" if exact and name == "opencv" else ""  # pip's has a number more, of the build
            yield Asked(package + exact, line, "conda")
