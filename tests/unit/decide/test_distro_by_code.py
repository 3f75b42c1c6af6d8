"""What code names in passing tells the distribution where only the date of the last commit would."""

from __future__ import annotations

from pathlib import Path

import pytest

from trees import decided

BASE = {
    "package.xml": "<package format='3'><name>mapper</name><exec_depend>rclpy</exec_depend><export>"
    "<build_type>ament_python</build_type></export></package>",
    "setup.py": "from setuptools import setup\nsetup(name='mapper', packages=['mapper'])\n",
    "mapper/__init__.py": "",
}
STORE = "import rclpy\nfrom rosbags.typesys import Stores, get_typestore\nSTORE = get_typestore(Stores.ROS2_HUMBLE)\n"
LINK = "import rclpy\n# taken from https://github.com/acme/tools/blob/humble/tools/cloud.py\n"
UNNAMED = "nothing says which ROS distribution"


@pytest.mark.parametrize(
    ("files", "distro", "told"),
    [
        ({"mapper/a.py": STORE}, "humble", False),
        ({"mapper/a.py": LINK}, "humble", False),
        ({"mapper/a.py": LINK.replace("blob", "tree")}, "humble", False),
        ({"mapper/a.py": LINK.replace("taken from", "see")}, "jazzy", True),
        ({"mapper/a.py": LINK + LINK.replace("taken from", "see").replace("acme", "b")}, "humble", False),
        (
            {"mapper/a.py": LINK.replace("taken from", "see") + "# https://github.com/b/c/tree/humble/d\n"},
            "humble",
            False,
        ),
        ({"mapper/a.py": LINK, "mapper/b.py": STORE.replace("HUMBLE", "JAZZY")}, "jazzy", False),
        ({"mapper/a.py": "import rclpy\n"}, "jazzy", True),
        ({"mapper/a.py": STORE.replace("HUMBLE", "FOXY")}, "jazzy", True),  # it had ended
        ({"mapper/a.py": STORE + "OTHER = Stores.ROS2_JAZZY\n"}, "jazzy", True),  # it reads both
        ({"mapper/a.py": STORE.replace("STORE =", "# STORE =")}, "jazzy", True),
        ({"mapper/a.py": LINK.replace("humble", "rolling")}, "jazzy", True),
        ({"mapper/a.py": LINK.replace("blob/humble/tools", "blob/main/humble")}, "jazzy", True),
        ({"test/a.py": STORE}, "jazzy", True),
        ({"mapper/a.py": STORE, "README.md": "Tested on ROS 2 Jazzy.\n"}, "jazzy", False),
    ],
)
def test_a_sign_in_the_code(tmp_path: Path, files: dict[str, str], distro: str, *, told: bool) -> None:
    found = _decided(tmp_path, files, "2026-04-07")
    assert found == (distro, told)


@pytest.mark.parametrize(("named", "distro", "told"), [("JAZZY", "jazzy", False), ("FOXY", "humble", True)])
def test_without_a_date_an_old_one_is_an_example(tmp_path: Path, named: str, distro: str, *, told: bool) -> None:
    assert _decided(tmp_path, {"mapper/a.py": STORE.replace("HUMBLE", named)}, "") == (distro, told)


def _decided(folder: Path, files: dict[str, str], day: str) -> tuple[str | None, bool]:
    decision = decided(folder, {**BASE, **files}, day)
    return decision.ros_distro, any(UNNAMED in warning.message for warning in decision.warnings)
