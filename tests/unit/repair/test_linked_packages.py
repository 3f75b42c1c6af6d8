"""A package that pip's index does not have: the repository of its name to which a page links."""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from roslab.cli.repairing import given
from roslab.explain.answer import explain
from roslab.pipeline import plan_repository
from roslab.repair.repair import repair
from trees import tree_of

PAGE = "# Arm\n\nSee [arm-np-tools](https://github.com/{}/arm-np-tools{}).\n"
ORIGIN = '[remote "origin"]\n\turl = https://github.com/lab/arm_envs.git\n'
LOG = """\
#6 [3/4] RUN pip install -r requirements.txt
#6 1.2 ERROR: Could not find a version that satisfies the requirement {0} (from versions: none)
#6 1.3 ERROR: No matching distribution found for {0}
#6 ERROR: process "/bin/sh -c pip install -r requirements.txt" did not complete: exit code: 1
"""
FROM_GIT = "arm_np_tools @ git+https://github.com/{}/arm-np-tools{}"


@pytest.mark.parametrize(
    ("page", "name", "value", "certain"),
    [
        (PAGE.format("lab", ""), "arm_np_tools", FROM_GIT.format("lab", ""), True),
        (PAGE.format("lab", "/tree/v2"), "arm_np_tools", FROM_GIT.format("lab", "@v2"), True),
        (PAGE.format("other", ""), "arm_np_tools", FROM_GIT.format("other", ""), False),
        (PAGE.format("other", "").replace("See", "Install"), "arm_np_tools", FROM_GIT.format("other", ""), True),
        (PAGE.format("lab", ""), "arm_np_tools==1.0", "", True),
        (PAGE.format("lab", ""), "arm_tools", "", True),
        ("# Arm\n", "arm_np_tools", "", True),
        (PAGE.format("isl-org", "").replace("arm-np-tools", "open3d"), "open3d", "", True),  # for other Pythons
        (PAGE.format("lab", "").replace("arm-np-tools", "arm_envs"), "arm_envs", "", True),  # the repository itself
    ],
)
def test_it_is_taken_from_there(tmp_path: Path, page: str, name: str, value: str, certain: bool) -> None:
    files = {"README.md": page, ".git/config": ORIGIN, "requirements.txt": f"{name}\n", "main.py": "import six\n"}
    tree_of(tmp_path, files)
    found = repair(explain(io.BytesIO(LOG.format(name).encode())), given(plan_repository(tmp_path)))
    assert [(change.key, change.value) for change in found.changes] == ([("pip", value)] if value else [])
    assert all(change.certain == certain for change in found.changes)
