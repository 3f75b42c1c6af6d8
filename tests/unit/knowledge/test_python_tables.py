"""Facts about Python packages that decisions ask for by name."""

from __future__ import annotations

import pytest

from roslab.knowledge.frameworks import framework_on_cuda, tabled
from roslab.knowledge.guesses import same_module, tooling
from roslab.knowledge.tools import python2_installers, tool_image


@pytest.mark.parametrize(
    ("name", "other", "same"),
    [
        ("opencv-python", "opencv-contrib-python-headless", True),
        ("pyyaml", "yaml", True),
        ("mmcv", "mmcv-full", True),
        ("faiss-cpu", "faiss-gpu", True),
        ("faiss-cpu", "faiss-gpu-cu12", True),
        ("faiss-cpu", "faiss", True),  # conda's name
        ("onnxruntime", "onnxruntime-gpu", True),
        ("onnxruntime", "onnxruntime-extensions", False),
        ("hydra-core", "hydra-colorlog", False),
        ("numpy", "scipy", False),
    ],
)
def test_packages_of_one_module(name: str, other: str, same: bool) -> None:
    assert same_module(name, other) is same


def test_tools_are_of_two_kinds() -> None:
    assert "pip" in tooling("installers")
    assert "pytest" in tooling("developers")
    assert not tooling("installers") & tooling("developers")


def test_packages_that_share_the_rows_of_a_framework() -> None:
    assert (tabled("jaxlib"), framework_on_cuda("jaxlib")) == ("jax", "jax")
    assert (tabled("tensorflow-cpu"), framework_on_cuda("tensorflow-cpu")) == ("tensorflow", None)
    assert (tabled("numpy"), framework_on_cuda("numpy")) == ("numpy", None)


def test_pins_of_tools() -> None:
    assert python2_installers()[0] == "pip<21"
    assert tool_image("micromamba").startswith("mambaorg/micromamba:")
