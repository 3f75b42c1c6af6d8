"""Scripts of the net that a page pipes into a shell and that add a source of apt: ``curl …/add_ppa.sh | bash``."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.facts import Mention
from roslab.values.pattern import pattern

_PIPED = pattern(
    r"\b(curl|wget)[ \t][^|\n`]{0,200}?(https?://[^\s|`'\"<>]{1,300})[^|\n`]{0,80}\|[ \t]{0,4}"
    r"(?:sudo[ \t]+(?:-\w+[ \t]+)*)?(?:/bin/)?((?:ba)?sh)\b"
)
_SOURCE = pattern(r"(?<![a-z])(?:ppa|apt|deb|add[-_](?:[a-z]{1,20}[-_])?(?:repo|repository|sources?))(?![a-z])")
"""What the address of such a script names."""
_OF_ROS = pattern(r"(?<![a-z])ros[12]?(?![a-z])[^/]*$")
"""Its file names ROS: that source the base image has."""
_ADDS = ("add-apt-repository ", "apt-add-repository ")


def read(file: str, text: str) -> Iterator[Mention]:
    """Yield a step for each line that runs such a script."""
    if "|" not in text or ("curl" not in text and "wget" not in text):
        return
    for match in _PIPED.finditer(text):
        url = match[2].lower()
        if _SOURCE.search(url) and not _OF_ROS.search(url):
            line = text.count("\n", 0, match.start()) + 1
            value = f"{match[1]} {match[2]} | {match[3]}"
            yield Mention(topic="step", value=value, source="readme", file=file, line=line, text=match[0][:200])


def adds_a_source(mention: Mention) -> bool:
    """Tell whether a step adds a source of apt: by such a script, or as ``add-apt-repository`` does."""
    return mention.value.startswith(_ADDS) or (" | " in mention.value and mention.value.endswith("sh"))
