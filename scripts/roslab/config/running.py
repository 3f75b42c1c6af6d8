"""Custom commands, volumes, MATLAB, environment, secrets and command: what runs in the image, with which settings."""

from __future__ import annotations

import shlex
from typing import Literal, cast

from roslab.config.model import Custom, Generation, Matlab, ProofGoals, ProofLimits, TagParts, Volume
from roslab.config.node import Mapping, Node, Scalar, Sequence
from roslab.config.reading import Reading
from roslab.values.secret import variable

_FOLDERS = {"source": "source", "home": "home", "/": "root"}


def custom(reading: Reading, root: Mapping, generation: Generation) -> Custom | None:
    """Read ``custom``, which each format ran differently; ``None`` if there are no commands."""
    mapping = reading.mapping(root, "custom")
    if mapping is not None:
        commands = reading.values(mapping, "commands", "custom")
        if not commands:
            return None
        folder = _FOLDERS[reading.value(mapping, "folder", "custom.folder") or "source"]
        return Custom(
            commands=commands,
            as_root=reading.value(mapping, "user", "custom.user") != "jovyan",
            chained=reading.truth(mapping, "chained", "custom.chained") is not False,
            workdir="root" if folder == "root" else "home" if folder == "home" else "source",
        )
    commands = reading.values(root, "custom", "custom")
    if not commands:
        return None
    if generation == "paper":
        return Custom(commands=commands, as_root=False, chained=False, workdir="home")
    return Custom(commands=commands, as_root=True, chained=True, workdir="source" if generation == "today" else "root")


def volumes(reading: Reading, root: Mapping) -> tuple[Volume, ...]:
    """Read ``volume``; three entries with one key each, as in some real files, are one volume."""
    node = root.get("volume")
    reading.note("volume", root.key("volume"))
    found: list[dict[str, str]] = []
    starts: list[Node] = []
    for item in node.items if isinstance(node, Sequence) else ():
        if not isinstance(item, Mapping):
            continue
        said = ((key.text, value) for key, value in item.pairs)
        parts = {name: value.text.strip() for name, value in said if isinstance(value, Scalar)}
        if found and len(item.pairs) == 1 and not parts.keys() & found[-1].keys() and "host_path" not in parts:
            reading.warn("read as part of the volume above: its keys belong under one `-`", item)
            found[-1] |= parts
        else:
            found.append(parts)
            starts.append(item)
    volumes: list[Volume] = []
    for index, (parts, start) in enumerate(zip(found, starts, strict=True)):
        missing = [key for key in ("host_path", "container_path") if key not in parts]
        if missing:
            message = f"volume[{index}] has no `{missing[0]}`"
            reading.complain(message, "for example: `host_path: /media/data` and `container_path: /DATASET`", start)
            continue
        reading.note(f"volume.{len(volumes)}", start)
        options = parts.get("options", "")
        volumes.append(Volume(host_path=parts["host_path"], container_path=parts["container_path"], options=options))
    return tuple(volumes)


def matlab(reading: Reading, root: Mapping) -> Matlab | None:
    """Read ``matlab``, which stays on the author's host."""
    mapping = reading.mapping(root, "matlab")
    reading.note("matlab", root.key("matlab"))
    host_path = reading.value(mapping, "host_path", "matlab.host_path")
    if host_path is None:
        return None
    message = "MATLAB is mounted from the host and never part of the image: nobody without a licence can reproduce this"
    reading.warn(message, root.key("matlab"))
    return Matlab(host_path=host_path, mac_address=reading.value(mapping, "mac_address", "matlab.mac_address"))


def environment(reading: Reading, root: Mapping, key: str = "env") -> tuple[tuple[str, str], ...]:
    """Read ``env`` or ``args``: names and values in the order of the file."""
    mapping = reading.mapping(root, key)
    reading.note(key, root.key(key))
    if mapping is None:
        return ()
    for name, _ in mapping.pairs:
        reading.note(f"{key}.{name.text}", name)
    return tuple((name.text, value.text) for name, value in mapping.pairs if isinstance(value, Scalar))


