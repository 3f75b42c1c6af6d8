"""A page that leaves the installation to the page of another repository is told."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.config.model import Config
from roslab.decide import decide
from roslab.decide.decision import Warning_
from roslab.evidence.gather import gather
from roslab.repository.checkout import Repository
from roslab.values.dataclass import replace

ORIGIN = "https://github.com/Acme/arm_control.git"
SENT = "For dependencies and build instructions please see [installation](https://github.com/acme/arm_base#build).\n"


def told(folder: Path, page: str, origin: str = ORIGIN) -> list[Warning_]:
    (folder / "README.md").write_text(page)
    (folder / "requirements.txt").write_text("numpy\n")
    evidence = replace(gather(Repository.open(folder)), origin=origin)
    warnings = decide(evidence, Config(), folder_name="arm_control").warnings
    return [warning for warning in warnings if "leaves the installation to" in warning.message]


def test_a_section_that_only_leads_elsewhere_is_told(tmp_path: Path) -> None:
    (found,) = told(tmp_path, f"# Arm\n## Installation\n{SENT}\n## Usage\n```\npython main.py\n```\n")
    assert "https://github.com/acme/arm_base#build, which was not read" in found.message
    assert (found.file, found.line) == ("README.md", 3)


@pytest.mark.parametrize(
    "page",
    [
        f"# Arm\n## Installation\n{SENT}\n```\npip install numpy\n```\n",  # it has commands of its own
        f"# Arm\n## Installation\n{SENT}\n    pip install numpy\n",
        f"# Arm\n## Citation\n{SENT}",
        f"# Arm\n## Installation\n{SENT.replace('acme/arm_base', 'other/arm_base')}",  # a tool of somebody else's
        f"# Arm\n## Installation\n{SENT.replace('acme/arm_base', 'acme/arm_control/wiki')}",  # itself
        "# Arm\n## Installation\nWe build on [arm_base](https://github.com/acme/arm_base).\n",
        f"# Arm\n## Installation on Windows\n{SENT}",
    ],
)
def test_other_links_are_not_told(tmp_path: Path, page: str) -> None:
    assert told(tmp_path, page) == []


def test_nothing_is_told_where_the_owner_is_not_known(tmp_path: Path) -> None:
    assert told(tmp_path, f"# Arm\n## Installation\n{SENT}", origin="") == []


def test_each_repository_is_told_once(tmp_path: Path) -> None:
    page = f"# Arm\n## Installation\n{SENT}{SENT}\n## Requirements\n{SENT.replace('arm_base', 'arm_tools')}"
    assert [warning.line for warning in told(tmp_path, page)] == [3, 7]
