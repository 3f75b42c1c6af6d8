"""Steps of an installation that are neither apt, pip, conda nor a clone, and images that a page builds or fetches."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Literal

from roslab.evidence.lex.shell import Command
from roslab.evidence.prose.archives import is_release
from roslab.values.pattern import pattern

Topic = Literal["step", "image_built", "image_pulled"]
_PACKAGES = pattern(r"\.(?:deb|run|sh|tar(?:\.\w+)?|tgz|zip|AppImage)$")
_INSTALLATION = pattern(r"instal|depend|prereq|requir|setup|set up|compil|getting started", re.IGNORECASE)
_NO_LIBRARY = pattern(r"data|model|weight|vocabular|bag\b|map\b|example|troubl|optional|docker", re.IGNORECASE)


def steps(command: Command, heading: str) -> Iterator[tuple[Topic, str]]:
    """Yield what a command does: a step that only a person can repeat, or the image that ``docker`` builds or pulls.

    ``heading``: the sections that it stands in; what is fetched outside of an installation is data.
    """
    words = command.words
    program = words[0].rpartition("/")[2]
    if program == "docker":
        yield from _docker(words)
    elif program in {"add-apt-repository", "apt-add-repository"}:
        yield from (("step", " ".join(words)) for word in words if word.startswith("ppa:"))
    elif (program == "dpkg" and {"-i", "--install"} & {*words}) or program == "gdebi":
        yield "step", " ".join(words)
    elif program in {"wget", "curl"} and (not heading or _INSTALLATION.search(heading)):
        urls = (word for word in words if "://" in word and _PACKAGES.search(word) and not is_release(word))
        if (url := next(urls, None)) and not _NO_LIBRARY.search(f"{heading} {url.rpartition('/')[2]}"):
            yield "step", f"{program} {url}"


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
