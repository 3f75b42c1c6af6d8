"""The Dockerfiles that a page at the root, else one about containers, has Docker Compose build: ``docker compose up``.

https://docs.docker.com/reference/compose-file/build/, https://docs.docker.com/reference/compose-file/interpolation/
"""

from __future__ import annotations

import posixpath
import re
import shlex
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from roslab.evidence import places
from roslab.evidence.lex.yaml import load
from roslab.evidence.prose.pages import pages, text_of
from roslab.evidence.service import Service
from roslab.repository.checkout import File, Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
MAX_DEPTH = 2
MAX_PAGES = 8
"""Most pages about containers that are opened, those nearest to the root first."""
_ABOUT = pattern(r"(?<![a-z])(?:docker|container|compose)", re.IGNORECASE)
"""The name of such a page, or of its folder: ``docs/docker.md``, ``docker/README.md``."""
_CALL = pattern(r"\bdocker[- ]compose((?:[ \t]+-\S+(?:[ \t]+[^-\s]\S*)??)*)[ \t]+(up|build|run)\b([^\n;&|`#]{0,300})")
_FILE = pattern(r"(?:-f|--file)(?:[ \t]+|=)(\S+)")
_DEFAULTS = ("compose.yaml", "compose.yml", "docker-compose.yaml", "docker-compose.yml")
_PORTS = 1 << 16
_STAGE = pattern(r"^[ \t]*FROM[ \t]+(?:--\S+[ \t]+)*\S+(?:[ \t]+AS[ \t]+(\S+))?", re.MULTILINE | re.IGNORECASE)
_VALUE = pattern(r"\$(?:\{(\w+)(?::?-([^}]*))?\}|(\w+))")
_OF_HOST = pattern(
    r"(?:DISPLAY|XAUTHORITY|QT_X11_NO_MITSHM|ROS_(?:MASTER_URI|HOSTNAME|IP)|NVIDIA_\w+)$"
    r"|.*(?:TOKEN|SECRET|PASSWORD|PASSWD|CREDENTIAL|(?:API|ACCESS|PRIVATE)_?KEY)",
    re.IGNORECASE,
)
"""Variables that hold for the host on which its author starts the services, and secrets."""


def services(repository: Repository) -> Mapping[str, Service]:
    """Return the service of each such Dockerfile, by its path; where each call names services, of these alone."""
    return repository.once(_services)


def _services(repository: Repository) -> dict[str, Service]:
    found: dict[str, list[Service]] = {}
    named: dict[str, list[Service]] = {}
    every = False
    for page in _read(repository):
        for call in _CALL.finditer(text_of(repository, page)):
            file = _composed(repository, call[1], page)
            services = list(_built(repository, file, page)) if file else []
            chosen = [(dockerfile, service) for name, dockerfile, service in services if name in call[3].split()]
            every = every or (call[2] == "up" and bool(services) and not chosen)
            for dockerfile, service in chosen:
                named.setdefault(dockerfile, []).append(service)
            for _, dockerfile, service in services:
                found.setdefault(dockerfile, []).append(service)
        if found:
            break
    meant = found if every else named or found
    return {path: _only(made, repository.read(path, limit=MAX_SIZE)) for path, made in meant.items()}


def _read(repository: Repository) -> Iterator[File]:
    """Yield the pages at the root, then those about containers, if there is a file that Compose takes."""
    yield from (page for page in pages(repository) if not page.folder)
    if repository.named(*_DEFAULTS):
        texts = (file for file in repository.suffixed(".md", ".rst", ".markdown") if file.folder)
        about = (file for file in texts if any(map(_ABOUT.search, (file.name, posixpath.basename(file.folder)))))
        kept = (f for f in about if f.size <= MAX_SIZE and not places.vendored(f.path) and not places.aside(f.path))
        yield from (file for file in nearest(kept)[:MAX_PAGES] if file.path.count("/") <= MAX_DEPTH)


def _only(made: list[Service], text: str) -> Service:
    """Return the service that is built from the last stage of a Dockerfile, which is what ``docker build`` makes.

    Of several such none tells how its container is started.
    """
    last = next(reversed(_STAGE.findall(text)), "").lower()
    of_last = [each for each in made if each.target.lower() in {"", last}]
    first = (of_last or made)[0]
    alone = bool(of_last) and all((each.file, each.line) == (first.file, first.line) for each in of_last)
    return first if alone else Service(file=first.file, line=first.line, said=first.said)


