"""Programs that only start another: managers of environments, MPI, a display without a screen."""

from __future__ import annotations

from roslab.evidence.lex.shell import Command
from roslab.values.pattern import pattern

_PYTHON = pattern(r"^i?python\d?(?:\.\d+)?$")
_MANAGERS = frozenset({"uv", "poetry", "pipenv", "pdm", "rye", "hatch", "conda", "mamba", "micromamba"})
SIMULATORS = {"gz": ("sim", "launch"), "ign": ("gazebo", "launch"), "gazebo": ()}
"""Programs of Gazebo, each with the words of which one follows; the last is Gazebo classic."""
_WORLD = pattern(r"\S+\.(?:world|sdf|ign|gzlaunch)")
_VERBS = frozenset({("launch",), ("run",), ("standalone",)})
"""Verbs of ``ros2`` that start something; the last is one of ``ros2 component``."""
_RUNNERS = _MANAGERS | {"pixi"}
"""Managers of environments: the image is the environment. What pixi runs may be the name of a task."""
_OF_TORCH = frozenset({"torch.distributed.launch", "torch.distributed.run", "accelerate.commands.launch"})
"""Modules that start a file on several GPUs, whose name follows their own options."""
_LAUNCHERS = {"torchpack": ("dist-run",), "accelerate": ("launch",), "horovodrun": (), "deepspeed": (), "srun": ()}
"""Programs that start another one on several GPUs, each with the word that says so."""
_WRAPPERS = frozenset({"xvfb-run", "mpirun", "mpiexec", "torchrun", "nohup", "time"})
_RUNNER_VALUED = frozenset(
    (
        *("-n", "-np", "-c", "-s", "-e", "-p", "-H", "--num_processes", "--config_file", "--num_gpus"),
        *("--with", "--extra", "--group", "--environment", "--python", "--package"),
    )
)
"""Options whose next word is their value."""


def started(command: Command) -> Command:
    """Return what ``uv run``, ``mpirun`` or ``xvfb-run`` starts, as Python starts it; other commands as they are."""
    command = _plain(command)
    words, lines = command.words, command.lines
    if words[0].startswith("./") and words[0].endswith(".py"):
        return command._replace(words=("python", words[0].removeprefix("./"), *words[1:]), lines=(lines[0], *lines))
    program = words[0].rpartition("/")[2]
    if program == "torchrun" or (_PYTHON.match(program) and words[1:2] == ("-m",) and _OF_TORCH & {*words[2:3]}):
        file = next((n for n, word in enumerate(words) if n > 2 * (program != "torchrun") and _begins(word)), 0)
        whole = command._replace(words=("python", *words[file:]), lines=(lines[0], *lines[file:]))
        return whole if file else command
    start = 2 if program in _RUNNERS and words[1:2] == ("run",) else 1 if program in _WRAPPERS else 0
    if program in _LAUNCHERS and words[1 : 1 + len(_LAUNCHERS[program])] == _LAUNCHERS[program]:
        start = 1 + len(_LAUNCHERS[program])
    while 0 < start < len(words) and words[start].startswith("-"):
        start += 2 if words[start] in _RUNNER_VALUED else 1
    if not 0 < start < len(words):
        return command
    rest = words[start:]
    if rest[0].endswith(".py"):
        return command._replace(words=("python", *rest), lines=(lines[start], *lines[start:]))
    if program == "pixi" and start > 2:  # options before the task
        return command._replace(words=(*words[:2], *rest), lines=(*lines[:2], *lines[start:]))
    known = _PYTHON.match(rest[0]) or program in _MANAGERS
    return command._replace(words=rest, lines=lines[start:]) if known else command


def by_ros(program: str, words: tuple[str, ...]) -> bool:
    """Tell whether a tool of ROS starts something: a launch file, a program, or a component in a process of its own.

    So does Gazebo that is given a world.
    """
    verbs = words[1:3] if words[1:2] == ("component",) else words[1:2]
    if program in SIMULATORS and (not SIMULATORS[program] or (verbs[:1] and verbs[0] in SIMULATORS[program])):
        return any(map(_WORLD.fullmatch, words))
    return program in {"roslaunch", "rosrun"} or (program == "ros2" and verbs[-1:] in _VERBS)


def _plain(command: Command) -> Command:
    """Return a call of a module without the options of Python before it: ``python -um demo`` is ``python -m demo``."""
    words, lines = command.words, command.lines
    if words[1:2] == ("-m",) or not _PYTHON.match(words[0].rpartition("/")[2]):
        return command
    from roslab.values.python_options import program_of_python  # noqa: PLC0415 - not for ROS

    program, rest = program_of_python(words)
    if program[:1] != ("-m",) or len(program) == 1:
        return command
    return command._replace(
        words=(words[0], *program, *words[rest:]), lines=(lines[0], lines[rest - 1], lines[rest - 1], *lines[rest:])
    )


def _begins(word: str) -> bool:
    """Tell whether a word begins what a launcher starts: a file of Python, or ``-m`` before a module."""
    return word.endswith(".py") or word in {"-m", "--module"}
