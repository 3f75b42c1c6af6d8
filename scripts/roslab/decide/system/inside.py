"""Libraries that lie in the tree and that are compiled there before all else.

A page does so, or a script that it runs, or the project links the file that is then there.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from roslab.config.model import Config, Kind
from roslab.decide.decision import Choice
from roslab.decide.reasons import because
from roslab.decide.ros.linked_in_place import linked_files
from roslab.decide.ros.workspace import packages_of
from roslab.evidence import places
from roslab.evidence.facts import Evidence, Mention
from roslab.values.origin import Place

WEIGHT = 300
"""Sources do not compete, so it only orders the report."""


def compiled_inside(evidence: Evidence, config: Config, kind: Kind) -> Choice[tuple[tuple[str, str], ...]]:
    """Return the folders to compile with CMake where they lie, each with its options, in the order of the page.

    Only copied libraries, submodules and what a page clones into the tree: examples and the project itself are no need
    of it. Of those that are packages, ROS's tools build each in a workspace, where what a page installs into the system
    is not found by its name alone; where CMake alone builds the project, they are libraries as the others.
    """
    if config.compatible or config.build or kind == "python":
        return Choice(answer=())
    absent = [git.name for git in evidence.sources if git.kind in {"submodule", "inside"}]
    folders = {project.file.rpartition("/")[0] for project in evidence.cmake if places.vendored(project.file)}
    folders = {folder for folder in {*folders, *absent} if folder}
    if kind in {"ros1", "ros2"}:
        folders -= {manifest.file.rpartition("/")[0] for manifest in evidence.manifests} - _put_into_system(evidence)
    run = {file for m in evidence.mentions if m.topic == "command" for file in m.files}
    found: dict[str, Mention] = {}
    for mention in evidence.mentions:
        if mention.topic == "compiled" and (mention.source == "readme" or mention.file in run):
            folder = meant(mention.value, folders)
            if folder and not places.vendored(mention.file):
                found.setdefault(folder, mention)
    why = "it is compiled where it lies"
    reasons = [because("source", folder, why, mention, weight=WEIGHT) for folder, mention in found.items()]
    answer = {folder: mention.text for folder, mention in found.items()}
    scripts = [mention for mention in evidence.mentions if mention.topic == "compiled"]
    for folder, path, place in _linked(evidence, folders - answer.keys()):
        if folder not in answer:
            said = next((m.text for m in scripts if meant(m.value, {folder}) and not places.vendored(m.file)), "")
            answer[folder] = said
            reasons.append(
                because("source", folder, f"{path} is linked, which is compiled there", place, weight=WEIGHT)
            )
    for folder, path, place in _of_packages(evidence) if kind in {"ros1", "ros2"} else ():
        if folder not in answer:
            own = (m for m in scripts if m.value == "." and m.file in run and m.file.rpartition("/")[0] == folder)
            answer[folder] = next((mention.text for mention in own), "")
            why = f"a package links {path}, which is compiled there"
            reasons.append(because("source", folder or ".", why, place, weight=WEIGHT))
    return Choice(answer=tuple(answer.items()), reasons=tuple(reasons))


def _put_into_system(evidence: Evidence) -> set[str]:
    """Return the folders of packages that CMake alone builds, without ROS, and that a page of the tree installs."""
    plain = {m.file.rpartition("/")[0] for m in evidence.manifests if [name for name, _ in m.build_types] == ["cmake"]}
    return _installed(plain, (mention for mention in evidence.mentions if mention.source == "readme"))


def installed_inside(evidence: Evidence, inside: Iterable[tuple[str, str]]) -> tuple[str, ...]:
    """Return those of the folders that a page or a script of the tree installs after it has compiled them."""
    return tuple(sorted(_installed({folder for folder, _ in inside}, evidence.mentions)))


def _installed(folders: set[str], said: Iterable[Mention]) -> set[str]:
    told = (m for m in said if m.topic == "installed_here" and not places.vendored(m.file))
    return {folder for m in told if (folder := meant(m.value, folders - {""}))}


def _linked(evidence: Evidence, folders: Collection[str]) -> Iterator[tuple[str, str, Place]]:
    """Yield each folder whose library the project links by its file, which no other CMake adds to its own build."""
    alone = {project.file.rpartition("/")[0] for project in evidence.cmake if project.top_level} & {*folders}
    for project in evidence.cmake:
        for path, line in project.linked if not places.vendored(project.file) else ():
            holding = [folder for folder in alone if path.startswith(f"{folder}/")]
            if holding:
                yield max(holding, key=len), path, Place(file=project.file, line=line)


def _of_packages(evidence: Evidence) -> Iterator[tuple[str, str, Place]]:
    """Yield the folder of plain CMake, ``""`` for the root, around a package of ROS that links its library by its file.

    The library has the name of its project; a tool of ROS builds the package, and nothing of what is around it.
    """
    packages = {manifest.file.rpartition("/")[0] for manifest in packages_of(evidence).built}
    plain = [p for p in evidence.cmake if p.top_level and p.name and p.file.rpartition("/")[0] not in packages]
    for path, place in linked_files(evidence):
        name = path.rpartition("/")[2].rpartition(".")[0].removeprefix("lib")
        around = [p.file.rpartition("/")[0] for p in plain if p.name == name and not places.vendored(p.file)]
        around = [folder for folder in around if not folder or place.file.startswith(f"{folder}/")]
        if around:
            yield max(around, key=len), path, place


def meant(path: str, folders: Collection[str]) -> str | None:
    """Return the folder that a path ends with, or the only one that ends with it: a page may begin anywhere."""
    whole = [folder for folder in folders if f"/{path}".endswith(f"/{folder.removeprefix('../')}")]
    part = [folder for folder in folders if f"/{folder}".endswith(f"/{path}")]
    return max(whole, key=len) if whole else part[0] if len(part) == 1 else None
