"""Each format of roslab.yaml, told by its own marks and read into the one model."""

import pathlib

import pytest

from roslab.config import Custom, Matlab, Volume, read
from roslab.config.model import Config, Generation
from roslab.errors import ConfigurationError


@pytest.fixture(scope="module")
def good(checkout: pathlib.Path) -> pathlib.Path:
    return checkout / "tests" / "data" / "config" / "good"


def load(good: pathlib.Path, name: str) -> Config:
    return read((good / f"{name}.yaml").read_text(encoding="utf-8"))


def warned(config: Config) -> str:
    return "\n".join(message for message, _ in config.warnings)


@pytest.mark.parametrize(
    ("name", "generation"),
    [
        ("paper", "paper"),
        ("paper-plain", "paper"),
        ("later", "later"),
        ("later-melodic", "later"),
        ("later-additions", "later"),
        ("unmarked", "later"),
        ("interim", "interim"),
        ("today", "today"),
        ("today-least", "today"),
        ("today-aliases", "today"),
        ("today-pip2", "today"),
    ],
)
def test_formats_are_told_by_their_marks(good: pathlib.Path, name: str, generation: Generation) -> None:
    config = load(good, name)
    assert config.generation == generation
    assert config.file == "roslab.yaml"
    if generation != "today":
        assert config.notebook is (name != "later-additions")


def test_the_papers_format(good: pathlib.Path) -> None:
    config = load(good, "paper")
    assert config.base.ros == "kinetic-desktop-full"  # what roslab/roslab:kinetic-nvidia held
    assert config.base.opengl == "devel"
    assert (config.gui, config.gpu) == (True, True)
    assert config.build == "catkin_tools"
    assert config.repositories == ("ppa:chronitis/jupyter",)
    assert config.apt == ("libeigen3-dev", "libboost-all-dev", "qtbase5-dev")
    assert (config.pip, config.pip_python) == (("tensorflow==1.3",), "2")
    assert config.source[0].repo == "https://github.com/jbehley/glow.git"
    assert (config.source[0].ref, config.source[0].build, config.source[0].depends) == ("v0.1", "catkin_tools", ())
    assert config.volume == (Volume(host_path="/home/user/EuRoC MAV", container_path="/DATASET", options="ro"),)
    assert config.custom == Custom(commands=("cd lib", "make"), as_root=False, chained=False, workdir="home")
    for words in ("gpu: true", "ppa:chronitis/jupyter", "ref: v0.1"):
        assert words in warned(config)


def test_the_papers_format_without_a_gpu(good: pathlib.Path) -> None:
    config = load(good, "paper-plain")
    assert (config.base.ros, config.base.opengl, config.gui, config.gpu) == ("kinetic", None, None, None)
    assert config.warnings == ()


def test_the_later_format(good: pathlib.Path) -> None:
    config = load(good, "later")
    base = config.base
    assert (base.ubuntu, base.ros, base.opengl) == ("xenial", "kinetic-desktop-full", "runtime")
    assert (base.cuda, base.cuda_flavour, base.cudnn) == ("8.0", "devel", "6")
    assert (base.icub, base.cmake_update) == (True, "3.18.4")
    assert config.matlab == Matlab(host_path="/usr/local/MATLAB/R2017a", mac_address="2c:60:0c:d6:50:36")
    assert config.apt == ("collada-dom2.4-dp*", "libassimp-dev", "xvfb=2:1.19.6-1ubuntu4")
    assert config.pip3[:2] == ("GPy", "matplotlib")
    assert config.pip3_options == ("--upgrade",)
    assert config.pip3[2].startswith("git+https://")
    assert config.pip3[3].endswith(".whl")
    assert (config.pip, config.pip_python) == (("numpy==1.11.3", "scipy"), "2")
    argos, opencv = config.source
    assert argos.ref == "d406b52894949512b29fb2ecc59276fd05895571"
    assert (argos.cmake_folder, argos.keep_source, argos.depends) == ("../src", True, ("libfreeimage-dev",))
    assert argos.cmake_options == '-DYARP_DIR=/usr/lib/cmake/YARP "-DFLAGS=-O2 -g"'
    assert argos.make_command == "make -j2 && make doc && make install"
    assert (opencv.repo, opencv.zip) == (None, "https://github.com/opencv/opencv/archive/3.3.0.zip")
    assert (config.build, config.cmake_options) == ("cmake", "-DBUILD_TESTS=OFF")
    assert config.custom == Custom(
        commands=("cd $HOME/superquadric-grasp && make", ":"), as_root=True, chained=True, workdir="root"
    )
    assert config.volume == (Volume(host_path="/media/usuario/DATA", container_path="/DATA", options="rw"),)
    for words in ("MATLAB", "CUDA 8", "icub.org", "volume above", "gpu: true"):
        assert words in warned(config)


def test_melodic_is_an_old_word_for_bionic(good: pathlib.Path) -> None:
    config = load(good, "later-melodic")
    assert config.base.ubuntu == "bionic"
    assert "`ubuntu: melodic`" in warned(config)


def test_todays_keys_may_complete_an_old_file(good: pathlib.Path) -> None:
    config = load(good, "later-additions")
    assert config.command == "ros2 launch demo demo.launch.py"
    assert config.env == (("TURTLEBOT3_MODEL", "burger"), ("LEVEL", "3"))
    assert (config.gui, config.gpu, config.base.cuda) == (False, True, "10.2")
    assert "without `format: 3`" in warned(config)


