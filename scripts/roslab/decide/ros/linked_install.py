"""Whether colcon installs links to the source: some programs find the modules beside them in no other way."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.config.model import BuildTool, Config
from roslab.decide.decision import Warning_
from roslab.evidence.facts import Evidence

OPTION = "--symlink-install"


def by_links(evidence: Evidence, config: Config, build_tool: BuildTool) -> bool:
    """Tell whether a program imports what lies beside it and is not installed, where the author's build makes links.

    Python looks beside the file that a link leads to; so it finds the folders that a setup.py leaves out of its
    packages. Elsewhere nothing is linked: copies need no build tree.
    """
    if build_tool != "colcon" or config.compatible or OPTION in config.build_args:
        return False
    said = (m for m in evidence.mentions if m.topic == "build_tool" and m.value == "colcon")
    mended = {"left_beside", "omitted_package"}
    return any(OPTION in m.text for m in said) and any(m.topic in mended for m in evidence.mentions)


def omitted(evidence: Evidence) -> Iterator[Warning_]:
    """Yield a warning for each folder that a setup.py leaves out and a program imports."""
    for each in (m for m in evidence.mentions if m.topic == "omitted_package"):
        what = f"`packages` of {each.file} leaves out {each.value}, which {each.text} imports: what starts it stops, "
        hint = f"except where colcon installs links (`{OPTION}`); write `packages=find_packages()`"
        yield Warning_(message=f"{what}{hint}", file=each.file, line=each.line)
