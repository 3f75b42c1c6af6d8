"""What an author's old Dockerfile has pip install without a version: it was of its day; today's may not run there."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.newest_pip import files_of
from roslab.evidence.facts import AuthorDockerfile, Evidence
from roslab.evidence.prose.python_steps import image_at
from roslab.knowledge.official_images import with_usual_shell
from roslab.knowledge.os_releases import of_debian, release_of
from roslab.values.requirement import Requirement


def of_the_day(authored: AuthorDockerfile, evidence: Evidence, day: str) -> dict[str, str]:
    """Return the external images in which pip is asked for something without a version, each with why it is of a day.

    The index of the day is given to the shell that runs the steps. A Dockerfile that names its own shell, or in which
    that shell would start what runs in the container, is left as it is; so is an image that may have another shell, or
    that may not be of Debian or Ubuntu.
    """
    if authored.own_shell:
        return {}
    found: dict[str, str] = {}
    for asked in _free(authored, evidence):
        name = image_at(asked.line, authored.stages)
        if name in found or not runs_bash(name):
            continue
        what = asked.name or asked.written
        found[name] = f"line {asked.line} has pip install {what} without a version: it takes that of {day}"
    return found


def runs_bash(image: str) -> bool:
    """Tell whether an image is known to be of Debian or Ubuntu, with the shell that Docker takes for its steps."""
    return "alpine" not in image and with_usual_shell(image) and bool(release_of(image) or of_debian(image))


def _free(authored: AuthorDockerfile, evidence: Evidence) -> Iterator[Requirement]:
    """Yield what pip is asked for in the Dockerfile's own lines that may be of any version, or needs what may be."""
    listed = [each for file in files_of(authored, evidence) for each in file.requirements if each.package]
    free = not listed or any(map(_unpinned, listed))
    for asked in authored.requirements:
        if asked.role == "project" or _unpinned(asked) or (asked.role == "file" and free):
            yield asked


def _unpinned(asked: Requirement) -> bool:
    return asked.package and asked.release is None and not asked.url
