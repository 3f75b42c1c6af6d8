"""Whether pages build a repository by CMake, by pip, or by the build tools of ROS."""

from __future__ import annotations

from roslab.config.model import WORKSPACE_TOOLS
from roslab.evidence.facts import Evidence, Mention
from roslab.values.name import canonicalize_name


def built_by_page(evidence: Evidence) -> Mention | None:
    """Return where the page at the root runs CMake, ``None`` if it does not, or has pip install the repository."""
    return None if by_pip(evidence) else page_of_cmake(evidence)


def without_ros(evidence: Evidence) -> bool:
    """Tell whether the page at the root builds the repository by CMake, and no page names a build tool of ROS."""
    tools = {m.value for m in evidence.mentions if m.topic == "build_tool"}
    return tools.isdisjoint(WORKSPACE_TOOLS) and built_by_page(evidence) is not None


def only_by_pip(evidence: Evidence) -> bool:
    """Tell whether the pages have pip install the repository, which compiles it, and the page at the root no CMake."""
    return by_pip(evidence) and page_of_cmake(evidence) is None


def by_pip(evidence: Evidence) -> bool:
    """Tell whether the pages have pip install the repository, from its folder or by its name."""
    names = {canonicalize_name(project.name) for project in evidence.python if not project.folder and project.name}
    return any(asked.role == "project" or asked.key in names for asked in evidence.prose_pip)


def page_of_cmake(evidence: Evidence) -> Mention | None:
    """Return where the page at the root runs CMake, ``None`` if it does not."""
    said = (m for m in evidence.mentions if m.topic == "build_tool" and m.value == "cmake" and m.source == "readme")
    return next((mention for mention in said if "/" not in mention.file), None)
