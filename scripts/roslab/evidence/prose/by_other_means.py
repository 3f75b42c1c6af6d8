"""Steps of an installation that are neither apt, pip, conda nor a clone: scripts that compile, images, downloads."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Literal

from roslab.evidence.lex.shell import UNKNOWN, Command
from roslab.evidence.prose import downloads, edits, own_packages, patches, single_headers
from roslab.evidence.prose.archives import is_release
from roslab.evidence.prose.entered import entered
from roslab.evidence.prose.loaded_sessions import loaded_session
from roslab.evidence.python.install_lines import builds_in_place
from roslab.values.pattern import pattern

Topic = Literal[
    "step",
    "image_built",
    "image_pulled",
    "build_script",
    "fetched",
    "unpacked",
    "skipped",
    "data",
    "entered",
    "made",
    "own_package",
    "patched",
    "edited",
    "single_header",
    "make",
    "session_loaded",
]
_PACKAGES = pattern(r"\.(?:deb|run|sh|tar(?:\.\w+)?|tgz|zip|AppImage)$")
_INSTALLATION = pattern(r"instal|depend|prereq|requir|setup|set up|compil|getting started", re.IGNORECASE)
_NO_LIBRARY = pattern(r"data|model|weight|vocabular|bag\b|map\b|example|troubl|optional|docker", re.IGNORECASE)
_DATA = pattern(
    r"\.(?:zip|7z|rar|tar(?:\.\w+)?|tgz|bag|db3|mcap|pcap|pcd|ply|pth?|ckpt|onnx|h5|hdf5|pkl|np[yz]|safetensors|weights|"
    r"caffemodel)(?:\?[\w=&-]*)?$",
    re.IGNORECASE,
)
"""An address of data or of weights, or of an archive of them."""
_KEY = pattern(r"[\w-]{20,60}")
"""Of a file at Google Drive, which ``gdown`` takes in place of an address: https://github.com/wkentaro/gdown#usage"""
_SCRIPT = pattern(
    r"^(?:[\w./-]*/)?(?:build|make|compile|install)(?:[_-]\w+)*\.(?:(?:ba)?sh|py)$|^[\w./-]*_(?:build|compile)\.(?:ba)?sh$"
)
"""A script that compiles something, by its name."""
_FOLDER = pattern(r"(?:\./)?\w[\w-]*(?:/[\w.-]+)*/?")
"""A folder by its path from where the page is."""
_PLAIN = pattern(r"-j\d*|[\w./=+-]{1,80}")
_RUNNERS = frozenset({"bash", "sh", "python", "python3"})


def steps(command: Command, heading: str, folder: str = "") -> Iterator[tuple[Topic, str]]:
    """Yield what a command does: a step that only a person can repeat, or the image that ``docker`` builds or pulls.

    ``heading``: the sections that it stands in; what is fetched outside of an installation is data. ``folder``: where
    the page is by then, which comes first in what is told of a script that compiles.
    """
    words = command.words
    program = words[0].rpartition("/")[2]
    called = words[1:] if program in _RUNNERS else words
    script = called and _SCRIPT.match(called[0]) and (called is not words or "/" in called[0])
    yield from (*_entering(words), *_making(words, folder))
    yield from (("own_package", path) for path in own_packages.called(words, folder))
    yield from (("patched", call) for call in patches.called(command, folder))
    yield from (("edited", call) for call in edits.called(command, folder))
    yield from (("single_header", each) for each in single_headers.called(words))
    if program in downloads.PROGRAMS:
        yield from downloads.told(words, folder)
    if script or (called is not words and builds_in_place(called)):
        yield "build_script", " ".join((folder or ".", *called))
    if program == "docker":
        yield from _docker(words)
    elif program in {"touch", "mkdir"}:
        yield from _left_there(words, folder)
    elif program in {"add-apt-repository", "apt-add-repository"}:
        yield from (("step", " ".join(words)) for word in words if word.startswith("ppa:"))
    elif (program == "dpkg" and {"-i", "--install"} & {*words}) or program == "gdebi" or _told(words):
        yield "step", " ".join(words)
    elif program in {"wget", "curl"} and (not heading or _INSTALLATION.search(heading)):
        urls = (word for word in words if "://" in word and _PACKAGES.search(word) and not is_release(word))
        if (url := next(urls, None)) and not _NO_LIBRARY.search(f"{heading} {url.rpartition('/')[2]}"):
            yield "step", f"{program} {url}"
            return
    if program in {"wget", "curl", "gdown"}:
        yield from (("data", f"{program} {word}") for word in _data(program, words))


def _entering(words: tuple[str, ...]) -> Iterator[tuple[Topic, str]]:
    if environment := entered(words):
        yield "entered", environment
    yield from (("session_loaded", path) for path in loaded_session(words))


def _making(words: tuple[str, ...], folder: str) -> Iterator[tuple[Topic, str]]:
    """Yield a call of make: the folder that the text is in by then, and the words behind it but the number of jobs."""
    if words[0] in {"make", "gmake"} and all(map(_PLAIN.fullmatch, words[1:])):
        yield "make", " ".join((folder or ".", *(word for word in words[1:] if not word.startswith("-j"))))


def _data(program: str, words: tuple[str, ...]) -> tuple[str, ...]:
    """Return the address, or the key at Google Drive, of the data that a command fetches, if it fetches any."""
    if program == "gdown":
        named = [word for word in words[1:] if "://" in word or _KEY.fullmatch(word)]
    else:
        named = [word for word in words[1:] if "://" in word and _DATA.search(word) and not is_release(word)]
    return tuple(word for word in named if UNKNOWN not in word)[:1]


def _left_there(words: tuple[str, ...], folder: str) -> Iterator[tuple[Topic, str]]:
    """Yield the package that ``touch`` has the build skip, or the folders that ``mkdir`` makes."""
    from roslab.evidence.prose.taken_out import marked  # noqa: PLC0415 - few pages leave a package out

    if words[0] == "touch":
        yield from (("skipped", path) for path in marked(words, folder))
    elif words[0] == "mkdir":
        yield from (("made", word) for word in words[1:] if _FOLDER.fullmatch(word))


def _told(words: tuple[str, ...]) -> bool:
    """Tell whether a command applies a patch to what was cloned, or starts a simulator that nobody packages."""
    return words[:2] == ("git", "apply") or words[0] == "patch" or _of_webots(words)


def _of_webots(words: tuple[str, ...]) -> bool:
    """Tell whether a command starts a world in Webots, a simulator that neither Ubuntu nor ROS packages."""
    return words[0] == "webots" and any(word.endswith(".wbt") for word in words[1:])


def _docker(words: tuple[str, ...]) -> Iterator[tuple[Topic, str]]:
    verbs = [word for word in words[1:] if word not in {"buildx", "image"}]
    if verbs[:1] == ["pull"] and len(verbs) > 1:
        yield "image_pulled", verbs[-1]
    if verbs[:1] == ["build"]:
        for index, word in enumerate(words[:-1]):
            if word in {"-t", "--tag"}:
                yield "image_built", words[index + 1]
            elif word.startswith("--tag="):
                yield "image_built", word.removeprefix("--tag=")
