"""An author's Dockerfile without a package that the command of a page imports at its top."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
DOCKER = "FROM {base}\nWORKDIR /work\nCOPY . /work\n{steps}\n"
PAGE = "# Demo\n## Usage\n```\npython show.py --size 3\n```\n"
SHOW = "import numpy\nimport open3d as o3d\n\nif __name__ == '__main__':\n    print(o3d)\n"


@pytest.mark.parametrize(
    ("steps", "believed"),
    [
        ("RUN pip install torch numpy", False),
        ("RUN pip install torch open3d==0.18", True),
        ("RUN pip install open3d-cpu", True),
        ("RUN apt-get update && apt-get install -y python3-open3d", True),
        ("RUN pip install -r requirements.txt", False),
        ("RUN pip install -r requirements.txt -r viewer.txt", True),  # a file that is not read as one of requirements
        ("RUN ./install.sh", True),
        ("RUN conda env update -f environment.yml", True),
        ("RUN pip install $PACKAGES", True),
        ("RUN pip install git+https://github.com/isl-org/Open3D", True),
        ("RUN pip install torch\nCMD python other.py", True),
        ("RUN apt-get update && apt-get install -y python3-pip git && python3 -m pip install 'numpy<2' tqdm", False),
        ("RUN pip install openmim && mim install mmcv", True),
        ("RUN pip install lerobot", True),  # nobody knows what else this brings
        ("RUN pip install 'torch[opt-einsum]'", True),
        ("RUN pip install /wheels/*.whl", True),
        ("RUN pip install numpy -r https://acme.org/list/requirements.txt", True),
        ("RUN pip install numpy && pip-sync", True),
        ("RUN git clone https://github.com/lab/acme /opt/acme && cd /opt/acme && pip install -e .", True),
        ("RUN cd /opt/acme && pip install -e .", True),
        ("RUN wget -O - https://acme.org/install | bash", True),
        ("RUN bash ./install", True),
        ("RUN python tools/fetch.py", True),
        ("RUN apt-get update && apt-get install -y python3-acme", True),
    ],
)
def test_a_package_that_nothing_in_it_installs(tree: Tree, steps: str, *, believed: bool) -> None:
    files = {
        "show.py": SHOW,
        "other.py": SHOW,
        "README.md": PAGE,
        "requirements.txt": "numpy\n",
        "install.sh": "true\n",
        "install": "true\n",
    }
    files |= {"viewer.txt": "open3d\n", "environment.yml": "dependencies:\n  - open3d\n"}
    found = tree({**files, "Dockerfile": DOCKER.format(base="python:3.10", steps=steps)})
    assert (found.dockerfile == "Dockerfile") == believed
    if not believed:
        said = next(reason for reason in found.reasons if reason.question == "dockerfile")
        assert "open3d, which show.py:2 imports" in said.reason


@pytest.mark.parametrize(
    "base",
    [
        "lab/robot:latest",
        "lab/open3d:focal",
        "nvcr.io/nvidia/pytorch:23.01-py3",
        "pytorch/pytorch:2.1.0-cuda12.1-cudnn8-devel",
    ],
)
def test_of_another_base_nobody_knows_what_it_has(tree: Tree, base: str) -> None:
    files = {"show.py": SHOW, "README.md": PAGE, "requirements.txt": "numpy\n"}
    docker = DOCKER.format(base=base, steps="RUN pip install tqdm")
    assert tree({**files, "Dockerfile": docker}).dockerfile == "Dockerfile"


@pytest.mark.parametrize(
    "top", ["import scipy\n", "import cv2\n", "try:\n    import open3d\nexcept ImportError:\n    pass\n"]
)
def test_what_others_bring_and_what_may_fail(tree: Tree, top: str) -> None:
    files = {
        "show.py": f"{top}if __name__ == '__main__':\n    pass\n",
        "README.md": PAGE,
        "requirements.txt": "torch\n",
    }
    docker = DOCKER.format(base="python:3.10", steps="RUN pip install -r requirements.txt")
    assert tree({**files, "Dockerfile": docker}).dockerfile == "Dockerfile"


def test_a_module_of_the_tree_is_there(tree: Tree) -> None:
    files = {"show.py": SHOW, "open3d/__init__.py": "", "README.md": PAGE, "requirements.txt": "numpy\n"}
    docker = DOCKER.format(base="python:3.10", steps="RUN pip install numpy")
    assert tree({**files, "Dockerfile": docker}).dockerfile == "Dockerfile"


def test_files_of_another_image_may_have_it(tree: Tree) -> None:
    files = {"show.py": SHOW, "README.md": PAGE, "requirements.txt": "numpy\n"}
    docker = DOCKER.format(base="python:3.10", steps="COPY --from=lab/open3d:1 /usr/local /usr/local")
    assert tree({**files, "Dockerfile": docker}).dockerfile == "Dockerfile"


@pytest.mark.parametrize(("needs", "believed"), [("['numpy']", False), ("['numpy', 'acme']", True), ("read()", True)])
def test_the_project_of_the_tree_is_one_whose_needs_are_read(tree: Tree, needs: str, *, believed: bool) -> None:
    setup = f"from setuptools import setup\nsetup(name='play', packages=['play'], install_requires={needs})\n"
    files = {"show.py": SHOW, "play/__init__.py": "", "setup.py": setup, "README.md": PAGE}
    docker = DOCKER.format(base="python:3.10", steps="RUN pip install -e .")
    assert (tree({**files, "Dockerfile": docker}).dockerfile == "Dockerfile") == believed


def test_what_a_known_package_brings_is_there(tree: Tree) -> None:
    files = {"show.py": "import pywt\n", "README.md": PAGE}
    docker = DOCKER.format(base="python:3.10", steps="RUN pip install scikit-image")
    assert tree({**files, "Dockerfile": docker}).dockerfile == "Dockerfile"
