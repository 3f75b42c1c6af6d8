"""A script that makes a virtual environment and starts the program in it stands for that program."""

from __future__ import annotations

from pathlib import Path

import pytest

from hanging import ends
from roslab.evidence.prose.venv_scripts import started
from roslab.pipeline import plan_repository

APP = """\
#!/usr/bin/env bash
# Makes .venv at the first start
set -euo pipefail
cd "$(dirname "$0")"
PYTHON="${PYTHON:-python3}"
VENV=".venv"
if [ ! -x "$VENV/bin/python" ]; then
  echo "Creating $VENV ..."
  "$PYTHON" -m venv "$VENV"
fi
"$VENV/bin/python" -m pip install --quiet -e .
exec "$VENV/bin/arm-demo" "$@"
"""
ENTERED = """\
if [ ! -d venv ]; then
    python3 -m venv venv
fi
source venv/bin/activate
pip install -r requirements.txt
python main.py --fast "$@"
"""


@pytest.mark.parametrize(
    ("script", "runs"),
    [
        (APP, ("arm-demo",)),
        (ENTERED, ("pip install -r requirements.txt", "python main.py --fast")),
        ("virtualenv env\n./env/bin/python sim.py\n", ("python sim.py",)),
        (ENTERED + "echo done\n", ()),
        (ENTERED + "python other.py\n", ()),
        (ENTERED.replace("python main.py", "python server.py &\npython main.py"), ()),
        (ENTERED.replace("--fast", "--port $PORT"), ()),
        (ENTERED.replace("source", "export ROBOT=arm\nsource"), ()),
        (ENTERED.replace("source", "cd sim\nsource"), ()),
        (APP.replace('dirname "$0")"', 'dirname "$0")/.."'), ()),
        ("python3 -m venv venv\nsource venv/bin/activate\npip install numpy\n", ()),
        ("python3 -m venv venv\npython main.py\n", ()),
        ("python3 -m venv venv\n", ()),
        ("", ()),
    ],
)
def test_what_a_script_installs_and_starts_in_its_environment(script: str, runs: tuple[str, ...]) -> None:
    assert started(script) == runs


@pytest.mark.parametrize(
    "line",
    [
        'if ! command -v python3 >/dev/null 2>&1; then echo "no; stop"; exit 1; fi',
        'cd "$(dirname "$0")" || exit 1',
        '[ -d venv ] || { echo "none" && exit 1; }',
        'HERE=$(cd "$(dirname "$0")" && pwd)',
        "source /opt/ros/humble/setup.bash",
        "sudo apt-get install -y ffmpeg",
        "echo starting >&2",
    ],
)
def test_what_prepares_alone_changes_nothing(line: str) -> None:
    assert started(ENTERED.replace("python main", f"{line}\npython main")) == started(ENTERED)


@pytest.mark.parametrize(
    "line",
    [
        "source .env",
        ". ./settings.sh",
        "echo 'rate: 5' > rate.yaml",
        "mkdir -p out",
        "echo a && python prepare.py",
        "if [ -f a ]; then python prepare.py; fi",
        "[[ -f model.pt ]] || wget https://example.org/model.pt",
        "else ./other.sh",
        '{ "./other.sh"; }',
        "sudo apt-get install -y cmake && make",
        "echo y | ./other.sh",
        "sleep 1 & ./other.sh",
        'cd "$HERE" && ./other.sh',
    ],
)
def test_a_script_that_does_more_stays_as_it_is(line: str) -> None:
    assert started(ENTERED.replace("python main", f"{line}\npython main")) == ()


@pytest.mark.parametrize(
    "line", ["a/" * 2000 + "bin/x", "A=" + '"' * 4000, "cd $" + "a" * 4000, "x " * 2000, " " * 7000 + ";x"]
)
def test_a_hostile_script_takes_no_long_time(line: str) -> None:
    with ends():
        assert started(f"python3 -m venv v\n{line}\n") == ()


@pytest.mark.parametrize("call", ["./run.sh", "bash run.sh", "$ sh ./run.sh   # the window"])
@pytest.mark.parametrize(("group", "value"), [("scripts", "arm:main"), ("gui-scripts", "arm:main")])
def test_the_image_starts_the_program_of_such_a_script(tmp_path: Path, call: str, group: str, value: str) -> None:
    files = {
        "run.sh": APP,
        "pyproject.toml": f'[project]\nname = "arm"\nversion = "1"\n[project.{group}]\narm-demo = "{value}"\n',
        "arm/__init__.py": "def main():\n    print('a')\n",
        "README.md": f"# Arm\n\n## Run\n\n```\n{call}\n```\n",
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    assert plan_repository(tmp_path).plan.run.command == ("arm-demo",)


def test_a_script_that_starts_two_programs_stays_the_command(tmp_path: Path) -> None:
    (tmp_path / "run.sh").write_text(ENTERED + "python main.py\n", encoding="utf-8")
    (tmp_path / "main.py").write_text("import numpy\nif __name__ == '__main__':\n    print('a')\n", encoding="utf-8")
    (tmp_path / "requirements.txt").write_text("numpy\n", encoding="utf-8")
    (tmp_path / "README.md").write_text("# Usage\n\n```\nbash run.sh\n```\n", encoding="utf-8")
    assert plan_repository(tmp_path).plan.run.command == ("bash", "run.sh")
