"""Frameworks whose wheel of the day computes on the CPU alone, and those that only CI installs."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide.decision import Decision
from roslab.decide.kind import decide_kind
from roslab.evidence.gather import gather
from roslab.pipeline import plan_repository
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace


@pytest.mark.parametrize(
    ("day", "kind"),
    [("2019-05-29", "python"), ("2019-12-01", "python"), ("2020-02-01", "cuda"), (None, "cuda")],
)
def test_what_nothing_pins_is_as_pip_had_it_on_the_day(tmp_path: Path, day: str | None, kind: str) -> None:
    (tmp_path / "train.py").write_text("import tensorflow as tf\n")
    evidence = replace(gather(Repository.open(str(tmp_path))), pip_day=day)
    assert decide_kind(evidence, Config()).answer == kind


def test_old_code_of_a_day_with_a_newer_framework_keeps_the_newest_old_one(tmp_path: Path) -> None:
    (tmp_path / "train.py").write_text("import tensorflow as tf\nx = tf.placeholder(tf.float32)\n")
    evidence = gather(Repository.open(str(tmp_path)))
    assert decide_kind(replace(evidence, pip_day="2019-10-10"), Config()).answer == "python"
    assert decide_kind(replace(evidence, pip_day="2019-12-01"), Config()).answer == "cuda"


@pytest.mark.parametrize(("code", "told"), [("tf.placeholder(tf.float32)", True), ("tf.constant(1)", False)])
def test_old_code_whose_framework_nothing_names_loads_the_cuda_of_then(
    tree: Callable[[dict[str, str]], Decision], code: str, told: bool
) -> None:
    files = {"train.py": f"import tensorflow as tf\nx = {code}\n"}
    for more, expected in (({}, told), ({"requirements.txt": "torch\n"}, False)):
        decision = tree({**files, **more})
        assert decision.kind == "cuda"
        warnings = [(w.file, w.line) for w in decision.warnings if w.message.startswith("CUDA 10.0: its images were")]
        assert warnings == [("train.py", 1)] * expected


def test_a_framework_that_only_ci_installs_for_the_tests_is_no_sign_of_cuda(
    tree: Callable[[dict[str, str]], Decision],
) -> None:
    step = "      - run: pip install torch --index-url https://download.pytorch.org/whl/cpu\n      - run: pytest\n"
    files = {
        "pyproject.toml": "[project]\nname = 'demo'\nversion = '1'\ndependencies = ['numpy']\n",
        ".github/workflows/ci.yaml": f"jobs:\n  test:\n    steps:\n{step}",
        "src/walker/convert.py": "def to_torch():\n    import torch\n    torch.ones(1)\n",
    }
    decision = tree(files)
    assert decision.kind == "python"
    assert decision.platforms == ("linux/amd64", "linux/arm64")
    assert tree({**files, "src/walker/model.py": "import torch\n"}).kind == "cuda"


PACKAGE = "<package><name>node</name><buildtool_depend>catkin</buildtool_depend></package>"
ROS = {
    "ws/node/package.xml": PACKAGE,
    "ws/node/CMakeLists.txt": "find_package(catkin REQUIRED)\ncatkin_package()\n",
    "requirements.txt": "tensorflow==2.9.1\n",
}


@pytest.mark.parametrize(
    ("files", "told"),
    [
        ({"README.md": "# A\n- Install CUDA 11.2 at least.\n"}, True),
        ({"README.md": "# A\nWe measured it with CUDA 11.2.\n"}, False),
        ({"README.md": "# A\n- Install CUDA 11.2 at least.\n", "requirements.txt": "numpy\n"}, False),
        ({"README.md": "# A\n- Install CUDA 11.2 at least.\n", "roslab.yaml": "format: 3\ngpu: true\n"}, False),
    ],
)
def test_a_page_that_requires_cuda_is_told_where_the_image_has_none(
    tmp_path: Path, files: dict[str, str], told: bool
) -> None:
    for path, text in {**ROS, **files}.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    warnings = plan_repository(tmp_path, branch=None).plan.warnings
    assert any("requires CUDA 11.2" in each.message for each in warnings) == told
