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


def test_what_shows_what_names_only_what_exists() -> None:
    """The lab's table names tests, jobs of the live workflow, and what is tried by hand; each is there."""
    page = (ROOT / "tests/lab/README.md").read_text()
    live = yaml.safe_load((ROOT / ".github/workflows/.live.yml").read_text())
    tests: dict[str, str] = {}
    for path in (ROOT / "tests").rglob("test_*.py"):
        tests[path.name] = tests.get(path.name, "") + path.read_text()
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in page.splitlines() if line.startswith("| ")][2:]
    jobs: set[str] = set()
    for row in rows:
        what, named, shown_live = row
        for file, test in re.findall(r"`(test_\w+\.py)(?:::(\w+))?", named):
            assert file in tests, f"{what}: there is no {file}"
            assert f"def {test}" in tests[file], f"{what}: {file} has no {test}"
        assert "`" in named or shown_live, f"nothing shows: {what}"
        jobs |= set(re.findall(r"`([a-z][a-z-]*)`", shown_live)) - {"dry-run"}
    assert {path.name for path in (ROOT / "tests/lab").glob("test_*.py")} <= set(re.findall(r"test_\w+\.py", page))
    assert jobs == set(live["jobs"]) - {"table"}
    assert set(live["jobs"]["table"]["needs"]) == jobs
    by_hand = {name.replace(" ", "-") for name in re.findall(r"^- \*\*(.+?)\*\*", page, flags=re.MULTILINE)}
    assert by_hand == set(live[True]["workflow_dispatch"]["inputs"]) - {"push"}
