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
    assert "COPY --from=scripts /git-as-of /usr/local/lib/git-as-of/git" in text, "CMake calls it again in later steps"


@pytest.mark.parametrize(
    "line",
    [
        FETCH,
        FETCH.replace(")", " GIT_TAG master)"),
        FETCH.replace(")", " GIT_TAG origin/release-1.2)"),
        f"ExternalProject_Add(matrix PREFIX matrix GIT_REPOSITORY {URL} GIT_TAG humble-devel)",
        f"download_project(PROJ matrix GIT_REPOSITORY {URL} GIT_TAG main QUIET)",
        "CPMAddPackage(NAME matrix GITLAB_REPOSITORY example/matrix.git GIT_TAG main)",
        'CPMAddPackage("gl:example/matrix.git#main")',
    ],
)
def test_a_branch_that_cmake_fetches_is_what_it_was(tmp_path: Path, line: str) -> None:
    planned = committed(tmp_path, line, "2019-03-01")
    assert planned.plan.workspace.clones_day == "2019-03-01"
    assert [(r.answer, r.line) for r in planned.decision.reasons if "without a commit" in r.reason] == [(URL, 2)]


def test_a_template_that_cmake_fills_in_fetches_too(tmp_path: Path) -> None:
    (tmp_path / "CMakeLists.txt.in").write_text(f"ExternalProject_Add(m GIT_REPOSITORY {URL} GIT_TAG main)\n")
    assert committed(tmp_path, "", "2019-03-01").plan.workspace.clones_day == "2019-03-01"


