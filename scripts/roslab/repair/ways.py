"""Ways to work out a value of roslab.yaml from plan and log, named by ``way`` in ``knowledge/repairs.toml``."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

from roslab.decide.python.pythons import PREFERRED
from roslab.decide.python.requires import refusing
from roslab.explain.answer import Explanation
from roslab.knowledge.distros import default_distro, distro, distros, distros_of, ubuntus
from roslab.knowledge.os_releases import has_ended
from roslab.knowledge.released import released
from roslab.knowledge.repairs import repairs
from roslab.repair import clones, flags, keys, linked_packages, missing, older_library, releases
from roslab.repair.change import Given, Worked
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern
from roslab.values.specifier import admits, specifiers
from roslab.values.version import Version

_ALIASES = ("float", "int", "bool", "object", "str", "complex", "long", "unicode")
"""Names that NumPy 1.24 removed: https://numpy.org/doc/stable/release/1.24.0-notes.html"""
_PIN = pattern(r"==\s*([\w.!+]{1,60})$")
_WORDS = pattern(r"[\w./-]+")
_READ = pattern(r"([\w./-]{1,300}):\d{1,7}\b")
"""A file with the line where a compiler or CMake stopped."""
_SERIAL = {
    "catkin_make": ("-j1",),
    "catkin_make_isolated": ("-j1",),
    "cmake": ("-j1",),
    "catkin_tools": ("-j1", "-p1"),
    "colcon": ("--executor", "sequential"),
}
"""Arguments of each build tool that compile one thing at a time."""


Way = Callable[[Explanation, Given], Worked]


def python(found: Explanation, given: Given) -> Worked:
    """Take a Python that what pip refused can run with."""
    names = dict(found.names)
    if given.plan.ros_distro:
        return Worked(why=f"the Python of ROS {given.plan.ros_distro} cannot be exchanged: take another release of it")
    exact = names.get("release", "")
    needs = f"=={exact}.*" if exact else names.get("needs", "") or required(names, found.log)
    needs = f">={needs}" if needs[:1].isdigit() else needs
    allowed = specifiers(needs) if needs else None
    if allowed is None:
        return Worked(why="the log does not say which Python it needs")
    tried = [version for version in (given.plan.python.version, names.get("python")) if version]
    fitting = [each for each in PREFERRED if admits(allowed, each) and not any(_is(now, each) for now in tried)]
    if not fitting:
        return Worked(why=f"no Python is {needs} and another than {' or '.join(tried)}")
    return Worked(values=(fitting[0],))


def older_python(found: Explanation, given: Given) -> Worked:
    """Take the newest Python that still has what was removed, if the repository's own projects run there.

    ROS's Python stays: what the repository pins of that time becomes a newer release.
    """
    last, now = dict(found.names).get("last", ""), given.plan.python.version
    if given.plan.ros_distro:
        line, instead = releases.newer(found, given)
        if line:
            return Worked(values=(line,), instead=instead, key="pip")
        return Worked(why=f"the Python of ROS {given.plan.ros_distro} cannot be exchanged: {found.fix}")
    limit = Version(last)
    if now and Version(now) < Version(f"{limit.major}.{limit.minor + 1}"):
        return Worked(why=f"the image has Python {now} already")
    fitting = [each for each in PREFERRED if Version("3") < Version(each) <= limit]
    fitting = [each for each in fitting if refusing(each, given.evidence.python) is None]
    if not fitting:
        return Worked(why=f"the repository runs on no Python up to {last}: take a newer release of what uses it")
    return Worked(values=(max(fitting, key=Version),))


def newer_python(found: Explanation, given: Given) -> Worked:
    """Take the oldest Python of the table's ``tag`` that the repository runs on, if the image has an older one."""
    since, now = repairs()[found.id or ""].tag.removeprefix(">="), given.plan.python.version
    if given.plan.ros_distro:
        return Worked(why=f"the Python of ROS {given.plan.ros_distro} cannot be exchanged: {found.fix}")
    if now and Version(now) >= Version(since):
        return Worked(why=f"the image has Python {now} already")
    fitting = [each for each in PREFERRED if Version(each) >= Version(since)]
    fitting = [each for each in fitting if refusing(each, given.evidence.python) is None]
    if not fitting:
        return Worked(why=f"the repository runs on no Python from {since} on: {found.fix}")
    return Worked(values=(min(fitting, key=Version),))


def _is(version: str, python: str) -> bool:
    return f"{version}.".startswith(f"{python}.")


def required(names: Mapping[str, str], log: str) -> str:
    """Return the Pythons of the pinned release among those that pip ignored."""
    pin = _PIN.search(names.get("version", ""))
    if pin is None:
        return ""
    said = re.search(rf"(?:: |; ){re.escape(pin[1])} Requires-Python ([^;\n]{{1,80}})", log)
    return said[1].strip() if said else ""


