"""Packages of the loggers that code makes whatever its arguments are."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
TORCHRL = "from torchrl.record.loggers.wandb import WandbLogger\n"


@pytest.mark.parametrize(
    ("code", "asked"),
    [
        (f"{TORCHRL}def train(args):\n    logger = WandbLogger(\n        exp_name='a',\n    )\n", True),
        (f"{TORCHRL}def train(args):\n    if args.log:\n        logger = WandbLogger(exp_name='a')\n", False),
        ("from logs import WandbLogger\nlogger = WandbLogger()\n", False),
        ("try:\n    import wandb\nexcept ImportError:\n    wandb = None\nwandb.init(project='a')\n", True),
        ("try:\n    import wandb\nexcept ImportError:\n    wandb = None\nif wandb:\n    wandb.init()\n", False),
        ("def main():\n    import wandb\n    wandb.init()\nif __name__ == '__main__':\n    main()\n", True),
    ],
)
def test_loggers_that_are_always_made(tree: Tree, code: str, asked: bool) -> None:
    project = '[project]\nname = "demo"\nversion = "1"\ndependencies = ["torchrl"]\n'
    files = {
        "pyproject.toml": project,
        "train.py": f"import torchrl\n{code}",
        "logs.py": "class WandbLogger:\n  pass\n",
    }
    assert ("wandb" in {each.key for each in tree(files).python.pip_guessed}) is asked
