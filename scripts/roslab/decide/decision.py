"""What ``decide`` answers: one value per question, each with the reasons for and against."""

from __future__ import annotations

from typing import Generic, Literal, TypeVar

from roslab.config.model import BuildTool, Kind, Volume
from roslab.config.model import Source as SourceDependency
from roslab.decide.python.command_imports import NO_IMPORTS, CommandImports
from roslab.decide.python.compiling import NOTHING, Compiling
from roslab.decide.python.image_python import Python
from roslab.evidence.entry_script import Taken
from roslab.evidence.facts import TestFile
from roslab.values.dataclass import dataclass
from roslab.values.requirement import Requirement

Answer = TypeVar("Answer")


@dataclass(frozen=True, kw_only=True, slots=True)
class Reason:
    """One piece of evidence for one answer to one question."""

    question: str
    """``kind``, ``ros_distro``, ``ubuntu``, ``base_image``, ``build_tool``, ``python``, ``cuda``, ``dependencies``,
    ``dockerfile``, ``command``, ``platforms``, ``workspace`` …"""
    answer: str
    reason: str
    file: str | None = None
    line: int | None = None
    weight: int = 0
    """Rank among the evidence for the question; a negative one speaks against the answer."""
    decisive: bool = True
    """False for evidence that was outweighed: only ``--explain`` shows it."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Warning_:  # noqa: N801 - the plain name is a built-in
    """Something the author should know; it does not stop the build."""

    message: str
    file: str | None = None
    line: int | None = None


@dataclass(frozen=True, kw_only=True, slots=True)
class Unlinkable(Warning_):
    """What the file builds cannot be linked: what it lacks is known nowhere, and nothing looks for it."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Choice(Generic[Answer]):
    """The answer to one question, what spoke for and against it, and what the author should know about it."""

    answer: Answer
    reasons: tuple[Reason, ...] = ()
    warnings: tuple[Warning_, ...] = ()


@dataclass(frozen=True, kw_only=True, slots=True)
class MendedBase:
    """An image that a Dockerfile starts from, which the build replaces by one that answers."""

    name: str
    """As the Dockerfile names it."""
    image: str
    """What the replacement is made from: the same image, or the nearest one where it is gone."""
    why: str
    recipe: str | None = None
    """The text of the author's Dockerfile that makes it, which needs no build context."""
    answers: bool = False
    """The image is as good as ever: only what the Dockerfile would take for pip, or by pip, is not."""
    pip_below: str | None = None
    """The first pip that is too new for what the Dockerfile has built, whatever it upgrades to."""
    pip_day: str | None = None
    """The day (``YYYY-MM-DD``) of what pip installs there without a version, ``None`` for today's."""
    git_day: str | None = None
    """The day of what git clones there without a tag or a commit, ``None`` for today's."""


@dataclass(frozen=True, kw_only=True, slots=True)
class ByPages:
    """What pages tell the build tool of a workspace."""

    packages: tuple[str, ...] = ()
    """Packages that it builds, with what they need; ``()`` for all of the workspace."""
    jobs: int | None = None
    """Most compilers that may run at once."""


@dataclass(frozen=True, kw_only=True, slots=True)
class OwnScript:
    """A script that compiles something in the repository, or in a submodule of it."""

    folder: str
    """In which it is run, ``""`` for the root."""
    path: str
    """Of the script, from the root."""
    command: str
    required: bool = False
    """Nothing else is built: what fails stops the build."""
    after: bool = False
    """It is run once all else is built: it needs the library of the project, or a page runs it after the workspace."""
    by_compiler: bool = False
    """It is a Makefile that calls compilers alone: CMake has no part in it."""
    copies: bool = False
    """It compiles nothing: it copies a header, or libraries of the tree into the system, or writes code."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Download:
    """A file that the image fetches while it is built, where it can."""

    url: str
    path: str
    """In the repository."""
    unpack: str | None = None
    """The folder of the repository that it is unpacked to."""
    home: bool = False
    """Both paths are below the home of the image's user, not in the repository."""
    system: bool = False
    """The path begins at the root of the image, without its slash."""
    strip: int = 0
    """How many folders of the paths in the archive are left out."""

    @property
    def name(self) -> str:
        """Of the file where it comes from."""
        return self.url.rpartition("/")[2]


