"""The one model that every generation of roslab.yaml is read into.

``None`` and empty tuples mean "not said": the evidence decides. Values are validated by the parser: whatever
stands here is safe to quote into a Dockerfile or a shell script (no newline, no NUL), package names match their
registry's grammar, ports and versions are well formed.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from roslab.values.origin import Origin, Place

Kind = Literal["ros1", "ros2", "cuda", "python", "cpp"]
BuildTool = Literal["catkin_make", "catkin_tools", "colcon", "cmake", "pip", "conda", "none"]
Generation = Literal["paper", "later", "interim", "today"]
Compatible = Literal["paper", "later"]


@dataclass(frozen=True, kw_only=True, slots=True)
class Base:
    """What the image starts from; every field may be left to the evidence."""

    image: str | None = None
    """A complete image reference; wins over everything below."""
    ubuntu: str | None = None
    """Codename: ``noble``. Versions and old spellings are normalised to it."""
    ros: str | None = None
    """``DISTRO`` or ``DISTRO-VARIANT``: ``noetic``, ``kinetic-desktop-full``."""
    cuda: str | None = None
    """Version, ``11.8``."""
    cuda_flavour: Literal["base", "runtime", "devel"] | None = None
    cudnn: str | None = None
    """Major version, ``8``."""
    opengl: Literal["runtime", "devel"] | None = None
    python: str | None = None
    """Version, ``3.8``."""
    icub: bool = False
    cmake_update: str | None = None
    """Version of CMake to install over the distribution's: ``3.18.4``."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Source:
    """A library or ROS package that is built from its source; exactly one of ``repo`` and ``zip`` is set."""

    name: str
    repo: str | None = None
    zip: str | None = None
    ref: str | None = None
    """Branch, tag or commit (``checkout`` and ``-b BRANCH`` of the old formats end here)."""
    depends: tuple[str, ...] = ()
    """apt packages needed to build it."""
    build: Literal["cmake", "catkin_make", "catkin_tools", "colcon", "pip", "none"] = "cmake"
    cmake_options: str = ""
    """Text as written, split by a shell's rules when used."""
    cmake_folder: str | None = None
    """Relative to the build folder, ``../`` unless said."""
    make_command: str | None = None
    """Shell text, ``make -j… install`` unless said."""
    keep_source: bool = False
    prepare: str = ""
    """Shell text of the program's own tables, run in the fresh checkout."""
    place: Place | None = None


@dataclass(frozen=True, kw_only=True, slots=True)
class Volume:
    """A folder of the host that the running container sees."""

    host_path: str
    container_path: str
    options: str = ""


@dataclass(frozen=True, kw_only=True, slots=True)
class Matlab:
    """MATLAB of the host, mounted at run time; it is never in the image."""

    host_path: str
    mac_address: str | None = None


@dataclass(frozen=True, kw_only=True, slots=True)
class Custom:
    """Shell commands of the author.

    In the 2019 paper's format each is a RUN of its own, as the image's user, in the home folder. In the later format
    and today's they are one chained RUN as root (``cd`` carries over): in ``/`` for the later format, in the source
    folder for today's.
    """

    commands: tuple[str, ...]
    as_root: bool
    chained: bool
    workdir: Literal["root", "home", "source"]


@dataclass(frozen=True, kw_only=True, slots=True)
class TagParts:
    """What stands before and after every tag of the image."""

    prefix: str = ""
    suffix: str = ""


@dataclass(frozen=True, kw_only=True, slots=True)
class ProofLimits:
    """What the container of a proof may do and use."""

    network: Literal["bridge", "none"] = "bridge"
    """``none``: the loopback alone, which ROS is content with."""
    memory: str | None = None
    """``8g``, ``512m``; ``None``: nine tenths of the machine's."""
    pids: int = 8192
    """Processes and threads: a launch has hundreds, a fork bomb more."""
    new_privileges: bool = False
    """Programs such as sudo may raise what they are allowed."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Config:
    """roslab.yaml as one value; ``Config()`` is what a repository without the file has."""

    file: str | None = None
    """The file it was read from, relative to the repository; ``None`` where there is none."""
    generation: Generation = "today"
    compatible: Compatible | None = None
    """Which old generator's ways the image keeps, so that what the file says still works: the old generators installed
    nothing that the file does not name, built libraries in place and had paths of their own. ``migrate`` writes it."""
    name: str | None = None
    kind: Kind | None = None
    base: Base = field(default_factory=Base)
    repositories: tuple[str, ...] = ()
    """Extra apt sources (PPAs): ``repos`` of the paper, ``repo`` of the later format."""
    apt: tuple[str, ...] = ()
    """One package an entry, ``name``, ``name=version`` or a glob."""
    pip: tuple[str, ...] = ()
    """Python 2's in the old formats, the image's Python today: requirement lines (specifiers, URLs, git+)."""
    pip_options: tuple[str, ...] = ()
    """Options of the one ``pip install`` that takes all of ``pip``, one word an entry: ``--upgrade``."""
    pip_python: Literal["2", "image"] = "image"
    """Whose ``pip`` is: Python 2 (where the base has it) or the image's Python. ``pip2`` of today says the former."""
    pip3: tuple[str, ...] = ()
    pip3_options: tuple[str, ...] = ()
    requirements: tuple[str, ...] | None = None
    """Requirement files to install; an empty tuple means none, ``None`` means those found."""
    conda: str | None = None
    vcs: tuple[str, ...] | None = None
    """Files of sister repositories (.repos, .rosinstall) to import; ``None`` means those found."""
    source: tuple[Source, ...] = ()
    build: BuildTool | None = None
    build_args: tuple[str, ...] = ()
    """Arguments of the build tool, one word an entry."""
    cmake_options: str = ""
    skip_keys: tuple[str, ...] = ()
    """rosdep keys that are not to be installed."""
    custom: Custom | None = None
    env: tuple[tuple[str, str], ...] = ()
    command: tuple[str, ...] | str | None = None
    """A string runs in ``bash -c`` with the workspace sourced, a tuple is an argv."""
    test: tuple[str, ...] | str | None = None
    dockerfile: str | None = None
    context: str | None = None
    args: tuple[tuple[str, str], ...] = ()
    """Build arguments of the author's own Dockerfile."""
    target: str | None = None
    """Stage of the author's own Dockerfile."""
    submodules: Literal["optional", "required"] | None = None
    tags: TagParts = field(default_factory=TagParts)
    proof: ProofLimits = field(default_factory=ProofLimits)
    gui: bool | None = None
    gpu: bool | None = None
    volume: tuple[Volume, ...] = ()
    ports: tuple[str, ...] = ()
    """``HOST:CONTAINER`` or ``CONTAINER``, optionally ``ADDRESS:`` before and ``/udp`` after."""
    platforms: tuple[str, ...] | None = None
    """``linux/amd64`` …"""
    notebook: bool | None = None
    matlab: Matlab | None = None
    origins: tuple[tuple[str, Origin], ...] = ()
    """Where each key was said, by dotted path (``base.ros``, ``apt.2``), for messages and reasons."""
    warnings: tuple[tuple[str, Origin | None], ...] = ()
    """What is outdated or was mapped, with the reason."""

    def origin(self, path: str) -> Origin | None:
        """Return where the key at a dotted path was said, or ``None``."""
        return dict(self.origins).get(path)
