"""Trees that are wrong, huge or hostile: each gets one clear answer, and nothing outside the tree is ever read."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from subprocess import CompletedProcess

import pytest

Roslab = Callable[..., CompletedProcess[str]]
EXAMPLES = Path(__file__).resolve().parent.parent.parent / "examples"
MANIFEST = """\
<?xml version="1.0"?>
<package format="2">
  <name>{name}</name>
  <version>1.0.0</version>
  <description>A package</description>
  <maintainer email="a@example.org">A</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>catkin</buildtool_depend>
  <depend>roscpp</depend>
</package>
"""
CMAKE = "cmake_minimum_required(VERSION 3.5)\nproject({name})\nfind_package(catkin REQUIRED)\ncatkin_package()\n"


def package(folder: Path, name: str) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "package.xml").write_text(MANIFEST.format(name=name))
    (folder / "CMakeLists.txt").write_text(CMAKE.format(name=name))


def noetic(folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "README.md").write_text("# A robot\n\nFor ROS Noetic.\n")


@pytest.mark.parametrize("command", ["inspect", "plan", "create", "check", "build", "run"])
def test_nothing_there(roslab: Roslab, command: str, tmp_path: Path) -> None:
    answer = roslab(command, "missing", cwd=tmp_path)
    assert answer.returncode == 2
    assert answer.stderr == (
        "roslab: error: not a directory: missing: there is nothing at that path\n  give the root of a repository\n"
    )
    assert answer.stdout == ""


def test_a_file(roslab: Roslab, tmp_path: Path) -> None:
    (tmp_path / "thing.zip").write_bytes(b"PK")
    answer = roslab("plan", "thing.zip", cwd=tmp_path)
    assert answer.returncode == 2
    assert answer.stderr == (
        "roslab: error: not a directory: thing.zip: it is a file\n  give the root of a repository\n"
    )


def test_an_address(roslab: Roslab, tmp_path: Path) -> None:
    answer = roslab("plan", "https://example.org/lab/robot.git", cwd=tmp_path)
    assert answer.returncode == 2
    assert answer.stderr == (
        "roslab: error: not a directory: https://example.org/lab/robot.git: it is an address\n"
        "  clone it first (`git clone --recursive`), and give the folder\n"
    )


def test_a_link_to_itself(roslab: Roslab, tmp_path: Path) -> None:
    (tmp_path / "loop").symlink_to("loop")
    answer = roslab("plan", "loop", cwd=tmp_path)
    assert answer.returncode == 2
    assert answer.stderr == (
        "roslab: error: not a directory: loop: it is a link that leads nowhere\n  give the root of a repository\n"
    )


def test_a_path_with_control_characters(roslab: Roslab, tmp_path: Path) -> None:
    answer = roslab("plan", "a\x1b[31m\nb", cwd=tmp_path)
    assert answer.returncode == 2
    assert "not a directory: a\\x1b[31m\\nb:" in answer.stderr


@pytest.mark.parametrize("command", ["inspect", "plan", "create", "build"])
def test_an_empty_directory(roslab: Roslab, command: str, tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    answer = roslab(command, "empty", cwd=tmp_path)
    assert answer.returncode == 3
    assert answer.stderr == "roslab: error: empty is empty\n  check the repository out first\n"
    assert answer.stdout == ""


def test_only_git(roslab: Roslab, tmp_path: Path) -> None:
    (tmp_path / "bare" / ".git").mkdir(parents=True)
    (tmp_path / "bare" / ".git" / "HEAD").write_text("ref: refs/heads/main\n")
    answer = roslab("plan", "bare", cwd=tmp_path)
    assert answer.returncode == 3


def test_nothing_recognisable(roslab: Roslab, tmp_path: Path) -> None:
    """What was looked for and what was found instead are both shown."""
    folder = tmp_path / "thesis"
    folder.mkdir()
    for name in ("chapter1.tex", "chapter2.tex", "figure.pdf"):
        (folder / name).write_text("words")
    answer = roslab("inspect", "thesis", cwd=tmp_path)
    assert answer.returncode == 3
    assert answer.stdout == ""
    for looked_for in ("package.xml", "CMakeLists.txt", "pyproject.toml", "requirements", "Dockerfile", "C++ source"):
        assert looked_for in answer.stderr
    assert "; there is only 2 .tex, 1 .pdf\n" in answer.stderr
    assert "roslab.yaml" in answer.stderr  # how to say it all the same


@pytest.mark.parametrize(
    ("text", "line"),
    [
        (MANIFEST.format(name="broken").replace("</description>", ""), 10),
        ("<package format='2'>\n  <name>broken</name>\n", 3),
        ("", 1),
        ("just words\n", 1),
    ],
    ids=["unclosed", "cut-off", "empty", "no-xml"],
)
def test_malformed_manifest(roslab: Roslab, text: str, line: int, tmp_path: Path) -> None:
    """It is named with its line, and the packages beside it are planned all the same."""
    folder = tmp_path / "robot"
    noetic(folder)
    package(folder / "good", "good")
    (folder / "broken").mkdir()
    (folder / "broken" / "package.xml").write_text(text)
    answer = roslab("inspect", folder, "--format", "json")
    assert answer.returncode == 0, answer.stderr
    found = json.loads(answer.stdout)
    assert found["kind"] == "ros1"
    warnings = [warning for warning in found["warnings"] if warning["file"] == "broken/package.xml"]
    assert warnings, found["warnings"]
    assert warnings[0]["line"] == line, warnings


def test_entity_that_leads_out(roslab: Roslab, tmp_path: Path) -> None:
    (tmp_path / "secret").write_text("the-secret")
    folder = tmp_path / "robot"
    noetic(folder)
    package(folder, "&a;")
    manifest = (folder / "package.xml").read_text()
    entity = f"<!DOCTYPE package [<!ENTITY a SYSTEM 'file://{tmp_path}/secret'>]>\n<package "
    (folder / "package.xml").write_text(manifest.replace("<package ", entity))
    answer = roslab("inspect", folder, "--format", "json")
    assert answer.returncode == 0, answer.stderr
    assert "the-secret" not in answer.stdout + roslab("plan", folder).stdout


def test_billion_laughs(roslab: Roslab, tmp_path: Path) -> None:
    folder = tmp_path / "robot"
    noetic(folder)
    package(folder / "good", "good")
    entities = "".join(f"<!ENTITY e{i} '{f'&e{i - 1};' * 10}'>" for i in range(1, 12))
    (folder / "bomb").mkdir()
    (folder / "bomb" / "package.xml").write_text(
        f"<!DOCTYPE p [<!ENTITY e0 'ha'>{entities}]>\n<package><name>&e11;</name></package>\n"
    )
    (folder / "bomb" / "start.launch").write_text(
        f"<!DOCTYPE p [<!ENTITY e0 'ha'>{entities}]>\n<launch><node pkg='&e11;'/></launch>\n"
    )
    answer = roslab("plan", folder, memory=2**30, timeout=20)
    assert answer.returncode == 0, answer.stderr


def test_links_out_of_the_tree(roslab: Roslab, tmp_path: Path) -> None:
    """They are never read, wherever they lead; a link inside the tree is."""
    secret = tmp_path / "secret"
    secret.mkdir()
    (secret / "requirements.txt").write_text("a-secret-package==1.2.3\n")
    (secret / "package.xml").write_text(MANIFEST.format(name="a_secret_package"))
    folder = tmp_path / "robot"
    folder.mkdir()
    (folder / "main.py").write_text("import numpy\n\nif __name__ == '__main__':\n    print(numpy.zeros(1))\n")
    (folder / "requirements.txt").symlink_to("../secret/requirements.txt")
    (folder / "package.xml").symlink_to(secret / "package.xml")
    (folder / "folder").symlink_to(secret)
    (folder / "nowhere").symlink_to("/does/not/exist")
    (folder / "circle").symlink_to("circle")
    (folder / "self").symlink_to(".")
    answer = roslab("inspect", folder, "--format", "json")
    assert answer.returncode == 0, answer.stderr
    assert "secret" not in answer.stdout.replace("../secret", "")
    assert json.loads(answer.stdout)["kind"] == "python"


@pytest.mark.parametrize("leads", ["../elsewhere.yaml", "nowhere"])
def test_configuration_that_is_a_link_out(roslab: Roslab, tmp_path: Path, leads: str) -> None:
    (tmp_path / "elsewhere.yaml").write_text("format: 3\nname: elsewhere\n")
    shutil.copytree(EXAMPLES / "python_filter", tmp_path / "robot")
    (tmp_path / "robot" / "roslab.yaml").symlink_to(leads)
    answer = roslab("plan", "robot", cwd=tmp_path)
    assert answer.returncode == 4
    assert answer.stderr == (
        f"roslab: error: roslab.yaml is a link to {leads}, which is no file of the repository\n"
        "  make it a file of the repository\n"
    )


def test_dockerfile_that_is_a_link_out(roslab: Roslab, tmp_path: Path) -> None:
    (tmp_path / "Dockerfile").write_text("FROM scratch\nCOPY . /everything\n")
    shutil.copytree(EXAMPLES / "python_filter", tmp_path / "robot")
    (tmp_path / "robot" / "roslab.yaml").write_text("format: 3\ndockerfile: docker/Dockerfile\n")
    (tmp_path / "robot" / "docker").mkdir()
    (tmp_path / "robot" / "docker" / "Dockerfile").symlink_to("../../Dockerfile")
    answer = roslab("plan", "robot", cwd=tmp_path)
    assert answer.returncode == 2, answer.stdout
    assert answer.stderr == (
        "roslab.yaml:2:1: error: dockerfile: docker/Dockerfile is a link to ../../Dockerfile, "
        "which is no file of the repository\n"
        "  give a path relative to the root of the repository\n"
    )


def test_files_of_hundreds_of_megabytes(roslab: Roslab, tmp_path: Path) -> None:
    """A file is read up to its first megabytes, whatever its name promises."""
    shutil.copytree(EXAMPLES / "ros1_talker", tmp_path / "robot")
    names = (
        "data/run.bag", "README.rst", "requirements.txt", "big/package.xml", "big/CMakeLists.txt", "big/big.cpp",
        "big/a.py", "big/start.launch", "big/environment.yml", "big/big.repos", "big/setup.py", "big/pyproject.toml",
        "Dockerfile.big", ".github/workflows/ci.yml", ".gitmodules", "big/notebook.ipynb", "install.sh",
        ".dockerignore",
    )  # fmt: skip
    for name in names:
        path = tmp_path / "robot" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.touch()
        os.truncate(path, 500 * 2**20)
    answer = roslab("inspect", tmp_path / "robot", "--format", "json", memory=600 * 2**20, timeout=30)
    assert answer.returncode == 0, answer.stderr
    assert json.loads(answer.stdout)["ros_distro"] == "noetic"


def test_configuration_of_hundreds_of_megabytes(roslab: Roslab, tmp_path: Path) -> None:
    shutil.copytree(EXAMPLES / "python_filter", tmp_path / "robot")
    (tmp_path / "robot" / "roslab.yaml").touch()
    os.truncate(tmp_path / "robot" / "roslab.yaml", 500 * 2**20)
    answer = roslab("plan", "robot", cwd=tmp_path, memory=600 * 2**20)
    assert answer.returncode == 2
    assert answer.stderr == "roslab.yaml: error: 524288000 bytes, a configuration has at most 1048576\n"


def test_ten_thousand_files(roslab: Roslab, tmp_path: Path) -> None:
    folder = tmp_path / "robot"
    noetic(folder)
    package(folder / "good", "good")
    for number in range(100):
        place = folder / "data" / str(number)
        place.mkdir(parents=True)
        for index in range(100):
            (place / f"{index}.txt").touch()
    answer = roslab("plan", folder, timeout=20)
    assert answer.returncode == 0, answer.stderr


def test_deep_folders(roslab: Roslab, tmp_path: Path) -> None:
    """Deeper than the recursion limit, and a path longer than the system takes in one piece."""
    folder = tmp_path / "robot"
    noetic(folder)
    package(folder / "good", "good")
    here = os.open(folder, os.O_RDONLY)
    try:
        for _ in range(2100):
            os.mkdir("d", dir_fd=here)
            deeper = os.open("d", os.O_RDONLY, dir_fd=here)
            os.close(here)
            here = deeper
    finally:
        os.close(here)
    try:
        answers = [roslab("inspect", folder), roslab("plan", folder), roslab("check", folder)]
    finally:  # shutil.rmtree, with which pytest tidies up, is not able to
        subprocess.run(["rm", "-rf", str(folder / "d")], check=True)
    for answer in answers:
        assert answer.returncode == 0, answer.stderr
        assert "a folder could not be listed, and nothing inside was read: d/d" in answer.stdout


@pytest.mark.parametrize("command", ["inspect", "plan", "create"])
def test_names_that_are_no_utf8(roslab: Roslab, command: str, tmp_path: Path) -> None:
    folder = tmp_path / "robot"
    noetic(folder)
    package(folder / "good", "good")
    root = os.fsencode(folder)
    Path(os.fsdecode(root + b"/m\xe4ppchen")).mkdir()
    for name in (b"bild-\xff.png", b"m\xe4ppchen/main.cpp", b"m\xe4ppchen/start.launch"):
        Path(os.fsdecode(root + b"/" + name)).write_text("#include <pcl/point_types.h>\n")
    answer = roslab(command, folder)
    assert answer.returncode == 0, answer.stderr
    answer.stdout.encode()  # what is printed is UTF-8, whatever the names are
    answer.stderr.encode()


@pytest.mark.parametrize(
    "name", [b"m\xe4ppchen", b"two words", b"$(touch owned)", b"a\nRUN touch owned", b"-rf", b"'; ls; '"]
)
def test_packages_in_folders_with_strange_names(roslab: Roslab, name: bytes, tmp_path: Path) -> None:
    """The path of a package.xml becomes a word of the Dockerfile: quoted, or refused with the place named."""
    folder = tmp_path / "robot"
    noetic(folder)
    package(folder / "good", "good")
    package(Path(os.fsdecode(os.fsencode(folder) + b"/" + name)), "strange")
    answer = roslab("create", folder, cwd=tmp_path)
    assert answer.returncode in (0, 2), answer.stderr
    if answer.returncode == 0:
        lines = (folder / "Dockerfile").read_text().splitlines()
        assert not [line for line in lines if line.startswith("RUN touch")]
    else:
        assert "it cannot be written to a Dockerfile" in answer.stderr
    assert not list(tmp_path.rglob("owned"))


def test_files_that_are_no_files(roslab: Roslab, tmp_path: Path) -> None:
    """A pipe would block a reader for ever; a folder may be called like a file."""
    folder = tmp_path / "robot"
    noetic(folder)
    package(folder / "good", "good")
    os.mkfifo(folder / "requirements.txt")
    os.mkfifo(folder / "Dockerfile")
    for name in ("CMakeLists.txt", "README.rst", "setup.py", "roslab.yaml", "environment.yml"):
        (folder / name).mkdir()
    answer = roslab("plan", folder, timeout=20)
    assert answer.returncode == 0, answer.stderr


@pytest.mark.skipif(os.geteuid() == 0, reason="root reads everything")
def test_unreadable_folders(roslab: Roslab, tmp_path: Path) -> None:
    folder = tmp_path / "robot"
    noetic(folder)
    package(folder / "good", "good")
    (folder / "locked").mkdir(mode=0)
    for command in ("inspect", "plan"):
        answer = roslab(command, folder)
        assert answer.returncode == 0, answer.stderr
        assert "a folder could not be listed, and nothing inside was read: locked" in answer.stdout


def test_the_repository_is_not_executed(roslab: Roslab, tmp_path: Path) -> None:
    """Nor does it shadow a module that the program imports, whatever folder it is started in."""
    folder = tmp_path / "robot"
    folder.mkdir()
    trap = "open('owned', 'w').close()\n"
    for name in (
        "setup.py",
        "conftest.py",
        "yaml.py",
        "json.py",
        "lxml.py",
        "sitecustomize.py",
        "roslab.py",
        "main.py",
    ):
        (folder / name).write_text(trap + "if __name__ == '__main__':\n    print(1)\n")
    (folder / "pyproject.toml").write_text(
        "[build-system]\nrequires = []\nbuild-backend = 'setup'\nbackend-path = ['.']\n"
    )
    (folder / "CMakeLists.txt").write_text("project(x)\nexecute_process(COMMAND touch owned)\n")
    (folder / "requirements.txt").write_text("numpy\n")
    answer = roslab("plan", cwd=folder, env={"PYTHONPATH": str(folder)})
    assert answer.returncode == 0, answer.stderr
    assert not (folder / "owned").exists()
