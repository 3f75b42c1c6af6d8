"""Whether the author's own Dockerfile can be built in place of a generated one."""

from __future__ import annotations

from collections.abc import Mapping

from roslab.config.model import Config, Kind
from roslab.decide.author_command import started
from roslab.decide.best_dockerfile import PUBLISHED, best_of
from roslab.decide.chains import Local, local_bases
from roslab.decide.command import decide_command
from roslab.decide.decision import Choice, Reason, Warning_
from roslab.decide.image_warnings import empty_folders, unbounded_jobs, without_source, without_use
from roslab.decide.launch_calls import started_launch
from roslab.decide.newest_pip import files_of
from roslab.decide.python.raised_pins import raised_pins
from roslab.decide.reasons import because, configured
from roslab.decide.stops_without_gpu import without_gpu
from roslab.decide.uncopied_packages import only_manifest, uncopied_by_command, uncopied_package
from roslab.evidence.facts import AuthorDockerfile, Evidence
from roslab.knowledge.distros import distro, distros
from roslab.knowledge.frameworks import cuda_image
from roslab.knowledge.os_releases import has_ended, release_of
from roslab.values.dataclass import dataclass, replace
from roslab.values.origin import Place
from roslab.values.pattern import pattern

MOST_REASONS = 20
"""Most Dockerfiles that the reasons mention; a collection of robots has hundreds."""
NAMED_PARTS = 3
"""Most parts of the repository that are named of what a Dockerfile copies."""
_CUDA = pattern(r"(?:^|/)nvidia/cuda:(\d+\.\d+)(\.\d+)?")
_ROS = pattern(r"(?:^|/)ros:([a-z]+)")


class Weight:
    """How much each reason for or against an author's Dockerfile counts."""

    BELIEVED = 60  # no doubt applies, and it ranks first among such files
    DOUBTED = -1  # why it is not built


@dataclass(frozen=True, kw_only=True, slots=True)
class Dockerfile:
    """A Dockerfile of the tree and its build context, both relative to the root."""

    file: str
    context: str


def decide_dockerfile(
    evidence: Evidence, config: Config, kind: Kind, ros_distro: str | None
) -> Choice[Dockerfile | None]:
    """Return the author's Dockerfile if it can be used, ``None`` to generate one.

    It can be used if it belongs to the project, copies the source and can be built.
    """
    choice = _choose(evidence, config, kind, ros_distro)
    return choice if choice.answer else replace(choice, warnings=(*choice.warnings, *without_use(config)))


def _choose(evidence: Evidence, config: Config, kind: Kind, ros_distro: str | None) -> Choice[Dockerfile | None]:
    if config.dockerfile:
        said = configured(config, "dockerfile", config.dockerfile, "dockerfile")
        authored = next((each for each in evidence.dockerfiles if each.file == config.dockerfile), None)
        context = config.context
        if context is None:
            context = (authored.context or "") if authored else ""
        told = (*unbounded_jobs(authored, evidence), *without_source(authored)) if authored else ()
        return Choice(answer=Dockerfile(file=config.dockerfile, context=context), reasons=(said,), warnings=told)
    if config.dockerfile is False:
        return Choice(answer=None, reasons=(configured(config, "dockerfile", "false", "dockerfile"),))
    locals_ = local_bases(evidence)
    reasons: list[Reason] = []
    warnings: list[Warning_] = []
    believed: list[AuthorDockerfile] = []
    for authored in evidence.dockerfiles:
        against = (
            _chained(authored, evidence, locals_)
            or doubt(authored, kind, ros_distro, mended=config.repair is not False, local=authored.file in locals_)
            or _secret(authored, config)
            or (None if authored.file in locals_ else _uncopied(authored, evidence, config, kind, ros_distro))
        )
        stops = None if against else without_gpu(authored, evidence)
        if stops:
            warnings.append(stops.warning)
            against = stops.why
        if against is None:
            believed.append(authored)
        else:
            reasons.append(_about(authored, against, Weight.DOUBTED))
    if not believed:
        return Choice(answer=None, reasons=tuple(reasons[:MOST_REASONS]), warnings=tuple(warnings))
    best = best_of(believed, evidence, kind, ros_distro)
    why = f"the author's Dockerfile: it copies {_copies(best)} and starts from {best.base}"
    return Choice(
        answer=Dockerfile(file=best.file, context=best.context or ""),
        reasons=(_about(best, why, Weight.BELIEVED), *reasons[: MOST_REASONS - 1]),
        warnings=(*empty_folders(best), *raised_pins(files_of(best, evidence)), *unbounded_jobs(best, evidence)),
    )


def _copies(authored: AuthorDockerfile) -> str:
    """Return what a Dockerfile copies, in words: the repository, or its parts by name."""
    if not authored.copied or "" in authored.copied:
        return "the repository"
    parts = dict.fromkeys(authored.copied)
    more = f" and {len(parts) - NAMED_PARTS} more" if len(parts) > NAMED_PARTS else ""
    return f"{', '.join([*parts][:NAMED_PARTS])}{more} of the repository"


