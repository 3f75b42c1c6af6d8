"""setup.py, setup.cfg, pyproject.toml and Pipfile, read without running them: one project per folder."""

from __future__ import annotations

import posixpath
from collections.abc import Callable, Iterable, Iterator
from typing import Any

from roslab.evidence.python import pipfile, requirements
from roslab.evidence.python.console_scripts import ENTRIES, modules_of, startable
from roslab.evidence.python.manager_lines import GROUP
from roslab.evidence.python_project import PythonProject
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern
from roslab.values.requirement import Requirement, Role
from roslab.values.requirement_line import requirement

MAX_SIZE = 256 * 1024
_AMENT = pattern(r"ament_index/resource_index|ament_python")
_SETUP = pattern(r"\bsetup\s*\(")


def read(repository: Repository) -> tuple[PythonProject, ...]:
    """Return every folder that Python's packaging tools know, sorted by path."""
    folders: dict[str, dict[str, str]] = {}
    for file in repository.named(*_READERS):
        if file.name in _READERS:
            folders.setdefault(file.folder, {})[file.name] = file.path
    found = (_project(repository, folder, files) for folder, files in sorted(folders.items()))
    return tuple(project for project in found if project)


def not_by_pip(projects: Iterable[PythonProject]) -> Iterator[Requirement]:
    """Yield what pip does not install with the projects, as a page's line would install it.

    Of a project that its backend refuses to install, all that it needs; uv's groups.
    """
    for project in projects:
        missed = (*project.requirements, *project.groups) if project.refused else project.groups
        yield from (replace(each, origin="prose") for each in missed if not each.role)


def _project(repository: Repository, folder: str, files: dict[str, str]) -> PythonProject | None:
    parts: list[PythonProject] = []
    for name, reader in _READERS.items():
        if name in files and (text := repository.read(files[name], limit=MAX_SIZE)):
            project = reader(repository, files[name], folder, text)
            if project is not None:
                parts.append(project)
    parts.sort(key=lambda part: not (part.installable or (part.stopped and part.file.endswith("pyproject.toml"))))
    if parts and not (parts[0].installable or parts[0].requirements or parts[0].stopped):
        parts.sort(key=lambda part: not part.file.endswith("Pipfile"))  # the other only configures tools
    if not parts:
        return None
    first, *rest = parts
    ros = any(part.file.endswith("setup.py") and not (part.installable or part.stopped) for part in parts)
    other = any(part.installable and part.file.endswith("pyproject.toml") for part in parts)
    stopped = "" if other else next((part.stopped for part in parts if part.stopped), "")
    return PythonProject(
        file=first.file,
        line=first.line,
        folder=folder,
        name=next((part.name for part in parts if part.name), None),
        version=next((part.version for part in parts if part.version), None),
        installable=first.installable and not ros and not stopped,
        requires_python=next((part.requires_python for part in parts if part.requires_python), None),
        build_requires=tuple(dict.fromkeys(line for part in parts for line in part.build_requires)),
        requirements=tuple(
            {(r.text, r.role, r.group): r for part in _asked(first, rest) for r in part.requirements}.values()
        ),
        scripts=tuple(script for part in parts for script in part.scripts),
        more_programs=any(part.more_programs for part in parts),
        modules=tuple(name for part in parts for name in part.modules),
        script_files=tuple(name for part in parts for name in part.script_files),
        extensions=tuple(dict.fromkeys(extension for part in parts for extension in part.extensions)),
        classifiers=tuple(dict.fromkeys(line for part in parts for line in part.classifiers)),
        setup_imports=next((part.setup_imports for part in parts if part.setup_imports), ()),
        groups=tuple(each for part in parts for each in part.groups),
        version_by=tuple(name for part in parts for name in part.version_by),
        stopped=stopped,
    )


def _asked(first: PythonProject, rest: list[PythonProject]) -> list[PythonProject]:
    """Return the files whose dependencies count: only the first, unless that leaves them to another."""
    return [first] if any(not asked.role for asked in first.requirements) else [*reversed(rest), first]


def _finder(text: str) -> Callable[[str], int]:
    def line_of(wanted: str) -> int:
        position = text.find(wanted)
        return text.count("\n", 0, position) + 1 if position >= 0 else 1

    return line_of


