"""What a page starts in a container is the command, with the tree's own paths where it mounts the tree."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
MAIN = (
    "import argparse\n\nif __name__ == '__main__':\n    parser = argparse.ArgumentParser()\n"
    "    parser.add_argument('--config')\n    print(parser.parse_args())\n"
)
DEPENDENCIES = (
    "FROM python:3.9-slim\nCOPY requirements.txt /tmp/\nRUN pip install -r /tmp/requirements.txt\nWORKDIR /app\n"
)
SHELL = (
    "FROM python:3.9-slim\nCOPY . /app\nWORKDIR /app\nRUN pip install -r requirements.txt\nENTRYPOINT ['/bin/bash']\n"
)
FILES = {"requirements.txt": "numpy\n", "train.py": MAIN, "cfg/a.yaml": "a: 1\n", "tools/eval.py": MAIN}


def page(line: str) -> str:
    return f"# Net\n```\ndocker build -t net .\n{line}\n```\n"


@pytest.mark.parametrize(
    ("line", "command"),
    [
        ("docker run -it -v $(pwd):/app net python /app/train.py", "python train.py"),
        (
            "docker run -v $PWD:/app/ net python /app/train.py --config=/app/cfg/a.yaml",
            "python train.py --config=cfg/a.yaml",
        ),
        (
            'docker run --mount type=bind,source="$(pwd)",target=/app net bash -c "cd /app && python train.py"',
            "python train.py",
        ),
        ("docker run --volume=${PWD}:/app:ro -w /app/tools net python eval.py", "python tools/eval.py"),
        ("docker run -v $(pwd)/data:/app net python train.py", "python train.py"),
        (
            "docker run -v $CONFIGS:/cfg net python train.py --config /cfg/a.yaml",
            "python train.py --config /cfg/a.yaml",
        ),
        (
            "docker run -v $CONFIGS:/cfg -v $(pwd):/app net python /app/train.py --config /cfg/a.yaml",
            "python train.py --config /cfg/a.yaml",
        ),
        ('docker run net -c "python train.py --config cfg/a.yaml"', "python train.py --config cfg/a.yaml"),
        ('docker run -it net "python train.py"', "python train.py"),
    ],
)
def test_the_command_in_the_container(tree: Tree, line: str, command: str) -> None:
    decision = tree({**FILES, "Dockerfile": DEPENDENCIES, "README.md": page(line)})
    assert decision.command == tuple(command.split())


def test_a_script_that_the_shell_of_the_entry_point_is_given(tree: Tree) -> None:
    scripts = {
        "docker_run.sh": '#!/bin/bash\ndocker run --rm -it net "$@"\n',
        "demo.sh": "#!/bin/bash\npython train.py --config cfg/a.yaml\n",
    }
    files = {**FILES, **scripts, "Dockerfile": SHELL.replace("'", '"'), "README.md": page("./docker_run.sh demo.sh")}
    assert tree(files).command == ("bash", "demo.sh")
    started = {**files, "README.md": page("./docker_run.sh python train.py")}
    assert tree(started).command == ("python", "train.py")
