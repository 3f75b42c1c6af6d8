"""Rung 0: the declared packages are there, and what was compiled finds its libraries."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.decision import Decision
from roslab.knowledge.accelerated import accelerated
from roslab.knowledge.distros import python_of_ubuntu
from roslab.knowledge.frameworks import imports
from roslab.knowledge.guesses import same_module
from roslab.knowledge.not_importable import importable_below, importable_with_display
from roslab.plan.compiled import compiled
from roslab.plan.proof import Proof
from roslab.plan.ros_build import ROS_TOOLS, WORKSPACE
from roslab.plan.run import WORKSPACES
from roslab.plan.workspace import Workspace
from roslab.values.dataclass import replace
from roslab.values.interpreter import Interpreter
from roslab.values.name import canonicalize_name
from roslab.values.requirement import Requirement
from roslab.values.version import Version

IMPORT_SCRIPT = """\
import importlib, importlib.util, subprocess, sys
try:
    import importlib.metadata as metadata
except ImportError:
    sys.exit(max(subprocess.call([sys.executable, "-m", "pip", "show", name]) for name in sys.argv[1:]))
names, failed = sys.argv[1:], {}
for name in names:
    try:
        distribution = metadata.distribution(name)
    except metadata.PackageNotFoundError:
        failed[name] = "not installed"
        continue
    listed = (distribution.read_text("top_level.txt") or "").split()
    packages = {str(f).split("/")[0] for f in distribution.files or () if str(f).endswith("/__init__.py")}
    modules = [each for each in listed or sorted(packages) if each.isidentifier() and each[0] != "_"]
    modules = [each for each in modules if each not in ("docs", "examples", "test", "tests")]
    there = [each for each in modules if not listed or each in sys.modules or importlib.util.find_spec(each)]
    own = name.lower().replace("-", "_").replace(".", "_")
    beside = own in [each.lower() for each in there]
    for module in there or modules:
        try:
            importlib.import_module(module)
        except Exception as error:
            why = f"import {module}: {type(error).__name__}: {error}"
            if beside and module.lower() != own and isinstance(error, ImportError):
                print(f"{name} is there, and a module beside it does not import: {why}")
            else:
                failed[name] = why
print("imported", len(names) - len(failed), "of", len(names), "packages")
sys.exit("\\n".join(f"{name}: {why}" for name, why in failed.items()) or 0)
"""
"""A package and its module may have different names (``opencv-python``, ``cv2``): the package's files tell.

A list that was made where the package was built may name folders that were never installed: the list of Debian
12's python3-setuptools has ``debian``. A package none of whose modules is there has failed. One with a module of its
own name may have others that need one of its extras: black's ``blackd`` imports aiohttp. That is told.
"""

SHOW_SCRIPT = """\
import subprocess, sys
try:
    from importlib import metadata
except ImportError:
    metadata = None
def there(name):
    if metadata is None:
        return subprocess.call([sys.executable, "-m", "pip", "show", name]) == 0
    return any(True for _ in metadata.Distribution.discover(name=name))
missing = [name for name in sys.argv[1:] if not there(name)]
print("installed: %d of %d packages" % (len(sys.argv) - 1 - len(missing), len(sys.argv) - 1))
sys.exit("\\n".join("not installed: " + name for name in missing) or 0)
"""
"""For any Python, 2 as well. ``pip show`` of several packages ends with 0 where one of them is there:
https://github.com/pypa/pip/blob/main/src/pip/_internal/commands/show.py, 2026-11-29.
"""

FIND_SCRIPT = """\
import importlib.util, sys
missing = [name for name in sys.argv[1:] if importlib.util.find_spec(name) is None]
print("found", len(sys.argv) - 1 - len(missing), "of", len(sys.argv) - 1, "modules")
sys.exit("\\n".join("no module " + name for name in missing) or 0)
"""
"""They are not imported: some need a GPU for that."""

AMENT_SCRIPT = """\
import os, sys
prefixes = [prefix for prefix in os.environ.get("AMENT_PREFIX_PATH", "").split(":") if prefix]
spaces = sorted({os.path.dirname(prefix) for prefix in prefixes})
def empty(name):
    for top in (os.path.join(space, name) for space in spaces):
        if os.path.exists(os.path.join(top, "share", "colcon-core", "packages", name)):
            files = {os.path.relpath(os.path.join(at, file), top) for at, _, here in os.walk(top) for file in here}
            told = (f"share/{name}/hook/", f"share/{name}/package.", "share/colcon-core/")
            return f"share/{name}/package.xml" not in files and all(file.startswith(told) for file in files)
    return False
