"""The script that keeps a repository where it holds packages which a workspace lacks."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

pytestmark = pytest.mark.usefixtures("scripts_on_path")


def _manifest(folder: Path, name: str, *needed: str) -> None:
    folder.mkdir(parents=True)
    depends = "\n".join(f"  <build_depend>{each}</build_depend>" for each in needed)
    (folder / "package.xml").write_text(f'<package format="2">\n  <name> {name} </name>\n{depends}\n</package>\n')


def _git(folder: Path, *words: str, day: str = "2019-05-20") -> str:
    identity = ("-c", "user.name=a", "-c", "user.email=a@b.c", "-c", "init.defaultBranch=main")
    dates = {"GIT_AUTHOR_DATE": f"{day}T12:00:00Z", "GIT_COMMITTER_DATE": f"{day}T12:00:00Z"}
    answer = subprocess.run(
        ["git", *identity, *words], cwd=folder, env=os.environ | dates, capture_output=True, text=True, check=True
    )
    return answer.stdout.strip()


@pytest.fixture
def remote(tmp_path: Path) -> Path:
    """Return a repository with four packages, of which quad_x needs quad_msgs."""
    folder = tmp_path / "remote"
    _manifest(folder / "quad_x", "quad_x", "quad_msgs", "roscpp")
    _manifest(folder / "quad_msgs", "quad_msgs")
    _manifest(folder / "quad_viewer", "quad_viewer", "rviz")
    _manifest(folder / "group", "group")
    _manifest(folder / "group/quad_y", "quad_y")
    _git(folder, "init", "--quiet")
    _git(folder, "add", ".")
    _git(folder, "commit", "--quiet", "--message", "first")
    return folder


def _run(tmp_path: Path, *words: str) -> tuple[str, list[str], list[str]]:
    """Return what the script says, the packages that the workspace has, and those that its build tool passes by."""
    workspace = tmp_path / "ws/src"
    workspace.mkdir(parents=True, exist_ok=True)
    answer = subprocess.run(["clone-holding", *words], capture_output=True, text=True, cwd=tmp_path, check=True)
    found = sorted(file.parent.name for file in workspace.rglob("package.xml"))
    passed = sorted(file.parent.name for file in workspace.rglob("CATKIN_IGNORE"))
    assert passed == sorted(file.parent.name for file in workspace.rglob("COLCON_IGNORE"))
    return answer.stdout, found, passed


def test_it_is_kept_with_what_the_package_needs_of_it(tmp_path: Path, remote: Path) -> None:
    said, found, passed = _run(tmp_path, remote.as_uri(), f"{tmp_path}/ws/src/remote", "quad_x", "other")
    assert found == ["group", "quad_msgs", "quad_viewer", "quad_x", "quad_y"]
    assert passed == ["group", "quad_viewer", "quad_y"]
    assert "brings" in said
    assert {"quad_x", "quad_msgs"} <= {*said.split()}


@pytest.mark.parametrize(
    ("file", "text"),
    [
        ("launch/x.launch", '<include file="$(find quad_viewer)/launch/view.launch"/>'),
        ("launch/x.launch", '<node pkg="quad_viewer" type="view" name="view"/>'),
        ("launch/x.launch.py", "Node(package='quad_viewer', executable='view')"),
        ("launch/x.launch.py", 'share = get_package_share_directory("quad_viewer")'),
        ("launch/x.launch.xml", '<include file="$(find-pkg-share quad_viewer)/launch/view.launch.xml"/>'),
        ("urdf/x.urdf.xacro", '<mesh filename="package://quad_viewer/meshes/x.stl"/>'),
    ],
)
def test_what_its_launch_files_and_models_find_is_kept(tmp_path: Path, remote: Path, file: str, text: str) -> None:
    (remote / "quad_x" / file).parent.mkdir()
    (remote / "quad_x" / file).write_text(text)
    _git(remote, "add", ".")
    _git(remote, "commit", "--quiet", "--message", "second")
    _, _, passed = _run(tmp_path, remote.as_uri(), f"{tmp_path}/ws/src/remote", "quad_x")
    assert passed == ["group", "quad_y"]


def test_no_marker_hides_a_package_below(tmp_path: Path, remote: Path) -> None:
    _, _, passed = _run(tmp_path, remote.as_uri(), f"{tmp_path}/ws/src/remote", "quad_y")
    assert passed == ["quad_msgs", "quad_viewer", "quad_x"]


@pytest.mark.parametrize(
    ("words", "why"),
    [(("quad_z",), "it holds no package called quad_z"), (("--ref", "no-branch", "quad_x"), "it has no no-branch")],
)
def test_what_holds_none_is_left_out(tmp_path: Path, remote: Path, words: tuple[str, ...], why: str) -> None:
    *options, package = words
    said, found, _ = _run(tmp_path, *options, remote.as_uri(), f"{tmp_path}/ws/src/remote", package)
    assert (f"roslab: left out: {remote.as_uri()}: {why}" in said, found) == (True, [])
    assert not (tmp_path / "ws/src/remote").exists()


def test_what_is_not_there_is_left_out(tmp_path: Path) -> None:
    url = (tmp_path / "nowhere").as_uri()
    said, found, _ = _run(tmp_path, url, f"{tmp_path}/ws/src/nowhere", "quad_x")
    assert (f"roslab: left out: {url}: it cannot be cloned" in said, found) == (True, [])


def test_nothing_is_cloned_for_what_the_workspace_has(tmp_path: Path, remote: Path) -> None:
    _manifest(tmp_path / "ws/src/mine", "quad_x")
    said, found, _ = _run(tmp_path, remote.as_uri(), f"{tmp_path}/ws/src/remote", "quad_x")
    assert ("is not needed" in said, found) == (True, ["mine"])


def test_a_day_tells_the_commit(tmp_path: Path, remote: Path) -> None:
    first = _git(remote, "rev-parse", "HEAD")
    (remote / "new").write_text("new\n")
    _git(remote, "add", ".")
    _git(remote, "commit", "--quiet", "--message", "second", day="2021-05-20")
    folder = tmp_path / "ws/src/remote"
    _run(tmp_path, "--before", "2020-01-01", remote.as_uri(), f"{folder}", "quad_x")
    assert _git(folder, "rev-parse", "HEAD") == first


@pytest.mark.parametrize(
    ("name", "own", "cloned"),
    [("heavy", True, False), ("swift-parts", True, True), ("heavy", False, True)],
)
@pytest.mark.usefixtures("local_submodules")
def test_submodules_are_cloned_where_one_may_hold_it(
    tmp_path: Path, remote: Path, name: str, own: bool, cloned: bool
) -> None:
    part = tmp_path / name
    _manifest(part / "swift_tools", "swift_tools")
    whole = remote if own else tmp_path / "whole"
    whole.mkdir(exist_ok=True)
    for folder in (part, whole):
        _git(folder, "init", "--quiet")
    _git(part, "add", ".")
    _git(part, "commit", "--quiet", "--message", "first")
    _git(whole, "submodule", "--quiet", "add", part.as_uri())
    _git(whole, "commit", "--quiet", "--message", "second")
    said, found, _ = _run(tmp_path, whole.as_uri(), f"{tmp_path}/ws/src/remote", "quad_z_msgs", "swift_tools")
    assert ("swift_tools" in found) is cloned
    assert ("it holds no package called" in said) is not cloned


@pytest.fixture
def local_submodules(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let git clone submodules from this machine, as it does from a host."""
    for name, value in {"COUNT": "1", "KEY_0": "protocol.file.allow", "VALUE_0": "always"}.items():
        monkeypatch.setenv(f"GIT_CONFIG_{name}", value)