def test_without_a_mark_the_later_meaning_holds(good: pathlib.Path) -> None:
    config = load(good, "unmarked")
    assert config.custom == Custom(commands=("make -C lib install",), as_root=True, chained=True, workdir="root")
    assert config.kind == "ros2"


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("custom: [make -C lib install]\n", True),
        ("apt: [cmake]\n", True),
        ("base: {ubuntu: bionic}\ncustom: [make -C lib install]\n", False),
        ("format: 3\ncustom: [make -C lib install]\n", False),
        ("distro: kinetic\npackages: [cmake]\n", False),
    ],
)
def test_a_file_that_says_neither_its_format_nor_its_base_is_told(text: str, told: bool) -> None:
    assert ("without `format: 3` as its first line" in warned(read(text))) is told


def test_the_interim_format(good: pathlib.Path) -> None:
    config = load(good, "interim")
    base = config.base
    assert (base.ubuntu, base.cuda, base.cuda_flavour, base.cudnn) == ("bionic", "10.0", "devel", "7")
    assert (config.apt, config.pip, config.pip3) == (("cmake", "qt5-default"), ("numpy",), ("torch",))
    assert (config.source[0].name, config.source[0].build, config.build) == ("ompl", "cmake", "cmake")


def test_todays_format(good: pathlib.Path) -> None:
    config = load(good, "today")
    assert (config.base.cuda, config.base.cuda_flavour, config.base.python) == ("11.8", None, "3.10")
    assert config.requirements == ("requirements.txt", "python/requirements dev.txt")
    assert config.vcs == ()
    assert (config.pip, config.pip_python) == (
        ("numpy >= 1.20, < 2", 'enum34; python_version < "3.4"', "torch==2.0.1+cu118"),
        "image",
    )
    assert config.pip_options == ("--extra-index-url", "https://download.pytorch.org/whl/cu118")
    assert config.build_args == ("--symlink-install", "--parallel-workers", "2")
    assert config.custom == Custom(commands=("make -C lib",), as_root=False, chained=False, workdir="home")
    assert config.env == (("TURTLEBOT3_MODEL", "burger"), ("EMPTY", ""))
    assert config.command == ("ros2", "launch", "demo", "demo.launch.py", "3")
    assert config.test == "ros2 pkg list | grep demo"
    assert config.ports == ("8888", "127.0.0.1:8888:8888", "22:22", "5000:5000/udp")
    assert config.platforms == ("linux/amd64", "linux/arm64")
    assert config.notebook is False
    assert config.warnings == ()


def test_a_file_of_today_says_only_what_it_says(good: pathlib.Path) -> None:
    config = load(good, "today-least")
    assert config == Config(file="roslab.yaml", origins=config.origins)


def test_custom_of_today_runs_in_the_source_folder(good: pathlib.Path) -> None:
    config = load(good, "today-pip2")
    assert config.custom == Custom(commands=("make",), as_root=True, chained=True, workdir="source")
    assert (config.pip, config.pip_python, config.pip3) == (("numpy==1.16.6",), "2", ())


def test_places_follow_the_model(good: pathlib.Path) -> None:
    config = load(good, "paper")
    places = {path: place.line for path, place in config.origins}
    assert places["base.ros"] == 3
    assert (places["apt.0"], places["apt.1"], places["apt.2"]) == (9, 10, 10)
    assert places["source.0.repo"] == 15
    assert config.origin("custom.1") is not None
    assert config.origin("nothing") is None


def test_mixed_formats_name_the_lines_of_each() -> None:
    with pytest.raises(ConfigurationError) as caught:
        read(
            "name: a\nbase:\n  ros: kinetic-ros-desktop-full\napt: [git]\n"
            "distro: kinetic\nruntime: nvidia\npackages: [git]\n"
        )
    told = str(caught.value)
    assert "the later old format: `base` (line 2), `apt` (line 4)" in told
    assert "the 2019 paper's format: `distro` (line 5), `runtime` (line 6), `packages` (line 7)" in told
    assert "did you mean `kinetic-desktop-full`?" in told
    assert len(caught.value.problems) == 2


def test_the_interim_words_in_a_later_file_are_named() -> None:
    with pytest.raises(ConfigurationError) as caught:
        read("base:\n  ubuntu: 18.04\n\napt-packages:\n  - git\npip-packages:\n  - tensorflow==1.4\n")
    found = [(p.line, p.hint and p.hint.split("?")[0]) for p in caught.value.problems]
    assert found == [(4, "did you mean `apt`"), (6, "did you mean `pip`")]


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        ("format: 3\npackages: [git]", "did you mean `apt`?"),
        ("format: 3\nrepos: [main]", "did you mean `repo`?"),
        ("format: 3\nruntime: nvidia", "did you mean `gpu`?"),
        ("format: 3\nubuntu: 20.04", "did you mean `base.ubuntu`?"),
        ("distro: kinetic\napt: [git]", "did you mean `packages`?"),
        ("base: {system: ubuntu}\npip3: [a]", "did you mean `pip3-packages`?"),
        ("format: 3\nskip-keys: [a]", "did you mean `skip_keys`?"),
        ("format: 3\nbase: {distro: noetic}", "did you mean `ros`?"),
        ("format: 3\nzzz: 1", "allowed: format, name"),
    ],
)
def test_an_unknown_key_is_answered_with_the_word_that_was_meant(text: str, hint: str) -> None:
    with pytest.raises(ConfigurationError) as caught:
        read(text)
    assert hint in str(caught.value)


@pytest.mark.parametrize(
    "text", ["roslab_version: 1", "backend: python\nlibraries: []", "nodes: []\nros_launch: []\nname: x"]
)
def test_a_file_of_the_other_roslab_is_refused_by_name(text: str) -> None:
    with pytest.raises(ConfigurationError, match="ROS code generator also called roslab"):
        read(text)
