"""Trees whose programs are all for Python 3, also where ROS's own Python is 2."""

from __future__ import annotations

from roslab.evidence.facts import Evidence
from roslab.evidence.python.of_python3 import ROLE


def only_python3(evidence: Evidence) -> bool:
    """Tell whether the first line of a program asks for Python 3, and none for ``python``, and nothing for Python 2."""
    roles = {each.role for each in evidence.code}
    old = any(each.topic == "python" and each.value.startswith("2") for each in evidence.mentions)
    return ROLE in roles and "shebang" not in roles and not old
