"""What one CMakeLists.txt tells."""

from __future__ import annotations

from roslab.evidence.dependency import Dependency, GitSource
from roslab.evidence.installed_path import InstalledPath
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class CMakeProject:
    """A CMakeLists.txt."""

    file: str
    line: int
    name: str | None
    top_level: bool
    """It calls ``project()`` and no CMakeLists.txt above it adds its folder."""
    ignored: bool = False
    """It lies in or below a folder with a marker that hides it from the build tools of ROS."""
    added: bool = False
    """A CMakeLists.txt above it, which is not about tests alone, adds its folder."""
    adds: tuple[str, ...] = ()
    """The folders that it adds, whether they are there or not."""
    top: str = ""
    """The folder of the first CMakeLists.txt of those that add it, its own where none does."""
    always: bool = False
    """Those above it add its folder under no condition, from the one that is called first."""
    usual: bool = True
    """So they do in a usual build: under no condition, or where options are on that are on by default."""
    languages: tuple[str, ...]
    macros: tuple[str, ...]
    """Macro families that it calls: ``catkin``, ``ament``, ``rosbuild``, ``cuda``."""
    cuda: bool = False
    """It needs the compiler of CUDA under no condition."""
    executables: tuple[tuple[str, int], ...]
    """Programs of ``add_executable`` and similar calls by the names of their files, with their lines."""
    dependencies: tuple[Dependency, ...]
    programs: tuple[Dependency, ...] = ()
    """Programs that it looks for and stops without."""
    bare: tuple[Dependency, ...] = ()
    """Libraries that it always links by names which nothing of the tree makes or finds, and no table has."""
    sources: tuple[GitSource, ...] = ()
    brought: tuple[str, ...] = ()
    """Names that what it fetches by itself may have, with the parts of the addresses."""
    minimum: Dependency | None = None
    """The CMake version that ``cmake_minimum_required`` asks for, as ``version``."""
    newer: tuple[Dependency, ...] = ()
    """What it always calls and only later releases of CMake have, each with the first of them as ``version``.

    ``CMake`` is the highest ``cmake_minimum_required`` after the first one, and of what it includes.
    """
    tests: bool = False
    """It has tests for ctest."""
    untested: tuple[str, ...] = ()
    """Options that are off, without which none of them is made."""
    programs_in: str | None = None
    """The folder that programs are written to; ``None`` if the file names none. ``source/…`` is relative to the root of
    the repository, ``top/…`` to the folder of the top-level CMakeLists.txt, ``build/…`` to the build folder."""
    placed: tuple[tuple[str, str], ...] = ()
    """Programs that are written to another folder than most, each with it."""
    in_bin: tuple[str, ...] = ()
    """Programs that it always installs into ``bin``, and nowhere else."""
    made: tuple[str, ...] = ()
    """Libraries that are targets of it, but for imported ones."""
    installs: tuple[str, ...] = ()
    """Those of them that it always installs."""
    targets: tuple[str, ...] = ()
    """Programs and libraries that are always targets of it, as CMake calls them."""
    not_there: tuple[InstalledPath, ...] = ()
    """What it installs in any case and the tree does not have, and which none of its other lines may make."""
    configs: tuple[str, ...] = ()
    """Packages that find_package finds once it is installed: ``gripper`` of ``gripper-config.cmake``."""
    linked: tuple[tuple[str, int], ...] = ()
    """Files of libraries below the source that it links and that are not there, as written, each with its line."""
    lost: tuple[tuple[str, int], ...] = ()
    """Paths of libraries in the tree that it always links and that are not there, each with its line."""
    lacks: bool = False
    """None of the files of code that its programs, else its libraries name is there: it cannot be built by itself."""
    without: tuple[tuple[str, int], ...] = ()
    """Of these the ones that are not there and that it names in any case, each with its line: CMake stops at them."""
    lacking: tuple[tuple[str, str, int], ...] = ()
    """Options, on by themselves, for which it compiles a file that is not there, each with that file and its line."""
    parts: tuple[tuple[str, int], ...] = ()
    """Folders and files of its author's computer that it adds, includes or links in any case, each with its line."""
    absent: tuple[tuple[str, int], ...] = ()
    """The first folder of the tree that it adds in any case and that is not there, with its line: CMake stops at it."""
    guards: tuple[tuple[str, str], ...] = ()
    """Programs that are built only where a package was found, each with the package's name in lower case."""
    optional: tuple[tuple[str, str], ...] = ()
    """Programs that are built only where a variable is set, each with it; ``OFF NAME`` for an option that is not."""
    settled: tuple[str, ...] = ()
    """Variables among these that a file of CMake sets itself."""
    outside: tuple[tuple[str, int], ...] = ()
    """Programs that a workspace of ROS 1 or 2 does not make, by conditions of the build tool, each with that ROS."""
    without_options: tuple[tuple[str, int, str], ...] = ()
    """Programs that it makes there only where an option is off, each with that ROS and the option."""