def numpy(found: Explanation, _: Given) -> Worked:
    """Keep NumPy below the release that removed what is used."""
    symbol = dict(found.names).get("symbol", "")
    return Worked(values=("numpy<1.24" if symbol in _ALIASES else "numpy<2",))


def release(found: Explanation, given: Given) -> Worked:
    """Take the release nearest to a pinned one that the index has not."""
    line, instead, why = releases.nearest(found, given)
    return Worked(values=(line,), instead=instead) if line else Worked(why=why)


def jobs(_: Explanation, given: Given) -> Worked:
    """Compile one thing at a time."""
    values = _SERIAL.get(given.plan.build_tool, ())
    return Worked(values=values, why="" if values else f"{given.plan.build_tool} takes no number of jobs")


def cmake(found: Explanation, _: Given) -> Worked:
    """Install the CMake that the project asks for."""
    needs = dict(found.names).get("needs", "").strip(".")
    return Worked(values=(".".join([*needs.split("."), "0", "0"][:3]),) if needs else (), why=found.fix)


def standard(found: Explanation, _: Given) -> Worked:
    """Compile with the C++ standard that a library asks for."""
    names = dict(found.names)
    said = names.get("standard", "") or ("17" if names.get("seventeen") else "14" if names.get("fourteen") else "")
    return Worked(values=(f"-DCMAKE_CXX_STANDARD={said}",)) if said.isdigit() else Worked(why="the compiler is too old")


def ros(found: Explanation, given: Given) -> Worked:
    """Install a ROS package that the distribution released."""
    distro = given.plan.ros_distro
    wanted = [word for word in dict(found.names).get("name", "").split(", ") if word]
    own = next((word for word in wanted if word in missing.own_packages(given)), "")
    if own and not found.step:  # a program that runs has what could be built of it
        return Worked(why=f"{own} is a package of this repository: it is not built, or lacks what is looked for")
    known = [word for word in wanted if distro and word in released(distro)]
    if distro and known:
        return Worked(values=tuple(f"ros-{distro}-{word.replace('_', '-')}" for word in known))
    if own:
        return Worked(why=f"{own} is a package of this repository: it is built after what asks for it, or not at all")
    lacking = ", ".join(wanted)
    if not distro:
        return Worked(why=f"{lacking} is of ROS, and this image has none: `base.ros` in roslab.yaml names one")
    if found_there := clones.cloned(wanted, given):
        return found_there
    addresses = dict.fromkeys(row.repo for word in wanted for row in clones.tabled(word, given))
    where = f": {', '.join(addresses)}" if addresses else ""
    return Worked(why=f"{lacking} is not released for ROS {distro}: name its repository under `source`{where}")


def _generation(name: str | None) -> int:
    known = distro(name)
    return known.ros if known else 0


_OF_ROS_1 = ("catkin", "roscpp", "rospy", "roslaunch", "message_generation", "message_runtime", "rviz", "tf")
_OF_ROS_2 = ("ament_", "rclcpp", "rclpy", "rosidl_", "launch_ros")


def other_ros(found: Explanation, given: Given) -> Worked:
    """Take the ROS that the code is written for: the one made for the image's Ubuntu, or its generation's usual one."""
    names = dict(found.names)
    now = given.plan.ros_distro
    word = names.get("name") or names.get("key", "")
    wanted = 1 if word in _OF_ROS_1 else 2 if word.startswith(_OF_ROS_2) else 0
    if names.get("version") in ubuntus().values() and wanted:
        fitting = distros_of(names["version"], 1 if wanted == 1 else 2)
        return Worked(values=fitting[:1], certain=False, why=f"no ROS {wanted} is made for {names['version']}")
    if not wanted or wanted == _generation(now):
        return Worked(why=f"ROS {now} has it: source /opt/ros/{now}/setup.bash in that step" if now else found.fix)
    return Worked(values=(default_distro(1 if wanted == 1 else 2).name,), certain=False)


def older_ros(found: Explanation, given: Given) -> Worked:
    """Take the newest ROS for an older Ubuntu that has all keys which the packages name and the image's own has."""
    now = distro(given.plan.ros_distro)
    if now is None:
        return Worked(why="the image has no ROS, which another one could take the place of")
    asked = released(now.name).intersection(given.plan.rosdep_keys)
    older = [d for d in distros().values() if d.ros == now.ros and d.ubuntu != now.ubuntu and not d.never_ends]
    older = [d for d in older if d.released < now.released and asked <= released(d.name)]
    why = "" if older else f"no ROS for an older Ubuntu has all that the packages ask for: {found.fix}"
    return Worked(values=tuple(d.name for d in older[-1:]), certain=False, why=why)


