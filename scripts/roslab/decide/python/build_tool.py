"""The build tool of a project that is no ROS package: conda, pip, CMake or none."""

from __future__ import annotations

from roslab.config.model import BuildTool
from roslab.decide.decision import Choice
from roslab.decide.python.image_python import Python
from roslab.decide.reasons import because
from roslab.evidence.facts import Evidence
from roslab.values.origin import Place


class Weight:
    """The first tool that fits is used; the weights only tell how certain it is."""

    MANIFEST = 300
    CMAKE = 200  # it may only build a part
    NOTHING = 1


def tool_of_python(evidence: Evidence, python: Python) -> Choice[BuildTool]:
    """Return the build tool, derived from what the image's Python installs."""
    if python.conda_file:
        return _choice("conda", "a conda environment", python.conda_file, Weight.MANIFEST)
    said = next((asked for asked in evidence.prose_pip if asked.role not in {"option", "conda", "channel"}), None)
    if python.projects or python.requirements or python.pip or said:
        files = [*python.requirements, *(p.file for p in evidence.python if (p.folder or ".") in python.projects)]
        files += [said.file] if said else []
        return _choice("pip", "Python packages", files[0] if files else None, Weight.MANIFEST)
    if any(project.top_level and "/" not in project.file for project in evidence.cmake):
        return _choice("cmake", "a CMake project", "CMakeLists.txt", Weight.CMAKE)
    return _choice("none", "nothing to build, and no manifest to install", None, Weight.NOTHING)


def _choice(tool: BuildTool, why: str, file: str | None, weight: int) -> Choice[BuildTool]:
    place = Place(file=file, line=1) if file else None
    return Choice(answer=tool, reasons=(because("build_tool", tool, why, place, weight=weight),))
