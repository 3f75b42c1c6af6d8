"""Code for one generation of GPUs, without PTX for the newer ones, is told."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.native import gpu_code
from trees import tree_of

CMAKE = "project(demo)\nfind_package(CUDA REQUIRED)\n{}\ncuda_add_library(demo a.cu)\n"
FLAGS = "set(CUDA_NVCC_FLAGS ${{CUDA_NVCC_FLAGS}} {})"
ONE = FLAGS.format("--generate-code arch=compute_50,code=sm_50")


@pytest.mark.parametrize(
    "line",
    [
        ONE,
        FLAGS.format("-gencode arch=compute_50,code=sm_50 -gencode arch=compute_52,code=sm_52"),
        FLAGS.format('"-gencode arch=compute_50,code=[sm_50,sm_52]"'),
    ],
)
def test_code_for_one_generation_is_told_at_its_line(tmp_path: Path, line: str) -> None:
    ((message, file, at),) = gpu_code.read(tree_of(tmp_path, {"CMakeLists.txt": CMAKE.format(line)}))
    assert message.startswith("CUDA's code is compiled for GPUs of compute capability 5.x alone, without PTX")
    assert "-gencode arch=compute_5" in message
    assert (file, at) == ("CMakeLists.txt", 3)


@pytest.mark.parametrize(
    "line",
    [
        FLAGS.format("-gencode arch=compute_50,code=sm_50 -gencode arch=compute_61,code=sm_61"),
        FLAGS.format("-gencode arch=compute_50,code=sm_50 -gencode arch=compute_50,code=compute_50"),
        FLAGS.format('"-gencode arch=compute_50,code=[sm_50,compute_50]"'),
        FLAGS.format("-arch=sm_50"),
        FLAGS.format("-gencode arch=compute_90a,code=sm_90a"),
        FLAGS.format("-gencode arch=compute_100f,code=sm_100f"),
        FLAGS.format("-gencode arch=compute_${GPU},code=sm_${GPU}"),
        f"if(JETSON)\n{ONE}\nendif()",
        f"# {ONE}",
        "",
    ],
    ids=["two", "PTX", "PTX in a list", "short", "suffix a", "suffix f", "variable", "condition", "comment", "nothing"],
)
def test_code_for_more_or_for_an_unknown_one_is_not(tmp_path: Path, line: str) -> None:
    assert list(gpu_code.read(tree_of(tmp_path, {"CMakeLists.txt": CMAKE.format(line)}))) == []


def test_makefiles_and_setup_py_are_read_by_their_lines(tmp_path: Path) -> None:
    made = "NVCCFLAGS = -gencode arch=compute_70,code=sm_70\n# -gencode arch=compute_80,code=sm_80\n"
    ((message, file, line),) = gpu_code.read(tree_of(tmp_path, {"Makefile": made}))
    assert "7.x alone" in message
    assert (file, line) == ("Makefile", 1)
