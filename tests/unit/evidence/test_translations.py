"""Translations of pages."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.prose.pages import pages
from roslab.repository.checkout import Repository

LONG = "pip install demo\n" * 20


@pytest.mark.parametrize(
    ("files", "read"),
    [
        ({"README.md": LONG, "README_zh-CN.md": LONG}, ["README.md"]),
        ({"README.md": LONG, "README.ja.md": LONG, "readme_cn.md": LONG}, ["README.md"]),
        ({"README.md": "see the other\n", "README_zh.md": LONG}, ["README.md", "README_zh.md"]),
        ({"README_zh.md": LONG}, ["README_zh.md"]),
        ({"docs/install.md": LONG, "docs_zh-CN/install.md": LONG}, ["docs/install.md"]),
        ({"docs/en/install.md": LONG, "docs/zh_cn/install.md": LONG}, ["docs/en/install.md"]),
        ({"docs/install.md": LONG, "docs_zh-CN/usage.md": LONG}, ["docs/install.md", "docs_zh-CN/usage.md"]),
        ({"README.md": LONG, "README_ROS2.md": LONG}, ["README.md", "README_ROS2.md"]),
        ({"README.md": LONG, "de/README.md": LONG}, ["README.md"]),
    ],
)
def test_a_translation_is_not_read_beside_its_page(tmp_path: Path, files: dict[str, str], read: list[str]) -> None:
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    assert [page.path for page in pages(Repository.open(tmp_path))] == read
