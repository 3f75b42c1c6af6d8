"""The Dockerfile's layers: their order, what each format's commands mean, and that no value becomes an instruction."""

from __future__ import annotations

import dataclasses
import re
from typing import Any

import pytest

from roslab.config.model import Base, Config, Custom, Source
from roslab.decide.decision import Decision, Python
from roslab.errors import ConfigurationError
from roslab.plan.plan import Plan, from_json, image_name, make_plan, to_json
from roslab.render.dockerfile import dockerfile


def decision(**changes: Any) -> Decision:
    ros1 = Decision(
        kind="ros1",
        ros_distro="noetic",
        ubuntu="focal",
        base_image="ros:noetic-ros-base",
        build_tool="catkin_make",
        rosdep=("roscpp",),
        python=Python(version="3.8", manager="system"),
        packages=("talker/package.xml",),
        package_names=("talker",),
        workspace="overlay",
    )
    return dataclasses.replace(ros1, **changes)


def plan(config: Config | None = None, **changes: Any) -> Plan:
    return make_plan(decision(**changes), config or Config(), folder_name="Paper")


def positions(text: str, *parts: str) -> list[int]:
    missing = [part for part in parts if part not in text]
    assert not missing, f"{missing} not in\n{text}"
    return [text.index(part) for part in parts]


CERES = Source(name="ceres", repo="https://example.org/ceres.git", ref="1.14.0", depends=("libgoogle-glog-dev",))
SISTER = Source(name="sister", repo="https://example.org/sister.git", ref="v1", build="catkin_make")


def test_layers_go_from_rarely_to_often_changing() -> None:
    python = Python(version="3.8", manager="system", pip=("numpy==1.17",))
    text = dockerfile(plan(apt=("libeigen3-dev",), apt_guessed=("libglew-dev",), source=(CERES, SISTER), python=python))
    order = positions(
        text,
        "FROM ros:noetic-ros-base AS base",
        "useradd",
        "FROM base AS library-1-ceres",
        "FROM base AS manifests",
        "FROM base AS image",
        "libeigen3-dev",
        "libglew-dev",
        "COPY --from=library-1-ceres",
        "sister.git",
        "rosdep install --default-yes",
        "numpy==1.17",
        "COPY --chown=${NB_UID}:${NB_UID} . /home/${NB_USER}/ws/src/paper",
        "catkin_make -j",
        "ENTRYPOINT",
        "CMD",
    )
    assert order == sorted(order)
    assert "# syntax" not in text


def test_a_new_system_package_rebuilds_no_library() -> None:
    before, after = (dockerfile(plan(apt=apt, source=(CERES,))) for apt in ((), ("libopencv-dev",)))
    stage = re.compile(r"FROM base AS library-1-ceres\n.*?\n\n\n", re.DOTALL)
    assert stage.findall(before) == stage.findall(after) != []
    assert before.partition("FROM base AS library")[0] == after.partition("FROM base AS library")[0]


def test_declared_packages_stop_the_build_and_guessed_ones_are_named() -> None:
    text = dockerfile(plan(apt=("libeigen3-dev",), apt_guessed=("libglew-dev",)))
    declared, guessed = text.split("# Read in code or prose")
    assert "libeigen3-dev" in declared
    assert "libglew-dev" not in declared
    assert "left-out.txt" in guessed


@pytest.mark.parametrize(
    ("tool", "command", "setup"),
    [
        ("catkin_make", "catkin_make -j", "ws/devel/setup.bash"),
        ("catkin_tools", "catkin build --no-status", "ws/devel/setup.bash"),
        ("colcon", "colcon build", "ws/install/setup.bash"),
    ],
)
def test_each_build_tool(tool: str, command: str, setup: str) -> None:
    text = dockerfile(plan(build_tool=tool))
    assert command in text
    assert setup in text
    assert "-DCMAKE_BUILD_TYPE=Release" in text


def test_the_image_runs_as_the_user_with_the_source_at_hand() -> None:
    lines = dockerfile(plan(command=("roslaunch", "talker", "a b.launch"))).splitlines()
    assert lines[-4:] == [
        "USER ${NB_USER}",
        "WORKDIR /home/${NB_USER}/ws/src/paper",
        'ENTRYPOINT ["roslab-entrypoint"]',
        'CMD ["roslaunch", "talker", "a b.launch"]',
    ]


def test_a_command_given_as_text_runs_in_bash() -> None:
    assert dockerfile(plan(command="cd x && ./run")).endswith('CMD ["bash", "-c", "cd x && ./run"]\n')


