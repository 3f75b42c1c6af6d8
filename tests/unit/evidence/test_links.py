"""Folders that are empty since a commit records a clone without its address."""

from __future__ import annotations

import subprocess
from pathlib import Path

from roslab.evidence import links
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

OTHER = "46e4d40a13a37e768e438600ee58c824dffa570d"
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
    evidence = gather(tree(tmp_path, "ROS Noetic\n", "src/own_driver", "src/mav_msgs", "src/perception"))
    (message,) = [message for message, _, _ in evidence.problems if message.startswith("empty in a clone")]
    assert "src/mav_msgs, src/own_driver, src/perception;" in message
    asked = {each.name for each in evidence.code if each.namespace == "ros"}
    assert "mav_msgs" in asked, "ROS has released a package of that name"
    assert not asked & {"own_driver", "perception"}


def test_one_that_a_page_clones_is_not(tmp_path: Path) -> None:
    page = "```\ngit clone https://github.com/ann/own_driver.git\n```\n"
    evidence = gather(tree(tmp_path, page, "src/own_driver"))
    assert not [message for message, _, _ in evidence.problems if message.startswith("empty in a clone")]


def test_a_folder_that_only_happens_to_be_empty_is_none(tmp_path: Path) -> None:
    repository = tree(tmp_path, "ROS Noetic\n")
    (tmp_path / "logs").mkdir()
    assert repository.listing.empty == ("logs",)
    assert links.lost(repository, ()) == ()
