"""docker_run.sh: runs the image with its volumes, ports, screen and graphics card, and needs only docker."""

from __future__ import annotations

from roslab.config.model import Volume
from roslab.errors import ConfigurationError, Problem
from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.output import Beside
from roslab.render.script import script
from roslab.values.pattern import pattern

IMAGE_USER = "1000"
_PORT = pattern(
    r"(?:(?P<address>\d+(?:\.\d+){3}|\[[0-9A-Fa-f:]+\]):)?(?:(?P<host>\d+(?:-\d+)?):)?(?P<container>\d+(?:-\d+)?)"
    r"(?P<protocol>/(?:tcp|udp|sctp))?"
)
_OPTION = pattern(r"ro|rw|z|Z|cached|consistent|delegated|nocopy|r?private|r?shared|r?slave")
_MAC = pattern(r"[0-9A-Fa-f]{2}(?:[:-][0-9A-Fa-f]{2}){5}")


def text(plan: Plan, beside: Beside) -> str:
    """Return docker_run.sh for the folder it is written to."""
    return run_script(plan, context=beside.context)


def run_script(plan: Plan, *, context: str) -> str:
    """Return the script's text; ``context`` is the repository, relative to the folder the script is written to.

    Raises ``ConfigurationError`` for a volume, port or address that docker would misread.
    """
    run = plan.run
    command = run.command if isinstance(run.command, str) else quote.words(run.command)
    if plan.author_dockerfile:
        command = command or "(the command of its Dockerfile)"
    given = run.given
    return script(
        "docker_run.sh",
        {
            "image": plan.name,
            "context": context,
            "default_command": command,
            "given": [list(given.command)] if given else [],
            "own_entrypoint": _word(not given or given.entrypoint),
            "entrypoint_takes": run.entrypoint_takes,
            "image_user": "" if plan.author_dockerfile else IMAGE_USER,  # the author's Dockerfile sets its own user
            "gui": _word(run.gui),
            "gpu": _word(run.gpu),
            "notebook": "unknown" if plan.author_dockerfile else _word(plan.notebook),
            "volumes": [_volume(volume) for volume in run.volumes],
            "made": [[volume.container_path] for volume in run.volumes if volume.made],
            "ports": [[_port(port)] for port in run.ports],
            "matlab": _place(run.matlab.host_path) if run.matlab else "",
            "mac_address": _mac(run.matlab.mac_address) if run.matlab and run.matlab.mac_address else "",
        },
    )


def _word(said: bool) -> str:
    return "yes" if said else "no"


def _volume(volume: Volume) -> tuple[str, str, str]:
    """Return the three words of a volume, without colons: docker splits at them, so one would change the mount."""
    if not volume.container_path.startswith("/"):
        raise _wrong(f"the volume at {volume.container_path!r}", "a folder of the container begins with /")
    options = volume.options.split(",") if volume.options else []
    if unknown := [word for word in options if not _OPTION.fullmatch(word)]:
        raise _wrong(f"{unknown[0]!r} as an option of a volume", "write ro, rw, z or Z")
    return _place(volume.host_path), _place(volume.container_path), volume.options


def _place(path: str) -> str:
    if not path or ":" in path or ".." in path.split("/"):
        raise _wrong(f"{path!r} as a folder", "write a path without `:` and without `..`")
    return path


def _port(text: str) -> str:
    """Return docker's notation for a port; without an address it is open to this machine only, not to its network."""
    match = _PORT.fullmatch(text)
    if not match:
        raise _wrong(f"{text!r} as a port", "write CONTAINER, HOST:CONTAINER or ADDRESS:HOST:CONTAINER")
    container = match["container"]
    return f"{match['address'] or '127.0.0.1'}:{match['host'] or container}:{container}{match['protocol'] or ''}"


def _mac(address: str) -> str:
    if not _MAC.fullmatch(address):
        raise _wrong(f"{address!r} as a MAC address", "write six pairs: 2c:60:0c:d6:50:36")
    return address


def _wrong(what: str, hint: str) -> ConfigurationError:
    return ConfigurationError(Problem(message=f"docker cannot take {what}", hint=hint))
