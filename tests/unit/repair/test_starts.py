"""The commonest messages with which a program of robotics dies at its start in an image that lacks something.

Most were seen: roslaunch, rosrun and rospack of ROS 1, launch and ament_index of ROS 2, Python, matplotlib, Qt and
OpenCV, in a container without what they ask for; the others are quoted from the code that prints them.
"""

from __future__ import annotations

import io
from collections.abc import Mapping
from pathlib import Path

import pytest

from roslab.cli.repairing import given
from roslab.explain.answer import explain
from roslab.pipeline import plan_repository
from roslab.repair.holders import sought
from roslab.repair.repair import repair

PACKAGE = """\
<package format="2"><name>robot</name><version>1.0.0</version><description>d</description>
<maintainer email="a@example.org">a</maintainer><license>MIT</license><buildtool_depend>{}</buildtool_depend></package>
"""
MAIN = "print(1)\n"
TREES: Mapping[str, Mapping[str, str]] = {
    "python": {"main.py": MAIN},
    "noetic": {"package.xml": PACKAGE.format("catkin"), "roslab.yaml": "format: 3\nbase: {ros: noetic}\n"},
    "melodic": {"package.xml": PACKAGE.format("catkin"), "roslab.yaml": "format: 3\nbase: {ros: melodic}\n"},
    "humble": {"package.xml": PACKAGE.format("ament_cmake"), "roslab.yaml": "format: 3\nbase: {ros: humble}\n"},
}
FRAME = 'Traceback (most recent call last):\n  File "/home/jovyan/x/main.py", line 1, in <module>\n'
POPEN = f"""{FRAME}  File "/usr/lib/python3.11/subprocess.py", line 1901, in _execute_child
    raise child_exception_type(errno_num, err_msg, err_filename)
FileNotFoundError: [Errno 2] No such file or directory: '{{}}'
"""
LAUNCH = "[INFO] [launch]: Default logging verbosity is set to INFO\n"
CAUGHT = f"{LAUNCH}[ERROR] [launch]: Caught exception in launch (see debug for traceback): "
NODE = f"""{LAUNCH}[INFO] [main.py-1]: process started with pid [32]
[main.py-1] Traceback (most recent call last):
[main.py-1]   File "/home/jovyan/ws/install/robot/lib/robot/main.py", line 1, in <module>
[main.py-1] ModuleNotFoundError: No module named 'serial'
[ERROR] [main.py-1]: process has died [pid 32, exit code 1, cmd '/home/jovyan/ws/install/robot/lib/robot/main.py'].
"""
CHAIN = f"""{FRAME}ModuleNotFoundError: No module named 'ruamel_yaml'

During handling of the above exception, another exception occurred:

{FRAME}ModuleNotFoundError: No module named 'yaml'
"""
OPEN = "cannot open shared object file: No such file or directory"
REPAIRED = {
    "python: a module of pip": ("python", f"{FRAME}ModuleNotFoundError: No module named 'cv2'", "pip: [opencv-python]"),
    "python: a module of Python 2": ("python", f"{FRAME}ImportError: No module named serial", "pip: [pyserial]"),
    "python: the last of two": ("python", CHAIN, "pip: [PyYAML]"),
    "python: tkinter": ("python", f"{FRAME}ModuleNotFoundError: No module named 'tkinter'", "apt: [python3-tk]"),
    "python: libGL": ("python", f"{FRAME}ImportError: libGL.so.1: {OPEN}", "apt: [libgl1]"),
    "python: ctypes": ("python", f"{FRAME}OSError: libportaudio.so.2: {OPEN}", "apt: [libportaudio2]"),
    "python: numpy 1": (
        "python",
        "A module that was compiled using NumPy 1.x cannot be run in\nNumPy 2.2.6 as it may crash.\n",
        "pip: [numpy<2]",
    ),
    "python: np.float": (
        "python",
        f"{FRAME}AttributeError: module 'numpy' has no attribute 'float'.\n",
        "pip: [numpy<1.24]",
    ),
    "python: a program": ("python", POPEN.format("ffmpeg"), "apt: [ffmpeg]"),
    "python: LaTeX": ("python", POPEN.format("latex"), "apt: [texlive-latex-base]"),
    "python: graphviz": (
        "python",
        f"{FRAME}graphviz.backend.execute.ExecutableNotFound: failed to execute PosixPath('dot'), make sure the",
        "apt: [graphviz]",
    ),
    "python: GitPython": ("python", f"{FRAME}ImportError: Bad git executable.\n", "apt: [git]"),
    "python: TkAgg": (
        "python",
        (
            f"{FRAME}ImportError: Cannot load backend 'TkAgg' which requires the 'tk' interactive framework, as "
            "'headless' is currently running\n"
        ),
        "gui: true",
    ),
    "python: no binding of Qt": (
        "python",
        f"{FRAME}ImportError: Failed to import any of the following Qt binding modules: PyQt6, PySide6, PyQt5, PySide2",
        "pip: [PyQt5]",
    ),
    "python: PyOpenGL": (
        "python",
        f"{FRAME}ImportError: ('Unable to load OpenGL library', 'libEGL.so.1: {OPEN}', 'EGL', None)\n",
        "apt: [libegl1]",
    ),
    "Qt: no display": ("python", "qt.qpa.xcb: could not connect to display \n", "gui: true"),
    "Qt 6: xcb-cursor": (
        "python",
        "qt.qpa.plugin: From 6.5.0, xcb-cursor0 or libxcb-cursor0 is needed to load the Qt xcb platform plugin.\n",
        "apt: [libxcb-cursor0]",
    ),
    "C++: a library": (
        "python",
        f"./viewer: error while loading shared libraries: libglfw.so.3: {OPEN}",
        "apt: [libglfw3]",
    ),
    "a script of python": (
        "python",
        "/usr/bin/env: \u2018python\u2019: No such file or directory\n",
        "apt: [python-is-python3]",
    ),
    "a shell": ("python", "run.sh: line 3: ffmpeg: command not found\n", "apt: [ffmpeg]"),
    "docker": (
        "python",
        'docker: Error response from daemon: exec: "ffmpeg": executable file not found in $PATH: unknown.\n',
        "apt: [ffmpeg]",
    ),
    "ROS 1: rospack": ("noetic", "[rospack] Error: package 'tf2_tools' not found\n", "apt: [ros-noetic-tf2-tools]"),
    "ROS 1: find": (
        "noetic",
        "Resource not found: xacro\nROS path [0]=/opt/ros/noetic/share/ros\nThe traceback for the exception",
        "apt: [ros-noetic-xacro]",
    ),
    "ROS 1: a node": (
        "noetic",
        (
            "ERROR: cannot launch node of type [robot_state_publisher/robot_state_publisher]: robot_state_publisher\n"
            "ROS path [0]=/opt/ros/noetic/share/ros\n"
        ),
        "apt: [ros-noetic-robot-state-publisher]",
    ),
    "ROS 1: a launch file": (
        "noetic",
        "RLException: [amcl_diff.launch] is neither a launch file in package [amcl] nor is [amcl] a launch file name\n",
        "apt: [ros-noetic-amcl]",
    ),
    "ROS 1: xacro": (
        "noetic",
        (
            "RLException: Invalid <param> tag: Cannot load command parameter [robot_description]: no such command "
            "[['xacro', '/ws/a.xacro']]. \n"
        ),
        "apt: [ros-noetic-xacro]",
    ),
    "ROS 1: a module": (
        "noetic",
        f"{FRAME}ModuleNotFoundError: No module named 'tf2_geometry_msgs'\n",
        "apt: [ros-noetic-tf2-geometry-msgs]",
    ),
    "ROS 1: a module that apt has": (
        "noetic",
        f"{FRAME}ModuleNotFoundError: No module named 'cv2'\n",
        "apt: [python3-opencv]",
    ),
    "ROS 1: a module of Python 2 that apt has": (
        "melodic",
        f"{FRAME}ImportError: No module named serial\n",
        "apt: [python-serial]",
    ),
    "ROS 1: a plugin": (
        "noetic",
        (
            "[FATAL] [1.5]: Exception: According to the loaded plugin descriptions the class "
            "teb_local_planner/TebLocalPlannerROS with base class type nav_core::BaseLocalPlanner does not exist. "
        ),
        "apt: [ros-noetic-teb-local-planner]",
    ),
    "ROS 2: a share directory": (
        "humble",
        f"{FRAME}ament_index_python.packages.PackageNotFoundError: \"package 'nav2_bringup' not found, searching: ['/",
        "apt: [ros-humble-nav2-bringup]",
    ),
    "ROS 2: run": ("humble", "Package 'teleop_twist_keyboard' not found\n", "apt: [ros-humble-teleop-twist-keyboard]"),
    "ROS 2: xacro": (
        "humble",
        f"{CAUGHT}file not found: [Errno 2] No such file or directory: 'xacro'\n",
        "apt: [ros-humble-xacro]",
    ),
    "ROS 2: a node": ("humble", NODE, "apt: [python3-serial]"),
    "ROS 2: a module": (
        "humble",
        NODE.replace("serial", "tf_transformations"),
        "apt: [ros-humble-tf-transformations]",
    ),
    "ROS 2: an implementation of rmw": (
        "humble",
        f"failed to load shared library 'librmw_cyclonedds_cpp.so' due to dlopen: librmw_cyclonedds_cpp.so: {OPEN}",
        "apt: [ros-humble-rmw-cyclonedds-cpp]",
    ),
}
LEFT = {
    "a camera": ("python", "[ WARN:0] open VIDEOIO(V4L2:/dev/video0): can't open camera by index\n", "device-missing"),
    "a port": (
        "python",
        "serial.serialutil.SerialException: [Errno 2] could not open port /dev/ttyUSB0: [Errno 2] No such file\n",
        "no-gpu",
    ),
    "a GPU": ("python", "RuntimeError: No CUDA GPUs are available\n", "no-gpu"),
    "the driver of a GPU": ("python", f"{FRAME}ImportError: libcuda.so.1: {OPEN}", "no-gpu"),
    "an argument": (
        "python",
        "usage: main.py [-h] --bag BAG\nmain.py: error: the following arguments are required: --bag\n",
        "argument-missing",
    ),
    "an argument of a launch file": (
        "noetic",
        "RLException: [/ws/a.launch] requires the 'bag' arg to be set\n",
        "argument-missing",
    ),
    "an argument of a launch file of ROS 2": (
        "humble",
        f'{CAUGHT}Required launch argument "bag" was not provided.\n',
        "argument-missing",
    ),
    "a roscore": ("noetic", "ERROR: Unable to communicate with master!\n", "no-roscore"),
    "data": (
        "python",
        f"{FRAME}FileNotFoundError: [Errno 2] No such file or directory: 'data/00.bag'\n",
        "python-file-missing",
    ),
    "the right to be executed": (
        "noetic",
        "ERROR: cannot launch node of type [robot/a.py]: Cannot locate node of type [a.py] in package [robot]. Make",
        "ros-executable-missing",
    ),
    "line endings": ("python", "/usr/bin/env: \u2018python3\\r\u2019: No such file or directory\n", "line-endings"),
    "code for Python 2": ("python", f"{FRAME}ModuleNotFoundError: No module named 'urllib2'\n", "python-print"),
    "a Python that was compiled without libffi": (
        "python",
        f"{FRAME}ModuleNotFoundError: No module named '_ctypes'\n",
        "python-built-without",
    ),
    "a package that nobody released": (
        "noetic",
        "Resource not found: robot_of_nobody\nROS path [0]=/opt/ros/noetic/share/ros\n",
        "ros-package-not-found",
    ),
    "the repository's own package": (
        "noetic",
        "[rospack] Error: package 'robot' not found\n",
        "ros-package-not-found",
    ),
    "a program that a launch file hides": (
        "humble",
        (
            f"{CAUGHT}executable '[<launch.substitutions.text_substitution.TextSubstitution object at 0x7f>]' not "
            "found on the PATH\n"
        ),
        "launch-program-missing",
    ),
}


