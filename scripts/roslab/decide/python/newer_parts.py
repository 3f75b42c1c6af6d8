"""Parts of modules that the distribution's package of an image of ROS is too old for: ``cv2.typing`` of OpenCV 4.8."""

from __future__ import annotations

from collections.abc import Iterator, Set

from roslab.config.model import Kind
from roslab.evidence import places
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import imports
from roslab.knowledge.guesses import same_module
from roslab.knowledge.system_modules import system_modules
from roslab.values.requirement import Requirement
from roslab.values.requirement_line import stated
from roslab.values.version import Version


def newer_parts(evidence: Evidence, kind: Kind, known: Set[str], ubuntu: str | None) -> Iterator[Requirement]:
    """Yield what pip brings in place of such a package; ``known``: what it installs anyway, by any name of the module.

    Not where the package of the ``ubuntu`` has that part; of several parts the newest counts. A release is taken that
    leaves the Ubuntu's own NumPy as it is, if one has the part. Without ROS nothing comes from the distribution, and
    pip takes the newest release by itself.
    """
    found: dict[str, Requirement] = {}
    for used in evidence.mentions if kind in {"ros1", "ros2"} else ():
        if used.topic != "companion" or not (imports().get(used.value) or (None, None))[1] or places.aside(used.file):
            continue
        asked = stated(used.text, "import", used.file, used.line)
        if not asked.at_least or asked.key in known or any(same_module(asked.key, each) for each in known):
            continue
        least, there = Version(asked.at_least), system_modules().get((ubuntu or "", used.value))
        if there and least <= Version(there.version):
            continue
        if there and there.below and least < Version(there.below):
            asked = stated(f"{used.text},<{there.below}", "import", used.file, used.line)
        before = found.get(asked.key)
        if before is None or Version(before.at_least or "0") < least:
            found[asked.key] = asked
    yield from found.values()
