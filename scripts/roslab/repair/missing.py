"""What answers a missing module of Python, or a missing program: a folder of the repository, ROS, pip or apt."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import PurePosixPath

from roslab.decide.ros.source_names import for_pip
from roslab.evidence import places
from roslab.explain.answer import Explanation
from roslab.knowledge.frameworks import imports
from roslab.knowledge.python2_packages import system_package
from roslab.knowledge.released import released
from roslab.repair import clones
from roslab.repair.asked import FRAME, here, in_log
from roslab.repair.change import Given, Worked
from roslab.values.dataclass import replace
from roslab.values.home import HOME
from roslab.values.name import canonicalize_name
from roslab.values.pattern import pattern

_INSTALLED = pattern(r"/(?:site|dist)-packages/")
_NO_MODULE = ("setup.py", "package.xml", "CMakeLists.txt")
"""Files of a project's folder, which is no module itself."""


def module(found: Explanation, given: Given) -> Worked:
    """Let Python find a module: in a folder of the repository, else in the package of ROS, apt or pip that holds it."""
    said = dict(found.names).get("module", "")
    top = said.partition(".")[0]
    known = next((name for name in (said, top) if name in imports()), "")
    pip = (imports().get(known) or ("", ""))[0]
    apt = system_package(known, given.plan.ubuntu)
    own = () if _by_another(found, given) else _folders(top, given.files)
    nearest = _nearest(own, found, given)
    if own and (nearest or not known):
        return _own(said, own, nearest, found, given)
    if top in own_packages(given):
        return Worked(why=f"{top} is a package of this repository: it is not built, or its workspace is not sourced")
    if apt and (not pip or _of_system(given)):
        return Worked(key="apt", values=(apt,))
    if _of_system(given) and (package := _released(top, given)):
        return package
    if pip:
        return _installed(top, pip, found, given) or Worked(values=(pip,))
    return _released(top, given) or _named_by_tree(top, given) or Worked(why=found.fix)


def _named_by_tree(module: str, given: Given) -> Worked | None:
    """Return the repository that the tree names for a module: of the workspace of ROS, else one that pip installs."""
    git = clones.named(module, given)
    of_pip = Worked(values=(for_pip(git),)) if git else None
    worked = clones.cloned((module,), given) if given.plan.workspace.ros else of_pip
    return replace(worked, certain=clones.surely(git, given)) if worked and git else worked


def _installed(module: str, package: str, found: Explanation, given: Given) -> Worked | None:
    """Refuse a package that the image installs from a list: another Python is started, which lacks it."""
    if found.step:
        return None
    lists = (each for each in given.evidence.requirements if each.file in given.plan.python.requirements)
    for line in (line for each in lists for line in each.requirements):
        if line.key == canonicalize_name(package) and line.marker is None:
            place = f"{line.file}:{line.line}"
            return Worked(why=f"{package} is installed ({place}), and the Python that is started finds no {module}")
    return None


def program(found: Explanation, given: Given) -> Worked:
    """Install the package of a program, which may be one of ROS that has its name."""
    names = dict(found.names)
    if package := names.get("package", ""):
        return Worked(values=tuple(package.replace(",", " ").split()))
    name = names.get("program", "")
    if is_own(name, given):
        return Worked(why=f"{name} is a program of this repository: it is not built, or its folder is not on PATH")
    return _released(name, given) or Worked(why=found.fix)


def is_own(program: str, given: Given) -> bool:
    """Tell whether a program is one of the repository: a file of it, or made by its CMake."""
    made = (name for project in given.evidence.cmake for name, _ in project.executables)
    return program in made or any(file.rpartition("/")[2] == program for file in given.files)


def own_packages(given: Given) -> frozenset[str]:
    """Return the names of the repository's packages of ROS."""
    return frozenset(manifest.name for manifest in given.evidence.manifests if manifest.name)


def _of_system(given: Given) -> bool:
    """Tell whether what ROS was compiled for has to run with the module: apt's fits, and pip's may not."""
    return bool(given.plan.ros_distro) and given.plan.python.manager == "system"


def _released(name: str, given: Given) -> Worked | None:
    distro = given.plan.ros_distro
    if not distro or name not in released(distro):
        return None
    return Worked(key="apt", values=(f"ros-{distro}-{name.replace('_', '-')}",))


def _folders(module: str, files: Iterable[str]) -> tuple[str, ...]:
    """Return the folders in which Python would find a module, ``.`` for the root; none of tests and documentation."""
    projects: set[str] = set()
    packages: set[str] = set()
    for file in files:
        folder, _, name = file.rpartition("/")
        if name == f"{module}.py":
            packages.add(folder or ".")
        elif folder.rpartition("/")[2] == module:
            if name in _NO_MODULE:
                projects.add(folder)
            elif name.endswith(".py"):
                packages.add(f"{folder.rpartition('/')[0] or '.'}//{folder}")
    found = {each.partition("//")[0] for each in packages if each.partition("//")[2] not in projects}
    kept = (each for each in found if ":" not in each)  # which parts the folders of PYTHONPATH
    return tuple(sorted(each for each in kept if not (places.test(f"{each}/x") or places.documentation(f"{each}/x"))))


def _by_another(found: Explanation, given: Given) -> bool:
    """Tell whether a package from elsewhere imports the module: it means none of the repository."""
    frames = [match["file"] for match in FRAME.finditer(found.log) if not match["file"].startswith("<")]
    return bool(frames) and bool(_INSTALLED.search(frames[-1])) and not here(frames[-1], given.files)


def _nearest(folders: tuple[str, ...], found: Explanation, given: Given) -> str:
    """Return the deepest of the folders that are above the file which the log names last, ``""`` if none is."""
    place = in_log(found, given) if folders else None
    above = [str(each) for each in PurePosixPath(place.file).parents] if place else []
    return next((each for each in above if each in folders), "")


def _own(module: str, folders: tuple[str, ...], nearest: str, found: Explanation, given: Given) -> Worked:
    """Name the folder of a module on PYTHONPATH: the only one, or the nearest above the file that imports it."""
    if found.step:
        return Worked(why=f"{module} lies in {_listed(folders)}: run the step there, or set PYTHONPATH in it")
    if "." in module:
        return Worked(why=f"{module.partition('.')[0]} is found, and has no {module.partition('.')[2]}")
    if not nearest and len(folders) > 1:
        return Worked(why=f"{module} lies in {_listed(folders)}: name one under `env` as PYTHONPATH")
    wanted = (nearest or folders[0], *given.plan.workspace.python_path)
    root = f"{HOME}/{given.plan.workspace.folder}"
    before = dict(given.config.env).get("PYTHONPATH", "")
    paths = dict.fromkeys(f"{root}/{folder}".removesuffix("/.") for folder in wanted)
    return Worked(key="env.PYTHONPATH", values=(":".join((*paths, *([before] if before else []))),))


def _listed(folders: tuple[str, ...]) -> str:
    shown = ("the root" if folder == "." else folder for folder in folders[:5])
    more = len(folders) - 5
    return ", ".join(shown) + (f" and {more} more" if more > 0 else "")
