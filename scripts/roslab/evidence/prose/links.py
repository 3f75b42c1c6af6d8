"""The repositories that a page links to: one of them may be a library, or hold what the page's own needs."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator

from roslab.evidence.dependency import GitSource
from roslab.evidence.prose import release_links
from roslab.evidence.prose.headings import lines_of
from roslab.evidence.prose.needed_items import LISTS, needed_items
from roslab.evidence.prose.said_of_links import doubt, fork_of, forked, used
from roslab.repository.checkout import File
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

MAX_LINKS = 100
MAX_DEPTH = 3
"""Of a page whose links count: that of a package may name the library that it alone needs."""
_LINK = pattern(
    r"https://(?:github|gitlab)\.com/[\w-]+/([\w.-]*\w)(?:/tree/([\w.-]*\w)|/releases/tag/([\w.-]*\w))?"
    r"(?:/(?![\w.?#/-]))?(?!\.?[\w/-])"
)
"""A page of a repository itself, of its branch or of a release, not of a file in it."""
_FOLDER = pattern(
    r"(https://(?:github|gitlab)\.com/[\w-]+/([\w.-]*\w))(?:/-)?/tree/([\w.-]*\w)/(?:[\w.-]+/){0,3}[a-z]\w*/?(?![\w./-])"
)
"""A folder in a repository, as a package lies in one."""
_DEFAULT = frozenset({"master", "main", "HEAD"})
_PINNED = pattern(r"(?:\.git)?\)?[ \t]{0,3}(?:@|\(?(?:at )?commit)[ \t]{0,3}`?\[?`?([0-9a-f]{7,40})(?![\w.])")
"""The commit behind a link: ``[odd](https://…/odd) @ 84bfc56``."""
_ITEM = pattern(r"[^\n]{0,400}(?:\n(?![ \t]{0,8}(?:[-*+]|\d{1,2}[.)])[ \t])[ \t]{1,8}\S[^\n]{0,200}){0,3}")
"""What follows on a line, with the further lines of an item of a list, which are indented."""
_NAMED_COMMIT = pattern(
    r"\b(?:commit|revision|rev|hash|sha)\b[^\n0-9]{0,40}?(?<![\w./#-])([0-9a-f]{7,40})(?![\w-])|"
    r"(?<![\w./#-])([0-9a-f]{40})(?![\w-])",
    re.IGNORECASE,
)
"""A commit in a sentence: ``(Tested commit: 7c5f5e2)``, or 40 digits alone."""
_NO_NAME = (
    r"(?!(?:default|this|that|the|an?|any|same|another|other|our|your|correct|right|new|specific|see|please|use|https?)"
    r"(?![\w/-]|\.\w))"
)
_NAMED_BRANCH = pattern(
    rf"\bbranch\b(?:[ \t]{{0,2}}[:=]|[ \t]+(?=`))[ \t]{{0,2}}[`\"']?{_NO_NAME}([\w][\w./-]{{0,60}})|"
    rf"\({_NO_NAME}([\w][\w./-]{{0,60}})[ \t]+branch\)",
    re.IGNORECASE,
)
"""The branch behind a link: ``, branch: humble-devel)``, ``(humble-devel branch)``, but not ``(default branch)``."""
_THANKS = pattern(r"acknowledg|\bthanks\b|\bcredits?\b", re.IGNORECASE)
_THANKED = pattern(r"^\W*(?:acknowledg\w*|(?:special )?thanks(?: to)?|credits?)\b[^\w]*(?:and\b.*)?$", re.IGNORECASE)
"""The title of a section that thanks others."""
BEFORE = 240
"""Most characters of a sentence before a link."""
_HOLDS = pattern(
    r"\b(?:dependenc(?:y|ies)|prerequisites?|(?:required|needed|necessary|missing) packages?)\b[^.]{0,80}"
    r"\b(?:found|available|released|provided|located|hosted|included|published|contained)\b[^.]{0,20}"
    r"\b(?:in|at|on|under|from|by|here)\b[^.]{0,60}$",
    re.IGNORECASE,
)
"""A sentence that says where the dependencies are, up to the link."""

_INSTALLS = pattern(
    r"\b(?:install(?:ing)?|(?:need|required?|prerequisite)\b[^.\n]{0,40}\bhave|requires|depends on)\s+"
    r"(?:(?:the|our|their|a|an|and|also|then|latest|library|package|version|of|from)\s+){0,4}"
    r"(?:\[[^\]\n]{1,80}\]\()?<?$|"
    r"\binstall\s+(?:[\w`'-]+\s+){1,5}\[(?:from\s+)?(?:here|this\s+(?:link|page|repo(?:sitory)?))\]\(<?$",
    re.IGNORECASE,
)
"""A sentence that has the reader install what it links to, or says that the code requires it, up to the link."""
_INSTALLING = pattern(r"\binstall", re.IGNORECASE)
"""The title of a section whose links are to be installed, ``Installation`` or ``Install dependencies``."""
_PACKAGES = pattern(
    r"\b(?:other|related|relevant|additional|further|companion|associated|external)[ \t]+(?:[\w-]+[ \t]+){0,3}"
    r"(?:packages|repositories|repos)\b",
    re.IGNORECASE,
)
"""The title of a section about packages beside those of the tree."""
_PRIVATE = pattern(
    r"(?<!not )(?<!not a )(?<!no )(?<!no longer )(?<!non-)\bprivate\b[^.\n]{0,40}"
    r"\b(?:repo(?:sitory|s|sitories)?|package|fork|submodule)s?\b[^.\n]{0,40}$",
    re.IGNORECASE,
)
"""A sentence that calls what it links to private, up to the link."""
_CALLED_PRIVATE = pattern(r"[^\s)]{0,80}\)?[ \t]*\((?:a |our |this is |currently |still )*private\b", re.IGNORECASE)


def read(text: str, file: File, cloned: Iterable[GitSource]) -> list[GitSource]:
    """Return the repositories that a page links to: one of them may be a library that CMake asks for by its name.

    What the page clones at one ref alone is meant at that ref.
    """
    refs: dict[str, set[str | None]] = {}
    for git in cloned:
        refs.setdefault(git.url.rstrip("/").removesuffix(".git"), set()).add(git.ref)
    found: dict[str, GitSource] = {}
    releases: dict[str, set[tuple[str, str | None]]] = {}
    thanked = _thanked(text)
    at_root = "" if "/" in file.path else text
    listed = _listed(at_root)
    installing = _below(at_root, _INSTALLING)
    beside = _below(at_root, _PACKAGES, nearest=True)
    for match in _LINK.finditer(text) if file.path.count("/") <= MAX_DEPTH else ():
        url = match[0].partition("/tree/")[0].partition("/releases/")[0].rstrip("/").removesuffix(".git")
        line = text.count("\n", 0, match.start()) + 1
        if line in thanked or (match[3] and not release_links.meant(text, *match.span())):
            continue
        pinned = _pinned(text, match.end())
        if url not in found or (pinned and not found[url].ref):
            found[url] = _first(
                match,
                text,
                GitSource(
                    name=match[1].removesuffix(".git").rstrip("."),
                    url=url,
                    ref=pinned,
                    strength="prose",
                    file=file.path,
                    line=line,
                    kind="link",
                ),
                refs.get(url, set()),
            )
        if release := (match[3] or "").removeprefix("v") or release_links.named(text, *match.span()):
            releases.setdefault(url, set()).add((release, match[3]))
        if not found[url].holds and (line in listed or _holds(text, match.start())):
            found[url] = replace(found[url], holds=True)
        if _INSTALLS.search(text[max(0, match.start() - BEFORE) : match.start()]):
            found[url] = replace(found[url], told=True)
        found[url] = replace(
            found[url],
            to_install=found[url].to_install or line in installing,
            of_packages=found[url].of_packages or line in beside,
        )
        found[url] = _judged(found[url], _before(text, match.start()), text, match.end())
    for url, said_of in releases.items():
        found[url] = _of_release(found[url], said_of)
    for git in _folders(text, file, listed - thanked):
        found.setdefault(git.url, git)
    return list(found.values())[:MAX_LINKS]


def _first(match: re.Match[str], text: str, git: GitSource, cloned: Collection[str | None]) -> GitSource:
    """Return what a page links to, at its commit, else at the one ref at which it is ``cloned``, else as linked."""
    if git.ref:
        return git
    branch = match[2] or _on_line(_NAMED_BRANCH, text, match.end())
    branch = branch if branch not in _DEFAULT else None
    return replace(git, ref=next(iter(cloned)) if len(cloned) == 1 else branch or match[3])


def _of_release(git: GitSource, said: Collection[tuple[str, str | None]]) -> GitSource:
    """Return a repository with the release that a page names for it, without the tag of one where it names several."""
    tags = {tag for _, tag in said if tag}
    if len({release for release, _ in said}) == 1:
        return replace(git, release=next(iter(said))[0], ref=git.ref or next(iter(tags), None))
    return replace(git, ref=None) if git.ref in tags else git


def _folders(text: str, file: File, listed: Collection[int]) -> Iterator[GitSource]:
    """Yield the repositories of which a list of what is needed names a folder: ``…/talk/tree/main/talk_msgs``."""
    for match in _FOLDER.finditer(text) if listed else ():
        line = text.count("\n", 0, match.start()) + 1
        if line in listed:
            ref = None if match[3] in _DEFAULT else match[3]
            name, url = match[2].removesuffix(".git"), match[1].removesuffix(".git")
            git = GitSource(
                name=name, url=url, ref=ref, strength="prose", file=file.path, line=line, kind="link", holds=True
            )
            yield _judged(git, _before(text, match.start()), text, match.end())


def _judged(git: GitSource, before: str, text: str, end: int) -> GitSource:
    """Return a repository with what the page says of it around the link: private, doubted, or forked."""
    if _PRIVATE.search(before) or _CALLED_PRIVATE.match(text, end):
        git = replace(git, private=True)
    behind = _behind(text, end)
    if doubted := doubt(behind):
        return replace(git, doubt=doubted)
    line = before.rpartition("\n")[2]
    named = fork_of(line)
    if not named and not forked(line, behind, git.name):
        return git
    return replace(git, forked=True, fork_of=git.fork_of or named, told=git.told or used(line))


def _pinned(text: str, end: int) -> str | None:
    """Return the commit that a page names for a link: right behind it, or later on its line, before the next one."""
    if near := _PINNED.match(text, end):
        return near[1]
    return _on_line(_NAMED_COMMIT, text, end)


def _on_line(named: re.Pattern[str], text: str, end: int) -> str | None:
    """Return what a pattern finds behind a link, later on its line or in its item, before the next link."""
    found = named.search(text, end, _end(text, end))
    return (found[1] or found[2]).rstrip(".-/") if found else None


def _behind(text: str, end: int) -> str:
    """Return what stands behind a link, later on its line or in its item, before the next link."""
    return text[end : _end(text, end)]


def _end(text: str, end: int) -> int:
    """Return where the line of a link, or its item, or what stands before the next link, ends."""
    rest = _ITEM.match(text, end)
    last = rest.end() if rest else end
    other = _LINK.search(text, end, last)
    return other.start() if other else last


def _listed(text: str) -> frozenset[int]:
    """Return the numbers of the lines that list what is needed, of a page with such a list and a link."""
    if not LISTS.search(text) or not (_LINK.search(text) or _FOLDER.search(text)):
        return frozenset()
    return frozenset(line.number for line in needed_items(text))


def _below(text: str, words: re.Pattern[str], *, nearest: bool = False) -> frozenset[int]:
    """Return the numbers of the lines below titles with some words, of a page with a link, without sections aside.

    ``nearest``: it is the title right above that has them.
    """
    if not words.search(text) or not _LINK.search(text):
        return frozenset()
    found = (line for line in lines_of(text) if not (line.fenced or line.elsewhere))
    first = -1 if nearest else 0
    return frozenset(line.number for line in found if any(map(words.search, [*line.titles.values()][first:])))


def _thanked(text: str) -> frozenset[int]:
    """Return the numbers of the lines in which a page thanks others, whose work its own came from or resembles."""
    if not _THANKS.search(text):
        return frozenset()
    found = (line for line in lines_of(text) if not line.fenced)
    return frozenset(line.number for line in found if any(map(_THANKED.search, line.titles.values())))


def _holds(text: str, start: int) -> bool:
    """Tell whether the sentence before a link says that the dependencies are there."""
    return bool(_HOLDS.search(_before(text, start)))


def _before(text: str, start: int) -> str:
    """Return what a paragraph says before a link, from the link before it on."""
    return text[max(0, start - BEFORE) : start].rpartition("\n\n")[2].rpartition("://")[2]
