"""What a compiler must be told where the code does not fit it: a header that it no longer brings along, a standard."""

from __future__ import annotations

from roslab.explain.answer import Explanation
from roslab.knowledge.code_limits import limits
from roslab.knowledge.newer_compilers import newer_compiler
from roslab.repair.change import Given, Worked
from roslab.values.pattern import pattern
from roslab.values.version import Version

_LIBRARIES = "-DCMAKE_CXX_STANDARD_LIBRARIES="
_LIBRARIES_OF_C = "-DCMAKE_C_STANDARD_LIBRARIES="
"""What all programs are linked with: https://cmake.org/cmake/help/latest/variable/CMAKE_LANG_STANDARD_LIBRARIES.html."""
_LINKED = "-Wl,"
"""It keeps several libraries one word; Ubuntu's linker leaves out what a program does not use."""
_OF_SYSTEM = pattern(r"(?:/usr)?/{1,2}lib/(?:\w{1,20}-linux-gnu/)?lib[\w+-]{1,60}\.so")
_OF_ROS = pattern(r"/opt/ros/[a-z]{4,9}/lib/(?:\w{1,20}-linux-gnu/)?lib[\w+-]{1,60}\.so$")
_AS_ERROR = pattern(
    r"(?m)^(?P<file>[^\s:]{1,300}):\d{1,6}:(?:\d{1,6}:)? error: [^\n]{1,1000} "
    r"\[-W(?:error[=,](?:-W)?(?P<name>\w[\w+=-]{0,50})|(?P<other>\w[\w+-]{0,40}),-Werror)\]"
)
_CXX_FLAGS = "-DCMAKE_CXX_FLAGS="
"""The option that is planned for flags; it is none where they stand in the variable, so that it takes them over."""


def flags(found: Explanation, given: Given) -> Worked:
    """Compile with the flag that answers an error, behind those that the plan or somebody gives."""
    names = dict(found.names)
    key, flag = names.get("setting", "env.CXXFLAGS"), names.get("flag", "")
    header = names.get("header", "")
    if not flag and header and not header.endswith(".h"):  # one of C++, which gcc names and brings
        flag = f"-include {header}"
    if not flag:
        return Worked(why=found.fix)
    if not key.startswith("env."):
        return Worked(key=key, values=(flag,))
    if (library := _library_of(flag)) and not _includes(library, given):
        return Worked(why=f"no code of the repository includes {library}, which may not be installed: {found.fix}")
    before = compiler_flags(key.partition(".")[2], given)
    if flag in before:
        return Worked(why=f"it is compiled with {flag} already, and that did not help")
    return Worked(key=key, values=(f"{before} {flag}".strip(),))


def compiler(found: Explanation, given: Given) -> Worked:
    """Install the oldest GCC that knows the standard, or has the header, which the one of the image does not know."""
    names, ubuntu = dict(found.names), given.plan.ubuntu
    signs = ("include",) if "header" in names else ("option", "standard")
    said = names.get("header") or names.get("standard", "")
    known = (limit for limit in limits() if limit.where in signs and limit.library == "GCC")
    fitting = [limit.at_least for limit in known if limit.at_least and limit.pattern.search(said)]
    needed = max(fitting, key=Version, default=None)
    newer = newer_compiler(ubuntu, needed) if needed and ubuntu else None
    if newer is None or given.plan.kind == "cuda":
        return Worked(why=found.fix)
    return Worked(values=(f"g++-{newer}",))


def not_errors(found: Explanation, given: Given) -> Worked:
    """Let the warnings that stopped a compilation be warnings: what names one outweighs a bare -Werror behind it."""
    said = list(_AS_ERROR.finditer(found.log))
    in_c = bool(said) and said[0]["file"].endswith(".c")
    same = (match for match in said if match["file"].endswith(".c") == in_c)
    names = dict.fromkeys((match["name"] or match["other"]).removesuffix("=") for match in same)
    variable = "CFLAGS" if in_c else "CXXFLAGS"
    before = compiler_flags(variable, given)
    new = [flag for name in names if (flag := f"-Wno-error={name}") not in before.split()]
    if not new:
        return Worked(why=f"it is compiled so already, and that did not help: {found.fix}" if said else found.fix)
    return Worked(key=f"env.{variable}", values=(" ".join((before, *new)).strip(),))


def _library_of(flag: str) -> str:
    """Return the folder of a library's header that each file would include: where it is not there, all would stop."""
    header = flag.removeprefix("-include ")
    return header.partition("/")[0] if header != flag and "/" in header else ""


def _includes(library: str, given: Given) -> bool:
    return any(each.namespace == "include" and each.name.startswith(f"{library}/") for each in given.evidence.code)


def linked(found: Explanation, given: Given) -> Worked:
    """Link every program with the library whose name the linker says, or which holds what is the system's own.

    One of the system by its name, one of ROS by its path, both are there before anything is compiled; not one that the
    build makes itself.
    """
    names = dict(found.names)
    path, library = names.get("path", ""), names.get("link") or names.get("library", "")
    said = f"-l{library}" if names.get("link") or _OF_SYSTEM.match(path) else path if _OF_ROS.match(path) else ""
    before = _linked(_LIBRARIES, given)
    if not said or before is None:
        return Worked(why=found.fix)
    if said in before:
        return Worked(why=f"{said} is linked already, and that did not help")
    of_c = _linked(_LIBRARIES_OF_C, given)
    also = (f"{_LIBRARIES_OF_C}{_LINKED}{','.join((*of_c, said))}",) if names.get("link") and of_c is not None else ()
    return Worked(values=(f"{_LIBRARIES}{_LINKED}{','.join((*before, said))}", *also))


def _linked(option: str, given: Given) -> list[str] | None:
    """Return the libraries that a repair before this one links, ``None`` where somebody gives the option himself."""
    words = [word.removeprefix(option) for word in given.config.cmake_options.split() if word.startswith(option)]
    if words and not words[-1].startswith(_LINKED):
        return None
    return words[-1].split(",")[1:] if words else []


def compiler_flags(variable: str, given: Given) -> str:
    """Return the flags of a variable that compilers take: those under ``env``, else those of the plan."""
    said = dict(given.config.env).get(variable)
    if said is not None:
        return said
    place = given.plan.workspace
    options = (place.ros.cmake_options if place.ros else ()) + (place.program.cmake_options if place.program else ())
    of_cmake = [word.removeprefix(_CXX_FLAGS) for word in options if word.startswith(_CXX_FLAGS)]
    planned = dict(place.variables).get(variable, "")
    return " ".join((planned, *(of_cmake if variable == "CXXFLAGS" else ()))).strip()
