"""Entry points of an author's image that no command reaches, and what their scripts expect to be there."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.author_command import entry_point_of, taken_by
from roslab.decide.decision import Warning_
from roslab.evidence.entry_script import EntryScript
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
    return (*warnings, *_absent(authored, entry))


def _absent(authored: AuthorDockerfile, entry: EntryScript) -> Iterator[Warning_]:
    """Yield a warning for each folder that the script changes to and that the image has only where it is mounted."""
    volumes = authored.service.volumes if authored.service else ()
    for folder, part, line in entry.absent:
        if any(f"{folder}/".startswith(f"{target.rstrip('/')}/") for _, target, _ in volumes):
            how = "it is there only as the volume of Docker Compose, which docker_run.sh mounts"
        else:
            then = "a container stops there" if entry.stops else "a container goes on in another folder"
            how = f"neither the tree nor a step of the Dockerfile names {part}: {then} unless it is mounted"
        yield Warning_(message=f"{entry.file} changes to {folder}; {how}", file=entry.file, line=line)


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
