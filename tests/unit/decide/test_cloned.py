"""What a page clones and installs by pip is installed from git; PYTHONPATH is as a page sets it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.config.model import Config
from roslab.decide.decision import Decision
from roslab.plan.plan import make_plan
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]
CODE = {"play.py": "import numpy\n", "src/arm/__init__.py": "", "requirements.txt": "numpy\n"}
API = "git clone https://github.com/lab/graspAPI.git\n"


@pytest.mark.parametrize(
    ("page", "urls"),
    [
        (f"{API}cd graspAPI\npip install .\n", ["git+https://github.com/lab/graspAPI.git"]),
        (f"cd src\n{API}cd graspAPI && pip install -e .\n", ["git+https://github.com/lab/graspAPI.git"]),
        (
            "git clone -b v1 https://github.com/lab/sim.git\ncd sim/python\npip install .\n",
            ["git+https://github.com/lab/sim.git@v1#subdirectory=python"],
        ),
        (
            "git clone https://github.com/lab/speed.git\ncd speed/speed\npython3 setup.py install --user\n",
            ["git+https://github.com/lab/speed.git#subdirectory=speed"],
        ),
        (
            "git clone https://github.com/lab/sim-fork.git sim\ncd sim/python\npip install .\n",
            ["git+https://github.com/lab/sim-fork.git#subdirectory=python"],
        ),
        ("git clone https://github.com/lab/demo.git\ncd demo\npip install -e .\n", []),
        (f"{API}pip install -r requirements.txt\n", []),
        (f"{API}cd graspAPI\npython setup.py install\n", ["git+https://github.com/lab/graspAPI.git"]),
        (
            "wget https://github.com/lab/Avoid/archive/master.zip && unzip master\ncd Avoid-master\npip install .\n",
            ["git+https://github.com/lab/Avoid"],
        ),
        (
            "curl -LO https://github.com/lab/avoid/archive/refs/tags/v1.2.tar.gz\npip install ./avoid-1.2/python\n",
            ["git+https://github.com/lab/avoid@v1.2#subdirectory=python"],
        ),
        ("wget https://github.com/lab/demo/archive/master.zip\ncd demo-master\npip install .\n", []),
    ],
)
def test_a_clone_that_pip_installs(tree: Tree, page: str, urls: list[str]) -> None:
    found = tree({**CODE, "README.md": f"```\n{page}```\n"}).python
    assert [each.url for each in found.pip_guessed] == urls
    texts = [each.text for each in found.pip_guessed]
    assert texts == urls, "pip refuses a package that has another name than its repository"


COMMIT = "4049794d4135e41c691f18da38a9af7541b01553"
VARIABLES = f"""\
ARG SPEED_PATH="/src/speed"
ARG SPEED_COMMIT="{COMMIT}"
RUN if [[ "${{DEV,,}}" = true ]]; then \\
    git clone https://github.com/lab/speed.git "${{SPEED_PATH}}" --branch main && \\
    git -C "${{SPEED_PATH}}" reset --hard "${{SPEED_COMMIT}}" && \\
    python3 -m pip install --editable "${{SPEED_PATH}}" ; \\
    fi
