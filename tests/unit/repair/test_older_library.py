"""Code that does not fit a newer release of a library is built on the newest Ubuntu before it."""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from failed_builds import log, repaired
from roslab.explain.answer import explain
from roslab.repair.change import Repair

CMAKE = (
    "cmake_minimum_required(VERSION 3.5)\nproject(joints CXX)\nfind_package(Eigen3)\nadd_executable(joints main.cpp)\n"
)
MAIN = """\
#include <Eigen/Dense>
int main() {
  Eigen::MatrixXd joints(8, 6);
  double row = 2;
  return joints(row, 1);
}
"""
CLONED = """\
# Joints

## Installation

```bash
git clone https://gitlab.com/libeigen/eigen.git
cd eigen && mkdir build && cd build && cmake .. && sudo make install
```
"""
VIEW = "Eigen::IndexedView<Eigen::Matrix<double, -1, -1>, double, Eigen::internal::SingleRange>"
SAID = f"/joints/main.cpp:5:16: error: cannot convert '{VIEW}' to 'int' in return"


def _repaired(folder: Path, *, text: str = SAID, **files: str) -> Repair:
    for name, content in {"CMakeLists.txt": CMAKE, "main.cpp": MAIN, **files}.items():
        (folder / name).write_text(content)
    return repaired(folder, log("make", text))


@pytest.mark.parametrize("ubuntu", ["", "{ubuntu: '24.04'}"])
def test_an_ubuntu_with_the_older_library_is_taken(tmp_path: Path, ubuntu: str) -> None:
    files = {"roslab.yaml": f"format: 3\nbase: {ubuntu}\n"} if ubuntu else {}
    found = _repaired(tmp_path, **files)
    assert [(change.key, change.value) for change in found.changes] == [("base.ubuntu", "20.04")]
    assert bool(found.certain.changes) is not bool(ubuntu)  # what somebody wrote is not exchanged


def test_the_index_may_be_the_second_one(tmp_path: Path) -> None:
    view = "Eigen::IndexedView<Eigen::Matrix<double, -1, -1>, Eigen::internal::SingleRange, float>"
    said = f"/joints/main.cpp:5:16: error: no match for 'operator=' (operand types are '{view}' and 'int')"
    assert [change.value for change in _repaired(tmp_path, text=said).changes] == ["20.04"]


@pytest.mark.parametrize(
    ("files", "why"),
    [
        ({"roslab.yaml": "format: 3\nbase: {ubuntu: '20.04'}\n"}, "the image's Ubuntu has Eigen3 3.3.7"),
        ({"roslab.yaml": "format: 3\nbase: {ros: humble}\n"}, "ROS humble belongs to its Ubuntu"),
        ({"roslab.yaml": "format: 3\nbase: {image: 'debian:12'}\n"}, "the base image is no Ubuntu"),
        ({"main.cpp": f"#include <format>\n{MAIN}"}, "Ubuntu 20.04 does not have GCC 13"),
        (
            {"CMakeLists.txt": CMAKE.replace("find_package(Eigen3)", "find_package(OpenCV 4.5 REQUIRED)")},
            "Ubuntu 20.04 does not have OpenCV 4.5",
        ),
        ({"README.md": CLONED}, "the repository builds Eigen3 from its source"),
    ],
)
def test_no_other_ubuntu_is_taken_where_it_cannot_be(tmp_path: Path, files: dict[str, str], why: str) -> None:
    found = _repaired(tmp_path, **files)
    assert found.changes == ()
    assert why in "".join(reason for _, reason in found.refused)


def test_the_log_alone_names_no_value_of_roslab_yaml() -> None:
    (found,) = explain(io.BytesIO(log("make", SAID).encode())).explanations
    assert (found.id, found.repair) == ("eigen-floating-index", ())
