"""The project of Autotools that a tree is: configure.ac, or the configure that was made of it, and each Makefile.am."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.makefile import Makefile
from roslab.evidence.native import compile_scripts
from roslab.knowledge.autoconf_macros import packages_of_macro
from roslab.knowledge.cmake_calls import packages_of_calls
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
MAX_FILES = 100
"""Most files of Automake that are read."""
_SOURCES = ("configure.ac", "configure.in")
_MADE = "configure"
_COMMENT = pattern(r"(?:^|(?<=\s))(?:#|dnl\b)[^\n]*", re.MULTILINE)
_PROGRAMS = pattern(r"^[ \t]*(bin|sbin|noinst)_PROGRAMS[ \t]*\+?=[ \t]*([^\n]*)", re.MULTILINE)
_NAME = pattern(r"[A-Za-z][\w.-]*")
_WORD = r"[ \t\n]*(?:\[[ \t\n]*)?([\w.+-]+)[ \t\n]*(?:\][ \t\n]*)?"
_LIBRARY = pattern(rf"\bAC_CHECK_LIB\({_WORD}[,)]")
_MODULES = pattern(r"\bPKG_CHECK_MODULES\(\s*\[?\w+\]?\s*,\s*(?:\[\s*)?([^\[\](),\s][^\[\](),]{0,400})(?:\]\s*)?[,)]")
_MODULE = pattern(r"(?<![<>=!])(?<![<>=!]\s)(?<![\w.+${-])([A-Za-z][\w.+-]*)")
_CALLED = pattern(r"\b[A-Z]{2,5}_[A-Z][A-Z0-9_]{1,60}\b")
_MACROS = pattern(
    r"\bAC_CONFIG_MACRO_DIRS?\(\s*(?:\[\s*)?([\w-][\w./-]*)|^ACLOCAL_AMFLAGS[ \t]*\+?=[^\n]*?-I[ \t]*([\w-][\w./-]*)",
    re.MULTILINE,
)
"""The folder of macros, which aclocal does not make: git keeps none without a file."""
_MAKER = "autoreconf"
_ANEW = f"{_MAKER} --force --install"
_CALL = "sh ./configure"


def read(repository: Repository) -> Iterator[Makefile]:
    """Yield the project at the root, else the only one in a folder there; none of copied code.

    The configure of a checkout may be older than what it is made of, and so make would make it again: it is made anew
    where its source is there. https://www.gnu.org/software/automake/manual/html_node/CVS.html, read 2026-11-29.
    """
    files: dict[str, File] = {}
    for name in (*_SOURCES, _MADE):
        for file in repository.named(name):
            if file.path.count("/") <= 1 and not (places.vendored(file.path) or places.aside(file.path)):
                files.setdefault(file.folder, file)
    found = [files[""]] if "" in files else list(files.values())
    for file in found if len(found) == 1 else ():
        automade = _automade(repository, file.folder)
        if automade or repository.has(posixpath.join(file.folder, "Makefile.in")):
            yield _project(file, automade, repository)


def _automade(repository: Repository, folder: str) -> list[File]:
    below = f"{folder}/" if folder else ""
    files = [f for f in repository.named("Makefile.am") if f.path.startswith(below) and f.size <= MAX_SIZE]
    return [file for file in files if not places.vendored(file.path)][:MAX_FILES]


def _project(file: File, automade: list[File], repository: Repository) -> Makefile:
    text = _COMMENT.sub("", repository.read(file, limit=MAX_SIZE)) if file.name != _MADE else ""
    texts = {each: _COMMENT.sub("", repository.read(each).replace("\\\n", " ")) for each in automade}
    installed: dict[str, None] = {}
    programs: dict[str, None] = {}
    for each, written in texts.items():
        for where, names in _PROGRAMS.findall(written):
            for name in filter(_NAME.fullmatch, names.split()):
                programs[name] = None
                if where != "noinst":
                    installed[posixpath.relpath(posixpath.join(each.folder, name), file.folder or ".")] = None
    libraries = (
        *_LIBRARY.findall(text),
        *(name for written in texts.values() for name in compile_scripts.linked(written)),
    )
    modules = [name for said in _MODULES.findall(text) for name in _MODULE.findall(said)]
    whole = "\n".join((text, *(said for each, said in texts.items() if each.folder == file.folder)))
    folders = dict.fromkeys(first or second for first, second in _MACROS.findall(whole))
    lost = [each for each in folders if posixpath.join(file.folder, each.rstrip("/")) not in repository.folders]
    made = f"mkdir --parents {' '.join(lost)} && " if lost else ""
    tools = (package for macro in dict.fromkeys(_CALLED.findall(text)) for package in packages_of_macro(macro))
    return Makefile(
        file=file.path,
        line=1,
        programs=tuple(programs),
        installs=tuple(posixpath.basename(path) for path in installed),
        only=next(iter(installed)) if len(installed) == 1 else None,
        linked=tuple(dict.fromkeys(libraries)),
        cuda=False,
        alone=True,
        modules=tuple(dict.fromkeys(modules)),
        configured=_CALL if file.name == _MADE else f"{made}{_ANEW} && {_CALL}",
        tools=() if file.name == _MADE else tuple(dict.fromkeys((*packages_of_calls()[_MAKER], *tools))),
    )
