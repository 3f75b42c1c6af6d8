"""What pip and conda are asked for on a command line."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Sequence
from typing import Literal

from roslab.evidence.lex.shell import UNKNOWN, Command
from roslab.knowledge.frameworks import conda_names, never_released
from roslab.values.conda import CondaPackage, conda_package
from roslab.values.dataclass import dataclass, replace
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement, Role
from roslab.values.requirement_line import requirement, stated
from roslab.values.version import minor_of

STOP = frozenset(
    [
        "and", "or", "the", "to", "for", "if", "on", "with", "then", "is", "as", "in", "it", "a", "an", "from",
        "via", "by", "into", "version", "you", "your", "this", "that", "sudo", "apt", "apt-get", "pip", "pip3",
        "will", "should", "can", "which", "using", "command", "following", "fi", "done", "esac",
    ]
)  # fmt: skip
PIP = pattern(r"^pip(?:x|[23](?:\.\d+)?)?$")
_PIP_VALUED = frozenset(
    {
        "-c", "--constraint", "-t", "--target", "--prefix", "--root", "--python", "--timeout", "--default-timeout",
        "--retries", "--proxy", "--trusted-host", "--cache-dir", "--src", "--progress-bar", "--global-option",
        "--install-option", "--config-settings", "-C", "--log", "--upgrade-strategy", "--only-binary", "--no-binary",
        "--platform", "--python-version", "--abi", "--implementation",
    }
)  # fmt: skip
_EDITABLE = frozenset({"-e", "--editable"})
_PIP_OPTIONS = {
    "-f": "--find-links", "--find-links": "--find-links", "-i": "--index-url", "--index-url": "--index-url",
    "--extra-index-url": "--extra-index-url",
}  # fmt: skip
CONDA = frozenset({"conda", "mamba", "micromamba"})
_CONDA_VALUED = frozenset({"-n", "-c", "--name", "--channel", "-p", "--prefix", "-f", "--file"})
_IN_PLACE = frozenset({"--inplace", "-i"})
_CUDA = frozenset({"cudatoolkit", "pytorch-cuda", "cuda", "cuda-toolkit"})
_PATH = pattern(r"^[./~]|^(?!.*://).*(?:\.whl|\.tar\.gz|/)$")
_FOLDER = pattern(r"[\w.-]+(?:/[\w.-]+)+(?:\[[\w,-]+\])?")
"""A path in the tree; no name of a package has a slash."""
_HERE = pattern(r"[A-Za-z][\w.-]*(?:\[[\w,-]+\])?")
"""What is installed in place, and has no slash: a folder here, in any letters."""
_CHANNEL = pattern(r"\w[\w./:-]*")
_EXACT = pattern(r"\d+(?:\.\d+)*")
_NAME = pattern(r"[a-z][a-z0-9._-]*")


@dataclass(frozen=True, slots=True)
class Version:
    """The version of Python or CUDA that conda is asked for."""

    topic: Literal["python", "cuda"]
    number: str


def builds_in_place(words: Sequence[str]) -> bool:
    """Tell whether a script of setuptools is run to compile extensions beside their sources, and for nothing else."""
    return words[1:2] == ("build_ext",) and not _IN_PLACE.isdisjoint(words) and words[0].endswith("setup.py")


def setup_asks(command: Command, file: str, here: Callable[[str], str]) -> Iterator[Requirement]:
    """Yield the folder whose setup.py is run; ``here`` makes it relative to the text's folder."""
    script = command.words[1]
    if script.rpartition("/")[2] == "setup.py" and not builds_in_place(command.words[1:]):
        asked = _argument(here(script.removesuffix("setup.py") or "."), "project", file, command.line)
        yield replace(asked, editable=True) if "develop" in command.words[2:] else asked


def pip_asks(command: Command, file: str, here: Callable[[str], str]) -> Iterator[Requirement]:
    """Yield what ``pip install`` or ``pipx install`` is given; ``here`` makes paths relative to the text's folder."""
    words = command.words
    if "install" not in words:
        return
    role: Role = "python2" if words[0].rpartition("/")[2].startswith("pip2") else ""
    index = words.index("install") + 1
    editable = {word for flag, word in itertools.pairwise(words) if flag in _EDITABLE}
    beside = "--no-build-isolation" in words
    while index < len(words):
        word, line = words[index].strip(), command.lines[index]
        following = words[index + 1] if index + 1 < len(words) else ""
        index += 1
        index += word in _PIP_VALUED
        flag, _, glued = word.partition("=") if word.startswith("--") else (word, "", "")
        value = glued or following
        if flag in _PIP_OPTIONS:
            index += not glued
            if value and UNKNOWN not in value:
                yield _argument(f"{_PIP_OPTIONS[flag]} {value}", "option", file, line)
        elif target := _requirements(word, flag, glued, following):
            index += target == following
            yield replace(_argument(here(target), "file", file, line), beside=beside)
        elif not word.startswith("-") and UNKNOWN not in word:  # the path after `-e` is handled like other words
            if _PATH.search(word) or _FOLDER.fullmatch(word) or (word in editable and _HERE.fullmatch(word)):
                asked = _argument(here(word), "project", file, line)
                yield replace(asked, beside=beside, editable=word in editable)
            elif (name := _bare(word)).lower() in STOP:
                break  # the rest is a sentence, not a command
            elif found := requirement(name, "prose", file, line, role=role, repair=False):
                yield replace(_readable(found), beside=beside)


