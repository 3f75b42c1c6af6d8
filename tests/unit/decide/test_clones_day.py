"""What CMake clones without a commit is of the day of an old last commit, as pip's packages are."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from roslab.knowledge.days import long_ago
from roslab.pipeline import Planned, plan_repository
from roslab.render.dockerfile import dockerfile

URL = "https://gitlab.com/example/matrix.git"
CLONE = f"execute_process(COMMAND git clone {URL} WORKING_DIRECTORY ${{CMAKE_BINARY_DIR}})"
FETCH = f"FetchContent_Declare(matrix GIT_REPOSITORY {URL})"
SCRIPT = Path(__file__).parents[3] / "scripts/roslab/render/image_scripts/git-as-of.sh"


def git(folder: Path, *words: str, day: str = "") -> None:
    when = {f"GIT_{who}_DATE": f"{day}T12:00:00Z" for who in ("AUTHOR", "COMMITTER")} if day else {}
    identity = ("-c", "user.name=a", "-c", "user.email=a@example.org")
    environment = {"PATH": "/usr/bin:/bin", "HOME": str(folder), **when}
    subprocess.run(["git", "-C", folder, *identity, *words], check=True, env=environment)


def committed(folder: Path, line: str, day: str, config: str = "") -> Planned:
    """Plan a CMake project of one commit of a day."""
    files = {"CMakeLists.txt": f"project(a CXX)\n{line}\nadd_executable(a a.cpp)\n", "a.cpp": "int main() {}\n"}
    files |= {"roslab.yaml": f"format: 3\n{config}"} if config else {}
    for path, text in files.items():
        (folder / path).write_text(text)
    git(folder, "init", "--quiet")
    git(folder, "add", ".")
    git(folder, "commit", "--quiet", "--message", "x", day=day)
    return plan_repository(folder)


def test_an_old_project_gets_what_was_there(tmp_path: Path) -> None:
    planned = committed(tmp_path, CLONE, "2019-03-01")
    assert planned.plan.workspace.clones_day == "2019-03-01"
    assert [(r.answer, r.line) for r in planned.decision.reasons if "without a commit" in r.reason] == [(URL, 2)]
    text = dockerfile(planned.plan)
    assert 'RUN eval "$(git-as-of 2019-03-01)" \\\n' in text
    assert "COPY --from=scripts /git-as-of /usr/local/bin/" in text


@pytest.mark.parametrize(
    ("line", "day", "config"),
    [
        (FETCH, "2019-03-01", ""),  # CMake goes to the newest commit again
        (CLONE.replace("clone", "clone --branch v1.2"), "2019-03-01", ""),
        (f"# {CLONE}", "2019-03-01", ""),
        (CLONE, long_ago(), ""),
        (CLONE, "2019-03-01", "pip_date: today\n"),
    ],
)
def test_what_is_of_today(tmp_path: Path, line: str, day: str, config: str) -> None:
    planned = committed(tmp_path, line, day, config)
    assert not planned.plan.workspace.clones_day
    assert "git-as-of" not in dockerfile(planned.plan)


@pytest.mark.skipif(not Path("/dev/shm").is_dir(), reason="a step of a build has /dev/shm")
@pytest.mark.parametrize("named", [True, False])
def test_a_clone_is_of_the_day_whether_or_not_its_folder_is_named(tmp_path: Path, *, named: bool) -> None:
    made, origin, here = tmp_path / "made", tmp_path / "matrix.git", tmp_path / "here"
    made.mkdir()
    here.mkdir()
    git(made, "init", "--quiet")
    for day in ("2018-01-01", "2020-01-01"):
        git(made, "commit", "--quiet", "--allow-empty", "--message", day, day=day)
    git(made, "clone", "--quiet", "--bare", ".", str(origin))
    shutil.copy(SCRIPT, here / "git-as-of")
    (here / "git-as-of").chmod(0o755)
    step = f'eval "$(git-as-of 2019-03-01)" && git clone --quiet {origin}{" into" if named else ""}'
    environment = {**os.environ, "PATH": f"{here}:{os.environ['PATH']}"}
    subprocess.run(["bash", "-c", step], check=True, env=environment, cwd=here)
    said = ["git", "-C", str(here / ("into" if named else "matrix")), "log", "-1", "--format=%s"]
    assert subprocess.run(said, check=True, capture_output=True, text=True).stdout.strip() == "2018-01-01"


@pytest.mark.skipif(not Path("/dev/shm").is_dir(), reason="a step of a build has /dev/shm")
def test_a_clone_of_the_day_is_what_its_branch_was_then(tmp_path: Path) -> None:
    """What was committed elsewhere before the day, and merged after it, was not there yet."""
    origin, here = tmp_path / "origin", tmp_path / "here"
    origin.mkdir()
    here.mkdir()
    git(origin, "init", "--quiet", "--initial-branch=main")
    git(origin, "commit", "--quiet", "--allow-empty", "--message", "there", day="2018-01-01")
    git(origin, "checkout", "--quiet", "-b", "aside")
    git(origin, "commit", "--quiet", "--allow-empty", "--message", "aside", day="2019-01-01")
    git(origin, "checkout", "--quiet", "main")
    git(origin, "merge", "--quiet", "--no-ff", "--message", "merged", "aside", day="2020-01-01")
    shutil.copy(SCRIPT, here / "git-as-of")
    (here / "git-as-of").chmod(0o755)
    environment = {**os.environ, "PATH": f"{here}:{os.environ['PATH']}"}
    step = f'eval "$(git-as-of 2019-03-01)" && git clone --quiet {origin} into'
    subprocess.run(["bash", "-c", step], check=True, env=environment, cwd=here)
    said = ["git", "-C", str(here / "into"), "log", "-1", "--format=%s"]
    assert subprocess.run(said, check=True, capture_output=True, text=True).stdout.strip() == "there"