found, nothing, failed = [], [], []
for name in sys.argv[1:]:
    marker = os.path.join("share", "ament_index", "resource_index", "packages", name)
    place = next((prefix for prefix in prefixes if os.path.exists(os.path.join(prefix, marker))), None)
    (found if place else nothing if empty(name) else failed).append(name)
    print(name, "in", place or "none of AMENT_PREFIX_PATH")
if nothing:
    print("packages that were built and install nothing:", *nothing)
sys.exit(1 if failed or not found else 0)
"""
"""The index that ``ros2 pkg`` and ament_index_python read; a base without ros2cli has it too.
https://github.com/ament/ament_cmake/blob/rolling/ament_cmake_core/doc/resource_index.md

A package whose CMakeLists.txt returns early, where something optional is absent, is built and installs nothing: colcon
then leaves its own files alone below the package's prefix. https://colcon.readthedocs.io/en/released/user/isolated-vs-merged-workspaces.html
"""

LIBRARIES_SCRIPT = """\
export LC_ALL=C
programs=0 failed=0
while IFS= read -r -d '' file; do
  IFS= read -r -N 4 magic <"$file"
  [ "$magic" = $'\\x7fELF' ] || continue
  programs=$((programs + 1))
  if missing=$(ldd "$file" 2>/dev/null | grep 'not found'); then printf '%s:\\n%s\\n' "$file" "$missing"; failed=1; fi
