"""Programs of Python that write code which CMake compiles and the tree does not have: a solver of acados.

CMake says so itself, in the error with which it stops without that code, or a page runs a program which names the
folder that CMake compiles and that is not there.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.cmake import Call, calls
from roslab.repository.checkout import File, Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

MOST = 6
"""Most programs that are run."""
_ERROR = "FATAL_ERROR"
_NAMED = pattern(r"(?:\bcd[ \t]+[\w./-]{1,200}\s{1,40})?\bpython3?[ \t]+(?P<path>[\w./-]{1,200}\.py)\b")
_FOLDER = pattern(
    r"\$\{(?:CMAKE_CURRENT_(?:SOURCE|LIST)_DIR|PROJECT_SOURCE_DIR)\}/(\w{0,40}(?:generated|codegen|autogen)\w{0,40})(?![\w.])"
)
_COMMAND = pattern(r"python3? ([\w./-]+\.py)")


def read(repository: Repository, mentions: Iterable[Mention]) -> Iterator[Mention]:
    """Yield the call of each such program, from the folder of the tree that ``inside`` names; ``files``: itself."""
    run = [each for each in mentions if each.topic == "command" and each.source == "readme" and len(each.files) == 1]
    found: dict[str, Mention] = {}
    for file in repository.named("CMakeLists.txt"):
        text = "" if places.aside(file.path) else repository.read(file)
        for each in (*_of_errors(repository, file, text), *_of_pages(repository, file, text, run)):
            found.setdefault(each.files[0], each)
    yield from [found[path] for path in sorted(found)][:MOST]


def _of_errors(repository: Repository, file: File, text: str) -> Iterator[Mention]:
    """Yield what an error of CMake names that ends it where a file or a folder is not there."""
    for call in calls(text, frozenset({"message"})) if _ERROR in text and ".py" in text else ():
        if call.words[:1] != (_ERROR,) or not _where_absent(call):
            continue
        said = _NAMED.search(" ".join(call.words[1:]).replace("\\n", "\n"))
        script = _script(repository, file, said["path"]) if said else None
        if said and script:
            yield _mention(said["path"], script, said[0], (file.path, call.line))


def _where_absent(call: Call) -> bool:
    return any(condition.startswith("NOT EXISTS ") for condition in call.conditions)


def _script(repository: Repository, file: File, path: str) -> str | None:
    """Return the only program of a package that ends in a path: an error names it as from its own folder."""
    name = posixpath.basename(path)
    there = [each.path for each in repository.named(name) if f"/{each.path}".endswith(f"/{posixpath.normpath(path)}")]
    there = [each for each in there if not file.folder or each.startswith(f"{file.folder}/")]
    return there[0] if len(there) == 1 else None


def _of_pages(repository: Repository, file: File, text: str, run: Iterable[Mention]) -> Iterator[Mention]:
    """Yield what a page runs of the package, where it names a folder that CMake compiles and the tree lacks."""
    folders: frozenset[str] | None = None
    for said in run:
        script, command = said.files[0], _COMMAND.fullmatch(said.value)
        if not command or command[1] != script or (file.folder and not script.startswith(f"{file.folder}/")):
            continue
        if folders is None:
            named = frozenset(_FOLDER.findall(text))
            folders = frozenset(each for each in named if posixpath.join(file.folder, each) not in repository.folders)
        code = repository.read(script) if folders else ""
        if any(f'"{each}"' in code or f"'{each}'" in code for each in folders):
            written = said.text.split()[-1].removeprefix("./")
            found = _mention(written if script.endswith(written) else script, script, said.text)
            yield replace(found, source="readme", file=said.file, line=said.line)


def _mention(path: str, script: str, text: str, place: tuple[str, int] = ("", 1)) -> Mention:
    """Return the call of a program from the folder in which a path leads to it."""
    where = script.removesuffix(posixpath.normpath(path)).rstrip("/")
    return Mention(
        topic="generates",
        value=f"python3 {posixpath.relpath(script, where or '.')}",
        source="code",
        file=place[0],
        line=place[1],
        text=text,
        files=(script,),
        inside=where,
    )
