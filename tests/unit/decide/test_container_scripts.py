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


FUNCTION = "#!/bin/bash\nview() {\n  docker run --rm -v $1:/models lab/demo\n}\nview /data/models\n"


@pytest.mark.parametrize(
    ("script", "told"),
    [
        (FUNCTION.replace("{\n  docker", "{ docker").replace("demo\n}", "demo; }"), False),
        ("a() { ls; }\ndocker run -v $1:/models lab/demo\n", True),
        (FUNCTION, False),
        (FUNCTION.replace("view() {", "if true; then").replace("}\nview /data/models", "fi"), True),
    ],
)
def test_what_a_function_is_given_is_not_given_to_its_script(tree: Tree, script: str, told: bool) -> None:
    found = tree({**FILES, "docker/run.sh": script})
    assert any("--volume FOLDER:/models" in w.message for w in found.warnings) == told


@pytest.mark.parametrize(
    ("image", "build", "counts"),
    [
        ("lab/demo:latest", "docker build -t lab/demo -f docker/Dockerfile .", True),
        ("--name a --gpus 'all,b c' --rm -it lab/demo bash", "docker build -t lab/demo:1 -f docker/Dockerfile .", True),
        ("-eTERM -itv /a:/b -w /c --net=host lab/demo bash", "docker build -t lab/demo -f docker/Dockerfile .", True),
        ("-v $(realpath -s a):/b lab/demo bash", "docker build -t lab/demo -f docker/Dockerfile .", True),
        ("$IMAGE", "docker build -t lab/demo -f docker/Dockerfile .", True),
        ("other/viewer", "docker build -t lab/demo -f docker/Dockerfile .", False),
        ("--privileged other/viewer lab/demo", "docker build -t lab/demo -f docker/Dockerfile .", False),
        ("other/viewer", "ls", True),
    ],
)
def test_of_which_image_a_script_starts_a_container(tree: Tree, image: str, build: str, counts: bool) -> None:
    page = f"# Demo\n## Docker\n```\n{build}\n```\n{FILES['README.md']}"
    script = f"#!/bin/bash\ndocker run -e DISPLAY -v $1:/models {image}\n"
    found = tree({**FILES, "README.md": page, "docker/run.sh": script})
    assert found.gui is counts
    assert any("--volume FOLDER:/models" in w.message for w in found.warnings) == counts


def test_a_script_that_builds_what_it_runs(tree: Tree) -> None:
    page = f"# Demo\n## Docker\n```\ndocker build -t demo -f docker/Dockerfile .\n```\n{FILES['README.md']}"
    script = "#!/bin/bash\ndocker build -t mine -f docker/Dockerfile .\ndocker run -e DISPLAY mine\n"
    assert tree({**FILES, "README.md": page, "docker/run.sh": script}).gui


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