def _composed(repository: Repository, options: str, page: File) -> File | None:
    """Return the first file that a call names, else that which Compose takes, else the only one of the tree.

    It takes that of the folder in which it is called: the page's, if one is there, or the root.
    """
    if named := _FILE.search(options):
        path = posixpath.normpath(named[1])
        return next((file for file in repository.named(path.rpartition("/")[2]) if file.path.endswith(path)), None)
    files = [f for f in repository.named(*_DEFAULTS) if f.path.count("/") <= MAX_DEPTH and not places.aside(f.path)]
    top = [file for file in files if file.folder == page.folder] or [file for file in files if not file.folder]
    return next(iter(top or files), None) if top or len(files) == 1 else None


def _built(repository: Repository, file: File, page: File) -> Iterator[tuple[str, str, Service]]:
    """Yield each Dockerfile that a file of Compose builds, with its service behind its name."""
    if file.size > MAX_SIZE:
        return
    text = repository.read(file)
    document = load(text)
    listed = document.get("services") if isinstance(document, dict) else None
    for name, said in listed.items() if isinstance(listed, dict) else ():
        made = said.get("build") if isinstance(said, dict) else None
        if isinstance(made, str):
            made = {"context": made}
        if not isinstance(made, dict):
            continue
        where = (_filled(str(made.get("context") or ".")) or ".", str(made.get("dockerfile") or "Dockerfile"))
        line = text[: match.start()].count("\n") + 1 if (match := _key(str(name)).search(text)) else 1
        own = not said.get("entrypoint")
        yield (
            str(name),
            posixpath.normpath(posixpath.join(file.folder, *where)),
            Service(
                file=file.path,
                line=line,
                said=page.path,
                command=_argv(said.get("command")) if own else (),
                ports=tuple(_filled(str(port)) or "" for port in _items(said.get("ports")) if _plain(port)),
                environment=tuple(_environment(said.get("environment"), listed or ())),
                volumes=tuple(_volumes(said.get("volumes"), file.folder)),
                target=str(made.get("target") or ""),
            ),
        )


def _key(name: str) -> re.Pattern[str]:
    return re.compile(rf"^[ \t]+[\"']?{re.escape(name)}[\"']?:", re.MULTILINE)


def _items(said: Any) -> list[Any]:
    return said if isinstance(said, list) else []


def _plain(port: Any) -> bool:
    if isinstance(port, int):
        return 0 < port < _PORTS  # YAML reads 2222:22 as a number of the base 60
    return isinstance(port, str) and bool(re.fullmatch(r"(?:[\w.]+:)*\d+(?:/\w+)?", _filled(str(port)) or ""))


def _argv(said: Any) -> tuple[str, ...]:
    """Return a command as words, ``()`` where it is not known."""
    try:
        words = shlex.split(said) if isinstance(said, str) else [str(word) for word in _items(said)]
    except ValueError:
        return ()
    filled = [_filled(word) for word in words]
    return () if None in filled else tuple(word for word in filled if word is not None)


def _environment(said: Any, services: Iterable[str]) -> Iterator[tuple[str, str]]:
    """Yield each variable, but none of the host's screen, of another service, or with a secret."""
    others = tuple(f"{name}:" for name in services)
    pairs = said.items() if isinstance(said, dict) else (str(each).partition("=")[::2] for each in _items(said))
    for name, value in pairs:
        filled = _filled("" if value is None else str(value).lower() if isinstance(value, bool) else str(value))
        if filled and not _OF_HOST.match(str(name)) and not any(other in filled for other in others):
            yield str(name), filled


def _volumes(said: Any, folder: str) -> Iterator[tuple[str, str, str]]:
    """Yield the folders below that of the file that are mounted, ``./data:/data:ro``; not the whole of it.

    https://docs.docker.com/reference/compose-file/services/#volumes, read 2026-11-27.
    """
    for each in _items(said):
        if isinstance(each, dict) and each.get("type") == "bind":
            words = [
                str(each.get("source") or ""),
                str(each.get("target") or ""),
                "ro" if each.get("read_only") else "",
            ]
        else:
            words = [*(_filled(str(each)) or "").split(":"), "", ""] if isinstance(each, str) else ["", ""]
        host, there, options = (_filled(word) or "" for word in (*words, "")[:3])
        path = posixpath.normpath(posixpath.join(folder, host))
        if host.startswith("./") and path != (folder or ".") and ".." not in path and there.startswith("/"):
            yield path, posixpath.normpath(there), "ro" if "ro" in options.split(",") else ""


def _filled(text: str) -> str | None:
    """Return a value with the defaults of the variables in it, ``None`` where one has none."""
    if any(match[2] is None for match in _VALUE.finditer(text.replace("$$", ""))):
        return None
    return "$".join(_VALUE.sub(lambda match: match[2], part) for part in text.split("$$"))
