"""Packages that most likely cannot be built are left out where the build fails in them, and stop no others."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile
from trees import tree_of

CLONE = "cd src\ngit clone https://github.com/lab/{}\n"


def _package(name: str, *needed: str, required: bool = True) -> dict[str, str]:
    depends = "".join(f"<depend>{each}</depend>" for each in needed)
    components = f"COMPONENTS {' '.join(needed)}" if needed and required else ""
    return {
        f"{name}/package.xml": f"<package><name>{name}</name><buildtool_depend>catkin</buildtool_depend>{depends}"
        "</package>",
        f"{name}/CMakeLists.txt": f"project({name})\nfind_package(catkin REQUIRED {components})\ncatkin_package()\n",
    }


def planned(root: Path, files: dict[str, str], steps: str = "") -> tuple[tuple[str, ...], str]:
    """Return the folders of packages that may fail, and the Dockerfile."""
    page = f"ROS Noetic\n```\n{steps}catkin_make\nrosrun mine a\n```\n"
    tree_of(root, {**files, "README.md": page})
    plan = plan_repository(root).plan
    return plan.workspace.may_fail, dockerfile(plan)


def test_what_a_clone_may_hold_stops_no_others(tmp_path: Path) -> None:
    files = {**_package("mine", "roscpp"), **_package("arm", "acme_control"), **_package("above", "arm")}
    found, text = planned(tmp_path, files, CLONE.format("stack"))
    assert found == ("above", "arm")
    folder = f"src/{tmp_path.name}"
    assert f"leave-out-failed --keep mine src/stack {folder}/above {folder}/arm -- " in text


def test_the_build_stops_where_hardly_anything_is_left_unless_a_package_must_be(tmp_path: Path) -> None:
    files = {**_package("mine", "roscpp"), **_package("arm", "acme_control"), "README.md": "ROS Noetic\n"}
    steps = CLONE.format("stack")
    _, text = planned(tmp_path / "kept", files, steps)
    assert "leave-out-failed --keep mine src/stack" in text
    (tmp_path / "kept/README.md").write_text(f"ROS Noetic\n```\n{steps}catkin_make\n```\n")
    assert "leave-out-failed --own src/kept src/stack" in dockerfile(plan_repository(tmp_path / "kept").plan)


@pytest.mark.parametrize(
    ("files", "cloned"),
    [
        (_package("arm", "acme_control"), "acme_stack"),  # it is called so
        (_package("arm", "acme_control", required=False), "stack"),
        (_package("arm", "sensor_msgs"), "stack"),
        (_package("mine", "acme_control"), "stack"),  # all that there is
    ],
)
def test_what_most_likely_builds_does_not_fail(tmp_path: Path, files: dict[str, str], cloned: str) -> None:
    mine = {} if "mine/package.xml" in files else _package("mine", "roscpp")
    assert planned(tmp_path, {**mine, **files}, CLONE.format(cloned))[0] == ()


def test_a_library_that_cmake_looks_for_and_nothing_brings(tmp_path: Path) -> None:
    files = {**_package("mine", "roscpp"), **_package("arm", "roscpp")}
    files["arm/src/CMakeLists.txt"] = (
        "find_library(ACME acme_proto_lib)\nif(NOT ACME)\n  message(FATAL_ERROR gone)\nendif()\n"
        "add_executable(a a.cpp)\ntarget_link_libraries(a ${ACME})\n"
    )
    files["arm/CMakeLists.txt"] += "add_subdirectory(src)\n"
    files["arm/src/a.cpp"] = "int main() {}\n"
    found, text = planned(tmp_path, files)
    assert found == ("arm",)
    assert f"leave-out-failed --keep mine src/{tmp_path.name}/arm -- " in text


def test_messages_that_nothing_brings(tmp_path: Path) -> None:
    files = {**_package("mine", "roscpp"), **_package("arm", "roscpp")}
    files["arm/src/a.cpp"] = "#include <acme_msgs/Led.h>\nint main() {}\n"
    files["arm/CMakeLists.txt"] += "add_executable(a src/a.cpp)\n"
    found, text = planned(tmp_path, files)
    assert found == ("arm",)
    assert f"leave-out-failed --keep mine src/{tmp_path.name}/arm -- " in text


@pytest.mark.parametrize(
    ("more", "found"),
    [
        ({"arm/src/a.cpp": "int main() {}\n"}, ()),
        ({"arm/src/a.cpp": "// #include <arm/led.h>\nint main() {}\n"}, ()),
        ({"arm/src/a.cpp": "#include <arm/led.h>\nint main() {}\n"}, ("arm",)),
        ({"arm/src/a.cpp": "#include <arm/all.h>\n", "arm/include/arm/all.h": '#include "led.h"\n'}, ("arm",)),
        ({"arm/src/a.cpp": "#include <leg/led.h>\n", "leg/include/leg/led.h": "#pragma once\n"}, ()),
        ({"arm/src/a.cpp": "int main() {}\n", "arm/src/z.cpp": "#include <acme_msgs/Led.h>\n"}, ("arm",)),
        ({"arm/src/a.cpp": "int main() {}\n", "arm/src/b.tpp": "#include <arm/led.h>\n"}, ("arm",)),
    ],
)
def test_messages_in_a_header_that_nothing_includes(
    tmp_path: Path, more: dict[str, str], found: tuple[str, ...]
) -> None:
    files = {**_package("mine", "roscpp"), **_package("arm", "roscpp"), **more}
    files["arm/include/arm/led.h"] = "#pragma once\n#include <acme_msgs/Led.h>\n"
    files["arm/CMakeLists.txt"] += "add_executable(a src/a.cpp)\n"
    assert planned(tmp_path, files)[0] == found


def test_messages_in_a_header_of_a_tree_that_is_not_read_whole(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    files = {**_package("mine", "roscpp"), **_package("arm", "roscpp")}
    files["arm/include/arm/led.h"] = "#pragma once\n#include <acme_msgs/Led.h>\n"
    monkeypatch.setattr("roslab.evidence.native.cpp.MAX_SOURCES", 1)
    assert planned(tmp_path, files)[0] == ("arm",)


def test_messages_in_a_header_that_a_build_file_names(tmp_path: Path) -> None:
    files = {**_package("mine", "roscpp"), **_package("arm", "roscpp")}
    files["arm/include/arm/led.h"] = "#pragma once\n#include <acme_msgs/Led.h>\n"
    files["arm/CMakeLists.txt"] += "qt5_wrap_cpp(MOC include/arm/led.h)\n"
    assert planned(tmp_path, files)[0] == ("arm",)


@pytest.mark.parametrize(("url", "found"), [("git@gitlab.com:lab/grasp_net.git", ("eye",)), ("", ())])
def test_what_requires_a_submodule_that_is_not_there_may_be_missing_too(
    tmp_path: Path, url: str, found: tuple[str, ...]
) -> None:
    files = {**_package("mine", "roscpp"), **_package("eye", "grasp_net")}
    module = f'[submodule "grasp_net"]\n\tpath = grasp_net\n\turl = {url}\n'
    files |= {".gitmodules": module} if url else _package("grasp_net")
    assert planned(tmp_path, files)[0] == found


CHECK = "find_package(PkgConfig REQUIRED)\n"


@pytest.mark.parametrize(
    ("call", "more", "told"),
    [
        ("pkg_check_modules(ACME REQUIRED acme-sdk)", {}, True),
        ("pkg_check_modules(ACME REQUIRED IMPORTED_TARGET acme-sdk>=1.2)", {}, True),
        ("pkg_check_modules(ACME acme-sdk)", {}, False),
        ("if(WITH)\npkg_check_modules(ACME REQUIRED acme-sdk)\nendif()", {}, False),
        ("pkg_check_modules(EIGEN REQUIRED eigen3)", {}, False),
        ("pkg_search_module(ACME REQUIRED acme-sdk eigen3)", {}, False),
        (
            "pkg_check_modules(ACME REQUIRED acme-sdk)",
            {"sdk/CMakeLists.txt": "project(sdk)\nadd_library(acme a.c)\n", "sdk/a.c": ""},
            False,
        ),
        ("pkg_check_modules(ACME REQUIRED acme-sdk)", _package("acme_sdk"), False),
    ],
)
def test_a_module_of_pkg_config_that_nothing_brings(
    tmp_path: Path, call: str, more: dict[str, str], *, told: bool
) -> None:
    files = {**_package("mine", "roscpp"), **_package("arm", "roscpp"), **more}
    files["arm/CMakeLists.txt"] += f"{CHECK}{call}\n"
    assert planned(tmp_path, files)[0] == (("arm",) if told else ())
    warnings = [each for each in plan_repository(tmp_path).plan.warnings if "asks pkg-config for" in each.message]
    assert [(each.file, "arm is left out" in each.message) for each in warnings] == [
        ("arm/CMakeLists.txt", True)
    ] * told


def test_modules_of_one_call_are_told_together(tmp_path: Path) -> None:
    """Of those of ``pkg_search_module`` one is enough."""
    files = {**_package("mine", "roscpp"), **_package("arm", "roscpp")}
    files["arm/CMakeLists.txt"] += f"{CHECK}pkg_search_module(ACME REQUIRED acme-sdk acme-sdk-2)\n"
    planned(tmp_path, files)
    told = [each.message for each in plan_repository(tmp_path).plan.warnings if "pkg-config" in each.message]
    assert len(told) == 1
    assert "acme-sdk and acme-sdk-2, and nothing is known that brings any of them" in told[0]
