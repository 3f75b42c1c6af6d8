"""setup.py, setup.cfg and pyproject.toml, read without running them: one project per folder."""

from __future__ import annotations

import configparser
import re
import sys
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from typing import Any

from packaging.utils import canonicalize_name

from roslab.evidence.facts import Dependency, PythonProject
from roslab.evidence.python import requirements, setup_py
from roslab.repository.checkout import Repository

MAX_SIZE = 256 * 1024
_AMENT = re.compile(r"ament_index/resource_index|ament_python")


def read(repository: Repository) -> tuple[PythonProject, ...]:
    """Return every folder that Python's tools know, sorted by path."""
    folders: dict[str, dict[str, str]] = {}
    for file in repository.named("setup.py", "setup.cfg", "pyproject.toml"):
        if file.name == file.name.lower():
            folders.setdefault(file.folder, {})[file.name] = file.path
    found = (_project(repository, folder, files) for folder, files in sorted(folders.items()))
    return tuple(project for project in found if project)


def _project(repository: Repository, folder: str, files: dict[str, str]) -> PythonProject | None:
    parts: list[PythonProject] = []
    for name, reader in (("pyproject.toml", _pyproject), ("setup.py", _setup_py), ("setup.cfg", _setup_cfg)):
        if name in files and (text := repository.read(files[name], limit=MAX_SIZE)):
            project = reader(repository, files[name], folder, text)
            if project is not None:
                parts.append(project)
    parts.sort(key=lambda part: not part.installable)
    if not parts:
        return None
    first, *rest = parts
    ros = any(part.file.endswith("setup.py") and not part.installable for part in parts)
    return PythonProject(
        file=first.file,
        line=first.line,
        folder=folder,
        name=next((part.name for part in parts if part.name), None),
        installable=first.installable and not ros,
        requires_python=next((part.requires_python for part in parts if part.requires_python), None),
        build_requires=tuple(dict.fromkeys(line for part in parts for line in part.build_requires)),
        dependencies=tuple({(d.name, d.role): d for part in _asked(first, rest) for d in part.dependencies}.values()),
        scripts=tuple(script for part in parts for script in part.scripts),
        extensions=tuple(dict.fromkeys(extension for part in parts for extension in part.extensions)),
        classifiers=tuple(dict.fromkeys(line for part in parts for line in part.classifiers)),
        setup_imports=next((part.setup_imports for part in parts if part.setup_imports), ()),
    )


def _asked(first: PythonProject, rest: list[PythonProject]) -> list[PythonProject]:
    """Return the files whose dependencies count: pip asks the first alone, unless that leaves them to another."""
    return [first] if any(not d.role for d in first.dependencies) else [*reversed(rest), first]


def _finder(text: str) -> Callable[[str], int]:
    def line_of(wanted: str) -> int:
        position = text.find(wanted)
        return text.count("\n", 0, position) + 1 if position >= 0 else 1

    return line_of


def _listed(lines: Iterable[Any], path: str, line_of: Callable[[str], int], role: str = "") -> list[Dependency]:
    found = (
        requirements.requirement(line.strip(), path, line_of(line), role=role)
        for line in lines
        if isinstance(line, str) and line.strip()
    )
    return [dependency for dependency in found if dependency]


def from_file(repository: Repository, folder: str, name: str) -> list[Dependency]:
    """Return the requirements of a file that a project reads its own from, and of what that file includes."""
    pending, seen, found = [f"{folder}/{name}".strip("/")], set[str](), list[Dependency]()
    while pending:
        path = pending.pop()
        if path not in seen and repository.has(path):
            seen.add(path)
            parsed = requirements.parse(repository.read(path, limit=requirements.MAX_SIZE), path, "run")
            found += [dependency for dependency in parsed.dependencies if dependency.role != "project"]
            pending += parsed.includes
    return found


