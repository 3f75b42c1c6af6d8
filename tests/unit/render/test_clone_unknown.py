"""The script that clones what cloned repositories ask for in turn."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from roslab.render import image_scripts

FOLDER = Path(image_scripts.__path__[0])
pytestmark = pytest.mark.usefixtures("scripts_on_path")


def _manifest(folder: Path, name: str, *needed: str) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    depends = "".join(f"  <depend>{each}</depend>\n" for each in needed)
    (folder / "package.xml").write_text(f"<package>\n  <name>{name}</name>\n{depends}</package>\n")


def _git(folder: Path, *words: str) -> None:
    identity = ("-c", "user.name=a", "-c", "user.email=a@b.c", "-c", "init.defaultBranch=main")
    subprocess.run(["git", *identity, *words], cwd=folder, capture_output=True, check=True)


def _commit(folder: Path) -> Path:
    _git(folder, "init", "--quiet")
    _git(folder, "add", ".")
    _git(folder, "commit", "--quiet", "--message", "all")
    return folder


@pytest.fixture
def image(tmp_path: Path) -> Path:
    """Return an image's folder: mine needs lib, whose repository was cloned from lab; lab has numeric too."""
    _manifest(tmp_path / "manifests/mine", "mine", "lib")
    _manifest(tmp_path / "lab/lib", "lib", "numeric", "roscpp")
    _manifest(tmp_path / "lab/lib/docs", "docs", "doxygen_tool")
    _commit(tmp_path / "lab/lib")
    _manifest(tmp_path / "lab/numeric", "numeric", "boosted")
    _commit(tmp_path / "lab/numeric")
    _manifest(tmp_path / "lab/doxygen_tool", "doxygen_tool")
    _commit(tmp_path / "lab/doxygen_tool")
    (tmp_path / "ws/src").mkdir(parents=True)
    _git(tmp_path / "ws/src", "clone", "--quiet", (tmp_path / "lab/lib").as_uri())
    binaries = tmp_path / "bin"
    binaries.mkdir()
    (binaries / "rosdep").write_text(f"#!{sys.executable}\n")
    for program in binaries.iterdir():
        program.chmod(0o755)
    return tmp_path


def _run(image: Path, *keys: str) -> tuple[int, list[str]]:
    """Return the exit code and the packages that the workspace then has."""
    script = image / "clone-unknown"
    text = (FOLDER / "clone-unknown.sh").read_text()
    script.write_text(text.replace("tried=/tmp/clone-unknown", f"tried={image}/tried"))
    ran = subprocess.run(
        ["bash", script, image / "manifests", image / "ws/src", *keys],
        env=os.environ | {"PATH": f"{image / 'bin'}:{os.environ['PATH']}"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert ran.returncode in {0, 1}, ran.stderr
    found = sorted({file.parent.name for file in (image / "ws/src").rglob("package.xml")})
    return ran.returncode, found


def test_the_owner_of_the_clone_that_asks_has_it(image: Path) -> None:
    assert _run(image, "numeric") == (0, ["docs", "lib", "numeric"])
    assert _run(image, "boosted") == (1, ["docs", "lib", "numeric"])


def test_a_part_is_in_the_repository_of_the_whole(image: Path) -> None:
    _manifest(image / "lab/space/space_msgs", "space_msgs")
    _commit(image / "lab/space")
    _manifest(image / "ws/src/lib", "lib", "space_msgs")
    assert _run(image, "space_msgs") == (0, ["docs", "lib", "space_msgs"])


def test_what_only_a_package_asks_for_that_is_not_needed_is_not_cloned(image: Path) -> None:
    assert _run(image, "doxygen_tool") == (1, ["docs", "lib"])


@pytest.mark.parametrize(
    ("file", "text"),
    [
        (".rosinstall", "- git: {{local-name: deps/numeric, uri: '{url}', version: v1}}\n- tar: {{local-name: a}}\n"),
        ("all.repos", "repositories:\n  deps/numeric:\n    type: git\n    url: {url}\n    version: v1\n"),
    ],
)
def test_a_list_of_the_clone_tells_where_it_is(image: Path, file: str, text: str) -> None:
    _manifest(image / "other/number_things", "numeric")
    _git(_commit(image / "other/number_things"), "tag", "v1")
    (image / "ws/src/lib" / file).write_text(text.format(url=(image / "other/number_things").as_uri()))
    assert _run(image, "numeric") == (0, ["docs", "lib", "number_things"])


def test_a_list_that_is_no_yaml_stops_nothing(image: Path) -> None:
    (image / "ws/src/lib/.rosinstall").write_text("- git: {local-name: [\n")
    assert _run(image, "numeric") == (0, ["docs", "lib", "numeric"])


def test_what_is_no_name_of_a_package_of_ros_is_not_tried(image: Path) -> None:
    _manifest(image / "lab/libboosted-dev", "libboosted-dev")
    _commit(image / "lab/libboosted-dev")
    _manifest(image / "ws/src/lib", "lib", "libboosted-dev")
    assert _run(image, "libboosted-dev") == (1, ["docs", "lib"])


def test_nothing_is_tried_twice(image: Path) -> None:
    assert _run(image, "numeric", "nowhere")[0] == 0
    assert _run(image, "numeric", "nowhere")[0] == 1


def test_a_name_may_have_a_dash(image: Path) -> None:
    _manifest(image / "lab/lab-util", "lab-util")
    _commit(image / "lab/lab-util")
    _manifest(image / "ws/src/lib", "lib", "lab-util")
    assert _run(image, "lab-util") == (0, ["docs", "lab-util", "lib"])
