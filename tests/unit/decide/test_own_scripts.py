"""Scripts of the tree with which the README of a Python project compiles something are run in the image."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.decide.system.run_by_pages import WITHOUT_APT

Tree = Callable[[dict[str, str]], Decision]
CODE = {"play.py": "import numpy\n"}
MAKE = "cd src\nnvcc -c a.cu\npython setup.py build_ext --inplace\n"
SETUP = "from setuptools import Extension, setup\nsetup(name='ops', ext_modules=[Extension('ops', ['a.cpp'])])\n"
DEEP = {".gitmodules": '[submodule "DCN"]\n\tpath = src/lib/nets/DCN\n\turl = https://github.com/a/DCN.git\n'}
MODULE = {".gitmodules": '[submodule "planner"]\n\tpath = planner\n\turl = https://github.com/a/planner.git\n'}


@pytest.mark.parametrize(
    ("files", "page", "scripts"),
    [
        ({"lib/make.sh": MAKE}, "cd lib\nsh make.sh\n", [("lib", "lib/make.sh", "bash make.sh")]),
        ({"lib/make.sh": MAKE}, "cd demo/lib && ./make.sh 3\n", [("lib", "lib/make.sh", "bash make.sh 3")]),
        ({"build.py": "run('cmake ..')\n"}, "python build.py\n", [("", "build.py", "python3 build.py")]),
        ({"lib/make.sh": "sudo make install\n"}, "bash lib/make.sh\n", []),
        ({"build.sh": "sudo apt-get update && sudo make install\n"}, "./build.sh\n", []),
        (
            {"build.sh": "sudo apt-get install -y libeigen3-dev cmake\nmkdir -p build\ncd build\ncmake ..\nmake\n"},
            "./build.sh\n",
            [("", "build.sh", f"bash -c '{WITHOUT_APT} && bash build.sh'")],
        ),
        ({"build_data.py": "import numpy\n"}, "python build_data.py\n", []),
        ({"make_video.py": "import numpy  # make a video\ncmd = 'ffmpeg make'\n"}, "python make_video.py\n", []),
        (
            {"make_ops.py": "import subprocess\nsubprocess.run(['cmake', '..'])\n"},
            "python make_ops.py\n",
            [("", "make_ops.py", "python3 make_ops.py")],
        ),
        (
            {"build_ops.py": "import os\nos.system(f'cd {there} && make -j4')\n"},
            "python build_ops.py\n",
            [("", "build_ops.py", "python3 build_ops.py")],
        ),
        (
            {"compile_wrappers.py": "from distutils.core import setup\nsetup(name='a')\n"},
            "python compile_wrappers.py\n",
            [("", "compile_wrappers.py", "python3 compile_wrappers.py")],
        ),
        (
            {"build_ffi.py": "from cffi import FFI\nbuilder = FFI()\n"},
            "python build_ffi.py\n",
            [("", "build_ffi.py", "python3 build_ffi.py")],
        ),
        (
            {"build_knn.py": "from torch.utils.cpp_extension import load\nload('knn', ['knn.cu'])\n"},
            "python build_knn.py\n",
            [("", "build_knn.py", "python3 build_knn.py")],
        ),
        ({}, "sh make.sh\n", []),
        (MODULE, "./planner/build.py\n", [("", "planner/build.py", "python3 planner/build.py")]),
        (MODULE, "cd demo/planner && ./build.sh\n", [("planner", "planner/build.sh", "bash build.sh")]),
        (MODULE, "./planner/install.sh\n", []),
        (
            DEEP,
            "cd $DEMO_ROOT/src/lib/nets/\ncd DCN\n./make.sh\n",
            [("src/lib/nets/DCN", "src/lib/nets/DCN/make.sh", "bash make.sh")],
        ),
        (DEEP, "cd other\n./make.sh\n", []),
        (
            {"net/ops/nms/setup.py": SETUP},
            "cd DEMO/net/ops/nms\npython setup.py build_ext --inplace\n",
            [("net/ops/nms", "net/ops/nms/setup.py", "python3 setup.py build_ext --inplace")],
        ),
        (
            {"net/ops/nms/setup.py": SETUP},
            "cd $ROOT/net/ops/nms\npython setup.py build_ext --inplace\n",
            [("net/ops/nms", "net/ops/nms/setup.py", "python3 setup.py build_ext --inplace")],
        ),
        (
            {"net/ops/nms/setup.py": SETUP, "net/old/nms/setup.py": SETUP},
            "cd $ROOT/net/ops/nms\npython setup.py build_ext --inplace\n",
            [],
        ),
        (
            {"tools/mesh_setup.py": "from Cython.Build import cythonize\n"},
            "python tools/mesh_setup.py build_ext -i\n",
            [("", "tools/mesh_setup.py", "python3 tools/mesh_setup.py build_ext -i")],
        ),
        ({"setup.py": SETUP}, "python setup.py build_ext --inplace\n", []),
        ({"net/ops/nms/setup.py": SETUP}, "cd net/ops/nms\npython setup.py build_ext\n", []),
        ({"lib/make.sh": MAKE, "setup.cfg": "", "roslab.yaml": ""}, "# Docker\nsh lib/make.sh\n", []),
    ],
)
def test_what_the_readme_compiles_by_a_script(
    tree: Tree, files: dict[str, str], page: str, scripts: list[tuple[str, str, str]]
) -> None:
    fence = "" if page.startswith("#") else "```\n"
    readme = f"{fence}{page}{fence}".replace("# Docker\n", "# Docker\n```\n")
    found = tree({**CODE, **files, "README.md": readme})
    assert [(each.folder, each.path, each.command) for each in found.scripts] == scripts


def test_a_program_of_python_whose_name_begins_like_a_builds_is_started(tree: Tree) -> None:
    code = "# make a video\nimport numpy\nif __name__ == '__main__':\n    run()\n"
    found = tree({"make_video.py": code, "README.md": "# Run\n```\npython make_video.py --fps 30\n```\n"})
    assert found.scripts == ()
    assert ("python", "make_video.py", "--fps", "30") in found.command_candidates


def test_a_package_of_ros_is_compiled_by_its_build_tool(tree: Tree) -> None:
    manifest = "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>"
    files = {"package.xml": manifest, "CMakeLists.txt": "project(demo)\nfind_package(catkin)\n", "make.sh": MAKE}
    assert not tree({**files, "README.md": "```\nsh make.sh\n```\n"}).scripts


@pytest.mark.parametrize(
    ("files", "page", "scripts"),
    [
        ({"3rdparty/suite/build.sh": "make install\n"}, "cd 3rdparty/suite; ./build.sh\n", ["3rdparty/suite/build.sh"]),
        (MODULE, "cd planner && ./build.sh\n", ["planner/build.sh"]),
        (MODULE | {"planner/build.sh": "make\n"}, "cd planner && ./build.sh\n", ["planner/build.sh"]),
        ({"build.sh": "mkdir build\ncd build\ncmake ..\n"}, "./build.sh\n", []),
        ({"3rdparty/suite/build.sh": "make\n"}, "./build.sh\n", []),
    ],
)
def test_what_the_readme_of_a_c_plus_plus_project_compiles_by_a_script(
    tree: Tree, files: dict[str, str], page: str, scripts: list[str]
) -> None:
    made = {"CMakeLists.txt": "project(demo CXX)\nadd_executable(demo a.cpp)\n", "a.cpp": "int main() {}\n"}
    found = tree({**made, **files, "README.md": f"Build the libraries by running `{page.strip()}`.\n"})
    assert (found.kind, [each.path for each in found.scripts]) == ("cpp", scripts)
    assert "clang" not in found.apt_guessed


def test_the_compiler_that_a_script_names_is_installed(tree: Tree) -> None:
    made = {"CMakeLists.txt": "project(demo CXX)\nadd_executable(demo a.cpp)\n", "a.cpp": "int main() {}\n"}
    script = {"3rdparty/suite/build.sh": ': "${CXX:=clang++}"\nexport CXX\nmake install\n'}
    found = tree({**made, **script, "README.md": "```\n./3rdparty/suite/build.sh\n```\n"})
    assert "clang" in found.apt_guessed


def test_a_library_that_a_script_compiles_with_cmake_is_compiled_once(tree: Tree) -> None:
    made = {"CMakeLists.txt": "project(demo CXX)\nadd_executable(demo a.cpp)\n", "a.cpp": "int main() {}\n"}
    library = {
        "third_party/words/CMakeLists.txt": "project(words CXX)\nadd_library(words w.cpp)\n",
        "third_party/words/build.sh": "mkdir -p build && cd build && cmake .. && make\n",
    }
    page = "```\ncd third_party/words\nmkdir build && cd build && cmake .. && make\n```\n"
    page += "Or run `cd third_party/words; ./build.sh`.\n"
    found = tree({**made, **library, "README.md": page})
    assert ([folder for folder, _ in found.inside], found.scripts) == (["third_party/words"], ())


@pytest.mark.parametrize("verb", ["install", "develop", "build develop"])
def test_a_page_installs_the_folder_that_it_goes_to(tree: Tree, verb: str) -> None:
    page = f"```\npip install -r requirements.txt\ncd demo/net/lib/ops\npython setup.py {verb}\n```\n"
    found = tree({**CODE, "requirements.txt": "numpy\n", "net/lib/ops/setup.py": SETUP, "README.md": page})
    assert (found.python.projects, found.scripts) == (("net/lib/ops",), ())


def test_what_a_script_that_is_run_installs_is_not_installed_before(tree: Tree) -> None:
    script = "cd net/lib/ops\npython setup.py install\n"
    files = {"net/lib/ops/setup.py": SETUP, "build_and_install.sh": script, "requirements.txt": "numpy\n"}
    found = tree({**CODE, **files, "README.md": "```\nsh build_and_install.sh\n```\n"})
    assert (found.python.projects, [each.path for each in found.scripts]) == ((), ["build_and_install.sh"])


@pytest.mark.parametrize(("extension", "gpus"), [("CUDAExtension", "6.1;7.0;7.5;8.0;8.6+PTX"), ("CppExtension", "")])
def test_extensions_of_torch_that_a_script_compiles_see_no_gpu(tree: Tree, extension: str, gpus: str) -> None:
    setup = f"from setuptools import setup\nfrom torch.utils.cpp_extension import {extension}\n"
    files = {
        "main.py": "import torch\n",
        "requirements.txt": "torch==1.10.0+cu113\n",
        "net/ops/nms/make.sh": "python setup.py build_ext --inplace\n",
        "net/ops/nms/setup.py": setup + f"setup(name='ops', ext_modules=[{extension}('ops', ['a.cpp'])])\n",
        "README.md": "```\npip install -r requirements.txt\ncd net/ops/nms\nsh make.sh\n```\n",
    }
    found = tree(files)
    assert [each.path for each in found.scripts] == ["net/ops/nms/make.sh"]
    assert found.compiling.architectures == gpus


@pytest.mark.parametrize(
    ("path", "script", "tool"),
    [
        (".ci/build.sh", "set -e\ncd ~/catkin_ws\ncatkin build --limit-status-rate 0.2\n", "catkin_tools"),
        (".ci/build.sh", "cd ~/catkin_ws && catkin_make -j2\n", "catkin_make"),
        ("ci/compile.bash", "catkin build\n", "catkin_tools"),
        (".ci/build.sh", "# catkin build\ncatkin_make\n", "catkin_make"),
        (".ci/build.sh", 'echo "run catkin build"\n', "catkin_make"),
        ("third_party/x/build.sh", "catkin build\n", "catkin_make"),  # another project's
    ],
)
def test_the_tool_of_a_script_that_builds(tree: Tree, path: str, script: str, tool: str) -> None:
    files = {
        "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
        "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
        ".github/workflows/a.yml": f"jobs:\n  build:\n    steps:\n      - run: ./{path}\n",
    }
    assert tree({**files, path: script}).build_tool == tool


def test_a_script_that_calls_apt_runs_behind_another_command(tree: Tree, tmp_path: Path) -> None:
    """So a script that asks for a GPU is told that there is one: ``with-gpu-said bash …``."""
    text = "sudo apt-get install -y no-such-package\ntouch made  # by cmake and make\n"
    decision = tree(
        CODE | {"build.sh": f"{text}cmake --version || make --version || true\n", "README.md": "    ./build.sh\n"}
    )
    assert [script.path for script in decision.scripts] == ["build.sh"]
    (tmp_path / "build.sh").write_text(text, encoding="utf-8")
    subprocess.run(["bash", "-ec", f"env {decision.scripts[0].command}"], cwd=tmp_path, check=True)
    assert (tmp_path / "made").is_file()


BY_INSTALL = """
import subprocess
from setuptools import Command, setup
from setuptools.command.install import install as usual

class install(usual):
    def run(self):
        subprocess.check_call([{tool!r}, "."])
        usual.run(self)

setup(name="arm", packages=["arm"], cmdclass={{{commands}}})
"""


@pytest.mark.parametrize(
    ("tool", "commands", "called"),
    [
        ("cmake", "'install': install", True),
        ("cmake", "'install': install, 'build_ext': Command", False),
        ("cmake", "'develop': install", False),
        ("git", "'install': install", False),
    ],
)
def test_an_install_of_its_own_that_compiles_is_called(tree: Tree, tool: str, commands: str, called: bool) -> None:
    setup = BY_INSTALL.format(tool=tool, commands=commands)
    decision = tree({"arm/__init__.py": "import numpy\n", "setup.py": setup})
    assert decision.python.projects == (".",)
    line = "python3 setup.py install --single-version-externally-managed --record /dev/null"
    assert [each.command for each in decision.scripts] == ([line] if called else [])
