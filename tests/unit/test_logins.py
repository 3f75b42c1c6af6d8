"""No file that is written for an image holds a password or a token that an author has left in an address."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.plan.plan import to_json
from roslab.render import render_all

SECRET = "s3cr3tpw"
TOKEN = "ghp_" + "a1B2" * 9
MANIFEST = (
    "<package format='2'><name>demo</name><version>0.1.0</version><description>d</description>"
    "<maintainer email='a@b.c'>a</maintainer><license>MIT</license>"
    "<buildtool_depend>catkin</buildtool_depend><depend>bar_x</depend></package>"
)
CMAKE = "cmake_minimum_required(VERSION 3.0)\nproject(demo)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"
ROS = {"demo/package.xml": MANIFEST, "demo/CMakeLists.txt": CMAKE, "README.md": "ROS Noetic\n"}
CONDA = "name: a\ndependencies:\n- python=3.10\n- pip:\n  - foo\n  - click\n"
RUN = {"run.py": "import click, foo\n"}
MODULES = '[submodule "demo/bar_x"]\n\tpath = demo/bar_x\n\turl = {}\n'
LIST = "- git:\n    local-name: bar_x\n    uri: {}\n"
FOO = "git+https://{}github.com/a/foo.git"
BAR = "https://{}github.com/foo/bar_x.git"
ELSEWHERE = "https://{}git.example.org/foo/bar_x.git"


def written(folder: Path, files: dict[str, str]) -> tuple[str, list[str]]:
    """Return all that is written for a tree, and its warnings."""
    for path, text in files.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text)
    plan = plan_repository(folder).plan
    rendered = render_all(plan, readme=files.get("README.md"), output_is_root=True, context=".")
    return "\n".join((to_json(plan), *(each.text for each in rendered))), [w.message for w in plan.warnings]


@pytest.mark.parametrize("login", [f"user:{SECRET}@", f"user:p@{SECRET}@", f"{TOKEN}@", f"x:{TOKEN}@"])
@pytest.mark.parametrize(
    ("files", "address"),
    [
        ({"environment.yml": CONDA, "README.md": "```\npip install {}\n```\n", **RUN}, FOO),
        ({"requirements.txt": "foo\nclick\n", "README.md": "```\npip install {}\n```\n", **RUN}, FOO),
        ({"README.md": "```\npip install {}\n```\n", **RUN}, FOO),
        (ROS | {"README.md": "ROS Noetic\n```\ngit clone {} src/bar_x\n```\n"}, BAR),
        (ROS | {"README.md": "ROS Noetic\n```\ngit clone {} src/bar_x\n```\n"}, ELSEWHERE),
        (ROS | {"setup.sh": "git clone {} src/bar\nwstool merge -t src src/bar/more.rosinstall\n"}, BAR[:-6] + ".git"),
        (ROS | {"demo.rosinstall": LIST}, BAR),
        (ROS | {"demo.rosinstall": LIST}, ELSEWHERE),
        (ROS | {".gitmodules": MODULES}, BAR),
        (ROS | {".gitmodules": MODULES}, ELSEWHERE),
    ],
)
def test_no_password_is_written(tmp_path: Path, files: dict[str, str], address: str, login: str) -> None:
    given = {path: text.replace("{}", address.format(login)) for path, text in files.items()}
    text, warnings = written(tmp_path, given)
    assert address.format("").removesuffix(".git") in text, "it is taken from there"
    assert SECRET not in text
    assert TOKEN not in text
    assert any("password or a token" in each or "not be there for everybody" in each for each in warnings)


@pytest.mark.parametrize(
    "address",
    [
        "git+https://github.com/a/foo.git@v1",
        "git+ssh://git@git.example.org/a/foo.git",
        "git+https://git.example.org:8443/a/foo.git@v1",
        "git+https://jane@git.example.org/a/foo.git",
    ],
)
def test_other_addresses_stay_as_they_are(tmp_path: Path, address: str) -> None:
    text, warnings = written(tmp_path, {"README.md": f"```\npip install {address}\n```\n", **RUN})
    assert address in text
    assert not any("password" in each for each in warnings)
