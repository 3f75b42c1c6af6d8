"""Headers that git does not have and that who compiles the tree copies from a template in it: ``config.example.hpp``.

Pages, scripts and CI say so: ``cp src/config.example.hpp src/config.hpp``. Without the copy the compiler stops.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.lex.includes import includes
from roslab.evidence.prose.pages import pages
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 128 * 1024
MAX_FILES = 200
"""Most pages and scripts that are opened, and most files of code for each header, those nearest to the root first."""
_CODE = (".cpp", ".cc", ".cxx", ".c", ".h", ".hpp", ".hh", ".cu", ".cuh")
_TEMPLATE = pattern(
    r".*(?:^|[._-])(?:examples?|samples?|templates?|defaults?|dist)(?:[._-].*)?\.(?:h|hh|hpp|hxx|cuh)"
    r"|.*\.(?:h|hh|hpp|hxx|cuh)\.(?:example|sample|template|default|dist)",
    re.IGNORECASE,
)
_HEADER = pattern(r"(?:[\w.+-]+/)*[\w.+-]+\.(?:h|hh|hpp|hxx|cuh)")
_PATH = r"[\"']?((?:\./)?[\w.+/-]{1,200})[\"']?"
_COPIES = (
    pattern(rf"(?<![\w./-])cp[ \t]+(?:-\w+[ \t]+)*{_PATH}[ \t]+{_PATH}(?=[\s`;&|)]|$)"),
    pattern(
        rf"\b(?:copy|duplicate)\b[^\n`.]{{0,40}}`{_PATH}`[^\n`.]{{0,40}}\b(?:to|as|into)\b[^\n`.]{{0,30}}`{_PATH}`",
        re.IGNORECASE,
    ),
)


def read(repository: Repository) -> Iterator[Mention]:
    """Yield for each such header, which the code includes, its path and that of its template (``files``)."""
    named = (f for f in repository.suffixed(*_CODE, ".example", ".sample", ".template", ".default", ".dist"))
    templates = {f.path for f in named if _TEMPLATE.fullmatch(f.name) and not places.vendored(f.path)}
    if not templates:
        return
    found: set[str] = set()
    scripts = nearest(
        (*repository.suffixed(".sh", ".bash", ".yml", ".yaml"), *repository.named("Dockerfile", "Makefile"))
    )
    for file in (*pages(repository), *scripts)[:MAX_FILES]:
        text = repository.read(file) if file.size <= MAX_SIZE else ""
        for match in (m for form in _COPIES for m in form.finditer(text)):
            template = _of_tree(match[1], file, templates)
            made = _made(match[2], match[1], template) if template else ""
            if not made or made in found or repository.has(made) or not _included(made, template, repository):
                continue
            found.add(made)
            line = text.count("\n", 0, match.start()) + 1
            yield Mention(
                topic="copied",
                value=made,
                source="readme",
                file=file.path,
                line=line,
                text=match[0][:200],
                files=(template,),
            )


def _of_tree(written: str, file: File, templates: set[str]) -> str:
    """Return the path of the template that is copied, from the root or from the folder of the file that says so."""
    path = posixpath.normpath(written)
    below = posixpath.normpath(posixpath.join(file.folder, path))
    ends = [each for each in templates if each.endswith(f"/{path}")]
    return path if path in templates else below if below in templates else ends[0] if len(ends) == 1 else ""


def _made(written: str, from_: str, template: str) -> str:
    """Return the path of the copy: it lies to the template as a page says, whatever folder that goes to before."""
    to = posixpath.join(written, posixpath.basename(from_)) if written.endswith("/") else written
    path = posixpath.relpath(posixpath.normpath(to), posixpath.dirname(posixpath.normpath(from_)) or ".")
    made = posixpath.normpath(posixpath.join(posixpath.dirname(template), path))
    return made if _HEADER.fullmatch(made) and not made.startswith("..") else ""


def _included(made: str, template: str, repository: Repository) -> bool:
    """Tell whether the code includes a header of that name."""
    name = posixpath.basename(made)
    files = (f for f in repository.suffixed(*_CODE) if f.size <= MAX_SIZE and f.path != template)
    texts = (text for file in nearest(files)[:MAX_FILES] if name in (text := repository.read(file)))
    return any(posixpath.basename(each[1]) == name for text in texts for each in includes(text))
