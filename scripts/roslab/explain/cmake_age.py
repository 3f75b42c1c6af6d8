"""Tells from which release on CMake knows what it says that it does not know."""

from __future__ import annotations

from collections.abc import Mapping

from roslab.knowledge.failures import compiled
from roslab.knowledge.table import rows


def since(names: Mapping[str, str]) -> dict[str, str]:
    """Name what an old CMake does not know, and the first release that does; nothing where no table has it.

    A log names a command, a sub-command of one, a module for ``include`` or ``find_package``, or, as ``said``, a
    policy, a generator expression or the words of a refusal.
    """
    said = " ".join(names.get("said", "").split())
    command, call, words = names.get("command", ""), names.get("call", ""), names.get("words", "")
    module, find = names.get("module", ""), names.get("find", "")
    known = (
        _of_call(command.lower(), "")
        or (call and (_of_call(call, words) or _of_message(f"{call} {words}")))
        or (module and _of_call("include", module))
        or (find and _of_call("find_package", find))
        or _of_message(said)
    )
    if not known:
        return {}
    module_of_find = f"Find{find}.cmake" if find else ""
    name = command or f"{call} {words}".strip() or module or module_of_find or said
    return {"name": name, "needs": known, "since": f"known since CMake {known}"}


def _of_call(call: str, words: str) -> str:
    known = (row["since"] for row in rows("cmake_since") if row["call"] == call and row["words"] == words)
    return next(known, "") if call else ""


def _of_message(said: str) -> str:
    known = (row["since"] for row in rows("cmake_messages") if compiled(row["pattern"]).fullmatch(said))
    return next(known, "") if said else ""
