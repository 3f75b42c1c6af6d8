"""SFML comes from apt, of the Ubuntu that has the major version that CMake asks for."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository


@pytest.mark.parametrize(
    ("found", "linked", "ubuntu"),
    [
        ("find_package(SFML 2.5 COMPONENTS graphics REQUIRED)", "sfml-graphics", "jammy"),
        ("find_package(SFML 3 COMPONENTS Graphics REQUIRED)", "SFML::Graphics", "resolute"),
        ("", "sfml-window sfml-system", "jammy"),
        ("", "", "jammy"),
    ],
)
def test_the_package_and_the_ubuntu(tmp_path: Path, found: str, linked: str, ubuntu: str) -> None:
    lists = f"cmake_minimum_required(VERSION 3.16)\nproject(arm CXX)\n{found}\nadd_executable(arm arm.cpp)\n"
    (tmp_path / "CMakeLists.txt").write_text(
        lists + (f"target_link_libraries(arm {linked})\n" if linked else ""), encoding="utf-8"
    )
    (tmp_path / "arm.cpp").write_text("#include <SFML/Graphics.hpp>\nint main() {}\n", encoding="utf-8")
    plan = plan_repository(tmp_path).plan
    assert "libsfml-dev" in (*plan.apt, *plan.apt_guessed)
    assert plan.ubuntu == ubuntu
    assert not plan.libraries
