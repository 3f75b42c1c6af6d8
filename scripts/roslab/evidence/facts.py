"""The facts that readers return, each with its place. Readers report, ``decide`` judges."""

from __future__ import annotations

from typing import Literal

from roslab.evidence.apt_source import AptSource
from roslab.evidence.author_path import AuthorPath
from roslab.evidence.cmake_project import CMakeProject
from roslab.evidence.code_limit import CodeLimit
from roslab.evidence.conda_environment import CondaEnvironment
from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.entry_script import EntryScript
from roslab.evidence.launch_file import LaunchFile
from roslab.evidence.locked import Locked
from roslab.evidence.makefile import Makefile
from roslab.evidence.old_code import OldCode
from roslab.evidence.own_key import OwnKey
from roslab.evidence.patch import Patch
from roslab.evidence.program import Program
from roslab.evidence.python_project import PythonProject
from roslab.evidence.removed_name import Removed
from roslab.evidence.service import Service
from roslab.evidence.workspace_files import WorkspaceFiles
from roslab.evidence.x86_only import X86Only
from roslab.values.dataclass import dataclass
from roslab.values.requirement import Requirement

RosInImage = Literal["named", "possible", "none"]
"""Its instructions name something of ROS; these or its base may bring it all the same; or neither."""


@dataclass(frozen=True, kw_only=True, slots=True)
class PackageManifest:
    """A package.xml. https://ros.org/reps/rep-0149.html (formats 1 and 2: REP 127, REP 140).

    Format 0: a manifest.xml or stack.xml of rosbuild, whose build type is ``rosbuild``.
    """

    file: str
    line: int
    name: str | None
    format: int
    build_types: tuple[tuple[str, str | None], ...]
    """``(type, condition)``: ``catkin``, ``ament_cmake``, ``ament_python``, ``cmake`` …; catkin if none is given."""
    dependencies: tuple[Dependency, ...]
    sources: tuple[GitSource, ...] = ()
    metapackage: bool = False
    ignored: bool = False
    """In or below a folder with COLCON_IGNORE, AMENT_IGNORE or CATKIN_IGNORE."""
    malformed: str | None = None
    """The parser's message if the XML is not well-formed; the other fields hold what could be read."""
    together: tuple[str, int] | None = None
    """The first element that names several packages, which tools take for one name, with its line."""
    website: str | None = None
    """The first address that it gives for itself, of its website or its repository."""


@dataclass(frozen=True, kw_only=True, slots=True)
class RequirementFile:
    """A requirements file, under any usual name."""

    file: str
    line: int
    requirements: tuple[Requirement, ...]
    includes: tuple[str, ...]
    """Paths of files that it includes with ``-r``, relative to the repository's root."""
    constraints: tuple[str, ...]
    options: tuple[str, ...]
    """Lines such as ``--extra-index-url …`` and ``-f …``."""
    purpose: Literal["run", "docs", "test", "dev", "vendored"]
    raised: tuple[tuple[str, str, str], ...] = ()
    """Pins that a bot raised: the package, the release before and after, the last one first. They are read only where
    no Python has wheels for all pins."""
    include_lines: tuple[int, ...] = ()
    """The line of each of ``includes``."""
    misplaced: tuple[tuple[str, str, int], ...] = ()
    """What it includes by a path that the tree does not have: that path, the one taken in its place, and the line."""
    unread: tuple[int, ...] = ()
    """Lines that pip refuses, and of which nothing tells what they ask for."""


