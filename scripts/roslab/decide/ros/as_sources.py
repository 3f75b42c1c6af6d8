"""The repository that is itself the ``src`` of its author's workspace."""

from __future__ import annotations

from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.ros.author_folders import of_image

ROOT = "package.xml"


def signs_of_sources(evidence: Evidence, written: str) -> tuple[Mention, ...]:
    """Return what tells so, each once; ``written`` is the folder that the build writes: ``devel``, ``install``.

    A repository that is one package lies in such a folder, whatever is beside it.
    """
    if any(manifest.file == ROOT for manifest in evidence.manifests):
        return ()
    laid = (m for m in evidence.mentions if m.topic == "as_sources")
    sourced = (m for m in evidence.mentions if m.topic == "own_setup" and m.value == f"../{written}")
    return (*laid, *sourced)


def mounted_in(evidence: Evidence) -> str:
    """Return the folder of the author's container as whose ``src`` the repository is mounted, ``""`` for none.

    None of the image's own: no link stands for that one.
    """
    alone = not any(manifest.file == ROOT for manifest in evidence.manifests)
    said = (m.value for m in evidence.mentions if alone and m.topic == "as_sources" and m.value)
    return next((folder for folder in said if not of_image(folder)), "")


def as_mounted(command: tuple[str, ...], evidence: Evidence) -> tuple[str, ...]:
    """Return a command with the paths below that ``src`` which its page gives in full.

    The program may hand them to another one that starts in a folder of its own, as roslaunch's nodes do.
    """
    if not (above := mounted_in(evidence)):
        return command
    given = {path for m in evidence.mentions if m.topic == "as_sources" for path in m.files}
    return tuple(f"{above}/src/{word}" if at > 1 and word in given else word for at, word in enumerate(command))