@dataclass(frozen=True, kw_only=True, slots=True)
class Decision:
    """All decisions about a repository; ``plan`` turns them into what is built."""

    kind: Kind
    ros_distro: str | None
    ubuntu: str | None
    base_image: str
    build_tool: BuildTool
    rosdep: tuple[str, ...] = ()
    """Keys of the repository's package.xml files, sorted, without the repository's own packages."""
    rosdep_pip: bool = False
    """For some of them rosdep calls pip."""
    skip_keys: tuple[str, ...] = ()
    """Keys that name no package or are built from source: rosdep is told to skip them."""
    repositories: tuple[str, ...] = ()
    """Package sources of a page or of what is installed: lines of apt in which ``signed-by`` is the key's address."""
    apt: tuple[str, ...] = ()
    """Declared: must install."""
    apt_guessed: tuple[str, ...] = ()
    """Only read in prose or guessed: installed where the image's apt knows them, reported where not."""
    python: Python
    pip: tuple[Requirement, ...] = ()
    """Everything that pip and conda install, also what files, projects and environments ask for; for the report."""
    compiling: Compiling = NOTHING
    source: tuple[SourceDependency, ...] = ()
    vcs: tuple[str, ...] = ()
    """vcs files to import into the workspace, relative to the root."""
    submodules: tuple[SourceDependency, ...] = ()
    """Submodules that are not checked out and are cloned in the image, each at its path."""
    apart: tuple[str, ...] = ()
    """Folders of submodules, whose packages a workspace is built without where it fails and needs none of them."""
    may_fail: tuple[str, ...] = ()
    """Folders of packages that are left out where they fail, for nothing is known to bring what they need."""
    spare: tuple[str, ...] = ()
    """Folders of packages that no other one needs: some of them may be left out where they fail."""
    most_spare: int = 0
    """Most of these that may be left out."""
    interfaces: tuple[str, ...] = ()
    """Messages, services and actions of cloned packages whose headers the code includes, as ``acme_msgs/Grip``."""
    wanted: tuple[str, ...] = ()
    """Packages that CMake or launch files need, no package.xml names, and the build looks for all the same."""
    must_build: tuple[str, ...] = ()
    """Packages that are never left out, for the default command does not start without them."""
    large_files: bool = False
    """Git LFS is installed, as a page has its reader do: it fetches its files of what is cloned, too."""
    inside: tuple[tuple[str, str], ...] = ()
    """Folders of copied libraries that are compiled where they lie, each with the options of CMake."""
    inside_installed: tuple[str, ...] = ()
    """Those of these folders that a page installs after it has compiled them."""
    python_path: tuple[str, ...] = ()
    """Folders of the repository on PYTHONPATH, ``.`` for the root."""
    variables: tuple[tuple[str, str], ...] = ()
    """Variables that a page sets and the build or a launch file reads, each with its value."""
    scripts: tuple[OwnScript, ...] = ()
    """Scripts of the repository that compile something, in the order of the README."""
    downloads: tuple[Download, ...] = ()
    """What the default command or the build needs and a page fetches."""
    packages: tuple[str, ...] = ()
    """Paths of the package.xml files that are built (neither ignored nor an asset)."""
    package_names: tuple[str, ...] = ()
    """Names of those packages, sorted; without metapackages of ROS 1."""
    by_pages: ByPages = ByPages()
    left_out: tuple[str, ...] = ()
    """Packages that are not built, because nothing brings what they require and no other one needs them."""
    cmake_options: tuple[str, ...] = ()
    """What a page tells CMake for the repository itself, where it is no ROS package."""
    cuda_options: tuple[str, ...] = ()
    """What tells CMake the compiler that the image's toolkit of CUDA takes."""
    own_packages: tuple[str, ...] = ()
    """Packages of Debian that the repository holds and a page or a script of it installs, by their paths."""
    header_links: tuple[tuple[str, str], ...] = ()
    """Headers of the Ubuntu that links take the place of, each with where its link leads to."""
    cmake_modules: tuple[str, ...] = ()
    """Modules of CMake that the Ubuntu has where CMake does not look."""
    interpreters: tuple[tuple[str, str], ...] = ()
    """Paths of Python on the author's machine, each with the program that a link there leads to."""
    author_folders: tuple[tuple[str, str], ...] = ()
    """Folders of the author's machine, each with what a link there leads to: ``source/…``, ``workspace/…``, or a path.

    ``~/NAME`` lies in the home of the image's user.
    """
    native: bool = False
    """CMake files compile for the processor of the machine that builds."""
    compiled_files: int = 0
    """Files of C and C++ and definitions of messages in the repository."""
    strict: bool = False
    """A build file has warnings of the compiler count as errors."""
    clones_day: str = ""
    """The day of what files of CMake clone without a commit."""
    downloads_heads: bool = False
    """CMake downloads the archive of a branch and compiles it."""
    without: tuple[str, ...] = ()
    """Options of the compiler that its files of CMake pass and that are left out for arm64."""
    compilers: tuple[tuple[str, str], ...] = ()
    """The compilers that it names there: the variable and the program."""
    ignored: tuple[str, ...] = ()
    """Folders of packages that are not built, for a build tool that would stop at them."""
    hidden: tuple[str, ...] = ()
    """Folders of packages that are built and to which the build tool does not come by itself."""
    not_there: tuple[str, ...] = ()
    """Folders (``a/b/``) and files that packages install and the repository does not have: made, empty."""
    lacking: tuple[tuple[str, tuple[str, ...]], ...] = ()
    """Packages that a clone may bring, each with the folders of those that are not built where none does."""
    undeclared: bool = False
    """A package requires another one of the repository that its package.xml does not name."""
    by_links: bool = False
    """colcon installs links to the source: a program imports what lies beside it and is not installed."""
    copied_scripts: tuple[str, ...] = ()
    """Names of scripts that CMake copies among the programs of ROS 2 without the right to be executed."""
    in_bin: tuple[tuple[str, str], ...] = ()
    """Packages of Python whose programs ROS 2 would not find once they are installed: folder and name of each."""
    ended: tuple[str, ...] = ()
    """Packages that manifests of rosbuild name and this ROS no longer has."""
    workspace: Literal["none", "overlay", "root"] = "none"
    """``overlay``: the repository is a folder of ``ws/src``; ``root``: the repository itself is the workspace."""
    set_up_links: tuple[Literal["inside", "beside"], ...] = ()
    """Where links to what the build of the workspace writes stand: in the repository's folder, beside it."""
    git_folder: bool = False
    """The code asks git for the repository's folder."""
    cmake_folder: str = ""
    """Folder of the top-level CMakeLists.txt of a plain CMake project, ``""`` for the root."""
    program_folders: tuple[str, ...] = ()
    """Where its programs are: ``source/…``, relative to the repository's root, ``build/…`` or ``beside/…``."""
    installed: bool = False
    """A page installs this project, too, and does not only compile it."""
    dockerfile: str | None = None
    bases: tuple[MendedBase, ...] = ()
    """Images that this Dockerfile starts from, and that its build replaces."""
    day: str | None = None
    """``YYYY-MM-DD``: packages, tables and clones are taken as they were on that day."""
    context: str | None = None
    """Build context of the author's Dockerfile, relative to the root."""
    command: tuple[str, ...] | str = ("bash",)
    command_given: bool = False
    """A container of the author's image has to be given the command, as the image does not start it by itself."""
    command_through_entrypoint: bool = True
    """It is given through the entry point of that image."""
    entrypoint_takes: Taken = "commands"
    """What that entry point does with words that a container is given."""
    command_named: bool = False
    """roslab.yaml, an input or an option names the command: it must start."""
    command_imports: CommandImports = NO_IMPORTS
    command_candidates: tuple[tuple[str, ...], ...] = ()
    test: tuple[str, ...] | str | None = None
    """The command that tests the image in place of the default proofs; a string runs in ``bash -c``."""
    rostests: tuple[str, ...] = ()
    """Launch files of the repository with tests that can run in the image."""
    tests: tuple[TestFile, ...] = ()
    """Files of tests in Python that can run in the image."""
    ctest: bool = False
    """The program that is compiled has tests for ctest."""
    compiles: bool = False
    """Programs are compiled, whichever tool does it."""
    platforms: tuple[str, ...] = ("linux/amd64", "linux/arm64")
    platforms_refused: tuple[tuple[str, str], ...] = ()
    cuda: str | None = None
    cudnn: str | None = None
    gpu: bool = False
    gui: bool = False
    ports: tuple[str, ...] = ()
    volumes: tuple[Volume, ...] = ()
    """What Docker Compose mounts into containers of the author's image."""
    """Where the command listens."""
    warnings: tuple[Warning_, ...] = ()
    reasons: tuple[Reason, ...] = ()
