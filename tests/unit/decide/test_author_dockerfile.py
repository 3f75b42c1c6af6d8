"""Which of the author's Dockerfiles can be believed."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from roslab.config.model import Base, Config, Kind
from roslab.config.reader import read
from roslab.config.written import written
from roslab.decide import decide
from roslab.decide.author_dockerfile import Dockerfile, decide_dockerfile, doubt
from roslab.evidence.facts import AuthorDockerfile, Evidence, Mention
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

GOOD = AuthorDockerfile(
    file="docker/Dockerfile", line=1, base="ros:noetic-ros-base", base_line=1, copies_repository=True, clones=(),
    dependencies=(), requirements=(), command=(), purpose="project", context="",
)  # fmt: skip


def test_a_good_one_is_believed() -> None:
    choice = decide_dockerfile(Evidence(dockerfiles=(GOOD,)), Config(), "ros1", "noetic")
    assert choice.answer == Dockerfile(file="docker/Dockerfile", context="")


@pytest.mark.parametrize("other", ["Dockerfile.submission", "examples/learning/Dockerfile"])
def test_one_for_another_purpose_yields(other: str) -> None:
    plain = replace(GOOD, file="utils/docker/Dockerfile", base="ubuntu:20.04")
    aside = replace(GOOD, file=other, base="nvidia/cuda:11.8.0-runtime-ubuntu22.04")
    choice = decide_dockerfile(Evidence(dockerfiles=(aside, plain)), Config(), "cuda", None)
    assert choice.answer == Dockerfile(file="utils/docker/Dockerfile", context="")


@pytest.mark.parametrize(
    ("page", "file"),
    [
        ("", "Dockerfile"),
        ("docker build -t demo -f docker/full.dockerfile .", "docker/full.dockerfile"),
        ("cd docker\ndocker build -t demo --file=full.dockerfile ..", "docker/full.dockerfile"),
        ("docker build -t demo .", "Dockerfile"),
    ],
)
def test_of_several_the_one_that_a_page_builds(tmp_path: Path, page: str, file: str) -> None:
    (tmp_path / "docker").mkdir()
    for path in ("Dockerfile", "docker/full.dockerfile"):
        (tmp_path / path).write_text("FROM python:3.12\nCOPY . /app\nWORKDIR /app\nCMD python3 main.py\n")
    (tmp_path / "main.py").write_text("import numpy\n\nif __name__ == '__main__':\n    print(numpy.pi)\n")
    (tmp_path / "README.md").write_text(f"# Demo\n```\n{page}\n```\n")
    assert decide(gather(Repository.open(tmp_path)), Config(), folder_name="demo").dockerfile == file


@pytest.mark.parametrize(
    ("lines", "believed"),
    [
        ("RUN cd $HOME/src/demo && cmake . && make\nRUN cd $HOME && sudo rm -rf $HOME/src/demo\n", False),
        ("RUN cd $HOME/src/demo && cmake . && make && rm -r -f $HOME/src/demo/\n", False),
        ("RUN cd $HOME/src/demo && cmake . && make install\nRUN rm -rf $HOME/src/demo\n", True),
        ("RUN cd $HOME/src/demo && cmake . && make\nRUN rm -rf $HOME/src/demo/build\n", True),
        ("RUN cd $HOME/src/demo && cmake . && make\nRUN rm -rf $HOME/src/demo2\n", True),
    ],
)
def test_one_that_removes_what_it_compiled_only_tries_that(tmp_path: Path, lines: str, believed: bool) -> None:
    (tmp_path / "Dockerfile").write_text(f"FROM ubuntu:20.04\nCOPY . $HOME/src/demo\n{lines}")
    (tmp_path / "CMakeLists.txt").write_text("project(demo)\nadd_executable(demo main.cpp)\n")
    (tmp_path / "main.cpp").write_text("int main() {}\n")
    found = decide(gather(Repository.open(tmp_path)), Config(), folder_name="demo")
    assert (found.dockerfile == "Dockerfile") is believed


@pytest.mark.parametrize(
    ("change", "why"),
    [
        ({"purpose": "documentation"}, "documentation"),
        ({"purpose": "vendored"}, "copy of other"),
        ({"purpose": "broken", "problem": "line 3"}, "does not parse"),
        ({"copies_repository": False}, "does not copy"),
        ({"clones_itself": True}, "clones"),
        ({"problem": "line 4 needs a private key or token"}, "private"),
        ({"context": "sub"}, "builds sub"),
        ({"base": "ros:${D}"}, "not known"),
        ({"base": "ros:melodic-ros-base"}, "it is for melodic"),
        ({"base": "nvidia/cuda:10.0-cudnn7-devel-ubuntu16.04"}, "deleted"),
        ({"base": "nvidia/cuda:11.3.0-devel-ubuntu20.04"}, "deleted"),
        ({"base": "nvidia/cudagl:11.3.1-devel-ubuntu20.04"}, "no longer built"),
    ],
)
def test_doubts(change: dict[str, object], why: str) -> None:
    authored = replace(GOOD, **change)  # type: ignore[arg-type]
    assert why in (doubt(authored, "ros1", "noetic", mended=False) or "")
    choice = decide_dockerfile(Evidence(dockerfiles=(authored,)), Config(repair=False), "ros1", "noetic")
    assert choice.answer is None
    assert why in choice.reasons[0].reason


def test_the_distro_in_the_path_comes_first() -> None:
    dockerfiles = (replace(GOOD, file="docker/Dockerfile.melodic"), replace(GOOD, file="docker/Dockerfile.noetic"))
    choice = decide_dockerfile(Evidence(dockerfiles=dockerfiles), Config(), "ros1", "noetic")
    assert choice.answer == Dockerfile(file="docker/Dockerfile.noetic", context="")


def test_a_link_of_a_chain_is_doubted() -> None:
    chain = (
        replace(GOOD, file="images/base/Dockerfile"),
        replace(GOOD, file="images/top/Dockerfile", base="me/img:base"),
    )
    choice = decide_dockerfile(Evidence(dockerfiles=chain), Config(), "ros1", "noetic")
    assert choice.answer == Dockerfile(file="images/base/Dockerfile", context="")


def test_the_configuration_wins() -> None:
    choice = decide_dockerfile(
        Evidence(dockerfiles=(GOOD,)), Config(dockerfile="x/Dockerfile", context="x"), "ros1", "noetic"
    )
    assert choice.answer == Dockerfile(file="x/Dockerfile", context="x")


def test_the_configuration_has_one_generated_beside_the_authors() -> None:
    config = read("format: 3\ndockerfile: false\n", file="roslab.yaml")
    choice = decide_dockerfile(Evidence(dockerfiles=(GOOD,)), config, "ros1", "noetic")
    assert choice.answer is None
    assert [(each.answer, each.reason) for each in choice.reasons] == [("false", "dockerfile says so")]
    assert "dockerfile: false\n" in written(config), "as roslab migrate writes it"


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("dockerfile: false\nargs: {A: b}\ntarget: run\n", {("`args` is for", 3), ("`target` is for", 4)}),
        ("context: docker\n", {("`context` is for", 2)}),
        ("dockerfile: false\n", set()),
    ],
)
def test_what_is_for_an_authors_dockerfile_is_told_where_one_is_generated(
    tmp_path: Path, text: str, told: set[tuple[str, int]]
) -> None:
    config = read(f"format: 3\n{text}", file="roslab.yaml")
    (tmp_path / "main.py").write_text("print(1)\n")
    warnings = decide(gather(Repository.open(tmp_path)), config, folder_name="demo").warnings
    assert {
        (each.message[: each.message.index("for") + 3], each.line)
        for each in warnings
        if "has no effect" in each.message
    } == told


def test_a_dockerfile_in_a_copy_of_another_project_is_not_the_authors(tmp_path: Path) -> None:
    package = "<package><name>{}</name><buildtool_depend>catkin</buildtool_depend></package>"
    files = {
        "src/own/package.xml": package.format("own"),
        "src/other/slam/package.xml": package.format("slam"),
        "src/other/docker/Dockerfile": "FROM ros:kinetic\nCOPY ./ /ws/src/other/\nRUN catkin build\n",
        "src/other/README.md": "Another project.\n",
    }

    def purpose(more: dict[str, str]) -> str:
        for path, text in (files | more).items():
            target = tmp_path / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text, encoding="utf-8")
        return gather(Repository.open(tmp_path)).dockerfiles[0].purpose

    assert purpose({}) == "project"
    assert purpose({"src/other/LICENCE": "GPL\n"}) == "vendored"
    (tmp_path / "src/own/package.xml").unlink()
    del files["src/own/package.xml"]
    built = "ROS Noetic\n```\ncatkin_make\n```\n"
    assert purpose({"README.md": built}) == "project"
    assert purpose({"LICENSE": "MIT\n"}) == "vendored"
    found = decide(gather(Repository.open(tmp_path)), Config(), folder_name="demo")
    assert (found.ros_distro, found.build_tool) == ("noetic", "catkin_make")


@pytest.mark.parametrize(("licence", "purpose"), [("detector/LICENSE", "vendored"), ("detector/NOTES", "project")])
def test_a_dockerfile_deep_in_a_copy_of_another_project(tmp_path: Path, licence: str, purpose: str) -> None:
    deep = "FROM python:3.12\nCOPY . /app\n"
    files = {"LICENSE": "MIT\n", "README.md": "# Own\n", "detector/README.md": "# Other\n", licence: "GPL\n"}
    for path, text in {**files, "detector/tools/app/Dockerfile": deep, "main.py": "print(1)\n"}.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    assert gather(Repository.open(tmp_path)).dockerfiles[0].purpose == purpose


@pytest.mark.parametrize(
    ("text", "lacks"),
    [
        ("ARG owner\nRUN adduser $owner\n", "line 3 needs a value for owner"),
        ("ARG OWNER\nRUN apt-get update\nUSER ${OWNER}\n", "line 4 needs a value for OWNER"),
        ("ARG OWNER=ros\nRUN adduser $OWNER\n", ""),
        ("ARG OWNER\nENV OWNER=ros\nRUN adduser $OWNER\n", ""),
        ("ARG OWNER\nRUN adduser ${OWNER:-ros}\n", ""),
        ("ARG STAMP\nRUN echo $STAMP\n", ""),
        ("ARG TARGETARCH\nRUN chown $TARGETARCH /tmp\n", ""),
    ],
)
def test_a_value_that_only_the_author_gives(tmp_path: Path, text: str, lacks: str) -> None:
    (tmp_path / "Dockerfile").write_text(
        f"FROM ros:noetic-ros-base\n{text}COPY . /ws/src/\nRUN catkin_make\n", encoding="utf-8"
    )
    (tmp_path / "package.xml").write_text("<package><name>a</name></package>", encoding="utf-8")
    authored = gather(Repository.open(tmp_path)).dockerfiles[0]
    assert (authored.problem or "").startswith(lacks)
    assert bool(authored.problem) == bool(lacks)


@pytest.mark.parametrize(
    ("copies", "lines", "refused"),
    [
        ("COPY arm /ws/src/arm", "RUN cd /ws && catkin_make", True),
        ("COPY arm /ws/src/arm\nCOPY arm_helpers /ws/src/arm_helpers", "RUN cd /ws && catkin_make", False),
        ("COPY . /ws/src/demo", "RUN cd /ws && catkin_make", False),
        ("COPY arm* /ws/src/", "RUN cd /ws && catkin_make", False),
        ("COPY legs /ws/src/legs", "RUN cd /ws && catkin_make", False),
        ("COPY arm /ws/src/arm", "RUN git clone https://github.com/lab/arm_helpers && catkin_make", False),
        ("COPY arm /ws/src/arm", "RUN apt-get install -y ros-noetic-arm-helpers && catkin_make", False),
        ("COPY arm /ws/src/arm", 'CMD ["/ws/src/arm/start"]', False),
    ],
)
def test_what_a_copied_package_requires_is_copied_too(
    tmp_path: Path, copies: str, lines: str, *, refused: bool
) -> None:
    files = {"Dockerfile": f"FROM ros:noetic-ros-base\n{copies}\n{lines}\n"}
    for name in ("arm", "arm_helpers", "legs"):
        needs = "<build_depend>arm_helpers</build_depend>" if name == "arm" else ""
        files[f"{name}/package.xml"] = f"<package><name>{name}</name>{needs}</package>"
        listed = "COMPONENTS roscpp arm_helpers" if name == "arm" else ""
        files[f"{name}/CMakeLists.txt"] = f"project({name})\nfind_package(catkin REQUIRED {listed})\n"
    for path, text in files.items():
        (tmp_path / path).parent.mkdir(exist_ok=True)
        (tmp_path / path).write_text(text)
    choice = decide_dockerfile(gather(Repository.open(tmp_path)), Config(), "ros1", "noetic")
    why = "it copies arm and not arm_helpers, which arm/CMakeLists.txt:2 requires"
    assert [why in each.reason for each in choice.reasons] == [refused]
    assert not (refused and choice.answer)


@pytest.mark.parametrize(
    ("code", "ci", "file"),
    [
        ("Eigen::Vector<float, 3> v;", "", "docker/24.dockerfile"),
        ("Eigen::Vector<float, 3> v;", "ubuntu-20.04, ubuntu-22.04", "docker/22.dockerfile"),
        ("Eigen::Vector3f v;", "ubuntu-20.04", "docker/20.dockerfile"),
    ],
)
def test_of_several_ubuntus_one_that_ci_runs_and_the_code_compiles_on(
    tmp_path: Path, code: str, ci: str, file: str
) -> None:
    (tmp_path / "docker").mkdir()
    for number, codename in (("20", "focal"), ("22", "jammy"), ("24", "noble")):
        (tmp_path / f"docker/{number}.dockerfile").write_text(
            f"FROM ubuntu:{codename}\nCOPY . demo\nRUN make -C demo\n"
        )
    (tmp_path / "CMakeLists.txt").write_text("project(demo)\nadd_executable(demo main.cpp)\n")
    (tmp_path / "main.cpp").write_text(f"int main() {{ {code} }}\n")
    (tmp_path / ".github/workflows").mkdir(parents=True)
    workflow = (
        f"jobs:\n  build:\n    strategy:\n      matrix:\n        os: [{ci}]\n    steps:\n      - run: cmake -B build\n"
    )
    (tmp_path / ".github/workflows/build.yml").write_text(workflow)
    assert decide(gather(Repository.open(tmp_path)), Config(), folder_name="demo").dockerfile == file


@pytest.mark.parametrize(("releases", "found"), [(("kinetic", "noetic"), False), (("kinetic",), True)])
def test_what_the_one_for_another_distribution_installs_counts_only_without_one_for_this(
    tmp_path: Path, releases: tuple[str, ...], found: bool
) -> None:
    for release in releases:
        packages = f"lib{release}-tool lib{release}-dev lld-6.0"
        text = f"FROM osrf/ros:{release}-desktop\nRUN apt-get update && apt-get install -y {packages}\n"
        (tmp_path / f"Dockerfile_{release}").write_text(text)
    (tmp_path / "package.xml").write_text(
        "<package><name>own</name><buildtool_depend>catkin</buildtool_depend></package>"
    )
    (tmp_path / "README.md").write_text("For ROS Noetic: `sudo apt install ros-noetic-desktop`.\n")
    decision = decide(gather(Repository.open(tmp_path)), Config(base=Base(ros="noetic")), folder_name="own")
    assert ("libkinetic-tool" in decision.apt_guessed) is found
    assert ("libnoetic-tool" in decision.apt_guessed) is ("noetic" in releases)
    assert "libkinetic-dev" in decision.apt_guessed  # headers of a library do no harm


@pytest.mark.parametrize("kind", ["ros2", "python"])
def test_the_ubuntu_of_ci_chooses_none_for_ros_or_python(kind: Kind) -> None:
    base = "ros:humble" if kind == "ros2" else "python:3.12-bookworm"
    dockerfiles = (
        replace(GOOD, file="Dockerfile", base=base),
        replace(GOOD, file="tools/a.Dockerfile", base="debian:12"),
    )
    ci = Mention(
        topic="ubuntu", value="24.04", source="ci", file=".github/workflows/a.yml", line=1, text="ubuntu-24.04"
    )
    choice = decide_dockerfile(Evidence(dockerfiles=dockerfiles, mentions=(ci,)), Config(), kind, "humble")
    assert choice.answer == Dockerfile(file="Dockerfile", context="")


@pytest.mark.parametrize(
    ("lines", "why"),
    [
        ("COPY bringup /ws/src/bringup", "it does not copy driver, and what would be started in it needs"),
        ("COPY bringup /ws/src/bringup\nCOPY driver /ws/src/driver", ""),
        ("COPY bringup /ws/src/bringup\nCMD /ws/src/bringup/simulate", ""),
        ("COPY bringup/package.xml /ws/src/bringup/\nCOPY tools /tools", "it copies bringup/package.xml and nothing"),
        ("COPY bringup/package.xml bringup/CMakeLists.txt /ws/src/bringup/\nCOPY driver /ws/src/driver", ""),
        ("COPY . /ws/src/demo", ""),
    ],
)
def test_the_image_has_what_is_started_in_it(tmp_path: Path, lines: str, why: str) -> None:
    files = {
        "Dockerfile": f"FROM ros:humble-ros-base\n{lines}\nRUN cd /ws && colcon build\n",
        "tools/check.py": "print(1)\n",
        "bringup/launch/robot.launch.py": "from launch_ros.actions import Node\n\n\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([Node(package='driver', executable='drive')])\n",
    }
    for name in ("bringup", "driver"):
        files[f"{name}/package.xml"] = (
            f"<package><name>{name}</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
        )
        files[f"{name}/CMakeLists.txt"] = f"project({name})\nfind_package(ament_cmake REQUIRED)\n"
    files["README.md"] = "# Demo\n```\nros2 launch bringup robot.launch.py\n```\n"
    for path, text in files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    choice = decide_dockerfile(gather(Repository.open(tmp_path)), Config(), "ros2", "humble")
    assert bool(choice.answer) is not bool(why)
    assert choice.reasons[0].reason.startswith(why or "the author's Dockerfile: it copies ")


def test_that_of_one_project_of_several_is_not_the_repositorys(tmp_path: Path) -> None:
    """The page installs both by pip, into the Python that it creates; that of one installs its own folder alone."""
    files = {
        "README.md": "```\nconda create -n a python=3.9\ncd robot\npip install .\ncd ../lab\npip install -e .\n```\n",
        "lab/docker/gpu/Dockerfile": "FROM python:3.12\nCOPY . /lab\nWORKDIR /lab\nRUN pip install .\n",
        "lab/environment.yml": "name: lab\ndependencies:\n  - python=3.11\n  - einops\n",
        "lab/pyproject.toml": '[project]\nname = "lab"\n[tool.setuptools]\npackages = ["lab"]\n',
        "lab/lab/main.py": "import robot\n\nif __name__ == '__main__':\n    robot.run()\n",
        "robot/setup.py": "from setuptools import setup\n\nsetup(name='robot', packages=['robot'])\n",
        "robot/robot/__init__.py": "def run(): ...\n",
    }
    for path, text in files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    decision = decide(gather(Repository.open(tmp_path)), Config(), folder_name="demo")
    assert decision.dockerfile is None
    said = next(reason for reason in decision.reasons if reason.question == "dockerfile")
    assert said.reason == "it builds lab, not the whole repository"
    assert decision.python.projects == ("robot", "lab")
    assert (decision.python.conda_file, decision.python.version) == (None, "3.9")


ROS = {"package.xml": "<package><name>a</name><buildtool_depend>catkin</buildtool_depend></package>"}


@pytest.mark.parametrize(
    ("files", "names"),
    [
        ({}, set[str]()),
        ({"README.md": "```\nvim a\n```\n"}, set[str]()),
        ({"run.sh": "#!/usr/bin/env zsh\necho vim\n# tmux\n"}, {"zsh"}),
        ({"run.sh": "#!/bin/bash -e\ncd a && tmux new -d -s a\n"}, {"tmux"}),
        ({"main.py": "import subprocess\nsubprocess.Popen(['screen', '-d'])\n"}, {"screen"}),
        ({"main.py": "import os\nos.system('cd a; htop')\n"}, {"htop"}),
        ({"run.sh": "#!/bin/bash\ntmux() {\n:\n}\ntmux\n"}, set[str]()),
        ({"setup.sh": "sudo apt-get install --yes \\\n  vim \\\n  zsh\n"}, set[str]()),
        ({"setup.sh": "sudo apt-get install --yes \\\r\n  vim \\\r\n  zsh\r\n"}, set[str]()),
        ({"run.sh": "cd a && \\\n  tmux new -d\n"}, {"tmux"}),
        (ROS, {"python3-vcstool"}),
    ],
)
def test_what_serves_the_author_alone_is_left_out(tmp_path: Path, files: dict[str, str], names: set[str]) -> None:
    own = "vim neovim tmux screen zsh htop kitware-archive-keyring python3-vcstool ros-dev-tools"
    made = {
        "Dockerfile": f"FROM ubuntu:20.04\nRUN apt-get install -y libgsl-dev {own}\n",
        "CMakeLists.txt": "project(a)\nadd_executable(a a.cpp)\n",
        "a.cpp": "int main() {}\n",
    }
    for path, text in {**made, **files}.items():
        (tmp_path / path).write_text(text)
    found = decide(gather(Repository.open(tmp_path)), Config(), folder_name="a")
    offered = {*found.apt, *found.apt_guessed}
    assert "libgsl-dev" in offered
    assert offered & {*own.split()} - {"ros-dev-tools"} == names


@pytest.mark.parametrize("script", ["", "#!/bin/bash\ncode .\n"])
def test_what_a_page_installs_for_a_person_alone_is_left_out(tmp_path: Path, script: str) -> None:
    own = "code software-properties-common google-chrome-stable gedit xterm libgsl-dev"
    made = {
        "README.md": f"# Install\n```\nsudo apt install {own}\n```\n",
        "CMakeLists.txt": "project(a)\nfind_package(catkin REQUIRED)\ncatkin_package()\n",
        "run.sh": script,
        **ROS,
    }
    for path, text in made.items():
        (tmp_path / path).write_text(text)
    found = decide(gather(Repository.open(tmp_path)), Config(), folder_name="a")
    kept = {"libgsl-dev", "xterm"} | ({"code"} if script else set[str]())
    assert {*found.apt, *found.apt_guessed} & {*own.split()} == kept


@pytest.mark.parametrize("required", ["", "find_package(LATEX REQUIRED)\n"])
def test_what_only_writes_manuals_or_asks_in_a_window_is_left_out(tmp_path: Path, required: str) -> None:
    own = "doxygen doxygen-latex cmake-gui cmake-qt-gui libgsl-dev"
    made = {
        "Dockerfile": f"FROM ubuntu:20.04\nRUN apt-get install -y {own}\n",
        "README.md": f"# Install\n```\nsudo apt install {own}\n```\n",
        "CMakeLists.txt": f"project(a)\n{required}add_executable(a a.cpp)\n",
        "a.cpp": "int main() {}\n",
    }
    for path, text in made.items():
        (tmp_path / path).write_text(text)
    found = decide(gather(Repository.open(tmp_path)), Config(), folder_name="a")
    kept = {"doxygen", "libgsl-dev"} | ({"doxygen-latex"} if required else set[str]())
    assert {*found.apt, *found.apt_guessed} & {*own.split()} == kept


def test_what_ubuntu_has_too_stays(tmp_path: Path) -> None:
    asked = "python3-rospkg python3-catkin-pkg python3-rosdistro python3-rospkg-modules"
    (tmp_path / "Dockerfile").write_text(f"FROM ubuntu:20.04\nRUN apt-get install -y {asked}\n")
    (tmp_path / "CMakeLists.txt").write_text("project(a)\nadd_executable(a a.cpp)\n")
    (tmp_path / "a.cpp").write_text("int main() {}\n")
    found = decide(gather(Repository.open(tmp_path)), Config(), folder_name="a")
    assert {*found.apt, *found.apt_guessed} & {*asked.split()} == {*asked.split()[:3]}
