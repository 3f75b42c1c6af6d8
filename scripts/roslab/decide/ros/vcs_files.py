"""Which lists of sister repositories are imported into the workspace."""

from __future__ import annotations

import re

from roslab.config.model import Config
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import distros
from roslab.values.pattern import pattern

_EXTRA = pattern(
    r"nightly|tools?|simulat|extra|optional|\bci\b|test|debug|docs?|develop|ssh|upstream|example|demo", re.IGNORECASE
)
_WORDS = pattern(r"[a-z]+")


def vcs_files(evidence: Evidence, config: Config, ros_distro: str | None, *, lacking: bool) -> tuple[str, ...]:
    """Return the vcs files to import: roslab.yaml's, else those for this distribution, else the plainest ones.

    ``lacking``: something is needed that no distribution has. Otherwise a list below the root is imported only where a
    page, a Dockerfile or CI names it: it may be data of a program.
    """
    if config.vcs is not None:
        return config.vcs
    files = list(dict.fromkeys(source.file for source in evidence.sources if source.kind == "vcs"))
    distinct = [(file, distros_in(_name(file))) for file in files]
    named = [file for file, words in distinct if ros_distro in words]
    plainest = _plainest(named or [file for file, words in distinct if not words])
    said = [mention for mention in evidence.mentions if mention.topic == "vcs_file"]
    pages = {mention.value for mention in said if mention.source == "readme"}
    plainest = [file for file in plainest if _name(file).lower() in pages] or plainest
    nearest = min((file.count("/") for file in plainest), default=0)
    found = tuple(file for file in plainest if file.count("/") == nearest)
    anywhere = {mention.value for mention in said}
    sure = not nearest or lacking or config.compatible
    return found if sure else tuple(file for file in found if _name(file).lower() in anywhere)


def distros_in(text: str) -> set[str]:
    """Return the distributions that a file's name or an image's tag names."""
    return set(_WORDS.findall(text.lower())) & distros().keys()


def _plainest(files: list[str]) -> list[str]:
    """Return the lists of unreleased packages if there are any, else all lists, without those for tests or tools."""
    files = [file for file in files if "not-released" in file] or files
    plain = [file for file in files if not _EXTRA.search(_name(file))]
    return plain or [file for file in files if "ssh" not in file] or files


def _name(path: str) -> str:
    return path.rpartition("/")[2]