def _listed(
    lines: Iterable[Any], path: str, line_of: Callable[[str], int], *, extra: str | None = None, role: Role = ""
) -> list[Requirement]:
    """Parse requirement lines; ``extra`` is the name of their extra, with a marker after a colon.

    The name may be empty: ``:python_version<"3"`` asks for more on an old Python without being an extra.
    https://setuptools.pypa.io/en/latest/userguide/dependency_management.html#platform-specific-dependencies
    """
    group, _, condition = (extra or "").partition(":")
    found = []
    for line in lines:
        if not isinstance(line, str) or not line.strip():
            continue
        asked = requirement(line.strip(), "manifest", path, line_of(line), role="extra" if group else role, group=group)
        if asked:
            found.append(asked.only_if(condition))
    return found


def from_file(repository: Repository, folder: str, name: str) -> list[Requirement]:
    """Return the requirements of a file from which a project reads its own, and of the files that it includes."""
    pending, seen, found = [f"{folder}/{name}".strip("/")], set[str](), list[Requirement]()
    while pending:
        path = pending.pop()
        if path not in seen and repository.has(path):
            seen.add(path)
            parsed = requirements.parse(repository.read(path, limit=requirements.MAX_SIZE), path, "run")
            found += [asked for asked in parsed.requirements if asked.role != "project"]
            pending += parsed.includes
    return found


def _setup_py(repository: Repository, path: str, folder: str, text: str) -> PythonProject | None:
    from roslab.evidence.python.extensions import by_install, extensions  # noqa: PLC0415 - many trees have no project of Python

    if not _SETUP.search(text):
        return None
    from roslab.evidence.python import setup_py  # noqa: PLC0415 - it imports Python's own parser
    from roslab.evidence.python.stopped_setup import why_stopped  # noqa: PLC0415 - as above

    script = setup_py.read(text)
    line_of = _finder(text)
    asked: list[Requirement] = []
    for role, (lines, files) in script.requirements.items():
        extra = role.removeprefix("extra:") if role.startswith("extra:") else None
        asked += _listed(lines, path, line_of, extra=extra, role="test" if role == "test" else "")
        for name in files:
            asked += from_file(repository, folder, name.removeprefix("./"))
    package_xml = f"{folder}/package.xml".strip("/")
    manifest = repository.read(package_xml) if repository.has(package_xml) else ""
    ros = script.catkin or bool(manifest and (_AMENT.search(text) or _AMENT.search(manifest)))
    own = "from setuptools import" in text
    stopped = "" if ros else why_stopped(repository, folder, script, setuptools=own)
    return PythonProject(
        file=path,
        line=script.line,
        folder=folder,
        name=script.name,
        version=script.version,
        installable=not (ros or stopped),
        stopped=stopped,
        requires_python=script.requires_python,
        build_requires=tuple(_listed(script.build_requires, path, line_of)),
        requirements=tuple(asked),
        scripts=tuple((name, line_of(name)) for name in startable(repository, folder, script.scripts)),
        modules=tuple(modules_of(script.scripts)),
        script_files=_in(folder, script.script_files),
        more_programs=script.more_programs,
        extensions=(*extensions(text), *by_install(text, script.commands)),
        classifiers=script.classifiers,
        setup_imports=tuple(dict.fromkeys(_imported(repository, folder, script.imports))),
    )


def _in(folder: str, files: Iterable[str]) -> tuple[str, ...]:
    """Return the paths from the root of files in a project's folder."""
    return tuple(posixpath.normpath(posixpath.join(folder, file.strip())) for file in files)


def _imported(repository: Repository, folder: str, modules: tuple[str, ...]) -> Iterator[str]:
    """Yield ``.`` for a package in the same folder, nothing for a script beside setup.py, else the module's name."""
    for module in modules:
        if repository.has(f"{folder}/{module}/__init__.py".strip("/")):
            yield "."
        elif not repository.has(f"{folder}/{module}.py".strip("/")):
            yield module


def _setup_cfg(repository: Repository, path: str, folder: str, text: str) -> PythonProject | None:
    import configparser  # noqa: PLC0415 - few projects have a setup.cfg

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
    asked: list[Requirement] = []
    for line in words("options", "install_requires"):
        if line.startswith("file:"):
            for part in line.removeprefix("file:").split(","):
                asked += from_file(repository, folder, part.strip())
        else:
            asked += _listed([line], path, line_of)
    if parser.has_section("options.extras_require"):
        for extra in parser.options("options.extras_require"):
            asked += _listed(words("options.extras_require", extra), path, line_of, extra=extra)
    entries = [line for kind in ENTRIES for line in words("options.entry_points", kind)]
    scripts = tuple((name, line_of(name)) for name in startable(repository, folder, entries))
    return PythonProject(
        file=path,
        line=1,
        folder=folder,
        name=name,
        installable=bool(name) and parser.has_section("options"),
        requires_python=" ".join(parser.get("options", "python_requires", fallback="").split()) or None,
        build_requires=tuple(_listed(words("options", "setup_requires"), path, line_of)),
        requirements=tuple(asked),
        scripts=scripts,
        script_files=_in(folder, words("options", "scripts")),
        classifiers=tuple(words("metadata", "classifiers")),
    )


