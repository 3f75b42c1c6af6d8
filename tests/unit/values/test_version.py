"""Version numbers as repositories write them."""

from __future__ import annotations

import pickle
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.values.version import InvalidVersion, Version, version_of


@pytest.mark.parametrize(
    ("text", "release"),
    [("3.1", (3, 1)), ("\u0663.\u0661\u0660", (3, 10)), ("9" * 5000 + ".1", (int("9" * 18), 1)), ("1.0rc1", (1, 0))],
)
def test_a_number(text: str, release: tuple[int, ...]) -> None:
    assert Version(text).release == release
    assert pickle.loads(pickle.dumps(Version(text))) == version_of(text)  # noqa: S301 - its own


def test_no_number() -> None:
    with pytest.raises(InvalidVersion):
        Version("three")
    assert version_of("³.1") is None


@pytest.mark.parametrize("number", ["\u0663.\u0661", "9" * 5000 + ".1"])
def test_a_plan_of_a_tree_with_such_numbers(tmp_path: Path, number: str) -> None:
    """Each of these places is compared with what an Ubuntu has."""
    lines = (
        f"cmake_minimum_required(VERSION {number})",
        "project(demo)",
        f"find_package(Boost {number} REQUIRED)",
        "find_package(NLopt REQUIRED)",
        "add_executable(demo main.cpp)",
    )
    page = (
        f"# Demo\nUbuntu 20.04\n## Dependencies\n- Eigen {number} or newer\n\n```\n"
        f"git clone https://github.com/stevengj/nlopt.git -b {number}\ncd nlopt && mkdir build && cd build\n"
        "cmake .. && make && sudo make install\n```\n"
    )
    (tmp_path / "CMakeLists.txt").write_text("\n".join(lines), encoding="utf-8")
    (tmp_path / "README.md").write_text(page, encoding="utf-8")
    (tmp_path / "main.cpp").write_text("int main() {}\n", encoding="utf-8")
    assert plan_repository(tmp_path).plan.kind == "cpp"