@pytest.mark.parametrize(("branch", "brings"), [("mbzirc", "quad_z"), ("gone", "")])
def test_a_branch_that_may_be_gone(tmp_path: Path, remote: Path, branch: str, brings: str) -> None:
    _git(remote, "checkout", "--quiet", "-b", "mbzirc")
    _manifest(remote / "quad_z", "quad_z")
    _git(remote, "add", ".")
    _git(remote, "commit", "--quiet", "--message", "second")
    _git(remote, "checkout", "--quiet", "main")
    said, found, _ = _run(
        tmp_path, "--branch", branch, remote.as_uri(), f"{tmp_path}/ws/src/remote", "quad_z", "quad_x"
    )
    assert "quad_x" in found, "the default branch has it"
    assert ("quad_z" in found) == bool(brings)
    assert ("has no gone any more: main is taken" in said) == (branch == "gone")


def test_what_a_clone_of_before_hid_is_there_once_it_is_asked_for(tmp_path: Path, remote: Path) -> None:
    _manifest(remote / "quad_plan", "quad_plan", "quad_viewer")
    _git(remote, "add", ".")
    _git(remote, "commit", "--quiet", "--message", "second")
    (tmp_path / "ws/src/mine").mkdir(parents=True)
    (tmp_path / "ws/src/mine/CATKIN_IGNORE").touch()  # the author's own
    (tmp_path / "ws/src/mine/COLCON_IGNORE").touch()
    _, _, passed = _run(tmp_path, remote.as_uri(), f"{tmp_path}/ws/src/remote", "quad_msgs")
    assert passed == ["group", "mine", "quad_plan", "quad_viewer", "quad_x", "quad_y"]
    said, _, passed = _run(tmp_path, (tmp_path / "gone").as_uri(), f"{tmp_path}/ws/src/gone", "quad_plan")
    assert passed == ["group", "mine", "quad_x", "quad_y"]
    assert "roslab: no longer hidden: quad_plan\nroslab: no longer hidden: quad_viewer\n" in said
    assert "is not needed: the workspace has quad_plan" in said


