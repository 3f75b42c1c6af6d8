"""The script that clones what a list or a page names, where its host lets anybody."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Source
from roslab.plan.plan import Plan
from roslab.render.dockerfile import dockerfile

pytestmark = pytest.mark.usefixtures("scripts_on_path")

GIT = """\
#!/bin/sh
# A stand-in for git whose clone fails
[ "$GIT_TERMINAL_PROMPT" = 0 ] || echo "it waits for a password"
echo "$SAID" >&2
exit 128
"""


def _run(*words: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(["clone-listed", *words], capture_output=True, text=True, check=False)


def _git(folder: Path, *words: str) -> str:
    identity = ("-c", "user.name=a", "-c", "user.email=a@b.c", "-c", "init.defaultBranch=main")
    return subprocess.run(
        ["git", *identity, *words], cwd=folder, capture_output=True, text=True, check=True
    ).stdout.strip()


@pytest.fixture
def remote(tmp_path: Path) -> Path:
    """Return a repository with a branch."""
    folder = tmp_path / "remote"
    folder.mkdir()
    _git(folder, "init", "--quiet")
    _git(folder, "commit", "--quiet", "--allow-empty", "--message", "first")
    _git(folder, "branch", "devel")
    (folder / "new").write_text("new")
    _git(folder, "add", ".")
    _git(folder, "commit", "--quiet", "--message", "second")
    return folder


@pytest.mark.parametrize(("options", "new"), [((), True), (("--branch", "devel"), False), (("--ref", "devel"), False)])
def test_what_is_there_is_cloned(tmp_path: Path, remote: Path, options: tuple[str, ...], new: bool) -> None:
    answer = _run(*options, remote.as_uri(), str(tmp_path / "copy"))
    assert (answer.returncode, (tmp_path / "copy/new").exists()) == (0, new), answer.stderr


@pytest.mark.parametrize(
    ("distro", "branch", "new"),
    [
        ("noetic", "kinetic-devel", True),
        ("melodic", "kinetic-devel", False),
        ("noetic", "devel", False),
        ("", "kinetic-devel", False),
    ],
)
def test_a_branch_of_another_distribution_gives_way_to_its_own(
    tmp_path: Path, remote: Path, monkeypatch: pytest.MonkeyPatch, *, distro: str, branch: str, new: bool
) -> None:
    _git(remote, "branch", "kinetic-devel", "devel")
    _git(remote, "branch", "noetic-devel")
    monkeypatch.setenv("ROS_DISTRO", distro)
    answer = _run("--ros1", "--branch", branch, remote.as_uri(), str(tmp_path / "copy"))
    assert (answer.returncode, (tmp_path / "copy/new").exists()) == (0, new), answer.stderr
    assert ("noetic-devel: it is taken" in answer.stdout) is new


@pytest.mark.parametrize(
    ("said", "status"),
    [
        ("fatal: could not read Username for 'https://github.com': terminal prompts disabled", 0),
        ("fatal: Authentication failed for 'https://bitbucket.org/lab/quad/'", 0),
        ("remote: Repository not found.", 0),
        ("fatal: repository 'https://gitlab.com/lab/quad/' not found", 0),
        ("git@github.com: Permission denied (publickey).", 0),
        ("fatal: could not create work tree dir 'quad': Permission denied", 128),
        ("fatal: unable to access 'https://github.com/lab/quad/': Could not resolve host: github.com", 128),
        ("fatal: unable to access 'https://github.com/lab/quad/': The requested URL returned error: 503", 128),
        ("fatal: early EOF", 128),
    ],
)
def test_only_what_a_host_refuses_is_left_out(
    tmp_path: Path, scripts_on_path: Path, monkeypatch: pytest.MonkeyPatch, said: str, status: int
) -> None:
    (scripts_on_path / "git").write_text(GIT)
    (scripts_on_path / "git").chmod(0o755)
    monkeypatch.setenv("SAID", said)
    answer = _run("https://example.org/quad.git", str(tmp_path / "quad"))
    assert answer.returncode == status
    assert ("roslab: left out: https://example.org/quad.git: " in answer.stdout) == (status == 0)
    assert said in answer.stderr
    assert "waits" not in answer.stdout + answer.stderr


@pytest.mark.parametrize(
    ("version", "said", "status"),
    [
        ("1.9.1", "fatal: unable to access 'https://example.org/': gnutls_handshake() failed: Handshake failed", 0),
        ("1.9.1", "fatal: unable to access 'https://example.org/': server certificate verification failed.", 0),
        ("1.9.1", "fatal: unable to access 'https://example.org/': Could not resolve host: example.org", 128),
        ("2.25.1", "fatal: unable to access 'https://example.org/': gnutls_handshake() failed: Handshake failed", 128),
    ],
)
def test_a_host_may_not_speak_to_an_old_git(
    tmp_path: Path, scripts_on_path: Path, monkeypatch: pytest.MonkeyPatch, *, version: str, said: str, status: int
) -> None:
    asked = f'[ "$1" != --version ] || {{ echo "git version {version}"; exit 0; }}\n'
    (scripts_on_path / "git").write_text(GIT.replace("[ ", f"{asked}[ ", 1))
    (scripts_on_path / "git").chmod(0o755)
    monkeypatch.setenv("SAID", said)
    answer = _run("https://example.org/quad.git", str(tmp_path / "quad"))
    assert answer.returncode == status
    assert ("does not speak to a git this old" in answer.stdout) == (status == 0)


def test_a_ref_that_is_not_there_stops(tmp_path: Path, remote: Path) -> None:
    assert _run("--ref", "v9", remote.as_uri(), str(tmp_path / "copy")).returncode != 0


CATKIN = "<package><name>a</name><buildtool_depend>catkin</buildtool_depend></package>"
AMENT = CATKIN.replace("catkin", "ament_cmake")
BOTH = AMENT.replace("<name>", '<buildtool_depend condition="$ROS_VERSION == 1">catkin</buildtool_depend><name>')


@pytest.mark.parametrize(
    ("options", "main", "branches", "taken", "told"),
    [
        (("--ros2",), CATKIN, {"ros2": AMENT}, AMENT, "its branch ros2 is taken"),
        (("--ros2",), CATKIN, {"ros2": CATKIN, "humble": AMENT}, AMENT, "its branch humble is taken"),
        (("--ros2", "--before", "2999-01-01"), CATKIN, {"humble": AMENT}, AMENT, "its branch humble is taken"),
        (("--ros2",), CATKIN, {"foxy": AMENT}, CATKIN, "no branch for ROS 2"),
        (("--ros2",), BOTH, {"ros2": AMENT}, BOTH, ""),
        (("--ros2",), AMENT, {"ros2": BOTH}, AMENT, ""),
        (("--ros2",), "<package><name>a</name></package>", {"ros2": AMENT}, "<package><name>a</name></package>", ""),
        (("--ros1",), AMENT, {"ros1": CATKIN}, CATKIN, "its branch ros1 is taken"),
        (("--ros1", "--before", "2999-01-01"), AMENT, {"humble-devel": CATKIN}, CATKIN, "its branch humble-devel is"),
        (("--ros1",), AMENT, {"feature/humble": CATKIN}, CATKIN, "its branch feature/humble is taken"),
        (("--ros1",), AMENT, {"a/b/humble": CATKIN}, CATKIN, "its branch a/b/humble is taken"),
        (("--ros1",), AMENT, {"feature/not-humble": CATKIN}, AMENT, "no branch for ROS 1"),
        (("--ros1",), AMENT, {"feature/humble": AMENT}, AMENT, "no branch for ROS 1"),
        (("--ros1",), AMENT, {"ros1": AMENT}, AMENT, "no branch for ROS 1"),
        (("--ros1",), BOTH, {"ros1": CATKIN}, BOTH, ""),
        (("--ros1",), CATKIN, {"ros2": AMENT}, CATKIN, ""),
        ((), CATKIN, {"ros2": AMENT}, CATKIN, ""),
        ((), AMENT, {"ros1": CATKIN}, AMENT, ""),
    ],
)
def test_packages_of_the_other_ros(
    tmp_path: Path,
    remote: Path,
    monkeypatch: pytest.MonkeyPatch,
    *,
    options: tuple[str, ...],
    main: str,
    branches: dict[str, str],
    taken: str,
    told: str,
) -> None:
    (remote / "a").mkdir()
    for name, text in {"main": main, **branches}.items():
        _git(remote, "checkout", "--quiet", "-B", name)
        (remote / "a/package.xml").write_text(text)
        _git(remote, "add", ".")
        _git(remote, "commit", "--quiet", "--allow-empty", "--message", name)
    _git(remote, "checkout", "--quiet", "main")
    monkeypatch.setenv("ROS_DISTRO", "humble")
    answer = _run(*options, remote.as_uri(), str(tmp_path / "copy"))
    assert (answer.returncode, (tmp_path / "copy/a/package.xml").read_text()) == (0, taken), answer.stderr
    assert told in answer.stdout
    assert (f"of ROS {1 if '--ros2' in options else 2} alone" in answer.stdout) == bool(told)
    passed_by = "no branch" in told
    assert [(tmp_path / "copy" / f"{tool}_IGNORE").exists() for tool in ("CATKIN", "COLCON")] == [passed_by] * 2


def test_what_calls_the_macros_of_this_ros_is_not_passed_by(
    tmp_path: Path, remote: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (remote / "a").mkdir()
    (remote / "a/package.xml").write_text(CATKIN)
    (remote / "a/CMakeLists.txt").write_text("find_package(ament_cmake REQUIRED)\nament_package()\n")
    _git(remote, "add", ".")
    _git(remote, "commit", "--quiet", "--message", "a")
    monkeypatch.setenv("ROS_DISTRO", "humble")
    assert _run("--ros2", remote.as_uri(), str(tmp_path / "copy")).returncode == 0
    assert not (tmp_path / "copy/COLCON_IGNORE").exists()


@pytest.mark.parametrize(("kind", "option"), [("ros1", "--ros1 "), ("ros2", "--ros2 ")])
def test_it_is_told_for_which_ros(plan: Callable[..., Plan], kind: str, option: str) -> None:
    source = Source(name="quad", repo="https://example.org/quad.git", ref="devel", build="colcon", listed=True)
    text = dockerfile(plan(kind=kind, sources=(source,)))
    assert (
        f"RUN clone-listed {option}--branch devel https://example.org/quad.git /home/${{NB_USER}}/ws/src/quad" in text
    )
    assert "COPY --from=scripts /checkout-branch /usr/local/bin/" in text


@pytest.mark.parametrize(
    ("options", "files", "said"),
    [
        (("--ros1",), ("CMakeLists.txt",), "with build: cmake"),
        (("--ros1", "--plain"), ("CMakeLists.txt",), "it is compiled by CMake as a library"),
        (("--ros1", "--plain"), ("doc.md",), "so that the workspace builds none of it\n"),
        (("--ros1",), ("CMakeLists.txt", "inner/package.xml"), ""),
        (("--ros2",), ("CMakeLists.txt",), ""),
        (("--ros2",), ("doc.md",), "so that the workspace builds none of it\n"),
        ((), ("doc.md",), ""),
    ],
)
def test_a_clone_without_a_package_is_told(
    tmp_path: Path, remote: Path, options: tuple[str, ...], files: tuple[str, ...], said: str
) -> None:
    for name in files:
        (remote / name).parent.mkdir(exist_ok=True)
        (remote / name).write_text("")
    _git(remote, "add", ".")
    _git(remote, "commit", "--quiet", "--message", "third")
    answer = _run(*options, remote.as_uri(), str(tmp_path / "copy"))
    assert answer.returncode == 0
    assert (said in answer.stdout) if said else ("has no package" not in answer.stdout)


def test_a_repository_without_a_commit_stops_nothing(tmp_path: Path) -> None:
    empty = tmp_path / "empty"
    empty.mkdir()
    _git(empty, "init", "--quiet")
    answer = _run("--ros2", empty.as_uri(), str(tmp_path / "copy"))
    assert (answer.returncode, "has no package at no commit" in answer.stdout) == (0, True)
