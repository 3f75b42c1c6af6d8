"""Pictures of a virtual display during a proof; the newest one that shows something is kept.

A program that ends by itself closes its windows without notice, so pictures are taken again and again. Pillow talks to
the X server: its wheels contain all that it needs, while smaller libraries need X's own on the machine. It is an extra
of the package: without it a proof has a display but no picture.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from roslab.prove.display import Display
from roslab.values.dataclass import dataclass, field

if TYPE_CHECKING:
    from PIL.Image import Image

NO_PILLOW = "Pillow is not installed (pip install Pillow)"


@dataclass(frozen=True, kw_only=True, slots=True)
class Screenshot:
    """The picture of a proof's screen."""

    file: Path | None = None
    remark: str = ""
    """That nothing was drawn, or why there is no picture; ``""`` if all is well."""

    def __str__(self) -> str:
        parts = (f"screenshot: {self.file}" if self.file else "no screenshot", self.remark)
        return "; ".join(part for part in parts if part)


@dataclass(kw_only=True, slots=True)
class Camera:
    """Takes pictures of one display and remembers the newest that shows something, else the newest."""

    display: Display
    drawn: bool = False
    """Something was seen: more than one colour."""
    _newest: Image | None = field(default=None, init=False)
    _problem: str = field(default="", init=False)

    @property
    def blind(self) -> bool:
        """Whether no picture can be taken."""
        return bool(self._problem)

    def look(self) -> None:
        """Take a picture; a failure does not end the proof."""
        try:
            from PIL import ImageGrab  # noqa: PLC0415 - an extra, and only a proof with windows needs it
        except ImportError:
            self._problem = NO_PILLOW
            return
        try:
            with _key(self.display.key):
                picture = ImageGrab.grab(xdisplay=self.display.name)
        except OSError as error:
            self._problem = f"the display gives no picture: {error}"
            return
        self._problem = ""
        shows = picture.getcolors(1) is None
        if shows or not self.drawn:
            self._newest = picture
        self.drawn = self.drawn or shows

    def keep(self, file: Path) -> Screenshot:
        """Write the picture as PNG and return it, or why there is none."""
        if self._newest is None:
            return Screenshot(remark=self._problem or "the program did not start")
        try:
            file.parent.mkdir(parents=True, exist_ok=True)
            self._newest.save(file, format="PNG", optimize=True)
        except OSError as error:
            return Screenshot(remark=f"{file} cannot be written: {error.strerror or error}")
        return Screenshot(file=file, remark="" if self.drawn else "nothing was drawn: it is wholly blank")


def file_name(platform: str, proof: str) -> str:
    """Return the picture's name: ``screenshot-linux-arm64-default-command-starts.png``."""
    words = re.sub(r"[^a-z0-9]+", "-", f"{platform} {proof.removeprefix('the ')}".lower().replace("'s ", " "))
    return f"screenshot-{words.strip('-')}.png"


@contextmanager
def _key(file: Path) -> Iterator[None]:
    """Let this process's X library find the display's key while the context lasts; only a variable can tell it."""
    before = os.environ.get("XAUTHORITY")
    os.environ["XAUTHORITY"] = str(file)
    try:
        yield
    finally:
        if before is None:
            del os.environ["XAUTHORITY"]
        else:
            os.environ["XAUTHORITY"] = before
