"""The transports of image_transport that launch files and parameters name, which few package.xml do."""

from __future__ import annotations

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
MAX_FILES = 800
"""Most files that are opened, those nearest to the root first."""
_WORD = "image"
"""In every file that matters: the topic, the parameter or the package has it in its name."""
_NAMED = pattern(
    r"/(?P<topic>compressedDepth|compressed|ffmpeg|theora|zstd)[\"']"
    r"|\w\.(?P<parameter>compressedDepth|compressed|ffmpeg|theora|zstd)\.\w+[\"']?\s*[:=]"
    r"|image_transport[\"']?(?:\s+(?:value|default)=|\s*:=?)\s*[\"']?"
    r"(?P<value>compressedDepth|compressed|ffmpeg|theora|zstd)\b"
)
"""The end of a topic, the parameter of a publisher (``camera.image.ffmpeg.encoder: …``) or that of a subscriber.

https://wiki.ros.org/image_transport#Parameters, read 2026-11-26."""


def read(repository: Repository) -> tuple[Dependency, ...]:
    """Return the packages of the transports, each once, where it is named first: others are left out without a word."""
    described = repository.suffixed(".launch", ".yaml", ".yml")
    launching = (file for file in repository.suffixed(".py", ".xml") if "launch" in file.name)
    files = [file for file in (*described, *launching) if file.size <= MAX_SIZE and not places.aside(file.path)]
    found: dict[str, Dependency] = {}
    for file in nearest(files)[:MAX_FILES]:
        text = repository.read(file)
        for match in _NAMED.finditer(text) if _WORD in text else ():
            from roslab.knowledge.image_transports import image_transports  # noqa: PLC0415 - few trees name one

            name = image_transports()[match["topic"] or match["parameter"] or match["value"]]
            if name not in found and not _commented(text, match.start()):
                line = text.count("\n", 0, match.start()) + 1
                found[name] = Dependency(
                    namespace="ros", name=name, strength="used", file=file.path, line=line, role="exec"
                )
    return tuple(found.values())


def _commented(text: str, position: int) -> bool:
    """Tell whether a place stands in a comment of Python or YAML, or in one of XML."""
    line = text[text.rfind("\n", 0, position) + 1 : position]
    return line.lstrip().startswith("#") or text.rfind("<!--", 0, position) > text.rfind("-->", 0, position)
