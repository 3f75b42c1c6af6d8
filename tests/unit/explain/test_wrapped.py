"""Messages of newer tools, and lines that CMake wraps."""

from __future__ import annotations

import io

import pytest

from roslab.explain.answer import explain


@pytest.mark.parametrize(
    ("lines", "known", "name"),
    [
        (
            [
                "CMake Error at /usr/share/cmake-3.25/Modules/FindPkgConfig.cmake:607 (message):",
                "  A required package was not found",
                "--   Package 'jsoncpp', required by 'virtual:world', not found",
            ],
            "pkg-config",
            ("module", "jsoncpp"),
        ),
        (
            [
                "CMake Error at /usr/share/cmake-3.25/Modules/FindPackageHandleStandardArgs.cmake:230 (message):",
                '  Could NOT find PkgConfig: Found unsuitable version "1.8.1", but required is',
                '  at least "99.0" (found /usr/bin/pkg-config)',
            ],
            "cmake-version",
            ("version", "99.0"),
        ),
        (
            [
                "CMake Error at /app/install/share/ament_cmake_target_dependencies/cmake/targets.cmake:77 (message):",
                "  ament_target_dependencies() the passed package name",
                "  'arm_msg_wrapper' was not found before",
                "Call Stack (most recent call first):",
                "  CMakeLists.txt:20 (ament_target_dependencies)",
            ],
            "ament-not-found-before",
            ("name", "arm_msg_wrapper"),
        ),
    ],
)
def test_the_cause(lines: list[str], known: str, name: tuple[str, str]) -> None:
    said = "".join(f"#6 1.2 {line}\n" for line in lines)
    log = f'#6 [3/4] RUN cmake .\n{said}#6 ERROR: process "/bin/sh -c cmake ." did not complete: exit code: 1\n'
    (found,) = explain(io.BytesIO(log.encode())).explanations
    assert found.id == known
    assert name in found.names
