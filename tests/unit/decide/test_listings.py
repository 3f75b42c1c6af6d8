"""What a program printed as a list installs nothing and names no version."""

from __future__ import annotations

from collections.abc import Callable

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CMAKE = "cmake_minimum_required(VERSION 3.5)\nproject(demo)\nadd_executable(demo main.cpp)\ninstall(TARGETS demo)\n"
FILES = {"CMakeLists.txt": CMAKE, "main.cpp": "int main() {}\n"}
LAYERS = """```txt
 446 MB  apt-get update && apt-get install -y bash-completion python3- drwxr-xr-x   0:0   5.3 kB  bin
 156 MB  apt-get install -y libgtk2.0-dev pkg-con drwxr-xr-x   0:0   13 MB  include
 1.2 GB  cd /opt && git clone https://github.com/lab/open && cd /opt/Open drwxrwxr-x  0:50  495 MB  python3.6
```
```
IMAGE          CREATED        CREATED BY                                      SIZE
d9bd0dcaa40b   3 weeks ago    /bin/sh -c apt-get install -y lsb-release       446MB
<missing>      3 weeks ago    /bin/sh -c apt-get install -y nano              3.4MB
```
"""


def apt(decision: Decision) -> set[str]:
    return {*decision.apt, *decision.apt_guessed}


def test_layers_of_an_image(tree: Tree) -> None:
    decision = tree({**FILES, "README.md": f"# Demo\n## Size\n{LAYERS}"})
    named = {
        "bash-completion",
        "python3-",
        "drwxr-xr-x",
        "5.3",
        "bin",
        "pkg-con",
        "13",
        "include",
        "lsb-release",
        "nano",
    }
    assert not named & apt(decision)


def test_commands_between_what_they_print(tree: Tree) -> None:
    page = "## Install\n```\nls -l /dev\ncrw-rw---- 1 root video 81, 0 video0\nsudo apt install v4l-utils 7zip\n"
    assert {"v4l-utils", "7zip"} <= apt(tree({**FILES, "README.md": f"{page}```\n"}))


def test_what_apt_removes_and_numbers_are_no_packages(tree: Tree) -> None:
    page = "## Install\n```\nsudo apt install g++ nano- 13 5.3\n```\n"
    assert not {"nano-", "nano", "13", "5.3"} & apt(tree({**FILES, "README.md": page}))
