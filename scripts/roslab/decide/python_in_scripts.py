"""Scripts of the default command that call ``python`` where that is Python 2, and pip's packages are for Python 3."""

from __future__ import annotations

from roslab.config.model import Config, Kind
from roslab.decide.decision import Choice
from roslab.decide.python.image_python import Python
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence
from roslab.evidence.prose.called_in_scripts import IN_SCRIPT, PYTHON
from roslab.knowledge.distros import codename_of, ubuntus_with_python2


def decide_python_in_scripts(evidence: Evidence, config: Config, kind: Kind, base: str, python: Python) -> Choice[None]:
    """Return a warning for such a script in an image of ROS; ``base``: its FROM."""
    by_pip = python.pip or python.pip_guessed or python.requirements or python.projects
    old = codename_of(base) in ubuntus_with_python2() and not (python.version or "").startswith("2")
    call = next((each for each in evidence.code if each.role == IN_SCRIPT and each.name == PYTHON), None)
    if call is None or not (old and by_pip) or kind not in {"ros1", "ros2"} or config.compatible:
        return Choice(answer=None)
    message = f"{call.file} calls `python`, which is Python 2 in this image, and pip installs for Python 3"
    return Choice(answer=None, warnings=(warn(f"{message}: write `python3` there, or set `command`", call),))
