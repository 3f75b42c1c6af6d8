"""The Dockerfile puts links in the places of the author's folders, but where the image has those."""

from __future__ import annotations

from pathlib import Path

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"


def written(folder: Path, at: str, path: str) -> str:
    package = folder / at
    (package / "config").mkdir(parents=True)
    (package / "package.xml").write_text(PACKAGE, encoding="utf-8")
    (package / "CMakeLists.txt").write_text("project(demo)\nfind_package(catkin REQUIRED)\n", encoding="utf-8")
    (package / "config/a.yaml").write_text(f"a: {path}\n", encoding="utf-8")
    (folder / "README.md").write_text("ROS Noetic\n", encoding="utf-8")
    return dockerfile(plan_repository(folder).plan)


def test_a_link_leads_to_the_source_before_that_is_copied(tmp_path: Path) -> None:
    folder = tmp_path / "robot"
    text = written(folder, "demo", "/home/me/catkin_ws/src/demo/config/a.yaml")
    link = "ln --symbolic /home/${NB_USER}/ws/src/robot /home/me/catkin_ws/src; fi"
    asked = "if [ ! -e /home/me/catkin_ws/src ]; then mkdir --parents /home/me/catkin_ws && "
    assert text.index(f"{asked}{link}") < text.index("COPY --chown=${NB_UID}:${NB_UID} . .")


def test_a_whole_workspace_is_linked_with_what_its_build_writes(tmp_path: Path) -> None:
    text = written(tmp_path, "src/demo", "/home/me/catkin_ws/src/demo/config/a.yaml")
    assert "ln --symbolic /home/${NB_USER}/ws /home/me/catkin_ws; fi" in text


def test_what_the_build_writes_is_linked_by_itself(tmp_path: Path) -> None:
    text = written(tmp_path, "demo", "/home/me/catkin_ws/devel/lib/demo/a")
    assert "ln --symbolic /home/${NB_USER}/ws/devel /home/me/catkin_ws/devel; fi" in text


def test_without_such_a_path_there_is_no_link(tmp_path: Path) -> None:
    assert "the author's machine" not in written(tmp_path, "demo", "/home/me/data/b.yaml")