def _pyproject(repository: Repository, path: str, folder: str, text: str) -> PythonProject | None:
    from roslab.evidence.python import poetry, uv  # noqa: PLC0415 - many trees have no project of Python
    from roslab.evidence.python.extensions import extensions  # noqa: PLC0415 - as above
    from roslab.evidence.python.lenient import tables  # noqa: PLC0415 - as above
    from roslab.evidence.python.stopped_setup import why_refused  # noqa: PLC0415 - as above
    from roslab.evidence.python.version_by import version_by  # noqa: PLC0415 - as above
    from roslab.evidence.python.without_module import without_module  # noqa: PLC0415 - as above

    data, wrong = tables(text)
    stopped = why_refused(data, wrong)
    beside = repository.has(f"{folder}/setup.py".strip("/"))
    if wrong and not (beside or {"project", "build-system"} & data.keys() or "poetry" in _table(data, "tool")):
        return None
    line_of = _finder(text)
    project, of_poetry = _table(data, "project"), _table(data, "tool", "poetry")
    asked = _listed(_list(project, "dependencies"), path, line_of)
    asked = [uv.as_installed(each, _table(data, "tool", "uv", "sources")) for each in asked]
    for extra, lines in _table(project, "optional-dependencies").items():
        asked += _listed(lines if isinstance(lines, list) else (), path, line_of, extra=extra)
    dynamic = _table(data, "tool", "setuptools", "dynamic", "dependencies").get("file")
    for name in [dynamic] if isinstance(dynamic, str) else dynamic if isinstance(dynamic, list) else []:
        asked += from_file(repository, folder, str(name))
    for name, each in {**poetry.groups_of(of_poetry), **uv.groups_of(data)}.items():
        asked += _listed(each, path, line_of, extra=GROUP + name)
    own = _table(of_poetry, "dependencies")
    python = project.get("requires-python") or poetry.python(own)
    asked += _listed(poetry.lines(own), path, poetry.finder_of_keys(text))
    for extra, names in _table(of_poetry, "extras").items():
        lines = poetry.lines(own, extra=frozenset(map(str, names)) if isinstance(names, list) else frozenset())
        asked += _listed(lines, path, poetry.finder_of_keys(text), extra=extra)
    scripts = {**_table(of_poetry, "scripts"), **_table(project, "scripts"), **_table(project, "gui-scripts")}
    build = _listed(_list(_table(data, "build-system"), "requires"), path, line_of)
    name = project.get("name") or of_poetry.get("name")
    backend = _table(data, "build-system").get("build-backend", "")
    return PythonProject(
        file=path,
        line=wrong[1] if wrong else line_of("[project]") if project else 1,
        folder=folder,
        name=name if isinstance(name, str) else None,
        installable=bool(name and (project or backend))
        and not (stopped or without_module(repository, folder, str(name), data)),
        stopped=stopped,
        requires_python=python if isinstance(python, str) else None,
        build_requires=tuple(build),
        requirements=tuple(asked),
        scripts=tuple((script, line_of(script)) for script in scripts),
        script_files=_in(folder, map(str, _list(_table(data, "tool", "setuptools"), "script-files"))),
        extensions=extensions(str(backend) + " ".join(each.written for each in build)),
        classifiers=tuple(line for line in _list(project, "classifiers") if isinstance(line, str)),
        version_by=tuple(dict.fromkeys(version_by(data))),
        groups=tuple(_listed([*uv.default_groups(data), *poetry.default_groups(of_poetry)], path, line_of)),
    )


_READERS = {"pyproject.toml": _pyproject, "setup.py": _setup_py, "setup.cfg": _setup_cfg, "Pipfile": pipfile.project}


def _table(data: Any, *keys: str) -> dict[str, Any]:
    for key in keys:
        data = data.get(key) if isinstance(data, dict) else None
    return data if isinstance(data, dict) else {}


def _list(data: dict[str, Any], key: str) -> list[Any]:
    value = data.get(key)
    return value if isinstance(value, list) else []
