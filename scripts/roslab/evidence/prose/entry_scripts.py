"""What a script that an author's ENTRYPOINT names starts in the end: what it is given, or always the same program."""

from __future__ import annotations

import posixpath
import shlex

from roslab.repository.checkout import Repository
from roslab.values.pattern import pattern

MAX_SIZE = 64 * 1024
_SHELLS = frozenset({"bash", "sh", "dash"})
_ENDS = pattern(r"(?m)^[ \t]*exec[ \t]+([^\n#$;|&]{1,300}?)[ \t]+\"?\$@\"?[ \t]*\Z")


def started_by(repository: Repository, entrypoint: tuple[str, ...]) -> tuple[str, ...]:
    """Return the words of the program that the script gives all arguments to, else the ENTRYPOINT as it is.

    The script is the only one of that name in the tree: the image may have it anywhere.
    """
    script = next((word for word in entrypoint if word not in _SHELLS and not word.startswith("-")), "")
    named = [file for file in repository.suffixed(".sh") if file.name == posixpath.basename(script)]
    if len(named) != 1 or script != entrypoint[-1] or named[0].size > MAX_SIZE:
        return entrypoint
    found = _ENDS.search(repository.read(named[0]).rstrip())
    if found is None:
        return entrypoint
    try:
        words = tuple(shlex.split(found[1]))
    except ValueError:
        return entrypoint
    return (words[1:] or entrypoint) if words[:1] == ("--",) else words  # the end of the options of exec itself
