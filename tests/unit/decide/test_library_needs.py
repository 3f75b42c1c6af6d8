"""What a library of the table needs in turn is built before it, and what links it is in the image."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Config, Source
from roslab.decide import decide
from roslab.decide.decision import Decision
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository

Tree = Callable[[dict[str, str]], Decision]
MADE = "project(demo)\nfind_package(RBDyn 1.2.1 REQUIRED)\nadd_executable(a a.cpp)\n"
PAGE = "Needs [RBDyn](https://github.com/jrl-umi3218/RBDyn)"


def test_what_a_linked_library_needs_comes_before_it(tree: Tree) -> None:
    decision = tree({"CMakeLists.txt": MADE, "a.cpp": "int main() {}\n", "README.md": PAGE})
    assert [source.name for source in decision.source] == ["spacevecalg", "rbdyn"]
    assert all("-DPYTHON_BINDING=OFF" in source.cmake_options for source in decision.source)
    assert not any(source.unread for source in decision.source)
    assert {"libtinyxml2-dev", "libyaml-cpp-dev"} <= {*decision.apt, *decision.apt_guessed}


@pytest.mark.parametrize(
    ("cmake", "built"),
    [
        ("find_package(Matplot++ REQUIRED)\n", ["matplotplusplus"]),
        ("find_package(matplot REQUIRED)\n", []),  # the tree's own
    ],
)
def test_matplotplusplus_draws_by_gnuplot(tree: Tree, cmake: str, built: list[str]) -> None:
    module = "include(ExternalProject)\nExternalProject_Add(words GIT_REPOSITORY https://github.com/lab/words.git)\n"
    code = "#include <matplot/matplot.h>\nint main() {}\n"
    made = (
        f"project(demo)\nlist(APPEND CMAKE_MODULE_PATH ${{CMAKE_SOURCE_DIR}}/cmake)\n{cmake}add_executable(a a.cpp)\n"
    )
    decision = tree({"CMakeLists.txt": made, "a.cpp": code, "cmake/Findmatplot.cmake": module})
    assert [source.name for source in decision.source] == built
    assert "gnuplot" in (*decision.apt, *decision.apt_guessed)


def install(name: str) -> str:
    build = f"cd {name} && mkdir build && cd build && cmake .. && sudo make install"
    return f"```\ngit clone https://github.com/lab/{name}.git\n{build}\n```\n"


PLAIN = "```\ngit clone https://github.com/lab/acme_tool.git\n```\n"


@pytest.mark.parametrize(
    ("asked", "page", "built"),
    [
        (("acme_top",), install("acme_base") + install("acme_top"), ["acme_base", "acme_top"]),
        (("acme_top", "acme_base"), install("acme_base") + install("acme_top"), ["acme_base", "acme_top"]),
        (("acme_base",), install("acme_base") + install("acme_top"), ["acme_base"]),
        (("acme_top",), PLAIN + install("acme_top"), ["acme_top"]),
        (("acme_top",), install("Eigen3") + install("acme_top"), ["acme_top"]),
    ],
)
def test_what_a_page_installs_above_a_library_is_built_before_it(
    tree: Tree, asked: tuple[str, ...], page: str, built: list[str]
) -> None:
    made = "project(demo)\n" + "".join(f"find_package({name} REQUIRED)\n" for name in asked)
    files = {"CMakeLists.txt": f"{made}add_executable(a a.cpp)\n", "a.cpp": "int main() {}\n", "README.md": page}
    assert [source.name for source in tree(files).source if not source.unasked] == built


@pytest.mark.parametrize(("ubuntu", "linked"), [("xenial", True), ("bionic", False)])
def test_pcl_of_xenial_links_proj(tree: Tree, ubuntu: str, linked: bool) -> None:
    made = "project(demo)\nfind_package(PCL 1.7 REQUIRED)\nadd_executable(a a.cpp)\n"
    page = f"Tested on Ubuntu {'16.04' if ubuntu == 'xenial' else '18.04'}\n"
    decision = tree({"CMakeLists.txt": made, "a.cpp": "int main() {}\n", "README.md": page})
    assert decision.ubuntu == ubuntu
    assert ("libproj-dev" in {*decision.apt, *decision.apt_guessed}) is linked


def listed(name: str, repo: str) -> Source:
    return Source(name=name, repo=f"https://github.com/{repo}.git", ref="1.0", build="cmake")


def test_what_roslab_yaml_lists_keeps_its_order_before_a_library_that_nobody_has_read(tmp_path: Path) -> None:
    made = "project(demo)\nfind_package(acme_top REQUIRED)\nadd_executable(a a.cpp)\n"
    (tmp_path / "CMakeLists.txt").write_text(made)
    (tmp_path / "a.cpp").write_text("int main() {}\n")
    (tmp_path / "README.md").write_text(install("acme_top"))
    ceres = listed("ceres", "ceres-solver/ceres-solver")
    config = Config(source=(listed("math", "lab/math"), ceres, listed("late", "lab/late")))
    decision = decide(gather(Repository.open(tmp_path)), config, folder_name="demo")
    assert [source.name for source in decision.source] == ["math", "ceres", "acme_top", "late"]
