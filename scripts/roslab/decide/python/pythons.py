"""The Pythons that an image may have, the best for code of unknown age first."""

from __future__ import annotations

from roslab.values.interpreter import Interpreter

PREFERRED = ("3.10", "3.8", "3.12", "3.9", "3.11", "3.7", "3.6", "3.13", "3.14", "3.5", "2.7")
"""Where several fit: what an Ubuntu ships comes first, then what most wheels exist for."""
ANY = Interpreter(pythons=PREFERRED)
"""Before anything is decided: what holds in no image at all is told already (``sys_platform == 'win32'``)."""
