"""What a container of the image needs to start, and what it is given where the image does not start its command."""

from __future__ import annotations

from roslab.config.model import Matlab, Volume
from roslab.decide.decision import Decision
from roslab.evidence.entry_script import Taken
from roslab.values.dataclass import dataclass

WORKSPACES = (
    "for setup in /opt/ros/*/setup.bash $(find / -xdev -maxdepth 6 "
    "-regextype posix-extended -regex '.*/(devel|install)(_isolated)?/setup.bash' 2>/dev/null); "
    'do . "$setup" --extend; done; '
)
"""An author's Dockerfile may leave it to its command, or to .bashrc, to make its workspace known."""
_MASTER = (
    'if [[ "${ROS_MASTER_URI:-}" =~ ^http://(localhost|127[.]0[.]0[.]1):([0-9]+) ]]; then port="${BASH_REMATCH[2]}"; '
    'answers() { (: <"/dev/tcp/localhost/${port}") 2>/dev/null; }; '
    'if ! answers; then roscore -p "${port}" >/dev/null 2>&1 & '
    "for _ in {1..50}; do answers && break; sleep 0.2; done; fi; fi; "
)
"""What ``rosrun`` starts waits for a master, which no author's image starts beside it, as ours do."""
_COMPILED = (
    'command -v "$1" >/dev/null || PATH="$PATH:$(dirname "$(find / -xdev -type f -perm -u+x -name "$1" -print -quit '
    '2>/dev/null)")"; '
)
"""An author's Dockerfile may leave what it compiled where it was compiled."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Given:
    """What follows the image's name where a container is started."""

    command: tuple[str, ...]
    """An argv."""
    entrypoint: bool
    """The image's own entry point starts it; otherwise the first word takes its place."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Run:
    """What a container of the image needs to start."""

    command: tuple[str, ...] | str
    candidates: tuple[tuple[str, ...], ...]
    gui: bool
    gpu: bool
    volumes: tuple[Volume, ...]
    ports: tuple[str, ...]
    matlab: Matlab | None
    given: Given | None = None
    """What a container of the author's image has to be given; ``None``: the image starts the command by itself."""
    entrypoint_takes: Taken = "commands"
    """What the image's entry point does with words that a container is given."""


def given(decision: Decision) -> Given | None:
    """Return what a container is given, ``None`` where the image starts its command by itself.

    A program of ROS runs with the workspaces that are found in the image.
    """
    if not decision.command_given:
        return None
    command, ros = decision.command, decision.kind in ("ros1", "ros2")
    before = WORKSPACES if ros else ""
    before += _MASTER if decision.kind == "ros1" and command[:1] == ("rosrun",) else ""
    if command == ("bash",):
        argv: tuple[str, ...] = command
    elif isinstance(command, str):
        argv = ("bash", "-c", before + command)
    elif not decision.command_named and decision.build_tool == "cmake" and not ros:
        argv = ("bash", "-c", _COMPILED + 'exec "$@"', "start", *command)
    else:
        argv = ("bash", "-c", before + 'exec "$@"', "start", *command) if ros else command
    return Given(command=argv, entrypoint=decision.command_through_entrypoint)
