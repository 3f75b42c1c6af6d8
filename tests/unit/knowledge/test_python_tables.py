"""Facts about Python packages that decisions ask for by name."""

from __future__ import annotations

import pytest

from roslab.knowledge.frameworks import framework, framework_on_cuda, never_released, tabled
from roslab.knowledge.guesses import same_module, tooling, tools_of_developers
from roslab.knowledge.table import rows
from roslab.knowledge.tools import for_old_packages, python2_installers, python_tools, tool_image, why_bounded


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
        ("psycopg2", "psycopg2-binary", True),
        ("urdf-parser-py", "urdfdom-py", True),
        ("dlib", "dlib-bin", True),
        ("zenoh", "eclipse-zenoh", True),
        ("numpy", "scipy", False),
    ],
)
def test_packages_of_one_module(name: str, other: str, same: bool) -> None:
    assert same_module(name, other) is same


def test_tools_are_of_two_kinds() -> None:
    assert "pip" in tooling("installers")
    assert "pytest" in tooling("developers")
    assert {"pre-commit", "pytest"} <= tools_of_developers()
    assert not tooling("installers") & tools_of_developers()


def test_packages_that_share_the_rows_of_a_framework() -> None:
    assert (tabled("jaxlib"), framework_on_cuda("jaxlib")) == ("jax", "jax")
    assert (tabled("tensorflow-cpu"), framework_on_cuda("tensorflow-cpu")) == ("tensorflow", None)
    assert (tabled("numpy"), framework_on_cuda("numpy")) == ("numpy", None)


def test_pins_of_tools() -> None:
    assert python2_installers()[0] == "pip<21"
    assert tool_image("micromamba").startswith("mambaorg/micromamba:")


@pytest.mark.parametrize(
    ("version", "lines"),
    [
        ("3.10", {"pip<24.1": "metadata"}),
        ("3.8", {"pip<24.1": "metadata", "setuptools<76": "python", "wheel<0.46": "python"}),
        ("3.6", {"pip<22": "python", "setuptools<60": "python", "wheel<0.38": "python"}),
        ("3.7", {"pip<24.1": "python", "setuptools<69": "python", "wheel<0.43": "python"}),
    ],
)
def test_why_an_installer_is_not_today_s(version: str, lines: dict[str, str]) -> None:
    found = for_old_packages(python_tools(version, None)).installers
    words = {"python": "do not run on the image's Python", "metadata": "refuse packages"}
    told = {line.partition(";")[0]: why for line in found if (why := why_bounded(line))}
    assert {pin: next(kind for kind, text in words.items() if text in why) for pin, why in told.items()} == lines
    assert all(words["python"] in why_bounded(line) for line in python2_installers())
    beside = ('pip<21; python_version < "3"', 'pip<24.1; python_version < "3.8" and python_version >= "3"')
    assert all(words["python"] in why_bounded(line) for line in beside)
    assert "do not work with newer ones" in why_bounded("setuptools<70")


def test_numbers_that_were_left_out_lie_between_two_releases_of_the_table() -> None:
    for row in rows("frameworks"):
        assert not never_released(row["package"], row["first"]), row
    for row in rows("never_released"):
        series = [each["first"] for each in rows("frameworks") if each["package"] == row["package"]]
        assert row["before"] in {f"{each}.0" if each.isdigit() else each for each in series}, row
        assert never_released(row["package"], row["first"])


def test_a_candidate_of_a_release_is_of_that_release() -> None:
    assert not never_released("torch", "1.0rc0")
    assert never_released("torch", "0.7.0+cu92")
    assert never_released("tensorflow-gpu", "1.17")
    assert not never_released("torch", "latest")
    assert not never_released("numpy", "0.7")


@pytest.mark.parametrize(
    ("name", "release", "cuda", "python"),
    [("torch", "2.10.0", "12.8", "3.14"), ("torch", "2.15.0", "13.2", "3.15"), ("jax", "0.12.0", "12.9", "3.15")],
)
def test_the_newest_rows_are_those_of_the_index(name: str, release: str, cuda: str, python: str) -> None:
    row = framework(name, release)
    assert row is not None
    assert (row.cuda[0], row.python_max) == (cuda, python)
    assert row.released
