"""Entry points of an author's image that no command reaches, and the variables that their scripts expect."""

from __future__ import annotations

from roslab.decide.author_command import entry_point_of, taken_by
from roslab.decide.decision import Warning_
from roslab.evidence.facts import AuthorDockerfile


def stops(authored: AuthorDockerfile) -> bool:
    """Tell whether a container that is given nothing runs a script that ends in a shell and lacks variables."""
    entry = authored.entry
    return entry is not None and entry.takes == "nothing" and entry.shell and bool(entry.unset)


def told(authored: AuthorDockerfile, command: tuple[str, ...] | str) -> tuple[Warning_, ...]:
    """Return what there is to say about the entry point of an image whose containers start ``command``."""
    entry = authored.entry
    if entry is None:
        return _of_line(authored)
    warnings = []
    if taken_by(authored) == "nothing" and entry_point_of(authored) in {"shell", "program"}:
        message = (
            f"ENTRYPOINT starts {entry.file}, which never starts the command that it is given: commands, the tests and"
            " the shell of docker_run.sh take its place (`--entrypoint`)"
        )
        warnings.append(Warning_(message=message, file=entry.file, line=entry.line))
    given = _composed(authored)
    here = command if isinstance(command, tuple) else ()
    for name, line in entry.unset:
        if name not in given:
            how = "neither it nor the Dockerfile sets it: give a container --option --env=" + f"{name}=VALUE"
        elif f"{name}={given[name]}" in here:
            how = f"docker_run.sh gives it {given[name]}, as Docker Compose would"
        else:
            how = f"Docker Compose would set it to {given[name]}: give a container --option --env={name}=VALUE"
        warnings.append(Warning_(message=f"{entry.file} reads {name}; {how}", file=entry.file, line=line))
    return tuple(warnings)


def _of_line(authored: AuthorDockerfile) -> tuple[Warning_, ...]:
    """Return a warning for a line of a shell that starts a program and never looks at what it is given."""
    if taken_by(authored) != "nothing":
        return ()
    message = (
        'ENTRYPOINT is a line of a shell without "$@", so no command reaches it: commands, the tests and the shell of'
        " docker_run.sh take its place (`--entrypoint`)"
    )
    return (Warning_(message=message, file=authored.file, line=authored.command_line or authored.line),)


def _composed(authored: AuthorDockerfile) -> dict[str, str]:
    return dict(authored.service.environment) if authored.service else {}
