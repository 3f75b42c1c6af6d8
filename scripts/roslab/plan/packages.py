"""The system packages of an image: what its own steps need, and what the repository names."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.config.model import Config, Source
from roslab.decide.decision import Decision
from roslab.decide.ros.source_names import wraps
from roslab.knowledge.compiled import programs
from roslab.knowledge.distros import distro
from roslab.knowledge.on_request import packages
from roslab.knowledge.package_data import PackageData, package_data
from roslab.knowledge.tools import pip_with_sni
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern
from roslab.values.secret import SSH

_OFFICIAL_ROS = pattern(r"(?:^|/)ros:")


@dataclass(frozen=True, kw_only=True, slots=True)
class ImagePackages:
    """Packages in the order in which they are installed."""

    first: tuple[str, ...] = ()
    """ROS, and what every image of the old formats had; empty for a current roslab.yaml."""
    tools: tuple[str, ...] = ()
    """Installed if the base's apt has them; if one is missing, the step that uses it fails and says so."""
    named: tuple[str, ...]

    def without(self, guessed: Iterable[str]) -> tuple[str, ...]:
        """Return what is guessed and none of these, nor the name for Python 2 of a tool that is here for Python 3."""
        here = {*self.first, *self.named, *self.tools}
        renamed = {name.replace("python3-", "python-", 1) for name in self.tools}
        return tuple(name for name in guessed if name not in here | renamed)


def own_files(paths: Iterable[str]) -> tuple[tuple[str, str], ...]:
    """Return packages that the repository holds, each with the path by which apt is asked for it."""
    held = (path for path in paths if "://" not in path)
    return tuple((path, f"/tmp/packages/{path.rpartition('/')[2]}") for path in held)  # noqa: S108 - of the image


def asked_files(paths: Iterable[str]) -> tuple[str, ...]:
    """Return what the step that installs such packages is given, in its order: the path in the image, or an address."""
    return tuple(path if "://" in path else own_files((path,))[0][1] for path in paths)


def image_packages(decision: Decision, config: Config, in_workspace: tuple[Source, ...]) -> ImagePackages:
    """Return what the steps of the plan themselves need, then what the repository needs."""
    if decision.dockerfile:
        return ImagePackages(named=decision.apt)  # the author's Dockerfile has its own steps
    needs = sorted({*_needs(decision, config)} | ({"ca-certificates", "git"} if in_workspace else set()))
    tools = _ros_tools(decision, in_workspace)
    if not config.compatible:
        return ImagePackages(tools=tuple(tools), named=tuple(dict.fromkeys((*needs, *decision.apt))))
    # In an old format its own packages come before JupyterLab and ROS, those that the author names after them
    ros = tuple(name for name in decision.apt if name not in config.apt)
    always = packages("old-image", decision.ubuntu)
    tools += [name for name in packages("old-tools", decision.ubuntu) if name not in needs]
    first = tuple(dict.fromkeys((*sorted({*always, *needs}), *ros)))
    return ImagePackages(first=first, tools=tuple(tools), named=config.apt)


def _needs(decision: Decision, config: Config) -> list[str]:
    """Return what the plan's steps need and any base may lack: a compiler, git, Python's tools."""
    needs: list[str] = []
    compiled = decision.build_tool == "cmake" and decision.kind not in ("ros1", "ros2")  # a ROS base has a compiler
    if compiled:
        needs += ["build-essential", "cmake"]
    elif decision.kind == "cpp" and not decision.scripts:  # another tool builds it, which its reader has to add
        needs.append("build-essential")
    if SSH in config.secrets:
        needs.append("openssh-client")
    if any(source.zip for source in decision.source) or config.base.cmake_update or config.base.icub:
        needs += ["build-essential", "ca-certificates", "curl", "unzip"]
    return needs + _python_needs(decision, notebook=bool(config.notebook), compatible=bool(config.compatible))


def _compilers(decision: Decision, *, own_python: bool) -> list[str]:
    """Return what pip compiles with; the images of ROS and those with CUDA's toolkit have a compiler.

    ``own_python``: the base brings its Python with its headers, as conda's has them too.
    """
    if not (decision.compiling.compiler or decision.scripts):
        return []
    has_one = decision.kind in ("ros1", "ros2") or "-devel" in decision.base_image
    needs = [] if has_one else ["build-essential"]
    needs += [] if all(script.by_compiler or script.copies for script in decision.scripts) else ["cmake"]
    if decision.python.conda_file:  # its pip part is compiled while the environment is made, before pip's own steps
        needs += [programs()[each.key] for each in decision.python.first if each.key in programs()]
    of_python = decision.compiling.compiler or decision.kind != "cpp"
    if of_python and decision.python.manager != "conda" and not own_python:
        needs.append("python-dev" if (decision.python.version or "").startswith("2") else "python3-dev")
    return needs + (["cargo"] if decision.compiling.rust else [])


def _python_needs(decision: Decision, *, notebook: bool, compatible: bool) -> list[str]:
    """Return the system packages that the image's Python needs."""
    python = decision.python
    own_python = decision.base_image.rpartition("/")[2].startswith("python:")  # it has pip and venv in /usr/local
    asked = (*python.pip, *python.pip_guessed, *python.first, *python.python2)
    needs = ["ca-certificates", "git"] if decision.compiling.git or any(each.vcs for each in asked) else []
    if python.manager == "conda":
        needs.append("ca-certificates")
    if not compatible:
        needs += _compilers(decision, own_python=own_python)
    if not own_python and (python.manager == "venv" or notebook):
        needs += ["ca-certificates", "python3", "python3-venv"]
    files = python.requirements or python.cloned_files or any(source.imported for source in decision.source)
    if not own_python and python.manager == "system" and (asked or files or python.projects):
        two = (python.version or "").startswith("2")
        sni = pip_with_sni(decision.ubuntu) if two else None
        needs += ["python-pip" if two else "python3-pip", *(sni[1] if sni else ())]
    return needs + list(packages("python2", decision.ubuntu) if python.python2 else ())


def _ros_tools(decision: Decision, in_workspace: tuple[Source, ...]) -> list[str]:
    """Return the workspace tools that not every ROS image has."""
    release = distro(decision.ros_distro)
    if release is None:
        return []
    python = "python" if release.python.startswith("2") else "python3"
    used = {decision.build_tool, *(source.build for source in in_workspace)}
    tools = [f"{python}-catkin-tools"] if "catkin_tools" in used else []
    bare = not _OFFICIAL_ROS.search(decision.base_image) or decision.base_image.endswith("-ros-core")
    if bare and (decision.packages or in_workspace):
        tools += ["build-essential", f"{python}-rosdep"]
        tools += [f"ros-{release.name}-rosmake", f"ros-{release.name}-mk"] if "rosmake" in used else []
    if "colcon" in used and (decision.packages or in_workspace) and (bare or release.ros == 1):
        tools.append("python3-colcon-common-extensions")
    if any(wraps(source.name) for source in in_workspace):
        tools += packages("catkin-wrapper", decision.ubuntu)
    return list(dict.fromkeys((*tools, *(name for data in data_of(decision) for name in data.needs))))


def data_of(decision: Decision) -> tuple[PackageData, ...]:
    """Return the data that packages of the image need and do not bring."""
    if decision.kind not in ("ros1", "ros2") or decision.dockerfile:
        return ()
    apt = {name.removeprefix(f"ros-{decision.ros_distro}-") for name in (*decision.apt, *decision.apt_guessed)}
    names = {*decision.rosdep, *(name.replace("-", "_") for name in apt)}
    return tuple(data for data in package_data() if data.package in names)
