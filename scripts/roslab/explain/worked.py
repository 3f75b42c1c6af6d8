"""Names that are worked out from a failed instruction and its lines together, without a table of packages."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache

from roslab.knowledge.distros import ubuntus
from roslab.knowledge.failures import compiled
from roslab.knowledge.table import rows
from roslab.values.pattern import pattern
from roslab.values.specifier import specifiers

_WORD = pattern(r"[^\s;&|()<>'\"]{0,200}\$\{?[A-Za-z_]\w{0,60}\}?[^\s;&|()<>'\"]{0,200}")
_VARIABLE = pattern(r"\$(?:\{([A-Za-z_]\w{0,60})\}|([A-Za-z_]\w{0,60}))")
_FETCHED = pattern(r"\b(?:wget|curl) [^&;|]{0,200}?(?<=[\s'\"])\$\{?([A-Za-z_]\w{0,60})\}?(?=['\"]?(?:[\s;&|]|$))")


def emptied(names: Mapping[str, str], instruction: str) -> dict[str, str]:
    """Name the variable of an instruction without which a word of it is what the log shows.

    ``$VERSION`` is empty where the instruction says ``/tmp/tool-$VERSION.zip`` and the log ``/tmp/tool-.zip``. Both
    ends of the word must be left, so that a word of the log is not taken for another by chance.
    """
    token = names.get("token", "")
    for word in _WORD.findall(instruction) if token else ():
        found = _VARIABLE.findall(word)
        parts = [part for part in _VARIABLE.split(word) if part is not None]
        plain = _VARIABLE.sub("", word)
        if len(found) == 1 and len(parts[0]) > 3 and len(parts[-1]) > 2 and token == plain:
            return {"name": found[0][0] or found[0][1]}
    return {}


def moved(names: Mapping[str, str], instruction: str) -> dict[str, str]:
    """Name the beginning of an address whose files have moved as a whole, and where they are now.

    Where the instruction holds the address in a variable alone, that is named too, with the whole new address.
    """
    address = names.get("address", "")
    for row in rows("moved_addresses"):
        if found := compiled(row["pattern"]).match(address):
            now = found.expand(row["now"])
            old = {"mirror": found[0], "moved": now}
            variable = _FETCHED.search(instruction)
            if found[0] not in instruction and variable:
                old |= {"variable": variable[1], "whole": now + address[found.end() :]}
            return old
    return {}


def conflict(names: Mapping[str, str], instruction: str) -> dict[str, str]:
    """Name what pip says that a pin would have to be, and the file that holds the pin, where both are said.

    Pins of others that contradict each other allow nothing.
    """
    wanted = names.get("wanted", "").replace(" and ", ",").replace(" ", "")
    allowed = specifiers(wanted) if wanted else None
    file = names.get("file") or next(iter(re.findall(r"(?:-r|--requirement)[ =]?([\w./-]{1,120})", instruction)), "")
    if allowed is None or len({each.version for each in allowed if each.operator == "=="}) > 1:
        return {}
    return {"constraint": wanted, "file": file} if file else {"constraint": wanted}


_STRUCTURES = {"_ts": "PyThreadState", "_typeobject": "PyTypeObject"}
"""Structures of Python's interface for C as clang calls them, each with the name of its type."""


def python_end(names: Mapping[str, str]) -> dict[str, str]:
    """Name what the standard library or Python's interface for C no longer has, and the last Python that has it."""
    module, symbol = names.get("module", ""), names.get("symbol", "")
    module = _STRUCTURES.get(module, module)
    for word in (f"{module}.{symbol}", symbol if not module else module if not symbol else ""):
        last = _python_ends().get(word)
        if last:
            return {"what": word, "last": last}
    return {}


def backend(names: Mapping[str, str]) -> dict[str, str]:
    """Name the package of pip that has a build backend: that of the table, else the one with the module's name."""
    module = names.get("module", "")
    said = f"No module named '{module}'"
    known = next((row["pip"] for row in rows("build_programs") if compiled(row["pattern"]).search(said)), "")
    top = ".".join(module.split(".")[: 2 if module.startswith("pdm.") else 1])
    return {"package": known or top.replace(".", "-").replace("_", "-")} if top else {}


