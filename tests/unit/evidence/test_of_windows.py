"""A page that starts Python as one does on Windows."""

from __future__ import annotations

from pathlib import Path

import pytest

from hanging import ends
from roslab.evidence.prose.pages import text_of
from roslab.pipeline import plan_repository
from trees import tree_of

CODE = "import argparse\nif __name__ == '__main__':\n    print('a')\n"
FILES = {"src/main.py": CODE, "src/other.py": CODE, "config.yaml": "a: 1\n", "data/a.pcd": ""}
MAIN = ["python", "src/main.py"]
GIVEN = [*MAIN, "--config", "config.yaml"]


def planned(root: Path, page: str) -> list[str]:
    for path, text in {**FILES, "README.md": page}.items():
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(text, encoding="utf-8")
    command = plan_repository(root).plan.run.command
    return command.split() if isinstance(command, str) else list(command)


@pytest.mark.parametrize(
    ("call", "command"),
    [
        (r"python .\src\main.py --config .\config.yaml", GIVEN),
        (r".\.venv\Scripts\python.exe .\src\main.py --config .\config.yaml", GIVEN),
        (r".venv\Scripts\python src/main.py --config config.yaml", GIVEN),
        (r"PS C:\Users\me\robot> python .\src\main.py", MAIN),
        (r"C:\robot> python src/main.py", MAIN),
        ("py src/main.py", MAIN),
        (r"py -3.10 src\main.py --config config.yaml", GIVEN),
        ("python3.exe src/main.py", MAIN),
        ("py src/main.py `\n  --config .\\config.yaml", GIVEN),
        (
            "python .\\src\\main.py `\n  --config .\\config.yaml `\n  --map .\\data\\a.pcd",
            [*GIVEN, "--map", "data/a.pcd"],
        ),
        (r"python .\src\gone.py", ["bash"]),
        ("python src/main.py --name a\\ b", [*MAIN, "--name", "a b"]),
    ],
)
def test_a_call_is_taken_as_a_shell_has_it(tmp_path: Path, call: str, command: list[str]) -> None:
    page = f"# Robot\n\n## Run\n\n```powershell\n{call}\n```\n"
    assert planned(tmp_path, page) in (command, [" ".join(command)])


def test_a_call_in_a_sentence(tmp_path: Path) -> None:
    assert planned(tmp_path, "# Robot\n\n## Run\n\nStart it with `py .\\src\\main.py`.\n") == MAIN


@pytest.mark.parametrize("text", ["python " * 9_000, "py " * 20_000, "a\\" * 30_000 + ".py", "python a.py `\n" * 5_000])
def test_a_page_of_any_length_ends(tmp_path: Path, text: str) -> None:
    repository = tree_of(tmp_path, {"README.md": text})
    with ends():
        text_of(repository, repository.named("README.md")[0])
