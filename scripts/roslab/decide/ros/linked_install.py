"""Whether colcon installs links to the source: some programs find the modules beside them in no other way."""

from __future__ import annotations

from roslab.config.model import BuildTool, Config
from roslab.evidence.facts import Evidence
from roslab.evidence.python.omitted_packages import hidden_by_links

OPTION = "--symlink-install"


def by_links(evidence: Evidence, config: Config, build_tool: BuildTool) -> bool:
    """Tell whether a program imports what lies beside it and is not installed, where the author's build makes links.

    Python looks beside the file that a link leads to; so it finds the folders that a setup.py leaves out of its
    packages. Elsewhere nothing is linked: copies need no build tree.
    """
    if build_tool != "colcon" or config.compatible or OPTION in config.build_args:
        return False
    said = (m for m in evidence.mentions if m.topic == "build_tool" and m.value == "colcon")
    return any(OPTION in m.text for m in said) and (
        any(m.topic == "left_beside" for m in evidence.mentions) or any(map(hidden_by_links, evidence.problems))
    )
