"""roslab.lock: every version that a proved image was made of, and the plan that uses them again.

JSON, because its reader comes with Python and is fast for thousands of rows, and a schema checks it; one row a line,
because people read its differences.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterable, Mapping
from typing import Any, TypeVar

from roslab.config.model import Source
from roslab.errors import ConfigurationError, Problem
from roslab.plan.locked import (
    NAME,
    Distribution,
    Environment,
    Lock,
    LockedSource,
    Machine,
    Material,
    Missing,
    Package,
)
from roslab.plan.plan import Plan
from roslab.values.dataclass import asdict, fields, replace
from roslab.values.origin import Place

VERSION = 1
"""Version of the file's format; a reader refuses any other."""
AGAIN = "build with `roslab build --no-lock`, then run `roslab lock`; or delete the file"
"""What to do with a lock that cannot be used."""
_PATTERNS: Mapping[str, str] = {
    "digest": r"sha256:[0-9a-f]{64}",
    "commit": r"[0-9a-f]{40}|[0-9a-f]{64}",
    "rosdistro": r"[A-Za-z0-9][A-Za-z0-9/._-]*",
    "name": r"[A-Za-z0-9][A-Za-z0-9+._-]*",
    "version": r"[A-Za-z0-9][A-Za-z0-9.+~:!_-]*",
    "architecture": r"[a-z0-9-]+",
    "hashes": r"sha256:[0-9a-f]{64}",
    "step": r"[a-z0-9-]*",
    "platform": r"[a-z]+/[a-z0-9]+(/[a-z0-9]+)?",
    "url": r"(https?|git\+https?|git\+ssh|ssh|git|file)://[^\s\"'\\`$]+|[\w.-]+@[\w.-]+:[^\s\"'\\`$]+|",
    "conda": r"https?://[^\s\"'\\`$]+",
}
"""What a value may be: it becomes a word of a Dockerfile, and anybody may propose another lock."""
T = TypeVar("T")


def to_text(lock: Lock) -> str:
    """Return the text of a lock; equal locks give equal bytes."""
    head = {
        "version": VERSION,
        "base": {"image": lock.base, "digest": lock.digest},
        "python": lock.python,
        "rosdistro": lock.rosdistro,
        "tools": dict(lock.tools),
    }
    parts = [f"  {json.dumps(name)}: {_line(value)}" for name, value in head.items()]
    parts.append(f'  "sources": {_rows(map(asdict, lock.sources), "  ")}')
    parts.append(f'  "materials": {_rows(map(asdict, lock.materials), "  ")}')
    machines = []
    for machine in lock.machines:
        pip = ",\n".join(
            f"        {_line(environment.name)}: {_rows(map(asdict, environment.packages), '        ')}"
            for environment in machine.python
        )
        machines.append(
            f"    {_line(machine.platform)}: {{\n"
            f'      "apt": {_rows(map(asdict, machine.apt), "      ")},\n'
            f'      "pip": {f"{{{chr(10)}{pip}{chr(10)}      }}" if pip else "{}"},\n'
            f'      "conda": {_rows(machine.conda, "      ")}\n    }}'
        )
    body = ",\n".join(machines)
    parts.append(f'  "platforms": {{\n{body}\n  }}' if body else '  "platforms": {}')
    return "{\n" + ",\n".join(parts) + "\n}\n"


def digest(text: str) -> str:
    """Return the digest by which an image names a lock."""
    import hashlib  # noqa: PLC0415 - few repositories have a lock

    return f"sha256:{hashlib.sha256(text.encode()).hexdigest()}"


def _line(value: object) -> str:
    return json.dumps(value, ensure_ascii=True)


def _rows(rows: Iterable[object], indent: str) -> str:
    lines = [f"{indent}  {_line(row)}" for row in rows]
    return "[\n" + ",\n".join(lines) + f"\n{indent}]" if lines else "[]"


def from_text(text: str, *, file: str = NAME) -> Lock:
    """Read a lock. Raises ``ConfigurationError`` for anything that ``to_text`` did not write."""
    origin = Place(file=file)
    try:
        data = json.loads(text)
        if not isinstance(data, dict) or data.get("version") != VERSION:
            found = data.get("version") if isinstance(data, dict) else None
            message = f"its format has version {found!r}, and this program reads version {VERSION}"
            raise ConfigurationError(Problem(message=message, hint=AGAIN, origin=origin))
        machines = tuple(_machine(platform, found) for platform, found in data["platforms"].items())
        return Lock(
            base=_text(data["base"]["image"], "image"),
            digest=_text(data["base"]["digest"], "digest") if data["base"]["digest"] else "",
            python=_text(data["python"], "python"),
            rosdistro=_text(data["rosdistro"], "rosdistro") if data["rosdistro"] is not None else None,
            tools=tuple((str(name), str(value)) for name, value in data["tools"].items()),
            sources=_all(LockedSource, data["sources"]),
            materials=_all(Material, data["materials"]),
            machines=machines,
        )
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        said = f"{type(error).__name__}: {error}" if not isinstance(error, ValueError) else str(error)
        raise ConfigurationError(Problem(message=f"no lock: {said}", hint=AGAIN, origin=origin)) from None


