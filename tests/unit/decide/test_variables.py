"""A variable that a page exports, and that the build or a launch file reads, is set in the image."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.gather import gather
from roslab.plan.plan import make_plan
from roslab.render.dockerfile import dockerfile
from roslab.repository.checkout import Repository

Tree = Callable[[dict[str, str]], Decision]
BUILT = {
    "package.xml": (
        '<package format="3"><name>imu_node</name><buildtool_depend>ament_cmake</buildtool_depend>'
        "<export><build_type>ament_cmake</build_type></export></package>"
    ),
    "CMakeLists.txt": (
        "project(imu_node)\nfind_package(ament_cmake REQUIRED)\n"
        'string(COMPARE EQUAL "imu-1" $ENV{DEVICE} IS_ONE)\nmessage($ENV{HOME} $ENV{ROS_DISTRO})\n'
    ),
    "launch/start.launch.py": "from launch import LaunchDescription\nimport os\nmodel = os.environ['ROBOT_MODEL']\n",
}


@pytest.mark.parametrize(
    ("page", "found"),
    [
        ("export DEVICE={one of these}\n```\n```\nexport DEVICE=imu-1\ncolcon build\n", (("DEVICE", "imu-1"),)),
        ("export DEVICE=imu-2\nexport DEVICE=imu-1\n", (("DEVICE", "imu-2"),)),
        ('$ export ROBOT_MODEL="burger"\n', (("ROBOT_MODEL", "burger"),)),
        ("export ROBOT_MODEL=burger   # with a camera\n", (("ROBOT_MODEL", "burger"),)),
        ("export ROBOT_MODEL=burger#1\n", ()),
        ("export ROS_DISTRO=humble\nexport HOME=here\nexport OTHER=1\nexport DEVICE=$1\n", ()),
    ],
)
def test_what_a_page_exports_and_the_tree_reads(tree: Tree, page: str, found: tuple[tuple[str, str], ...]) -> None:
    assert tree({**BUILT, "README.md": f"```\n{page}```\n"}).variables == found


@pytest.mark.parametrize(
    ("folder", "written", "found"),
    [
        ("src/demo/doc/", "$(env ARM)", (("ARM", "one"),)),
        ("src/demo/doc/", "$(optenv ARM two)", ()),
        ("src/demo/arm/", "$(env ARM)", ()),
    ],
)
def test_a_page_of_a_documentation_folder_sets_what_a_launch_file_stops_without(
    tree: Tree, folder: str, written: str, found: tuple[tuple[str, str], ...]
) -> None:
    launch = f'<launch><arg name="arm" value="{written}"/></launch>\n'
    files = {"README.md": "# Demo\n", f"{folder}installation.md": "```\nexport ARM=one\nexport LEG=two\n```\n"}
    package = BUILT["package.xml"].replace("ament_cmake", "catkin")
    assert tree({"src/demo/package.xml": package, "src/demo/launch/a.launch": launch, **files}).variables == found


def test_the_build_has_the_variable(tree: Tree) -> None:
    decision = tree({**BUILT, "README.md": "```\nexport DEVICE=imu-1\ncolcon build\n```\n"})
    text = dockerfile(make_plan(decision, Config(), folder_name="demo"))
    assert 0 < text.index("ENV DEVICE=imu-1") < text.index("install-rosdep-keys /tmp/manifests")
    assert text.index("ENV DEVICE=imu-1") < text.index("colcon build")


def test_roslab_yaml_has_the_last_word(tmp_path: Path) -> None:
    for name, text in {**BUILT, "README.md": "```\nexport DEVICE=imu-1\ncolcon build\n```\n"}.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    config = Config(env=(("DEVICE", "imu-2"),))
    found = decide(gather(Repository.open(tmp_path)), config, folder_name="demo")
    assert found.variables == (("DEVICE", "imu-2"),)


MODELS = {**BUILT, "models/cup/model.sdf": "<sdf/>\n", "worlds/a.world": "<sdf/>\n"}


@pytest.mark.parametrize(
    ("line", "found"),
    [
        ("export GAZEBO_MODEL_PATH=~/ws/src/demo/models", "./models"),
        ("echo 'export GAZEBO_MODEL_PATH=$GAZEBO_MODEL_PATH:$HOME/ws/src/demo/models' >> ~/.bashrc", "./models"),
        ("export GAZEBO_MODEL_PATH=$(rospack find demo)/models:$PWD/worlds", "./models:./worlds"),
        ("export GAZEBO_MODEL_PATH=/opt/ros/humble/share/other/models", ""),
        ("export GAZEBO_MODEL_PATH=~/other/things", ""),
        ("export SOME_OTHER_PATH=~/ws/src/demo/models", ""),
    ],
)
def test_the_folders_in_which_a_simulator_looks_for_models(tree: Tree, line: str, found: str) -> None:
    decision = tree({**MODELS, "README.md": f"```\n{line}\n```\n"})
    assert decision.variables == ((("GAZEBO_MODEL_PATH", found),) if found else ())


def test_the_image_has_the_folders_of_models(tree: Tree) -> None:
    decision = tree({**MODELS, "README.md": "```\nexport GAZEBO_MODEL_PATH=~/ws/src/demo/models:.\n```\n"})
    text = dockerfile(make_plan(decision, Config(), folder_name="demo"))
    here = "/home/${NB_USER}/ws/src/demo"
    assert f'ENV GAZEBO_MODEL_PATH="{here}/models:{here}"\n' in text


PROGRAM = {"train.py": "import numpy\nif __name__ == '__main__':\n    print(1)\n", "requirements.txt": "numpy\n"}


@pytest.mark.parametrize(
    ("page", "found"),
    [
        ("MUJOCO_GL=egl CUDA_VISIBLE_DEVICES=0 python train.py", (("MUJOCO_GL", "egl"),)),
        ("$ MUJOCO_GL='egl' python train.py\nMUJOCO_GL=osmesa python train.py", (("MUJOCO_GL", "egl"),)),
        ("HYDRA_FULL_ERROR=1 OMP_NUM_THREADS=4 torchrun --nproc_per_node=1 train.py", (("HYDRA_FULL_ERROR", "1"),)),
        ("LOCAL_RANK=0 WANDB_API_KEY=abc LD_PRELOAD=a.so PYTHONPATH=. python train.py", ()),
        ("export MUJOCO_GL=egl\npython train.py", (("MUJOCO_GL", "egl"),)),
        ("export MUJOCO_GL=egl\nMUJOCO_GL=osmesa python train.py", (("MUJOCO_GL", "osmesa"),)),
        ("export NETS=$PWD/nets/\n```\nand\n```\npython train.py", (("NETS", "./nets"),)),
        ("export DEMO_ROOT=`pwd`\npython train.py", (("DEMO_ROOT", "./"),)),
        ("export NETS=$PWD/others\nexport LANG=C\nexport CUDA_VISIBLE_DEVICES=0\npython train.py", ()),
        ("export NETS=/home/me/nets\nexport OLD=$NETS\nexport RMW_IMPLEMENTATION=a\npython train.py", ()),
        ("python train.py\nexport MUJOCO_GL=egl", ()),
        ("export MUJOCO_GL=egl\n```\n# Train\n```\npython train.py", ()),
        ("DATA=/home/me/data CACHE=<path> MODE=$1 python train.py", ()),
        ("python train.py\nDEBUG=1 python train.py --more", ()),
    ],
)
def test_the_default_command_has_the_variables_before_it(
    tree: Tree, page: str, found: tuple[tuple[str, str], ...]
) -> None:
    files = {**PROGRAM, "nets/a.yaml": "", "README.md": f"# Usage\n```\n{page}\n```\n"}
    assert tree(files).variables == found


def test_another_command_on_the_page_sets_nothing(tree: Tree) -> None:
    page = "# Usage\n```\npython train.py\n```\n# Convert\n```\nFORMAT=bag python convert.py\n```\n"
    assert tree({**PROGRAM, "convert.py": PROGRAM["train.py"], "README.md": page}).variables == ()


@pytest.mark.parametrize(
    ("package", "found"),
    [
        ('<depend condition="$ARM == six">arm_six</depend>', (("ARM", "six"),)),
        ("<depend>arm_six</depend>", ()),
    ],
)
def test_a_condition_of_a_package_reads_a_variable(
    tree: Tree, package: str, found: tuple[tuple[str, str], ...]
) -> None:
    xml = BUILT["package.xml"].replace("<export>", f"{package}<export>")
    assert tree({**BUILT, "package.xml": xml, "README.md": "```\nexport ARM=six\n```\n"}).variables == found


def test_a_variable_that_a_sister_repository_reads(tree: Tree) -> None:
    page = "```\nexport GZ_VERSION=harmonic\ncolcon build\n```\n"
    assert tree({**BUILT, "README.md": page}).variables == (("GZ_VERSION", "harmonic"),)


EXTENSION = """\
import os
from setuptools import setup
from torch.utils.cpp_extension import CUDAExtension
include = os.path.join(os.environ["CUDA_HOME"], "include")
setup(name="ops", ext_modules=[CUDAExtension("ops", ["ops.cu"])])
"""


def test_an_image_with_the_compiler_of_cuda_tells_where_it_is(tree: Tree) -> None:
    decision = tree({"setup.py": EXTENSION, "ops.cu": "", "requirements.txt": "torch==1.13.1\n"})
    assert "-devel" in decision.base_image
    assert decision.variables == (("CUDA_HOME", "/usr/local/cuda"),)


@pytest.mark.parametrize(
    "files",
    [
        {"requirements.txt": "torch==1.13.1\n", "main.py": "import torch\n"},
        {"requirements.txt": "numpy\n", "main.py": "import numpy\n"},
    ],
    ids=["no-compiler", "no-cuda"],
)
def test_others_have_none(tree: Tree, files: dict[str, str]) -> None:
    decision = tree(files)
    assert "-devel" not in decision.base_image
    assert not decision.variables


def test_the_compiler_of_a_conda_environment_is_left_to_be_found(tree: Tree) -> None:
    packages = "".join(f"  - {each}\n" for each in ("python=3.10", "pytorch=2.1", "cuda-nvcc=12.1"))
    environment = f"channels: [conda-forge]\ndependencies:\n{packages}"
    decision = tree({"setup.py": EXTENSION, "ops.cu": "", "environment.yml": environment})
    assert "-devel" in decision.base_image
    assert not decision.variables


@pytest.mark.parametrize(
    ("files", "found"),
    [
        ({"requirements.txt": "mujoco==3.2.0\n", "main.py": "import mujoco\n"}, (("MUJOCO_GL", "egl"),)),
        ({"requirements.txt": "dm_control\n", "main.py": "import dm_control\n"}, (("MUJOCO_GL", "egl"),)),
        (
            {
                "requirements.txt": "mujoco\n",
                "main.py": "import mujoco\nimport mujoco.viewer\nmujoco.viewer.launch()\n",
            },
            (),
        ),
        ({"requirements.txt": "numpy\n", "main.py": "import numpy\n"}, ()),
    ],
    ids=["mujoco", "dm_control", "window", "neither"],
)
def test_what_draws_without_a_window_is_told_so(
    tree: Tree, files: dict[str, str], found: tuple[tuple[str, str], ...]
) -> None:
    assert tree({**files, "README.md": "# Demo\n## Usage\n```\npython main.py\n```\n"}).variables == found


MAKE = "import gym\nimport mujoco_py\n\ndef main(show):\n    env = gym.make('Ant-v2')\n    while True:\n"


@pytest.mark.parametrize(
    ("code", "gui"),
    [
        (f"{MAKE}        env.render()\n", True),
        (f"{MAKE}        if env.step(0):\n            break\n        env.render(mode='human')\n", True),
        (f"{MAKE}        env.render('rgb_array')\n", False),
        (f"{MAKE}        if show:\n            time.sleep(1)\n            env.render()\n", False),
        (f"{MAKE.replace('main(show)', 'render(self)')}        env.render()\n", False),
        (MAKE.replace("v2'", "v4', render_mode=None") + "        env.render()\\n", False),
        (MAKE.replace("v2'", "v4', render_mode='human'") + "        pass\\n", True),
    ],
)
def test_a_window_of_an_environment_needs_what_its_library_needs(tree: Tree, code: str, gui: bool) -> None:
    files = {"requirements.txt": "gym\nmujoco-py==2.0.2.7\n", "main.py": code}
    decision = tree({**files, "README.md": "# Demo\n## Usage\n```\npython main.py\n```\n"})
    assert (decision.gui, ("LD_PRELOAD", "libGLEW.so") in decision.variables) == (gui, gui)


def test_a_window_of_another_library_changes_nothing_where_it_draws(tree: Tree) -> None:
    code = "import matplotlib.pyplot as plt\nimport mujoco_py\nplt.show()\n"
    files = {"requirements.txt": "matplotlib\nmujoco-py==2.0.2.7\n", "main.py": code}
    decision = tree({**files, "README.md": "# Demo\n## Usage\n```\npython main.py\n```\n"})
    assert (decision.gui, decision.variables) == (True, ())


def test_a_page_says_how_to_draw(tree: Tree) -> None:
    files = {"requirements.txt": "mujoco\n", "main.py": "import mujoco\n"}
    page = "# Demo\n## Usage\n```\nMUJOCO_GL=osmesa python main.py\n```\n"
    assert tree({**files, "README.md": page}).variables == (("MUJOCO_GL", "osmesa"),)


@pytest.mark.parametrize(
    ("line", "found"),
    [
        ("export DEMO_ROOT=$(pwd)/tools", (("DEMO_ROOT", "./tools"),)),
        ('export AGENT="[LINK TO DEMO REPO]/tools/agent.py"', (("AGENT", "./tools/agent.py"),)),
        ("export A=./tools\nexport B=${A}/agent.py", ()),  # a name of one letter is the reader's own
        ("export AA1=./tools\nexport AA2=${AA1}/agent.py", (("AA1", "./tools"), ("AA2", "./tools/agent.py"))),
        ("export BOARD=[LINK TO THIS REPO]/board/data", (("BOARD", "./board/data"),)),
        ("export CARLA_ROOT=[LINK TO YOUR CARLA FOLDER]/tools", ()),
        ("export DATA_ROOT=$(pwd)/data\nexport TOP=$(pwd)\nexport ROS_X=$(pwd)/tools", ()),
    ],
)  # fmt: skip
def test_a_place_of_the_tree_that_a_page_exports(tree: Tree, line: str, found: tuple[tuple[str, str], ...]) -> None:
    modules = '[submodule "board"]\n\tpath = board\n\turl = https://github.com/a/board.git\n'
    files = {**BUILT, "tools/agent.py": "", ".gitmodules": modules, "README.md": f"# imu_node\n```\n{line}\n```\n"}
    assert tree(files).variables == found


@pytest.mark.parametrize("package", ["drake-dev", "other-dev"])
def test_the_folder_in_opt_of_a_package_that_the_page_installs(tree: Tree, package: str) -> None:
    version = "python$(python3 -c 'import sys; print(\"{0}.{1}\".format(*sys.version_info))')"
    lines = (
        f"sudo apt-get install {package}",
        'export PATH="/opt/drake/bin${PATH:+:${PATH}}"',
        f'export PYTHONPATH="/opt/drake/lib/{version}/site-packages${{PYTHONPATH:+:${{PYTHONPATH}}}}"',
        "export PATH=/opt/ros/jazzy/bin:$PATH",
    )
    page = "Tested with ROS 2 Jazzy.\n```\n" + "\n".join(lines) + "\n```\n"
    decision = tree({**BUILT, "README.md": page})
    paths = (("PATH", "/opt/drake/bin"), ("PYTHONPATH", "/opt/drake/lib/python3.12/site-packages"))
    assert decision.variables == (paths if package == "drake-dev" else ())
    text = dockerfile(make_plan(decision, Config(), folder_name="demo"))
    assert ('PATH="/opt/drake/bin:${PATH}"' in text) is (package == "drake-dev")


def test_a_path_of_python_of_places_that_a_page_exports(tree: Tree) -> None:
    page = 'export A_ROOT=./tools\nexport PYTHONPATH="${CARLA_ROOT}/api":"${A_ROOT}":"${A_ROOT}/more"\n'
    files = {"requirements.txt": "numpy\n", "tools/more/agent.py": "", "README.md": f"```\n{page}```\n"}
    decision = tree(files)
    assert (decision.variables, decision.python_path) == ((("A_ROOT", "./tools"),), ("tools", "tools/more"))
