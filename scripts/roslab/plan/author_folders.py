"""Where links in the places of the author's folders lead to."""

from __future__ import annotations

from roslab.decide.decision import Decision
from roslab.plan.ros_build import WORKSPACE
from roslab.plan.workspace import Workspace


def author_folders(decision: Decision, place: Workspace) -> tuple[tuple[str, str], ...]:
    """Return the author's folders, each with the folder below the user's home, or the path, that stands for it.

    None that is that folder itself, as where the image has the name by which code imports the repository, or that lies
    around it or in it, and none in the image's workspace.
    """
    sides = {"source": place.folder, "workspace": WORKSPACE}
    parted = ((folder, *target.partition("/")[::2]) for folder, target in decision.author_folders)
    led = ((folder, f"{sides[side]}/{rest}".rstrip("/") if side else f"/{rest}") for folder, side, rest in parted)
    own = (f"~/{place.folder}", f"~/{WORKSPACE}")
    return tuple((folder, target) for folder, target in led if not any(_touch(folder, each) for each in own))


def _touch(one: str, other: str) -> bool:
    """Tell whether one of two folders is, or lies in, the other."""
    return f"{one}/".startswith(f"{other}/") or f"{other}/".startswith(f"{one}/")