def tree(folder: Path, files: Mapping[str, str]) -> Path:
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return folder


@pytest.mark.parametrize("case", REPAIRED.values(), ids=REPAIRED)
def test_what_an_image_lacks_is_added(tmp_path: Path, case: tuple[str, str, str]) -> None:
    kind, log, wanted = case
    answer = explain(io.BytesIO(log.encode()))
    found = repair(answer, given(plan_repository(tree(tmp_path / "x", TREES[kind])))).starting
    assert [str(change) for change in found.certain.changes] == [wanted]


@pytest.mark.parametrize("case", LEFT.values(), ids=LEFT)
def test_what_an_image_cannot_bring_is_only_told(tmp_path: Path, case: tuple[str, str, str]) -> None:
    kind, log, identity = case
    answer = explain(io.BytesIO(log.encode()))
    found = repair(answer, given(plan_repository(tree(tmp_path / "x", TREES[kind])))).starting
    assert [one.id for one in answer.explanations] == [identity]
    assert found.certain.changes == ()
    assert not sought(answer)


UTILS = f"{FRAME.replace('main.py', 'tools/train.py')}ModuleNotFoundError: No module named 'utils'\n"
YAML = UTILS.replace("utils", "yaml")


@pytest.mark.parametrize(
    ("files", "log", "wanted"),
    [
        (("lib/utils.py",), UTILS, ["env.PYTHONPATH: /home/jovyan/x/lib"]),
        (("utils/__init__.py",), UTILS, ["env.PYTHONPATH: /home/jovyan/x"]),
        (("tools/core/utils/a.py",), UTILS, ["env.PYTHONPATH: /home/jovyan/x/tools/core"]),
        (("utils.py", "lib/utils.py"), UTILS, ["env.PYTHONPATH: /home/jovyan/x"]),  # above the program
        (("lib/utils.py", "src/utils.py"), UTILS, []),
        (("tests/utils.py",), UTILS, []),
        (("a:b/utils.py",), UTILS, []),  # two folders for PYTHONPATH
        (("utils/setup.py", "utils/main.py"), UTILS, []),  # a project, no module
        (("yaml/__init__.py",), YAML, ["env.PYTHONPATH: /home/jovyan/x"]),
        (("lib/yaml.py",), YAML, ["pip: [PyYAML]"]),  # a name that it has by chance
        (("lib/utils.py",), UTILS.replace("'utils'", "'utils.boxes'"), []),
    ],
)
def test_a_module_of_the_repository_is_found_in_its_folder(
    tmp_path: Path, files: tuple[str, ...], log: str, wanted: list[str]
) -> None:
    names = dict.fromkeys((*files, "main.py", "tools/train.py"), MAIN)
    names["requirements.txt"] = ""
    found = repair(explain(io.BytesIO(log.encode())), given(plan_repository(tree(tmp_path / "x", names))))
    assert [str(change) for change in found.certain.changes] == wanted


