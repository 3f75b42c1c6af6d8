"""Where the repository lies in the image, and what is compiled there."""

from __future__ import annotations

import posixpath

from roslab.config.model import Config, Custom, Source
from roslab.decide.decision import Decision, Download
from roslab.plan.own_options import own_options
from roslab.plan.ros_build import ROS_TOOLS, WORKSPACE, RosBuild, ros_build
from roslab.values.dataclass import dataclass, replace

FEWEST_PROGRAMS = 3
"""Fewest programs of which one may be missing."""
FEWEST_KEPT = 10
"""Fewest files for which a cache of what was compiled is worth the package that keeps it."""
MAX_FOLDERS = 24
"""Most folders of programs on PATH beside the build folder itself."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Program:
    """Compiling the repository as a CMake project that is no ROS package."""

    folder: str
    """Of its CMakeLists.txt, relative to the repository's root, ``""`` for the root itself."""
    build: str
    """The folder to compile in: beside the source, for a ``build`` folder that the repository ships is its own; the old
    formats did it inside."""
    arguments: tuple[str, ...]
    cmake_options: tuple[str, ...]
    on_path: bool
    """A program is called by its name."""
    programs: tuple[str, ...] = ()
    """Further folders that hold its programs."""
    compilers: tuple[tuple[str, str], ...] = ()
    """Variables of the environment, each with the compiler that it names if the image has it."""
    install: bool = False
    """It is installed after that, so that others find its libraries and modules."""
    keeps_going: bool = False
    """What does not compile is left out: of many programs of which none is started, or beside the one that is."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Script:
    """A command that compiles something in the repository."""

    folder: str
    """Of the repository, ``""`` for its own."""
    command: str
    required: bool
    """Nothing else is built: what fails stops the build."""
    after: bool = False
    """It needs what the program installs."""
    copies: bool = False
    """It compiles nothing, and copies or writes what is compiled later."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Workspace:
    """The repository's place, and what is compiled."""

    folder: str
    """Of the repository."""
    underlay: bool
    """The base has ROS, whose setup script every shell sources."""
    ros: RosBuild | None
    program: Program | None
    sources: tuple[Source, ...]
    """Sister packages that are cloned into the workspace."""
    submodules: tuple[Source, ...] = ()
    """Submodules that are not checked out: cloned into the repository's folder, each at the path that is its name."""
    apart: tuple[str, ...] = ()
    """Folders of submodules in the repository: the workspace is built without those of their packages that stop it."""
    may_fail: tuple[str, ...] = ()
    """Folders of packages of the repository that are left out where the build fails in them."""
    spare: tuple[str, ...] = ()
    """Folders of those of which some may be left out, for a shell is started and no other package needs them."""
    most_spare: int = 0
    """Most of these that may be left out."""
    interfaces: tuple[str, ...] = ()
    """Messages, services and actions whose headers the code includes and a clone has to hold: ``acme_msgs/Grip``."""
    wanted: tuple[str, ...] = ()
    """Packages that no package.xml names and that CMake or launch files need: the build looks for them, too."""
    must_build: tuple[str, ...] = ()
    """Packages that are never left out: the build stops where one of them fails."""
    large_files: bool = False
    """Git fetches the files of Git LFS of what is cloned; those that are not served stay pointers."""
    inside: tuple[tuple[str, str], ...] = ()
    """Folders of the repository, each with CMake's options, that are compiled where they lie before all else."""
    inside_installed: tuple[str, ...] = ()
    """Those of these folders that are installed, too."""
    scripts: tuple[Script, ...] = ()
    downloads: tuple[Download, ...] = ()
    """Files that are fetched into the repository's folder before its source is copied."""
    python_path: tuple[str, ...] = ()
    """Folders of the repository on PYTHONPATH, ``.`` for its own."""
    variables: tuple[tuple[str, str], ...] = ()
    """Variables of the environment that the build or a launch file reads, each with its value."""
    python_projects: tuple[str, ...]
    unread: tuple[str, ...] = ()
    """Names at the top of the repository that no build file names."""
    written_beside: bool = False
    """CMake writes what runs to the source, or to the user's home: it is compiled where it runs."""
    made_elsewhere: tuple[str, ...] = ()
    """Files and folders of the repository that CMake wrote on another machine: hidden from the build."""
    git_folder: bool = False
    """The code asks git for the repository's folder."""
    clones_day: str = ""
    """The day of what files of CMake clone without a commit, ``""`` for today's."""
    compiler_cache: bool = False
    """What is compiled is kept from one build to the next, file by file."""
    strict: bool = False
    """What is compiled may have warnings count as errors: where one stops it, it is compiled with those that do not."""
    native: bool
    """What is compiled for the processor of the machine that builds is compiled for all processors of a platform."""
    without: tuple[str, ...]
    """Options of the compiler for x86 alone that an image for arm64 is compiled without."""
    links: tuple[tuple[str, str], ...]
    """Name and target of the links that keep the paths of an image in an old format, or that the repository's scripts
    look for."""


