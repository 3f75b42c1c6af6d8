"""The C++ library of PyTorch is unpacked where CMake looks for it."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.decide.platforms import AMD64, ARM64
from roslab.knowledge.libtorch import libtorch_archive
from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import commit, tree_of

Tree = Callable[[dict[str, str]], Decision]
CMAKE = "project(demo CXX)\nfind_package(Torch REQUIRED)\nadd_executable(a a.cpp)\n"
CODE = {"CMakeLists.txt": CMAKE, "a.cpp": "#include <torch/script.h>\nint main() {}\n"}


@pytest.mark.parametrize(
    ("page", "release"),
    [
        ("## Dependencies\n- libtorch (v1.10.2)\n", "1.10.2"),
        ("LibTorch: tested with 1.7\n", "1.7.0"),
        ("wget https://example.org/libtorch-cxx11-abi-shared-with-deps-1.13.1%2Bcpu.zip\n", "1.13.1"),
        ("## Requirements\n- PyTorch 1.6.0\n", "1.6.0"),
        ("```\ngit clone -b v1.0.1 https://github.com/pytorch/pytorch\n```\n", "1.2.0"),
    ],
)
def test_the_release_is_the_pages(tree: Tree, page: str, release: str) -> None:
    decision = tree(CODE | {"README.md": page})
    assert [(each.name, each.zip) for each in decision.source] == [("libtorch", libtorch_archive(release, None))]
    assert decision.platforms == (AMD64,)
    assert dict(decision.platforms_refused).keys() == {ARM64}


CPU = "https://download.pytorch.org/libtorch/{}libtorch-cxx11-abi-shared-with-deps-{}%2Bcpu.zip"


@pytest.mark.parametrize(
    ("files", "release"),
    [
        (
            {".github/workflows/a.yml": f"jobs:\n  a:\n    steps:\n    - run: wget {CPU.format('cpu/', '1.9.1')}\n"},
            "1.9.1",
        ),
        ({"scripts/get.sh": f"wget {CPU.format('lts/1.8/cpu/', '1.8.2')}\n"}, "1.8.2"),
        ({"Dockerfile": f"FROM ubuntu:20.04\nRUN wget {CPU.format('cpu/', '1.13.1')}\n"}, "1.13.1"),
        ({"get.sh": f"wget {CPU.format('cpu/', '1.9.1')}\n", "README.md": "- libtorch 1.10.0\n"}, "1.10.0"),
        ({"README.md": f"Get {CPU.format('lts/1.8/cpu/', '1.8.2')}\n"}, "1.8.2"),
        ({"get.sh": f"wget {CPU.format('cpu/', '1.9.1').replace('cxx11-abi', 'win')}\n", "README.md": "2021\n"}, None),
    ],
)
def test_an_archive_that_scripts_download_is_of_their_release(
    tree: Tree, files: dict[str, str], release: str | None
) -> None:
    (source,) = tree(CODE | files).source
    assert (source.zip == libtorch_archive(release or "1.9.1", None)) is bool(release)


def test_without_a_name_it_is_of_the_last_commits_day(tmp_path: Path) -> None:
    tree_of(tmp_path, CODE)
    commit(tmp_path, "2021-05-01")
    text = dockerfile(plan_repository(tmp_path).plan)
    assert libtorch_archive("1.8.0", None) in text
    assert "curl" in text
    assert "unzip" in text


@pytest.mark.parametrize("line", ["", "find_package(Torch QUIET)\n", "if(WITH_IT)\nfind_package(Torch)\nendif()\n"])
def test_what_does_not_need_it_gets_none(tree: Tree, line: str) -> None:
    files = {"CMakeLists.txt": f"project(demo CXX)\n{line}add_executable(a a.cpp)\n", "a.cpp": "int main() {}\n"}
    decision = tree(files | {"README.md": "libtorch 1.8.1\n"})
    assert not decision.source
    assert decision.platforms == (AMD64, ARM64)


def test_an_archive_for_the_cuda_of_the_image_only_where_there_is_one() -> None:
    assert "/cu118/libtorch-cxx11-abi-shared-with-deps-2.1.0%2Bcu118.zip" in libtorch_archive("2.1.0", "11.8")
    assert "/cu126/libtorch-shared-with-deps-2.8.0%2Bcu126.zip" in libtorch_archive("2.8.0", "12.6")
    assert "/cpu/" in libtorch_archive("2.1.0", "12.4")
    assert "/lts/1.8/cu111/libtorch-cxx11-abi-shared-with-deps-1.8.2%2Bcu111.zip" in libtorch_archive("1.8.2", "11.1")
    assert "/cpu/" in libtorch_archive("1.7.1", "10.2")
    with pytest.raises(ValueError, match=r"1\.0\.1"):
        libtorch_archive("1.0.1", None)


def test_what_is_unpacked_is_installed_where_cmake_finds_it(tmp_path: Path, tree: Tree) -> None:
    """A made-up archive of one file; CMake looks below its own prefixes alone."""
    (prepare,) = [each.prepare for each in tree(CODE).source]
    config = tmp_path / "libtorch/share/cmake/Torch/TorchConfig.cmake"
    config.parent.mkdir(parents=True)
    config.write_text("set(Torch_FOUND TRUE)\n", encoding="utf-8")
    (tmp_path / "libtorch/include").mkdir()
    (tmp_path / "libtorch/lib").mkdir()
    installed = tmp_path / "installed"
    for command, folder in (
        (prepare, "libtorch"),
        ("mkdir build && cd build && cmake .. && make install", "libtorch"),
    ):
        subprocess.run(
            ["bash", "-ec", command],
            cwd=tmp_path / folder,
            check=True,
            env={"DESTDIR": str(installed), "PATH": "/usr/local/bin:/usr/bin:/bin"},
        )
    assert (installed / "etc/ld.so.conf.d/torch.conf").read_text(encoding="utf-8") == "/usr/local/torch/lib\n"
    (tmp_path / "used").mkdir()
    (tmp_path / "used/CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.5)\nproject(a NONE)\n"
        "set(Torch_DIR /home/a/torch)\nfind_package(Torch REQUIRED)\n",
        encoding="utf-8",
    )
    prefix = f"-DCMAKE_SYSTEM_PREFIX_PATH={installed}/usr/local"
    subprocess.run(["cmake", prefix, "."], cwd=tmp_path / "used", check=True)


LUA = "project(x)\nfind_package(Torch REQUIRED)\ninstall(FILES a.lua DESTINATION ${Torch_INSTALL_LUA_PATH_SUBDIR})\n"
PACKAGE = "<package><name>nav</name><buildtool_depend>catkin</buildtool_depend></package>"
NAV = {"nav/package.xml": PACKAGE, "nav/CMakeLists.txt": "project(nav)\nfind_package(catkin REQUIRED)\n"}


def test_torch_of_lua_is_another_library(tree: Tree) -> None:
    decision = tree({"CMakeLists.txt": f"{LUA}add_executable(a a.cpp)\n", "a.cpp": "int main() {}\n"})
    assert not decision.source
    assert any("Torch7" in warning.message for warning in decision.warnings)


def test_a_file_that_the_workspace_never_comes_to_asks_for_nothing(tree: Tree) -> None:
    assert not tree(NAV | CODE).source
    inside = {f"nav/{name}": text for name, text in CODE.items()}
    both = NAV["nav/CMakeLists.txt"] + "find_package(Torch REQUIRED)\n"
    assert [each.name for each in tree(NAV | inside | {"nav/CMakeLists.txt": both}).source] == ["libtorch"]


def test_a_component_of_catkin_that_is_no_package_of_ros_is_the_library(tree: Tree) -> None:
    asked = "project(demo)\nfind_package(catkin REQUIRED COMPONENTS roscpp Torch)\nadd_executable(a a.cpp)\n"
    manifest = "<package><name>demo</name><version>1.0.0</version><buildtool_depend>catkin</buildtool_depend></package>"
    page = "Tested on Ubuntu 20.04 with ROS Noetic and libtorch 1.10.2\n"
    decision = tree(CODE | {"CMakeLists.txt": asked, "package.xml": manifest, "README.md": page})
    assert [(each.name, each.zip) for each in decision.source] == [("libtorch", libtorch_archive("1.10.2", None))]


ADDRESS = "https://download.pytorch.org/libtorch/{}/libtorch-cxx11-abi-shared-with-deps-{}.zip"
OF_CUDA = ADDRESS.format("cu113", "1.11.0%2Bcu113")
OLD = ADDRESS.format("cu92", "1.6.0%2Bcu92")
ROS = {
    "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
    "CMakeLists.txt": "find_package(catkin REQUIRED)\n" + CMAKE,
    "README.md": "ROS Noetic\n",
}
USE = "#include <torch/script.h>\nvoid f(torch::Tensor a) {{\n  int b;\n  int c;\n  int d;\n  a = a{};\n}}\n"
ON = {"README.md": "Tested on Ubuntu 20.04\n"}


def on_cpu(decision: Decision) -> list[tuple[str | None, int | None]]:
    return [(w.file, w.line) for w in decision.warnings if "the image has the libtorch for the CPU" in w.message]


@pytest.mark.parametrize(
    ("files", "places"),
    [
        (ROS | {"get.sh": f"#!/bin/sh\nwget {OLD}\n"}, [("get.sh", 2)]),
        (ROS | {"get.sh": f"#!/bin/sh\nwget {OF_CUDA}\n"}, [("get.sh", 2)]),
        (CODE | ON | {"get.sh": f"#!/bin/sh\nwget {OLD}\n"}, [("get.sh", 2)]),
        (CODE | ON | {"get.sh": f"#!/bin/sh\n# wget {OLD}\n"}, []),
        (CODE | ON | {"get.sh": f"wget {OLD} # or {ADDRESS.format('cpu', '1.6.0%2Bcpu')}\n"}, []),
        (CODE | ON | {".github/workflows/a.yml": f"run: wget {OF_CUDA}\n"}, [(".github/workflows/a.yml", 1)]),
        (CODE | ON | {"a.cpp": USE.format(".cuda()")}, [("a.cpp", 6)]),
        (CODE | ON | {"a.cpp": USE.format(".to(torch::kCUDA)")}, [("a.cpp", 6)]),
        (CODE | ON | {"a.cpp": USE.format(";  // .cuda()")}, []),
        (CODE | ON | {"a.cpp": USE.format(".to(g ? torch::kCUDA : torch::kCPU)")}, []),
        (CODE | ON | {"a.cpp": USE.format(";\n  if (g) {\n    a = a.cuda();\n  }")}, []),
        (CODE | ON | {"a.cpp": USE.format(";\n#ifdef GPU\n  a = a.cuda();\n#endif")}, []),
        (CODE | ON | {"a.cpp": USE.format(".cuda()") + "bool b = torch::cuda::is_available();\n"}, []),
        (CODE | ON | {"b.cpp": USE.format(".cuda()")}, []),
        ({"CMakeLists.txt": "project(a)\nadd_executable(a a.cpp)\n", "a.cpp": USE.format(".cuda()")}, []),
    ],
)
def test_who_asks_for_cuda_is_told_of_the_archive_for_the_cpu(
    tree: Tree, files: dict[str, str], places: list[tuple[str, int]]
) -> None:
    assert on_cpu(tree(files)) == places


@pytest.mark.parametrize(
    ("script", "base", "archive"),
    [
        (OF_CUDA, "nvidia/cuda:11.3.1-cudnn8-devel-ubuntu20.04", libtorch_archive("1.11.0", "11.3")),
        (OLD, "ubuntu:20.04", libtorch_archive("1.6.0", None)),
        (ADDRESS.format("cu113", "latest"), "ubuntu:20.04", None),
    ],
)
def test_a_program_gets_the_archive_that_its_script_takes(
    tree: Tree, script: str, base: str, archive: str | None
) -> None:
    decision = tree(CODE | ON | {"get.sh": f"#!/bin/sh\nwget {script}\n"})
    assert decision.base_image == base
    (source,) = decision.source
    assert archive is None or source.zip == archive
    assert bool(on_cpu(decision)) is base.startswith("ubuntu")