@pytest.mark.parametrize(
    ("file", "wanted"),
    [
        ("/opt/venv/lib/python3.10/site-packages/boxes/nms.py", []),
        (
            "/home/jovyan/ws/install/x/lib/python3.10/site-packages/tools/train.py",
            ["env.PYTHONPATH: /home/jovyan/x/lib"],
        ),
        ("/usr/lib/python3.10/importlib/__init__.py", ["env.PYTHONPATH: /home/jovyan/x/lib"]),
    ],
)
def test_what_a_package_from_elsewhere_imports_is_no_module_of_the_repository(
    tmp_path: Path, file: str, wanted: list[str]
) -> None:
    names = {"lib/utils.py": MAIN, "tools/train.py": MAIN, "requirements.txt": ""}
    log = UTILS.replace("ModuleNotFound", f'  File "{file}", line 3, in <module>\nModuleNotFound')
    found = repair(explain(io.BytesIO(log.encode())), given(plan_repository(tree(tmp_path / "x", names))))
    assert [str(change) for change in found.certain.changes] == wanted


def test_an_image_without_ros_is_told_so(tmp_path: Path) -> None:
    log = f"{FRAME}ModuleNotFoundError: No module named 'cv_bridge'\n".encode()
    found = repair(explain(io.BytesIO(log)), given(plan_repository(tree(tmp_path / "x", TREES["python"]))))
    assert found.changes == ()
    assert [why for _, why in found.refused] == [
        "cv_bridge is of ROS, and this image has none: `base.ros` in roslab.yaml names one"
    ]


