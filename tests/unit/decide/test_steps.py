"""Steps of an installation that the image does not repeat: each is told once, with its line."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.brought_archives import in_its_place
from roslab.decide.decision import Decision
from roslab.evidence.gather import gather
from trees import tree_of

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
CMAKE = "project(demo)\nfind_package(catkin REQUIRED)\n"


def told(tree: Tree, page: str, **files: str) -> list[tuple[str, str | None, int | None]]:
    found = tree({"package.xml": PACKAGE, "CMakeLists.txt": CMAKE, "README.md": f"# For ROS Noetic\n{page}"} | files)
    begin = ("not part of the image: ", "not cloned: ")
    return [(w.message.split(";")[0], w.file, w.line) for w in found.warnings if w.message.startswith(begin)]


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("sudo add-apt-repository ppa:somebody/things", "add-apt-repository ppa:somebody/things"),
        ("sudo dpkg -i driver_1.0_amd64.deb", "dpkg -i driver_1.0_amd64.deb"),
        ("wget https://example.org/sdk-2.tar.gz", "wget https://example.org/sdk-2.tar.gz"),
        ("git apply ../driver.patch", "git apply ../driver.patch"),
    ],
)
def test_a_step_by_other_means_is_told_once_with_its_line(tree: Tree, line: str, said: str) -> None:
    page = f"## Installation\n```\n{line}\n```\n## Once more\n```\n{line}\n```\n"
    assert told(tree, page) == [(f"not part of the image: `{said}`", "README.md", 4)]


@pytest.mark.parametrize(
    ("line", "here"),
    [
        ("wget https://raw.githubusercontent.com/Lab/robots/master/tools/pcl_install.sh", True),
        ("wget https://github.com/lab/robots/raw/master/tools/pcl_install.sh", True),
        ("curl -O https://raw.githubusercontent.com/lab/robots/refs/heads/master/tools/pcl_install.sh", True),
        ("wget https://raw.githubusercontent.com/lab/robots/master/tools/gone_install.sh", False),
        ("wget https://raw.githubusercontent.com/lab/other/master/tools/pcl_install.sh", False),
    ],
)
def test_a_file_of_the_tree_is_part_of_the_image(tree: Tree, line: str, *, here: bool) -> None:
    git = {
        ".git/config": '[remote "origin"]\n\turl = git@github.com:lab/robots.git\n',
        ".git/HEAD": "ref: refs/heads/a\n",
    }
    page = f"## Installation\n```\n{line}\n```\n"
    assert bool(told(tree, page, **git, **{"tools/pcl_install.sh": "make\n"})) != here


def test_data_is_no_step_of_an_installation(tree: Tree) -> None:
    page = "## Usage\n```\nwget https://example.org/bags.zip\n```\n## Install the dataset\n```\nwget https://x.org/a.zip\n```\n"
    assert told(tree, page) == []


def test_a_clone_that_nothing_asks_for_is_told_and_the_repository_itself_is_not(tree: Tree) -> None:
    page = "```\ngit clone https://github.com/me/demo\ngit clone https://github.com/them/odd_sdk.git\n```\n"
    message = "not cloned: https://github.com/them/odd_sdk.git, for nothing that is built asks for it by name"
    assert told(tree, page) == [(message, "README.md", 4)]


@pytest.mark.parametrize("there", [True, False])
def test_a_submodule_whose_page_clones_itself_is_there(tree: Tree, there: bool) -> None:
    """Its page names it by another form of the address, and its folder is called otherwise."""
    page = "```\ngit clone git@github.com:them/odd_sdk.git\n```\n"
    module = '[submodule "{0}"]\n\tpath = {0}\n\turl = https://github.com/them/{1}\n'
    files = {".gitmodules": module.format("parts/odd", "odd_sdk" if there else "even_sdk"), "parts/odd/a.txt": "a\n"}
    assert bool(told(tree, page, **files)) != there


@pytest.mark.parametrize(
    ("url", "needed", "page", "why"),
    [
        ("https://github.com/gazebosim/ros_gz", "ros_gz_sim", "", "apt brings what is needed of that name: ros_gz_sim"),
        (
            "https://github.com/gazebosim/ros_gz",
            "ros_gz_sim",
            "sudo apt install gz-garden",
            "apt brings what is needed of that name: ros-humble-ros-gzgarden-sim",
        ),
        (
            "https://github.com/them/gazebo_ros_pkgs",
            "gazebo_ros",
            "",
            "apt brings what is needed of that name: gazebo_ros",
        ),
        ("https://github.com/gazebosim/ros_gz", "rclcpp", "", "nothing that is built asks for it by name"),
        ("https://github.com/them/gazebo_r", "gazebo_ros", "", "nothing that is built asks for it by name"),
    ],
)
def test_a_clone_whose_packages_apt_brings_is_told_with_them(
    tree: Tree, url: str, needed: str, page: str, why: str
) -> None:
    package = (
        '<package format="3"><name>robot</name><buildtool_depend>ament_cmake</buildtool_depend>'
        f"<depend>{needed}</depend><export><build_type>ament_cmake</build_type></export></package>"
    )
    cmake = "project(robot)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"
    readme = f"# For ROS 2 Humble\n```\ngit clone {url}\n{page}\n```\n"
    found = tree({"package.xml": package, "CMakeLists.txt": cmake, "README.md": readme}).warnings
    assert [w.message.split(";")[0] for w in found if w.message.startswith("not cloned")] == [
        f"not cloned: {url}, for {why}"
    ]


@pytest.mark.parametrize(
    ("line", "itself"),
    [
        ("vcs import . < robots/robots.repos", True),
        ("vcs import src --input src/robots/lists/deep.repos", True),
        ("vcs import . < robots/others.repos", False),  # the tree has no such list: the clone brings it
        ("vcs import src < robots.repos", False),
    ],
)
def test_a_clone_whose_list_the_tree_has_is_the_repository(tree: Tree, line: str, itself: bool) -> None:
    page = f"```\ngit clone https://github.com/me/robots.git\n{line}\ncolcon build\n```\n"
    lists = "repositories:\n  a:\n    type: git\n    url: https://github.com/x/a.git\n"
    said = told(tree, page, **{"robots.repos": lists, "lists/deep.repos": lists})
    assert (said == []) is itself


def test_a_clone_of_the_origin_is_the_repository(tmp_path: Path) -> None:
    files = {"package.xml": PACKAGE, "CMakeLists.txt": CMAKE, ".git/HEAD": "ref: refs/heads/noetic"}
    files["README.md"] = "```\ngit clone https://github.com/me/robots\ngit clone https://github.com/me/odd\n```\n"
    files[".git/config"] = '[remote "origin"]\n\turl = git@github.com:me/robots.git\n'
    found = decide(gather(tree_of(tmp_path, files)), Config(), folder_name="checkout")
    said = [w.message.split(",")[0] for w in found.warnings if w.message.startswith("not cloned")]
    assert said == ["not cloned: https://github.com/me/odd"]


LIST = (
    "https://raw.githubusercontent.com/laboratory/robots-of-the-laboratory/a-branch-with-a-long-name/lists/robot.repos"
)


@pytest.mark.parametrize(
    "line",
    [
        f"wget {LIST}",
        f"vcs import --input {LIST} src",
        f"vcs import src < <(curl -s {LIST})",
        f"curl {LIST} | vcs import src",
        f"wstool init src {LIST}",
    ],
)
def test_a_list_of_repositories_that_a_page_fetches_is_imported_or_told(tree: Tree, line: str) -> None:
    listed = (
        "repositories:\n  odd_arm:\n    type: git\n    url: https://github.com/lab/odd_arm.git\n    version: main\n"
    )
    files = {"package.xml": PACKAGE, "CMakeLists.txt": CMAKE, "README.md": f"# For ROS Noetic\n```\n{line}\n```\n"}
    (told,) = [warning for warning in tree(files).warnings if LIST in warning.message]
    assert (told.message.partition(":")[0], told.file, told.line) == ("not imported", "README.md", 3)
    found = tree({**files, "lists/robot.repos": listed})
    assert [source.name for source in found.source] == ["odd_arm"]
    assert not any(LIST in warning.message for warning in found.warnings)


def test_a_script_names_the_distribution_by_its_packages(tree: Tree) -> None:
    script = "apt-get install -y ros-melodic-tf2-sensor-msgs\n"
    found = tree({"package.xml": PACKAGE, "CMakeLists.txt": CMAKE, "install_dependencies.sh": script})
    assert found.ros_distro == "melodic"


BASE = "FROM ubuntu:22.04\nRUN apt-get update\n"
ELSEWHERE = (
    "its base lab/base is what line 2 of README.md builds first, from docker/other/Dockerfile, "
    "which is not one file of the tree"
)
OWN = "FROM lab/base\nCOPY . /app\nCMD python3 /app/walk.py\n"


@pytest.mark.parametrize(
    ("page", "used"),
    [
        ("```\ndocker build -t lab/base docker/other\ndocker build -t walk .\n```\n", False),
        ("```\ndocker pull lab/base\n```\nor `docker build -t lab/base docker/base`\n", True),
        ("```\ndocker build -t walk .\n```\n", True),
    ],
)
def test_a_base_that_the_page_builds_from_elsewhere_is_no_published_image(tree: Tree, page: str, used: bool) -> None:
    files = {"Dockerfile": OWN, "docker/base/Dockerfile": BASE, "walk.py": "print(1)\n", "README.md": page}
    found = tree(files)
    assert (found.dockerfile == "Dockerfile") is used
    against = [r.reason for r in found.reasons if r.question == "dockerfile" and "builds first" in r.reason]
    assert against == ([] if used else [ELSEWHERE])


SOURCE = "## Install\n1. Add the source:\n```bash\n{line}\n```\n```bash\nsudo apt install ros-noetic-things\n```\n"


@pytest.mark.parametrize(
    ("line", "step"),
    [
        ("curl https://them.example/add_ppa.sh | bash", "curl https://them.example/add_ppa.sh | bash"),
        ("wget -qO - https://deb.them.example/setup | sudo -E bash -", "wget https://deb.them.example/setup | bash"),
        ("curl https://them.example/apt/install.sh | bash", "curl https://them.example/apt/install.sh"),  # told once
        ("curl https://them.example/add_ros_ppa.sh | bash", None),  # the base has the source of ROS
        ("curl -LsSf https://them.example/tool/get.sh | sh", None),
    ],
)
def test_a_script_of_the_net_that_adds_a_source_of_apt_is_told(tree: Tree, line: str, step: str | None) -> None:
    assert told(tree, SOURCE.format(line=line)) == (
        [(f"not part of the image: `{step}`", "README.md", 5)] if step else []
    )


@pytest.mark.parametrize(
    ("line", "together"),
    [
        ("curl https://them.example/ppa/add.sh | bash", True),
        ("sudo add-apt-repository ppa:them/things", True),
        ("ls", False),
    ],
)
def test_unknown_keys_are_told_together_with_the_source_that_may_have_them(
    tree: Tree, line: str, *, together: bool
) -> None:
    xml = PACKAGE.replace("</package>", "<depend>odd_core</depend>\n<depend>odd_maps</depend></package>")
    page = "# For ROS Noetic\n" + SOURCE.format(line=line)
    found = tree({"package.xml": xml, "CMakeLists.txt": CMAKE, "README.md": page})
    said = [(w.message.split(":")[0], w.file, w.line) for w in found.warnings if "has no key" in w.message]
    every = [("rosdep has no key odd_core, odd_maps for ROS noetic", "README.md", 5)]
    alone = [("rosdep has no keys odd_core and odd_maps for ROS noetic", "package.xml", 1)]
    assert said == (every if together else alone)


@pytest.mark.parametrize(
    ("ignored", "more", "said"),
    [
        ("*pyc\n*_pb2.py\n", {}, True),
        ("*pyc\n", {}, False),
        ("*_pb2.py\n", {"proto/state_pb2.py": "x = 1\n"}, False),
        ("*_pb2.py\n", {"CMakeLists.txt": "project(demo)\nadd_executable(a a.cpp)\n"}, False),
    ],
)
def test_a_call_of_make_that_generates_modules_is_told(
    tree: Tree, ignored: str, more: dict[str, str], *, said: bool
) -> None:
    files = {
        "README.md": "# Demo\n## Build\n``` shell\nmake -j build_it=1\n```\nThen make coffee.\n",
        "proto/state.proto": 'syntax = "proto3";\n',
        "run.py": "import numpy\nimport proto.state_pb2\n",
        "requirements.txt": "numpy\n",
        ".gitignore": ignored,
    }
    begin = "not part of the image: `make -j build_it=1`"
    found = [(w.file, w.line) for w in tree({**files, **more}).warnings if w.message.startswith(begin)]
    assert found == ([("README.md", 4)] if said else [])


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        (
            "gdown https://drive.google.com/uc?id=1D2guAxDEgrKnJFMcLSBkf10SOagz0mr",
            "`gdown https://drive.google.com/uc?id=1D2",
        ),
        (
            "pip install gdown && gdown --id 1D2guAxDEgrKnJFMcLSBkf10SOagz0mr -O a.zip",
            "`gdown 1D2guAxDEgrKnJFMcLSBkf10SOagz0mr`;",
        ),
        (
            "wget https://example.org/a.bag\nwget https://example.org/b.bag",
            "`wget https://example.org/a.bag` and 1 more;",
        ),
        ("wget https://example.org/demo.repos", ""),
        ("pip install gdown", ""),
        ("gdown $KEY", ""),
        ("wget https://a.org/there.bag", ""),
    ],
)
def test_data_that_a_page_fetches_is_told_once(tree: Tree, lines: str, said: str) -> None:
    page = f"# Demo\n## Data\n```\n{lines}\n```\n## Again\n```\n{lines}\n```\n"
    found = tree({"play.py": "import numpy\n", "bags/there.bag": "", "README.md": page})
    data = [w.message for w in found.warnings if w.message.startswith("data that a page fetches")]
    assert len(data) == bool(said)
    assert not said or said in data[0]


def test_data_that_the_image_fetches_is_not_told(tree: Tree) -> None:
    page = "# Demo\n```\nwget https://example.org/net.pth\npython play.py --weights net.pth\n```\n"
    found = tree({"play.py": "import numpy\n", "requirements.txt": "numpy\n", "README.md": page})
    assert [each.path for each in found.downloads] == ["net.pth"]
    assert not any("data that" in warning.message for warning in found.warnings)


@pytest.mark.parametrize("name", ["ros2-apt-source", "other-apt-source"])
def test_the_source_of_ros_itself_is_in_the_image(tree: Tree, name: str) -> None:
    package = '<package format="3"><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend></package>'
    page = f"ROS 2 jazzy\n\n```\nsudo dpkg -i /tmp/{name}.deb\n```\n"
    decision = tree({"package.xml": package, "CMakeLists.txt": "project(demo)\n", "README.md": page})
    assert any("not part of the image" in each.message for each in decision.warnings) is name.startswith("other")


@pytest.mark.parametrize(
    ("path", "copies", "told_of"),
    [
        ("docker/Dockerfile.base", "COPY docker/start.sh /", True),
        ("Dockerfile", "COPY . /ws/src/demo", False),  # it is built itself
        (".devcontainer/Dockerfile", "COPY docker/start.sh /", False),
    ],
)
def test_a_clone_of_an_authors_dockerfile_that_is_not_built_is_told(
    tree: Tree, path: str, copies: str, *, told_of: bool
) -> None:
    clones = "".join(f"RUN git clone https://github.com/{name}.git\n" for name in ("me/demo", "them/odd_sdk"))
    build = "RUN apt-get update && apt-get install -y git && catkin_make"
    files = {path: f"FROM ros:noetic\nWORKDIR /ws/src\n{clones}{copies}\n{build}\n", "docker/start.sh": "ls\n"}
    message = "not cloned: https://github.com/them/odd_sdk.git, for nothing that is built asks for it by name"
    assert told(tree, "", **files) == ([(message, path, 4)] if told_of else [])


def test_a_clone_that_may_be_what_cmake_requires_is_told_with_that(tree: Tree) -> None:
    docker = "FROM ubuntu:22.04\nRUN git clone https://github.com/them/libodd.git /opt/odd && /opt/odd/setup.run\n"
    cmake = "project(demo)\nfind_package({} REQUIRED)\nadd_executable(demo demo.cpp)\n"
    for name, why in (
        ("odd2", "though CMakeLists.txt:2 requires odd2, which it may be"),
        ("even2", "for nothing that"),
    ):
        files = {"docker/Dockerfile": docker, "CMakeLists.txt": cmake.format(name), "demo.cpp": "int main() {}\n"}
        said = [each.message for each in tree(files).warnings if each.file == "docker/Dockerfile"]
        assert len(said) == 1
        assert said[0].startswith(f"not cloned: https://github.com/them/libodd.git, {why}")


def test_a_clone_of_what_apt_brings_for_this_ubuntu_is_not_told(tree: Tree) -> None:
    page = "```\ngit clone https://github.com/pybind/pybind11.git\n```\n"
    cmake = "project(demo)\nfind_package(pybind11 REQUIRED)\npybind11_add_module(demo demo.cpp)\n"
    files = {"CMakeLists.txt": cmake, "demo.cpp": "#include <pybind11/pybind11.h>\n", "bindings/README.md": page}
    decision = tree(files)
    assert "pybind11-dev" in (*decision.apt, *decision.apt_guessed)
    assert not [each for each in decision.warnings if "not cloned" in each.message]


@pytest.mark.parametrize(
    ("code", "said"),
    [
        ("import acmearm_sdk\n", "though scripts/a.py:2 imports acmearm_sdk, which it may bring"),
        ("import numpy\n", "for nothing that is built asks for it by name"),
        (
            "try:\n    import acmearm_sdk\nexcept ImportError:\n    pass\n",
            "for nothing that is built asks for it by name",
        ),
    ],
)
def test_a_module_that_a_clone_may_bring_is_told(tree: Tree, code: str, said: str) -> None:
    page = "```\ngit clone https://github.com/acme/AcmeArm-Service-Binding.git\n```\n"
    found = told(tree, page, **{"scripts/a.py": f"#!/usr/bin/env python3\n{code}"})
    assert [message.partition(".git, ")[2] for message, _, _ in found] == [said]


FETCHED = """\
#!/bin/bash
wget https://gmplib.org/download/gmp/gmp.tar.xz
wget https://example.org/odd-1.0.tar.gz
wget https://boostorg.example.org/release/source/${BOOST}.tar.gz
wget https://example.org/CGAL-6.0.1-library.tar.xz
wget https://example.org/sdk.zip
make install
"""


def archives(tree: Tree, script: str, page: str = "") -> list[tuple[str, int | None]]:
    top = (
        "cmake_minimum_required(VERSION 3.14)\nproject(demo CXX)\nfind_package(Boost REQUIRED)\ninclude(FetchContent)\n"
        "FetchContent_Declare(CGAL URL https://example.org/CGAL.tar.xz)\nadd_executable(demo main.cpp)\n"
    )
    files = {"CMakeLists.txt": top, "main.cpp": "int main() {}\n", "README.md": page, "install_dependencies.sh": script}
    begin = "not part of the image: "
    found = [w for w in tree(files).warnings if w.message.startswith(begin)]
    return [(w.message.removeprefix(begin).split("; put")[0], w.line) for w in found]


@pytest.mark.parametrize(
    ("apt", "first", "line"),
    [("libgmp-dev", "", 3), ("libgsl-dev", "`wget https://gmplib.org/download/gmp/gmp.tar.xz`, ", 2)],
)
def test_one_line_tells_what_a_script_fetches_and_no_library_that_is_there(
    tree: Tree, apt: str, first: str, line: int
) -> None:
    rest = "`wget https://example.org/odd-1.0.tar.gz`, `wget https://boostorg.example.org/release/source/….tar.gz`"
    page = f"# Installation\n```\nsudo apt install {apt}\n```\n"
    assert archives(tree, FETCHED, page) == [(f"{first}{rest}, `wget https://example.org/sdk.zip`", line)]


def test_of_many_steps_of_a_script_some_are_named(tree: Tree) -> None:
    hosts = [f"wget https://h{number}.example.org/part{number}x.tar.gz" for number in range(12)]
    named = ", ".join(f"`{each}`" for each in hosts[:4])
    assert archives(tree, "#!/bin/bash\n" + "\n".join(hosts) + "\nmake install\n") == [
        (f"{named} and 8 more, see the script", 2)
    ]


@pytest.mark.parametrize(
    ("apt", "path", "said"),
    [
        ("libopencv-dev", "opencv-3.4.6.tar.gz", " (Ubuntu's libopencv-dev is there instead)"),
        ("libopencv-dev", "opencv.zip", None),
        ("libopencv-dev", "opencv_contrib-3.4.6.zip", ""),
        ("libboost-all-dev", "boost_1_83_0.tar.gz", " (Ubuntu's libboost-all-dev is there instead)"),
        ("libboost-all-dev", "models/boost/$NAME.tar.gz", ""),
        ("zlib1g-dev", "zlib.tar.gz", None),
        ("zlib1g-dev", "zlib-1.2.13.tar.gz", " (Ubuntu's zlib1g-dev is there instead)"),
        ("python3-dev", "Python-3.9.1.tgz", ""),
        ("python3-dev", "Python.tgz", ""),
        ("linux-libc-dev", "linux-6.1.tar.xz", ""),
        ("default-libmysqlclient-dev", "default.zip", ""),
        ("libgoogle-glog-dev", "google.zip", ""),
    ],
)
def test_an_archive_of_another_thing_or_release_is_told(tree: Tree, apt: str, path: str, said: str | None) -> None:
    page = f"# Installation\n```\nsudo apt install {apt}\n```\n"
    step = f"wget https://example.org/{path}"
    told = f"`{step.replace('$NAME', '…')}`{said}"
    assert archives(tree, f"#!/bin/bash\n{step}\nmake install\n", page) == ([] if said is None else [(told, 2)])


@pytest.mark.parametrize("file", ["boost_models.zip", "boost-data.tar.gz", "models/boost/….tar.gz", "boost_1_83_0.deb"])
def test_only_a_version_follows_the_name_of_a_library(file: str) -> None:
    assert in_its_place(f"wget https://example.org/{file}", {"boost": "libboost-all-dev"}) is None


@pytest.mark.parametrize(("root", "told"), [("", True), ("```\npython play.py\n```\n", False)])
def test_where_the_first_page_starts_nothing_a_page_below_tells_of_its_data(tree: Tree, root: str, told: bool) -> None:
    page = (
        "# Start\n```\nwget -qO- https://example.org/a.zip | bsdtar -xvf- -C ./\npython play.py --data a/b.pkl\n```\n"
    )
    files = {
        "play.py": "import numpy\n",
        "walker/play.py": "import numpy\n",
        "README.md": f"# Demo\n[Getting Started](walker/docs/quick_start.md)\n{root}",
        "walker/docs/quick_start.md": page,
    }
    found = [w.file for w in tree(files).warnings if w.message.startswith("data that a page fetches")]
    assert found == (["walker/docs/quick_start.md"] if told else [])


@pytest.mark.parametrize(
    ("address", "cloned"),
    [
        ("git@github.com:them", False),
        ("https://gitlab.com/them/", False),
        ("git@github.com:them/odd_sdk.git", True),
        ("https://code.example.org/odd_sdk", True),  # a host of somebody's own may have no owners
    ],
)
def test_an_owner_alone_is_no_repository(tree: Tree, address: str, *, cloned: bool) -> None:
    assert bool(told(tree, f"## Installation\n```\ngit clone {address}\n```\n")) == cloned
