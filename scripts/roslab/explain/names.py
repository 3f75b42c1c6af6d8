"""Finds the package for a name in a log, with the tables of ``knowledge``.

A lookup takes the captured names and what is known about the image, and returns further names for the sentences of a
failure; ``{}`` if no table has the name.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from functools import partial

from roslab.explain import cmake_age, ros_names, worked
from roslab.knowledge import libraries
from roslab.knowledge.distros import distro, ubuntus
from roslab.knowledge.failures import compiled
from roslab.knowledge.latex import latex
from roslab.knowledge.os_releases import moved_to
from roslab.knowledge.table import rows
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

Names = dict[str, str]


@dataclass(frozen=True, kw_only=True, slots=True)
class Image:
    """What a log shows about the image that was built."""

    ubuntu: str | None = None
    ros: str | None = None
    instruction: str = ""


_CODENAMES = "|".join(sorted(ubuntus().values()))
_UBUNTU = pattern(
    rf"(?:ubuntu(?:-ports)?/?(?:/dists/|\s)|ubuntu:|-)({_CODENAMES})\b|ubuntu:?-?(\d\d\.\d\d)\b|ubuntu(\d\d)(\d\d)\b"
)
_ROS = pattern(r"\bros:([a-z]{4,9})\b|/opt/ros/([a-z]{4,9})\b|\bros-([a-z]{4,9})-[a-z]")


def image(text: str, instruction: str) -> Image:
    """Return the Ubuntu and ROS distribution of an image, as far as the text of its log shows them."""
    release = None
    if found := _UBUNTU.search(text):
        version = found[2] or (f"{found[3]}.{found[4]}" if found[3] else "")
        release = found[1] or ubuntus().get(version)
    named = (name for match in _ROS.finditer(text) for name in match.groups() if name)
    ros = next((name for name in named if distro(name)), None)
    known = distro(ros)
    return Image(ubuntu=release or (known.ubuntu if known else None), ros=ros, instruction=instruction)


def _release(names: Names, _: Image) -> Names:
    found = moved_to(names.get("codename", ""))
    return {"release": found[0], "archive": found[1]} if found else {}


def _renamed(names: Names, _: Image) -> Names:
    table = {row["name"]: row for row in rows("apt_names")}
    known = [table[name] for name in names.get("name", "").split(", ") if name in table]
    notes = dict.fromkeys(row["note"] for row in known if row["note"])
    if not known:
        return {}
    named = ", ".join(row["name"] for row in known)
    return {"name": named, "package": ", ".join(dict.fromkeys(row["now"] for row in known)), "note": " ".join(notes)}


def _table(name: str, key: str, value: str, captured: str) -> Callable[[Names, Image], Names]:
    def look(names: Names, _: Image) -> Names:
        word = names.get(captured, "").rpartition("/")[2] if captured != "module" else names.get(captured, "")
        for wanted in (word, word.split(".")[0]) if captured == "module" else (word, word.lower()):
            found = next((row[value] for row in rows(name) if row[key] == wanted), "")
            if found:
                return {"package": found}
        return {}

    return look


def _library(naming: libraries.Naming, captured: str) -> Callable[[Names, Image], Names]:
    def look(names: Names, where: Image) -> Names:
        packages: dict[str, None] = {}
        for name in names.get(captured, "").split(", "):
            found = _of_any(partial(libraries.header, name), where.ubuntu) if naming == "include" else None
            if naming != "include":
                spellings = (name, name.removeprefix("lib"), name.lower(), name.capitalize(), f"lib{name}")
                known = (_of_any(partial(libraries.library, naming, each), where.ubuntu) for each in spellings)
                found = next((library for library in known if library is not None), None)
            if found is not None:
                packages.update(dict.fromkeys(_packages(found, where)))
            if naming == "include" and not packages:
                of_it = (row for row in rows("headers") if row["header"] == name)
                packages.update((row["apt"], None) for row in of_it if not where.ubuntu or not row["ubuntu"])
        low = {"low": names.get(captured, "").lower()}
        return {"package": " ".join(packages), **low} if packages else low

    return look


def _component(names: Names, where: Image) -> Names:
    """Name the package of a part that is a package of CMake by itself, as those of Qt are: ``Qt5OpenGL``."""
    name, part = names.get("name", ""), names.get("component", "")
    of_qt = ("Qt6", "Qt5") if name == "Qt" else (name,)
    found = (_library("cmake", "name")({"name": f"{each}{part}"}, where).get("package", "") for each in of_qt)
    package = next((each for each in found if each), "")
    return {"package": package} if package else {}


def _of_any(look: Callable[[str | None], libraries.Library | None], ubuntu: str | None) -> libraries.Library | None:
    """Return where a library comes from; where the log does not show the Ubuntu, what all that have it agree on."""
    found = look(ubuntu)
    if ubuntu is not None or found is None or found.apt or found.recipe:
        return found
    each = {library.apt for one in ubuntus().values() if (library := look(one))} - {()}
    return libraries.Library(apt=each.pop(), ros=found.ros) if len(each) == 1 else found


def _packages(found: libraries.Library, where: Image) -> tuple[str, ...]:
    if found.ros and where.ros:
        return (f"ros-{where.ros}-{found.ros.replace('_', '-')}",)
    return found.apt


def _api(names: Names, _: Image) -> Names:
    """Name the change that the first of several errors tells of: those after it most often follow from it.

    Where a header says that the code is compiled with too old a standard, only a change that tells of one counts.
    """
    said = names.get("text", "")
    found = [(match.start(), row) for row in rows("api_changes") if (match := compiled(row["pattern"]).search(said))]
    row = min(found, key=lambda each: each[0])[1] if found else None
    if row is None or (names.get("standard") and "C++" not in row["why"]):
        return {}
    flag = {"setting": row["key"], "flag": row["value"]} if row["key"] else {}
    return {"why": row["why"], "repair_words": row["fix"], **flag}


def _since_go(names: Names, _: Image) -> Names:
    """Name the first Go whose standard library has a symbol."""
    said = names.get("symbol", "")
    row = next((row for row in rows("go_since") if compiled(row["symbol"]).fullmatch(said)), None)
    return {"needs": f">={row['go']}"} if row else {}


def _older_gem(names: Names, _: Image) -> Names:
    """Name the last version of a gem before one that needs a newer Ruby, unless the log does."""
    if names.get("hint"):
        return {"hint": names["hint"].removeprefix(f"gem install {names.get('name', '')} -v ").strip("'")}
    for row in rows("older_gems"):
        if row["gem"] == names.get("name") and row["needs"] == names.get("needs", "").replace(" ", ""):
            return {"hint": row["version"]}
    return {}


_SPACE = pattern(r"(?<![\w:])(?!std::|__gnu_cxx::|internal::)([A-Za-z_]\w{0,60})::")


def _namespace(names: Names, where: Image) -> Names:
    """Name the library of a namespace or type: its own namespace, or, of one of std, that of what it is made with."""
    space = names.get("space", "") or names.get("type", "")
    if found := _SPACE.search(space):
        return {"library": found[1], "space": space}
    if space.partition("::")[0].rpartition(" ")[2].startswith("std"):
        return {**_built_with(names, where), "space": space}
    return {"library": space if names.get("space") else f"what declares {space}", "space": space}


_OF_CLASS = pattern(r"^(?:typeinfo|vtable|VTT|non-virtual thunk) (?:for|to) ")


def _symbol(names: Names, _: Image) -> Names:
    """Name the library of the first symbol that is missing, by its namespace or prefix: of a table, else a ROS package.

    Of ``typeinfo for`` a class, the class decides, and only that of no known library is the project's own.
    """
    symbol = names.get("symbol", "")
    of_class = _OF_CLASS.sub("", symbol)
    return _of_symbols(of_class) or _of_ros(of_class) or _of_symbols(symbol)


def _of_symbols(symbol: str) -> Names:
    for row in rows("symbols"):
        if compiled(row["pattern"]).match(symbol):
            link = {"link": row["link"]} if row["link"] else {}
            return {"library": row["library"], "how": row["how"], **link}
    return {}


def _of_ros(symbol: str) -> Names:
    """Name the ROS package that has the name of a symbol's namespace, where that is no plain word."""
    space = _SPACE.match(symbol)
    known = ros_names.known({"name": space[1]}, None) if space and "_" in space[1] else {}
    return {"library": f"the ROS package {known['name']}", "how": known["name"]} if known else {}


