"""The pages of the documentation: every starter and every right is explained, and every link leads somewhere."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]
STARTERS = ROOT / "workflows"
PAGES = [ROOT / "README.md", STARTERS / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
LINK = re.compile(r"\]\((?!https?:)([^)#\s]*)(?:#([^)\s]+))?\)")


def headings(page: Path) -> list[str]:
    """Return the titles of a page, without what stands in blocks of code."""
    text = re.sub(r"^```.*?^```", "", page.read_text(), flags=re.MULTILINE | re.DOTALL)
    return re.findall(r"^#+ (.+)$", text, flags=re.MULTILINE)


def anchor(title: str) -> str:
    """Return a title as GitHub names it in an address."""
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_links_lead_somewhere(page: Path) -> None:
    for path, part in LINK.findall(page.read_text()):
        target = (page.parent / path).resolve() if path else page
        assert target.exists(), f"{page.name}: {path}"
        if part:
            assert part in map(anchor, headings(target)), f"{page.name}: {path}#{part}"


def test_every_starter_has_a_section() -> None:
    titles = headings(STARTERS / "README.md")
    for starter in STARTERS.glob("*.yml"):
        assert [title for title in titles if f"`{starter.name}`" in title], starter.name
    named = {name for title in titles for name in re.findall(r"`([\w-]+\.yml)`", title)}
    assert named == {starter.name for starter in STARTERS.glob("*.yml")}


def test_every_right_that_a_starter_asks_for_has_its_reason() -> None:
    page = (STARTERS / "README.md").read_text()
    for starter in STARTERS.glob("*.yml"):
        for job in (yaml.safe_load(starter.read_text()).get("jobs") or {}).values():
            for right, level in job["permissions"].items():
                assert f"| `{right}: {level}` |" in page, f"{starter.name}: {right}"