def mistaken(names: Mapping[str, str]) -> dict[str, str]:
    """Name the package that a module is of, where pip has another by the module's name."""
    found = (row for row in rows("mistaken_packages") if row["module"] == names.get("module"))
    row = next(found, None)
    return {"name": row["pip"], "package": row["beside"]} if row else {}


_CUDA = pattern(
    r"^nvidia/cuda:(?P<cuda>\d{1,2}\.\d)(?:\.\d)?(?P<cudnn>-cudnn\d?)?-(?P<kind>base|runtime|devel)-ubuntu(?P<ubuntu>\d\d\.\d\d)$"
)


def cuda_image(names: Mapping[str, str]) -> dict[str, str]:
    """Name the tag of NVIDIA that is there for the CUDA and the Ubuntu of one that is not."""
    found = _CUDA.match(names.get("image", ""))
    if found is None:
        return {}
    for row in rows("cuda_images"):
        if row["cuda"] == found["cuda"] and ubuntus().get(found["ubuntu"]) in row["ubuntu"].split():
            cudnn = f"-{row['cudnn']}" if found["cudnn"] else ""
            now = f"nvidia/cuda:{row['tag']}{cudnn}-{found['kind']}-ubuntu{found['ubuntu']}"
            return {"package": now} if now != names["image"] else {}
    return {}


def moved_image(names: Mapping[str, str]) -> dict[str, str]:
    """Name the image that took the place of one which its maker moved; its tag stays only where the name changes."""
    said = names.get("image", "").removeprefix("docker.io/").removeprefix("library/").removesuffix(":latest")
    name, _colon, tag = said.partition(":")
    for row in rows("moved_images"):
        if name == row["image"] or (row["image"].endswith("/") and name.startswith(row["image"])):
            now = name.replace(row["image"], row["now"], 1)
            return {"image": said, "package": f"{now}:{tag}" if tag else now}
    return {}


def apk(names: Mapping[str, str]) -> dict[str, str]:
    """Name what the packages of Alpine are called today, if the table has all of them."""
    table = {row["name"]: row["now"] for row in rows("apk_names")}
    wanted = [name for name in names.get("name", "").split(", ") if name]
    return {"package": ", ".join(table[name] for name in wanted)} if wanted and table.keys() >= set(wanted) else {}


@cache
def _python_ends() -> dict[str, str]:
    return {row["name"]: row["last"] for row in rows("python_ends")}


def cmake_command(names: Mapping[str, str]) -> dict[str, str]:
    """Name the arguments of find_package for what defines a command of CMake."""
    name = names.get("name", "").lower()
    row = next((row for row in rows("cmake_commands") if compiled(row["pattern"]).fullmatch(name)), None)
    return {"package": row["package"]} if row else {}


def cuda_architecture(names: Mapping[str, str]) -> dict[str, str]:
    """Name the first CUDA of the table that knows an architecture, and what the ones before it can compile for."""
    said = names.get("architecture", "").rstrip("af")
    older = ""
    for row in rows("cuda_architectures") if said else ():
        known = [int(each.replace(".", "")) for each in row["architectures"].removesuffix("+PTX").split(";")]
        if int(said) < known[0]:
            return {}  # an old one, which was taken out of CUDA
        if int(said) <= known[-1]:
            return {"since": f"known since CUDA {row['cuda']}", "architectures": older}
        older = row["architectures"]
    return {}


_IGNORED = pattern(r"(?:^|[;:]) {0,3}(\d[\w.!+]{0,40}) Requires-Python ")
_CUT = "…"


def ignored(names: Mapping[str, str]) -> dict[str, str]:
    """Tell whether pip ignored a release that is asked for: nothing where all that it ignored are others.

    A line that is cut, or a version that is none, tells nothing against it.
    """
    said = names.get("versions", "") + names.get("others", "")
    wanted = specifiers(names.get("version", ""))
    known = [match[1] for match in _IGNORED.finditer(said)]
    fits = wanted is None or not known or _CUT in said or any(wanted.contains(each) for each in known)
    return {"ignored": "yes"} if fits else {}


def dropped(names: Mapping[str, str]) -> dict[str, str]:
    """Name the releases of a package that still have what a line of Python says is not there."""
    line = names.get("line", "")
    row = next((row for row in rows("dropped_names") if compiled(row["pattern"]).search(line)), None)
    if row is None:
        return {}
    return {"limit": row["limit"], "package": row["limit"].partition("<")[0], "newest_python": row["python"]}
