"""Folders that are empty since a commit records a clone without its address."""

from __future__ import annotations

import subprocess
from pathlib import Path

from roslab.evidence import links
from roslab.evidence.gather import gather
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from roslab.repository.checkout import Repository

OTHER = "46e4d40a13a37e768e438600ee58c824dffa570d"
LISTED = "https://github.com/turtlebot/turtlebot_msgs"
MANIFEST = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"


def git(folder: Path, *words: str) -> None:
    who = ("-c", "user.name=a", "-c", "user.email=a@example.org")
    subprocess.run(["git", "-C", folder, *who, *words], check=True, capture_output=True)


def tree(folder: Path, page: str, *paths: str) -> Repository:
    (folder / "demo").mkdir()
    (folder / "demo/package.xml").write_text(MANIFEST)
    (folder / "README.md").write_text(page)
    git(folder, "init", "-q")
    git(folder, "add", ".")
    for path in paths:
        (folder / path).mkdir(parents=True)
        git(folder, "update-index", "--add", "--cacheinfo", f"160000,{OTHER},{path}")
    git(folder, "commit", "-qm", "a")
    return Repository.open(folder)


def test_a_folder_without_an_address_is_told(tmp_path: Path) -> None:
    evidence = gather(tree(tmp_path, "ROS Noetic\n", "src/own_driver", "src/mav_msgs", "src/sight"))
    (message,) = [message for message, _, _ in evidence.problems if message.startswith("empty in a clone")]
    assert "src/mav_msgs, src/own_driver, src/sight;" in message
    asked = {each.name for each in evidence.code if each.namespace == "ros"}
    assert "mav_msgs" in asked, "ROS has released a package of that name"
    assert not asked & {"own_driver", "sight"}


def test_one_that_a_page_clones_is_not(tmp_path: Path) -> None:
    page = "```\ngit clone https://github.com/ann/own_driver.git\n```\n"
    evidence = gather(tree(tmp_path, page, "src/own_driver"))
    assert not [message for message, _, _ in evidence.problems if message.startswith("empty in a clone")]


def test_a_folder_that_only_happens_to_be_empty_is_none(tmp_path: Path) -> None:
    repository = tree(tmp_path, "ROS Noetic\n")
    (tmp_path / "logs").mkdir()
    assert repository.listing.empty == ("logs",)
    assert not links.lost(repository, ())


def test_one_that_is_called_like_a_listed_repository_is_tried_at_its_commit(tmp_path: Path) -> None:
    evidence = gather(tree(tmp_path, "ROS Noetic\n", "src/turtlebot_msgs", "src/own_driver"))
    (git,) = [each for each in evidence.sources if each.kind == "submodule"]
    assert (git.name, git.url, git.ref) == ("src/turtlebot_msgs", f"{LISTED}.git", OTHER)
    own, tried = [message for message, _, _ in evidence.problems if message.startswith("empty in a clone")]
    assert "src/own_driver;" in own
    assert f"src/turtlebot_msgs ({LISTED}); the image takes the commit from" in tried


def test_the_name_of_its_address_tells_one_that_is_listed_under_another(tmp_path: Path) -> None:
    """ROS lists moveit2 as moveit, realsense-ros as realsense2_camera."""
    evidence = gather(tree(tmp_path, "ROS Noetic\n", "src/moveit2", "src/realsense-ros"))
    assert [each.url for each in evidence.sources if each.kind == "submodule"] == [
        "https://github.com/ros-planning/moveit2.git",
        "https://github.com/IntelRealSense/realsense-ros.git",
    ]


def test_nothing_stays_of_a_repository_without_the_commit(tmp_path: Path) -> None:
    tree(tmp_path, "ROS Noetic\n", "src/turtlebot_msgs")
    plan = plan_repository(tmp_path).plan
    (source,) = plan.workspace.submodules
    assert (source.repo, source.ref) == (f"{LISTED}.git", OTHER)
    text = dockerfile(plan)
    assert f"{source.name} cannot be cloned' && rm -rf /home/${{NB_USER}}/" in text


def test_one_in_an_example_or_in_a_tree_without_packages_is_not_tried(tmp_path: Path) -> None:
    repository = tree(tmp_path, "ROS Noetic\n", "examples/turtlebot_msgs")
    assert not [each for each in gather(repository).sources if each.kind == "submodule"]
    (tmp_path / "demo/package.xml").unlink()
    (tmp_path / "turtlebot_apps").mkdir()
    git(tmp_path, "update-index", "--add", "--cacheinfo", f"160000,{OTHER},turtlebot_apps")
    git(tmp_path, "commit", "-qam", "b")
    assert not [each for each in gather(Repository.open(tmp_path)).sources if each.kind == "submodule"]
