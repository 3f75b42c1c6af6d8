"""The toolkit of the image knows the GPUs that the code is compiled for."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.evidence.native import gpus
from roslab.knowledge.cuda_gpus import cuda_of_gpu
from roslab.repository.checkout import Repository

Tree = Callable[[dict[str, str]], Decision]


def made(*lines: str, page: str = "") -> dict[str, str]:
    text = "\n".join(["project(demo CXX CUDA)", *lines, "add_executable(a a.cu)", ""])
    return {"CMakeLists.txt": text, "a.cu": "int main() {}\n", "README.md": page}


@pytest.mark.parametrize(
    ("line", "page", "cuda"),
    [
        ("", "", "11.8"),
        ("set(CMAKE_CUDA_ARCHITECTURES 86)", "", "11.8"),
        ("set(CMAKE_CUDA_ARCHITECTURES 120)", "", "12.8"),
        ('set(CMAKE_CUDA_ARCHITECTURES "75;89-real")', "Tested with CUDA 11.3.\n", "11.8"),
        ("set(CUDA_NVCC_FLAGS ${CUDA_NVCC_FLAGS} -gencode arch=compute_37,code=sm_37)", "CUDA 12.4\n", "11.8"),
        ("set_target_properties(a PROPERTIES CUDA_ARCHITECTURES 61)", "Tested with CUDA 13.0.\n", "12.9"),
        ("set(CMAKE_CUDA_ARCHITECTURES 86)", "Tested with CUDA 12.1.\n", "12.1"),
        ("if(NEW)\nset(CMAKE_CUDA_ARCHITECTURES 120)\nendif()", "Tested with CUDA 11.3.\n", "11.3"),
        ("# set(CMAKE_CUDA_ARCHITECTURES 120)", "Tested with CUDA 11.3.\n", "11.3"),
        ("set(CMAKE_CUDA_ARCHITECTURES 20)", "Tested with CUDA 11.3.\n", "11.3"),
    ],
)
def test_the_cuda_of_the_image_knows_the_gpus_of_the_code(tree: Tree, line: str, page: str, cuda: str) -> None:
    decision = tree(made(line, page=page))
    assert decision.kind == "cuda"
    assert decision.cuda == cuda
    assert f":{cuda}" in decision.base_image


FLAGS = "set(FLAGS -gencode arch=compute_35,code=sm_35)"


@pytest.mark.parametrize(
    ("lines", "found"),
    [
        ((FLAGS, "if(USE_CUDA)", "set(CUDA_NVCC_FLAGS ${FLAGS})", "endif()"), False),
        ((FLAGS, "set(CUDA_NVCC_FLAGS ${FLAGS})", "if(USE_CUDA)", "find_package(CUDA REQUIRED)", "endif()"), False),
        (("option(USE_CUDA a OFF)", FLAGS, "if(USE_CUDA)", "set(CUDA_NVCC_FLAGS ${FLAGS})", "endif()"), False),
        (("option(USE_CUDA a ON)", FLAGS, "if(USE_CUDA)", "set(CUDA_NVCC_FLAGS ${FLAGS})", "endif()"), True),
        (("find_package(CUDA)", FLAGS, "set(CUDA_NVCC_FLAGS ${FLAGS})"), True),
        (("find_package(CUDA)", FLAGS, "if(CUDA_FOUND)", "set(CUDA_NVCC_FLAGS ${FLAGS})", "endif()"), True),
        ((FLAGS,), True),
    ],
)
def test_the_gpus_of_an_option_that_is_off_tell_nothing(tmp_path: Path, lines: tuple[str, ...], found: bool) -> None:
    (tmp_path / "CMakeLists.txt").write_text("\n".join(["project(demo CXX)", *lines, ""]))
    assert [limit.what for limit in gpus.read(Repository.open(tmp_path))] == (["sm_35"] if found else [])


def test_the_reason_names_the_line_of_the_gpu(tree: Tree) -> None:
    decision = tree(made("set(CMAKE_CUDA_ARCHITECTURES 120)"))
    (reason,) = [r for r in decision.reasons if r.question == "cuda" and r.decisive]
    assert (reason.file, reason.line) == ("CMakeLists.txt", 2)
    assert "sm_120" in reason.reason


def test_the_first_and_the_last_toolkit_of_a_gpu() -> None:
    assert cuda_of_gpu(86) == ("11.1", None)
    assert cuda_of_gpu(37)[1] == "12.0"
    assert cuda_of_gpu(61)[1] == "13.0"
    assert cuda_of_gpu(900) == (None, None)


def test_an_extension_of_python_names_its_gpus(tree: Tree) -> None:
    setup = (
        "from setuptools import setup\nfrom torch.utils.cpp_extension import CUDAExtension\n"
        "setup(name='demo', ext_modules=[CUDAExtension('a', ['a.cu'],\n"
        "    extra_compile_args={'nvcc': ['-gencode=arch=compute_89,code=sm_89']})])\n"
    )
    files = {"setup.py": setup, "a.cu": "int main() {}\n", "README.md": "Tested with CUDA 11.3.\n"}
    assert tree(files).cuda == "11.8"


@pytest.mark.parametrize(("gpu", "told"), [(20, True), (86, False)])
def test_a_gpu_that_no_images_compiler_knows_is_told(tree: Tree, gpu: int, told: bool) -> None:
    lines = ("find_package(CUDA REQUIRED)", "if(CUDA_FOUND)", f"set(CUDA_NVCC_FLAGS -arch=sm_{gpu})", "endif()")
    found = [(w.file, w.line) for w in tree(made(*lines)).warnings if f"sm_{gpu}" in w.message]
    assert found == ([("CMakeLists.txt", 4)] if told else [])