def ros_before(found: Explanation, given: Given) -> Worked:
    """Take the newest ROS that has what the code uses, if it has all keys which the packages name and this one has."""
    last, now = dict(found.names)["last"], given.plan.ros_distro
    lacking = released(now or last).intersection(given.plan.rosdep_keys) - released(last)
    why = f"ROS {last} lacks {', '.join(sorted(lacking))}: {found.fix}" if lacking else ""
    return Worked(values=() if lacking else (last,), certain=False, why=why)


def newer_ubuntu(_: Explanation, given: Given) -> Worked:
    """Take the next release of Ubuntu that is still supported."""
    if given.plan.ros_distro:
        return Worked(why=f"ROS {given.plan.ros_distro} belongs to its Ubuntu: take a newer ROS with `base.ros`")
    releases = list(ubuntus().items())
    codenames = [codename for _, codename in releases]
    if given.plan.ubuntu not in codenames:
        return Worked(why="the base image is no Ubuntu that `base.ubuntu` sets")
    later = releases[codenames.index(given.plan.ubuntu) + 1 :]
    fitting = [version for version, codename in later if not has_ended(codename)]
    return Worked(values=tuple(fitting[:1]), certain=False, why="there is no newer Ubuntu yet")


def compiler(found: Explanation, given: Given) -> Worked:
    """Install a newer compiler beside the Ubuntu's own, or take a newer Ubuntu where none is known."""
    worked = flags.compiler(found, given)
    newer = None if worked.values or given.plan.ros_distro else newer_ubuntu(found, given)
    return replace(newer, key="base.ubuntu") if newer and newer.values else worked


def renamed(found: Explanation, given: Given) -> Worked:
    """Replace a package of roslab.yaml that has another name today."""
    names = dict(found.names)
    old = [word for word in names.get("name", "").split(", ") if _asks(given, word)]
    new = [word for word in names.get("package", "").split(", ") if word]
    if len(old) == 1 and len(new) == 1:
        return Worked(values=(new[0],), instead=old[0])
    return Worked(why="roslab.yaml does not name it once")


def unpinned(found: Explanation, given: Given) -> Worked:
    """Take whatever version of a package of roslab.yaml there is."""
    names = dict(found.names)
    name = names.get("name", "")
    pinned = f"{name}={names.get('version', '')}"
    if any(pinned in value.split() for value in given.config.apt):
        return Worked(values=(name,), instead=pinned)
    return Worked(why=f"roslab.yaml does not pin {name}")


def _asks(given: Given, word: str) -> bool:
    return bool(word) and any(word in value.split() for value in given.config.apt)


def submodules(found: Explanation, given: Given) -> Worked:
    """Demand the submodules, if the failed step wants a file of one that is not checked out."""
    names = dict(found.names)
    said = [names[name] for name in ("path", "file", "header", "name", "module") if names.get(name)]
    said += _WORDS.findall(found.error)
    if headers := names.get("header", ""):  # the file that includes it is there, and so is the submodule it lies in
        said = headers.split(", ")
    read = _READ.findall(found.error)
    for path in absent(given):
        folder = path.rpartition("/")[2]
        if any(f"{path}/" in word for word in read):
            continue  # a file of it was read: it is there
        if any(path in word or folder in word.split("/") for word in said):
            return Worked(values=("required",))
    return Worked(why="no submodule is missing")


def absent(given: Given) -> tuple[str, ...]:
    """Return the paths of the submodules that are not checked out."""
    paths = [source.name for source in given.evidence.sources if source.kind == "submodule"]
    return tuple(path for path in paths if not any(file.startswith(f"{path}/") for file in given.files))


WAYS: Mapping[str, Way] = {
    "brought": clones.of_package,
    "compiler": compiler,
    "cmake": cmake,
    "dropped": releases.dropped,
    "flags": flags.flags,
    "jobs": jobs,
    "key": keys.key,
    "key-of-double": keys.of_double,
    "linked": flags.linked,
    "linked-package": linked_packages.linked,
    "module": missing.module,
    "newer-python": newer_python,
    "newer-ubuntu": newer_ubuntu,
    "not-errors": flags.not_errors,
    "numpy": numpy,
    "older-library": older_library.older_library,
    "older-python": older_python,
    "older-ros": older_ros,
    "other-ros": other_ros,
    "program": missing.program,
    "python": python,
    "release": release,
    "released": ros,
    "renamed": renamed,
    "ros-before": ros_before,
    "standard": standard,
    "submodules": submodules,
    "unpinned": unpinned,
}