_INCLUDED = pattern(r"/(?:include|site-packages|dist-packages|pkg/mod/[\w.]{1,60})/([\w.+-]{2,60})/")


def _built_with(names: Names, where: Image) -> Names:
    """Name what a compiled file belongs to: the library of a header, else the folder that the step builds in."""
    file, said = names.get("file", ""), _SPACE.search(names.get("symbol", "") or names.get("why", ""))
    found = (said if "/src/" in file else None) or _INCLUDED.search(file) or said
    if found:
        return {"library": found[1]}
    folder = re.search(r"\bcd ([\w./$-]{2,200})", where.instruction)
    return {"library": f"what it is built against (in {folder[1]})" if folder else "what it is built against"}


_ACCOUNT = pattern(r"(?i)(?:^|_)(?:uid|gid|user_?id|group_?id)$")
"""Arguments for the number of a user or a group; of the first user of a machine, both are 1000."""
_SECRET = pattern(r"(?i)key|token|licen[cs]e|secret|pass|user|auth|credential")
_VARIABLE = pattern(r"\$\{?([A-Za-z_]\w{1,60})")


_ADDRESS = pattern(r"(?:https?|ftp)://[^\s'\"]{1,300}")


def _argument(names: Names, where: Image) -> Names:
    within = " ".join(_ADDRESS.findall(where.instruction)) if names.get("address") else ""
    found = _VARIABLE.findall(within) or _VARIABLE.findall(where.instruction)
    if package := names.get("package"):
        beside = re.search(rf"{re.escape(package)}={{1,2}}['\"]?\$\{{?(\w{{1,60}})", where.instruction)
        found = [beside[1]] if beside else found
    name = names.get("name") or next(iter(found), "")
    return ({"name": name} | ({"account": name} if _ACCOUNT.search(name) else {})) if name else {}


