"""Packages from before package.xml: manifest.xml of rosbuild, and stack.xml, which gathers them.

https://wiki.ros.org/Manifest https://wiki.ros.org/Stack%20Manifest
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import PackageManifest
from roslab.repository.checkout import File, Repository
from roslab.values.pattern import pattern

if TYPE_CHECKING:
    from lxml import etree

MAX_SIZE = 256 * 1024
BUILD_TYPE = "rosbuild"
_NAME = pattern(r"[A-Za-z][\w-]*")
_NAMED_BY = {"depend": "package", "rosdep": "name"}


def read(repository: Repository) -> tuple[PackageManifest, ...]:
    """Return the packages of rosbuild, sorted by path; none where a folder has a package.xml, which then holds.

    A package is named like its folder: the file does not name it. Who unpacked the root may have given it another name:
    there ``<description brief="NAME">`` counts, which ``roscreate-pkg`` wrote.
    """
    newer = {file.folder for file in repository.named("package.xml")}
    files = [
        file
        for file in repository.named("manifest.xml", "stack.xml")
        if file.size <= MAX_SIZE and file.folder not in newer
    ]
    found = (_manifest(repository, file) for file in sorted(files, key=lambda file: file.path))
    return tuple(manifest for manifest in found if manifest)


def _manifest(repository: Repository, file: File) -> PackageManifest | None:
    from lxml import etree  # noqa: PLC0415 - slow to import, and few repositories are that old

    parser = etree.XMLParser(
        recover=True, resolve_entities=False, no_network=True, load_dtd=False, remove_comments=True, remove_pis=True
    )
    try:
        root = etree.fromstring(repository.read(file).encode(), parser)
    except (etree.XMLSyntaxError, ValueError):
        return None
    stack = file.name == "stack.xml"
    if root is None or root.tag != ("stack" if stack else "package"):
        return None  # the manifest.xml of another program: Android, a browser's extension
    return PackageManifest(
        file=file.path,
        line=root.sourceline or 1,
        name=file.folder.rpartition("/")[2] or _brief(root) or repository.folder_name,
        format=0,
        build_types=((BUILD_TYPE, None),),
        dependencies=() if stack else tuple(_dependencies(root, file.path)),  # a stack's are what its packages name
        metapackage=stack,
    )


def _brief(root: etree._Element) -> str | None:
    described = root.find("description")
    brief = (described.get("brief") or "").strip() if described is not None else ""
    return brief if _NAME.fullmatch(brief) else None


def _dependencies(root: etree._Element, path: str) -> Iterator[Dependency]:
    for element in root:
        tag = str(element.tag)
        if tag not in _NAMED_BY or not (name := (element.get(_NAMED_BY[tag]) or "").strip()):
            continue
        for role in ("build", "exec"):
            yield Dependency(
                namespace="ros" if tag == "depend" else "rosdep",
                name=name,
                strength="declared",
                file=path,
                line=element.sourceline or 1,
                role=role,
            )
