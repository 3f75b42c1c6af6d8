"""Extensions whose C++ is written for an older torch: a bound, or a macro where one is enough."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
SETUP = (
    "from setuptools import setup\nfrom torch.utils.cpp_extension import CUDAExtension, BuildExtension\n"
    "setup(name='ops', ext_modules=[CUDAExtension('ops', ['a.cu'])], cmdclass={'build_ext': BuildExtension})\n"
)
CHECK = "void f() { AT_CHECK(true); }\n"
THC = "#include <THC/THC.h>\n"
MACRO = ("AT_CHECK=TORCH_CHECK",)


def planned(tree: Tree, code: str, torch: str = "torch", **more: str) -> Decision:
    files = {"requirements.txt": f"{torch}\n", "train.py": "import torch\n", "ops/setup.py": SETUP, "ops/a.cu": code}
    page = "# Net\n```\npip install -r requirements.txt\ncd ops && python setup.py install\n```\n"
    return tree({**files, "README.md": page, **more})


def bounds(decision: Decision) -> set[str]:
    return {each.written for each in decision.python.bounds if each.key == "torch"}


def test_the_newest_torch_that_has_what_the_code_includes(tree: Tree) -> None:
    found = planned(tree, THC)
    assert found.cuda == "11.1"
    assert bounds(found) == {"torch<1.11", "torch==1.10.*"}
    assert found.python.version == "3.8"
    assert found.python.defines == ()


def test_what_the_author_pins_stays(tree: Tree) -> None:
    assert bounds(planned(tree, THC, "torch==1.12.1")) == set()


@pytest.mark.parametrize("script", ["ops/setup.py", "third_party/ops/setup.py", "examples/ops/setup.py"])
def test_only_what_is_compiled(tree: Tree, script: str) -> None:
    folder = script.rpartition("/")[0]
    files = {"requirements.txt": "torch\n", "setup.py": "from setuptools import setup\nsetup(name='net')\n"}
    files |= {script: SETUP, f"{folder}/a.cu": THC + CHECK, "train.py": "import torch\n"}
    found = tree(files)
    assert "torch<1.11" not in bounds(found)
    assert found.python.defines == ()


@pytest.mark.parametrize(
    ("torch", "defines"), [("torch", MACRO), ("torch==1.8.1", MACRO), ("torch==1.4.0", ()), ("torch<1.5", ())]
)
def test_a_macro_brings_back_what_a_newer_torch_dropped(tree: Tree, torch: str, defines: tuple[str, ...]) -> None:
    found = planned(tree, CHECK, torch)
    assert found.python.defines == defines
    assert "torch<1.5" not in bounds(found)
    assert any("-DAT_CHECK=TORCH_CHECK" in each.message for each in found.warnings) == bool(defines)


def test_no_macro_where_more_is_in_the_way(tree: Tree) -> None:
    assert planned(tree, THC + CHECK, "torch==1.12.1").python.defines == ()


def test_what_a_script_of_a_page_compiles(tree: Tree) -> None:
    files = {
        "README.md": "# Net\n## Requirements\n* PyTorch 1.0\n\n## Install\n```\nsh build_and_install.sh\n```\n",
        "build_and_install.sh": "cd lib/ops/\npython setup.py install\n\ncd ../more/\npython setup.py install\n",
        "train.py": "import torch\n",
        "lib/ops/setup.py": SETUP,
        "lib/ops/a.cu": CHECK,
    }
    found = tree(files)
    assert bounds(found) == {"torch==1.7.*"}
    assert found.python.defines == MACRO


SUBMODULE = '[submodule "points"]\n\tpath = points\n\turl = https://github.com/acme/points.git\n'
STREAM = "THCState_getCurrentStream(...)=c10::cuda::getCurrentCUDAStream()"


@pytest.mark.parametrize(
    ("torch", "more", "defines"),
    [
        ("1.0", {".gitmodules": SUBMODULE}, (*MACRO, STREAM)),
        ("1.0", {}, MACRO),  # what is compiled can be read
        ("1.6", {".gitmodules": SUBMODULE, "lib/ops/a.cu": "void f() {}\n"}, ()),  # its code knows the new names
        ("1.8", {".gitmodules": SUBMODULE}, MACRO),  # the image has that torch itself
    ],
)
def test_what_a_missing_submodule_compiles_is_as_old_as_the_torch_that_a_page_names(
    tree: Tree, torch: str, more: dict[str, str], defines: tuple[str, ...]
) -> None:
    files = {
        "README.md": f"# Net\n## Requirements\n* PyTorch {torch}\n\n## Install\n```\nsh build.sh\n```\n",
        "build.sh": "cd points/lib\npython setup.py install\ncd ../../lib/ops/\npython setup.py install\n",
        "train.py": "import torch\n",
        "lib/ops/setup.py": SETUP,
        "lib/ops/a.cu": CHECK,
    }
    found = tree({**files, **more})
    assert found.python.defines == defines
    told = [each for each in found.warnings if each.file == ".gitmodules" and "may have" in each.message]
    assert len(told) == (STREAM in defines)
