"""Which pages are read for what they have people install: those of a usual name, and those that the README links so."""

from __future__ import annotations

from pathlib import Path

import pytest

from roslab.evidence.prose.pages import pages
from roslab.repository.checkout import Repository


def read(tmp_path: Path, files: dict[str, str]) -> list[str]:
    for name, text in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return [file.path for file in pages(Repository.open(tmp_path))]


@pytest.mark.parametrize(
    ("readme", "page"),
    [
        ("# Demo\n## Installation\nSee [the page](guide/first.md).\n", "guide/first.md"),
        ("# Demo\n## Setup\n### Code\n* [first](./guide/first.md#code)\n", "guide/first.md"),
        (
            "# Demo\nSee [here](https://github.com/x/demo/blob/master/InstallationInstructions.md).\n",
            "InstallationInstructions.md",
        ),
        ("# Demo\n## Start\n[Installation instructions](wiki/first.md)\n# More\n", "wiki/first.md"),
    ],
)
def test_a_page_that_the_readme_links_for_its_installation(tmp_path: Path, readme: str, page: str) -> None:
    assert sorted(read(tmp_path, {"README.md": readme, page: "text"})) == sorted([page, "README.md"])


@pytest.mark.parametrize(
    "readme",
    [
        "# Demo\n## Results\n[More](guide/first.md)\n",
        "# Building Robots\n[More](guide/first.md)\n",  # what the code is for
        "# Demo\n## Installation\n[Datasets](guide/first.md)\n",
        "# Demo\n## Windows installation\n[this](guide/first.md)\n",
        "# Demo\n## Installation\n```\n[this](guide/first.md)\n```\n",
    ],
)
def test_a_page_that_is_about_something_else(tmp_path: Path, readme: str) -> None:
    assert read(tmp_path, {"README.md": readme, "guide/first.md": "text"}) == ["README.md"]


@pytest.mark.parametrize(
    "name", ["TRAINING.md", "docker.md", "troubleshooting.md", "ERROR_CATCH.md", "CONTRIBUTING.md"]
)
def test_a_page_of_another_name_below_the_title(tmp_path: Path, name: str) -> None:
    assert read(tmp_path, {"README.md": f"# Demo\n## Installation\n[this]({name})\n", name: "text"}) == ["README.md"]


def test_a_guide_at_the_root_where_no_readme_is(tmp_path: Path) -> None:
    files = dict.fromkeys(
        ("SIMULATION_GUIDE.md", "docs_guide/GUIDE.md", "TODO.md", "DEVELOPER_GUIDE.md", "STYLE_GUIDE.md"), "# Demo\n"
    )
    assert read(tmp_path, files) == ["SIMULATION_GUIDE.md"]
    assert read(tmp_path, {**files, "INSTALL.md": "# Demo\n"}) == ["INSTALL.md"]


def test_any_page_at_the_root_where_neither_a_readme_nor_a_guide_is(tmp_path: Path) -> None:
    notes = ("TODO.md", "CHANGELOG.md", "CLAUDE.md", "AGENTS.md", "commands.md", "LICENSE.md", "docs/other.md")
    old = ("migration.md", "UPGRADING.md", "results_2.md", "legacy-api.md", "deprecated.md", "old.md")
    files = dict.fromkeys(("example.md", "arm_control.md", *notes, *old), "# Demo\n")
    assert sorted(read(tmp_path, files)) == ["arm_control.md", "example.md"]
    assert read(tmp_path, {**files, "README.md": "# Demo\n"}) == ["README.md"]


@pytest.mark.parametrize("built_by", ["package.xml", "CMakeLists.txt"])
def test_the_page_of_a_package_is_read_however_deep_it_lies(tmp_path: Path, built_by: str) -> None:
    files = {"a/b/c/d/e/README.md": "text", f"a/b/c/d/e/{built_by}": "", "a/b/c/d/f/README.md": "text"}
    assert read(tmp_path, files) == ["a/b/c/d/e/README.md"]
