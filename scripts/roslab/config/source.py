"""Libraries that are built from source, and the other things that real files contain instead of a URL."""

from __future__ import annotations

from typing import cast

from roslab.config import packages
from roslab.config.cited import shown
from roslab.config.edit import OTHER_THAN_TEXT, quoted
from roslab.config.model import Source, SourceBuild
from roslab.config.node import Mapping, Scalar, Sequence
from roslab.config.reading import Reading, Text
from roslab.values.origin import Place
from roslab.values.pattern import pattern
from roslab.values.secret import SSH

OLD_TOOLS = {"catkin_build": "catkin_tools"}
"""Names of build tools in the old formats."""
_FLAG = pattern(r"(?:^|\s)(?:-b|--branch)[ =]+(\S+)|(?:^|\s)--(?:single-branch|depth[ =]\d+)")
_SSH = pattern(r"(?:ssh://)?git@([^/:]+)[/:](.+)")
_IN_FLOW = pattern(r"[A-Za-z][\w./+-]*(?::[\w./+-]+)?")
"""Text that YAML reads as text without quotes within ``{}``, apart from words that are something else."""
_OTHER = {*OTHER_THAN_TEXT, "true", "false"}
_NAME = pattern(r"\{name: ([^,}]{1,200})")
_PUBLIC = ("github.com", "gitlab.com", "bitbucket.org")
"""Hosts whose public repositories have the same path by https."""


def flow(name: str, repo: str, *, ref: str | None, build: str, options: str = "") -> str:
    """Return a source as it is written on one line of roslab.yaml: ``{name: …, repo: …}``."""
    said = {"name": name, "repo": repo, "ref": ref, "build": build, "cmake_options": options}
    return f"{{{', '.join(f'{key}: {_plain(value)}' for key, value in said.items() if value)}}}"


def named(line: str) -> str:
    """Return the name in a line of ``flow``."""
    found = _NAME.match(line)
    return found[1].strip('"') if found else ""


def _plain(value: str) -> str:
    return value if _IN_FLOW.fullmatch(value) and value.lower() not in _OTHER else quoted(value)


def sources(reading: Reading, root: Mapping, key: str) -> tuple[Source, ...]:
    """Read the list of sources; two with the same name are an error, because they would share a folder."""
    node = root.get(key)
    reading.note("source", root.key(key))
    found: dict[str, Source] = {}
    by_ssh = _names_ssh(root)
    for item in node.items if isinstance(node, Sequence) else ():
        if isinstance(item, Mapping):
            source = _source(reading, item, f"source.{len(found)}", by_ssh=by_ssh)
            if source is None:
                continue
            if source.name in found:
                line = found[source.name].place
                hint = f"give each a name of its own: the first is on line {line.line if line else '?'}"
                reading.complain(f"source: two are named `{source.name}`", hint, item)
            found[source.name] = source
    return tuple(found.values())


def _names_ssh(root: Mapping) -> bool:
    """Return whether ``secrets`` names the key for ssh."""
    node = root.get("secrets")
    items = node.items if isinstance(node, Sequence) else (node,)
    return any(isinstance(item, Scalar) and item.text.strip() == SSH for item in items)


def _source(reading: Reading, item: Mapping, path: str, *, by_ssh: bool) -> Source | None:
    name = reading.value(item, "name", f"{path}.name")
    repo = reading.text(item, "repo", f"{path}.repo")
    archive = reading.text(item, "zip", f"{path}.zip")
    if name is None or (repo is None and archive is None):
        return None  # its problems were reported
    reading.note(path, item)
    url, branch = clone(reading, repo, by_ssh=by_ssh) if repo else (None, None)
    ref = reading.value(item, "ref", f"{path}.ref") or reading.value(item, "checkout", f"{path}.ref")
    if ref and branch and ref != branch and repo:
        reading.warn(f"`{branch}` is asked for in `repo` too: `{ref}` is what is built", repo.node)
    if archive and archive.value.startswith("http://"):
        reading.warn("fetched without encryption: write https://", archive.node)
    tool = reading.value(item, "build", f"{path}.build") or "cmake"
    place = reading.where(item.start)
    return Source(
        name=name,
        repo=url,
        zip=archive.value if archive else None,
        ref=ref or branch,
        depends=packages.apt(reading, item, "depends", f"{path}.depends"),
        build=cast(SourceBuild, OLD_TOOLS.get(tool, tool)),
        cmake_options=reading.value(item, "cmake_options", f"{path}.cmake_options") or "",
        cmake_folder=reading.value(item, "cmake_folder", f"{path}.cmake_folder"),
        make_command=reading.value(item, "make_command", f"{path}.make_command"),
        keep_source=reading.truth(item, "keep_source", f"{path}.keep_source") or False,
        place=place if isinstance(place, Place) else None,
    )


def clone(reading: Reading, repo: Text, *, by_ssh: bool = False) -> tuple[str, str | None]:
    """Return the URL and the branch from the arguments of ``git clone``; ``by_ssh``: the build has a key for ssh."""
    branch: str | None = None
    for match in _FLAG.finditer(repo.value):
        branch = match[1] or branch
    url = _FLAG.sub(" ", repo.value).strip()
    if branch:
        reading.warn(f"`-b {branch}` in `repo` is read as `ref: {branch}`", repo.node)
    if url.startswith("git://"):
        url = "https://" + url.removeprefix("git://")
        reading.warn(f"git:// is unsafe and mostly switched off: read as {url}", repo.node)
    elif by_ssh and _SSH.fullmatch(url):
        pass  # as it is
    elif (private := _SSH.fullmatch(url)) and private[1] not in _PUBLIC:
        message = f'source: "{shown(url)}" is no git URL that can be cloned'
        hint = "it needs a private key, which a build does not have: write the https URL, or `secrets: [ssh]`"
        reading.complain(message, hint, repo.node)
    elif private:
        url = f"https://{private[1]}/{private[2]}"
        reading.warn(f"a build has no private key: read as {url}", repo.node)
    elif url.startswith("http://"):
        reading.warn("fetched without encryption: write https://", repo.node)
    return url, branch
