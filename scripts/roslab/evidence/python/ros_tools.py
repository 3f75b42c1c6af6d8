"""What programs of Python start with ROS's tools in a tree without a package: ``"ros2 bag record /topic"``."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import places
from roslab.evidence.dependency import Dependency
from roslab.evidence.facts import Mention
from roslab.evidence.python.in_comment import in_comment
from roslab.evidence.python.modules import modules
from roslab.knowledge.released import ever_released
from roslab.knowledge.ros2_verbs import ros2_verbs
from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

_STARTING = frozenset({"system", "popen", "subprocess"})
_CALL = pattern(
    r"[\"'](?:sudo )?(?:(ros2)(?:[ \t]+|[\"'][ \t]*,\s{0,40}[\"'])"
    r"(run|launch|bag|topic|service|action|node|param|control|component|lifecycle)|"
    r"(rosrun|roslaunch|rosbag|rostopic|rosservice|rosparam)(?=\s|[\"']\s{0,40},))(?=[\s\"'])"
    r"(?:[\"',\s]{1,40}([A-Za-z]\w*)(?=[\s\"']))?"
)
"""In a string, or as the words of a list; what follows a tool that starts programs is their package.

https://docs.ros.org/en/rolling/Concepts/Basic/About-Command-Line-Tools.html, https://wiki.ros.org/ROS/CommandLineTools
(2026-11-29)
"""
_TOLD = pattern(r"\b(?:print|input|description|help|\w*log\w*(?:\.\w+)?|\w*[eE]rror)\s*\([^()]*$")
"""What stands before it on a line where it is only told."""
NEAR = 200
"""Most characters of a line before it that are looked at."""
_OF_PACKAGES = frozenset({"run", "launch", "rosrun", "roslaunch"})


def read(repository: Repository) -> Iterator[Mention]:
    """Yield the first such call of each file, with the tool: ``ros2 bag``; none of a tree with packages."""
    if repository.named("package.xml", "manifest.xml"):
        return
    told: set[str] = set()
    for file, line, tool, _ in _calls(repository):
        if file not in told:
            told.add(file)
            yield Mention(topic="ros_call", value=tool, source="code", file=file, line=line, text=tool)


def packages(repository: Repository) -> Iterator[Dependency]:
    """Yield the packages of what they start, and those that bring a tool, each once; none of a tree with packages."""
    found: set[str] = set()
    if repository.named("package.xml", "manifest.xml"):
        return
    for file, line, tool, word in _calls(repository):
        verb = tool.rpartition(" ")[2]
        name = word if verb in _OF_PACKAGES and ever_released(word) else ros2_verbs().get(verb, "")
        if name and name not in found:
            found.add(name)
            yield Dependency(namespace="ros", name=name, strength="used", file=file, line=line, role="exec")


def _calls(repository: Repository) -> Iterator[tuple[str, int, str, str]]:
    """Yield file, line and tool of each call, and the word behind it."""
    for module in modules(repository):
        text, path = module.text, module.file.path
        aside = places.vendored(path) or places.test(path) or places.aside(path)
        if aside or _STARTING.isdisjoint(module.words) or "ros" not in text:
            continue
        for match in _CALL.finditer(text):
            begin = max(text.rfind("\n", 0, match.start()) + 1, match.start() - NEAR)
            if not (in_comment(text, match.start()) or _TOLD.search(text, begin, match.start())):
                tool = f"ros2 {match[2]}" if match[1] else match[3]
                yield path, text.count("\n", 0, match.start()) + 1, tool, match[4] or ""
