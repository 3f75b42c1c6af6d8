"""Inputs and options lie over roslab.yaml, keep their names, and are refused in roslab.yaml's own words."""

from __future__ import annotations

import pytest

from roslab.config import Override, configure
from roslab.config.vocabulary import nearest
from roslab.errors import ConfigurationError
from roslab.values.origin import Input, Option, Place

FILE = """\
format: 3
base: {ros: foxy, ubuntu: focal}
command: roslaunch old.launch
platforms: [linux/amd64, linux/arm64]
apt: [git]
"""


def said(**values: str) -> tuple[Override, ...]:
    return tuple(Override(key=key, text=text, origin=Input(name=key)) for key, text in values.items())


@pytest.mark.parametrize("text", ["linux/amd64,linux/arm64", "linux/amd64 linux/arm64", "linux/amd64,\n linux/arm64\n"])
def test_a_list_is_parted_by_commas_blanks_and_line_breaks(text: str) -> None:
    assert configure(None, said(platforms=text)).platforms == ("linux/amd64", "linux/arm64")


def test_what_is_said_beside_the_file_wins_and_the_rest_stays() -> None:
    distro = Override(key="base.ros", text="galactic", origin=Input(name="distro"))
    config = configure(FILE, (distro, *said(platforms="linux/amd64")), file="roslab.yaml")
    assert (config.base.ros, config.base.ubuntu) == ("galactic", "focal")
    assert (config.platforms, config.command, config.apt) == (("linux/amd64",), "roslaunch old.launch", ("git",))
    assert config.origin("base.ros") == Input(name="distro")
    assert config.origin("platforms") == config.origin("platforms.0") == Input(name="platforms")
    assert config.origin("platforms.1") is None
    assert config.origin("base.ubuntu") == Place(file="roslab.yaml", line=2, column=19)
    assert config.origin("command") == Place(file="roslab.yaml", line=3, column=1)
    assert config.file == "roslab.yaml"


def test_a_distribution_without_packages_for_the_ubuntu_of_the_file_is_told() -> None:
    """One of the two is wrong, and nobody but the author knows which."""
    distro = Override(key="base.ros", text="humble-desktop", origin=Input(name="distro"))
    with pytest.raises(ConfigurationError) as caught:
        configure(FILE, (distro,), file="roslab.yaml")
    (problem,) = caught.value.problems
    assert str(problem) == (
        "input distro: ROS humble has no packages for Ubuntu focal, which roslab.yaml:2:19 names "
        "(leave `ubuntu` out of the file: it follows from the distribution)"
    )
    image = "format: 3\nbase: {image: 'example.org/robot:1', ubuntu: focal}\n"
    assert configure(image, (distro,)).base.ros == "humble-desktop"  # the image decides what it holds


@pytest.mark.parametrize("text", [None, FILE, "distro: kinetic\n", "base: {ubuntu: xenial, ros: kinetic}\n"])
def test_a_file_without_overrides_is_read_as_it_is(text: str | None) -> None:
    over = configure(text, said(test="true"), file="roslab.yaml" if text else None)
    alone = configure(text, file="roslab.yaml" if text else None)
    assert over.test == "true"
    for name in ("base", "compatible", "generation", "notebook", "gpu", "warnings", "platforms", "build"):
        assert getattr(over, name) == getattr(alone, name)


def test_every_problem_of_file_and_overrides_at_once() -> None:
    option = Override(key="platforms", text="linux/amd64 linux/arm65", origin=Option(name="--platform"))
    distro = Override(key="base.ros", text="jazzi", origin=Input(name="distro"))
    with pytest.raises(ConfigurationError) as caught:
        configure("format: 3\nbase: {ros: noetik}\ngpu: perhaps\n", (option, distro), file="roslab.yaml")
    problems = caught.value.problems
    assert [str(problem.origin) for problem in problems] == [
        "roslab.yaml:2:13", "roslab.yaml:3:6", "--platform", "input distro",
    ]  # fmt: skip
    assert str(problems[2]).startswith(
        '--platform: "linux/arm65" is no platform (did you mean `linux/arm64`? allowed: linux/amd64, linux/arm64, '
    )
    assert problems[3].message == '"jazzi" is no ROS distribution'
    assert problems[3].hint is not None
    assert problems[3].hint.startswith("did you mean `jazzy`?")
    # The file's problem is told in the same words, with the name of the key
    assert problems[0].message == 'base.ros: "noetik" is no ROS distribution'


@pytest.mark.parametrize(
    ("word", "meant"), [("linux/mips", None), ("Linux/AMD64", "linux/amd64"), ("arm64", "linux/arm64")]
)
def test_what_all_platforms_begin_with_makes_none_similar(word: str, meant: str | None) -> None:
    assert nearest(word, ["linux/amd64", "linux/arm64", "linux/ppc64le", "linux/riscv64"]) == meant


@pytest.mark.parametrize("text", ["a\nb", "a\x00b", "\udcff", "x" * 70_000])
@pytest.mark.parametrize("key", ["command", "test", "name", "platforms", "base.ros", "base.cuda", "base.python"])
def test_no_text_that_roslab_yaml_could_not_hold(key: str, text: str) -> None:
    if key == "platforms" and text == "a\nb":
        text = "linux/a\nb"
    with pytest.raises(ConfigurationError) as caught:
        configure(None, (Override(key=key, text=text, origin=Option(name="--x")),))
    for problem in caught.value.problems:
        assert str(problem).startswith("--x: ")
        assert str(problem).isprintable()
        assert len(problem.message) < 200


def test_a_warning_keeps_its_origin() -> None:
    assert configure(None, said(name="MyRobot")).warnings == (
        ("image names are in lower case: `MyRobot` becomes `myrobot`", Input(name="name")),
    )
