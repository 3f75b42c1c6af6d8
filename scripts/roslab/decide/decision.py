"""What ``decide`` answers: one value per question, each with the reasons for and against."""

from __future__ import annotations

from typing import Generic, Literal, TypeVar

from roslab.config.model import BuildTool, Kind
from roslab.config.model import Source as SourceDependency
from roslab.decide.python.compiling import NOTHING, Compiling
from roslab.decide.python.pythons import ANY
from roslab.evidence.facts import TestFile
from roslab.values.dataclass import dataclass
from roslab.values.interpreter import Interpreter
from roslab.values.native_part import NativePart
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


@dataclass(frozen=True, kw_only=True, slots=True)
class ByPages:
    """What pages tell the build tool of a workspace."""

    packages: tuple[str, ...] = ()
    """Packages that it builds, with what they need; ``()`` for all of the workspace."""
    jobs: int | None = None
    """Most compilers that may run at once."""


Manager = Literal["system", "venv", "conda"]
"""``system``: the base's own interpreter (ROS); ``venv``: /opt/venv over it; ``conda``: by micromamba."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Python:
    """The Python part of the image."""

    version: str | None
    """``3.8``; ``None`` where the image needs none of its own."""
    manager: Manager
    day: str | None = None
    """``YYYY-MM-DD``: pip's packages are those of that day, ``None`` for those of the image's."""
    interpreter: Interpreter = ANY
    """The Pythons that it may be, for the markers of requirements."""
    pip: tuple[Requirement, ...] = ()
    """Declared in a manifest: they must install."""
    pip_tried: tuple[Requirement, ...] = ()
    """Those of ``pip`` whose file pip refuses: one by one where they do not install together, so that none stops it."""
    pip_guessed: tuple[Requirement, ...] = ()
    """Read from imports or prose: installed where pip can, reported where not."""
    requirements: tuple[str, ...] = ()
    """Requirement files of the tree to install as they are, relative to the root."""
    beside_files: tuple[Requirement, ...] = ()
    """Those of ``pip_guessed`` that are packages of these files with extras of a page: one call of pip chooses both."""
    cloned_files: tuple[str, ...] = ()
    """Requirement files of submodules that the image clones, relative to the root; nothing has read them."""
    manifests: tuple[str, ...] = ()
    """Every file that ``requirements`` and ``conda_file`` need to be read: what they include, their constraints."""
    projects: tuple[str, ...] = ()
    """Folders to ``pip install``, ``.`` for the root; installed in this order, editable, after the source is copied."""
    unseen: tuple[str, ...] = ()
    """Those of ``projects`` that lie in submodules which are not checked out: they may be none."""
    alone: tuple[str, ...] = ()
    """Those of ``projects`` to install without their dependencies, because one of these cannot be had anywhere."""
    conda_file: str | None = None
    conda_specs: tuple[str, ...] = ()
    """conda's packages where ``conda_file`` is pixi's, which micromamba does not read, or where there is none."""
    conda_channels: tuple[str, ...] = ()
    conda_defaults: bool = False
    """The environment file counts on conda's default channels, which conda adds by itself and micromamba does not."""
    conda_local: tuple[str, ...] = ()
    """Folders of the tree that the conda file installs, as it writes them; they are ``projects``."""
    conda_pip: bool = True
    """The conda file has pip install something else."""
    conda_no_channels: tuple[str, ...] = ()
    """What the conda file lists as channels and is none: the page or the file of a package."""
    conda_old_pip: str = ""
    """The version of pip that the conda file pins and that is not taken: it knows no wheels of today."""
    conda_pip_below: str = ""
    """The first pip that is too new for the conda file, which names it in any version."""
    conda_limits: tuple[str, ...] = ()
    """What conda must not take, if it takes that package at all: ``mkl<2024.1`` beside an old torch."""
    conda_cuda: str = ""
    """The CUDA of the drivers for which conda takes packages; ``""``: as on the machine that builds."""
    setuptools: Requirement | None = None
    """The setuptools of the environment, where a package is too old for newer ones."""
    first: tuple[Requirement, ...] = ()
    """What must be installed before the others are built (numpy, torch, Cython)."""
    defines: tuple[str, ...] = ()
    """Macros with which the C++ of the own projects is compiled: ``AT_CHECK=TORCH_CHECK``."""
    bounds: tuple[Requirement, ...] = ()
    """pip constraints: newer versions lack what the code uses, or do not fit its compiled parts or the CUDA."""
    options: tuple[str, ...] = ()
    """pip options: index URLs and find-links of the framework's own wheels."""
    pip_options: tuple[str, ...] = ()
    """Options among the lines of ``pip`` in roslab.yaml (``--upgrade``), for these lines only."""
    python2: tuple[Requirement, ...] = ()
    """Requirements for a Python 2 beside the image's Python (``pip`` in the old formats)."""
    python2_options: tuple[str, ...] = ()
    native_parts: tuple[NativePart, ...] = ()
    """Libraries that packages need before they are built, and do not bring."""
    compiled_modules: tuple[str, ...] = ()
    """Modules that compile themselves when they are first imported."""


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


@dataclass(frozen=True, kw_only=True, slots=True)
class Download:
    """A file that the image fetches while it is built, where it can."""

    url: str
    path: str
    """In the repository."""
    unpack: str | None = None
    """The folder of the repository that it is unpacked to."""

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
    must_build: tuple[str, ...] = ()
    """Packages that are never left out, for the default command does not start without them."""
    large_files: bool = False
    """Git LFS is installed, as a page has its reader do: it fetches its files of what is cloned, too."""
    inside: tuple[tuple[str, str], ...] = ()
    """Folders of copied libraries that are compiled where they lie, each with the options of CMake."""
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
    header_links: tuple[tuple[str, str], ...] = ()
    """Headers of the Ubuntu that links take the place of, each with where its link leads to."""
    native: bool = False
    """CMake files compile for the processor of the machine that builds."""
    clones_day: str = ""
    """The day of what files of CMake clone without a commit."""
    without: tuple[str, ...] = ()
    """Options of the compiler that its files of CMake pass and that are left out for arm64."""
    compilers: tuple[tuple[str, str], ...] = ()
    """The compilers that it names there: the variable and the program."""
    ignored: tuple[str, ...] = ()
    """Folders of packages that are not built, for a build tool that would stop at them."""
    not_there: tuple[str, ...] = ()
    """Folders (``a/b/``) and files that packages install and the repository does not have: made, empty."""
    lacking: tuple[tuple[str, tuple[str, ...]], ...] = ()
    """Packages that a clone may bring, each with the folders of those that are not built where none does."""
    undeclared: bool = False
    """A package requires another one of the repository that its package.xml does not name."""
    ended: tuple[str, ...] = ()
    """Packages that manifests of rosbuild name and this ROS no longer has."""
    workspace: Literal["none", "overlay", "root"] = "none"
    """``overlay``: the repository is a folder of ``ws/src``; ``root``: the repository itself is the workspace."""
    set_up_inside: bool = False
    """Scripts of the repository look for the setup script of the workspace in the repository's own folder."""
    cmake_folder: str = ""
    program_folders: tuple[str, ...] = ()
    """Folder of the top-level CMakeLists.txt of a plain CMake project, ``""`` for the root."""
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
    command_named: bool = False
    """roslab.yaml, an input or an option names the command: it must start."""
    command_imports: tuple[str, ...] = ()
    """Modules that it imports at its top and whose packages are only tried: it does not start without one of them."""
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
    """Where the command listens."""
    warnings: tuple[Warning_, ...] = ()
    reasons: tuple[Reason, ...] = ()
