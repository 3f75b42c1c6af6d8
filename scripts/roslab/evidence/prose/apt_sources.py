"""Package sources of apt that pages, CI and Dockerfiles add by a line ``deb …``, each with the key fetched for it."""

from __future__ import annotations

import re
from collections.abc import Iterator

from roslab.evidence.apt_source import AptSource, host_of
from roslab.evidence.prose import author_dockerfile, ci
from roslab.evidence.prose.pages import pages, text_of
from roslab.knowledge.apt_sources import keys_of_sources
from roslab.repository.checkout import Repository
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

_SOURCE = pattern(
    r"(?<![\w.-])deb[ \t]+(?:\[([^\]\n]{1,300})\][ \t]+)?(https?://(?:\$\([^()\n]{1,100}\)|[^\s\"'|>()]){3,200})[ \t]+"
    r"(\$\([^)\n]{1,100}\)|`[^`\n]{1,60}`|\$\{?\w+\}?|[\w./-]+)((?:[ \t]+[a-z][\w./-]*){0,6})"
)
_CODENAME = pattern(
    r"\$\(\s*lsb_release\s+(?:-cs|-sc|-c\s+-s|-s\s+-c|--codename --short|--short --codename)\s*\)|"
    r"\$\{?(?:\w*CODENAME|codename)\b\}?"
)
"""What asks the system for the name of its release, inside an address."""
_ADDS = ("sources.list", "apt-repository")
_AROUND = 300
"""Most characters between the line and the command that adds it."""
_FETCH = pattern(r"\b(?:curl|wget)[ \t][^\n|]{0,200}?(https?://[^\s\"'|>;)]{3,300})[^\n]*")
_AS_KEY = pattern(r"apt-key[ \t]+add|--dearmor|keyrings?[/.]|trusted\.gpg")
_KEY_FILE = pattern(r"\.(?:asc|gpg|key|pub|pgp)$", re.IGNORECASE)
_PLACE = pattern(r"/(?:usr/share|etc/apt)/(?:keyrings|trusted\.gpg\.d)/[\w.+-]+")
_SERVER = pattern(
    r"--keyserver[ \t=]+[\"']?(\S+?)[\"']?[ \t][^\n]*?--recv(?:-keys?)?[ \t]+(?:0x)?([0-9A-Fa-f]{8,40})(?!\w)"
)
_PUBLIC = "keyserver.ubuntu.com"
_FINGERPRINT = 40
NEAR = 20
"""Most lines between a source and a key that neither of them names."""


@dataclass(frozen=True, slots=True)
class _Key:
    url: str | None
    refused: str | None
    place: str | None
    line: int
    host: str | None = None


def read(repository: Repository) -> tuple[AptSource, ...]:
    """Return the sources that installing pages and CI add, and those of Dockerfiles whose key is known."""
    found = [each for file in pages(repository) for each in said(text_of(repository, file), file.path)]
    recipes = (each for file in author_dockerfile.files(repository) for each in said(repository.read(file), file.path))
    found += [each for path in ci.files(repository) for each in said(repository.read(path), path)]
    found += [each for each in recipes if host_of(each.url) in keys_of_sources()]
    return tuple({(each.url, each.suite, each.components): each for each in reversed(found)}.values())[::-1]


def said(text: str, file: str) -> Iterator[AptSource]:
    """Yield the sources that one page adds."""
    if "deb" not in text or not any(word in text for word in _ADDS):
        return
    joined = text.replace("\\\n", "  ")  # places stay
    keys = [*_fetched(joined, text), *_asked(joined, text)]
    for match in _SOURCE.finditer(joined):
        before = joined[joined.rfind("\n", 0, match.start()) + 1 : match.start()]
        around = joined[max(0, match.start() - _AROUND) : match.end() + _AROUND]
        if before.lstrip().startswith("#") or not any(word in around for word in _ADDS):
            continue
        options, url, suite, components = match.groups()
        line = _line(text, match.start())
        key = _of(options or "", host_of(url), keys, line)
        yield AptSource(
            url=_CODENAME.sub("{codename}", url),
            suite="{codename}" if suite[0] in "$`" else suite,
            components=tuple(components.split()),
            key=key.url,
            refused=key.refused,
            file=file,
            line=line,
        )


def _line(text: str, position: int) -> int:
    return text.count("\n", 0, position) + 1


def _fetched(joined: str, text: str) -> Iterator[_Key]:
    """Yield the keys that are downloaded."""
    for match in _FETCH.finditer(joined):
        url = match[1].rstrip("\\")
        if not (_AS_KEY.search(match[0]) or _KEY_FILE.search(url)):
            continue
        place = _PLACE.search(match[0])
        refused = None if url.startswith("https://") else "its key is fetched without https"
        yield _Key(None if refused else url, refused, place and place[0], _line(text, match.start()), host_of(url))


def _asked(joined: str, text: str) -> Iterator[_Key]:
    """Yield the keys that a key server is asked for; the public one answers by https, too."""
    for match in _SERVER.finditer(joined):
        refused = None if _PUBLIC in match[1] else f"its key comes from {match[1]}"
        if len(match[2]) < _FINGERPRINT:
            refused = f"{match[2]} is no whole fingerprint of its key"
        url = f"https://{_PUBLIC}/pks/lookup?op=get&search=0x{match[2].upper()}"
        yield _Key(None if refused else url, refused, None, _line(text, match.start()))


def _of(options: str, host: str | None, keys: list[_Key], line: int) -> _Key:
    """Return the key of a source: the one whose file it names, else the nearest, of its own host if there is one.

    A page that adds several sources fetches a key for each: another's key may be nearer, and may be trusted where its
    own is not.
    """
    if "trusted=" in options:
        return _Key(None, "it is trusted without a key", None, line)
    place = _PLACE.search(options)
    named = [key for key in keys if place and key.place == place[0]]
    near = [key for key in keys if abs(key.line - line) <= NEAR and not (place and key.place)]
    own = [key for key in near if host and key.host and _domain(key.host) == _domain(host)]
    best = min(named or own or near, key=lambda key: (key.url is None, abs(key.line - line)), default=None)
    return best or _Key(None, "nothing beside it fetches its key", None, line)


def _domain(host: str) -> str:
    return ".".join(host.split(".")[-2:])