def _secret(_: Names, where: Image) -> Names:
    """Name the variable of an instruction that contains a key, not the one that contains an address."""
    found = [name for name in _VARIABLE.findall(where.instruction) if _SECRET.search(name)]
    return {"name": found[0]} if found else {}


def _hidden(names: Names, _: Image) -> Names:
    cuda = re.search(r"CUDA|nvcc", names.get("line", ""))
    return {"hint": "For CUDA, start FROM a -devel tag of nvidia/cuda." if cuda else ""}


def _advice(names: Names, _: Image) -> Names:
    name = (names.get("package") or names.get("tool") or "").lower().replace("_", "-")
    return {"advice": next((row["advice"] for row in rows("package_advice") if row["package"] == name), "")}


LOOKUPS: Mapping[str, Callable[[Names, Image], Names]] = {
    "release": _release,
    "apt": _renamed,
    "advice": _advice,
    "api": _api,
    "argument": _argument,
    "cmake-command": lambda names, _: worked.cmake_command(names),
    "cmake": _library("cmake", "name"),
    "cmake-since": lambda names, _: cmake_age.since(names),
    "conflict": lambda names, where: worked.conflict(names, where.instruction),
    "apk": lambda names, _: worked.apk(names),
    "backend": lambda names, _: worked.backend(names),
    "component": _component,
    "cuda-architecture": lambda names, _: worked.cuda_architecture(names),
    "cuda-image": lambda names, _: worked.cuda_image(names),
    "image-moved": lambda names, _: worked.moved_image(names),
    "dropped": lambda names, _: worked.dropped(names),
    "emptied": lambda names, where: worked.emptied(names, where.instruction),
    "header": _library("include", "header"),
    "go-since": _since_go,
    "hidden": _hidden,
    "ignored": lambda names, _: worked.ignored(names),
    "include-path": _built_with,
    "latex": lambda _names, _where: {"package": " ".join(latex())},
    "link": _library("link", "library"),
    "moved": lambda names, where: worked.moved(names, where.instruction),
    "locals": lambda _names, _where: {"what": "local names that exec changes", "last": "3.12"},
    "mistaken": lambda names, _: worked.mistaken(names),
    "module": _table("imports", "module", "pip", "module"),
    "namespace": _namespace,
    "older-gem": _older_gem,
    "pkg-config": _library("pkg-config", "module"),
    "python-end": lambda names, _: worked.python_end(names),
    "program": _table("programs", "program", "apt", "program"),
    "ros": lambda names, where: ros_names.package(names, where.ros, where.ubuntu),
    "ros-dropped": lambda names, where: ros_names.dropped(names, where.ros),
    "ros-elsewhere": lambda names, where: ros_names.elsewhere(names, where.ros),
    "ros-header": lambda names, where: ros_names.header(names, where.ros, where.ubuntu),
    "ros-library": lambda names, where: ros_names.known(names, where.ros),
    "ros-module": lambda names, where: ros_names.module(names, where.ros),
    "secret": _secret,
    "symbol": _symbol,
    "shared": _table("shared_objects", "library", "apt", "library"),
}