"""


@pytest.mark.parametrize(
    ("steps", "urls"),
    [
        (f"RUN {API.strip()} && pip install -e graspAPI\n", ["git+https://github.com/lab/graspAPI.git"]),
        (VARIABLES, [f"git+https://github.com/lab/speed.git@{COMMIT}"]),
        (VARIABLES.replace("python3 -m pip install", "ls"), []),
        ("COPY . /src/demo\nRUN pip install -e /src/demo\n", []),
    ],
)
@pytest.mark.parametrize("folder", ["", "docker/", "examples/one/"])
def test_a_clone_that_pip_installs_in_a_dockerfile_that_is_not_built(
    tree: Tree, folder: str, steps: str, urls: list[str]
) -> None:
    found = tree({**CODE, f"{folder}Dockerfile": f"FROM own_image:latest\n{steps}", "README.md": "# Demo\n"}).python
    assert [each.url for each in found.pip_guessed] == ([] if folder.startswith("examples") else urls)


@pytest.mark.parametrize(("code", "urls"), [("import numpy\n", []), ("import speed\n", [COMMIT])])
def test_of_several_dockerfiles_only_what_the_code_imports(tree: Tree, code: str, urls: list[str]) -> None:
    files = {f"docker/Dockerfile.{use}": f"FROM own_image:{use}\n{VARIABLES}" for use in ("train", "play")}
    found = tree({**CODE, "play.py": code, **files}).python
    assert [each.url.rpartition("@")[2] for each in found.pip_guessed] == urls


@pytest.mark.parametrize(
    ("install", "editable"),
    [
        ("pip install -e .", True),
        ("pip3 install --no-deps --editable .", True),
        ("python setup.py develop --user", True),
        ("pip install .", False),
        ("python setup.py install", False),
        ("pip install numpy . # -e is for developers", False),
    ],
)
def test_what_a_page_installs_editable_keeps_its_clone(tree: Tree, install: str, editable: bool) -> None:
    decision = tree({**CODE, "README.md": f"```\n{API}cd graspAPI\n{install}\n```\n"})
    text = dockerfile(make_plan(decision, Config(), folder_name="demo"))
    url = "git+https://github.com/lab/graspAPI.git"
    assert f"{' --editable=' if editable else ' '}{url}\n" in text
    assert ("COPY --from=scripts /clone-editable " in text) == editable


@pytest.mark.parametrize("option", ["", " --no-build-isolation"])
def test_what_a_page_builds_beside_torch_is_built_so_first(tree: Tree, option: str) -> None:
    page = f"```\npip install torch==2.1.0\n{API}cd graspAPI\npip install -e .{option}\n```\n"
    decision = tree({**CODE, "README.md": page})
    text = dockerfile(make_plan(decision, Config(), folder_name="demo"))
    assert ("--no-build-isolation=--editable=git+https://github.com/lab/graspAPI.git" in text) == bool(option)
    assert "git+https://github.com/lab/graspAPI.git" in text


@pytest.mark.parametrize(
    ("code", "urls"),
    [
        ("import numpy\nfrom widow.utils import load\n", ["git+https://github.com/lab/robot_infra#subdirectory=widow"]),
        ("import numpy\n", []),
    ],
)
def test_a_folder_of_a_clone_that_a_page_never_enters(tree: Tree, code: str, urls: list[str]) -> None:
    page = "Clone the  [infrastructure](https://github.com/lab/robot_infra), and run\n\n`pip install -e widow`\n"
    decision = tree({**CODE, "play.py": code, "README.md": f"# Demo\n## Installation\n{page}"})
    assert [each.url for each in decision.python.pip_guessed] == urls
    assert not any("widow" in warning.message for warning in decision.warnings)


def test_a_folder_of_the_tree_is_no_clones(tree: Tree) -> None:
    page = "Clone the [robot infrastructure](https://github.com/lab/robot_infra), and run\n\n`pip install -e widow`\n"
    own = {"widow/setup.py": "from setuptools import setup\nsetup(name='widow')\n", "widow/widow/__init__.py": ""}
    decision = tree({**CODE, **own, "play.py": "import widow\n", "README.md": f"# Demo\n## Installation\n{page}"})
    assert decision.python.projects == ("widow",)
    assert not decision.python.pip_guessed


SAID = "- Clone https://github.com/lab/rsl_lib\n- `cd rsl_lib && git checkout v1.0.2 && pip install -e .`\n"
URL = "git+https://github.com/lab/rsl_lib"


@pytest.mark.parametrize(
    ("page", "asked", "pip"),
    [
        (SAID, "rsl-lib", [f"rsl-lib @ {URL}@v1.0.2", "numpy"]),
        (SAID.replace("https://github.com/lab/rsl_lib", "the library [rsl_lib](https://github.com/lab/rsl_lib)."),
         "rsl_lib", [f"rsl_lib @ {URL}@v1.0.2", "numpy"]),
        (f"`pip install rsl_lib@{URL}`\n", "rsl-lib[torch]", [f"rsl-lib[torch] @ {URL}", "numpy"]),
        (f"`pip install {URL}`\n", "rsl-lib==2.0", []),
        ("See https://github.com/lab/rsl_lib\n", "rsl-lib", []),
    ],
)  # fmt: skip
@pytest.mark.parametrize("declared", ["requirements.txt", "setup.py"])
def test_a_declared_name_that_a_page_takes_from_git(
    tree: Tree, page: str, asked: str, pip: list[str], declared: str
) -> None:
    files = {
        "requirements.txt": f"{asked}\nnumpy\n",
        "setup.py": f"from setuptools import setup\nsetup(name='demo', install_requires=['{asked}', 'numpy'])\n",
    }
    found = tree({"play.py": "import numpy\n", declared: files[declared], "README.md": f"## Install\n{page}"}).python
    assert [each.text for each in found.pip] == pip


@pytest.mark.parametrize(
    ("page", "folders"),
    [
        ("export PYTHONPATH=$PYTHONPATH:$(pwd)/src\n", ("src",)),
        ("echo 'export PYTHONPATH=</path/to/demo/src>:$PYTHONPATH' >> ~/.bashrc\n", ("src",)),
        ('export PYTHONPATH="${PYTHONPATH}:$HOME/demo/src"\n', ("src",)),
        ("export PYTHONPATH=`pwd`:$PYTHONPATH\n", (".",)),
        ("PYTHONPATH=. python play.py\n", (".",)),
        ("export PYTHONPATH=/opt/caffe/python:$PYTHONPATH\n", ()),
        ('export PYTHONPATH="${PYTHONPATH}:PATH_TO_REACH_NET"\n', (".",)),
        ("export PYTHONPATH=$PYTHONPATH:/home/me/reach-net/\n", (".",)),
        ("export PYTHONPATH=$PYTHONPATH:/path/to/reach\n", ()),
    ],
)
def test_the_folders_that_a_page_puts_on_the_path(tree: Tree, page: str, folders: tuple[str, ...]) -> None:
    origin = {".git/config": '[remote "origin"]\n\turl = https://github.com/lab/Reach-Net.git\n'}
    assert tree({**CODE, **origin, "README.md": f"```\n{page}```\n"}).python_path == folders


@pytest.mark.parametrize(
    ("value", "module", "folders"),
    [
        ("/path/to/arm", "arm/__init__.py", (".",)),
        ("$PWD/arm", "arm/__init__.py", (".",)),
        ("arm", "arm/__init__.py", (".",)),
        ("/path/to/arm", "arm/typing.py", (".",)),
        ("$PWD/arm", "arm/play.py", ("arm",)),
        ("arm", "arm/play.py", ("arm",)),
        ("/path/to/arm/arm", "arm/play.py", ("arm",)),
        ("/path/to/arm/arm", "arm/__init__.py", (".",)),
        ("/path/to/arm/lib/arm", "lib/arm/play.py", ("lib/arm",)),
    ],
)
def test_a_folder_of_the_repositorys_name_is_the_clone(
    tree: Tree, value: str, module: str, folders: tuple[str, ...]
) -> None:
    origin = {".git/config": '[remote "origin"]\n\turl = https://github.com/lab/arm.git\n'}
    page = f"```\nexport PYTHONPATH=$PYTHONPATH:{value}\n```\n"
    files = {"play.py": "import numpy\n", "requirements.txt": "numpy\n", **origin, module: "", "README.md": page}
    assert tree(files).python_path == folders


def test_the_image_has_the_path(tree: Tree) -> None:
    decision = tree({**CODE, "README.md": "```\nexport PYTHONPATH=$PWD:$PWD/src\n```\n"})
    text = dockerfile(make_plan(decision, Config(), folder_name="demo"))
    assert 'PYTHONPATH="/home/${NB_USER}/demo:/home/${NB_USER}/demo/src"' in text


@pytest.mark.parametrize(
    ("options", "repository", "asked"),
    [
        ("--recursive --depth 1 -b v1.8.1", "pytorch/pytorch", "torch==1.8.1"),
        ("--recursive", "pytorch/pytorch", "torch"),
        ("-b v0.9.1", "pytorch/vision", "torchvision==0.9.1"),
        ("-b v1.8.1", "lab/pytorch", "git+https://github.com/lab/pytorch.git@v1.8.1"),
    ],
)
def test_a_framework_that_a_page_compiles_comes_as_a_wheel(
    tree: Tree, options: str, repository: str, asked: str
) -> None:
    folder = repository.rpartition("/")[2]
    lines = f"git clone {options} https://github.com/{repository}.git\ncd {folder}\npython setup.py install\n"
    page = {"README.md": f"# Install\n```\n{lines}```\n", "play.py": "import numpy\n"}
    python = tree(page).python
    written = [each.written for each in (*python.pip, *python.pip_guessed)]
    assert asked in written
    assert not any("pytorch.git" in each for each in written if each != asked)


NODE = """\
<package><name>planner</name><version>1.0.0</version><description>x</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license>
<buildtool_depend>catkin</buildtool_depend><depend>rospy</depend></package>
"""
CMAKE = "cmake_minimum_required(VERSION 3.0)\nproject(planner)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"


@pytest.mark.parametrize(
    ("name", "imported", "key", "cloned"),
    [
        ("toppra", "toppra", "rospy", True),  # ROS 2 has a package of that name, and ROS 1 has none
        ("toppra", "toppra", "toppra", False),  # it is in the workspace
        ("toppra", "numpy", "rospy", False),
        ("moveit_commander", "moveit_commander", "rospy", False),  # ROS's own
    ],
)
def test_beside_ros_it_is_what_the_code_imports(
    tree: Tree, name: str, imported: str, key: str, *, cloned: bool
) -> None:
    page = f"For ROS Noetic.\n```\ngit clone https://github.com/lab/{name}.git && cd {name}/\ngit checkout {COMMIT}\n"
    page += "pip install -r requirements.txt --user\npython setup.py install --user\n```\n"
    node = NODE.replace("rospy", key)
    files = {"package.xml": node, "CMakeLists.txt": CMAKE, "README.md": page, "scripts/plan.py": f"import {imported}\n"}
    found = [each.url for each in tree(files).python.pip_guessed if each.url]
    assert found == ([f"git+https://github.com/lab/{name}.git@{COMMIT}"] if cloned else [])
