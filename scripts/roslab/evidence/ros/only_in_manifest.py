"""Names that a package.xml has and nothing else of its package: a key left over from a template, or from older code."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from collections.abc import Set as AbstractSet

from roslab.evidence import places
from roslab.evidence.facts import Mention, PackageManifest
from roslab.evidence.lex.c_comments import without_c_comments
from roslab.evidence.lex.xml_comments import without_xml_comments
from roslab.knowledge.released import ever_released, rosdep_keys
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

MAX_SIZE = 128 * 1024
MOST = 1_500
"""Most files of one package that are read; of a larger one nothing is told."""
_CODE = (".cpp", ".cc", ".cxx", ".c", ".cu", ".h", ".hpp", ".hh", ".cuh")
_XML = (".launch", ".xml", ".xacro", ".urdf", ".world", ".sdf")
_OTHERS = (".cmake", ".py", ".yaml", ".yml", ".msg", ".srv", ".action", ".cfg", ".sh", ".bash", ".txt", ".test")
_WITHOUT_ENDING = "scripts/"
_WORDS = pattern(r"[A-Za-z][\w-]*")
_NAME = pattern(r"(?!lib|python)[a-z](?:[a-z0-9]*(?:_[a-z0-9]+)+|[a-z0-9]{3,})")
"""One word alone has to be of four letters."""
_OF_BUILD = frozenset({"build", "buildtool"})
_HASH = pattern(r"#[^\n]*")
_TAKES_ALL = pattern(r"\bcatkin_simple\b|\bament_auto_find_build_dependencies\b|\bament_cmake_auto\b")
"""What has CMake look for all that the package.xml names."""


def read(repository: Repository, manifests: Iterable[PackageManifest]) -> Iterator[Mention]:
    """Yield each such name that neither rosdep nor any distribution has, once, if it is so in every package.

    It has to be one for the build, as packages of ROS have: what is only started may be so by others' files.
    """
    manifests = tuple(manifests)
    files: dict[str | None, list[File]] = {}
    folders = {each.file.rpartition("/")[0] for each in manifests}
    for file in _files(repository):
        files.setdefault(places.innermost(file.path, folders), []).append(file)
    first: dict[str, Mention] = {}
    used: set[str] = set()
    for manifest in manifests:
        named = [d for d in manifest.dependencies if _NAME.fullmatch(d.name)]
        unknown = {d.name: d for d in reversed(named) if not (d.name in rosdep_keys() or ever_released(d.name))}
        used |= unknown.keys() - {d.name for d in named if d.role in _OF_BUILD}
        if not unknown or manifest.metapackage or not manifest.file.endswith("package.xml"):
            used |= {*unknown}
            continue
        used |= _used(unknown.keys() - used, repository, files.get(manifest.file.rpartition("/")[0], ()))
        for name, asked in unknown.items():
            text = f"<depend>{name}</depend>"
            at = Mention(
                topic="only_in_manifest", value=name, source="manifest", file=asked.file, line=asked.line, text=text
            )
            first.setdefault(name, at)
    yield from (each for name, each in first.items() if name not in used)


def _used(names: AbstractSet[str], repository: Repository, own: Collection[File]) -> AbstractSet[str]:
    """Return which of some names a package's files have outside of comments; all where there may be more than is read.

    A comment is looked for only in a file with a name.
    """
    lists = (repository.read(file, limit=MAX_SIZE) for file in own if file.name == "CMakeLists.txt")
    if len(own) > MOST or any(_TAKES_ALL.search(_HASH.sub("", text)) for text in lists):
        return names
    left = set(names)
    for file in own:
        if not left:
            break
        text = repository.read(file, limit=MAX_SIZE)
        lowered = text if all("_" in name for name in left) else text.lower()
        if near := {name for name in left if name in (text if "_" in name else lowered)}:
            words = {*_WORDS.findall(_without_comments(file, text))}
            left -= {name for name in near if any(_means(word, name) for word in words)}
    return names - left


def _means(word: str, name: str) -> bool:
    """Tell whether a word may mean a package: it has its name in it, or begins so where that is one word alone."""
    return name in word if "_" in name else word.lower().startswith((name, f"lib{name}"))


def _without_comments(file: File, text: str) -> str:
    if file.path.endswith(_XML):
        return without_xml_comments(text)
    return without_c_comments(text) if file.path.endswith(_CODE) else _HASH.sub("", text)


def _files(repository: Repository) -> tuple[File, ...]:
    named = repository.suffixed(*_CODE, *_XML, *_OTHERS)
    scripts = [file for file in repository.files if "." not in file.name and _WITHOUT_ENDING in file.path]
    return (*(file for file in named if file.name not in {"package.xml", "manifest.xml"}), *scripts)
