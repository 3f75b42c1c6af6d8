"""What the repository would be built from and no longer answers, and what the image is built from in its place."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from roslab.decide.decision import Decision
from roslab.knowledge.distros import distro
from roslab.knowledge.os_releases import ends, has_ended, moved_to, release_of
from roslab.knowledge.ros_packages import first_source
from roslab.knowledge.tools import PythonTools, why_bounded
from roslab.plan.author_bases import Base
from roslab.plan.package_sources import PackageSources, RosSource
from roslab.plan.python import installs
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class Upstream:
    """Something that no longer answers, or does not long from now."""

    name: str
    why: str
    instead: str
    """What replaces it."""


def upstreams(
    decision: Decision,
    *,
    sources: PackageSources | None,
    rosdistro_tag: str | None,
    installers: Sequence[str],
    bases: Sequence[Base],
) -> tuple[Upstream, ...]:
    """Return what is replaced: each of a decision, or of the bases of the author's Dockerfile, once.

    ``installers`` are the requirement lines of pip and its companions that a step of the image installs.
    """
    found: list[Upstream] = []
    if decision.dockerfile:
        for base in bases:
            if base.image != base.name and base.recipe is None:
                found.append(Upstream(name=f"image {base.name}", why=base.why, instead=base.image))
            found += _of_base(base.image, base.sources, base.rosdistro_tag, base.installers)
    else:
        found += [
            *_cuda(decision),
            *_of_base(decision.base_image, sources, rosdistro_tag, installers, decision.ubuntu),
            *_python(decision),
            *_hosts(decision),
        ]
    return tuple(dict.fromkeys(found))


def brought(tools: PythonTools, decision: Decision, *, both: bool, notebook: bool) -> tuple[str, ...]:
    """Return the installers that a step brings: for packages of the image's Python, or for JupyterLab (``notebook``).

    ``both``: an image of the old formats, which brings those of both Pythons. conda has its own.
    """
    python = decision.python
    if python.manager == "conda":
        return ()
    return tools.installers if python.manager == "venv" or both or notebook or installs(python) else ()


def _cuda(decision: Decision) -> Iterator[Upstream]:
    """Yield the images of the CUDA that was asked for, where another was taken: its last reason says why."""
    reasons = [each for each in decision.reasons if each.question == "cuda" and each.decisive]
    asked = next((each.answer for each in reasons if each.answer != decision.cuda), None)
    taken = next((each for each in reasons if each.answer == decision.cuda), None)
    if asked and taken:
        yield Upstream(name=f"image nvidia/cuda of CUDA {asked}", why=taken.reason, instead=decision.base_image)


def _of_base(
    image: str,
    sources: PackageSources | None,
    tag: str | None,
    installers: Sequence[str],
    ubuntu: str | None = None,
) -> Iterator[Upstream]:
    codename = ubuntu or release_of(image) or ""
    if sources and sources.ros:
        yield from _ros(sources.ros, tag)
    if sources and sources.ended and has_ended(codename):
        moved = moved_to(codename)
        yield Upstream(
            name=f"apt archive of {codename}",
            why=f"{codename} ended on {ends()[codename]}: its packages {'moved' if moved else 'may move at any time'}",
            instead=moved[1] if moved else "the archive of old releases, as soon as it does not answer",
        )
    if image.startswith("nvidia/"):
        yield Upstream(
            name=f"apt source of NVIDIA in {image}",
            why="its key was replaced in April 2022, and images of before do not know the new one",
            instead="left out where the image does not know its key; CUDA is in the image",
        )
    bounded: dict[str, dict[str, None]] = {}
    for line in installers:
        if why := why_bounded(line):
            bounded.setdefault(why, {})[line.partition(";")[0]] = None
    for why, pins in bounded.items():
        names = list(dict.fromkeys(pin.partition("<")[0] for pin in pins))
        listed = " and ".join(filter(None, (", ".join(names[:-1]), names[-1])))
        yield Upstream(name=f"today's {listed}", why=why, instead=", ".join(pins))


def _ros(source: RosSource, tag: str | None) -> Iterator[Upstream]:
    from roslab.knowledge.keys import expires  # noqa: PLC0415 - only a build, or a key of ROS, asks

    release = distro(source.distro)
    if release is None or release.rosdistro_tag is None:
        return
    ended = f"ROS {release.name} ended on {release.eol}"
    yield Upstream(name=f"apt source {first_source(release)}", why=f"{ended}: its packages moved", instead=source.url)
    if source.in_base:
        yield Upstream(
            name=f"key of ROS in the image of {release.name}",
            why="it is as old as the image and may have expired",
            instead=f"{source.key}, valid until {expires(source.key)}, from the Dockerfile",
        )
    if tag:
        yield Upstream(
            name="rosdep's index of today", why=f"{ended}: rosdep skips it", instead=f"ros/rosdistro at {tag}"
        )


def _python(decision: Decision) -> Iterator[Upstream]:
    """Yield the Python that is not the base's own."""
    python = decision.python
    if python.manager == "conda" and python.version and not python.conda_file and not python.conda_specs:
        name = f"Python {python.version} of {decision.ubuntu or decision.base_image}"
        yield Upstream(name=name, why="its own Python is another", instead=f"python={python.version} of conda-forge")


def _hosts(decision: Decision) -> Iterator[Upstream]:
    for host in decision.compiling.hosts:
        yield Upstream(
            name=f"git://{host}/",
            why="it no longer answers; ssh:// would need a key",
            instead=f"https://{host}/",
        )
