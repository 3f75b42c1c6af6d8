"""The scripts that a Dockerfile carries in itself, so that what is the same in every image does not hide what is not.

They stand in a stage of their own, and each is copied where it is first used. BuildKit compares what is copied by
content: a changed script repeats the steps from its first use on and nothing before, wherever it stands in the file.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

from roslab.render.layers import shell

_FOLDER = Path(__file__).parent.parent / "image_scripts"
_COPY = re.compile(re.escape(shell.copy_script("NAME").rstrip()).replace("NAME", r"(\S+)"), re.MULTILINE)
_WHY = "# What is the same in every image, as small scripts; what belongs to this repository begins below them."


def stage(image: str) -> str:
    """Return the stage that holds the scripts that the text of the other stages copies; ``""`` where they copy none."""
    names = dict.fromkeys(_COPY.findall(image))
    parts = (shell.heredoc(f"/{name}", _text(name), executable=True) for name in names)
    return "\n".join((_WHY, "FROM scratch AS scripts", *parts)).rstrip("\n") if names else ""


@cache
def _text(name: str) -> str:
    return (_FOLDER / f"{name}.sh").read_text(encoding="utf-8")
