"""The launcher of a program that stops without it stays before the default command, with one process."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
READS = "import os\nprint(int(os.environ['LOCAL_RANK']))\n"
GUARDED = "import os\nif 'LOCAL_RANK' in os.environ:\n    print(os.environ['LOCAL_RANK'])\n"
JOINS = "import torch.distributed as dist\nif gpus > 1:\n    dist.init_process_group({})\n"
OF_TORCHPACK = "from torchpack import distributed as dist\ndist.init()\n"
ONE = "--nproc_per_node=1"


@pytest.mark.parametrize(
    ("code", "line", "command"),
    [
        (READS, "torchrun --nproc_per_node=8 train.py a.yaml", f"torchrun {ONE} train.py a.yaml"),
        ("import numpy\nfrom tools import dist\n", "torchrun --nproc_per_node=8 train.py", f"torchrun {ONE} train.py"),
        (GUARDED, "torchrun --nproc_per_node=8 train.py", "python train.py"),
        (
            READS,
            "python -m torch.distributed.launch --nproc_per_node=8 --use_env train.py",
            f"python -m torch.distributed.launch {ONE} --use_env train.py",
        ),
        (OF_TORCHPACK, "torchpack dist-run -np 8 python train.py", "torchpack dist-run -np 1 python train.py"),
        (READS, "python train.py", "python train.py"),
        (
            JOINS.format("'nccl', init_method='env://'"),
            "python -m torch.distributed.run --nnodes=1 --nproc_per_node=8 train.py a.yaml",
            f"python -m torch.distributed.run {ONE} train.py a.yaml",
        ),
        (JOINS.format("backend=choose('nccl')"), "torchrun --nproc_per_node=8 train.py", f"torchrun {ONE} train.py"),
        (JOINS.format("'nccl', rank=0, world_size=2"), "torchrun --nproc_per_node=8 train.py", "python train.py"),
        (JOINS.format("'nccl', init_method=url"), "torchrun --nproc_per_node=8 train.py", "python train.py"),
        (
            JOINS.format("'nccl'").replace("gpus > 1", "args.local_rank != -1"),
            "torchrun --nproc_per_node=8 train.py",
            "python train.py",
        ),
    ],
)
def test_a_launcher(tree: Tree, code: str, line: str, command: str) -> None:
    files = {"train.py": code, "tools/dist.py": READS, "a.yaml": "", "requirements.txt": "torch\n"}
    assert " ".join(tree({**files, "README.md": f"# Usage\n```\n{line}\n```\n"}).command) == command
