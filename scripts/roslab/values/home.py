"""The home of the image's own user."""

from __future__ import annotations

HOME = "/home/jovyan"
"""The user is called as that of Jupyter's images."""
