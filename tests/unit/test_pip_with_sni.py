"""Python before 2.7.9 has no SNI, without which PyPI gives no files: pip uses pyOpenSSL there."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render.dockerfile import dockerfile

PACKAGE = (
    "<package format='2'><name>car</name><version>1.0.0</version><description/>"
    "<maintainer email='a@b.c'>a</maintainer><license>MIT</license>"
    "<buildtool_depend>catkin</buildtool_depend></package>"
)
CMAKE = "cmake_minimum_required(VERSION 2.8.3)\nproject(car)\nfind_package(catkin REQUIRED)\ncatkin_package()\n"


@pytest.mark.parametrize(("distro", "old"), [("indigo", True), ("kinetic", False)])
def test_pip_of_trusty(tmp_path: Path, distro: str, old: bool) -> None:
    files = {
        "src/car/package.xml": PACKAGE,
        "src/car/CMakeLists.txt": CMAKE,
        "deep_car/setup.py": "from distutils.core import setup\nsetup(name='deep_car', packages=['deep_car'])\n",
        "deep_car/deep_car/__init__.py": "",
        "roslab.yaml": f'format: 3\nbase:\n  ros: {distro}\n  python: "2.7"\n',
    }
    for path, text in files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text, encoding="utf-8")
    plan = plan_repository(tmp_path).plan
    assert any("has no SNI" in each.why for each in plan.upstreams) is old
    text = dockerfile(plan)
    assert "--editable ./deep_car" in text
    assert ("python2 -m pip install --upgrade 'pip<9'" in text) is old
    assert ("pip<21" in text) is not old
    assert all((f"      {name} \\\n" in text) is old for name in ("python-openssl", "python-ndg-httpsclient"))