def test_what_a_clone_of_before_hid_stays_so_where_another_has_it(tmp_path: Path, remote: Path) -> None:
    _run(tmp_path, remote.as_uri(), f"{tmp_path}/ws/src/remote", "quad_msgs")
    _manifest(tmp_path / "ws/src/mine", "quad_x")
    said, _, passed = _run(tmp_path, remote.as_uri(), f"{tmp_path}/ws/src/again", "quad_x")
    assert "quad_x" in passed
    assert "no longer hidden" not in said


@pytest.mark.parametrize(
    ("options", "branch", "found"),
    [(("--ros1",), "feature/noetic", True), (("--ros1",), "feature/other", False), ((), "feature/noetic", False)],
)
def test_a_branch_for_the_other_ros(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, options: tuple[str, ...], branch: str, found: bool
) -> None:
    folder = tmp_path / "remote"
    _manifest(folder, "torch_tools")
    text = (folder / "package.xml").read_text()
    for name, tool, called in ((branch, "catkin", "torch_tools"), ("main", "ament_cmake", "torch_tools_2")):
        _git(folder, "init", "--quiet")
        _git(folder, "checkout", "--quiet", "-B", name)
        made = text.replace("torch_tools", called).replace(
            "</package>", f"<buildtool_depend>{tool}</buildtool_depend></package>"
        )
        (folder / "package.xml").write_text(made)
        _git(folder, "add", ".")
        _git(folder, "commit", "--quiet", "--message", name)
    monkeypatch.setenv("ROS_DISTRO", "noetic")
    said, there, _ = _run(tmp_path, *options, folder.as_uri(), f"{tmp_path}/ws/src/remote", "torch_tools")
    assert (bool(there), f"its branch {branch} is taken" in said) == (found, found)