def test_the_papers_custom_runs_one_by_one_as_the_user_at_home() -> None:
    custom = Custom(commands=("make a", "make b"), as_root=False, chained=False, workdir="home")
    text = dockerfile(plan(Config(file="roslab.yaml", generation="paper", compatible="paper", name="x", custom=custom)))
    assert "USER ${NB_USER}\nWORKDIR /home/${NB_USER}\nRUN make a\nRUN make b" in text


def test_the_later_custom_is_one_chain_as_root() -> None:
    custom = Custom(commands=("cd $HOME/x", "make"), as_root=True, chained=True, workdir="root")
    text = dockerfile(
        plan(Config(file="roslab.yaml", generation="later", compatible="later", notebook=True, name="x", custom=custom))
    )
    assert re.search(r"USER root\nWORKDIR /\nRUN cd \$HOME/x \\\n && make\n", text)


def test_old_formats_build_libraries_in_place_after_pythons_packages() -> None:
    python = Python(version="3.5", manager="system", pip=("scipy",))
    config = Config(
        file="roslab.yaml",
        generation="later",
        compatible="later",
        notebook=True,
        name="x",
        base=Base(cmake_update="3.18.4"),
    )
    text = dockerfile(plan(config, source=(CERES,), python=python))
    order = positions(text, "/opt/jupyter", "cmake-3.18.4.tar.gz", "scipy", "example.org/ceres.git", "rosdep install")
    assert order == sorted(order)
    assert "AS library-" not in text
    assert "CMAKE_BUILD_TYPE" not in text


def test_an_archive_is_unpacked_whatever_its_top_folder_is_called() -> None:
    source = Source(name="opencv", zip="https://example.org/opencv/archive/3.3.0.zip", cmake_options="-DA='b c'")
    text = dockerfile(plan(source=(source,)))
    assert "mv /tmp/archive/* /tmp/sources/opencv" in text
    assert "'-DA=b c'" in text


HOSTILE = 'x\'; rm -rf ~; $(touch /pwned) `id` "${HOME}" #'


@pytest.mark.parametrize(
    "changes",
    [
        {"apt": (HOSTILE,)},
        {"apt_guessed": (HOSTILE,)},
        {"skip_keys": (HOSTILE,)},
        {"packages": (HOSTILE,)},
        {"source": (Source(name="x", repo=HOSTILE, ref=HOSTILE),)},
        {"python": Python(version="3.8", manager="venv", pip=(HOSTILE,), requirements=(HOSTILE,), projects=(HOSTILE,))},
    ],
    ids=lambda changes: next(iter(changes)),
)
def test_no_value_leaves_its_quotes(changes: dict[str, Any]) -> None:
    text = dockerfile(plan(**changes))
    quoted = HOSTILE.replace("'", "'\"'\"'")
    assert quoted in text
    assert HOSTILE not in text


@pytest.mark.parametrize(
    "changes",
    [
        {"apt": ("a\nRUN evil",)},
        {"base_image": "ubuntu:24.04\nRUN evil"},
        {"command": ("a\0",)},
        {"packages": ("a\nb/package.xml",)},
    ],
    ids=lambda changes: next(iter(changes)),
)
def test_a_newline_in_a_value_is_an_error(changes: dict[str, Any]) -> None:
    with pytest.raises(ConfigurationError):
        dockerfile(plan(**changes))


def test_a_plan_survives_its_json() -> None:
    custom = Custom(commands=("make",), as_root=True, chained=True, workdir="source")
    config = Config(file="roslab.yaml", name="x", custom=custom, env=(("A", "b c"),), test="true")
    whole = plan(config, source=(CERES,), platforms_refused=(("linux/arm64", "no wheel"),))
    assert from_json(to_json(whole)) == whole
    assert to_json(whole) == to_json(from_json(to_json(whole)))


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"version": 2}', '{"version": 1}', "[" * 100_000])
def test_what_is_no_plan_is_refused(text: str) -> None:
    with pytest.raises(ConfigurationError):
        from_json(text)


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("SqueezeSegV2", "squeezesegv2"),
        ("a b/ç", "a-b"),
        ("-x-", "x"),
        ("--", "image"),
        ("a._b", "a_b"),
        ("a__b", "a_b"),
    ],
)
def test_every_text_gives_an_image_name(text: str, name: str) -> None:
    assert image_name(text) == name


def test_a_sister_is_prepared_after_its_clone_and_gives_the_workspace_its_options() -> None:
    sister = dataclasses.replace(SISTER, prepare="cp a.xml package.xml", cmake_options="-DEDITION='R 1'")
    text = dockerfile(plan(source=(sister,)))
    clone, prepare, build = positions(text, "git clone", "cp a.xml package.xml", "catkin_make -j")
    assert clone < prepare < build
    assert "'-DEDITION=R 1'" in text[build:].splitlines()[0]
