"""Links in the places of an author's folders, by the shell of the image itself."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide.decision import Decision
from roslab.decide.python.image_python import Python
from roslab.plan.plan import make_plan
from roslab.render.layers.author_folders import author_folders

USER = 1234 if os.getuid() == 0 else os.getuid()
"""Who else than root the folders may be given to."""


def _made(*folders: str, target: str = "source") -> str:
    decision = Decision(
        kind="python",
        ros_distro=None,
        ubuntu="jammy",
        base_image="ubuntu:22.04",
        build_tool="pip",
        python=Python(version="3.10", manager="system"),
        author_folders=tuple((folder, target) for folder in folders),
    )
    return author_folders(make_plan(decision, Config(), folder_name="paper"))


def _run(block: str) -> None:
    command = re.sub(r"^#.*\n|^RUN ", "", block, flags=re.MULTILINE)
    environment = {**os.environ, "NB_USER": "jovyan", "NB_UID": str(USER)}
    subprocess.run(["bash", "-euc", command], env=environment, check=True)


def test_what_is_made_above_a_link_is_the_user_s_and_what_was_there_is_not_touched(tmp_path: Path) -> None:
    (tmp_path / "home").mkdir()
    _run(_made(f"{tmp_path}/home/dev/my data/paper"))
    link = tmp_path / "home" / "dev" / "my data" / "paper"
    assert link.readlink() == Path("/home/jovyan/paper")
    assert {link.parent.stat().st_uid, link.parent.parent.stat().st_uid} == {USER}
    assert (tmp_path / "home").stat().st_uid == os.getuid()


def test_what_the_image_has_stays(tmp_path: Path) -> None:
    (tmp_path / "paper").mkdir()
    _run(_made(f"{tmp_path}/paper"))
    assert not (tmp_path / "paper").is_symlink()


def test_what_is_made_above_a_link_of_the_home_is_the_user_s(tmp_path: Path) -> None:
    block = _made("~/robot_ws/src")
    _run(block.replace("/home/${NB_USER}", str(tmp_path)))
    assert (tmp_path / "robot_ws/src").readlink() == tmp_path / "paper"
    assert (tmp_path / "robot_ws").stat().st_uid == USER


@pytest.mark.parametrize(
    "path", ["~/paper", "~/paper/config", "~/ws", "~/ws/src", "~/ws/src/paper", "~/ws/install", "/home/jovyan/paper"]
)
def test_no_link_takes_the_place_of_the_image_s_own_folders(path: str) -> None:
    assert not _made(path) or path.startswith("/home/jovyan")


@pytest.mark.parametrize("path", ["/paper", "~/Paper"])
def test_nothing_is_made_at_the_root_or_in_the_home(path: str) -> None:
    assert "install --directory" not in _made(path)


def test_a_link_may_lead_to_a_path_of_the_image(tmp_path: Path) -> None:
    _run(_made(f"{tmp_path}/cuda-10.2", target=f"{tmp_path}/cuda"))
    assert (tmp_path / "cuda-10.2").readlink() == tmp_path / "cuda"
