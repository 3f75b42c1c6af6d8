"""Folders of a package in which code writes or reads data, and which git lost, for it keeps no empty ones.

``ros::package::getPath("planner") + "/results/path.bin"``, and in a launch file ``$(find planner)/results/path.bin``:
of ROS 1, whose packages are found where their source lies.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention, PackageManifest
from roslab.evidence.lex.lines import end_of_line
from roslab.evidence.lex.xml_comments import without_xml_comments
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
MOST = 12
"""Most folders that are told."""
_CODE = (".cpp", ".cc", ".cxx", ".c", ".h", ".hpp", ".hh", ".cu", ".py")
_LAUNCH = (".launch", ".xml", ".test")
_NAME = r"[a-z][\w-]{1,60}"
_PATH = r"[\"']/?((?:[\w-][\w.-]*/)+)([\w.-]*)[\"']"
_ASKED = pattern(r"get(?:P|_p)ath")
_IN_CODE = pattern(rf"\bget_?[pP]ath\(\s*[\"']({_NAME})[\"']\s*\)\s*(?:\+|,)\s*(?:std::string\(\s*)?{_PATH}")
_IN_LAUNCH = pattern(rf"(?:value|default)\s*=\s*[\"']\$\(find ({_NAME})\)/((?:[\w-][\w.-]*/)+)([\w.-]*)[\"']")
_GIVEN = (
    *(".launch", ".yaml", ".yml", ".xml", ".xacro", ".urdf", ".sdf", ".world", ".rviz", ".srdf", ".py", ".perspective"),
    *(".stl", ".dae", ".obj", ".mesh", ".json", ".ini", ".cfg", ".conf", ".pt", ".pth", ".onnx", ".engine", ".so"),
)
"""Endings of what an author gives a program: nothing is gained by a folder without it."""

_WRITES = pattern(
    r"ofstream|fstream::out|ios(?:_base)?::out|write|sav(?:e|ing)|dump|record|output|result|log|"
    r",\s{0,9}(?:mode\s?=\s?)?[\"'][wax]b?\+?[\"']",
    re.IGNORECASE,
)
"""What a line has that writes a file."""
_REFUSES = pattern(
    r"\bif\s*\(\s*(?:\w+::)*(?:is_directory|exists)\s*\([^{}!]{1,120}\)\s*\{[^{}]{0,400}\b(?:return|exit|throw)\b|"
    r"^([ \t]*)if os\.path\.(?:exists|isdir)\([^\n]{1,120}\):\n"
    r"(?:\1[ \t][^\n]*\n){0,4}?\1[ \t]+(?:return|raise|(?:sys\.)?exit)\b",
    re.MULTILINE,
)
_MAKES = pattern(r"\b(?:create_director(?:y|ies)|mkdirs?|makedirs)\s*\(")


def read(repository: Repository, manifests: Iterable[PackageManifest]) -> Iterator[Mention]:
    """Yield each such folder once, by its path from the root, at the first place that names it.

    With the file that is meant (``files``) where the tree has one of that name elsewhere, and nothing there tells that
    it is written.
    """
    owners = {each.name: posixpath.dirname(each.file) for each in manifests if each.name and not each.ignored}
    found: set[str] = set()
    for file in repository.suffixed(*_CODE, *_LAUNCH) if owners else ():
        if file.size > MAX_SIZE or places.vendored(file.path) or places.test(file.path):
            continue
        launch = file.path.endswith(_LAUNCH)
        text = repository.read(file)
        if not ("$(find " in text if launch else _ASKED.search(text)):
            continue
        text = without_xml_comments(text) if launch else text
        for match in (_IN_LAUNCH if launch else _IN_CODE).finditer(text):
            folder = posixpath.normpath(posixpath.join(owners.get(match[1], ""), match[2]))
            lost = match[1] in owners and folder not in repository.folders and not repository.has(folder)
            if not lost or folder in found or match[3].endswith(_GIVEN) or _commented(text, match.start(), file.path):
                continue
            if not match[3] and _makes_it_anew(text):
                continue
            found.add(folder)
            line = text.count("\n", 0, match.start()) + 1
            said = match[0][:120]
            written = _WRITES.search(text, text.rfind("\n", 0, match.start()) + 1, end_of_line(text, match.end()))
            there = () if written else _called(match[3], repository)
            yield Mention(
                topic="lost_folder",
                value=folder,
                source="code",
                file=file.path,
                line=line,
                text=said,
                files=there if len(there) == 1 else (),
            )
            if len(found) == MOST:
                return


def _makes_it_anew(text: str) -> bool:
    """Tell whether code makes a folder itself and stops where one is there: an earlier run's results are in it."""
    return bool(_MAKES.search(text)) and bool(_REFUSES.search(text))


def _called(name: str, repository: Repository) -> tuple[str, ...]:
    """Return the paths of the files with a name, written as it is."""
    return tuple(file.path for file in repository.named(name) if file.name == name)


def _commented(text: str, at: int, file: str) -> bool:
    before = text[text.rfind("\n", 0, at) + 1 : at]
    return ("#" if file.endswith(".py") else "//") in before if not file.endswith(_LAUNCH) else False
