"""The files and folders that a CMakeLists.txt, and what it includes, has its programs written to."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.evidence.lex.cmake import Call
from roslab.evidence.native.made_targets import TARGET
from roslab.evidence.native.output_folder import output_folder
from roslab.values.dataclass import dataclass, field

_AT_ONCE = "CMAKE_RUNTIME_OUTPUT_DIRECTORY"
"""A program is written where this says when it is added; what the other says last is for all programs without it."""
_OF_RELEASE = "RUNTIME_OUTPUT_DIRECTORY_RELEASE"
"""What goes before the folder of all build types in an image, which is built as a release."""
VARIABLES = frozenset({_AT_ONCE, "EXECUTABLE_OUTPUT_PATH"})


@dataclass
class ProgramFolders:
    """What is known of them so far."""

    folder: str | None = None
    """The one that is named last."""
    at_once: str | None = None
    at_last: str | None = None
    placed: dict[str, str | None] = field(default_factory=dict)
    """Programs with the folder that was set when they were added."""
    files: dict[str, str] = field(default_factory=dict)
    """File names of targets that differ from the target's name."""

    def add(self, program: str) -> None:
        """Note a program where it is added."""
        self.placed.setdefault(program, self.at_once)

    def note(self, call: Call, folder: str, programs: Collection[str]) -> None:
        """Note what ``set`` gives programs, and what ``set_target_properties(TARGETS… PROPERTIES …)`` does.

        ``folder`` is that of the CMakeLists.txt, ``programs`` those that it has added.
        """
        words = call.words
        if call.name == "set" and len(words) > 1 and words[0] in VARIABLES:
            place = output_folder(words[1], folder)
            self.folder = place or self.folder
            self.at_once, self.at_last = (place, self.at_last) if words[0] == _AT_ONCE else (self.at_once, place)
        if call.name == "set" or "PROPERTIES" not in words:
            return
        split = words.index("PROPERTIES")
        values = dict(zip(words[split + 1 :: 2], words[split + 2 :: 2], strict=False))
        if (output := values.get("OUTPUT_NAME")) and TARGET.match(output):
            self.files |= dict.fromkeys(words[:split], output)
        place = values.get(_OF_RELEASE) or values.get("RUNTIME_OUTPUT_DIRECTORY")
        if place and any(word in programs for word in words[:split]):
            written = output_folder(place, folder)
            self.folder = written or self.folder
            self.placed |= {word: written for word in words[:split] if word in self.placed}

    def file(self, target: str) -> str:
        """Return the name of a target's file."""
        return self.files.get(target, target)

    def elsewhere(self) -> Iterator[tuple[str, str]]:
        """Yield the programs that lie elsewhere than in the folder that is named last, each with its own."""
        for name, place in self.placed.items():
            where = place or self.at_last
            if where and where != self.folder:
                yield self.file(name), where
