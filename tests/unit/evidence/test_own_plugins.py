"""A nodelet that the tree declares under another prefix than its package's name needs no package of that name."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.ros import launch
from roslab.repository.checkout import Repository

LAUNCH = '<launch>\n<node pkg="nodelet" type="nodelet" name="a" args="load old_name/Loop m"/>\n</launch>\n'
PLUGIN = '<library path="lib/x">\n<class {} base_class_type="nodelet::Nodelet"/>\n</library>\n'


def needed(folder: Path, files: dict[str, str]) -> list[str]:
    for path, text in {"demo/launch/a.launch": LAUNCH, "demo/package.xml": "<package><name>demo</name>"}.items():
        files.setdefault(path, text)
    for path, text in files.items():
        target = folder / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text)
    return [each.name for file in launch.read(Repository.open(folder)) for each in file.dependencies]


@pytest.mark.parametrize(
    ("declared", "more"),
    [
        ('name="old_name/Loop" type="demo::Loop"', []),
        ('type="old_name::Loop"', []),
        ('name="demo/Loop" type="old_name::Loop"', ["old_name"]),
        ('name="old_name/Other" type="demo::Loop"', ["old_name"]),
    ],
)
def test_a_declared_class(tmp_path: Path, declared: str, more: list[str]) -> None:
    assert needed(tmp_path, {"demo/plugins.xml": PLUGIN.format(declared)}) == ["nodelet", *more]


def test_a_description_that_is_commented_out(tmp_path: Path) -> None:
    text = PLUGIN.format('name="old_name/Loop" type="demo::Loop"')
    assert needed(tmp_path, {"demo/plugins.xml": f"<!-- {text} -->"}) == ["nodelet", "old_name"]


def test_a_package_of_the_tree_is_needed_all_the_same(tmp_path: Path) -> None:
    text = PLUGIN.format('name="old_name/Loop" type="demo::Loop"')
    files = {"old_name/plugins.xml": text, "old_name/package.xml": "<package><name>old_name</name>"}
    assert needed(tmp_path, files) == ["nodelet", "old_name"]
