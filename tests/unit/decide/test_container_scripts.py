"""Scripts of the author's that start containers of his image: the screen, and the folder that their users give."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "demo.py": "import numpy\nif __name__ == '__main__':\n    print(1)\n",
    "README.md": "# Demo\n## Usage\n```\npython demo.py\n```\n",
    "docker/Dockerfile": 'FROM python:3.10\nCOPY . /app\nWORKDIR /app\nRUN pip install numpy\nCMD ["bash"]\n',
}
RUN = "#!/bin/bash\nxhost +\ndocker run -it --rm \\\n  {} \\\n  lab/demo:latest\n"


@pytest.mark.parametrize(
    ("option", "shown"),
    [
        ("-e DISPLAY=$DISPLAY", True),
        ("--env=DISPLAY", True),
        ('-e "DISPLAY=${DISPLAY}"', True),
        ("-v /tmp/.X11-unix:/tmp/.X11-unix:rw", True),
        ("--volume=/tmp/.X11-unix:/tmp/.X11-unix", True),
        ("-e DISPLAYS=2", False),
        ("-v /tmp:/tmp", False),
        ("--network host", False),
    ],
)
def test_the_screen_of_the_machine(tree: Tree, option: str, shown: bool) -> None:
    found = tree({**FILES, "docker/run.sh": RUN.format(option)})
    assert (found.dockerfile, found.gui) == ("docker/Dockerfile", shown)


@pytest.mark.parametrize(
    ("path", "script", "shown"),
    [
        ("run.sh", RUN, True),
        ("docker/run.bash", RUN, True),
        ("robot/run.sh", RUN, False),
        ("docker/run.sh", RUN.replace("docker run", "# docker run"), False),
        ("docker/run.sh", RUN.replace("docker run", "docker build"), False),
        ("docker/run.sh", RUN.replace("xhost +", 'OPTIONS="-e DISPLAY"').replace("{}", "$OPTIONS"), True),
    ],
)
def test_which_scripts_are_meant(tree: Tree, path: str, script: str, shown: bool) -> None:
    assert tree({**FILES, path: script.format("-e DISPLAY=$DISPLAY")}).gui is shown


@pytest.mark.parametrize(
    ("option", "folder"),
    [
        ("-v $1/:/datasets/", "/datasets"),
        ('-v "$1:/datasets"', "/datasets"),
        ('--volume="${2}":/data/bags:ro', "/data/bags"),
        ("--mount type=bind,source=$1,target=/data", "/data"),
        ("-v $PWD:/app", ""),
        ("-v $HOME/data:/data", ""),
        ("-e RATE=$1 -p 80:80", ""),
    ],
)
def test_a_folder_that_a_script_is_given(tree: Tree, option: str, folder: str) -> None:
    files = {**FILES, "docker/run.sh": RUN.format(option)}
    found = [(w.message, w.file, w.line) for w in tree(files).warnings if "--volume FOLDER" in w.message]
    assert [(f"--volume FOLDER:{folder}," in message, file, line) for message, file, line in found] == (
        [(True, "docker/run.sh", 3)] if folder else []
    )


def test_what_docker_compose_mounts_there_is_not_lacking(tree: Tree) -> None:
    compose = "services:\n  demo:\n    build:\n      context: .\n      dockerfile: docker/Dockerfile\n"
    files = {
        **FILES,
        "README.md": "# Demo\n## Usage\n```\ndocker compose up\n```\n",
        "docker/run.sh": RUN.format("-v $1:/datasets"),
        "docker-compose.yml": f"{compose}    volumes:\n      - ./data:/datasets\n",
    }
    assert not [w for w in tree(files).warnings if "--volume FOLDER" in w.message]


def test_a_generated_image_has_neither(tree: Tree) -> None:
    files = {name: text for name, text in FILES.items() if name != "docker/Dockerfile"}
    found = tree({**files, "docker/run.sh": RUN.format("-e DISPLAY -v $1:/datasets")})
    assert not found.gui
    assert not [w for w in found.warnings if "--volume FOLDER" in w.message]
