"""Scripts of the shell that end with ``.bash``."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.prose.titled import titles_commands
from roslab.pipeline import plan_repository

FILES = {
    "tools/train.bash": "#!/bin/bash\npython ../main.py --seed $1 --name $2\n",
    "main.py": "import numpy\nif __name__ == '__main__':\n    print('a')\n",
    "other/main.py": "import numpy\nif __name__ == '__main__':\n    print('a')\n",
    "other/README.md": "# Other\n```\npython main.py --slow\n```\n",
    "requirements.txt": "numpy\n",
}


@pytest.mark.parametrize(
    ("page", "command"),
    [
        ("cd tools\nbash train.bash 1 demo", "cd tools && exec bash train.bash 1 demo"),
        ("bash tools/train.bash 1 demo", "bash tools/train.bash 1 demo"),
        ("./tools/train.bash 1 demo", "tools/train.bash 1 demo"),
        ("```\nTo train, run `~/demo/tools/train.bash 1 demo`.\n```", "tools/train.bash 1 demo"),
        ("```\nTraining is started by `tools/train.bash 1 demo`.\n```", "tools/train.bash 1 demo"),
    ],
)
def test_a_page_starts_one(tmp_path: Path, page: str, command: str) -> None:
    for path, text in {**FILES, "README.md": f"# Demo\n## Training\n```bash\n{page}\n```\n"}.items():
        (tmp_path / path).parent.mkdir(exist_ok=True)
        (tmp_path / path).write_text(text)
    found = plan_repository(tmp_path).plan.run.command
    assert command in (found if isinstance(found, str) else " ".join(found))


@pytest.mark.parametrize("script", ["train.sh", "train.bash"])
def test_a_block_that_starts_one_has_a_title(script: str) -> None:
    assert titles_commands(["### Run `train`", "```", f"bash {script}", "```"], 1)


@pytest.mark.parametrize("ending", ["sh", "bash"])
def test_one_that_keeps_the_project_is_not_started(tmp_path: Path, ending: str) -> None:
    script = f"tools/publish.{ending}"
    (tmp_path / "tools").mkdir()
    for path, text in {"main.py": FILES["main.py"], script: "python main.py --all\n"}.items():
        (tmp_path / path).write_text(text)
    (tmp_path / "README.md").write_text(f"# Demo\n## Usage\n```\nbash {script} demo\n```\n")
    assert plan_repository(tmp_path).plan.run.command == ("python3", "main.py")
