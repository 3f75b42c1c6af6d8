"""Files of sessions of a terminal that a page has tmuxp or tmuxinator load.

https://tmuxp.git-pull.com/cli/load/ and https://github.com/tmuxinator/tmuxinator (Usage), read 2026-11-28.
"""

from __future__ import annotations

from collections.abc import Sequence

from roslab.values.pattern import pattern

_FILE = pattern(r"(?:--?[a-z-]+=)?((?:[\w.@+~-]*/)*[\w.@+-]+\.(?:ya?ml|json))")
_LOADS = frozenset({("tmuxp", "load"), ("tmuxinator", "start"), ("tmuxinator", "local")})


def loaded_session(words: Sequence[str]) -> tuple[str, ...]:
    """Return the paths of the files that a call loads; a name alone is one of the reader's own."""
    if (*words[:2],) in _LOADS:
        return tuple(match[1] for word in words[2:] if (match := _FILE.fullmatch(word)))
    return ()
