"""What the default command names and a page fetches is in the image."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.config.model import Config
from roslab.decide.decision import Decision, Download
from roslab.plan.plan import make_plan
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]
URL = "https://files.example/v1/model.pth"
RUN = "python demo.py --weights weights/model.pth --input=data/one --config conf.yaml"
MODEL = Download(url=URL, path="weights/model.pth")


def planned(tree: Tree, page: str, run: str = RUN, **more: str) -> Decision:
    files = {"demo.py": "import numpy\n", "requirements.txt": "numpy\n", **more}
    return tree({**files, "README.md": f"## Install\n```\n{page}\n```\n## Usage\n```\n{run}\n```\n"})


@pytest.mark.parametrize(
    ("page", "found"),
    [
        (f"mkdir weights && cd weights\nwget {URL}\ncd ..", MODEL),
        (f"git clone https://example.org/lab/demo.git\ncd demo\nmkdir -p weights\nwget -P weights {URL}", MODEL),
        (f"wget -qO weights/model.pth {URL}?download=1", Download(url=f"{URL}?download=1", path="weights/model.pth")),
        (f"$ curl -L --output weights/model.pth '{URL}'", MODEL),
        (f"cd weights\ncurl -LO {URL}", MODEL),
        (f"wget {URL}", None),
        (f"curl -L {URL}", None),
        (f"wget -O ../weights/model.pth {URL}", None),
        (f"wget -O /data/weights/model.pth {URL}", None),
        (f"wget -O weights/model.pth {URL.replace('model', '$NAME')}", None),
        ("wget https://x.example/d.zip\nunzip d.zip -d data",
         Download(url="https://x.example/d.zip", path="d.zip", unpack="data")),
        ("wget https://x.example/data.tar.gz\ntar -xzf data.tar.gz",
         Download(url="https://x.example/data.tar.gz", path="data.tar.gz", unpack=".")),
        ("wget https://x.example/all.zip\nunzip all.zip", None),
        ("wget https://x.example/data.zip", None),
        ("wget -O conf.yaml https://x.example/conf.yaml", None),
    ],
)  # fmt: skip
def test_what_the_command_names(tree: Tree, page: str, found: Download | None) -> None:
    assert planned(tree, page, **{"conf.yaml": ""}).downloads == ((found,) if found else ())


@pytest.mark.parametrize(("folder", "there"), [("thirdparty", True), ("other", False)])
def test_what_the_build_names(tree: Tree, folder: str, there: bool) -> None:
    url = "https://example.org/eigen/archive/eigen-3.4.0.zip"
    setup = "from setuptools import setup, Extension\nsetup(name='demo', ext_modules=[Extension('a', ['a.cpp'], "
    setup += "include_dirs=['thirdparty/eigen-3.4.0'])])\n"
    page = f"wget {url}\nunzip eigen-3.4.0.zip -d {folder}\npip install ."
    decision = planned(tree, f"cd demo\n{page}", "python demo.py", **{"setup.py": setup, "a.cpp": ""})
    assert decision.downloads == ((Download(url=url, path="eigen-3.4.0.zip", unpack=folder),) if there else ())
    told = [warning.message for warning in decision.warnings if url in warning.message]
    assert len(told) == (not there)


@pytest.mark.parametrize(("name", "there"), [("4.8.0.zip", False), ("lidar.zip", False), ("lidar-4.8.0.zip", True)])
def test_an_archive_of_a_repository_has_its_own_folder(tree: Tree, name: str, there: bool) -> None:
    """A page may give it the name of a library that CMake asks for."""
    url = f"https://github.com/lab/lidar/archive/{'lidar-' * there}4.8.0.zip"
    folder = "lidar-4.8.0" if there else "lidar"
    made = f"project(demo)\nfind_package(lidar REQUIRED)\nadd_executable(demo a.cpp)\ninclude_directories({folder})\n"
    page = f"wget -O {name} {url}\nunzip {name}\n"
    files = {"CMakeLists.txt": made, "a.cpp": "int main() {}\n", "README.md": f"```\n{page}```\n"}
    assert tree(files).downloads == ((Download(url=url, path=name, unpack="."),) if there else ())


def test_a_command_that_names_no_file_needs_none(tree: Tree) -> None:
    assert planned(tree, f"wget -P weights {URL}", "python demo.py").downloads == ()


def test_an_edit_of_the_source_fetches_nothing_again(tree: Tree) -> None:
    text = dockerfile(make_plan(planned(tree, f"wget -P weights {URL}"), Config(), folder_name="demo"))
    stage = text.partition("\nFROM base AS downloads\n")[2].partition("\nFROM ")[0]
    assert f"fetch-optional \\\n      {URL} \\\n      weights/model.pth" in stage
    assert "COPY . " not in stage
    brought = text.index("COPY --from=downloads --chown=${NB_UID}:${NB_UID} /fetched/ /home/${NB_USER}/demo/\n")
    assert brought < text.index("COPY --chown=${NB_UID}:${NB_UID} . .")


ARCHIVE = "https://x.example/sets/room.zip"
SCRIPT = (
    f"#!/bin/bash\nset -e\nmkdir -p data && cd data\necho Fetching it\nwget {ARCHIVE}\nunzip room.zip\nrm room.zip\n"
)
ROOM = Download(url=ARCHIVE, path="data/room.zip", unpack="data")


@pytest.mark.parametrize(
    ("page", "script", "found"),
    [
        ("# Data\n`bash get/room.sh`\n# Demo\n`python demo.py --input data/room/one`\n", SCRIPT, (ROOM,)),
        ("# Data\n```\n./get/room.sh\n```\n# Demo\n`python demo.py --input data/room/one`\n", SCRIPT, (ROOM,)),
        ("# Demo\n```\nbash get/room.sh\npython demo.py conf.yaml\n```\n", SCRIPT, (ROOM,)),
        ("# Data\n`bash get/room.sh`\n# Demo\n`python demo.py conf.yaml`\n", SCRIPT, ()),
        ("# Demo\n```\npython demo.py conf.yaml\nbash get/room.sh\n```\n", SCRIPT, ()),
        ("# Demo\n`python demo.py --input data/room/one`\n", SCRIPT, ()),
        (
            "# Demo\n```\nbash get/room.sh\npython demo.py conf.yaml\n```\n",
            SCRIPT.replace("set -e", "for each in a b; do") + "done\n",
            (),
        ),
        ("# Demo\n```\nbash get/room.sh\npython demo.py conf.yaml\n```\n", f"{SCRIPT}python convert.py\n", ()),
    ],
)
def test_a_script_of_the_tree_that_only_fetches(
    tree: Tree, page: str, script: str, found: tuple[Download, ...]
) -> None:
    files = {"demo.py": "import numpy\n", "requirements.txt": "numpy\n", "conf.yaml": "data: data/room\n"}
    assert tree({**files, "get/room.sh": script, "README.md": page}).downloads == found


def test_a_script_that_only_fetches_is_no_default_command(tree: Tree) -> None:
    files = {"demo.py": "import numpy\n", "requirements.txt": "numpy\n", "get/room.sh": SCRIPT}
    page = "# Demo\n```\nbash get/room.sh\npython demo.py\n```\n"
    assert tree({**files, "README.md": page}).command == ("python", "demo.py")