def workspace(
    decision: Decision, config: Config, sisters: tuple[Source, ...], name: str, unread: tuple[str, ...] = ()
) -> Workspace:
    """Return what is compiled; ``name`` is the image's, which the repository's folder has too.

    Of the names that are ``unread``, none stays in which a manifest lies.
    """
    python = decision.python
    manifests = (*decision.packages, *python.manifests, *python.requirements, python.conda_file or "")
    copied = {path.partition("/")[0] for path in manifests}
    ros = decision.kind in ("ros1", "ros2")
    in_workspace = decision.workspace != "none" and not (ros and decision.build_tool not in ROS_TOOLS)
    if in_workspace and decision.build_tool == "rosmake" and "manifest.xml" in decision.packages:
        name = decision.package_names[0]  # the folder names the package
    inside = f"{WORKSPACE}/src/{name}" if decision.workspace == "overlay" else WORKSPACE
    folder = inside if in_workspace else name
    links = []
    if config.compatible and (in_workspace or sisters):
        links.append(("catkin_ws", WORKSPACE))
        if in_workspace and name not in (WORKSPACE, "catkin_ws"):
            links.append((name, folder))
    build = ros_build(decision, config, sisters, folder) if ros and (in_workspace or sisters) else None
    if build and folder.startswith(f"{WORKSPACE}/src/") and not config.compatible:
        written = build.setup.removeprefix(f"{WORKSPACE}/").partition("/")[0]
        where = {
            "inside": (f"{folder}/{written}", f"../../{written}"),
            "beside": (f"{WORKSPACE}/src/{written}", f"../{written}"),
        }
        links += [where[place] for place in decision.set_up_links]
    return Workspace(
        folder=folder,
        underlay=ros,
        ros=build,
        program=_program(decision, config, folder) if decision.build_tool == "cmake" else None,
        sources=sisters,
        submodules=decision.submodules,
        apart=decision.apart,
        may_fail=decision.may_fail,
        spare=decision.spare,
        most_spare=decision.most_spare,
        interfaces=decision.interfaces if sisters else (),
        wanted=decision.wanted if sisters and not config.compatible else (),
        must_build=decision.must_build,
        large_files=decision.large_files and bool(sisters or decision.submodules),
        inside=decision.inside if decision.build_tool not in ("pip", "conda") else (),
        inside_installed=decision.inside_installed,
        scripts=tuple(
            Script(
                folder=each.folder,
                command=each.command,
                required=each.required,
                after=each.after,
                copies=each.copies,
            )
            for each in decision.scripts
        ),
        downloads=decision.downloads,
        python_path=decision.python_path,
        variables=decision.variables,
        python_projects=python.projects,
        unread=tuple(each for each in unread if each not in copied),
        git_folder=decision.git_folder and not decision.dockerfile,
        clones_day=decision.clones_day,
        compiler_cache=_keeps(decision, sisters),
        strict=(decision.strict or bool(sisters)) and not config.compatible,
        native=decision.native,
        without=decision.without,
        links=tuple(links),
    )


def _keeps(decision: Decision, sisters: tuple[Source, ...]) -> bool:
    """Tell whether so much is compiled that it is kept; an author who names a launcher of compilers has one."""
    options = (*decision.cmake_options, *(source.cmake_options for source in sisters))
    much = bool(sisters) or decision.compiled_files >= FEWEST_KEPT
    return much and not any("COMPILER_LAUNCHER" in option for option in options)


def custom(config: Config, place: Workspace) -> Custom | None:
    """Return the author's commands with the folder that they start in.

    The generator of the 2019 paper put what is no ROS workspace into the home folder itself.
    """
    found = config.custom
    in_workspace = place.folder.startswith(f"{WORKSPACE}/")
    if found and config.compatible == "paper" and found.workdir == "home" and not in_workspace:
        return replace(found, workdir="source")
    return found


def library(source: Source, config: Config) -> Source:
    """Return a library with the build type that it is compiled with; the old formats gave none."""
    if source.build != "cmake" or config.compatible or "CMAKE_BUILD_TYPE" in source.cmake_options:
        return source
    return replace(source, cmake_options=f"-DCMAKE_BUILD_TYPE=Release {source.cmake_options}".rstrip())


def _program(decision: Decision, config: Config, folder: str) -> Program:
    inside = f"{folder}/{decision.cmake_folder}".rstrip("/")
    sides = {"source": folder, "build": f"{folder}-build", "beside": folder.rpartition("/")[0]}
    written = ((sides[place.partition("/")[0]], place.partition("/")[2]) for place in decision.program_folders)
    programs = tuple(posixpath.join(side, rest) for side, rest in written if rest or side == folder)
    return Program(
        folder=decision.cmake_folder,
        build=f"{inside}/build" if config.compatible else f"{folder}-build",
        arguments=config.build_args,
        cmake_options=own_options(decision, config),
        on_path=not config.compatible and bool(decision.program_folders or not decision.installed),
        programs=() if config.compatible else programs[:MAX_FOLDERS],
        compilers=decision.compilers,
        install=decision.installed and not config.compatible,
        keeps_going=not (decision.installed or config.compatible)
        and ((_many(decision) and not decision.command_named) or _head_may_fail(decision)),
    )


def _head_may_fail(decision: Decision) -> bool:
    """Tell whether the archive of a branch is compiled beside a program of the project that is started, or a shell.

    Of any other command, a script too, nothing tells whether it needs what is left out.
    """
    command = decision.command
    if not decision.downloads_heads or decision.ctest or isinstance(command, str):
        return False
    other = "/" in command[0] or command[0].startswith("python") or command[0] in {"bash", "sh"}
    return command == ("bash",) or not other


def _many(decision: Decision) -> bool:
    """Tell whether there are many programs and a shell is started, for nothing says which one is meant.

    Tests of CMake rest on all that is compiled.
    """
    programs = [argv for argv in decision.command_candidates if len(argv) == 1]
    return decision.command == ("bash",) and not decision.ctest and len(programs) >= FEWEST_PROGRAMS
