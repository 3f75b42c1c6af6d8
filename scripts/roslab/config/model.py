"""The model for all formats of roslab.yaml.

``None`` and empty tuples mean "not given": the evidence decides. The parser has validated the values: they are safe
to quote in a Dockerfile or a shell script (no newline, no NUL), package names match their registry's grammar, ports
and versions are well formed.
"""

from __future__ import annotations

from typing import Literal, get_args

from roslab.values.dataclass import dataclass, field
from roslab.values.origin import Origin, Place

Kind = Literal["ros1", "ros2", "cuda", "python", "cpp"]
WorkspaceTool = Literal["catkin_make", "catkin_make_isolated", "catkin_tools", "colcon"]
WORKSPACE_TOOLS: tuple[WorkspaceTool, ...] = get_args(WorkspaceTool)
"""Build tools of a ROS workspace in which packages are found by their package.xml."""
BuildTool = Literal[WorkspaceTool, "rosmake", "cmake", "pip", "conda", "none"]
SourceBuild = Literal[WorkspaceTool, "cmake", "pip", "none"]
Generation = Literal["paper", "later", "interim", "today"]
Compatible = Literal["paper", "later"]
PullImage = Literal["image", "archive", "none"]


@dataclass(frozen=True, kw_only=True, slots=True)
class Base:
    """What the image starts from; the evidence decides on every field that is not given."""

    image: str | None = None
    """A complete image reference; it has priority over everything below."""
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
    """Version of CMake that replaces the distribution's: ``3.18.4``."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Patch:
    """A patch of the repository that is applied to a source."""

    path: str
    """Of its file, from the root of the repository."""
    command: tuple[str, ...]
    """``git apply`` or ``patch`` with its options, without the file."""
    below: str = ""
    """The folder of the source in which it is applied."""
    stops: bool = False
    """The build stops where it fails, as the author's does."""
    place: Place | None = None


@dataclass(frozen=True, kw_only=True, slots=True)
class Source:
    """A library or ROS package that is built from its source; exactly one of ``repo`` and ``zip`` is set."""

    name: str
    repo: str | None = None
    zip: str | None = None
    zip_arm64: str = ""
    """The archive that takes its place on arm64, ``""`` where it is for every processor."""
    ref: str | None = None
    """Branch, tag or commit (also from ``checkout`` and ``-b BRANCH`` of the old formats)."""
    depends: tuple[str, ...] = ()
    """apt packages needed to build it."""
    offered: tuple[str, ...] = ()
    """apt packages that a page installs before it builds it: what is not known to apt is left out."""
    build: SourceBuild = "cmake"
    cmake_options: str = ""
    """Text as written; it is split by the rules of a shell when it is used."""
    cmake_folder: str | None = None
    """Relative to the build folder; by default ``../``. With ``by_make`` its Makefile's, relative to its own."""
    make_command: str | None = None
    """Shell text; by default ``make -j… install``."""
    keep_source: bool = False
    prepare: str = ""
    """Shell text from this program's own tables, run in the fresh checkout."""
    before: str = ""
    """Without a ``ref``: the newest commit not after this date (``YYYY-MM-DD``) is taken, if there is one."""
    unread: bool = False
    """Nobody has read what its own CMakeLists.txt asks for: no table knows the library, and no author configures it."""
    tabled: bool = False
    """A row of this program's table says how CMake builds it, on whichever Ubuntu the image has."""
    imported: bool = False
    """The code imports a module of its name: it may be plain Python."""
    by_make: bool = False
    """A page installs it with its own Makefile alone, where that puts its files."""
    unasked: bool = False
    """A page has everybody build it, and nothing that was read asks for it, or only a page below the root clones it,
    or only a link in prose names what CMake links, or it is known by its folder's name alone: where it fails, the image
    goes without."""
    listed: bool = False
    """A list or a page names it: where its host asks for a password, or has it no longer, the image goes without."""
    lists: bool = False
    """It is a workspace's repository, or a list of a list: what its lists name is cloned, in place of what else is
    cloned by these names."""
    holding: tuple[str, ...] = ()
    """Packages for which it is looked through: it is kept where it holds some."""
    patches: tuple[Patch, ...] = ()
    """Patches of the repository that its author applies to it."""
    marked: tuple[str, ...] = ()
    """Folders of it that the author has the build tool pass over, ``""`` for all of it."""
    only: tuple[str, ...] = ()
    """Packages of it that launch files alone want, or messages alone: what these do not need is hidden from the build
    tool."""
    instead: tuple[str, ...] = ()
    """Packages with it that a page installs from a source which it adds to apt: it is built where apt has them not."""
    place: Place | None = None


