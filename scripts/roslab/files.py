"""Writing files next to the author's: all or none, and never over a file that roslab did not write."""

from __future__ import annotations

import contextlib
import os
import stat
from collections.abc import Sequence
from pathlib import Path, PurePosixPath
from typing import Literal

from roslab.errors import ConfigurationError, Problem, RefusedError
from roslab.render.output import OutputFile, generated
from roslab.repository.checkout import printable
from roslab.values.dataclass import dataclass
from roslab.values.origin import Place

ELSEWHERE = "write to another folder with --output DIR"
_IN_PLACE = "it is changed in its own folder, which you must be allowed to write"
MAX_SIZE = 64 * 1024 * 1024
"""Bytes read of an existing file: roslab writes nothing longer."""
Action = Literal["created", "replaced", "unchanged"]


@dataclass(frozen=True, kw_only=True, slots=True)
class Written:
    """What happened to one file."""

    path: str
    action: Action

    def __str__(self) -> str:
        return f"{self.action:9} {self.path}"


def write_all(files: Sequence[OutputFile], folder: str | Path, *, force: bool = False) -> tuple[Written, ...]:
    """Write every file to a folder, or none of them.

    The folder is made if it is missing. An existing file with the same text stays; one that roslab wrote earlier is
    replaced with ``force``; any other obstacle stops the call before the first byte is written.

    Raises ``RefusedError`` naming every file in the way, ``ConfigurationError`` where the folder cannot be written.
    """
    folder = Path(folder)
    contents = {_relative(file): _encoded(file) for file in files}
    actions = _examine(files, contents, folder, force=force)
    wanted = [file for file in files if actions[file.path] != "unchanged"]
    made = _make_folders(folder, wanted)
    try:
        _replace([(folder / file.path, contents[file.path], file.executable) for file in wanted])
    except BaseException as error:
        _unmake(made)
        if isinstance(error, OSError):
            raise _unwritable(folder, error) from None
        raise
    return tuple(Written(path=file.path, action=actions[file.path]) for file in files)


def replace_with_backup(path: str | Path, text: str) -> Path:
    """Replace a file of the author's, with their consent; return the path of the old one, ``NAME.old``.

    Raises ``RefusedError`` where the path is a link or ``NAME.old`` already exists.
    """
    path = Path(path)
    backup = path.with_name(path.name + ".old")
    try:
        if not stat.S_ISREG(path.lstat().st_mode):
            raise RefusedError(
                Problem(message=f"{printable(str(path))} is not a regular file", hint="name the file itself")
            )
        old = path.read_bytes()
        if os.path.lexists(backup) and (backup.is_symlink() or not backup.is_file() or backup.read_bytes() != old):
            name = printable(str(backup))
            raise RefusedError(Problem(message=f"{name} already exists", hint="move it away first"))
        mode = stat.S_IMODE(path.stat().st_mode)
        _replace([(backup, old, False), (path, text.encode(), False)])
        path.chmod(mode)
    except OSError as error:
        raise _unwritable(path, error, hint=_IN_PLACE) from None
    return backup


def write_configuration(path: Path, old: str | None, new: str) -> None:
    """Write a roslab.yaml that the author asked for; the old one, if there is one, is kept as ``NAME.old``.

    Raises ``RefusedError`` as ``replace_with_backup``, ``ConfigurationError`` where it cannot be written.
    """
    if old is not None:
        replace_with_backup(path, new)
        return
    try:
        _replace([(path, new.encode(), False)])
    except OSError as error:
        raise _unwritable(path, error, hint=_IN_PLACE) from None


def _relative(file: OutputFile) -> str:
    path = PurePosixPath(file.path)
    if path.is_absolute() or ".." in path.parts or not path.parts or str(path) != file.path:
        raise RefusedError(Problem(message=f"{printable(file.path)} leads out of the folder"))
    return file.path


def _encoded(file: OutputFile) -> bytes:
    try:
        return file.text.encode()
    except UnicodeEncodeError as error:
        raise ConfigurationError(Problem(message=f"{file.path} cannot be written as UTF-8: {error.reason}")) from None


