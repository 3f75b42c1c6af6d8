"""Weights that a file of settings names and the tree lacks, where a script of the page downloads what is needed."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator

from roslab.evidence.facts import Mention
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
MAX_FILES = 40
_SETTINGS = (".yaml", ".yml", ".json")
_NAMED = pattern(
    r"^[ \t-]*[\"']?(?![^:\n]*(?:out|save|export|log|result))(\w+)[\"']?[ \t]*:[ \t]*[\"']?"
    r"((?!/)[\w.-]+(?:/[\w.-]+)+\.(?:pth?|ckpt|onnx|safetensors|pkl|h5|tflite|engine|weights))[\"']?(?=[\s,#]|$)",
    re.MULTILINE,
)
"""A line with a key that is none of what the program writes, and a file of weights below a folder."""
_DOWNLOADS = pattern(r"(?:^|/)(?:down-?load|fetch|get)_?[\w-]*\.(?:py|sh)$", re.IGNORECASE)


def read(repository: Repository, said: Iterable[Mention]) -> Iterator[Mention]:
    """Yield each such file, at its line in the settings, with the command of the first page that downloads some."""
    commands = [each for each in said if each.topic == "command" and each.source == "readme"]
    download = next((each for each in commands if any(map(_DOWNLOADS.search, each.files[:1]))), None)
    if download is None:
        return
    given = dict.fromkeys(file for each in commands for file in each.files if file.endswith(_SETTINGS))
    for settings in list(given)[:MAX_FILES]:
        text = repository.read(settings, limit=MAX_SIZE) if repository.has(settings) else ""
        for match in _NAMED.finditer(text):
            path = posixpath.normpath(match[2])
            beside = posixpath.normpath(posixpath.join(posixpath.dirname(settings), path))
            if not any(map(repository.may_have, (path, beside))):
                line = text.count("\n", 0, match.start(1)) + 1
                yield replace(download, topic="weights", value=path, file=settings, line=line, files=(settings,))
