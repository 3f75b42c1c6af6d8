"""An author's Dockerfile that cannot be built from the tree alone, or makes files and no image that runs."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]


@pytest.mark.parametrize(
    ("last", "base", "generated"),
    [
        ("FROM scratch AS exporter\nCOPY --from=builder /app/build /\n", "ubuntu:20.04", True),
        ("FROM scratch\nCOPY --from=builder / /\n", "ubuntu:20.04", False),
        ("FROM scratch\nCOPY --from=builder /app/demo /demo\nENTRYPOINT ['/demo']\n", "ubuntu:20.04", False),
        ("FROM builder\nRUN make -C build install\n", "ubuntu:20.04", False),
        ("RUN --mount=type=bind,from=sdk,target=/sdk make\n", "ubuntu:20.04", True),
        ("RUN --mount=type=cache,target=/var/cache --mount=from=builder,target=/b make\n", "ubuntu:20.04", False),
        ("COPY --from=sdk /opt /opt\n", "ubuntu:20.04", True),
        ("COPY --from=0 /opt /opt\n", "ubuntu:20.04", False),
        (
            "COPY --from=ghcr.io/astral-sh/uv:0.5 /uv /bin/uv\nCOPY --from=python:3.8 /usr/local /usr/local\n",
            "ubuntu:20.04",
            False,
        ),
    ],
)
def test_what_it_makes_can_be_built_and_run(tree: Tree, last: str, base: str, *, generated: bool) -> None:
    first = f"ARG BASE=base\nFROM {base} AS base\nFROM $BASE AS builder\nWORKDIR /app\nCOPY . .\nRUN make\n"
    found = tree(
        {
            "Dockerfile": f"{first}{last}",
            "CMakeLists.txt": "project(demo)\nadd_executable(demo demo.cpp)\n",
            "demo.cpp": "int main() {}\n",
        }
    )
    assert (found.dockerfile is None) == generated
    assert found.base_image == base


@pytest.mark.parametrize(
    ("into", "macros", "kind"),
    [
        ("parts/udp", "", "cpp"),
        ("src/udp", "", "ros2"),
        ("udp", "", "ros2"),
        ("parts/udp", "find_package(ament_cmake REQUIRED)\nament_package()\n", "ros2"),
    ],
)
def test_parts_of_a_cmake_project_that_a_list_adds(tree: Tree, into: str, macros: str, kind: str) -> None:
    listed = f"repositories:\n  {into}:\n    type: git\n    url: https://github.com/lab/udp.git\n    version: main\n"
    found = tree(
        {
            "extensions.repos": listed,
            "README.md": "With ROS 2 Humble there is more.\n",
            "CMakeLists.txt": f"project(demo)\nadd_executable(demo demo.cpp)\nadd_subdirectory(parts/pcl)\n{macros}",
            "parts/pcl/CMakeLists.txt": "add_library(pcl_part part.cpp)\n",
            "demo.cpp": "int main() {}\n",
        }
    )
    assert found.kind == kind