def test_a_clone_is_asked_for_all_that_is_missing(tmp_path: Path, remote: Path) -> None:
    said, _, passed = _run(
        tmp_path, remote.as_uri(), f"{tmp_path}/ws/src/remote", "quad_y", "--also", "quad_viewer", "other"
    )
    assert passed == ["quad_msgs", "quad_x"]
    assert {"quad_y", "quad_viewer"} <= {*said.split()}


def test_what_is_there_needs_no_clone_for_others_alone(tmp_path: Path, remote: Path) -> None:
    _manifest(tmp_path / "ws/src/mine", "quad_y")
    said, found, _ = _run(tmp_path, remote.as_uri(), f"{tmp_path}/ws/src/remote", "quad_y", "--also", "quad_viewer")
    assert "is not needed: the workspace has quad_y" in said
    assert found == ["mine"]


@pytest.mark.parametrize(
    ("cmake", "config", "kept"),
    [
        ("cmake_minimum_required(VERSION 3.5)\nproject(\n  Quad-Map VERSION 3)\nproject(other)\n", "", True),
        ("project(other)\n", "cmake/quad_mapConfig.cmake.in", True),
        ("project(other) # project(quad_map)\n", "", False),
        ("", "quad_map-config.cmake", False),
    ],
)
def test_a_library_of_plain_cmake_that_is_called_so_is_kept(
    tmp_path: Path, cmake: str, config: str, kept: bool
) -> None:
    library = tmp_path / "remote"
    library.mkdir()
    for file, text in (("CMakeLists.txt", cmake), (config, "set(X 1)\n")):
        if file and text:
            (library / file).parent.mkdir(exist_ok=True)
            (library / file).write_text(text)
    (library / "README").write_text("a map\n")
    _git(library, "init", "--quiet")
    _git(library, "add", ".")
    _git(library, "commit", "--quiet", "--message", "first")
    said, _, _ = _run(tmp_path, library.as_uri(), f"{tmp_path}/ws/src/remote", "quad_map")
    noted = tmp_path / "ws/src/remote/.git/roslab-plain"
    assert ("is quad_map, a library without a package.xml" in said, noted.exists()) == (kept, kept)
    assert ("it holds no package called quad_map" in said) is not kept
    if kept:
        said, _, _ = _run(tmp_path, library.as_uri(), f"{tmp_path}/ws/src/again", "quad_map")
        assert "is not needed: the workspace has quad_map" in said


@pytest.mark.parametrize(
    ("makefile", "name", "kept"),
    [
        ("all:\n\ttrue\ninstall:\n\tcp a.hpp /usr/local/include\n", "quad_map", True),
        ("install: all\n\tcp a.hpp /usr/local/include\n", "quad_map", True),
        ("all:\n\ttrue\n", "quad_map", False),
        ("install:\n\ttrue\n", "other", False),
    ],
)
def test_a_library_with_a_makefile_that_installs_it_is_kept(
    tmp_path: Path, makefile: str, name: str, kept: bool
) -> None:
    library = tmp_path / name
    library.mkdir()
    (library / "Makefile").write_text(makefile)
    _git(library, "init", "--quiet")
    _git(library, "add", ".")
    _git(library, "commit", "--quiet", "--message", "first")
    said, _, _ = _run(tmp_path, library.as_uri(), f"{tmp_path}/ws/src/{name}", "quad_map")
    assert ("is quad_map, a library without a package.xml" in said) is kept
    assert (tmp_path / f"ws/src/{name}/.git/roslab-plain").exists() is kept


def test_a_library_beside_packages_is_none_of_plain_cmake(tmp_path: Path, remote: Path) -> None:
    (remote / "CMakeLists.txt").write_text("project(quad_map)\n")
    _git(remote, "add", ".")
    _git(remote, "commit", "--quiet", "--message", "second")
    said, _, _ = _run(tmp_path, remote.as_uri(), f"{tmp_path}/ws/src/remote", "quad_map")
    assert "it holds no package called quad_map" in said


