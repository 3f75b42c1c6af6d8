"""A pull request's image that is not published, kept as an archive so that it can be tried before it is merged."""

from __future__ import annotations

import shutil
from collections.abc import Mapping, Sequence

from roslab.config.model import PullImage
from roslab.engine import archive, disk
from roslab.engine import docker as engine
from roslab.errors import BuildError
from roslab.github import event, tags, workflow
from roslab.github.event import Event, Publication
from roslab.github.run import Folder, Run, artifact_name, slug
from roslab.github.run import candidate as candidate_name
from roslab.render.outcome import ArchiveReport
from roslab.render.sizes import human

MOST = 10**9
"""Most bytes of an archive: it is uploaded for every commit of every pull request."""
SMALLEST = 4
"""Highest ratio of an image's size to its archive's, measured for a minimal base; ROS and Python have less."""
MARGIN = 10**9
"""Bytes of the disk that stay free."""


def wanted(what: Event, publication: Publication, pr: PullImage | None) -> bool:
    """Return whether an archive is kept: of a pull request that is not published, unless roslab.yaml says ``none``.

    A private repository pays for the room of its artifacts, so there roslab.yaml must ask for it:
    https://docs.github.com/en/billing/concepts/product-billing/github-actions
    """
    if what.name != "pull_request" or what.pull is None or publication.push or pr == "none":
        return False
    return pr is not None or what.public


def keep(
    folder: Folder, run: Run, platform: str, platforms: Sequence[str], environment: Mapping[str, str]
) -> tuple[ArchiveReport | None, str]:
    """Write the proved image of one of this job's platforms to a file; return what it is, or why there is none.

    The archive has the image under the name that a person will use.
    """
    if not run.archive:
        return None, ""
    name = tags.dressed(f"{run.plan.name}:pr-{event.read(environment).pull}", run.plan.tags)
    candidate = candidate_name(folder, run, platform)
    held = archive.size(candidate)
    free = shutil.disk_usage(folder.path).free
    # The engine may write the whole image to its own disk before it gives the first byte
    room = min(free, available if (available := disk.free()) is not None else free) - MARGIN
    if held > SMALLEST * MOST:
        return None, f"{human(held)} are too many for an archive, which may have {human(MOST)}"
    if room < held + min(held, MOST):
        return None, f"the runner's disk has no room for an archive of {human(held)}"
    folder.archives.mkdir(exist_ok=True)
    file = folder.archives / f"{name.replace(':', '-')}-{slug(platform)}.tar.gz"
    try:
        engine.name_image(candidate, name)
        size = archive.save(name, file, most=MOST)
    except BuildError as error:
        return None, error.problems[0].message
    finally:
        engine.remove_image(name)
    if size is None:
        return None, f"an archive of it would have more than {human(MOST)}"
    return ArchiveReport(artifact=_artifact(run, platforms, environment), file=file.name, name=name, size=size), ""


def tell(folder: Folder, run: Run, platforms: Sequence[str], environment: Mapping[str, str]) -> None:
    """Output the folder of this job's archives, ``""`` if there are none, and the name of their artifact."""
    found = folder.archives.is_dir() and any(folder.archives.iterdir())
    workflow.outputs(
        {
            "archives": str(folder.archives) if found else "",
            "archives-artifact": _artifact(run, platforms, environment),
        },
        environment,
    )


def _artifact(run: Run, platforms: Sequence[str], environment: Mapping[str, str]) -> str:
    part = slug(platforms[0]) if len(platforms) == 1 else "all"
    # An artifact belongs to an attempt: a second attempt cannot replace the first one's
    return f"{artifact_name('try', run)}-{part}-{environment.get('GITHUB_RUN_ATTEMPT') or 1}"
