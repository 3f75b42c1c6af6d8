"""An extension whose sources include what a licensed program makes does not stop the image, and is told."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
SETUP = (
    "from setuptools import Extension, setup\nfrom Cython.Build import cythonize\n"
    "import os\nsources = [os.path.join('sim', 'model.pyx'), os.path.join('src', 'wrapper.cpp')]\n"
    "setup(name='sim', install_requires=['numpy', 'scipy'], ext_modules=cythonize([Extension('sim', sources)]))\n"
)
FILES = {
    "binds/setup.py": SETUP,
    "binds/sim/__init__.py": "",
    "binds/src/wrapper.cpp": '#include "wrapper.h"\n',
    "binds/src/wrapper.h": '#ifndef WRAPPER_H\n#define WRAPPER_H\n#include "rtwtypes.h"\n#endif\n',
}


def lost(decision: Decision) -> list[tuple[str, list[str]]]:
    return [(folder, [each.written for each in asked]) for folder, asked in decision.python.lost_extensions]


def said(decision: Decision) -> list[tuple[str, int, str]]:
    told = (each for each in decision.warnings if "pip will stop at that" in each.message)
    return [(each.file or "", each.line or 0, each.message) for each in told]


@pytest.mark.parametrize(
    ("header", "tool"), [("rtwtypes.h", "Simulink"), ("sub/rtw_modelmap.h", "Simulink"), ("tmwtypes.h", "MATLAB")]
)
def test_what_it_requires_is_installed_where_pip_stops_at_it(tree: Tree, header: str, tool: str) -> None:
    decision = tree({**FILES, "binds/src/wrapper.h": FILES["binds/src/wrapper.h"].replace("rtwtypes.h", header)})
    assert decision.python.projects == ("binds",)
    assert lost(decision) == [("binds", ["numpy", "scipy"])]
    ((file, line, message),) = said(decision)
    assert (file, line) == ("binds/src/wrapper.h", 3)
    assert f"{header.rpartition('/')[2]}, which {tool} makes" in message
    assert "the extension of sim includes it" in message


@pytest.mark.parametrize(
    "files",
    [
        {"build/model/rtwtypes.h": "typedef int int_T;\n"},  # its code is in the tree
        {"binds/src/wrapper.h": '#include "types.h"\n#include "Eigen/Dense"\n'},
        {"binds/src/wrapper.h": '#ifdef WITH_MODEL\n#include "rtwtypes.h"\n#endif\n'},
        {"binds/src/wrapper.cpp": "int x;\n", "binds/src/unused.cpp": '#include "rtwtypes.h"\n'},  # not compiled
        {"binds/setup.py": SETUP + "open('src/rtwtypes.h', 'w').write('typedef int int_T;')\n"},
        {".gitmodules": '[submodule "m"]\n\tpath = m\n\turl = https://github.com/lab/m\n'},  # it may be there
    ],
)
def test_what_is_there_or_may_be_there_is_not_told(tree: Tree, files: dict[str, str]) -> None:
    decision = tree({**FILES, **files})
    assert "binds" in decision.python.projects
    assert lost(decision) == []
    assert said(decision) == []


def test_each_project_is_told_once_and_only_where_it_is_installed(tree: Tree) -> None:
    header = FILES["binds/src/wrapper.h"].replace("#endif", '#include "rt_nonfinite.h"\n#endif')
    other = {f"{folder}/{path}".replace("/binds", ""): text for path, text in FILES.items() for folder in ("b", "docs")}
    decision = tree({**FILES, "binds/src/wrapper.h": header, **other})
    assert decision.python.projects == ("b", "binds")
    assert [folder for folder, _ in lost(decision)] == ["b", "binds"]
    assert sorted(file for file, _, _ in said(decision)) == ["b/src/wrapper.h", "binds/src/wrapper.h"]
