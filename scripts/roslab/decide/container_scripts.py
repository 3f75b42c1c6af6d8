"""What the containers of an author's image share with their machine by the scripts beside its Dockerfile."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.config.model import Config, Volume
from roslab.decide.decision import Warning_
from roslab.decide.entry_scripts import told
from roslab.decide.reasons import warn
from roslab.decide.windows import opens_windows
from roslab.evidence.facts import AuthorDockerfile, Evidence, Mention
from roslab.values.image import without_tag


def shown(text: str, config: Config, evidence: Evidence, authored: AuthorDockerfile | None) -> bool:
    """Tell whether a command opens windows: roslab.yaml says so, or it does, or a script shares the screen with it."""
    if config.gui is not None:
        return config.gui
    return opens_windows(evidence, text) or any(m.topic == "screen" for m in _beside(authored, evidence))


def of_image(
    authored: AuthorDockerfile | None,
    command: tuple[str, ...] | str,
    evidence: Evidence,
    volumes: Collection[Volume],
) -> tuple[Warning_, ...]:
    """Return what there is to say about containers of an author's image: of its entry point, and what they lack."""
    return (*told(authored, command), *_mounts(authored, evidence, volumes)) if authored else ()


def known_folders(
    authored: AuthorDockerfile | None, evidence: Evidence, volumes: Collection[Volume]
) -> tuple[str, ...]:
    """Return folders of a container that have, or may have, what the tree has not: all, where nobody knows them."""
    mounted = tuple(volume.container_path for volume in volumes)
    if authored is None:
        return mounted
    given = (m.value for m in _beside(authored, evidence) if m.topic == "mounted")
    return (*mounted, *given, authored.source if (authored.source or "").startswith("/") else "/")


def _mounts(authored: AuthorDockerfile, evidence: Evidence, volumes: Collection[Volume]) -> Iterator[Warning_]:
    """Yield a warning for each folder that a script is given and mounts, where nothing else mounts one there."""
    there = {volume.container_path.rstrip("/") for volume in volumes}
    for said in _beside(authored, evidence):
        if said.topic == "mounted" and said.value not in there:
            there.add(said.value)
            message = f"{said.file} is given a folder and mounts it at {said.value}, which is not in the image"
            hint = f"give it with --volume FOLDER:{said.value}, or under `volume` in roslab.yaml"
            yield warn(f"{message}: {hint}", said)


def _beside(authored: AuthorDockerfile | None, evidence: Evidence) -> Iterator[Mention]:
    """Yield what scripts tell that lie beside a Dockerfile, in the folder above or at the root.

    Not of containers of another image, where pages or scripts tell by which names the images of the tree are built.
    """
    if authored is None:
        return
    folder = authored.file.rpartition("/")[0]
    near = {folder, folder.rpartition("/")[0], ""}
    built = {without_tag(m.value) for m in evidence.mentions if m.topic == "image_built" and "$" not in m.value}
    for said in evidence.mentions:
        beside = said.topic in {"screen", "mounted"} and said.file.rpartition("/")[0] in near
        if beside and (not (said.inside and built) or without_tag(said.inside) in built):
            yield said
