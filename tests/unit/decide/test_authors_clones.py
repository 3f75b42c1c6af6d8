"""What comes from source where the author's Dockerfile is built, and at which commit."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render import bases as rendered
from trees import commit, tree_of

Tree = Callable[[dict[str, str]], Decision]
CLONE = "git clone {} https://github.com/others/shapes.git"
FILES = {
    "package.xml": "<package><name>demo</name><depend>shapes</depend><depend>lines</depend></package>",
    "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\nadd_executable(demo_node a.cpp)\n",
    "README.md": "## Install\n\n```\ngit clone https://github.com/others/lines.git\n```\n",
}
IMAGE = "FROM ros:noetic\nRUN cd /ws/src && {}\nCOPY . /ws/src/demo\nRUN cd /ws && catkin_make\n"


def committed(folder: Path, step: str, day: str, before: str = "") -> Decision:
    tree_of(folder, FILES | {"Dockerfile": IMAGE.replace("RUN", f"{before}RUN", 1).format(step)})
    commit(folder, day)
    return plan_repository(folder).decision


def test_what_its_steps_clone_comes_from_source_and_nothing_else(tree: Tree) -> None:
    assert [each.name for each in tree(FILES).source] == ["lines"]
    decision = tree(FILES | {"Dockerfile": IMAGE.format(CLONE.format("-b 1.2.0"))})
    assert decision.dockerfile
    assert [(each.name, each.ref, each.before) for each in decision.source] == [("shapes", "1.2.0", "")]


def test_a_dockerfile_that_roslab_yaml_names_and_nothing_reads_clones_nothing_that_is_known(tmp_path: Path) -> None:
    named = {"Other": IMAGE.format(CLONE.format("")), "roslab.yaml": "dockerfile: Other\n"}
    tree_of(tmp_path, FILES | named)
    decision = plan_repository(tmp_path).decision
    assert (decision.dockerfile, decision.source) == ("Other", ())


@pytest.mark.parametrize(
    ("options", "day", "said"),
    [
        ("--depth 1", "2021-03-04", "without a tag or a commit"),
        ("-b 4.x", "2021-03-04", "at its branch 4.x"),
        ("-b noetic-devel", "2021-03-04", "at its branch noetic-devel"),
        ("-b v1.2.0", "2021-03-04", ""),
        ("--depth 1", "2026-11-20", ""),  # that is nearly the day of the build
    ],
)
def test_old_code_has_each_clone_of_a_head_as_it_was_then(tmp_path: Path, options: str, day: str, said: str) -> None:
    decision = committed(tmp_path, CLONE.format(options), day)
    (base,) = decision.bases
    line = f"line 2 clones https://github.com/others/shapes.git {said}: it takes that of {day}"
    assert (line in base.why, base.git_day) == ((True, day) if said else (False, None))
    assert base.why.startswith("ROS noetic ended")
    assert [each.before for each in decision.source] == [day if said else ""]
    assert not [each for each in decision.warnings if "is cloned" in each.message]


@pytest.mark.parametrize(
    ("options", "day", "said"),
    [
        ("--depth 1", "2021-03-04", "without a tag or a commit"),
        ("-b 4.x", "2021-03-04", "at its branch 4.x"),
        ("-b v1.2.0", "2021-03-04", ""),
        ("--depth 1", "2026-11-20", ""),
    ],
)
def test_it_is_told_of_each_where_the_dockerfile_has_a_shell_of_its_own(
    tmp_path: Path, options: str, day: str, said: str
) -> None:
    decision = committed(tmp_path, CLONE.format(options), day, 'SHELL ["/bin/bash", "-c"]\n')
    told = [each for each in decision.warnings if "is cloned" in each.message]
    assert [(each.file, each.line) for each in told] == ([("Dockerfile", 3)] if said else [])
    assert all(said in each.message and day in each.message for each in told)
    assert all(not each.before for each in decision.source)


def test_git_is_given_the_day_to_the_steps_and_stays_where_cmake_found_it(tmp_path: Path) -> None:
    tree_of(tmp_path, FILES | {"Dockerfile": IMAGE.format(CLONE.format(""))})
    commit(tmp_path, "2023-03-04")
    plan = plan_repository(tmp_path).plan
    assert plan.author_dockerfile
    (base,) = plan.author_dockerfile.bases
    assert (base.pip_day, base.git_day) == (None, "2023-03-04")
    text = rendered.bases((base,), "demo")
    shared, steps = text.split("FROM ros:noetic AS base-1")
    assert steps.split("\n")[-6:] == [
        "# What this clones without a commit is of 2023-03-04",
        "COPY --from=scripts /git-as-of /usr/local/bin/",
        "COPY --from=scripts /shell-as-of /usr/local/bin/",
        "COPY --from=scripts /git-as-of /usr/local/lib/git-as-of/git",
        'SHELL ["/usr/local/bin/shell-as-of", "2023-03-04"]',
        "",
    ]
    assert "/git-as-of\n" in shared
    assert "/index-as-of\n" not in shared
