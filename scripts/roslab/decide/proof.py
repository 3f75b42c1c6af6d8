"""The command that tests the image, if roslab.yaml, an input or an option names one."""

from __future__ import annotations

import shlex

from roslab.config.model import Config
from roslab.decide.decision import Choice
from roslab.decide.reasons import configured


def decide_test(config: Config) -> Choice[tuple[str, ...] | str | None]:
    """Return the command that tests the image, ``None`` for the default proofs of its kind."""
    if not config.test:
        return Choice(answer=None)
    text = config.test if isinstance(config.test, str) else shlex.join(config.test)
    return Choice(answer=config.test, reasons=(configured(config, "test", text, "test"),))
