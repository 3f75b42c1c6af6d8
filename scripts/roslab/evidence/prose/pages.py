"""The pages that explain how to install or to start, by their names, or by a link from the page at the root."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import cache

from roslab.evidence import places
from roslab.evidence.packed import packed
from roslab.evidence.prose.blank_programs import with_programs
from roslab.evidence.prose.blanks import chosen
from roslab.evidence.prose.block_values import with_values
from roslab.evidence.prose.called_tasks import with_tasks
from roslab.evidence.prose.comments import without_comments
from roslab.evidence.prose.diagrams import without_diagrams
from roslab.evidence.prose.headings import lines_of, title_of
from roslab.evidence.prose.listings import without_listings
from roslab.evidence.prose.of_windows import as_in_a_shell
from roslab.evidence.prose.other_branches import without
from roslab.evidence.prose.preformatted import as_markdown
from roslab.evidence.prose.translations import without_translations
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

MAX_SIZE = 256 * 1024
MAX_PAGES = 60
DEEPEST = 3
"""Most folders above a page that is read for its name alone."""
_MADE_BY = ("package.xml", "CMakeLists.txt")
_PAGE = pattern(
    r"^(?:readme|install|installation|building|build|compiling|compilation|"
    r"getting[-_ ]?started|setup|dependencies|requirements|quick[-_ ]?start|usage)(?:[-_. ].*)?$"
)
_ASCIIDOC = (".adoc", ".asciidoc")
_TEXTS = (".md", ".mdx", ".rst", ".txt", "", ".markdown", ".mkd", ".org", *_ASCIIDOC)
_DOCS_PAGE = pattern(
    r"install|compil|getting[-_ ]?started|setup|build|depend|requirement|quick[-_ ]?start|prerequisite|usage|running|"
    r"launching|^(?:gazebo[-_ ]?)?simulations?\b"
)
_VARIANT = pattern(r"readme[-_.](?!md$|rst$|txt$|markdown$)\w", re.IGNORECASE)
"""A page that says what another one does, in a language or for a system: it comes after that."""
LINK = pattern(
    r"\]\(\s*<?(?:https?://git(?:hub|lab)\.com/[\w.-]+/[\w.-]+/(?:-/)?(?:blob|tree)/[\w.-]+/|(/))?"
    r"((?:\.{1,2}/){0,4}\w[\w./-]*(?:\.(?:md|rst|adoc|asciidoc)|/|(?<=/)[\w-]+))(?:#[^)\s]*)?>?\s*\)"
)
"""A link of Markdown to a page or a folder of pages, by its path or by its whole address; one that begins with ``/``
is meant from the root. What the tree lacks is no such."""
_INSTALLS = pattern(r"install|set(?:ting)?[-_ ]?up\b|prerequisite|dependenc|compil|build", re.IGNORECASE)
"""Words of a title, of a page's name or of the text of a link."""
_ASIDE = pattern(
    r"contribut|change|licen[sc]e|conduct|security|faq|trouble|error|news|history|author|issue|docker|container|"
    r"windows|mac ?os|hardware|jetson|raspberry|robot|data|train|evaluat|benchmark|model|develop|test|uninstall",
    re.IGNORECASE,
)
"""What a page is about that an installation also names, and that is none of it."""
_GUIDE = pattern(
    r"^(?!.*(?:style|cod(?:e|ing)|contribut|release|migrat))(?:.*[-_. ])?"
    r"(?:guides?|how[-_ ]?to|instructions?)(?:[-_. ]|$)"
)
"""The name of a page at the root that tells how to start the program where no README does."""
_NOTES = pattern(
    r"(?:^|[-_. ])(?:notes?|todo|to[-_ ]do|plans?|roadmap|logs?|commands?|cheat\w*|releases?|summary|reports?|paper|"
    r"design|architect\w*|style|singularity|apptainer|agents?|claude|copilot|gemini|prompts?|citation|credits?|thanks|"
    r"status|progress|ideas?|meetings?|spec|specification|requirements?|"
    r"migrat\w*|upgrad\w*|results?|legacy|deprecat\w*|old)(?:[-_. ]|$)",
    re.IGNORECASE,
)
"""The name of a page that is for those who write the code, or that tells of it without starting it."""
_ABOUT = pattern(r"readme|install")
_MANUAL = pattern(r"guide|manual|tutorial|how[-_ ]?to|instructions", re.IGNORECASE)
_STYLE = pattern(r"style|cod(?:e|ing)|contribut|release|migrat|conduct", re.IGNORECASE)
_CODE = pattern(r"^(?:[ \t]{0,9}(?:```|~~~)|(?: {4}|\t)\S)", re.MULTILINE)
"""The first line of a block of code."""


def text_of(repository: Repository, file: File) -> str:
    """Return what a page says to those who read it, with all its blocks of code fenced.

    That is not what it comments out, nor what it says of another branch. Blanks in names of programs are filled in,
    and in place of ``just run`` or ``make run`` stands what that runs. Calls of Python are those of a shell.
    """
    texts = repository.once(_texts)
    if file.path not in texts:
        text = with_tasks(without(repository, _shown(_read(repository, file))), repository, file)
        text = as_in_a_shell(text, repository, file)
        texts[file.path] = with_programs(text, repository, file)
    return texts[file.path]


def _texts(_: Repository) -> dict[str, str]:
    """Return what keeps the text of each page, by its path, for the many readers of them."""
    return {}


def _read(repository: Repository, file: File) -> str:
    text = repository.read(file)
    if not file.path.endswith(_ASCIIDOC):
        return text
    from roslab.evidence.prose import asciidoc  # noqa: PLC0415 - few pages are in it

    return asciidoc.as_markdown(text)