@dataclass(frozen=True, kw_only=True, slots=True)
class AuthorDockerfile:
    """A Dockerfile that the author wrote."""

    file: str
    line: int
    base: str | None
    """The FROM of the last stage that starts from an external image, with the defaults of ARGs filled in."""
    base_line: int
    copies_repository: bool
    clones: tuple[GitSource, ...]
    patches: tuple[Mention, ...] = ()
    """What it applies to them."""
    dependencies: tuple[Dependency, ...]
    """What it installs with apt."""
    requirements: tuple[Requirement, ...]
    command: tuple[str, ...]
    """Its CMD; ``()`` for that of its base."""
    purpose: Literal["project", "documentation", "vendored", "ci", "deploy", "broken"]
    """What it seems to be for; ``broken`` if it does not parse."""
    problem: str | None = None
    context: str | None = None
    """Build context that its COPY lines fit, relative to the root; ``None`` if nothing is copied."""
    command_line: int | None = None
    """The line of ``command``, else of ``entrypoint``."""
    entrypoint: tuple[str, ...] = ()
    """Its ENTRYPOINT; ``()`` for that of its base."""
    entry: EntryScript | None = None  # the script of the tree that this names
    starts_in_source: bool = False
    """A container starts in the folder that the whole build context was copied to."""
    source: str = ""
    """That folder, relative to the one in which a container starts, ``""`` where it is not known."""
    updates_rosdep: int | None = None
    """The line of a ``rosdep update`` that skips distributions that have ended."""
    newest_pips: tuple[tuple[str, int], ...] = ()  # images in which it upgrades pip without a bound, with the line
    own_shell: bool = False  # it names the shell of its steps, or has it start what runs in the container
    changes_setup: bool = False  # its steps change what a setup.py asks for, as by sed
    secrets: tuple[tuple[str, int], ...] = ()
    """The secrets that its steps mount, ``ssh`` for the agent, each with its line."""
    bases: tuple[tuple[str, int], ...] = ()
    """The external images of all its stages, with the line of each FROM."""
    stages: tuple[tuple[int, str], ...] = ()  # the line of each FROM, and the external image that its stage starts from
    clones_itself: bool = False
    """It clones this repository instead of building the checkout."""
    recipe: str | None = None
    """Its text, if it needs no build context."""
    copied: tuple[str, ...] = ()  # files and folders, relative to the root; none where a pattern is among them
    taken: tuple[tuple[str, int], ...] = ()  # images and named contexts that it takes files from, with the line
    enters: tuple[tuple[str, int], ...] = ()  # submodules without their files that its steps name, with the line
    environment: tuple[
        Mention, ...
    ] = ()  # ``NAME=VALUE`` of it and of its service, for ROS and for what the tree reads
    hides: bool = False  # its steps may install more than its lines say
    ros: RosInImage = "possible"
    built: tuple[str, ...] | None = None  # names and folders of packages that it builds, ``None`` for maybe any
    kept: tuple[str, ...] | None = None  # all that its last stage has of the tree; ``None`` where it may be anything
    service: Service | None = None  # the service of Docker Compose that a page at the root starts from it


@dataclass(frozen=True, kw_only=True, slots=True)
class Mention:
    """A mention of a distribution, an Ubuntu, a CUDA or Python version or the like."""

    topic: Literal[
        "distro", "ubuntu", "cuda", "cudnn", "python", "no_python", "build_tool", "base", "framework", "command",
        "date", "vcs_file", "compiled", "step", "build_script", "python_path", "from_root", "variable", "exported",
        "option", "gazebo", "compared", "skipped", "own_history", "data", "image_built", "image_pulled", "pointed",
        "included", "reference", "libtorch", "fetched", "unpacked", "runs", "environment", "elsewhere", "tried",
        "positional", "refused", "launcher", "stops", "withheld", "entered", "parameter", "other_builder", "conflict",
        "made", "unlaunched", "machine", "own_setup", "demanded", "cloned_head", "at_top", "sibling", "contained",
        "weights", "port", "listens", "own_package", "opened", "above", "companion", "home_archive", "compiled_for",
        "torch_on_gpu", "index_link", "template", "patched", "single_header", "unpackaged", "said_run", "session",
        "required", "calls", "guide", "of_other_index", "matlab", "master", "git_folder", "installed_here", "make",
        "asked_option", "reached", "as_sources", "node_import", "only_in_manifest", "lost_folder", "sibling_folder",
        "on_gpu", "handed", "own_spelling", "optional_step", "started", "made_header", "start_import", "from_above",
        "lost_header", "needs_extension", "unbounded", "optional_ros", "typestore", "cuda_path", "lost_module",
        "screen", "mounted", "argument_count", "copied", "session_loaded", "system_library", "edited", "left_beside",
        "strict", "shown", "usetex", "handed_place", "generates", "onnx_on_gpu", "omitted_package",
        "copied_script", "python3_module", "speaks", "ending", "built_by", "robot_model", "in_bin", "python2_node",
        "module_aside", "ros_call", "robot_models", "of_windows", "told_way", "caught_import", "head_archive",
    ]  # fmt: skip
    value: str
    source: Literal[
        "branch", "dockerfile", "ci", "readme", "vcs", "filename", "manifest", "launch", "script", "code", "commit"
    ]
    file: str
    line: int
    text: str
    """The words around it, which the reason quotes."""
    files: tuple[str, ...] = ()
    """Of a call of make: the Makefile of the tree, and programs for x86-64 beside it, which it may make anew.

    Of a command: its arguments that are files or folders of the tree; they are relative to its root in ``value``.
    Of what is fetched: where to, ``value`` being the URL; of what is unpacked: the archive and the folder, ``value``
    being the build file that names what it holds. Of what is shown: itself, if it can be started as it is. Of an
    archive for the home: the folder there, and how many folders
    of its paths are left out."""
    heading: str = ""
    """The titles of the sections that it stands in, the outermost first (``Usage / Simulation``); of a page only."""
    inside: str = ""
    """Of a command: the folder of the tree that it has to be started in; of what is fetched: the script; of an archive
    for the home and a variable with a place in it: the file of the tree that names or reads it; of a folder of CUDA
    that CMake names: what says little of the version; of what writes code: the folder to start it in; of a script that
    compiles: ``apt`` where it installs packages first."""
    variables: tuple[str, ...] = ()
    """Of a command: the variables that it is started with, ``NAME=VALUE``."""


