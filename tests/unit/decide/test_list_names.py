"""Which of several lists of repositories counts, by the system that its name says it is for."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
LISTS = {
    ".ci/a_windows.repos": "v1",
    ".ci/needs.repos": "v2",
    ".ci/needs_focal.repos": "v3",
    ".ci/needs_jammy.repos": "v4",
}


@pytest.mark.parametrize(
    ("names", "found", "built"),
    [
        (tuple(LISTS), "REQUIRED", ["v4"]),
        (tuple(LISTS)[:3], "REQUIRED", []),  # Ubuntu's own package
        (tuple(LISTS)[3:], "", []),
        (tuple(LISTS)[:2], "Acme REQUIRED", ["v2"]),
        (tuple(LISTS)[:1], "Acme REQUIRED", ["v1"]),
    ],
)
def test_a_list_of_the_images_ubuntu_comes_first_and_before_apt(
    tree: Tree, names: tuple[str, ...], found: str, built: list[str]
) -> None:
    listed = "- git: {{local-name: {}, uri: 'https://github.com/lab/{}.git', version: {}}}\n"
    name = "acme" if "Acme" in found else "fcl"
    made = (
        f"project(demo CXX)\nfind_package({found if 'Acme' in found else f'fcl {found}'})\nadd_executable(demo a.cpp)\n"
    )
    files = {"CMakeLists.txt": made, "a.cpp": "int main() {}\n", "README.md": "For Ubuntu 22.04\n"}
    files |= {file: listed.format(name, name, LISTS[file]) for file in names}
    assert [source.ref for source in tree(files).source] == built


@pytest.mark.parametrize(
    ("names", "cloned"),
    [
        (("needs.repos", "needs_focal.repos", "needs_jammy.repos"), ["v-needs_jammy.repos"]),
        (("needs.repos", "needs_focal.repos", "needs_windows.repos"), ["v-needs.repos"]),
        (("needs_humble.repos", "needs_jammy.repos"), ["v-needs_humble.repos"]),
        (("needs.repos", "needs_2004.repos", "needs_22.04.repos"), ["v-needs_22.04.repos"]),
        (("needs.repos", "needs_2004.repos", "needs_win32.repos"), ["v-needs.repos"]),
    ],
)
def test_so_do_those_of_the_ubuntu_of_ros(tree: Tree, names: tuple[str, ...], cloned: list[str]) -> None:
    manifest = "<package format='3'><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend>"
    files = {"package.xml": f"{manifest}<depend>acme</depend></package>", "README.md": "For ROS 2 Humble\n"}
    files["CMakeLists.txt"] = "project(demo)\nfind_package(ament_cmake REQUIRED)\nfind_package(acme REQUIRED)\n"
    listed = "repositories:\n  acme: {{type: git, url: 'https://github.com/lab/acme.git', version: v-{}}}\n"
    files |= {name: listed.format(name) for name in names}
    assert [source.ref for source in tree(files).source] == cloned


@pytest.mark.parametrize(
    ("folders", "built"),
    [
        (("ci/fedora35", "ci/ubuntu22"), "v-ubuntu22"),
        (("ci/ubuntu20", "ci/ubuntu2204"), "v-ubuntu2204"),
        (("ci/focal", "ci/other"), "v-other"),
        (("ci/centos7", "ci/fedora35"), "v-centos7"),
    ],
)
def test_so_does_the_script_of_the_images_ubuntu(tree: Tree, folders: tuple[str, ...], built: str) -> None:
    script = "git clone https://github.com/lab/acme.git\ncd acme\ngit checkout {}\nmkdir build\ncd build\ncmake ..\n"
    script += "make install\n"
    files = {f"{folder}/install_acme.sh": script.format(f"v-{folder[3:]}") for folder in folders}
    files["CMakeLists.txt"] = "project(demo CXX)\nfind_package(Acme REQUIRED)\nadd_executable(demo a.cpp)\n"
    files |= {"a.cpp": "int main() {}\n", "README.md": "For Ubuntu 22.04\n"}
    assert [source.ref for source in tree(files).source] == [built]
