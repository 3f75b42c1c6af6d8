"""Repositories that a build tool builds which no step of the image calls."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.errors import NothingToBuildError
from roslab.pipeline import plan_repository


def told(root: Path, files: dict[str, str]) -> list[str]:
    """Return the warnings of a tree that name another build tool."""
    for path, text in files.items():
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(text)
    return [
        each.message for each in plan_repository(root).decision.warnings if "no step of the image calls" in each.message
    ]


@pytest.mark.parametrize(
    ("files", "tool"),
    [
        (
            {"Cargo.toml": "[package]\n", "src/main.rs": "fn main() {}\n", "tools/plot.py": "import numpy\n"},
            "Cargo (Rust)",
        ),
        ({"WORKSPACE": "", "BUILD.bazel": "", "src/main.cc": "#include <opencv2/core.hpp>\n"}, "Bazel"),
        ({"meson.build": "project('a', 'cpp')\n", "main.cpp": "#include <opencv2/core.hpp>\n"}, "Meson"),
    ],
)
def test_the_tool_is_told(tmp_path: Path, files: dict[str, str], tool: str) -> None:
    (message,) = told(tmp_path, files)
    assert message.startswith(f"the repository is built by {tool}, ")


@pytest.mark.parametrize(
    ("files", "kind"),
    [
        ({"WORKSPACE": "", "a/main.cc": "#include <opencv2/core.hpp>\n"}, "cpp"),
        ({"WORKSPACE": "", "a/main.cc": "#include <opencv2/core.hpp>\n", "b.py": "import numpy\n"}, "python"),
        ({"Cargo.toml": "[package]\n", "a/main.cc": "#include <opencv2/core.hpp>\n"}, "python"),
    ],
)
def test_cpp_that_it_compiles_is_of_that_kind(tmp_path: Path, files: dict[str, str], kind: str) -> None:
    assert told(tmp_path, files)
    plan = plan_repository(tmp_path).plan
    assert plan.kind == kind
    assert plan.build_tool == "none"
    assert ("build-essential" in plan.apt) == (kind == "cpp")


@pytest.mark.parametrize(("file", "tool"), [("meson.build", "none"), ("Cargo.toml", "cmake")])
def test_what_compiles_no_cpp_does_not_build_it(tmp_path: Path, file: str, tool: str) -> None:
    files = {file: "", "main.cc": "#include <vector>\nint main() {}\n", "roslab.yaml": "format: 3\nkind: cpp\n"}
    told(tmp_path, files)
    assert plan_repository(tmp_path).plan.build_tool == tool


def test_where_it_builds_all_that_is_told(tmp_path: Path) -> None:
    with pytest.raises(NothingToBuildError, match="nothing to build was found") as error:
        told(tmp_path, {"Cargo.toml": "[package]\n", "src/main.rs": "fn main() {}\n"})
    assert "Cargo (Rust) builds Cargo.toml, and no step of the image calls it" in str(error.value)


@pytest.mark.parametrize(
    "files",
    [
        {
            "Cargo.toml": "[package]\n",
            "pyproject.toml": '[project]\nname = "a"\n[build-system]\nrequires = ["maturin"]\n',
        },
        {"WORKSPACE": "", "CMakeLists.txt": "project(a)\nadd_executable(a a.cpp)\n", "a.cpp": "int main() {}\n"},
        {"WORKSPACE": "", "requirements.txt": "numpy\n", "main.py": "import numpy\n"},
        {"web/go.mod": "module a\n", "main.py": "import numpy\n"},
    ],
)
def test_what_is_built_as_usual_tells_nothing(tmp_path: Path, files: dict[str, str]) -> None:
    assert told(tmp_path, files) == []


RUNNER = {
    "linux/CMakeLists.txt": "project(runner LANGUAGES CXX)\nadd_executable(app main.cc)\n",
    "linux/main.cc": "#include <opencv2/core.hpp>\nint main() {}\n",
}


@pytest.mark.parametrize("text", ["name: app\ndependencies:\n  flutter:\n    sdk: flutter\n", "name: a\nflutter:\n"])
def test_the_runner_of_flutter_is_not_compiled_alone(tmp_path: Path, text: str) -> None:
    with pytest.raises(NothingToBuildError, match="nothing to build was found") as error:
        told(tmp_path, {"pubspec.yaml": text, "lib/main.dart": "void main() {}\n", **RUNNER})
    assert "Flutter builds pubspec.yaml, and no step of the image calls it" in str(error.value)


def test_beside_an_app_of_flutter_the_rest_is_planned(tmp_path: Path) -> None:
    files = {"app/pubspec.yaml": "name: app\nflutter:\n", **{f"app/{name}": text for name, text in RUNNER.items()}}
    assert told(tmp_path, {"main.py": "import numpy\n", **files}) == []
    assert plan_repository(tmp_path).plan.kind == "python"


def test_a_folder_of_the_runner_s_name_without_flutter_is_compiled(tmp_path: Path) -> None:
    assert told(tmp_path, {"pubspec.yaml": "name: app\n", **RUNNER}) == []
    assert plan_repository(tmp_path).plan.kind == "cpp"


def _uncompiled(root: Path, files: dict[str, str]) -> list[str]:
    for path, text in {"src/main.cpp": "#include <opencv2/core.hpp>\nint main() {}\n", **files}.items():
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(text)
    return [each.message for each in plan_repository(root).decision.warnings if "Visual Studio" in each.message]


def test_a_project_of_visual_studio_alone_is_told(tmp_path: Path) -> None:
    (message,) = _uncompiled(tmp_path, {"app/Arm.vcxproj": "<Project/>\n", "Arm.sln": "Global\n"})
    assert message.startswith("the C++ is compiled by Visual Studio (Arm.sln), which is of Windows alone")


@pytest.mark.parametrize(
    "files",
    [
        {},
        {"third_party/json/Json.sln": "", "third_party/json/a.vcxproj": ""},
        {"Arm.sln": "", "CMakeLists.txt": "project(a)\nadd_executable(a src/main.cpp)\n"},
        {"Arm.sln": "", "Makefile": "arm: src/main.cpp\n\tg++ -o arm src/main.cpp\n"},
        {"Arm.sln": "", "a.py": "import numpy\n", "b.py": "import numpy\n"},
    ],
    ids=["none", "copied", "cmake", "make", "python"],
)
def test_a_project_of_visual_studio_beside_others_is_not(tmp_path: Path, files: dict[str, str]) -> None:
    assert not _uncompiled(tmp_path, files)
