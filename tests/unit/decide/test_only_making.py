"""Where pages run nothing but programs that make something of data, the first of them is the use of a repository."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PROGRAM = 'import argparse\n\nif __name__ == "__main__":\n    argparse.ArgumentParser().parse_args()\n'
NAMES = ("extract_images", "extract_poses", "bag2csv", "download_data", "train", "generate_labels", "net_to_onnx")
TREE = {f"scripts/{name}.py": PROGRAM for name in NAMES} | {"lake.yaml": "a: 1\n", "requirements.txt": "numpy\n"}
FIRST = "### By a list\n\n    python scripts/extract_images.py lake.yaml\n"
SECOND = "\n### By a recording\n\n    python scripts/extract_poses.py /path/to/a.bag\n"


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("## Usage\n\n" + FIRST + SECOND, "python scripts/extract_images.py lake.yaml"),
        (
            "## Usage\n\n    python scripts/bag2csv.py\n    python scripts/extract_poses.py\n",
            "python scripts/bag2csv.py",
        ),
        ("## Usage\n\n" + SECOND + FIRST, "python scripts/extract_images.py lake.yaml"),
        ("## Usage\n\n" + FIRST + SECOND + "\n    python scripts/train.py\n", "python scripts/train.py"),
        ("## Usage\n\n" + FIRST + "\n    python scripts/download_data.py\n", "bash"),
        ("## Usage\n\n" + SECOND, "bash"),
        ("## Usage\n\n    python scripts/net_to_onnx.py\n    python scripts/extract_poses.py\n", "bash"),
        ("## Dataset preparation\n\n" + FIRST, "bash"),
        ("## Usage\n\n### Generate data\n\n    python scripts/generate_labels.py\n", "bash"),
    ],
)
def test_the_first_that_is_whole(tree: Tree, page: str, command: str) -> None:
    assert " ".join(tree({**TREE, "README.md": "# Lake\n\n" + page}).command) == command
