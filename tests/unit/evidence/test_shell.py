"""Shell text as install lines: what is kept, what is dropped, on which line."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.gather import gather
from roslab.evidence.lex.braces import expanded
from roslab.evidence.lex.shell import commands, fill_placeholders, logical_lines
from roslab.evidence.prose.installs import Collector
from roslab.repository.checkout import Repository


def words(text: str) -> list[tuple[str, ...]]:
    return [command.words for line, logical in logical_lines(text) for command in commands(logical, line)]


def collected(text: str) -> Collector:
    collector = Collector("f", "script")
    collector.text(text)
    return collector


def apt(text: str) -> list[str]:
    return [d.name for d in collected(text).dependencies if d.namespace == "apt"]


def pip(text: str) -> list[str]:
    return [asked.written for asked in collected(text).requirements if asked.role != "channel"]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("sudo -H apt-get -y install a-lib b-lib", ["a-lib", "b-lib"]),
        ("apt-get update && DEBIAN_FRONTEND=noninteractive apt install -y liba-dev=1.2-3 || true", ["liba-dev"]),
        ("apt-get install -y \\\n  # why\n  libone \\\n  libtwo", ["libone", "libtwo"]),
        ("#RUN apt-get install nothing", []),
        ("apt install -y acme-py3-{core,viewer} libone", ["acme-py3-core", "acme-py3-viewer", "libone"]),
        ("apt install lib{a,b}-dev \\\n  libc-dev", ["liba-dev", "libb-dev", "libc-dev"]),
        ("apt install ros-{distro}-{tf,msgs}", []),  # two lists in a word
        ("apt-get install liba # libb", ["liba"]),
        ("{ apt-get install liba-{name}.1 libb; }", ["libb"]),
        ('apt-get install "$(cat packages)" liba `pick` $LIBS', ["liba"]),
        ("if [ -f x ]; then sudo apt install liba; fi", ["liba"]),
        ('bash -c "apt-get update; apt-get install -y liba"', ["liba"]),
        ("sudo apt-get install liba, sudo apt-get install libb", ["liba"]),
        ("apt-get install -t focal-backports liba libc++-dev g++", ["liba", "libc++-dev", "g++"]),
        ("apt-get install liba and then run it", ["liba"]),
        ("apt-get install liba sudo apt-get install libb", ["liba"]),
        ("apt-get install ros-humble-gazebo-* ./local.deb libA", ["ros-humble-gazebo-*"]),
        ("X=libfoo apt-get install $X", []),
        ("if a; then apt install -y liba libb . /opt/a.sh fi", ["liba", "libb"]),
    ],
)
def test_apt_lines(text: str, expected: list[str]) -> None:
    assert apt(text) == expected


@pytest.mark.parametrize(
    ("text", "last"),
    [
        ("mkdir -p ~/ws/src && cd $_", ("cd", "~/ws/src")),
        ('mkdir -p build; cd "$_"', ("cd", "build")),
        ("mkdir a && cd ${_} && ls $_", ("ls", "a")),
        ("mkdir a && X=b && cd $_", ("cd", "\0")),
        ("mkdir $FOLDER && cd $_", ("cd", "\0")),
        ("cd $_", ("cd", "\0")),
        ("mkdir a && cd $_b", ("cd", "\0")),
    ],
)
def test_the_last_word_of_the_command_before(text: str, last: tuple[str, ...]) -> None:
    assert words(text)[-1] == last


@pytest.mark.parametrize(
    "written",
    ["YOUR_DISTRO", "<distro>", "$ROS_DISTRO", "${ROS_DISTRO}", '"${ROS_DISTRO}"', "XXX", "xxx", "[distro]",
     "your-distro", "your_ros_distro",
     "$(rosversion -d)",
     "${{ matrix.ros_distro }}", "${{ needs.find-ros-distro.outputs.distro }}", "{distro}", "<your-ros-version>"],
)  # fmt: skip
def test_placeholders_of_a_distro(written: str) -> None:
    assert apt(f"sudo apt-get install ros-{written}-cv-bridge libx") == ["ros-{distro}-cv-bridge", "libx"]


@pytest.mark.parametrize("name", ["ros-noetic-cv-bridge", "ros-humble-ros-base", "ros-dev-tools"])
def test_real_names_stay(name: str) -> None:
    assert fill_placeholders(name) == name


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("pip install absl-py>=0.7.0 numpy<2", ["absl-py>=0.7.0", "numpy<2"]),
        ("python3.8 -m pip install --user -U 'torch==1.7' > log 2>&1", ["torch==1.7"]),
        ("pip3 install -r requirements.txt", ["requirements.txt"]),
        ("pip install -e .[dev]", [".[dev]"]),
        ("pip install git+https://github.com/a/b.git#egg=b", ["git+https://github.com/a/b.git#egg=b"]),
        (
            "pip install torch==1.10.0+cu113 -f https://w.org/x.html",
            ["torch==1.10.0+cu113", "--find-links https://w.org/x.html"],
        ),
        ("conda install pytorch==1.7.1 cudatoolkit=10.1 -c pytorch", ["torch==1.7.1"]),
        ("uv pip install -c pins.txt six", ["six"]),
        ("pip install six to get it", ["six"]),
        ("said=$(pip install six==1.16.0 --user)", ["six==1.16.0"]),
        ("said=`pip install six`", ["six"]),
        ('said="$(sudo pip3 install six)"', ["six"]),
        ("echo $(pip install six)", []),
        ("said=$(pip install six) env", []),
    ],
)
def test_pip_lines(text: str, expected: list[str]) -> None:
    assert pip(text) == expected


def test_roles_of_what_pip_is_given() -> None:
    found = collected("pip install -r r.txt ./pkg six -i https://i.org\npip2 install yaml")
    assert [asked.role for asked in found.requirements] == ["file", "project", "", "option", "python2"]
    assert {asked.origin for asked in found.requirements} == {"prose"}


def test_a_clone_takes_the_ref_that_is_checked_out() -> None:
    text = "git clone -b dev https://g.org/a/one.git\ngit clone git@g.org:a/two.git && cd two && git checkout tags/v2"
    sources = collected(text).sources
    assert [(s.name, s.ref, s.kind) for s in sources] == [("one", "dev", "clone"), ("two", "v2", "clone")]


def test_programs_and_build_tools_are_mentioned() -> None:
    text = "catkin build\nroslaunch pkg a.launch x:=1\nconda create -n e python=3.8 -y\npython train.py --go"
    found = {(m.topic, m.value) for m in collected(text).mentions}
    assert found == {
        ("build_tool", "catkin_tools"),
        ("command", "roslaunch pkg a.launch x:=1"),
        ("entered", "e"),
        ("python", "3.8"),
        ("command", "python train.py --go"),
    }


def test_words_know_their_lines() -> None:
    (command,) = commands("apt-get install \n a-lib \n b-lib", 7)
    assert command.lines == (7, 7, 8, 9)


@pytest.mark.parametrize(
    "text", ["'" * 5000, '"' * 5000, "$(" * 5000, "`" * 5001, "\\" * 5000, "(" * 5000, "install " * 2000]
)
def test_hostile_lines_end(text: str) -> None:
    words("apt-get install " + text)


@pytest.mark.parametrize(
    ("page", "name"),
    [
        ("export ROS1_DISTRO=melodic\nsudo apt install ros-$ROS1_DISTRO-tf\n", "ros-melodic-tf"),
        ("export ROS1_DISTRO=melodic # or kinetic\nsudo apt install ros-${ROS1_DISTRO}-tf\n", "ros-melodic-tf"),
        (
            "export ROS1_DISTRO=melodic\nexport ROS1_DISTRO=kinetic\nsudo apt install ros-$ROS1_DISTRO-tf\n",
            "ros-{distro}-tf",
        ),
        ("export ROS_DISTRO=melodic\nsudo apt install ros-$ROS_DISTRO-tf\n", "ros-{distro}-tf"),
        ("sudo apt install ros-$ROS1_DISTRO-tf\n", "ros-{distro}-tf"),
    ],
)
def test_a_page_sets_what_stands_for_a_distribution(tmp_path: Path, page: str, name: str) -> None:
    (tmp_path / "README.md").write_text(f"# A\n```\n{page}```\n")
    assert [d.name for d in gather(Repository.open(tmp_path)).prose] == [name]


@pytest.mark.parametrize("end", [" `", "`", ""])
def test_a_mark_of_the_page_behind_a_command_is_no_word(end: str) -> None:
    (command,) = commands(f"python train.py --config configs/a.json{end}")
    assert command.words == ("python", "train.py", "--config", "configs/a.json")


@pytest.mark.parametrize(
    "text",
    [
        "python run.py --env {ant,hopper} seed={1,2}",
        "mkdir 'a{b,c}' \"a {b,c}\"",
        "mkdir ${A,b}x{a,b}",
        "roslaunch demo {sim,real}.launch",
    ],
)
def test_what_no_shell_writes_out_or_a_page_leaves_to_the_reader_stays(text: str) -> None:
    assert expanded(text) == text
