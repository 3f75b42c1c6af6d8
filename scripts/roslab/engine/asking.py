"""Questions to a base image and its package sources: a Dockerfile asks, and its image is the answer."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from pathlib import Path
from secrets import token_hex

from roslab.engine import docker as engine
from roslab.engine.secrets import Secret

_ASKED = token_hex(8)
"""The argument ASKED: what hangs on it is asked anew by each call of the program, and once by each."""


def ask(
    question: str,
    platforms: Sequence[str],
    *,
    secrets: Sequence[Secret] = (),
    arguments: Sequence[tuple[str, str]] = (),
) -> str:
    """Return the text of the file ``answer`` that is all of a Dockerfile's image; the engine's store keeps nothing.

    It is asked on the engine's own platform where that is one of ``platforms``, else on the first. ``secrets`` and
    ``arguments``, as those of a proxy, are the build's own. Raises ``FailedBuild``.
    """
    own = engine.native_platform()
    with tempfile.TemporaryDirectory(prefix="roslab-") as folder:
        place = Path(folder)
        (place / "context").mkdir()
        (place / "Dockerfile").write_text(question, encoding="utf-8")
        job = engine.Build(
            context=place / "context",
            dockerfile=place / "Dockerfile",
            platforms=(own if own in platforms else platforms[0],),
            arguments=(*arguments, ("ASKED", _ASKED)),
            secrets=tuple(secrets),
            output=f"type=local,dest={place / 'out'}",
            extra=("--provenance=false",),
        )
        engine.build(job)
        return (place / "out" / "answer").read_text(encoding="utf-8")
