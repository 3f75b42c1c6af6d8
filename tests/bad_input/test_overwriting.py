"""`create` never loses a file of the author's: it stops before the first byte, and `--force` replaces only its own."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path
from subprocess import CompletedProcess

import pytest

Roslab = Callable[..., CompletedProcess[str]]
EXAMPLES = Path(__file__).resolve().parent.parent.parent / "examples"
AUTHORS = "the author's own words\n"
FILES = ("Dockerfile", "docker_build.sh", "docker_run.sh", "README.ipynb")


@pytest.fixture
def robot(tmp_path: Path) -> Path:
    shutil.copytree(EXAMPLES / "python_filter", tmp_path / "robot")
    return tmp_path / "robot"


def listing(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@pytest.mark.parametrize("force", [False, True])
@pytest.mark.parametrize("name", ["docker_build.sh", "docker_run.sh", "README.ipynb"])
def test_a_file_of_the_authors(roslab: Roslab, robot: Path, name: str, force: bool) -> None:
    (robot / name).write_text(AUTHORS)
    before = listing(robot)
    answer = roslab("create", robot, *(["--force"] if force else []))
    assert answer.returncode == 4
    assert answer.stderr == (
        f"{name}: error: roslab did not write it\n  move it away, or write to another folder with --output DIR\n"
    )
    assert answer.stdout == ""
    assert listing(robot) == before


@pytest.mark.parametrize("force", [False, True])
def test_an_authors_dockerfile_is_built_and_stays(roslab: Roslab, tmp_path: Path, force: bool) -> None:
    robot = tmp_path / "robot"
    shutil.copytree(EXAMPLES / "own_dockerfile", robot)
    shutil.move(robot / "docker" / "Dockerfile", robot / "Dockerfile")
    text = (robot / "Dockerfile").read_text()
    answer = roslab("create", robot, *(["--force"] if force else []))
    assert answer.returncode == 0, answer.stderr
    assert (robot / "Dockerfile").read_text() == text


@pytest.mark.parametrize("force", [False, True])
def test_an_authors_dockerfile_that_cannot_be_used(roslab: Roslab, robot: Path, force: bool) -> None:
    """It copies nothing of the repository, so it is not this program's image; it stays all the same."""
    (robot / "Dockerfile").write_text("FROM nginx\nRUN rm /etc/nginx/conf.d/default.conf\n")
    before = listing(robot)
    answer = roslab("create", robot, *(["--force"] if force else []))
    assert listing(robot)["Dockerfile"] == before["Dockerfile"]
    if answer.returncode:
        assert answer.returncode == 4
        assert answer.stderr.startswith("Dockerfile: error: roslab did not write it\n")
        assert listing(robot) == before


def test_all_in_the_way_are_named_at_once(roslab: Roslab, robot: Path) -> None:
    for name in ("docker_run.sh", "README.ipynb"):
        (robot / name).write_text(AUTHORS)
    answer = roslab("create", robot)
    assert answer.returncode == 4
    assert answer.stderr.count("error: roslab did not write it") == 2
    assert not (robot / "Dockerfile").exists()


@pytest.mark.parametrize("name", FILES)
def test_a_link_in_the_way(roslab: Roslab, robot: Path, name: str) -> None:
    """Writing through it would change a file elsewhere."""
    target = robot.parent / "elsewhere"
    target.write_text(AUTHORS)
    (robot / name).symlink_to(target)
    answer = roslab("create", robot, "--force")
    assert answer.returncode == 4
    assert f"{name}: error: it is a link, and roslab does not write through links\n" in answer.stderr
    assert target.read_text() == AUTHORS


def test_a_folder_in_the_way(roslab: Roslab, robot: Path) -> None:
    (robot / "docker_run.sh").mkdir()
    answer = roslab("create", robot, "--force")
    assert answer.returncode == 4
    assert "docker_run.sh: error: it is a folder\n" in answer.stderr


def test_again_with_nothing_changed(roslab: Roslab, robot: Path) -> None:
    assert roslab("create", robot).returncode == 0
    before = listing(robot)
    answer = roslab("create", robot)
    assert answer.returncode == 0, answer.stderr
    assert "unchanged Dockerfile\n" in answer.stdout
    assert listing(robot) == before


def test_its_own_older_file_needs_force(roslab: Roslab, robot: Path) -> None:
    assert roslab("create", robot).returncode == 0
    (robot / "requirements.txt").write_text("numpy\nmatplotlib\nscipy\n")
    (robot / "roslab.yaml").write_text("format: 3\napt: [libeigen3-dev]\n")
    before = listing(robot)
    answer = roslab("create", robot)
    assert answer.returncode == 4
    assert answer.stderr == (
        "Dockerfile: error: roslab wrote it earlier, and what it would write now differs\n"
        "  --force replaces it, and any edit of yours in it\n"
    )
    assert listing(robot) == before
    again = roslab("create", robot, "--force")
    assert again.returncode == 0, again.stderr
    assert "replaced  Dockerfile\n" in again.stdout
    assert "libeigen3-dev" in (robot / "Dockerfile").read_text()


def test_a_file_made_ones_own_stays(roslab: Roslab, robot: Path) -> None:
    """Who deletes the mark takes the file over."""
    assert roslab("create", robot).returncode == 0
    lines = (robot / "docker_run.sh").read_text().splitlines(keepends=True)
    mine = "".join(line for line in lines if "Generated by roslab" not in line)
    (robot / "docker_run.sh").write_text(mine)
    answer = roslab("create", robot, "--force")
    assert answer.returncode == 4
    assert (robot / "docker_run.sh").read_text() == mine


def test_output_that_is_a_file(roslab: Roslab, robot: Path) -> None:
    (robot.parent / "out").write_text(AUTHORS)
    answer = roslab("create", robot, "--output", robot.parent / "out")
    assert answer.returncode == 2
    assert "is a file, not a folder\n  --output names a folder\n" in answer.stderr
    assert (robot.parent / "out").read_text() == AUTHORS


def test_output_elsewhere(roslab: Roslab, robot: Path) -> None:
    before = listing(robot)
    answer = roslab("create", robot, "--output", robot.parent / "deep" / "out")
    assert answer.returncode == 0, answer.stderr
    assert set(FILES) <= set(listing(robot.parent / "deep" / "out"))
    assert listing(robot) == before


def test_a_dockerignore_of_the_authors_stays(roslab: Roslab, robot: Path) -> None:
    (robot / ".dockerignore").write_text("data\n")
    answer = roslab("create", robot)
    assert answer.returncode == 0, answer.stderr
    assert (robot / ".dockerignore").read_text() == "data\n"
