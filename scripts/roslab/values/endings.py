"""How the names of files end that one program reads."""

from __future__ import annotations

SHELL_SCRIPTS = (".sh", ".bash")
"""Those that bash runs."""
