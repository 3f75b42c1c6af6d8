"""NumPy's limit heeds every release that the image gets, whoever names it: a page, a lock or the image's CUDA."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.decide.python.torch_build import numpy_of
from roslab.values.requirement_line import stated

Tree = Callable[[dict[str, str]], Decision]
LISTS = {"run.py": "import torch\nimport numpy\n", "requirements.txt": "torch\nnumpy\n"}


@pytest.mark.parametrize(("torch", "limited"), [("2.2.0", True), ("2.4.0", False)])
def test_a_torch_that_only_a_page_pins(tree: Tree, torch: str, limited: bool) -> None:
    page = f"# Net\n```\npip install torch=={torch}\npip install -r requirements.txt\n```\n"
    written = {each.written for each in tree({**LISTS, "README.md": page}).python.bounds}
    assert f"torch=={torch}" in written
    assert ("numpy<2" in written) is limited


@pytest.mark.parametrize(
    ("asked", "limited"),
    [
        (["torch", "numpy", "torch==2.2.0"], True),
        (["torch", "numpy", "torch==2.2.*"], True),
        (["torch", "torch<2.3"], True),
        (["torch", "torch<2.4"], False),
        (["torch==2.2.0", "numpy", "numpy==2.1.0"], False),
        (["torch==2.2.0", "numpy", "numpy==1.21.5"], False),
        (["torch", "torch>=2.2", "numpy"], False),
    ],
)
def test_limits_count_like_what_is_asked_for(asked: list[str], limited: bool) -> None:
    assert [each.written for each in numpy_of(map(stated, asked)).answer] == ["numpy<2"] * limited


def robot(distro: str, code: str, lists: str) -> dict[str, str]:
    manifest = (
        "<package format='3'><name>eyes</name><version>1.0.0</version><description>d</description>"
        "<maintainer email='a@b.c'>a</maintainer><license>MIT</license><exec_depend>rclpy</exec_depend>"
        "<export><build_type>ament_python</build_type></export></package>"
    )
    page = f"Made for ROS 2 {distro.title()}.\n\n    pip install -r requirements.txt\n"
    setup = "from setuptools import setup\nsetup(name='eyes', packages=['eyes'])\n"
    page += f"\n    source /opt/ros/{distro}/setup.bash\n"
    files = {"README.md": page, "src/eyes/package.xml": manifest, "src/eyes/setup.py": setup}
    return {**files, "src/eyes/eyes/look.py": code, "requirements.txt": lists}


@pytest.mark.parametrize(
    ("distro", "code", "lists", "limit"),
    [
        ("humble", "import cv_bridge\nimport mediapipe\n", "mediapipe\n", {"numpy<2"}),
        ("jazzy", "import cv_bridge\nimport mediapipe\n", "mediapipe\n", {"numpy<2"}),
        ("jazzy", "import cv_bridge\n", "mediapipe\nnumpy>=2\n", set()),
        ("humble", "import cv_bridge\n", "opencv-python==4.11.0.86\n", {"numpy<2"}),
        ("humble", "import cv_bridge\n", "opencv-python\n", {"numpy<2"}),
        ("humble", "import cv_bridge\n", "opencv-python==4.12.0.88\n", set()),
        ("humble", "import cv_bridge\n", "mediapipe\nnumpy>=1.24.0,<2.0.0\n", {"numpy<2"}),  # for later calls of pip
        ("humble", "import cv_bridge\n", "mediapipe\nnumpy==1.21.5\n", {"numpy<2"}),
        ("humble", "import cv_bridge\n", "mediapipe\nnumpy~=1.26\n", {"numpy<2"}),
        ("humble", "import cv_bridge\n", "mediapipe\nnumpy==2.1.0\n", set()),
        ("humble", "import cv_bridge\n", "mediapipe\nnumpy==2.*\n", set()),
        ("humble", "import cv_bridge\n", "mediapipe\nnumpy>=2,<2.3\n", set()),
        ("humble", "import cv_bridge\n", "mediapipe\nnumpy<2.3\n", set()),  # the author's own choice
        ("jazzy", "import cv_bridge\n", "jax>=0.7.2\n", set()),
        ("jazzy", "import cv_bridge\n", "setuptools<80\n", set()),
        ("jazzy", "import mediapipe\n", "mediapipe\n", set()),
        ("jazzy", "import matplotlib\n", "matplotlib\n", set()),
        ("foxy", "import cv_bridge\n", "mediapipe\n", set()),  # its Python has no NumPy 2
        ("foxy", "import numpy as np\nx = np.float(1)\n", "numpy>=1.22.0\n", {"numpy<1.24"}),
        ("jazzy", "import numpy as np\nx = np.float(1)\n", "numpy>=1.22.0\n", set()),  # the distribution's will do
        ("foxy", "import numpy as np\nx = np.float(1)\n", "gym\n", {"numpy<1.24"}),  # what gym needs is not known
        ("foxy", "import numpy as np\nx = np.float(1)\n", "gym\nnumpy\n", {"numpy<1.24"}),
        ("foxy", "import numpy as np\nx = np.float(1)\n", "gym\nnumpy==1.18.5\n", set()),
        ("foxy", "import numpy as np\nx = np.float(1)\n", "setuptools<80\nnumpy\n", set()),
        ("jazzy", "import numpy as np\nx = np.float(1)\n", "gym\n", set()),
        ("humble", "import numpy as np\nx = np.float(1)\n", "opencv-python==4.12.0.88\n", set()),
        ("humble", "import numpy as np\nx = np.float(1)\n", "scikit-image==0.25.0\n", set()),
        ("humble", "import numpy as np\nx = np.float(1)\n", "scikit-image==0.19.3\n", {"numpy<1.24"}),
        ("humble", "import numpy as np\nx = np.float(1)\n", "scikit-image\n", {"numpy<1.24"}),
        ("humble", "import numpy as np\nimport cv_bridge\nx = np.float(1)\n", "numba>=0.61\n", {"numpy<2"}),
        ("foxy", "import scipy.spatial\n", "albumentations==1.4.18\n", set()),
        ("foxy", "import scipy.spatial\n", "gym\n", {"numpy<1.24"}),
        ("foxy", "import cv_bridge\nimport scipy.spatial\n", "gym\n", {"numpy<1.24"}),
        ("foxy", "import scipy.spatial\n", "gym\nscipy\n", set()),  # pip's own scipy
        ("foxy", "import scipy.spatial\n", "gym\nnumpy>=1.24\n", set()),
        ("foxy", "import scipy.spatial\n", "", set()),
        ("humble", "import scipy.spatial\n", "gym\n", {"numpy<2"}),
    ],
)
def test_beside_what_the_distribution_built(tree: Tree, distro: str, code: str, lists: str, limit: set[str]) -> None:
    written = {each.written for each in tree(robot(distro, code, lists)).python.bounds}
    assert {each for each in written if each.startswith("numpy")} == limit


def test_a_release_that_needs_numpy_2_is_told(tree: Tree) -> None:
    lists = "tqdm\nopencv-contrib-python-headless==4.12.0.88\n"
    (told,) = (w for w in tree(robot("humble", "import cv_bridge\n", lists)).warnings if "NumPy" in w.message)
    assert (told.file, told.line) == ("requirements.txt", 2)
    assert "the distribution's cv_bridge fails to load" in told.message
    code = "import mediapipe\n"
    assert not any("NumPy" in w.message for w in tree(robot("humble", code, lists)).warnings)


@pytest.mark.parametrize(("release", "told"), [("0.25.0", True), ("0.19.3", False)])
@pytest.mark.parametrize("ros", [True, False])
def test_a_release_that_needs_a_numpy_without_what_the_code_uses_is_told(
    tree: Tree, ros: bool, release: str, told: bool
) -> None:
    code, lists = "import numpy as np\nimport skimage\nx = np.float(1)\n", f"scikit-image=={release}\nnumpy\n"
    decision = tree(robot("humble", code, lists) if ros else {"run.py": code, "requirements.txt": lists})
    assert ("numpy<1.24" in {each.written for each in decision.python.bounds}) is not told
    said = [each.message for each in decision.warnings if "np.float" in each.message]
    assert bool(said) is told
    assert all("scikit-image==0.25.0 needs one" in each for each in said)


@pytest.mark.parametrize(
    ("lists", "line", "code", "given_way"),
    [
        ("lab6", "numpy==2.1.0", "import cv_bridge\n", True),
        ("lab6", "numpy>=2.0", "import cv_bridge\n", True),
        ("lab6", "numpy>=1.20", "import cv_bridge\n", False),
        ("lab6", "numpy==2.1.0", "import rclpy\n", False),
        ("src", "numpy==2.1.0", "import cv_bridge\n", False),
        ("src/eyes", "numpy==2.1.0", "import cv_bridge\n", False),
    ],
)
def test_a_list_without_nodes_gives_way_to_them(tree: Tree, lists: str, line: str, code: str, given_way: bool) -> None:
    files = robot("humble", code, "")
    del files["requirements.txt"]
    page = files["README.md"].replace("requirements.txt", f"{lists}/requirements.txt")
    lab = {f"{lists}/requirements.txt": f"{line}\npyserial==3.5\n", f"{lists}/lab.py": "import numpy\n"}
    decision = tree({**files, **lab, "README.md": page})
    told = [each.message for each in decision.warnings if "gives way to numpy<2" in each.message]
    assert len(told) == given_way
    written = {each.written for each in decision.python.pip}
    assert ({"numpy", "pyserial==3.5"} <= written) is given_way
    if given_way:
        assert f"{lists}/requirements.txt" not in decision.python.requirements
        assert "numpy<2" in {each.written for each in decision.python.bounds}
