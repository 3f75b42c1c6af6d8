"""The script that clones what cloned repositories ask for in turn."""

from __future__ import annotations

import os
import shutil
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


def _git(folder: Path, *words: str, day: str = "2019-05-20") -> str:
    identity = ("-c", "user.name=a", "-c", "user.email=a@b.c", "-c", "init.defaultBranch=main")
    dates = {"GIT_AUTHOR_DATE": f"{day}T12:00:00Z", "GIT_COMMITTER_DATE": f"{day}T12:00:00Z"}
    ran = subprocess.run(
        ["git", *identity, *words], cwd=folder, env=os.environ | dates, capture_output=True, text=True, check=True
    )
    return ran.stdout.strip()


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


def _run(image: Path, *keys: str, day: str = "", manifests: str = "manifests", want: str = "") -> tuple[int, list[str]]:
    """Return the exit code and the packages that the workspace then has."""
    script = image / "clone-unknown"
    text = (FOLDER / "clone-unknown.sh").read_text()
    script.write_text(text.replace("tried=/tmp/clone-unknown", f"tried={image}/tried"))
    ran = subprocess.run(
        ["bash", script, "--before", day, "--want", want, image / manifests, image / "ws/src", *keys],
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


def test_a_new_clone_is_not_its_own_double_where_the_workspace_holds_all_manifests(image: Path) -> None:
    _manifest(image / "lab/numeric/lib", "lib")
    _manifest(image / "lab/numeric/tools", "tools")
    (image / "lab/numeric/package.xml").unlink()
    _manifest(image / "lab/numeric/numeric", "numeric")
    _git(image / "lab/numeric", "add", "--all")
    _git(image / "lab/numeric", "commit", "--quiet", "--message", "apart")
    _list(image, "numeric", image / "lab/numeric")
    assert _run(image, "numeric", manifests="ws/src") == (0, ["docs", "lib", "numeric", "tools"])
    hidden = {file.parent.relative_to(image).as_posix() for file in image.rglob("COLCON_IGNORE")}
    assert hidden == {"ws/src/numeric/lib", "ws/src/numeric/tools"}  # what nothing needs is hidden, too


def test_a_part_is_in_the_repository_of_the_whole(image: Path) -> None:
    _manifest(image / "lab/space/space_msgs", "space_msgs")
    _commit(image / "lab/space")
    _manifest(image / "ws/src/lib", "lib", "space_msgs")
    assert _run(image, "space_msgs") == (0, ["docs", "lib", "space_msgs"])


@pytest.mark.parametrize(("repository", "found"), [("deep_space", True), ("deep", False)])
def test_a_package_may_be_in_the_repository_whose_name_of_two_words_or_more_it_begins_with(
    image: Path, repository: str, found: bool
) -> None:
    _manifest(image / f"lab/{repository}/deep_space_probe_arm", "deep_space_probe_arm")
    _commit(image / f"lab/{repository}")
    _manifest(image / "ws/src/lib", "lib", "deep_space_probe_arm")
    assert _run(image, "deep_space_probe_arm")[0] == (0 if found else 1)


def test_what_only_a_package_asks_for_that_is_not_needed_is_not_cloned(image: Path) -> None:
    assert _run(image, "doxygen_tool") == (1, ["docs", "lib"])


@pytest.mark.parametrize(
    ("file", "text"),
    [
        (".rosinstall", "- git: {{local-name: deps/numeric, uri: '{url}', version: v1}}\n- tar: {{local-name: a}}\n"),
        ("repositories.repos", "repositories:\n  deps/numeric:\n    type: git\n    url: {url}\n    version: v1\n"),
    ],
)
def test_a_list_of_the_clone_tells_where_it_is(image: Path, file: str, text: str) -> None:
    _manifest(image / "other/number_things", "numeric")
    _git(_commit(image / "other/number_things"), "tag", "v1")
    (image / "ws/src/lib" / file).write_text(text.format(url=(image / "other/number_things").as_uri()))
    assert _run(image, "numeric") == (0, ["docs", "lib", "number_things"])


@pytest.mark.parametrize(
    ("more", "found"),
    [
        ("counting: {path: src, origin: ours, tag: v1}\n", True),
        ("counting: {path: src, origin: '{url}/counting.git'}\nother: [no, row]\n", True),
        ("counting: {path: src, origin: theirs}\n", False),
        ("counting: src\n", False),
    ],
)
@pytest.mark.parametrize("file", ["repositories.yaml", "repositories_lab.yaml"])
def test_so_does_a_list_of_treep(image: Path, file: str, more: str, found: bool) -> None:
    _manifest(image / "manifests/mine", "mine", "lib", "counting")
    _manifest(image / "other/counting.git", "counting")
    _git(_commit(image / "other/counting.git"), "tag", "v1")
    url = (image / "other").as_uri()
    lists = image / "ws/src/treep_lab"
    lists.mkdir()
    (lists / file).write_text(f"lib: {{path: src, origin: ours}}\n{more.replace('{url}', url)}")
    (lists / "configuration.yaml").write_text(f"origin_prefixes: {{ours: '{url}/'}}\n")
    assert _run(image, "counting") == ((0, ["counting", "docs", "lib"]) if found else (1, ["docs", "lib"]))


def test_what_a_clone_has_besides_is_hidden_where_the_workspace_has_it(image: Path) -> None:
    _manifest(image / "lab/space/space", "space", "lib", "mine", "numeric")
    for name in ("lib", "mine", "numeric"):
        _manifest(image / f"lab/space/parts/{name}", name)
    _commit(image / "lab/space")
    _manifest(image / "ws/src/lib", "lib", "space")
    _run(image, "space")
    marked = sorted(file.parent.name for file in (image / "ws/src").rglob("CATKIN_IGNORE"))
    assert marked == ["lib", "mine"]
    assert (image / "ws/src/space/parts/lib/COLCON_IGNORE").exists()


def _list(image: Path, name: str, repository: Path, version: str = "main") -> None:
    row = f"- git: {{local-name: {name}, uri: '{repository.as_uri()}', version: {version}}}\n"
    with (image / "ws/src/lib/all.rosinstall").open("a") as file:
        file.write(row)


def test_a_listed_repository_may_hold_what_it_is_not_called_like(image: Path) -> None:
    _manifest(image / "other/tools/cmake", "tools_cmake")
    _list(image, "tools", _commit(image / "other/tools"))
    _manifest(image / "other/plusplus/numbers", "counting")
    _manifest(image / "other/plusplus/more", "more")
    _list(image, "plusplus", _commit(image / "other/plusplus"))
    _manifest(image / "ws/src/lib", "lib", "counting")
    assert _run(image, "counting") == (0, ["docs", "lib", "more", "numbers"])
    assert (image / "ws/src/plusplus/more/CATKIN_IGNORE").exists()


def test_what_no_manifest_asks_for_is_looked_for_in_lists_and_what_it_needs_in_turn_with_its_owner(image: Path) -> None:
    _manifest(image / "other/desk/talk", "talk", "voice")
    _list(image, "desk", _commit(image / "other/desk"))
    _manifest(image / "other/voice", "voice")
    _commit(image / "other/voice")
    assert _run(image, "talk") == (1, ["docs", "lib"])
    (image / "tried").unlink()
    assert _run(image, "talk", want="talk lib nowhere") == (0, ["docs", "lib", "talk"])
    assert _run(image, "lib", "nowhere", "voice", want="talk lib nowhere") == (0, ["docs", "lib", "talk", "voice"])


def test_what_a_listed_repository_holds_is_looked_up_as_of_the_day(image: Path) -> None:
    _manifest(image / "other/desk/talk", "talk")
    _commit(image / "other/desk")
    _git(image / "other/desk", "rm", "--quiet", "-r", "talk")
    _manifest(image / "other/desk/write", "write")
    _git(image / "other/desk", "add", ".")
    _git(image / "other/desk", "commit", "--quiet", "--message", "gone", day="2023-01-01")
    _list(image, "desk", image / "other/desk")
    assert _run(image, "talk", want="talk", day="2022-01-01") == (0, ["docs", "lib", "talk"])
    assert {line.split()[0] for line in (image / "tried.held").read_text().splitlines()} == {"talk"}


def test_a_git_that_filters_nothing_clones_all_of_an_owner_of_clones(image: Path) -> None:
    """However many clones there are beside the one that names the owner."""
    old = image / "bin/git"
    old.write_text(f'#!/bin/bash\nif [[ "$*" = *--filter=* ]]; then exit 129; fi\nexec {shutil.which("git")} "$@"\n')
    old.chmod(0o755)
    for number in range(3):
        (image / f"ws/src/other{number}/.git").mkdir(parents=True)
        (image / f"ws/src/other{number}/.git/config").write_text("# more than a pipe holds\n" * 4000)
    _manifest(image / "lab/desk/talk", "talk")
    _commit(image / "lab/desk")
    _git(image / "lab/desk", "rm", "--quiet", "-r", "talk")
    _manifest(image / "lab/desk/write", "write")
    _git(image / "lab/desk", "add", ".")
    _git(image / "lab/desk", "commit", "--quiet", "--message", "gone", day="2023-01-01")
    _list(image, "desk", image / "lab/desk")
    _run(image, "talk", want="talk", day="2022-01-01")
    assert {line.split()[0] for line in (image / "tried.held").read_text().splitlines()} == {"talk"}


def test_of_a_list_of_a_tag_the_tag_is_looked_into(image: Path) -> None:
    _manifest(image / "other/desk/talk", "talk")
    _git(_commit(image / "other/desk"), "tag", "v1")
    _list(image, "desk", image / "other/desk", version="v1")
    assert _run(image, "talk", want="talk", day="2001-01-01") == (0, ["docs", "lib", "talk"])


def test_what_an_interrupted_look_has_left_and_a_manifest_without_a_name_stop_none(image: Path) -> None:
    (image / "tried.git").mkdir()
    (image / "tried.git/HEAD").touch()
    _manifest(image / "other/plusplus/numbers", "counting")
    _manifest(image / "other/plusplus/empty", "")
    _list(image, "plusplus/", _commit(image / "other/plusplus"))
    _manifest(image / "ws/src/lib", "lib", "counting")
    assert _run(image, "counting") == (0, ["docs", "empty", "lib", "numbers"])
    url = (image / "other/plusplus").as_uri()
    assert (image / "tried.held").read_text().splitlines() == [f"counting {url} main"]


def test_what_the_repository_itself_asks_for_is_looked_for_in_the_lists_of_its_clones_alone(image: Path) -> None:
    _manifest(image / "manifests/mine", "mine", "lib", "counting", "unlisted")
    _manifest(image / "other/plusplus/counting", "counting")
    _list(image, "plusplus", _commit(image / "other/plusplus"))
    _manifest(image / "lab/unlisted", "unlisted")
    _commit(image / "lab/unlisted")
    assert _run(image, "counting", "unlisted") == (0, ["counting", "docs", "lib"])


def test_what_a_repository_of_lists_alone_does_not_name_is_looked_for_with_its_owner(image: Path) -> None:
    _manifest(image / "manifests/mine", "mine", "lib", "unlisted")
    _manifest(image / "lab/unlisted", "unlisted")
    _commit(image / "lab/unlisted")
    (image / "lab/lists").mkdir()
    (image / "lab/lists/all.rosinstall").write_text("[]\n")
    _git(image / "ws/src", "clone", "--quiet", _commit(image / "lab/lists").as_uri())
    assert _run(image, "unlisted") == (0, ["docs", "lib", "unlisted"])


@pytest.mark.parametrize(("version", "newest"), [("main", False), ("v2", True)])
def test_a_branch_of_a_list_is_that_of_the_day_and_a_tag_stays(image: Path, version: str, newest: bool) -> None:
    _manifest(image / "other/numeric", "numeric")
    remote = _commit(image / "other/numeric")
    (remote / "new").write_text("new\n")
    _git(remote, "add", ".")
    _git(remote, "commit", "--quiet", "--message", "second", day="2021-05-20")
    _git(remote, "tag", "v2")
    _list(image, "numeric", remote, version)
    assert _run(image, "numeric", day="2020-01-01") == (0, ["docs", "lib", "numeric"])
    assert (image / "ws/src/numeric/new").exists() is newest


def test_a_repository_may_have_dashes_where_its_package_has_underscores(image: Path) -> None:
    _manifest(image / "lab/space-tools", "space_tools")
    _commit(image / "lab/space-tools")
    _manifest(image / "ws/src/lib", "lib", "space_tools")
    assert _run(image, "space_tools") == (0, ["docs", "lib", "space_tools"])


def test_a_list_that_is_no_yaml_stops_nothing(image: Path) -> None:
    (image / "ws/src/lib/.rosinstall").write_text("- git: {local-name: [\n")
    assert _run(image, "numeric") == (0, ["docs", "lib", "numeric"])


def test_what_is_no_name_of_a_package_of_ros_is_not_tried(image: Path) -> None:
    _manifest(image / "lab/libboosted-dev", "libboosted-dev")
    _commit(image / "lab/libboosted-dev")
    _manifest(image / "ws/src/lib", "lib", "libboosted-dev")
    assert _run(image, "libboosted-dev") == (1, ["docs", "lib"])


def test_what_ends_as_packages_of_ros_do_is_looked_for(image: Path) -> None:
    _manifest(image / "lab/libnumeric_ros", "libnumeric_ros")
    _commit(image / "lab/libnumeric_ros")
    _manifest(image / "ws/src/lib", "lib", "libnumeric_ros")
    assert _run(image, "libnumeric_ros") == (0, ["docs", "lib", "libnumeric_ros"])


@pytest.mark.parametrize(("header", "found"), [("libnumeric/a.hpp", True), ("libnumeric.h", False)])
def test_a_package_may_be_called_like_a_library_where_the_clone_includes_its_headers(
    image: Path, header: str, found: bool
) -> None:
    _manifest(image / "lab/libnumeric", "libnumeric")
    _commit(image / "lab/libnumeric")
    _manifest(image / "ws/src/lib", "lib", "libnumeric")
    (image / "ws/src/lib/a.cpp").write_text(f"#include <{header}>\n")
    assert _run(image, "libnumeric") == (0 if found else 1, ["docs", "lib", *(["libnumeric"] if found else [])])


def test_a_list_may_name_a_package_that_is_called_like_a_library(image: Path) -> None:
    _manifest(image / "manifests/mine", "mine", "lib", "libnumeric")
    _manifest(image / "other/libnumeric", "libnumeric")
    _list(image, "libnumeric", _commit(image / "other/libnumeric"))
    assert _run(image, "libnumeric") == (0, ["docs", "lib", "libnumeric"])


def test_nothing_is_tried_twice(image: Path) -> None:
    assert _run(image, "numeric", "nowhere")[0] == 0
    assert _run(image, "numeric", "nowhere")[0] == 1


def test_a_name_may_have_a_dash(image: Path) -> None:
    _manifest(image / "lab/lab-util", "lab-util")
    _commit(image / "lab/lab-util")
    _manifest(image / "ws/src/lib", "lib", "lab-util")
    assert _run(image, "lab-util") == (0, ["docs", "lab-util", "lib"])


def test_an_owner_who_writes_repositories_with_dashes_does_so_for_others(image: Path) -> None:
    _manifest(image / "lab/more-parts", "more_parts", "arm_core")
    _commit(image / "lab/more-parts")
    _manifest(image / "lab/arm-core", "arm_core")
    _commit(image / "lab/arm-core")
    _git(image / "ws/src", "clone", "--quiet", (image / "lab/more-parts").as_uri())
    assert _run(image, "arm_core", want="more_parts") == (0, ["arm-core", "docs", "lib", "more-parts"])