def _setup_py(repository: Repository, path: str, folder: str, text: str) -> PythonProject | None:
    if not re.search(r"\bsetup\s*\(", text):
        return None
    script = setup_py.read(text)
    line_of = _finder(text)
    dependencies: list[Dependency] = []
    for role, (lines, files) in script.requirements.items():
        dependencies += _listed(lines, path, line_of, role)
        for name in files:
            dependencies += from_file(repository, folder, name.removeprefix("./"))
    manifest = (
        repository.read(f"{folder}/package.xml".strip("/"))
        if repository.has(f"{folder}/package.xml".strip("/"))
        else ""
    )
    ros = script.catkin or bool(manifest and (_AMENT.search(text) or _AMENT.search(manifest)))
    return PythonProject(
        file=path,
        line=script.line,
        folder=folder,
        name=script.name,
        installable=not ros,
        requires_python=script.requires_python,
        build_requires=script.build_requires,
        dependencies=tuple(dependencies),
        scripts=tuple((name, line_of(name)) for name in script.scripts),
        extensions=setup_py.extensions(text),
        classifiers=script.classifiers,
        setup_imports=tuple(dict.fromkeys(_imported(repository, folder, script.imports))),
    )


def _imported(repository: Repository, folder: str, modules: tuple[str, ...]) -> Iterator[str]:
    """Yield ``.`` for a package of the same folder, nothing for a script beside setup.py, else the module's name."""
    for module in modules:
        if repository.has(f"{folder}/{module}/__init__.py".strip("/")):
            yield "."
        elif not repository.has(f"{folder}/{module}.py".strip("/")):
            yield module


def _setup_cfg(repository: Repository, path: str, folder: str, text: str) -> PythonProject | None:
    parser = configparser.ConfigParser(interpolation=None, strict=False)
    try:
        parser.read_string(text)
    except configparser.Error:
        return None
    if not parser.has_section("metadata") and not parser.has_section("options"):
        return None
    line_of = _finder(text)

    def words(section: str, key: str) -> list[str]:
        return [line for line in parser.get(section, key, fallback="").split("\n") if line.strip()]

    name = parser.get("metadata", "name", fallback=None)
    dependencies: list[Dependency] = []
    for line in words("options", "install_requires"):
        if line.startswith("file:"):
            for part in line.removeprefix("file:").split(","):
                dependencies += from_file(repository, folder, part.strip())
        else:
            dependencies += _listed([line], path, line_of)
    if parser.has_section("options.extras_require"):
        for extra in parser.options("options.extras_require"):
            dependencies += _listed(words("options.extras_require", extra), path, line_of, f"extra:{extra}")
    scripts = tuple(
        (line.partition("=")[0].strip(), line_of(line)) for line in words("options.entry_points", "console_scripts")
    )
    return PythonProject(
        file=path,
        line=1,
        folder=folder,
        name=name,
        installable=bool(name) and parser.has_section("options"),
        requires_python=parser.get("options", "python_requires", fallback=None),
        build_requires=tuple(words("options", "setup_requires")),
        dependencies=tuple(dependencies),
        scripts=scripts,
        classifiers=tuple(words("metadata", "classifiers")),
    )


def _pyproject(repository: Repository, path: str, folder: str, text: str) -> PythonProject | None:
    if sys.version_info >= (3, 11):
        import tomllib  # noqa: PLC0415 - most repositories never need it
    else:
        import tomli as tomllib  # noqa: PLC0415
    try:
        data: dict[str, Any] = tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError, ValueError):
        return None
    line_of = _finder(text)
    project, poetry = _table(data, "project"), _table(data, "tool", "poetry")
    dependencies = _listed(_list(project, "dependencies"), path, line_of)
    dependencies = [_of_uv(d, _table(data, "tool", "uv", "sources")) for d in dependencies]
    for extra, lines in _table(project, "optional-dependencies").items():
        dependencies += _listed(lines if isinstance(lines, list) else (), path, line_of, f"extra:{extra}")
    dynamic = _table(data, "tool", "setuptools", "dynamic", "dependencies").get("file")
    for name in [dynamic] if isinstance(dynamic, str) else dynamic if isinstance(dynamic, list) else []:
        dependencies += from_file(repository, folder, str(name))
    python = project.get("requires-python")
    poetry_lines = _poetry(_table(poetry, "dependencies"))
    if poetry_lines:
        python = python or poetry_lines.pop("python", None)
        dependencies += _listed(poetry_lines.values(), path, line_of)
    scripts = {**_table(poetry, "scripts"), **_table(project, "scripts")}
    build = _list(_table(data, "build-system"), "requires")
    name = project.get("name") or poetry.get("name")
    backend = _table(data, "build-system").get("build-backend", "")
    return PythonProject(
        file=path,
        line=line_of("[project]") if project else 1,
        folder=folder,
        name=name if isinstance(name, str) else None,
        installable=bool(name) and bool(project or backend),
        requires_python=python if isinstance(python, str) else None,
        build_requires=tuple(line for line in build if isinstance(line, str)),
        dependencies=tuple(dependencies),
        scripts=tuple((script, line_of(script)) for script in scripts),
        extensions=setup_py.extensions(str(backend) + " ".join(map(str, build))),
        classifiers=tuple(line for line in _list(project, "classifiers") if isinstance(line, str)),
    )


