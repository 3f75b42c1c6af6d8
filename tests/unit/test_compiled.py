"""An image whose scripts began to compile a module of Python and did not end it gets no tag."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.plan.compiled import COMPILED_SCRIPT

EXTENSION = "from setuptools import setup\nsetup(name='ops', ext_modules=[CUDAExtension('ops_cuda', ['a.cu'])])\n"
NAME = "what scripts compile for Python is there"
FILES = {
    "train.py": "import torch\n",
    "lib/ops/setup.py": f"from torch.utils.cpp_extension import CUDAExtension\n{EXTENSION}",
    "lib/ops/a.cu": "__global__ void f() {}\n",
    "build.sh": "cd lib/ops\npython setup.py install\n",
}


def put(folder: Path, files: dict[str, str]) -> None:
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")


@pytest.mark.parametrize(
    ("files", "failed"),
    [
        ({"ops/setup.py": EXTENSION, "ops/build/lib.linux/ops_cuda.so": ""}, False),
        ({"ops/setup.py": EXTENSION, "ops/build/temp/a.o": "", "ops/ops/ops_cuda.cpython-38.so": ""}, False),
        ({"ops/setup.py": EXTENSION, "ops/build/temp/a.o": ""}, True),
        ({"ops/setup.py": EXTENSION}, False),  # nobody called it
        ({"ops/setup.py": "setup(name='ops')\n", "ops/build/lib/ops.py": ""}, False),  # it compiles nothing
    ],
)
def test_a_called_script_leaves_a_module(tmp_path: Path, files: dict[str, str], failed: bool) -> None:
    put(tmp_path, files)
    done = subprocess.run(
        (sys.executable, "-c", COMPILED_SCRIPT, str(tmp_path)), capture_output=True, text=True, check=False
    )
    assert (done.returncode != 0) is failed
    assert ("has compiled no module" in done.stderr) is failed


@pytest.mark.parametrize(
    ("install", "proved"), [("sh build.sh", True), ("bash build.bash", True), ("pip install torch", False)]
)
def test_where_a_page_runs_a_script_that_compiles(tmp_path: Path, install: str, proved: bool) -> None:
    page = f"# Net\n## Install\n```\n{install}\n```\n## Run\n```\npython train.py\n```\n"
    put(tmp_path, {**FILES, "build.bash": FILES["build.sh"], "README.md": page})
    found = [proof for proof in plan_repository(tmp_path).plan.proofs if proof.name == NAME]
    assert [(proof.rung, proof.required) for proof in found] == [(0, False)] * proved


def test_a_script_that_compiles_no_python_needs_no_proof(tmp_path: Path) -> None:
    page = "# Fusion\n## Install\n```\nsh compile.sh\n```\n"
    put(tmp_path, {"README.md": page, "compile.sh": "nvcc -o demo demo.cu\n", "demo.cu": "int main() {}\n"})
    assert NAME not in {proof.name for proof in plan_repository(tmp_path).plan.proofs}
