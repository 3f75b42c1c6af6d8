"""Which tool builds the workspace or the project."""

from __future__ import annotations

from roslab.config.model import BuildTool, Config, Kind
from roslab.decide.beside_cpp import of_cpp
from roslab.decide.decision import Choice
from roslab.decide.programs import top_of
from roslab.decide.python.image_python import Python
from roslab.decide.reasons import because, configured
from roslab.evidence.facts import Evidence
from roslab.knowledge import other_builders


class Weight:
    """Weights for kinds with only one tool: nothing competes with them."""

    ROS2 = 500
    CPP = 100


def _of_cpp(evidence: Evidence, *, said: bool) -> Choice[BuildTool]:
    """Return CMake, or none where make, which is no tool of this table, builds it, or a script of the repository.

    Nor where nothing shows what compiles it; ``said``: roslab.yaml says that it is C++.
    """
    if top_of(evidence) is None and not evidence.makefiles:
        for other in evidence.mentions:
            if other.topic == "other_builder" and other.value in other_builders.of_cpp():
                why = f"{other.value} builds it, which no step of the image calls"
                return Choice(answer="none", reasons=(because("build_tool", "none", why, other, weight=Weight.CPP),))
        if not said:
            why = "nothing shows how it is compiled"
            return Choice(answer="none", reasons=(because("build_tool", "none", why, weight=Weight.CPP),))
    return _made(evidence) or Choice(
        answer="cmake", reasons=(because("build_tool", "cmake", "plain C++", weight=Weight.CPP),)
    )


def _made(evidence: Evidence) -> Choice[BuildTool] | None:
    """Return none where a Makefile or a script builds the tree."""
    for made in evidence.makefiles:
        said = "a script compiles it, as a page says" if made.script else "make builds it, as its Makefile says"
        said = f"{made.by} and make build it" if made.by else said
        return Choice(answer="none", reasons=(because("build_tool", "none", said, made, weight=Weight.CPP),))
    return None


def decide_build_tool(evidence: Evidence, config: Config, kind: Kind, python: Python) -> Choice[BuildTool]:
    """Return the build tool: what roslab.yaml says, else the tool of the kind."""
    if config.build:
        return Choice(answer=config.build, reasons=(configured(config, "build_tool", config.build, "build"),))
    if kind == "ros1":
        from roslab.decide.ros.build_tool import tool_of_ros1  # noqa: PLC0415 - of one kind

        return tool_of_ros1(evidence)
    if kind == "ros2":
        from roslab.decide.ros.build_tool import alone  # noqa: PLC0415 - as above

        why = because("build_tool", "colcon", "ROS 2 is built by colcon", weight=Weight.ROS2)
        return alone(evidence) or Choice(answer="colcon", reasons=(why,))
    if kind == "cpp":
        return _of_cpp(evidence, said=config.kind is not None)
    from roslab.decide.python.build_tool import tool_of_python  # noqa: PLC0415 - as above

    choice = tool_of_python(evidence, python)
    top = top_of(evidence)
    no_python = choice.answer == "none" and not evidence.programs
    own = {each.folder for each in evidence.python if each.file.startswith(f"{each.folder}/".lstrip("/"))}
    beside = choice.answer == "pip" and not own & {*python.projects} and of_cpp(evidence)
    if kind == "cuda" and (no_python or beside) and top and not top.lacks:
        what = "a CMake project, with Python beside it" if beside else "a CMake project, and no Python"
        why = because("build_tool", "cmake", what, top, weight=Weight.CPP)
        return Choice(answer="cmake", reasons=(why,))
    return (_made(evidence) if kind == "cuda" and no_python else None) or choice
