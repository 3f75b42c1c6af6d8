"""What uv installs of a project and pip does not: its default groups, one build of a lock that has several."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PROJECT = """\
[project]
name = "demo"
version = "1.0"
dependencies = ["numpy==1.26.4"]
[dependency-groups]
cpu = ["onnxruntime==1.17.0", {include-group = "shapes"}]
shapes = ["shapely==2.0.4", {include-group = "shapes"}]
dev = ["pytest==8.0.0"]
[build-system]
requires = ["setuptools"]
build-backend = "setuptools.build_meta"
"""
CODE = {"demo/__init__.py": "", "demo/main.py": "import onnxruntime\nif __name__ == '__main__':\n    pass\n"}


@pytest.mark.parametrize(
    ("uv", "found"),
    [
        ("default-groups = ['cpu', 'dev']", {"onnxruntime==1.17.0", "shapely==2.0.4"}),
        ("default-groups = 'all'", {"onnxruntime==1.17.0", "shapely==2.0.4"}),
        ("default-groups = ['Shapes']", {"shapely==2.0.4"}),
        ("default-groups = 5", set()),
        ("package = true", set()),
    ],
)
def test_default_groups(tree: Tree, uv: str, found: set[str]) -> None:
    python = tree({**CODE, "pyproject.toml": f"{PROJECT}[tool.uv]\n{uv}\n"}).python
    versions = {each.written for each in (*python.pip, *python.pip_guessed) if each.release}
    assert versions == found


LOCKED = """\
[[package]]
name = "{name}"
version = "{version}"
source = {{ registry = "https://download.pytorch.org/whl/{build}" }}
wheels = [
    {{ url = "https://download.pytorch.org/whl/{name}-{version}-cp310-cp310-linux_x86_64.whl", hash = "sha256:00" }},
]

"""


@pytest.mark.parametrize("builds", [("cpu", "cu121"), ("cu121", "cpu")])
def test_one_build_of_a_lock_with_several(tree: Tree, builds: tuple[str, ...]) -> None:
    lock = "version = 1\n\n" + "".join(
        LOCKED.format(name=name, version=f"{version}+{build}", build=build)
        for name, version in (("torch", "2.3.1"), ("torchvision", "0.18.1"))
        for build in builds
    )
    project = "[project]\nname = 'demo'\nversion = '1'\nrequires-python = '>=3.10,<3.11'\n"
    files = {"pyproject.toml": project, "uv.lock": lock, "README.md": "CUDA 12.1\n"}
    python = tree(
        {**files, "train.py": "import torch, torchvision\nif __name__ == '__main__':\n    torch.cuda.init()\n"}
    )
    bounds = [each.written for each in python.python.bounds if each.key.startswith("torch")]
    assert bounds == ["torch==2.3.1+cu121", "torchvision==0.18.1+cu121"]


SMALL = """\
version = 1

[[package]]
name = "numpy"
version = "1.26.4"
source = { registry = "https://index.example.org/simple" }

[[package]]
name = "requests"
version = "2.31.0"
source = { registry = "https://index.example.org/simple" }
"""
SYNC, PIP = "```\nuv sync\n```\n", "```\npip install -r requirements.txt\n```\n"


@pytest.mark.parametrize(
    ("page", "listed", "installed"),
    [
        (f"{SYNC}Or with pip:\n{PIP}", "numpy==1.24.0\n", False),
        ("", "numpy==1.24.0\n", False),
        (f"{PIP}Or with uv:\n{SYNC}", "numpy==1.24.0\n", True),
        (f"```\npip install -e .\n```\n{PIP}", "numpy==1.24.0\n", True),
        (f"{SYNC}Then:\n{PIP}", "numpy==1.24.0\nshapely==2.0.4\n", True),
        (f"{SYNC}Then:\n{PIP}", "numpy==1.24.0\nrequests==2.31.0\n", True),
        (f"{SYNC}Or with pip:\n{PIP}", "numpy==1.26.4\n", True),
    ],
)
def test_a_list_that_is_the_second_way_beside_a_lock(tree: Tree, page: str, listed: str, installed: bool) -> None:
    project = PROJECT.replace('"numpy==1.26.4"', '"numpy"')
    files = {"pyproject.toml": project, "uv.lock": SMALL, "README.md": f"# Demo\n{page}", "requirements.txt": listed}
    found = tree({**CODE, **files})
    assert found.python.requirements == (("requirements.txt",) if installed else ())
    assert any("uv.lock has another" in each.message for each in found.warnings) is not installed
    assert installed or [each.written for each in found.python.bounds] == ["numpy==1.26.4"]


def test_a_member_of_a_workspace_elsewhere_is_declared(tree: Tree) -> None:
    """Its workspace is another repository: pip takes it from its address, and nothing else has to bring it."""
    needs = '"tsr @ git+https://github.com/o/tsr.git"'
    sources = "[tool.uv.sources]\ntsr = { workspace = true }\n"
    files = {
        "pyproject.toml": f"[project]\nname = 'arm'\nversion = '1'\ndependencies = [{needs}]\n{sources}",
        "src/arm/__init__.py": "from tsr import TSR\n",
        "README.md": "Its planner needs `pip install git+https://github.com/o/tsr`.\n",
    }
    found = tree(files)
    assert [each.written for each in found.python.pip] == ["tsr @ git+https://github.com/o/tsr.git"]
    assert found.python.pip_guessed == ()
    assert not [each.message for each in found.warnings if "tsr" in each.message]
