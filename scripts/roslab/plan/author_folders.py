"""Where links in the places of the author's folders lead to."""

from __future__ import annotations

from roslab.decide.decision import Decision
from roslab.plan.ros_build import WORKSPACE
from roslab.plan.workspace import Workspace


def author_folders(decision: Decision, place: Workspace) -> tuple[tuple[str, str], ...]:
    """Return the author's folders, each with the folder below the user's home, or the path, that stands for it.

    None that is that folder itself, as where the image has the name by which code imports the repository.
    """
    sides = {"source": place.folder, "workspace": WORKSPACE}
    parted = ((folder, *target.partition("/")[::2]) for folder, target in decision.author_folders)
    led = ((folder, f"{sides[side]}/{rest}".rstrip("/") if side else f"/{rest}") for folder, side, rest in parted)
    return tuple((folder, target) for folder, target in led if folder != f"~/{target}")
