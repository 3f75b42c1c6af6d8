"""The Pythons that an image may have, the best choice for code of unknown age first."""

from __future__ import annotations

from roslab.values.interpreter import Interpreter
from roslab.values.version import minor_of

DEFAULT = "3.10"
"""The default: that of Ubuntu 22.04, for which most old and new wheels exist."""
PREFERRED = (DEFAULT, "3.8", "3.12", "3.9", "3.11", "3.7", "3.6", "3.13", "3.14", "3.5", "2.7")
"""Order of preference if several fit: first those in an Ubuntu, then those with most wheels."""
ANY = Interpreter(pythons=PREFERRED)
"""Any image, before anything is decided: enough to drop what applies to none (``sys_platform == 'win32'``)."""


def interpreter_of(version: str | None) -> Interpreter:
    """Return the interpreter for markers: the image's Python, or any Python if that is not known."""
    return Interpreter(pythons=(minor_of(version) or version,)) if version else ANY