def _uncopied(
    authored: AuthorDockerfile, evidence: Evidence, config: Config, kind: Kind, ros_distro: str | None
) -> str | None:
    """Return why the image lacks packages of the tree: what it builds, or what would be started in it, needs them."""
    from roslab.decide.unbrought_modules import unbrought  # noqa: PLC0415 - most trees have no Dockerfile

    if kind not in {"ros1", "ros2"}:
        return uncopied_package(authored, evidence, ros_distro) or unbrought(authored, evidence, config, kind)
    if why := uncopied_package(authored, evidence, ros_distro) or only_manifest(authored, evidence):
        return why
    if not authored.copied or "" in authored.copied or started(authored):
        return None
    argv = decide_command(evidence, config, kind, authored.file).answer.command
    words = () if isinstance(argv, str) else argv[1:] if argv[0] in {"roslaunch", "rosrun"} else argv[2:]
    ours = bool(words) and argv[0] in {"roslaunch", "rosrun", "ros2"}
    return uncopied_by_command(authored, words, started_launch(evidence, argv), evidence) if ours else None


def _about(authored: AuthorDockerfile, why: str, weight: int) -> Reason:
    place = Place(file=authored.file, line=authored.base_line)
    return because("dockerfile", authored.file, why, place, weight=weight)


def doubt(  # noqa: PLR0911 - one doubt a line
    authored: AuthorDockerfile, kind: Kind, ros_distro: str | None, *, mended: bool = True, local: bool = False
) -> str | None:
    """Return why a Dockerfile cannot be used, ``None`` if it can.

    ``mended``: the build replaces bases that ended; ``local``: it builds the base from the tree first.
    """
    from roslab.knowledge.official_images import published  # noqa: PLC0415 - most trees have no Dockerfile

    if authored.purpose != "project":
        return {
            "documentation": "it is for the documentation",
            "vendored": "it belongs to a copy of other people's code",
            "ci": "it is for CI, or sets up an environment without the source",
            "deploy": "its name or its base is that of a deployment, a release or one machine",
            "broken": f"it does not parse: {authored.problem}",
        }[authored.purpose]
    if authored.problem:
        return authored.problem
    if authored.clones_itself:
        return "it clones the repository instead of copying this checkout"
    if not authored.copies_repository:
        return "it does not copy the repository into the image"
    if authored.context:
        return f"it builds {authored.context}, not the whole repository"
    if authored.base is None or "$" in authored.base:
        return f"its base is not known: {authored.base or 'no FROM'}"
    if not local and not published(authored.base):
        return f"its base {authored.base} is built on the author's machine first: Docker Hub has no image of that name"
    if given := next((each for each in authored.taken if not published(each[0])), None):
        return (
            f"line {given[1]} takes {given[0]}, which is no stage and no image: `docker build --build-context` gives it"
        )
    against = _base_doubt(authored.base, kind, ros_distro, mended=mended)
    return against or (None if mended else _tables_doubt(authored))


def _tables_doubt(authored: AuthorDockerfile) -> str | None:
    """Return a doubt if it asks rosdep for the tables of a distribution that has ended, which rosdep then skips.

    https://github.com/ros-infrastructure/rosdep/issues/818
    """
    named = _ROS.search(authored.base or "")
    release = distro(named[1]) if named else None
    if release is None or release.rosdistro_tag is None or authored.updates_rosdep is None:
        return None
    return f"its `rosdep update` (line {authored.updates_rosdep}) skips {release.name}, which has ended"


def _secret(authored: AuthorDockerfile, config: Config) -> str | None:
    """Return a doubt if a step mounts a secret that the build does not get."""
    for name, line in authored.secrets:
        if name not in config.secrets:
            return f"line {line} mounts the secret {name}, which roslab.yaml does not name under `secrets`"
    return None


def _chained(authored: AuthorDockerfile, evidence: Evidence, locals_: Mapping[str, Local]) -> str | None:
    """Return a doubt if the base is the image of another Dockerfile here: a page builds it, or it is tagged so."""
    if authored.purpose != "project" or authored.base is None:
        return None
    for file, made in locals_.items():
        if made.dockerfile is authored:
            return f"it makes the base of {file}"
    if first := locals_.get(authored.file):
        said = f"its base {authored.base} is what line {first.said.line} of {first.said.file} builds first"
        return f"{said}, {first.problem}" if first.problem else None
    name, _, tag = (authored.base or "").partition(":")
    if "/" not in name or name.startswith(PUBLISHED) or not tag:
        return None
    for other in evidence.dockerfiles:
        if other is not authored and tag in other.file.split("/")[:-1] and tag not in distros():
            return f"its base {authored.base} is what {other.file} builds"
    return None


def _base_doubt(base: str, kind: Kind, ros_distro: str | None, *, mended: bool) -> str | None:
    """Return why an image is unsuitable as a base: it no longer exists, or it is for something else."""
    from roslab.decide.mended_bases import nearest  # noqa: PLC0415 - as above

    named = _ROS.search(base)
    if (gone := _gone(base)) and not (mended and (nearest(base) or has_ended(release_of(base)))):
        return gone
    if named and kind in {"python", "cpp"}:
        return f"it tests the code with ROS ({base}), which the repository does not need"
    release = distro(named[1]) if named else None
    if release and kind in {"ros1", "ros2"} and ros_distro and release.name != ros_distro:
        return f"it is for {release.name}, the repository for {ros_distro}"
    return None


def _gone(base: str) -> str | None:
    """Return why an image can no longer serve as a base."""
    from roslab.knowledge.ended_bases import ended  # noqa: PLC0415 - most trees have no Dockerfile

    if match := _CUDA.search(base):
        row = cuda_image(match[1])
        if row is None or not row.tag or (match[2] and match[1] + match[2] != row.tag):
            return f"{base} was deleted from the registry"
    return ended(base)