@pytest.mark.parametrize(
    ("line", "wanted"),
    [("pyyaml==6.0", []), ('PyYAML; python_version < "3"', ["pip: [PyYAML]"]), ("six", ["pip: [PyYAML]"])],
)
def test_what_a_list_installs_is_not_installed_again(tmp_path: Path, line: str, wanted: list[str]) -> None:
    names = {"tools/train.py": MAIN, "requirements.txt": f"{line}\n"}
    found = repair(explain(io.BytesIO(YAML.encode())), given(plan_repository(tree(tmp_path / "x", names))))
    assert [str(change) for change in found.changes] == wanted
    told = "PyYAML is installed (requirements.txt:1), and the Python that is started finds no yaml"
    assert [why for _, why in found.refused] == ([] if wanted else [told])


def test_the_folders_that_python_looks_into_already_stay(tmp_path: Path) -> None:
    names = {"lib/utils.py": MAIN, "tools/train.py": MAIN, "roslab.yaml": "format: 3\nenv:\n  PYTHONPATH: /opt/a\n"}
    planned = plan_repository(tree(tmp_path / "x", names))
    (change,) = repair(explain(io.BytesIO(UTILS.encode())), given(planned)).changes
    assert change.value == "/home/jovyan/x/lib:/opt/a"
    step = f'#6 [3/4] RUN python tools/train.py\n#6 1.2 {UTILS.splitlines()[-1]}\n#6 ERROR: process "/bin/sh" did\n'
    found = repair(explain(io.BytesIO(step.encode())), given(planned))
    assert found.changes == ()
    assert "utils lies in lib: run the step there" in found.refused[0][1]


def test_a_program_of_the_repository_is_not_looked_for_elsewhere(tmp_path: Path) -> None:
    names = {"CMakeLists.txt": "project(x)\nadd_executable(planner main.cpp)\n", "main.cpp": "int main() {}\n"}
    answer = explain(io.BytesIO(b"run.sh: line 3: planner: command not found\n"))
    found = repair(answer, given(plan_repository(tree(tmp_path / "x", names))))
    assert found.changes == ()
    assert "planner is a program of this repository" in found.refused[0][1]