done < <(
  for folder in "$@"; do
    case $folder in /opt/ros/* | '') ;; *) find -L "$folder" -name CMakeFiles -prune -o -type f -perm -u+x \
      ! -name '*.so*' -print0 ;; esac
  done 2>/dev/null | sort -zu
)
echo "programs looked at: $programs"
exit $failed
"""
"""``ldd`` only asks the loader, and starts none of them; libraries may be plug-ins, whose programs find theirs."""
PREFIXES = "IFS=:; set -f; set -- $CMAKE_PREFIX_PATH $AMENT_PREFIX_PATH; unset IFS; set +f\n"
"""Where the workspaces that the environment knows have their programs."""


def installed(decision: Decision, place: Workspace) -> list[Proof]:
    """Return the proofs of rung 0; nothing depends on those of an author's Dockerfile, which may install less."""
    own = decision.dockerfile is not None
    found = _workspace_proofs(decision, own=own)
    version = None if own else decision.python.version or python_of_ubuntu().get(decision.ubuntu or "")
    distributions = _declared_distributions(decision, version)
    without = [name for name in distributions if _caught(name, decision.command_imports.caught)]
    if imported := [name for name in distributions if name not in without]:
        found.append(_import_proof(version, imported))
    if without:
        name = "declared Python packages that the code can do without are installed"
        found.append(Proof(name=name, command=(_python(version), "-c", SHOW_SCRIPT, *without)))
    if decision.command_imports.required and not (version or "").startswith("2"):
        found.append(
            Proof(
                name="the default command finds the modules of its imports",
                command=("python3", "-c", FIND_SCRIPT, *decision.command_imports.required),
            )
        )
    on_python2 = Interpreter(pythons=("2.7",), platforms=decision.platforms)
    if beside := _names(decision.python.python2, on_python2):
        command = ("python2", "-c", SHOW_SCRIPT, *beside)
        found.append(Proof(name="declared packages of Python 2 are installed", command=command))
    if decision.compiles:
        found += _libraries(decision, place, own=own)
    sure = [replace(proof, rung=0, required=not own, entrypoint=not own) for proof in found]
    # Told alone: which programs need an extension nobody knows, and one that the command needs keeps it from starting
    told = [*compiled(decision, place), *([] if own else _reached(decision, version))]
    return [*sure, *(replace(proof, rung=0, required=False) for proof in told)]


def _reached(decision: Decision, version: str | None) -> list[Proof]:
    """Return the proof that the guesses which the command's files import are there: each is left out if pip fails."""
    if not decision.command_imports.tried or (version or "").startswith("2"):
        return []
    name = "the default command finds what its files import"
    return [Proof(name=name, command=("python3", "-c", FIND_SCRIPT, *decision.command_imports.tried))]


def _libraries(decision: Decision, place: Workspace, *, own: bool) -> list[Proof]:
    """Return the proof that programs which were compiled find their libraries, none where their place is unknown."""
    name = "the compiled programs find their libraries"
    if _in_workspace(decision) and decision.build_tool == "rosmake":
        return [_in_bash(name, "cd && " + LIBRARIES_SCRIPT, f"{WORKSPACE}/src")]
    if _in_workspace(decision):
        return [_in_bash(name, PREFIXES + LIBRARIES_SCRIPT, own=own)]
    if place.program and not own:
        folders = (place.program.build, *place.program.programs)
        return [_in_bash(name, "cd && " + LIBRARIES_SCRIPT, *dict.fromkeys(folders))]
    return []


def _in_bash(name: str, script: str, *arguments: str, own: bool = False) -> Proof:
    return Proof(name=name, command=("bash", "-c", (WORKSPACES if own else "") + script, "proof", *arguments))


def _in_workspace(decision: Decision) -> bool:
    """Tell whether the repository is a package of a ROS workspace, or holds some."""
    return (
        decision.kind in ("ros1", "ros2")
        and decision.build_tool in ROS_TOOLS
        and (decision.workspace != "none" or decision.dockerfile is not None)
    )


def _workspace_proofs(decision: Decision, *, own: bool) -> list[Proof]:
    if not decision.package_names or not _in_workspace(decision):
        return []
    name = "the workspace's packages are found"
    if decision.kind == "ros1":
        script = 'failed=0; for package in "$@"; do rospack find "$package" || failed=1; done; exit $failed'
        return [_in_bash(name, script, *decision.package_names, own=own)]
    if own:
        return [_in_bash(name, 'exec python3 -c "$@"', AMENT_SCRIPT, *decision.package_names, own=True)]
    return [Proof(name=name, command=("python3", "-c", AMENT_SCRIPT, *decision.package_names))]


def _import_proof(version: str | None, distributions: list[str]) -> Proof:
    if version and Version(version) < Version("3.8"):
        # No importlib.metadata before 3.8: which modules a package has is not known
        command = (_python(version), "-c", SHOW_SCRIPT, *distributions)
        return Proof(name="declared Python packages are installed", command=command)
    return Proof(name="declared Python packages import", command=("python3", "-c", IMPORT_SCRIPT, *distributions))


def _python(version: str | None) -> str:
    return "python2" if (version or "").startswith("2") else "python3"


def _caught(distribution: str, modules: Iterable[str]) -> bool:
    """Tell whether the code goes on without a package, no framework: it may need a device that is not there."""
    name = canonicalize_name(distribution)
    if name in accelerated():
        return False
    found = (canonicalize_name((imports().get(module) or (None, None))[0] or module) for module in modules)
    return any(name == each or same_module(name, each) for each in found)


def _declared_distributions(decision: Decision, version: str | None) -> list[str]:
    """Return the declared packages, without guesses and without conda packages, which have names of their own.

    Without what is only tried, too, and what this ``version`` of Python, or no Python without a display, can import,
    whoever declared it.
    """
    python = decision.python
    others = {*python.pip_guessed, *python.python2} - {*python.pip}
    others |= {*python.pip_tried}
    others |= {each for each in decision.pip if each.key in importable_with_display()}
    if version:
        ended = {name for name, since in importable_below().items() if Version(version) >= since}
        others |= {each for each in decision.pip if each.key in ended}
    asked = python.pip if python.manager == "conda" else decision.pip
    return _names((each for each in asked if each not in others), python.interpreter.on(*decision.platforms))


def _names(asked: Iterable[Requirement], image: Interpreter) -> list[str]:
    """Return the packages that pip installs on every platform: the same proof runs on all of them.

    Bare URLs are left out: the name was only guessed from the URL.
    """
    return sorted({each.name for each in asked if each.package and each.name and not each.url and image.must(each)})
