"""Scripts that the pages nearest to the root run to compile something, as far as the image runs them."""

from __future__ import annotations

import posixpath
import re
import shlex

from roslab.config.model import Config, Kind
from roslab.decide.decision import OwnScript
from roslab.evidence import places
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.prose.own_scripts import BY_APT
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.pattern import pattern

MOST = 6
"""Most of them that are run."""
_UNREAD = pattern(r"(?:^|/)(?:build|make|compile)(?:[_-]\w+)*\.(?:sh|py)$")
"""What is run though nobody has read it, because it lies in a submodule that the image clones."""
ASIDE = pattern(
    r"\b(?:docker|docs?|documentation|tests?|wheels?|release|optional|windows?|mac\w*|jetson|real)\b", re.IGNORECASE
)
"""Words of a heading whose scripts the image does not run."""
_PLAIN = pattern(r"[\w./=+-]+")
WITHOUT_APT = "sudo() { :; } && apt() { :; } && apt-get() { :; } && export -f sudo apt apt-get"
"""What a script calls for its packages does nothing: the image has them, and the user of this step may install none."""


def by_author(config: Config) -> bool:
    """Tell whether roslab.yaml says what is compiled, and how."""
    return bool(config.compatible or config.custom or config.build)


def by_make_alone(evidence: Evidence, kind: Kind) -> bool:
    """Tell whether make compiles the tree, and of the scripts those alone that come before it."""
    listed = evidence.python or evidence.requirements or evidence.conda
    return bool(evidence.makefiles) and (kind == "cpp" or (kind == "cuda" and not listed))


def run_by_pages(evidence: Evidence, config: Config, kind: Kind) -> list[tuple[OwnScript, Mention]]:
    """Return the scripts that the image runs as a page does, each once with where it is said; none of a ROS workspace.

    Of a C++ project only those of copied libraries and submodules: CMake compiles the project itself.
    """
    if by_author(config) or kind not in {"python", "cuda", "cpp"} or by_make_alone(evidence, kind):
        return []
    modules = tuple(f"{git.name}/" for git in evidence.sources if git.kind == "submodule")
    absent = tuple(git.name for git in evidence.sources if git.kind == "submodule" and git.absent)
    said = [m for m in evidence.mentions if m.topic == "build_script" and m.source == "readme"]
    said = [m for m in said if not places.vendored(m.file) and not ASIDE.search(m.heading)]
    nearest = min((mention.file.count("/") for mention in said), default=0)
    found: dict[str, tuple[OwnScript, Mention]] = {}
    for mention in said:
        script = script_of(mention, absent) if mention.file.count("/") == nearest else None
        library = script and (places.vendored(script.path) or script.path.startswith(modules))
        if script and (kind != "cpp" or library):
            found.setdefault(script.path, (script, mention))
    return list(found.values())


def script_of(mention: Mention, absent: tuple[str, ...], unread: re.Pattern[str] = _UNREAD) -> OwnScript | None:
    """Return how a script is run from the root; ``None`` for one that is neither in the tree nor in a submodule.

    Of one in a submodule, only if its name is among the ``unread`` that may be run.
    """
    folder, script, *words = mention.value.split()
    folder = "" if folder == "." else folder
    if not all(map(_PLAIN.fullmatch, (script, *words))):
        return None
    if mention.files:
        path = mention.files[0]
    else:
        path = posixpath.normpath(posixpath.join(folder, script))
        inside = next((name for name in absent if f"/{name}/" in f"/{path}"), None)
        if not unread.search(path):
            return None
        if inside is not None:
            above = f"/{path}".index(f"/{inside}/")  # a page may begin above the root
            path, folder = path[above:], folder[above:] if inside in folder else ""
        elif folder and (ends := [name for name in absent if name.endswith(f"/{folder}")]) and len(ends) == 1:
            path, folder = posixpath.normpath(posixpath.join(ends[0], script)), ends[0]  # or below it
        else:
            return None
    program = "bash" if script.endswith(SHELL_SCRIPTS) else "python3"
    command = shlex.join((program, posixpath.relpath(path, folder or "."), *words))
    if mention.inside == BY_APT:
        command = shlex.join(("bash", "-c", f"{WITHOUT_APT} && {command}"))  # one command, which may get a prefix
    return OwnScript(folder=folder, path=path, command=command)
