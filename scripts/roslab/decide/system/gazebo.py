"""A release of Gazebo that is not the distribution's own: ros_gz made for it takes the place of the distribution's."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from roslab.decide.decision import Choice
from roslab.decide.reasons import because
from roslab.decide.ros.gazebo import required
from roslab.decide.system.names import Target
from roslab.decide.system.packages import SystemPackages
from roslab.evidence.facts import Evidence
from roslab.knowledge.gazebo_releases import gazebo_pairs, gazebo_releases, replaced_keys
from roslab.values.dataclass import replace

WEIGHT = 400
"""Weight of the reasons; nothing competes with them."""
_OWN = "ros_gz"


def with_release(choice: Choice[SystemPackages], evidence: Evidence, target: Target) -> Choice[SystemPackages]:
    """Return the packages with ros_gz of the one release of Gazebo that is needed, where it is made for it.

    The two cannot be installed together. Where a source holds ros_gz, all of that release is installed, which compiling
    it needs: https://gazebosim.org/docs/harmonic/ros_installation
    """
    system, distro = choice.answer, target.ros_distro or ""
    libraries = dict(required(evidence))
    releases = {*libraries, *_installed((*system.apt, *system.apt_guessed))}
    release = next(iter(releases)) if len(releases) == 1 else ""
    family = gazebo_pairs().get((distro, release))
    if family is None:
        return choice
    own, named = target.ros(_OWN), f"ros-{distro}-{family}"

    def renamed(name: str) -> str:
        return named + name.removeprefix(own) if name == own or name.startswith(f"{own}-") else name

    keys = tuple(key for key in system.rosdep if key == _OWN or key.startswith(f"{_OWN}_"))
    keyed = tuple(renamed(target.ros(key)) for key in keys)
    sources = {git.name.rpartition("/")[2] for git in evidence.sources if git.kind != "link"}
    whole = (f"gz-{release}",) if _OWN in sources else ()
    more = (named,) if sources and not whole else ()  # what is cloned may ask for any of them
    guessed = sorted({*map(renamed, system.apt_guessed), *more} - {*map(renamed, system.apt), *keyed, *whole})
    answer = replace(
        system,
        rosdep=tuple(key for key in system.rosdep if key not in keys),
        skip_keys=tuple(dict.fromkeys((*system.skip_keys, *keys, *replaced_keys(distro, release)))),
        apt=tuple(dict.fromkeys((*map(renamed, system.apt), *keyed, *whole))),
        apt_guessed=tuple(guessed),
    )
    new = sorted({*answer.apt, *answer.apt_guessed} - {*system.apt, *system.apt_guessed})
    why = f"it is for Gazebo {release.capitalize()}, and ROS {distro}'s own ros_gz is for another release"
    return replace(
        choice,
        answer=answer,
        reasons=(
            *choice.reasons,
            *(because("dependencies", n, why, libraries.get(release), weight=WEIGHT) for n in new),
        ),
    )


def _installed(names: tuple[str, ...]) -> Iterator[str]:
    yield from (release for release in gazebo_releases() if f"gz-{release}" in names)


def of_release(repository: str, apt: Collection[str]) -> list[str]:
    """Return the packages of apt that are ros_gz of another release of Gazebo, where that is the repository."""
    families = tuple(f"ros-{distro}-{family}" for (distro, _), family in gazebo_pairs().items())
    return sorted(name for name in apt if repository == _OWN and name.startswith(families))