@cache
def _shown(text: str) -> str:
    return with_values(chosen(without_listings(without_diagrams(as_markdown(without_comments(text))))))


def pages(repository: Repository) -> tuple[File, ...]:
    """Return the pages that explain how to install or to start, those nearest to the root first.

    Of folders that lie equally deep, those come first to which the page at the root links, in the order of its links.
    """
    return repository.once(_pages)


def _pages(repository: Repository) -> tuple[File, ...]:
    found = []
    others = tuple(f"{folder}/" for folder in packed(repository))
    for file in repository.suffixed(*_TEXTS):
        name = file.name.lower()
        if file.size > MAX_SIZE or places.vendored(file.path) or places.test(file.path) or name.endswith("lists.txt"):
            continue
        if file.path.startswith(others):
            continue  # another repository's
        if (name.endswith(".txt") or "." not in name) and not _ABOUT.match(name):
            continue
        page = _PAGE.match(name.rpartition(".")[0] or name)
        docs = places.documentation(file.path) and _DOCS_PAGE.search(name)
        if (page and (file.path.count("/") <= DEEPEST or _of_package(repository, file))) or docs:
            found.append(file)
    if all(file.folder for file in found):
        found += _guides(repository)
    found += _linked(repository, found)
    places_of = _linked_folders(repository, found)
    found.sort(
        key=lambda file: (
            file.path.count("/"),
            places_of.get(file.folder, len(places_of)),
            file.folder,
            bool(_VARIANT.match(file.name)),
            file.path,
        )
    )
    return tuple(without_translations(found)[:MAX_PAGES])


def _of_package(repository: Repository, file: File) -> bool:
    """Tell whether a page lies beside what builds a package, which it explains however deep that lies."""
    return any(repository.has(posixpath.join(file.folder, name)) for name in _MADE_BY)


def _guides(repository: Repository) -> list[File]:
    """Return the pages at the root that are called like guides, else all that are no notes of those who write it.

    Lists of commands are notes, for several machines.
    """
    files = [f for f in repository.suffixed(".md", ".rst", *_ASCIIDOC) if not f.folder and f.size <= MAX_SIZE]
    files = [f for f in files if not _ASIDE.search(f.name)]
    guides = [f for f in files if _GUIDE.search(f.name.rpartition(".")[0].lower())]
    return guides or [f for f in files if not _NOTES.search(f.name)]


def path_of(link: re.Match[str], page: File) -> str:
    """Return the path that a ``LINK`` of a page leads to, from the root."""
    whole = link[0].startswith(("](http", "](<http")) or link[1]
    return posixpath.normpath(link[2] if whole else posixpath.join(page.folder, link[2]))


def _linked_folders(repository: Repository, found: list[File]) -> dict[str, int]:
    """Return the place of each folder, of a page or itself, among the links of the page at the root."""
    root = next((f for f in found if not f.folder and f.name.lower().startswith("readme.")), None)
    if root is None or all(not file.folder for file in found):
        return {}
    paths = (path_of(link, root) for link in LINK.finditer(text_of(repository, root)))
    folders = {file.path: file.folder for file in found} | {file.folder: file.folder for file in found}
    linked = dict.fromkeys(folders[path] for path in paths if path in folders)
    return {folder: place for place, folder in enumerate(linked)}


def _linked(repository: Repository, found: list[File]) -> list[File]:
    """Return the pages that the page at the root links to where it tells how to install, whatever their names are."""
    taken = {file.path for file in found}
    files = {file.path: file for file in repository.suffixed(*_TEXTS) if "." in file.name and file.size <= MAX_SIZE}
    linked: dict[str, File] = {}
    for page in found:
        if "/" not in page.path and page.name.lower().startswith("readme"):
            linked |= {path: files[path] for path in _install_links(repository, page) if path in files}
            linked = {path: file for path, file in linked.items() if not _ASIDE.search(file.name)}
            linked |= {path: files[path] for path in _manual_links(repository, page) if path in files}
    there = ((path, file) for path, file in linked.items() if path not in taken)
    return [file for path, file in there if not (places.vendored(path) or places.test(path))]


def _manual_links(repository: Repository, page: File) -> Iterator[str]:
    """Yield where the links to manuals lead of a page that shows no code: what there is to run stands there."""
    text = text_of(repository, page)
    if _CODE.search(text):
        return
    for link in LINK.finditer(text):
        path, called = path_of(link, page), text[max(0, link.start() - 200) : link.start()].rpartition("[")[2]
        name = posixpath.basename(path)
        if (_MANUAL.search(name) or _MANUAL.search(called)) and not (_STYLE.search(name) or _STYLE.search(called)):
            yield path


def _install_links(repository: Repository, page: File) -> Iterator[str]:
    """Yield where the links lead that stand below a title of installation, or have such a name or text."""
    text = text_of(repository, page)
    whole = title_of(text.split("\n"))
    for line in lines_of(text):
        titles = list(line.titles.values())[1 if whole else 0 :]
        if "](" not in line.text or line.fenced or line.elsewhere or (titles and _ASIDE.search(titles[-1])):
            continue
        below = any(map(_INSTALLS.search, titles))
        for link in LINK.finditer(line.text):
            path, called = path_of(link, page), line.text[: link.start()].rpartition("[")[2]
            told = below or _INSTALLS.search(posixpath.basename(path)) or _INSTALLS.search(called)
            if told and not _ASIDE.search(called):
                yield path