@pytest.mark.parametrize(
    ("options", "passed", "said_of"),
    [
        (("--ros1",), [], "lab_maps is a package of rosbuild, which catkin does not compile"),
        (("--ros1", "--rosmake"), [], "brings lab_maps"),
        (("--ros2",), [], "it holds no package called lab_maps"),
    ],
)
def test_a_package_of_rosbuild_serves_its_files(
    tmp_path: Path, options: tuple[str, ...], passed: list[str], said_of: str
) -> None:
    remote = tmp_path / "lab_maps"
    remote.mkdir()
    (remote / "manifest.xml").write_text('<package>\n<depend package="gone"/>\n</package>\n')
    (remote / "CMakeLists.txt").write_text("rosbuild_init()\n")
    _git(remote, "init", "--quiet")
    _git(remote, "add", ".")
    _git(remote, "commit", "--quiet", "--message", "first")
    folder = tmp_path / "ws/src/lab_maps"
    said, found, hidden = _run(tmp_path, *options, remote.as_uri(), str(folder), "lab_maps")
    catkin = options == ("--ros1",)
    assert said_of in said
    assert (found, hidden) == (["lab_maps"] if catkin else [], passed)
    assert folder.exists() == (options != ("--ros2",))
    if catkin:
        assert "gone" not in (folder / "package.xml").read_text()
        assert "catkin_package()" in (folder / "CMakeLists.txt").read_text()
        assert (folder / "CMakeLists.rosbuild.txt").read_text() == "rosbuild_init()\n"
    if options == ("--ros1", "--rosmake"):
        said, _, _ = _run(tmp_path, *options, remote.as_uri(), f"{tmp_path}/ws/src/again", "lab_maps")
        assert "is not needed: the workspace has lab_maps" in said


@pytest.fixture
def of_python(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a repository with modules of Python: a package, a file beside a setup.py, and others elsewhere."""
    folder = tmp_path / "library"
    _manifest(folder / "robot", "robot")
    files = ["detect/Detection/__init__.py", "detect/setup.py", "filters/Kalman.py", "filters/setup.py"]
    files += ["robot/src/Inside/__init__.py", "scripts/Loose.py", "old/detect/more/Detection/__init__.py"]
    for file in files:
        (folder / file).parent.mkdir(parents=True, exist_ok=True)
        (folder / file).write_text("here = __file__\n")
    _git(folder, "init", "--quiet")
    _git(folder, "add", ".")
    _git(folder, "commit", "--quiet", "--message", "first")
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    return folder


def test_the_modules_of_python_that_it_holds_are_found(tmp_path: Path, of_python: Path) -> None:
    clone = tmp_path / "ws/src/library"
    words = (of_python.as_uri(), str(clone), "robot_msgs", "Detection", "Kalman", "Inside", "Loose")
    said, found, passed = _run(tmp_path, *words)
    assert "brings Detection Kalman, for Python" in said
    assert (found, passed) == (["robot"], ["robot"])  # nothing needs its package
    (listed, *_) = (tmp_path / "home").rglob("site-packages/roslab.pth")
    assert listed.read_text().split() == [f"{clone}/detect", f"{clone}/filters"]


def test_a_repository_without_the_module_is_left_out(tmp_path: Path, of_python: Path) -> None:
    said, found, _ = _run(tmp_path, of_python.as_uri(), f"{tmp_path}/ws/src/library", "Loose", "Inside")
    assert "it holds no package called Loose Inside" in said
    assert found == []


def test_a_module_that_another_clone_brought_is_not_looked_for(tmp_path: Path, of_python: Path) -> None:
    _run(tmp_path, of_python.as_uri(), f"{tmp_path}/ws/src/library", "Kalman")
    said, _, _ = _run(tmp_path, of_python.as_uri(), f"{tmp_path}/ws/src/other", "Kalman")
    assert "is not needed: the workspace has Kalman" in said
