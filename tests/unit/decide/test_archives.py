"""Libraries whose project compiles them itself: its archives are unpacked."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Config, Source
from roslab.decide.decision import Decision
from roslab.plan.plan import make_plan
from roslab.render.dockerfile import dockerfile
from trees import decided

Tree = Callable[[dict[str, str]], Decision]
_MANIFEST = (
    "<package format='3'><name>depth</name><buildtool_depend>ament_cmake</buildtool_depend><depend>rclcpp</depend>{}"
    "<export><build_type>ament_cmake</build_type></export></package>"
)
_FILES = {
    "package.xml": _MANIFEST.format("<build_depend>onnxruntime</build_depend>"),
    "CMakeLists.txt": "project(depth)\nfind_package(ament_cmake REQUIRED)\nFIND\nadd_executable(depth depth.cpp)\n"
    "target_link_libraries(depth ${ORT})\nament_package()\n",
    "depth.cpp": "#include <onnxruntime_cxx_api.h>\nint main() {}\n",
}
_LIBRARY = "find_library(ORT onnxruntime)"


def _built(decision: Decision) -> Source | None:
    return next((each for each in decision.source if each.name == "onnxruntime"), None)


@pytest.mark.parametrize(
    ("key", "asked"),
    [
        (True, ""),
        (False, _LIBRARY),
        (False, "find_package(onnxruntime REQUIRED)"),
        (False, "find_package(ONNXRuntime REQUIRED)"),
        (False, "set(ORT onnxruntime)"),  # linked by its name alone
    ],
)
def test_an_archive_for_each_processor(tree: Tree, key: bool, asked: str) -> None:
    files = _FILES if key else {**_FILES, "package.xml": _MANIFEST.format("")}
    decision = tree({**files, "CMakeLists.txt": _FILES["CMakeLists.txt"].replace("FIND", asked)})
    library = _built(decision)
    assert library is not None
    assert library.zip is not None
    assert "-linux-x64-" in library.zip
    assert "-linux-aarch64-" in library.zip_arm64
    assert decision.platforms == ("linux/amd64", "linux/arm64")
    said = "onnxruntime is the name of a library, not a key of rosdep: onnxruntime, from an archive of its project, is"
    assert any(each.message.startswith(said) for each in decision.warnings) == key
    assert not any("onnxruntime" in each.message and "nothing" in each.message for each in decision.warnings)
    text = dockerfile(make_plan(decision, Config(), folder_name="demo"))
    assert f"arm64) echo {library.zip_arm64} ;; *) echo {library.zip} ;;" in text
    assert "tar --extract --gzip --directory /tmp/archive --file /tmp/archive.packed" in text
    assert "> CMakeLists.txt)" in text


@pytest.mark.parametrize(
    ("day", "code", "release"),
    [
        ("2022-10-01", "", "1.12.1"),
        ("2022-10-01", "auto name = session.GetInputNameAllocated(0, allocator);", "1.13.1"),
        ("2023-12-24", "", "1.16.3"),
        ("2023-12-24", "auto name = session.GetInputName(0, allocator);", "1.12.1"),
        ("2023-12-24", "auto name = session.GetInputNameAllocated(0, allocator);", "1.16.3"),
    ],
)
def test_the_release_of_its_time_and_of_its_code(tmp_path: Path, day: str, code: str, release: str) -> None:
    files = {
        **_FILES,
        "CMakeLists.txt": _FILES["CMakeLists.txt"].replace("FIND", _LIBRARY),
        "depth.cpp": f"{_FILES['depth.cpp']}{code}\n",
    }
    library = _built(decided(tmp_path, files, config=Config(pip_date=day)))
    assert library is not None
    assert (library.zip or "").endswith(f"-{release}.tgz")


@pytest.mark.parametrize(
    ("code", "told"),
    [
        ("options.AppendExecutionProvider_CUDA(cuda);", True),
        ("  session_.AppendExecutionProvider_TensorRT_V2 (*trt);", True),
        ("// options.AppendExecutionProvider_CUDA(cuda);", False),
        ("options.AppendExecutionProvider_CoreML(flags);", False),
    ],
)
def test_code_that_asks_for_a_gpu(tree: Tree, code: str, told: bool) -> None:
    files = {**_FILES, "depth.cpp": f"{_FILES['depth.cpp']}{code}\n"}
    found = [each for each in tree(files).warnings if "ONNX Runtime for the CPU" in each.message]
    assert [(each.file, each.line) for each in found] == [("depth.cpp", 3)] * told


def test_code_for_a_gpu_beside_what_is_installed_otherwise(tree: Tree) -> None:
    """No archive is unpacked, and which library there is nobody knows."""
    files = {"CMakeLists.txt": "project(a)\nadd_executable(a a.cpp)\n", "a.cpp": "s.AppendExecutionProvider_CUDA(c);\n"}
    assert not [each for each in tree(files).warnings if "ONNX Runtime" in each.message]