def day(reading: Reading, root: Mapping, key: Literal["date", "pip_date"]) -> str | None:
    """Read a day; one that is no day or still to come is an error, and so are two: ``date`` is the day of pip's too."""
    text = reading.text(root, key, key)
    if text is None:
        return None
    if key == "pip_date" and "date" in root.names:
        reading.complain("pip_date: `date` is the day of pip's packages too", "leave one of them out", text.node)
    if text.value not in {"paper", "today"}:
        import datetime as dt  # noqa: PLC0415 - few files name a day

        try:
            named = dt.date.fromisoformat(text.value)
        except ValueError:
            reading.complain(f'{key}: there is no day "{text.value}"', "write YEAR-MONTH-DAY, or `paper`", text.node)
        else:
            # The day has begun somewhere on earth while UTC still has the one before
            if named > dt.datetime.now(dt.timezone.utc).date() + dt.timedelta(days=1):
                hint = "give a day that has been, or `paper`: the newest commit's"
                reading.complain(f"{key}: {text.value} is still to come, no archive has its packages", hint, text.node)
    return text.value


def secrets(reading: Reading, root: Mapping) -> tuple[str, ...]:
    """Read ``secrets``; two that would have one variable of the environment are an error."""
    found: dict[str, str] = {}
    for index, text in enumerate(reading.texts(root, "secrets", "secrets") or ()):
        reading.note(f"secrets.{index}", text.node)
        if (other := found.setdefault(variable(text.value), text.value)) != text.value:
            message = f"secrets: two are named {variable(text.value)} in the environment, {other} and {text.value}"
            reading.complain(message, "rename one of them", text.node)
    return tuple(found.values())


def tag_parts(reading: Reading, root: Mapping) -> TagParts:
    """Read ``tags``."""
    mapping = reading.mapping(root, "tags")
    reading.note("tags", root.key("tags"))
    prefix, suffix = (reading.value(mapping, part, f"tags.{part}") or "" for part in ("prefix", "suffix"))
    return TagParts(prefix=prefix, suffix=suffix)


def proof(reading: Reading, root: Mapping) -> ProofLimits:
    """Read ``proof``: the limits of the container in which the image is proved."""
    mapping = reading.mapping(root, "proof")
    reading.note("proof", root.key("proof"))
    usual = ProofLimits()
    pids = reading.value(mapping, "pids", "proof.pids")
    return ProofLimits(
        network=cast(Literal["bridge", "none"], reading.value(mapping, "network", "proof.network") or usual.network),
        memory=reading.value(mapping, "memory", "proof.memory"),
        pids=int(pids) if pids else usual.pids,
        new_privileges=reading.truth(mapping, "new_privileges", "proof.new_privileges") is True,
    )


def goals(reading: Reading, root: Mapping) -> ProofGoals:
    """Read ``proof``: how far the proof must get."""
    mapping = reading.mapping(root, "proof")
    rung, seconds = (reading.value(mapping, key, f"proof.{key}") for key in ("rung", "seconds"))
    return ProofGoals(
        rung=int(rung) if rung else None,
        seconds=int(seconds) if seconds else None,
        topics=(reading.values(mapping, "topics", "proof.topics") or ()) if mapping else (),
        play=reading.value(mapping, "play", "proof.play"),
    )


def command(reading: Reading, root: Mapping, key: str) -> tuple[str, ...] | str | None:
    """Read ``command`` or ``test``: a line of shell stays a string, a list of words a tuple."""
    node = root.get(key)
    reading.note(key, root.key(key))
    if isinstance(node, Sequence):
        return tuple(item.text for item in node.items if isinstance(item, Scalar)) or None
    return node.text.strip() if isinstance(node, Scalar) else None


def arguments(reading: Reading, root: Mapping, key: str) -> tuple[str, ...]:
    """Read ``build_args``: a list of words, or a line that is split by the rules of a shell."""
    node = root.get(key)
    reading.note(key, root.key(key))
    if isinstance(node, Sequence):
        return tuple(item.text for item in node.items if isinstance(item, Scalar))
    return tuple(shlex.split(node.text)) if isinstance(node, Scalar) and node.kind != "null" else ()