def _of_uv(dependency: Dependency, sources: dict[str, Any]) -> Dependency:
    """Return a dependency as uv would install it: pip knows neither its sources nor the members of its workspace.

    https://docs.astral.sh/uv/concepts/projects/dependencies/#dependency-sources.
    """
    name = canonicalize_name(re.split(r"[\s\[<>=!~;@]", dependency.name, maxsplit=1)[0])
    said = next((value for key, value in sources.items() if canonicalize_name(key) == name), None)
    said = said[0] if isinstance(said, list) and said else said
    if not isinstance(said, dict):
        return dependency
    if said.get("workspace") or "path" in said:
        return replace(dependency, role="member")
    if isinstance(said.get("git"), str):
        ref = said.get("rev") or said.get("tag") or said.get("branch")
        folder = f"#subdirectory={said['subdirectory']}" if said.get("subdirectory") else ""
        line = f"{name} @ git+{said['git']}" + (f"@{ref}" if ref else "") + folder
        return replace(dependency, name=line, role="source")
    if isinstance(said.get("url"), str):
        return replace(dependency, name=f"{name} @ {said['url']}", role="source")
    return dependency


def _table(data: Any, *keys: str) -> dict[str, Any]:
    for key in keys:
        data = data.get(key) if isinstance(data, dict) else None
    return data if isinstance(data, dict) else {}


def _list(data: dict[str, Any], key: str) -> list[Any]:
    value = data.get(key)
    return value if isinstance(value, list) else []


def _poetry(table: dict[str, Any]) -> dict[str, str]:
    """Return Poetry's dependency table as requirement lines. https://python-poetry.org/docs/dependency-specification/."""
    lines: dict[str, str] = {}
    for name, said in table.items():
        optional = isinstance(said, dict) and said.get("optional")
        value = (said[0] if said else "*") if isinstance(said, list) else said
        if isinstance(value, dict) and "git" in value:
            ref = value.get("rev") or value.get("tag") or value.get("branch")
            lines[name] = f"{name} @ git+{value['git']}" + (f"@{ref}" if ref else "")
            continue
        if isinstance(value, dict) and ("path" in value or "url" in value):
            if "url" in value:
                lines[name] = f"{name} @ {value['url']}"
            continue
        version = value.get("version", "*") if isinstance(value, dict) else value
        if isinstance(version, str) and not optional:
            specifier = ",".join(_caret(part.strip()) for part in version.split("||")[0].split(",")).strip(",")
            lines[name] = specifier if name == "python" else name + specifier
    return lines


def _caret(part: str) -> str:
    if part in {"*", ""}:
        return ""
    if part[0] in "^~" and not part.startswith("~="):
        numbers = re.findall(r"\d+", part[1:])[:3]
        if not numbers:
            return ""
        index = (
            0
            if part[0] == "~" and len(numbers) == 1
            else 1
            if part[0] == "~"
            else next((i for i, n in enumerate(numbers) if n != "0"), len(numbers) - 1)
        )
        upper = [*numbers[:index], str(int(numbers[index]) + 1)]
        return f">={part[1:].strip()},<{'.'.join(upper)}"
    if part[0].isdigit():
        return f"=={part}"
    return part.replace(" ", "")
