"""The 39 real files: each with the result it must have."""

import pathlib

import pytest

from roslab.config import read
from roslab.config.model import Config
from roslab.errors import ConfigurationError


@pytest.fixture(scope="module")
def folder(shared: pathlib.Path) -> pathlib.Path:
    return shared / "roslab-yaml"


REFUSED = {"ICRA-2018__Omni-CNN.v2", "ICRA-2018__superquadric-grasp.v2"}


def load(folder: pathlib.Path, name: str) -> Config:
    return read((folder / f"{name}.yaml").read_text(encoding="utf-8"))


def test_all_but_two_are_read_in_the_format_of_their_name(folder: pathlib.Path) -> None:
    names = {file.stem for file in folder.glob("*.yaml")} - REFUSED
    assert len(names) == 37
    for name in names:
        config = load(folder, name)
        assert config.generation == {"v1": "paper", "v2": "later"}[name.rpartition(".")[2]], name
        assert config.name, name


def test_omni_cnn_is_told_the_right_words(folder: pathlib.Path) -> None:
    with pytest.raises(ConfigurationError) as caught:
        load(folder, "ICRA-2018__Omni-CNN.v2")
    found = [(p.line, p.column, p.message, str(p.hint).split("?")[0]) for p in caught.value.problems]
    assert found == [
        (6, 1, 'unknown key "apt-packages"', "did you mean `apt`"),
        (9, 1, 'unknown key "pip-packages"', "did you mean `pip`"),
    ]


def test_superquadric_grasp_is_told_that_its_url_is_a_page(folder: pathlib.Path) -> None:
    with pytest.raises(ConfigurationError) as caught:
        load(folder, "ICRA-2018__superquadric-grasp.v2")
    (problem,) = caught.value.problems
    assert problem.line == 23
    assert "`repo: https://github.com/robotology/tactile-control.git`" in str(problem.hint)


def test_rosin_tutorials_asks_for_bionic(folder: pathlib.Path) -> None:
    config = load(folder, "RobInLabUJI__ROSIN-Tutorials.v2")
    assert (config.base.ubuntu, config.base.ros) == ("bionic", "melodic-ros-base")
    assert config.apt[-1] == "netpbm=2:10.0-15.3build1"
    assert any("melodic" in message for message, _ in config.warnings)


def test_vins_mono_in_both_formats(folder: pathlib.Path) -> None:
    old, new = load(folder, "ICRA-2018__VINS-Mono.v1"), load(folder, "ICRA-2018__VINS-Mono.v2")
    assert old.apt == new.apt
    assert old.source[0].depends == new.source[0].depends
    assert old.base.ros == new.base.ros == "kinetic-desktop-full"
    assert (old.gpu, old.gui, new.gpu, new.gui) == (True, True, True, True)
    assert old.volume[0].options == "ro"


def test_gcg_keeps_its_thirty_eight_requirements(folder: pathlib.Path) -> None:
    config = load(folder, "ICRA-2018__gcg.v2")
    assert len(config.pip3) == 38
    assert sum(line.startswith("git+") for line in config.pip3) == 4


def test_slambench_has_every_package_on_its_own(folder: pathlib.Path) -> None:
    config = load(folder, "ICRA-2018__slambench2.v2")
    assert config.apt[:3] == ("libvtk6.2", "libvtk6-dev", "unzip")
    assert all(" " not in name for name in config.apt)
    assert len(config.apt) == len(set(config.apt)) == 30


def test_adversarial_testing_upgrades(folder: pathlib.Path) -> None:
    config = load(folder, "ICRA-2018__adversarial_testing.v2")
    assert (config.pip3, config.pip3_options) == (("GPy", "GPyOpt", "matplotlib"), ("--upgrade",))


def test_densemapnet_keeps_its_empty_command(folder: pathlib.Path) -> None:
    config = load(folder, "ICRA-2018__densemapnet.v2")
    assert config.custom
    assert config.custom.commands == (":",)


def test_what_cannot_be_as_it_was_is_said(folder: pathlib.Path) -> None:
    for name, words in {
        "ICRA-2018__MOTBeyondPixels.v2": "MATLAB",
        "ICRA-2018__TrafficWeavingCVAE.v1": "ppa:chronitis/jupyter",
        "ICRA-2018__LearnedSamplingDistributions.v2": "CUDA 8",
        "ICRA-2018__Active-ORB-SLAM2.v2": "gpu: true",
        "SLAM-in-ROS__viso2.v1": "gui: true",
    }.items():
        assert any(words in message and place for message, place in load(folder, name).warnings), name