Runner = Literal["pytest", "unittest", "launch_test"]
"""What starts a file of tests; pytest starts those of unittest too."""


@dataclass(frozen=True, kw_only=True, slots=True)
class TestFile:
    """A file of tests in Python."""

    file: str
    line: int
    runner: Runner


@dataclass(frozen=True, kw_only=True, slots=True)
class Evidence:
    """Everything that was read, sorted by file within each source."""

    manifests: tuple[PackageManifest, ...] = ()
    cmake: tuple[CMakeProject, ...] = ()
    makefiles: tuple[Makefile, ...] = ()
    python: tuple[PythonProject, ...] = ()
    requirements: tuple[RequirementFile, ...] = ()
    conda: tuple[CondaEnvironment, ...] = ()
    locked: tuple[Locked, ...] = ()
    unsafe_hosts: tuple[str, ...] = ()
    """Hosts that build files clone from by ``git://``."""
    dockerfiles: tuple[AuthorDockerfile, ...] = ()
    launch: tuple[LaunchFile, ...] = ()
    programs: tuple[Program, ...] = ()
    notebooks: tuple[str, ...] = ()
    """Notebooks in Python of a tree without other Python at its root, those nearest to the root first."""
    tests: tuple[TestFile, ...] = ()
    code: tuple[Dependency, ...] = ()
    """Includes and imports."""
    prose: tuple[Dependency, ...] = ()
    """What install lines in READMEs and scripts install with apt."""
    prose_pip: tuple[Requirement, ...] = ()
    """What they install with pip and conda."""
    listed: tuple[Requirement, ...] = ()
    """What the pages at the root of a repository without ROS packages list as needed, or name with a version."""
    sources: tuple[GitSource, ...] = ()
    patches: tuple[Patch, ...] = ()
    """Patches of the tree that its author applies to what is cloned."""
    origin: str = ""
    """Where the checkout was cloned from, as git's configuration has it."""
    own_keys: tuple[OwnKey, ...] = ()
    """Keys that the repository defines for rosdep, each once."""
    commented: tuple[GitSource, ...] = ()
    """The repositories whose addresses the code of packages of ROS names."""
    apt_sources: tuple[AptSource, ...] = ()
    mentions: tuple[Mention, ...] = ()
    old_code: tuple[OldCode, ...] = ()
    bounds: tuple[Removed, ...] = ()
    """Upper bounds of Python packages, from removed names that the code uses."""
    limits: tuple[CodeLimit, ...] = ()
    """Versions of compilers and libraries that the C++ code compiles with."""
    listed_releases: tuple[CodeLimit, ...] = ()
    """Of libraries, in lists of what a page requires; they are weaker than what the code shows."""
    cmake_modules: frozenset[str] = frozenset()
    """Names that a file of the tree finds for CMake: ``FindNAME.cmake``, ``NAMEConfig.cmake``."""
    by_variables: frozenset[str] = frozenset()
    """Packages that CMake requires of which ROS has one that the code, using no variable of it, does not find."""
    misnamed: tuple[tuple[str, str], ...] = ()
    """Variables that CMake files use and nothing sets, each with the value that is meant."""
    author_paths: tuple[AuthorPath, ...] = ()
    """Paths of the author's machine that code, CMake, launch files, parameters and worlds name."""
    copies: tuple[str, ...] = ()
    """Folders with packages of somebody else."""
    repositories: tuple[str, ...] = ()
    """Folders that hold a whole repository of packages."""
    cuda_files: tuple[str, ...] = ()
    compiled_files: int = 0
    """Files of C and C++ that are compiled, and definitions of messages, of which code is made that is."""
    x86_only: tuple[X86Only, ...] = ()
    """Each option and each header once for a file, at its first place."""
    beside: WorkspaceFiles = WorkspaceFiles()
    worked_on: tuple[Mention, ...] = ()
    """Days of the repository's commit and of its citation file, in this order."""
    day: str | None = None
    """The day that the image is to be of; ``decide`` sets it."""
    pip_day: str | None = None
    """The day that pip's packages are to be of where the rest of the image is today's; ``decide`` sets it."""
    problems: tuple[tuple[str, str | None, int | None], ...] = ()
    """``(message, file, line)``: what could not be read and was skipped; file and line may be ``None``."""