@dataclass(frozen=True, kw_only=True, slots=True)
class Volume:
    """A folder of the host that the running container sees."""

    host_path: str
    container_path: str
    options: str = ""
    made: bool = False
    """The folder of the host is made where it is absent, as Docker Compose makes those that it mounts."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Matlab:
    """The host's MATLAB, mounted at run time and never part of the image."""

    host_path: str
    mac_address: str | None = None


@dataclass(frozen=True, kw_only=True, slots=True)
class Custom:
    """Shell commands of the author.

    In the 2019 paper's format each command is a separate RUN as the image's user in the home folder. In the later
    format and today's they are one chained RUN as root, so that ``cd`` affects the next command: in ``/`` for the later
    format, in the source folder for today's.
    """

    commands: tuple[str, ...]
    as_root: bool
    chained: bool
    workdir: Literal["root", "home", "source"]


@dataclass(frozen=True, kw_only=True, slots=True)
class TagParts:
    """Prefix and suffix of every tag of the image."""

    prefix: str = ""
    suffix: str = ""


@dataclass(frozen=True, kw_only=True, slots=True)
class ProofLimits:
    """What the container of a proof may do and use."""

    network: Literal["bridge", "none"] = "bridge"
    """``none`` gives only the loopback interface, which is enough for ROS."""
    memory: str | None = None
    """Memory such as ``8g`` or ``512m``; ``None`` means nine tenths of the machine's memory."""
    pids: int = 8192
    """Most processes and threads: a launch has hundreds, a fork bomb more than this."""
    new_privileges: bool = False
    """Whether programs such as sudo may gain privileges."""


