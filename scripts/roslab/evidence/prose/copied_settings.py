"""Files of settings that git does not have and that a page copies from others: ``cp config.example.yaml config.yaml``.

Without the copy the program stops, or runs with other values.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.facts import Mention
from roslab.evidence.prose.headings import MAX_LINE, lines_of
from roslab.evidence.prose.pages import pages, text_of
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

MOST = 20
"""Most copies that are made."""
_SETTINGS = pattern(r"\.env(?:\.\w+)?|[\w.+-]+\.(?:ya?ml|json|toml|ini|cfg|conf|config|env|properties|xml|py)")
_OF_BUILDS = frozenset(
    {"package.xml", "CMakeLists.txt", "setup.py", "pyproject.toml", "environment.yml", "conftest.py"}
)
"""What the image is made by, of which pages have one for each version of ROS."""
_PATH = r"[\"']?((?:\./)?[\w.][\w.+/-]{0,200})[\"']?"
_COPIED = pattern(rf"(?<![\w./-])(?:cp|mv)[ \t]+(?:-[fiv]+[ \t]+)*{_PATH}[ \t]+{_PATH}(?=[ \t]*(?:[`;&|)#]|$))")
_SAID = pattern(
    r"(?<!\bnot )(?<!n't )(?<!\bnever )"
    rf"\b(?:copy|duplicate|rename)\b[^\n`.]{{0,40}}`{_PATH}`[^\n`.]{{0,40}}\b(?:to|as|into)\b[^\n`.]{{0,30}}`{_PATH}`",
    re.IGNORECASE,
)
_GONE = pattern(rf"(?<![\w./-])cd[ \t]+{_PATH}[ \t]*(?:&&|;)")
_WORDS = ("cp ", "mv ", "opy ", "uplicate ", "ename ")


def read(repository: Repository) -> Iterator[Mention]:
    """Yield for each such file its path and that of the one that it is copied from (``files``)."""
    found: set[str] = set()
    for page in pages(repository):
        text = text_of(repository, page) if not places.vendored(page.path) else ""
        for line in lines_of(text) if any(word in text for word in _WORDS) else ():
            if line.elsewhere or len(line.text) > MAX_LINE or len(found) >= MOST:
                continue
            for match in (*_COPIED.finditer(line.text), *(() if line.fenced else _SAID.finditer(line.text))):
                there = _of_tree(match[1], page, repository, _gone_to(line.text[: match.start()], page, repository))
                made = _made(match[2], match[1], there) if there else ""
                if made and made not in found and _lacks(made, repository):
                    found.add(made)
                    yield Mention(
                        topic="copied",
                        value=made,
                        source="readme",
                        file=page.path,
                        line=line.number,
                        text=match[0][:200],
                        files=(there,),
                    )


def _gone_to(before: str, page: File, repository: Repository) -> str:
    """Return the folder of the tree that the words before a command go to on its line, ``""`` for none."""
    gone = [match[1] for match in _GONE.finditer(before)]
    tried = (posixpath.normpath(posixpath.join(folder, gone[-1])) for folder in ("", page.folder)) if gone else ()
    return next((folder for folder in tried if folder in repository.folders and folder), "")


def _of_tree(written: str, page: File, repository: Repository, gone_to: str) -> str:
    """Return the path of the file that is copied, from the root, the page's folder, or where a page went before."""
    path = posixpath.normpath(written)
    if gone_to:
        inside = posixpath.normpath(posixpath.join(gone_to, path))
        return inside if repository.has(inside) else ""
    below = posixpath.normpath(posixpath.join(page.folder, path))
    ends = [file.path for file in repository.named(posixpath.basename(path)) if f"/{file.path}".endswith(f"/{path}")]
    return path if repository.has(path) else below if repository.has(below) else ends[0] if len(ends) == 1 else ""


def _made(written: str, from_: str, there: str) -> str:
    """Return the path of the copy: it lies to the other file as a page says, whatever folder that goes to before."""
    to = posixpath.join(written, posixpath.basename(from_)) if written.endswith(("/", ".")) else written
    path = posixpath.relpath(posixpath.normpath(to), posixpath.dirname(posixpath.normpath(from_)) or ".")
    made = posixpath.normpath(posixpath.join(posixpath.dirname(there), path))
    name = posixpath.basename(made)
    return made if _SETTINGS.fullmatch(name) and name not in _OF_BUILDS and not made.startswith("..") else ""


def _lacks(made: str, repository: Repository) -> bool:
    """Tell whether the tree has the folder of a file, and not the file."""
    folder = posixpath.dirname(made)
    return not repository.has(made) and (not folder or folder in repository.folders)
