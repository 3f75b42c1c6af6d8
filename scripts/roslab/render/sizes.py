"""A chart for the summary of what a download consists of: an image's layers, grouped by what made them."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable

from roslab.render.markdown import block
from roslab.values.dataclass import dataclass
from roslab.values.pattern import pattern

BASE = "base image"
SMALLEST = 0.02
"""Smallest share that gets its own slice: in a smaller one the number cannot be read."""
COLOURS = ("#57606a", "#0969da", "#1a7f37", "#bc4c00", "#8250df", "#bf3989", "#9a6700", "#1b7c83", "#cf222e")
"""Colours of the slices, dark enough for white numbers and light enough for a dark page, unlike Mermaid's own."""
PARTS: tuple[tuple[str, re.Pattern[str]], ...] = (
    ("Ubuntu", pattern(r"^(?:ADD|COPY) \S+ (?:in )?/$")),
    ("files", pattern(r"^(?:ADD|COPY)\b")),
    ("rosdep", pattern(r"\brosdep install\b|\binstall-rosdep-keys\b")),
    ("conda", pattern(r"\b(?:conda|mamba|micromamba)\s+(?:install|create|env)\b")),
    (
        "pip",
        re.compile(
            r"\b(?:pip[\d.]*|poetry|pdm|pipenv|uv)\s+(?:install|sync)\b|-m venv\b|"
            r"\binstall-(?:optional-pip|cloned-files)\b"
        ),
    ),
    ("apt", pattern(r"\bapt(?:-get)?\s+(?:-\S+\s+)*install\b|\binstall-(?:optional-apt|icub)\b")),
    ("compiled", pattern(r"\b(?:colcon|catkin_make\w*|catkin|cmake|make|ninja|nvcc|cargo)\b")),
)
"""What made a layer, by its instruction; the first match counts. https://docs.docker.com/reference/dockerfile/"""


@dataclass(frozen=True, kw_only=True, slots=True)
class LayerSize:
    """One layer of an image."""

    size: int
    """Compressed bytes."""
    text: str
    """The instruction that made it, ``""`` if it is not known."""
    base: bool


def chart(platform: str, layers: Iterable[LayerSize]) -> str:
    """Return a pie chart of what the layers hold, which GitHub renders: https://mermaid.js.org/syntax/pie.html.

    Labels are short and letters large, because a phone shows the chart at half its size. If a base does not describe
    its layers, the file system that it started from is labelled as Ubuntu's.
    """
    sizes: dict[str, int] = {}
    for layer in layers:
        name = BASE if layer.base else part(layer.text)
        sizes[name] = sizes.get(name, 0) + layer.size
    total = sum(sizes.values())
    small = [name for name, size in sizes.items() if size < SMALLEST * total]
    kept = sorted((name for name in sizes if name not in small), key=lambda name: (name != BASE, -sizes[name]))
    lines = [f'    "{name} {human(sizes[name])}" : {sizes[name] / 1e6:.3f}' for name in kept]
    look = {
        "pieOpacity": "1",
        "pieSectionTextColor": "#ffffff",
        "pieSectionTextSize": "21px",
        "pieLegendTextSize": "21px",
        "pieTitleTextSize": "21px",
        "pieStrokeColor": "#8c959f",
        "pieOuterStrokeColor": "#8c959f",
        **{f"pie{number}": colour for number, colour in enumerate(COLOURS, 1)},
    }
    # A Mermaid that is too old for `legendPosition` puts a smaller legend at the right
    settings = json.dumps({"pie": {"legendPosition": "bottom"}, "themeVariables": look})
    head = f"%%{{init: {settings}}}%%"
    return block("\n".join([head, f"pie title Download for {platform}", *lines]), "mermaid")


def part(history: str) -> str:
    """Return in two words what an image's history entry put into its layer."""
    said = re.sub(r"\s*# buildkit$", "", re.sub(r"^.*?#\(nop\)\s+", "", history)).strip()
    return next((name for name, pattern in PARTS if pattern.search(said)), "set-up")


def human(size: int) -> str:
    """Return a size as registries show it: ``1.23 GB``, ``45.6 MB``."""
    for unit, factor in (("GB", 1e9), ("MB", 1e6), ("kB", 1e3)):
        if size >= factor:
            return f"{size / factor:.{2 if unit == 'GB' else 1}f} {unit}"
    return f"{size} B"