def _readable(asked: Requirement) -> Requirement:
    """Return it without a version that no release can have, or none ever had: ``torch==1.cd``, ``torch==0.7.0``.

    No pip finds such a one (https://peps.python.org/pep-0440/), while the name is what is needed.
    """
    named = asked.name + (f"[{','.join(asked.extras)}]" if asked.extras else "")
    if asked.release and never_released(asked.key, asked.release):
        return stated(named, asked.origin, asked.file, asked.line, role=asked.role)
    unread = not (asked.url or asked.specifier) and asked.name and asked.package and asked.marker is None
    return replace(asked, written=named) if unread else asked


def _bare(word: str) -> str:
    """Return a name without punctuation of the surrounding sentence; a URL stays as it is."""
    if "://" in word:
        return word
    return word.rstrip(".") if word.endswith(".") else word.rstrip(",:)")


def _requirements(word: str, flag: str, glued: str, following: str) -> str:
    """Return the file that ``-r`` names, in the same or the next word; ``""`` for another option."""
    if flag in {"-r", "--requirement", "--requirements"}:
        return glued or following
    return word[2:] if word.startswith("-r") else ""


def _argument(written: str, role: Role, file: str, line: int) -> Requirement:
    return Requirement(name="", written=written, origin="prose", role=role, file=file, line=line)


def _environment(command: Command, file: str, default: str) -> Iterator[Requirement]:
    """Yield the file that ``--file`` names, else the default if there is one, and the channels that are given."""
    named, channels = default, []
    for word, following in itertools.pairwise((*command.words[2:], "")):
        flag, _, glued = word.partition("=")
        if flag in {"-f", "--file"}:
            named = glued or following
        elif flag in {"-c", "--channel"}:
            channels.append(glued or following)
    if named and UNKNOWN not in named:
        yield _argument(named, "environment", file, command.line)
    yield from (_argument(each, "channel", file, command.line) for each in channels if _CHANNEL.fullmatch(each))


def conda_asks(command: Command, file: str) -> Iterator[Requirement | Version]:
    """Yield what ``conda install`` or ``conda create`` is given, and the file that makes the environment.

    ``conda env create`` without ``--file`` means environment.yml; ``create`` alone takes a file as well.
    """
    words = command.words
    if words[1:2] == ("env",) and {"create", "update"} & set(words[2:3]):
        yield from _environment(command, file, "environment.yml")
        return
    if not {"install", "create", "update"} & set(words[1:3]):
        return
    channels = [*_environment(command, file, "")]
    if words[1] != "update":
        yield from _packages(command, file)
    yield from channels


def _packages(command: Command, file: str) -> Iterator[Requirement | Version]:
    """Yield the packages that ``conda install`` or ``conda create`` is given."""
    skip = False
    for word, line in zip(command.words[2:], command.lines[2:], strict=True):
        if skip or word.startswith("-") or UNKNOWN in word:
            skip = not skip and word in _CONDA_VALUED
            continue
        asked = conda_package(word.strip("\"'"))
        if asked is None:
            continue
        if asked.name == "python" and asked.version and "=" in asked.sign:
            yield Version("python", minor_of(asked.version) or asked.version)
        elif asked.name in _CUDA and asked.version and "=" in asked.sign:
            yield Version("cuda", minor_of(asked.version) or asked.version)
        elif _NAME.fullmatch(asked.name) and asked.name not in STOP | {"install", "create"}:
            package = conda_names().get(asked.name, asked.name)
            exact = f"=={asked.version}" if asked.release and _EXACT.fullmatch(asked.version) else ""
            exact += ".*" if exact and _begins(package, asked) else ""
            exact = "" if package and never_released(package, asked.version) else exact
            if package:
                yield stated(package + exact, "prose", file, line, role="conda")


def _begins(package: str | None, asked: CondaPackage) -> bool:
    """Tell whether the version that conda is given is the beginning of pip's one.

    opencv has one more number on pip's index; of ``pytorch=0.3`` there is 0.3.1 alone, and conda means any 0.3.
    """
    return asked.name == "opencv" or (package == "torch" and asked.sign == "=" and asked.version.startswith("0."))
