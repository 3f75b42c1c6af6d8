"""The plugins of rqt that its saved layouts (``.perspective``) open."""

from __future__ import annotations

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.repository.checkout import Repository, nearest
from roslab.values.pattern import pattern

MAX_SIZE = 1024 * 1024
MAX_FILES = 20
_RUNNING = pattern(r"\"running-plugins\"\s*:\s*\{[^{}\"]{0,200}(?:\"(?:[^\"\\]|\\.){0,9000}\"[^{}\"]{0,200}){0,20}\}")
"""The list of open plugins: ``{'rqt_plot/Plot': [1, 2]}``, in a text of JSON.

https://github.com/ros-visualization/qt_gui_core/blob/master/qt_gui/src/qt_gui/plugin_manager.py, 2026-11-27."""
_PLUGIN = pattern(r"u?'([a-z][a-z0-9_]{1,60})/[^'\n]{1,80}'\s*:\s*\[\s*\d")


def read(repository: Repository) -> tuple[Dependency, ...]:
    """Return rqt and the package of each plugin that is open in a layout, each where it is named first."""
    found: dict[str, Dependency] = {}
    layouts = (f for f in repository.suffixed(".perspective") if f.size <= MAX_SIZE and not places.vendored(f.path))
    for file in nearest(layouts)[:MAX_FILES]:
        text = repository.read(file)
        running = _RUNNING.search(text) if "running-plugins" in text else None
        for plugin in _PLUGIN.finditer(text, running.start(), running.end()) if running else ():
            line = text.count("\n", 0, plugin.start()) + 1
            for name in ("rqt_gui", plugin[1]):
                asked = Dependency(namespace="ros", name=name, strength="used", file=file.path, line=line, role="exec")
                found.setdefault(name, asked)
    return tuple(found.values())
