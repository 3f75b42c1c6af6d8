"""What the sources of an extension include or call that newer releases of torch have dropped."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.native import extension_code
from roslab.evidence.python import project
from roslab.repository.checkout import Repository

SETUP = (
    "from setuptools import setup\nfrom torch.utils.cpp_extension import CUDAExtension, BuildExtension\n"
    "setup(name='ops', ext_modules=[CUDAExtension('ops', [{sources}])], cmdclass={{'build_ext': BuildExtension}})\n"
)


def found(tmp_path: Path, files: dict[str, str], sources: str = "'src/a.cpp'") -> set[tuple[str, str, int]]:
    for name, text in {"ops/setup.py": SETUP.format(sources=sources), **files}.items():
        file = tmp_path / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    repository = Repository.open(tmp_path)
    return {(use.below, use.file, use.line) for use in extension_code.read(repository, project.read(repository))}


@pytest.mark.parametrize(
    ("code", "below"),
    [
        ("#include <torch/extension.h>\n#include <THC/THC.h>\n", "1.11"),
        ("\n  dim3 grid(std::min(THCCeilDiv(size, 512L), 4096L));\n", "1.11"),
        ('\nAT_DISPATCH_FLOATING_TYPES(input.type(), "f", [&] {\n', "2.6"),
        ('\nAT_DISPATCH_FLOATING_TYPES_AND_HALF(\n    boxes->type(), "f", [&] {\n', "2.6"),
        ("\n  cudaStream_t stream = THCState_getCurrentStream(state);\n", "1.5"),
        ("\n#define CHECK_CUDA(x) AT_CHECK(x.type().is_cuda(), #x)\n", "1.5"),
    ],
)
def test_what_was_dropped(tmp_path: Path, code: str, below: str) -> None:
    ((release, file, _),) = found(tmp_path, {"ops/src/a.cpp": code})
    assert (release, file) == (below, "ops/src/a.cpp")


@pytest.mark.parametrize(
    "code",
    [
        "#include <THC/THCAtomics.cuh>\n#include <THC/THCDeviceUtils.cuh>\n",
        "// #include <THC/THC.h>\n// extern THCState *state;\n",
        'AT_DISPATCH_FLOATING_TYPES(input.scalar_type(), "f", [&] {\n',
        "#ifndef AT_CHECK\n#define AT_CHECK TORCH_CHECK\n#endif\nvoid f() { AT_CHECK(true); }\n",
        "#if TORCH_VERSION_MAJOR < 2\n#include <THC/THC.h>\n#endif\n",
        "// AT_CHECK was TORCH_CHECK before\n",
    ],
)
def test_what_every_release_has(tmp_path: Path, code: str) -> None:
    assert found(tmp_path, {"ops/src/a.cpp": code}) == set()


def test_only_what_the_script_compiles(tmp_path: Path) -> None:
    old = "#include <THC/THC.h>\n"
    files = {"ops/src/a.cpp": '#include "a.h"\n', "ops/src/b.cpp": old, "ops/src/b.h": old, "c.cpp": old}
    assert found(tmp_path, files) == set()
    assert found(tmp_path, {"ops/include/a.h": f"\n{old}"}) == {("1.11", "ops/include/a.h", 2)}


def test_a_script_that_lists_its_folder(tmp_path: Path) -> None:
    files = {"ops/src/b.cu": "void f() { AT_CHECK(true); }\n", "ops/third_party/c.cu": "#include <THC/THC.h>\n"}
    assert found(tmp_path, files, "*glob.glob('src/*.cu')") == {("1.5", "ops/src/b.cu", 1)}
