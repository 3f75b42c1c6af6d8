"""Parts of modules that the distribution's package of an image of ROS is too old for: ``cv2.typing`` of OpenCV 4.8."""

from __future__ import annotations

from collections.abc import Iterator, Set

from roslab.config.model import Kind
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import imports
from roslab.knowledge.guesses import same_module
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated


def newer_parts(evidence: Evidence, kind: Kind, known: Set[str]) -> Iterator[Requirement]:
    """Yield what pip brings in place of such a package; ``known``: what it installs anyway, by any name of the module.

    Without ROS nothing comes from the distribution, and pip takes the newest release by itself.
    """
    for used in evidence.mentions if kind in {"ros1", "ros2"} else ():
        if used.topic != "companion" or not (imports().get(used.value) or (None, None))[1] or places.aside(used.file):
            continue
        asked = stated(used.text, "import", used.file, used.line)
        if asked.at_least and asked.key not in known and not any(same_module(asked.key, each) for each in known):
            yield asked