@pytest.mark.parametrize(
    ("line", "day", "config"),
    [
        (FETCH.replace(")", " GIT_TAG v1.2)"), "2019-03-01", ""),
        (FETCH.replace(")", " GIT_TAG deadbee)"), "2019-03-01", ""),
        (FETCH.replace(")", " GIT_TAG ${TAG_OF_MATRIX})"), "2019-03-01", ""),
        ('CPMAddPackage("gh:example/matrix@1.2")', "2019-03-01", ""),
        ("CPMAddPackage(NAME m GITHUB_REPOSITORY example/matrix VERSION 1.2)", "2019-03-01", ""),
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


@pytest.mark.parametrize(
    ("line", "day"),
    [(f"git clone {URL}", "2019-03-01"), (f"git clone -b v1.2 {URL}", ""), ("echo", "")],
)
def test_what_a_script_of_the_tree_clones_is_of_the_day(tmp_path: Path, line: str, day: str) -> None:
    files = {
        "setup.py": "from setuptools import setup\nsetup(name='demo')\n",
        "README.md": "# Demo\n\n## Installation\n```\nbash build_parts.sh\npip install .\n```\n",
        "build_parts.sh": f"#!/bin/bash\n{line}\ncd matrix\nmkdir build\ncd build\ncmake ..\nmake\n",
    }
    for path, text in files.items():
        (tmp_path / path).write_text(text)
    git(tmp_path, "init", "--quiet")
    git(tmp_path, "add", ".")
    git(tmp_path, "commit", "--quiet", "--message", "x", day="2019-03-01")
    planned = plan_repository(tmp_path)
    assert [script.path for script in planned.decision.scripts] == ["build_parts.sh"]
    assert planned.plan.workspace.clones_day == day
    run = 'RUN eval "$(git-as-of 2019-03-01)" \\\n && cd /home/${NB_USER}/'
    assert (run in dockerfile(planned.plan)) is bool(day)


def test_what_cmake_fetches_for_pip_is_of_the_day(tmp_path: Path) -> None:
    """pip builds a project that asks for nothing but what builds it."""
    files = {"python/CMakeLists.txt": f"project(b)\n{FETCH}\n", "python/example.py": "import b\n"}
    files["README.md"] = "```\npip install ./python\npython python/example.py\n```\n"
    files["python/pyproject.toml"] = (
        '[build-system]\nrequires = ["scikit_build_core"]\nbuild-backend = "scikit_build_core.build"\n'
        '[project]\nname = "b"\nversion = "1"\n'
    )
    for path, text in files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    planned = committed(tmp_path, "", "2019-03-01")
    assert planned.plan.python.projects == ("python",)
    assert planned.plan.python.day == "2019-03-01"
    assert planned.plan.python.clones, "index-as-of calls git-as-of where it is there"
    assert "COPY --from=scripts /git-as-of /usr/local/bin/" in dockerfile(planned.plan)


def put_script(folder: Path) -> None:
    """Have the script in a folder, with another place for git's name than all other tests that run now."""
    (folder / "git-as-of").write_text(SCRIPT.read_text(encoding="utf-8").replace("/dev/shm", str(folder)))
    (folder / "git-as-of").chmod(0o755)


needs_cmake = pytest.mark.skipif(shutil.which("cmake") is None, reason="CMake itself fetches")


def origin_of(folder: Path) -> Path:
    """Make a repository with a commit before the day and one after it, on two branches, and a tag after it."""
    origin = folder / "origin" / "matrix"
    origin.mkdir(parents=True)
    git(origin, "init", "--quiet", "--initial-branch=main")
    for name, day in (("old", "2018-01-01"), ("new", "2020-01-01")):
        (origin / "CMakeLists.txt").write_text(f'message("it is {name}")\n')
        git(origin, "add", ".")
        git(origin, "commit", "--quiet", "--message", name, day=day)
    git(origin, "branch", "aside")
    git(origin, "tag", "v2")
    return origin


def step(here: Path, commands: str) -> str:
    """Run commands as a step of the day, and return what they say."""
    here.mkdir(exist_ok=True)
    put_script(here)
    environment = {**os.environ, "PATH": f"{here}:{os.environ['PATH']}"}
    words = ["bash", "-c", f'set -e; eval "$(git-as-of 2019-03-01)"\n{commands}']
    ran = subprocess.run(words, check=False, env=environment, cwd=here, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    return ran.stdout + ran.stderr


@pytest.mark.parametrize(
    ("commands", "said"),
    [
        ("cd m; git fetch --tags --force origin; git rebase origin/main", "old"),
        ("cd m; git --git-dir=.git fetch --tags --force origin; git --git-dir=.git rebase origin/main", "old"),
        ("git -C m fetch; git -C m checkout origin/aside", "old"),
        ("cd m; git checkout aside", "old"),
        ("cd m; git fetch; git checkout v2", "new"),
        ("cd m; git pull", "old"),
        ("git -C m pull --ff-only origin main", "old"),
        ("cd m; git fetch origin aside; git checkout FETCH_HEAD", "old"),
        ("cd m; git fetch origin aside; git reset --hard FETCH_HEAD", "old"),
        ("cd m; git fetch origin v2; git checkout FETCH_HEAD", "new"),
    ],
)
def test_what_is_fetched_again_stays_of_the_day(tmp_path: Path, commands: str, said: str) -> None:
    step(tmp_path / "here", f"git clone {origin_of(tmp_path)} m; {commands}")
    words = ["git", "-C", str(tmp_path / "here/m"), "log", "-1", "--format=%s"]
    assert subprocess.run(words, check=True, capture_output=True, text=True).stdout.strip() == said


@pytest.mark.parametrize("branch", ["main", "aside"])
def test_the_newest_alone_that_is_fetched_into_an_empty_repository_is_of_the_day(tmp_path: Path, branch: str) -> None:
    origin = origin_of(tmp_path)
    git(origin, "checkout", "--quiet", "aside")
    git(origin, "commit", "--quiet", "--allow-empty", "--message", "newest", day="2021-01-01")
    fetch = f"git init m; cd m; git remote add origin file://{origin}; git fetch --depth 1 origin {branch}"
    step(tmp_path / "here", f"{fetch}; git checkout FETCH_HEAD")
    words = ["git", "-C", str(tmp_path / "here/m"), "log", "-1", "--format=%s"]
    assert subprocess.run(words, check=True, capture_output=True, text=True).stdout.strip() == "old"


def test_what_was_changed_before_a_pull_stays(tmp_path: Path) -> None:
    commands = f"git clone {origin_of(tmp_path)} m; cd m; echo more >other.txt; git pull; git pull"
    step(tmp_path / "here", commands)
    assert (tmp_path / "here/m/other.txt").read_text() == "more\n"


@pytest.mark.parametrize(
    ("words", "folder"),
    [("ORIGIN --recursive", "matrix"), ("ORIGIN -b aside", "matrix"), ("--branch aside -- ORIGIN", "matrix")],
)
def test_a_clone_with_options_behind_its_address_is_of_the_day(tmp_path: Path, words: str, folder: str) -> None:
    origin = origin_of(tmp_path)
    step(tmp_path / "here", f"git clone {words.replace('ORIGIN', '../origin/matrix')}")
    for place, said in ((tmp_path / "here" / folder, "old"), (origin, "new")):  # what is cloned stays as it is
        log = ["git", "-C", str(place), "log", "-1", "--format=%s"]
        assert subprocess.run(log, check=True, capture_output=True, text=True).stdout.strip() == said


@pytest.mark.parametrize(
    ("options", "said"),
    [("", "old"), ("--depth 1", "old"), ("--depth 1 --branch aside", "old"), ("--branch v2", "new")],
)
def test_a_clone_of_the_newest_alone_is_of_the_day_too(tmp_path: Path, options: str, said: str) -> None:
    step(tmp_path / "here", f"git clone {options} file://{origin_of(tmp_path)} m")
    words = ["git", "-C", str(tmp_path / "here/m"), "log", "-1", "--format=%s"]
    assert subprocess.run(words, check=True, capture_output=True, text=True).stdout.strip() == said


@needs_cmake
@pytest.mark.parametrize(
    ("fetched", "said"),
    [
        ("GIT_TAG main", "old"),
        ("GIT_TAG origin/aside", "old"),
        ("GIT_TAG main GIT_SHALLOW TRUE", "old"),
        ("GIT_TAG v2", "new"),
    ],
)
def test_cmake_builds_what_was_there(tmp_path: Path, fetched: str, said: str) -> None:
    """Its update step fetches once more, and goes to where the remote's branch is; a later build does so again."""
    here, origin = tmp_path / "here", origin_of(tmp_path)
    here.mkdir()
    (here / "CMakeLists.txt").write_text(
        f"""cmake_minimum_required(VERSION 3.14)
project(a NONE)
include(FetchContent)
FetchContent_Declare(matrix GIT_REPOSITORY file://{origin} {fetched})
FetchContent_MakeAvailable(matrix)
"""
    )
    told = step(here, "cmake -S . -B build && cmake -S . -B build")
    assert told.count(f"it is {said}") == 2, told


@pytest.mark.parametrize("named", [True, False])
def test_a_clone_is_of_the_day_whether_or_not_its_folder_is_named(tmp_path: Path, *, named: bool) -> None:
    made, origin, here = tmp_path / "made", tmp_path / "matrix.git", tmp_path / "here"
    made.mkdir()
    here.mkdir()
    git(made, "init", "--quiet")
    for day in ("2018-01-01", "2020-01-01"):
        git(made, "commit", "--quiet", "--allow-empty", "--message", day, day=day)
    git(made, "clone", "--quiet", "--bare", ".", str(origin))
    put_script(here)
    step = f'eval "$(git-as-of 2019-03-01)" && git clone --quiet {origin}{" into" if named else ""}'
    environment = {**os.environ, "PATH": f"{here}:{os.environ['PATH']}"}
    subprocess.run(["bash", "-c", step], check=True, env=environment, cwd=here)
    said = ["git", "-C", str(here / ("into" if named else "matrix")), "log", "-1", "--format=%s"]
    assert subprocess.run(said, check=True, capture_output=True, text=True).stdout.strip() == "2018-01-01"


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
    put_script(here)
    environment = {**os.environ, "PATH": f"{here}:{os.environ['PATH']}"}
    step = f'eval "$(git-as-of 2019-03-01)" && git clone --quiet {origin} into'
    subprocess.run(["bash", "-c", step], check=True, env=environment, cwd=here)
    said = ["git", "-C", str(here / "into"), "log", "-1", "--format=%s"]
    assert subprocess.run(said, check=True, capture_output=True, text=True).stdout.strip() == "there"