def _examine(
    files: Sequence[OutputFile], contents: dict[str, bytes], folder: Path, *, force: bool
) -> dict[str, Action]:
    """Decide what happens to each file; touch nothing."""
    actions: dict[str, Action] = {}
    problems: list[Problem] = []
    try:
        if folder.exists() and not folder.is_dir():
            name = printable(str(folder))
            raise ConfigurationError(Problem(message=f"{name} is a file, not a folder", hint="--output names a folder"))
        for file in files:
            if obstacle := _obstacle(folder, file.path):
                hint = f"move it away, or {ELSEWHERE}"
                problems.append(Problem(message=obstacle, hint=hint, origin=Place(file=file.path)))
                continue
            actions[file.path] = _action(folder / file.path, file, contents[file.path])
            if actions[file.path] == "replaced" and not force:
                message = "roslab wrote it earlier, and what it would write now differs"
                problems.append(
                    Problem(
                        message=message,
                        hint="--force replaces it, and any edit of yours in it",
                        origin=Place(file=file.path),
                    )
                )
    except OSError as error:
        raise _unwritable(folder, error) from None
    if problems:
        raise RefusedError(*problems)
    return actions


def _obstacle(folder: Path, relative: str) -> str | None:
    """Return what is in the way of a file and was not written by roslab, ``None`` if nothing is."""
    *parts, _ = PurePosixPath(relative).parts
    for part in parts:
        folder /= part
        if folder.is_symlink() or (folder.exists() and not folder.is_dir()):
            return f"{printable(part)} is a link or a file, not a folder"
    path = folder / PurePosixPath(relative).name
    if not os.path.lexists(path):
        return None
    mode = path.lstat().st_mode
    if stat.S_ISLNK(mode):
        return "it is a link, and roslab does not write through links"
    if not stat.S_ISREG(mode):
        return "it is a folder" if stat.S_ISDIR(mode) else "it is not a regular file"
    return None if generated(path.name, _content(path)) else "roslab did not write it"


def _action(path: Path, file: OutputFile, content: bytes) -> Action:
    if not path.exists():
        return "created"
    runs = not file.executable or path.stat().st_mode & stat.S_IXUSR
    return "unchanged" if runs and _content(path) == content else "replaced"


def _content(path: Path) -> bytes:
    with path.open("rb") as stream:
        return stream.read(MAX_SIZE)


def _make_folders(folder: Path, files: Sequence[OutputFile]) -> list[Path]:
    """Make the missing folders, parents first, and return them."""
    made: list[Path] = []
    try:
        for target in dict.fromkeys([folder, *((folder / file.path).parent for file in files)]):
            for path in [*reversed(target.parents), target]:
                if not path.exists():
                    path.mkdir()
                    made.append(path)
    except OSError as error:
        _unmake(made)
        raise _unwritable(folder, error) from None
    return made


def _unmake(folders: Sequence[Path]) -> None:
    for path in reversed(folders):
        with contextlib.suppress(OSError):
            path.rmdir()


def _replace(files: Sequence[tuple[Path, bytes, bool]]) -> None:
    """Write each file under a temporary name, then rename them all; undo everything where one step fails."""
    pending: list[tuple[Path, Path]] = []
    done: list[tuple[Path, Path | None]] = []
    try:
        for path, content, executable in files:
            pending.append((_temporary(path), path))
            _write(pending[-1][0], content, executable=executable)
        for temporary, path in pending:
            done.append((path, _kept(path)))
            temporary.replace(path)
    except BaseException:
        for path, kept in reversed(done):
            with contextlib.suppress(OSError):
                if kept is None:
                    path.unlink()
                else:
                    kept.replace(path)
                    kept.unlink(missing_ok=True)  # `replace` does nothing if both names are the same file
        for temporary, _ in pending:
            with contextlib.suppress(OSError):
                temporary.unlink()
        raise
    for _, kept in done:
        if kept:
            kept.unlink()


def _write(path: Path, content: bytes, *, executable: bool) -> None:
    # The caller's umask decides who may read it, as for any new file
    descriptor = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o777 if executable else 0o666)
    with os.fdopen(descriptor, "wb") as stream:
        stream.write(content)


def _kept(path: Path) -> Path | None:
    """Give an existing file a second name until all is done; ``None`` if there is no file."""
    if not os.path.lexists(path):
        return None
    kept = _temporary(path)
    try:
        kept.hardlink_to(path)
    except OSError:  # no hard links on this file system: the name is briefly unused
        path.rename(kept)
    return kept


def _temporary(path: Path) -> Path:
    import secrets  # noqa: PLC0415 - slow to import, and a plan writes nothing

    return path.with_name(f".roslab-{secrets.token_hex(8)}")


def _unwritable(path: Path, error: OSError, *, hint: str = ELSEWHERE) -> ConfigurationError:
    name = printable(str(path))
    return ConfigurationError(Problem(message=f"cannot write {name}: {error.strerror or error}", hint=hint))
