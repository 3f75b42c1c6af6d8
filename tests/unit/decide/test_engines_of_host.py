"""Scripts that bring what runs containers to the machine of the reader."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
FILES = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
}
SINGULARITY = (
    "sudo apt-get install -y cryptsetup uuid-dev\n"
    "wget https://github.com/sylabs/singularity/releases/download/v3.9.5/singularity-ce-3.9.5.tar.gz\n"
)
DOCKER = "sudo apt-get install -y cryptsetup\ncurl -fsSL https://get.docker.com -o get-docker.sh\n"


@pytest.mark.parametrize(
    ("name", "text", "installed"),
    [
        ("install/install_singularity.sh", SINGULARITY, False),
        ("install_docker.sh", DOCKER, False),
        ("scripts/docker-install.sh", "sudo apt install cryptsetup docker-ce docker-ce-cli\n", False),
        ("install_docker.sh", "apt-get install -y cryptsetup\n", True),
        ("install_dependencies.sh", DOCKER, True),
    ],
)
def test_what_they_need(tree: Tree, name: str, text: str, *, installed: bool) -> None:
    decision = tree(FILES | {name: f"#!/bin/bash\n{text}"})
    assert ("cryptsetup" in decision.apt_guessed) == installed
    assert any("singularity" in each.message for each in decision.warnings) == (installed and text == SINGULARITY)


def test_one_that_the_authors_image_runs(tree: Tree) -> None:
    recipe = "FROM ros:noetic\nCOPY . /ws/src/demo\nRUN /ws/src/demo/install_docker.sh\n"
    files = {"docker/Dockerfile": recipe, "install_docker.sh": f"#!/bin/bash\n{DOCKER}"}
    assert "cryptsetup" in tree(FILES | files).apt_guessed


@pytest.mark.parametrize(
    "name", ["docker.io", "podman", "podman-docker", "apptainer", "singularity-ce", "python3-rocker"]
)
def test_what_runs_containers_is_in_none(tree: Tree, name: str) -> None:
    page = f"# demo\n\n```\nsudo apt install {name} cryptsetup\n```\n"
    found = tree(FILES | {"README.md": page})
    assert [each for each in found.apt_guessed if each in {name, "cryptsetup"}] == ["cryptsetup"]
