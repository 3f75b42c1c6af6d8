"""A program opens the windows of the modules that it imports."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PAGE = "# Cart\n```\npython examples/linear.py\n```\n"
SHOW = "import matplotlib.pyplot as plt\ndef plot(show):\n    if show:\n        plt.show()\n"
VIEW = "import mujoco\nfrom mujoco import viewer as mjviewer\ndef run(m, d):\n    mjviewer.launch_passive(m, d)\n"


@pytest.mark.parametrize(
    ("line", "files", "gui"),
    [
        ("from lib.visualizer import plot", {"lib/visualizer.py": SHOW}, True),
        ("import lib.visualizer as v, sys", {"lib/visualizer.py": SHOW}, True),
        ("from core import run", {"examples/core.py": VIEW}, True),
        ("import mujoco", {"lib/visualizer.py": SHOW}, False),
        ("import mujoco\ndef late():\n    from lib.visualizer import plot", {"lib/visualizer.py": SHOW}, False),
    ],
)
def test_a_window_of_an_imported_module(tree: Tree, line: str, files: dict[str, str], gui: bool) -> None:
    decision = tree({"README.md": PAGE, "examples/linear.py": f"{line}\nimport mujoco\n", **files})
    assert decision.gui is gui
    assert (("MUJOCO_GL", "egl") in decision.variables) is not gui