@dataclass(frozen=True, kw_only=True, slots=True)
class ProofGoals:
    """How far a proof must get, and what helps it there."""

    rung: int | None = None
    """Below this rung of the ladder nothing is tagged; ``None``: only what is certain must hold."""
    seconds: int | None = None
    """Seconds that the default command is watched; ``None``: as few as show what there is to be seen."""
    topics: tuple[str, ...] = ()
    """Topics on which messages must come for rung 2, and for rung 4 where something is played."""
    play: str | None = None
    """A bag of the repository that is played to the default command, relative to where the command starts."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Config:
    """The content of roslab.yaml; a repository without the file has ``Config()``."""

    file: str | None = None
    """The file it was read from, relative to the repository; ``None`` if there is none."""
    generation: Generation = "today"
    compatible: Compatible | None = None
    """The old generator that the image imitates, so that the file still works: the old generators installed only what
    the file names, built libraries in place and used other paths. ``migrate`` writes this key."""
    name: str | None = None
    kind: Kind | None = None
    date: str | None = None
    """``YYYY-MM-DD``, the day that the image is to be of, or ``paper``: that of the newest commit."""
    pip_date: str | None = None
    """The day of pip's packages where the rest is today's: ``YYYY-MM-DD``, ``paper`` as in ``date``, or ``today``."""
    base: Base = field(default_factory=Base)
    repositories: tuple[str, ...] = ()
    """Extra apt sources (PPAs): ``repos`` of the paper, ``repo`` of the later format."""
    apt: tuple[str, ...] = ()
    """One package per entry: ``name``, ``name=version`` or a glob."""
    pip: tuple[str, ...] = ()
    """Requirement lines (specifiers, URLs, git+), for Python 2 in the old formats, for the image's Python today."""
    pip_options: tuple[str, ...] = ()
    """Options of the single ``pip install`` for all of ``pip``, one word per entry: ``--upgrade``."""
    pip_python: Literal["2", "image"] = "image"
    """The Python for ``pip``: Python 2 (if the base has it), as set by today's ``pip2``, or the image's Python."""
    pip3: tuple[str, ...] = ()
    pip3_options: tuple[str, ...] = ()
    requirements: tuple[str, ...] | None = None
    """Requirement files to install; an empty tuple means none, ``None`` means all that are found."""
    conda: str | None = None
    vcs: tuple[str, ...] | None = None
    """Files that list other repositories to import (.repos, .rosinstall); ``None`` means all that are found."""
    source: tuple[Source, ...] = ()
    build: BuildTool | None = None
    build_args: tuple[str, ...] = ()
    """Arguments of the build tool, one word per entry."""
    cmake_options: str = ""
    skip_keys: tuple[str, ...] = ()
    """rosdep keys that are not to be installed."""
    skip_packages: tuple[str, ...] = ()
    """Packages of the workspace that are not built."""
    custom: Custom | None = None
    env: tuple[tuple[str, str], ...] = ()
    command: tuple[str, ...] | str | None = None
    """A string runs in ``bash -c`` with the workspace sourced, a tuple is an argv."""
    test: tuple[str, ...] | str | None = None
    dockerfile: str | Literal[False] | None = None
    """``False``: one is generated, also where the repository has its own."""
    context: str | None = None
    args: tuple[tuple[str, str], ...] = ()
    """Build arguments of the author's own Dockerfile."""
    target: str | None = None
    """Stage of the author's own Dockerfile."""
    secrets: tuple[str, ...] = ()
    """Names of what single steps of the build may read; ``values.secret`` says what the known ones are for."""
    repair: bool | None = None
    """``False``: the build starts the author's own Dockerfile from the very images that it names."""
    lock: bool | None = None
    """``True``: each run that publishes keeps the lock of its image, as an artifact and beside the image."""
    submodules: Literal["optional", "required"] | None = None
    tags: TagParts = field(default_factory=TagParts)
    pr: PullImage | None = None
    """What a pull request leaves to try: an image under its own tag, an archive among the run's artifacts, or nothing.
    It is no input, because it holds for every workflow that builds the repository."""
    proof: ProofLimits = field(default_factory=ProofLimits)
    goals: ProofGoals = field(default_factory=ProofGoals)
    """The other half of the key ``proof``."""
    gui: bool | None = None
    gpu: bool | None = None
    volume: tuple[Volume, ...] = ()
    ports: tuple[str, ...] = ()
    """``HOST:CONTAINER`` or ``CONTAINER``, optionally ``ADDRESS:`` before and ``/udp`` after."""
    platforms: tuple[str, ...] | None = None
    """``linux/amd64`` …"""
    notebook: bool | None = None
    slim: bool | None = None
    """A second image is built, of what runs alone."""
    matlab: Matlab | None = None
    origins: tuple[tuple[str, Origin], ...] = ()
    """Where each key was given, by dotted path (``base.ros``, ``apt.2``), for messages and reasons."""
    warnings: tuple[tuple[str, Origin | None], ...] = ()
    """Notes on values that are outdated or were converted, with the reason."""

    def origin(self, path: str) -> Origin | None:
        """Return where the key at a dotted path was given, or ``None``."""
        return dict(self.origins).get(path)


def workspace_tool(build_tool: BuildTool) -> WorkspaceTool | None:
    """Return a build tool if it finds the packages of a ROS workspace, else ``None``."""
    return next((tool for tool in WORKSPACE_TOOLS if tool == build_tool), None)
