"""Folders of modules that the setup.py of a ROS package installs as data, and that its programs import.

Data lie below ``share``, where Python does not look. ``colcon build --symlink-install`` puts links to them into the
package's build folder, which is on Python's path: colcon/colcon-core (colcon_core/task/python/build.py,
``_symlinks_in_build`` and the hook ``pythonpath_develop``), 2026-11-28.
"""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence.facts import Mention
from roslab.evidence.python.imports import modules_of
from roslab.evidence.python.modules import modules, setup_scripts
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_DATA = pattern(r"[\"'](\w{1,60})/[\w*]{1,60}\.py[\"']")


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the first import of each such folder by a module that lies outside it."""
    for setup in setup_scripts(repository):
        above = f"{setup.file.folder}/".lstrip("/")
        if "data_files" not in setup.text or not repository.has(f"{above}package.xml"):
            continue
        folders = {file.folder for file in repository.suffixed(".py")}
        names = {name for name in _DATA.findall(setup.text) if f"{above}{name}" in folders}
        if not names:
            continue
        from roslab.evidence.python.setup_py import read as packages_of  # noqa: PLC0415 - it imports Python's parser

        installed = packages_of(setup.text).packages
        for name in sorted(names.difference(installed)) if installed else ():
            yield from _first(name, f"{above}{name}/", repository)


def _first(name: str, folder: str, repository: Repository) -> Iterator[Mention]:
    for module in modules(repository):
        if name not in module.text or module.file.path.startswith(folder):
            continue
        for match in module.statements:
            if not match["indent"] and name in modules_of(match):
                line = module.text.count("\n", 0, match.start()) + 1
                path, text = module.file.path, f"import {name}"
                yield Mention(topic="left_beside", value=name, source="code", file=path, line=line, text=text)
                return