def _machine(platform: str, data: Mapping[str, Any]) -> Machine:
    return Machine(
        platform=_text(platform, "platform"),
        apt=_all(Package, data["apt"]),
        python=tuple(
            Environment(name=_text(name, "step"), packages=_all(Distribution, rows))
            for name, rows in data["pip"].items()
        ),
        conda=tuple(_text(row, "conda") for row in data["conda"]),
    )


def _all(kind: Callable[..., T], rows: Iterable[Mapping[str, Any]]) -> tuple[T, ...]:
    names = {field.name for field in fields(kind)}  # type: ignore[arg-type]
    found = []
    for row in rows:
        if set(row) != names:
            raise ValueError(f"a row has the fields {', '.join(sorted(row))}, not {', '.join(sorted(names))}")
        values = {
            name: tuple(_text(each, name) for each in value) if isinstance(value, list) else _text(value, name)
            for name, value in row.items()
        }
        found.append(kind(**values))
    return tuple(found)


def _text(value: object, name: str) -> str:
    pattern = _PATTERNS.get(name, r"[^\x00-\x1f\x7f\"`$\\]*")
    if not isinstance(value, str) or not re.fullmatch(pattern, value):
        raise ValueError(f"{value!a} is no {name}")
    return value


def use(plan: Plan, lock: Lock, *, file: str = NAME) -> Plan:
    """Return the plan with everything at the lock's versions; what the lock does not name stays as it is.

    Raises ``ConfigurationError`` where the lock was made for another base or another Python.
    """
    if plan.author_dockerfile:
        return replace(plan, lock=lock)
    asked, _, pinned = plan.base_image.partition("@")
    problems = [
        f"it was made for {what} {old}, and the plan has {new}"
        for what, old, new in (("the base", lock.base, asked), ("Python", lock.python, python_of(plan)))
        if old != new
    ]
    if pinned and pinned != lock.digest:
        problems.append(f"it was made for {asked}@{lock.digest}, and the plan names {pinned}")
    if problems:
        origin = Place(file=file)
        raise ConfigurationError(*(Problem(message=problem, hint=AGAIN, origin=origin) for problem in problems))
    commits = {(source.name, source.url): source.commit for source in lock.sources}

    def at(source: Source) -> Source:
        commit = commits.get((source.name, source.repo or ""))
        return replace(source, ref=commit, before="") if commit else source

    rosdep = plan.rosdep
    if rosdep and rosdep.rosdistro_tag is None and lock.rosdistro:
        rosdep = replace(rosdep, rosdistro_tag=lock.rosdistro)
    return replace(
        plan,
        base_image=f"{asked}@{lock.digest}" if lock.digest else asked,
        libraries=tuple(map(at, plan.libraries)),
        workspace=replace(plan.workspace, sources=tuple(map(at, plan.workspace.sources))),
        rosdep=rosdep,
        python=replace(plan.python, day=None),
        lock=lock,
    )


def python_of(plan: Plan) -> str:
    """Return what the versions of Python packages hold for: the environment and its Python."""
    return f"{plan.python.manager} {plan.python.version or ''}".strip()


def without(plan: Plan, gone: Iterable[Missing]) -> Plan:
    """Return a plan that no longer asks for what is gone: the build then takes the newest; of a commit, the nearest."""
    lost = {(each.kind, each.name, each.wanted) for each in gone}
    commits = {each.wanted: each.nearest for each in gone if each.kind == "source"}
    if not lost or plan.lock is None:
        return plan
    machines = tuple(
        replace(
            machine,
            apt=tuple(p for p in machine.apt if ("apt", p.name, p.version) not in lost),
            python=tuple(
                replace(each, packages=tuple(p for p in each.packages if ("pip", p.name, p.version) not in lost))
                for each in machine.python
            ),
        )
        for machine in plan.lock.machines
    )

    def at(source: Source) -> Source:
        return replace(source, ref=commits[source.ref] or source.ref) if source.ref in commits else source

    base, _, digest = plan.base_image.partition("@")
    return replace(
        plan,
        lock=replace(plan.lock, machines=machines),
        base_image=base if ("base", base, digest) in lost else plan.base_image,
        libraries=tuple(map(at, plan.libraries)),
        workspace=replace(plan.workspace, sources=tuple(map(at, plan.workspace.sources))),
    )
