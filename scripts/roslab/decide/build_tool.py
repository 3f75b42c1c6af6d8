"""With which tool the workspace or the project is built."""

from __future__ import annotations

from roslab.config.model import BuildTool, Config, Kind
from roslab.decide.decision import Python, Reason
from roslab.decide.reasons import configured, ranked
from roslab.decide.ros.workspace import packages_of, types
from roslab.evidence import places
from roslab.evidence.facts import Evidence, Mention

_SOURCES = {"readme": 400, "dockerfile": 420, "ci": 380, "script": 300}


def decide_build_tool(
    evidence: Evidence, config: Config, kind: Kind, python: Python
) -> tuple[BuildTool, tuple[Reason, ...]]:
    """Return the build tool with its reasons."""
    if config.build:
        return config.build, (configured(config, "build_tool", config.build, "build"),)
    if kind == "ros2":
        return "colcon", (
            Reason(question="build_tool", answer="colcon", reason="ROS 2 is built by colcon", weight=500),
        )
    if kind == "ros1":
        return _ros1(evidence)
    if kind == "cpp":
        return "cmake", (Reason(question="build_tool", answer="cmake", reason="plain C++", weight=100),)
    return _python(evidence, python)


def _ros1(evidence: Evidence) -> tuple[BuildTool, tuple[Reason, ...]]:
    reasons = [
        Reason(question="build_tool", answer=m.value, reason=m.text[:120], file=m.file, line=m.line, weight=_weight(m))
        for m in evidence.mentions
        if m.topic == "build_tool" and m.value in {"catkin_make", "catkin_tools"}
    ]
    plain = [m for m in packages_of(evidence).built if types(m, 1) == {"cmake"}]
    if plain:
        reasons.append(
            Reason(
                question="build_tool",
                answer="catkin_tools",
                reason="a plain CMake package, which catkin_make refuses",
                file=plain[0].file,
                line=plain[0].line,
                weight=350,
            )
        )
    simple = next((p for p in evidence.cmake for d in p.dependencies if d.name == "catkin_simple"), None)
    if simple:
        reasons.append(
            Reason(
                question="build_tool",
                answer="catkin_tools",
                reason="catkin_simple, of the same hands as catkin_tools",
                file=simple.file,
                line=1,
                weight=250,
            )
        )
    if not reasons:
        reasons.append(Reason(question="build_tool", answer="catkin_make", reason="ROS 1's own", weight=1))
    best = max(reasons, key=lambda reason: reason.weight)
    answer: BuildTool = "catkin_tools" if best.answer == "catkin_tools" else "catkin_make"
    return answer, ranked(reasons, answer)


def _weight(mention: Mention) -> int:
    """Rank a build command by where it stands; an isolated build is what CI runs, hardly ever what people do."""
    weight = _SOURCES.get(mention.source, 100) - (5 if mention.source == "dockerfile" else 30) * mention.file.count("/")
    if places.vendored(mention.file):
        weight -= 200
    if places.documentation(mention.file):
        weight -= 50
    return weight - (100 if "isolated" in mention.text else 0)


def _python(evidence: Evidence, python: Python) -> tuple[BuildTool, tuple[Reason, ...]]:
    if python.conda_file:
        return "conda", (
            Reason(
                question="build_tool",
                answer="conda",
                reason="a conda environment",
                file=python.conda_file,
                line=1,
                weight=300,
            ),
        )
    said = next((d for d in evidence.prose if d.namespace == "pip" and d.role not in {"option", "conda"}), None)
    if python.projects or python.requirements or python.pip or said:
        file = next(iter(python.requirements), None) or next(
            (p.file for p in evidence.python if (p.folder or ".") in python.projects), None
        )
        return "pip", (
            Reason(
                question="build_tool",
                answer="pip",
                reason="Python packages",
                file=file or (said.file if said else None),
                line=1,
                weight=300,
            ),
        )
    if any(p.top_level and "/" not in p.file for p in evidence.cmake):
        return "cmake", (
            Reason(
                question="build_tool",
                answer="cmake",
                reason="a CMake project",
                file="CMakeLists.txt",
                line=1,
                weight=200,
            ),
        )
    return "none", (
        Reason(question="build_tool", answer="none", reason="nothing to build, and no manifest to install", weight=1),
    )
