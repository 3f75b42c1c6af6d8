"""Scripts of the tree that start no program of it: they open a shell in which a person goes on, or a container.

So do those that stop because nobody has set a variable or wait for a password, and those that only install what others
need, add submodules or send the tree to another machine.
"""

from __future__ import annotations

import re

from roslab.evidence.facts import Mention
from roslab.repository.checkout import Repository
from roslab.values.endings import SHELL_SCRIPTS
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
_SHELL = r"[\"']?(?:\$\{?SHELL\}?|(?:/(?:usr/)?bin/)?(?:ba|z)sh)[\"']?"
_OPENS = pattern(
    rf"^[ \t]*(?:exec[ \t]+)?{_SHELL}[ \t]+(?:-\w[ \t]+){{0,3}}--(?:rcfile|init-file)\b|"
    rf"^[ \t]*(?:exec[ \t]+{_SHELL}|(?:exec[ \t]+)?{_SHELL}[ \t]+-i)[ \t]*$"
)
"""A shell with a file of its own to begin with, as a robot's ``baxter.sh`` opens it, or one that waits for a person."""
_CONTAINER = pattern(
    r"^[ \t]*(?:\w+=[\"']?)?(?:(?:sudo|exec|eval|then|else)[ \t]+)*(?:\w+=\S*[ \t]+)*"
    r"(?:(?:nvidia-)?docker|podman|singularity|apptainer)"
    r"(?:-compose|[ \t]+(?:compose|container|image|buildx))?[ \t]+(?:-[\w-]+(?:[ =][^\s-]\S*)?[ \t]+)*"
    r"(?:run|exec|start|up|build|pull|shell)(?![\w-])"
)
"""The host's engine, also in a variable that is called later: ``RUN_COMMAND="docker run …"``."""
_INSTALLS = pattern(
    r"^[ \t]*(?:(?:sudo|then|else|do)[ \t]+)*(?:pip[23]?|python[\d.]*[ \t]+-m[ \t]+pip|conda|mamba|micromamba|apt|"
    r"apt-get)[ \t]+(?:-\S+[ \t]+)*(?:install|create|env[ \t]+(?:create|update))\b|"
    r"^[ \t]*(?:(?:sudo|then|else|do)[ \t]+)*(?:cmake[ \t]+--install|(?:make|ninja)[ \t]+(?:-\S+[ \t]+)*install)\b",
    re.MULTILINE,
)
_OPTION = pattern(r"--?(?:with|install)[_-]?(?:deps|dependencies|requirements)|--install-\w+|--deps")
"""An option of a script that has it install something."""
_SENDS = pattern(
    r"^[ \t]*(?:(?:if|then|else|do|exec|sudo|time|!)[ \t]+)*(?:sshpass[ \t]+(?:-\S+[ \t]+(?:[\w\"'$][^\s-]*[ \t]+)?)*)?"
    r"(?:(?:rsync|scp)\b[^\n#]*[ \t][\"']?[\w.${}@-]+:[^\s;&|]*[ \t]*(?:$|[;&|>#])|sftp\b[^\n]*@|ssh[ \t]+[^\n]*@)",
    re.MULTILINE,
)
"""A copy to another machine, which is in the last word, or a command there: ``rsync -az . pi@robot.local:/home/pi``."""
_STARTS = pattern(
    r"^[ \t]*(?:(?:exec|eval|nohup|time|then|else|do)[ \t]+)*"
    r"(?:\w+=(?:\$\([^()\n]*\)|\$\{[^}\n]*\}|\"[^\"\n]*\"|'[^'\n]*'|[^\s\"'$(]|\$(?![({]))*[ \t]+)*"
    r"(?:python[\d.]*[ \t]+(?!-m[ \t]+pip\b|setup\.py\b|-[cV])|torchrun\b|accelerate[ \t]+launch|roslaunch\b|rosrun\b|"
    r"roscore\b|ros2[ \t]|jupyter\b|mpi(?:run|exec)\b|xvfb-run\b|rosbag[ \t]|gazebo\b|(?:gz|ign)[ \t]|"
    r"[\w.~-]*/|(?:ba)?sh[ \t]+(?![^\n;&|]*(?:install|setup|deps?|dependenc|build)[\w-]*\.(?:ba)?sh\b)\S|[$\"'])",
    re.MULTILINE,
)
"""A line that starts a program, or what a variable names; another script that installs is none."""


_PASSWORD = pattern(
    r"^[ \t]*(?:IFS=\S*[ \t]+)?read[ \t]+(?!(?:\S+[ \t]+)*-\w*[nN])(?:-[\w.]+[ \t]+)*-\w*s\w*\b", re.MULTILINE
)
"""It waits for words that are not shown; of ``-n 1`` any key is enough."""
_SUBMODULES = pattern(r"^[ \t]*git[ \t]+(?:-\S+[ \t]+)*submodule[ \t]+(?:add|init|deinit|sync)\b", re.MULTILINE)


def leads_elsewhere(mention: Mention, repository: Repository) -> bool:
    """Tell whether a command runs a script that ends in a shell, or starts a container or no program at all."""
    scripts = [file for file in mention.files if file.endswith(SHELL_SCRIPTS)]
    asked = any(map(_OPTION.fullmatch, mention.value.split()))
    return any(_leads_elsewhere(repository.read(script, limit=MAX_SIZE), asked=asked) for script in scripts[:1])


def _leads_elsewhere(text: str, *, asked: bool) -> bool:
    """Tell this of a script's text; ``asked``: it is called with an option to install something."""
    from roslab.evidence.prose.unset import stops_unset  # noqa: PLC0415 - few scripts stop so

    text = text.replace("\\\n", " ")
    aside = asked or any(each.search(text) for each in (_INSTALLS, _SENDS, _SUBMODULES))
    if aside and not _STARTS.search(text):
        return True
    if _PASSWORD.search(text):
        return True
    return stops_unset(text) or starts_container(text) or any(map(_OPENS.match, text.splitlines()))


def starts_container(text: str) -> bool:
    """Tell whether a line of a script calls the engine that starts containers."""
    return any(map(_CONTAINER.match, text.splitlines()))
