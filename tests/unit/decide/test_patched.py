"""Patches of the tree that its author applies to what is cloned."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Patch, Source
from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from roslab.values.dataclass import replace

Tree = Callable[[dict[str, str]], Decision]
CHANGE = "--- a/{0}\n+++ b/{0}\n@@ -1 +1 @@\n-a\n+b\n"
FILES = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend>"
    "<depend>maps</depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
    "deps.rosinstall": "- git: {local-name: maps, uri: 'https://github.com/lab/maps.git', version: '1.2'}\n"
    "- git: {local-name: solver, uri: 'https://github.com/lab/solver.git', version: '3.0'}\n",
    "patches/maps.patch": CHANGE.format("maps_core/src/a.cpp"),
}
START = "FROM ros:noetic\nRUN git clone https://github.com/lab/maps.git /ws/src/maps\nCOPY . /ws/src/demo\n"
CLONE = "git clone https://github.com/lab/maps.git\n"


def patches(decision: Decision) -> dict[str, list[tuple[str, str, str, bool]]]:
    return {
        source.name: [(each.path, " ".join(each.command), each.below, each.stops) for each in source.patches]
        for source in decision.source
        if source.patches
    }


@pytest.mark.parametrize(
    ("steps", "expected"),
    [
        ("WORKDIR /ws/src/maps\nRUN git apply ../demo/patches/maps.patch\n", ("git apply", "", True)),
        (
            "WORKDIR /ws/src/maps/core\nRUN git apply -p2 ../../demo/patches/maps.patch\n",
            ("git apply -p2", "core", True),
        ),
        ("RUN cd /ws/src/maps && git apply ../demo/patches/maps.patch || true\n", ("git apply", "", False)),
        ("RUN cd /ws/src/maps && patch -p1 < ../demo/patches/maps.patch\n", ("patch -p1", "", True)),
        ("RUN cd /ws/src && patch --strip=0 -d maps -i /ws/src/demo/patches/maps.patch\n", ("patch -p0", "", True)),
        ("RUN git -C /ws/src/maps apply --ignore-whitespace /p/*.patch\n", ("git apply --ignore-whitespace", "", True)),
        ("WORKDIR /ws/src\nRUN git apply demo/patches/maps.patch\n", ("git apply", "", True)),
    ],
)
def test_what_a_dockerfile_applies(tree: Tree, steps: str, expected: tuple[str, str, bool]) -> None:
    decision = tree(FILES | {"docker/Dockerfile": START + steps})
    assert patches(decision) == {"maps": [("patches/maps.patch", *expected)]}
    why = [each for each in decision.reasons if "patches/maps.patch" in each.reason]
    assert [(each.answer, each.file) for each in why] == [("maps", "docker/Dockerfile")]


@pytest.mark.parametrize(
    "steps",
    [
        "RUN cd /ws/src/maps && git apply --check ../demo/patches/maps.patch\n",
        "RUN cd /ws/src/maps && git apply -R ../demo/patches/maps.patch\n",
        "RUN cd /ws/src/maps && git apply own.patch\n",
        "RUN cd /ws/src/maps && patch a.cpp < ../demo/patches/maps.patch\n",
        "RUN cd /ws/src/maps && git apply --directory=sub ../demo/patches/maps.patch\n",
    ],
)
def test_what_changes_nothing_or_is_not_of_the_tree(tree: Tree, steps: str) -> None:
    assert patches(tree(FILES | {"docker/Dockerfile": START + steps})) == {}


def test_a_page_goes_on_and_no_longer_tells_the_step(tree: Tree) -> None:
    page = f"# Demo\nROS Noetic\n## Installation\n```\ncd ~/catkin_ws/src\n{CLONE}cd maps\ngit apply {{}}\n```\n"
    own = tree(FILES | {"README.md": page.format("../demo/patches/maps.patch")})
    assert patches(own) == {"maps": [("patches/maps.patch", "git apply", "", False)]}
    other = tree(FILES | {"README.md": page.format("../other/a.patch")})
    assert patches(other) == {}
    told = [["git apply" in each.message for each in decision.warnings] for decision in (own, other)]
    assert not any(told[0])
    assert any(told[1])


def test_a_patch_of_the_repository_itself_changes_no_clone(tree: Tree) -> None:
    files = FILES | {"maps_core/src/a.cpp": "a\n"}
    steps = "WORKDIR /ws/src\nRUN git apply demo/patches/maps.patch\n"
    assert patches(tree(files | {"docker/Dockerfile": START + steps})) == {}


def test_it_is_applied_before_the_manifests_are_read(tmp_path: Path) -> None:
    steps = "WORKDIR /ws/src/maps\nRUN git apply ../demo/patches/maps.patch\n"
    for path, text in (FILES | {"docker/Dockerfile": START + steps}).items():
        (tmp_path / path).parent.mkdir(exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    plan = plan_repository(tmp_path).plan
    text = dockerfile(plan)
    applied = (
        "USER ${NB_USER}\nCOPY --from=scripts /apply-patch /usr/local/bin/\n"
        "RUN --mount=type=bind,source=patches/maps.patch,target=/tmp/patches/patches/maps.patch \\\n"
        "    apply-patch --stops /home/${NB_USER}/ws/src/maps /tmp/patches/patches/maps.patch git apply\n"
    )
    assert applied in text
    before, _, after = text.partition(applied)
    assert "lab/maps.git" in before
    assert "&& install-rosdep-keys " in after
    library = Source(
        name="solver",
        repo="https://github.com/lab/solver.git",
        patches=(Patch(path="a.patch", command=("patch", "-p1"), below="sub"),),
    )
    text = dockerfile(replace(plan, libraries=(library,)))
    assert "RUN --mount=type=bind,source=a.patch,target=/tmp/patches/a.patch \\\n    mkdir" in text
    assert "apply-patch /tmp/sources/solver/sub /tmp/patches/a.patch patch -p1" in text
