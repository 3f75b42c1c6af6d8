"""The summary of every example, however its run ended, reads well on GitHub and on a phone.

What was seen to read badly in pictures of them is kept out here: wide tables, markup that GitHub takes out, sections
that do not close, a chart that cannot be told apart, the same thing said twice.
"""

from __future__ import annotations

import dataclasses
import json
import re
from pathlib import Path

import pytest
from markdown_it import MarkdownIt
from markdown_it.token import Token

from roslab.decide.decision import Warning_
from roslab.pipeline import plan_repository
from roslab.render.outcome import PlatformReport, ProofReport, Report
from roslab.render.sizes import PARTS, LayerSize
from roslab.render.summary import PHONE, summary

EXAMPLES = sorted(path.name for path in (Path(__file__).parents[3] / "examples").iterdir() if path.is_dir())
ENDINGS = ("published", "pull request", "proof failed", "one platform failed", "nothing built")
DIGEST = "sha256:" + "5e" * 32
HTML = re.compile(r"</?(?:summary|details(?: open)?)>")
"""What may stand outside of code: https://github.com/gjtorikian/html-pipeline keeps it."""
TABLE = 26
"""Letters that the longest words of a row may have together: four columns of them fit into 358 pixels."""


def layers() -> tuple[LayerSize, ...]:
    return (
        LayerSize(size=61_000_000, text="/bin/sh -c #(nop) ADD file:1 in / ", base=True),
        LayerSize(size=39_000, text="RUN |2 NB_USER=jovyan NB_UID=1000 /bin/bash -c useradd # buildkit", base=False),
        LayerSize(size=18_000_000, text="RUN /bin/bash -c apt-get install --yes x # buildkit", base=False),
        LayerSize(size=2_000_000, text="RUN /bin/bash -c apt-get install --yes y # buildkit", base=False),
        LayerSize(size=9_000_000, text="RUN /bin/bash -c pip install numpy # buildkit", base=False),
        LayerSize(size=3_000_000, text="RUN /bin/bash -c colcon build # buildkit", base=False),
    )


def ended(examples: Path, name: str, ending: str) -> Report:
    plan = plan_repository(examples / name, folder_name=name).plan
    failed = ending == "proof failed"
    entries = []
    for platform in plan.platforms[: 1 if ending == "one platform failed" else None]:
        bad = failed and platform != "linux/amd64"
        summaries = ("failed with exit code 127 after 1799.9 s", "passed: still running after 10 s")
        proofs = tuple(
            ProofReport(
                name=proof.name,
                command=" ".join(proof.command),
                passed=not bad,
                summary=summaries[0 if bad else 1],
                output="one line\n" * 3,
            )
            for proof in plan.proofs
        )
        entries.append(
            PlatformReport(
                platform=platform,
                digest=DIGEST,
                source=DIGEST,
                layers=() if ending == "pull request" else layers(),
                proofs=proofs,
                build_seconds=3599.0,
            )
        )
    image = f"ghcr.io/a-laboratory-with-a-name/{name}"
    published = ending == "published"
    return Report(
        plan=dataclasses.replace(
            plan,
            platforms_refused=(("linux/arm/v7", "no image of `ros:jazzy-ros-base` exists for it"),),
            warnings=(Warning_(message="`gurobipy` is licensed: it is left out", file="requirements.txt", line=3),),
        ),
        image=image,
        published=published,
        reason="a pull request from a fork builds and proves the image and publishes nothing",
        digest=DIGEST if published else "",
        tags=(f"{image}:sha-0359499", f"{image}:main", f"{image}:latest") if published else (),
        platforms=tuple(entries) if ending != "nothing built" else (),
        failures=() if ending in ENDINGS[:2] else ("the registry ghcr.io does not answer (run the job again later)",),
        notes=("Anybody may pull this image.",) if published else (),
        badge="[![image](https://github.com/a/b/badge.svg)](https://github.com/a/b)",
    )


@pytest.fixture(params=EXAMPLES)
def example(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture(params=ENDINGS)
def markdown(request: pytest.FixtureRequest, examples: Path, example: str) -> str:
    return summary(ended(examples, example, request.param))


def tokens(markdown: str) -> list[Token]:
    """Return GitHub's blocks in order, those inside of others too."""
    return MarkdownIt("commonmark").enable(["table", "strikethrough"]).parse(markdown)


def test_only_markup_that_github_keeps_and_all_of_it_closed(markdown: str) -> None:
    found = []
    for token in tokens(markdown):
        for part in (token, *(token.children or ())):
            if part.type in ("html_block", "html_inline"):
                found += re.findall(r"<[^>]*>", part.content)
    assert [tag for tag in found if not HTML.fullmatch(tag)] == []
    depth = 0
    for tag in found:
        depth += tag.startswith("<details")
        depth -= tag == "</details>"
        assert depth in (0, 1)
    assert depth == 0
    assert found.count("<summary>") == found.count("</summary>") == found.count("</details>") > 0


def test_no_table_is_wider_than_a_phone(markdown: str) -> None:
    for row in re.findall(r"^\|.*\|$", markdown, flags=re.MULTILINE):
        cells = [cell.strip().strip("`") for cell in re.split(r"(?<!\\)\|", row)[1:-1]]
        assert len(cells) <= 4, row
        assert sum(max(map(len, cell.split()), default=0) for cell in cells) <= TABLE, row


def test_the_first_thing_is_whether_it_worked_and_what_runs_it(markdown: str) -> None:
    first, second = [token for token in tokens(markdown) if token.level == 0 and token.nesting >= 0][:2]
    assert (first.type, first.tag) == ("heading_open", "h3")
    assert markdown.startswith(("### ✅ ", "### ❌ "))
    if "### ✅ Published" in markdown:
        assert second.type == "fence"
        assert second.content.startswith("docker run ")
        wide = [line for line in second.content.splitlines() if len(line) > PHONE and "ghcr.io/" not in line]
        assert wide == []
    elif "### ❌" in markdown:
        assert second.type == "bullet_list_open"


def test_a_failed_proof_is_open_and_stands_before_what_passed(markdown: str) -> None:
    failed = [match.start() for match in re.finditer(r"<summary>❌ Proof", markdown)]
    passed = [match.start() for match in re.finditer(r"<summary>✅ (?:Proof|\d+ proofs) on ", markdown)]
    assert markdown.count("<details open><summary>❌ Proof") == len(failed)
    assert len(re.findall(r"<details><summary>✅ (?:Proof|\d+ proofs) on ", markdown)) == len(passed)
    assert not failed or not passed or max(failed) < min(passed)


def test_nothing_is_empty_and_nothing_is_said_twice(markdown: str) -> None:
    assert "<summary></summary>" not in markdown
    assert not re.search(r"</summary>\s*</details>", markdown)
    assert not re.search(r"```\w*\n\s*```", markdown)
    assert not re.search(r"^- *$", markdown, flags=re.MULTILINE)
    assert not re.search(r"^#+ [^\n]*\n+(?:#|<details|\Z)", markdown, flags=re.MULTILINE)
    said = re.findall(r"^(?:#+|-|<details.*?><summary>) *(.+)$", markdown, flags=re.MULTILINE)
    assert sorted(said) == sorted(set(said))


def test_the_chart_can_be_read(examples: Path, example: str) -> None:
    report = ended(examples, example, "published")
    (chart,) = (token for token in tokens(summary(report)) if token.info == "mermaid")
    settings, title, *slices = chart.content.splitlines()
    look = json.loads(settings.removeprefix("%%{init: ").removesuffix("}%%"))["themeVariables"]
    assert title == "pie title Download for linux/amd64"
    found = [re.fullmatch(r'    "([A-Za-z0-9 .-]{1,24})" : (\d+\.\d{3})', line) for line in slices]
    assert all(found), slices
    # The same name once, in the order of the legend, and with a colour of its own that shows white numbers
    assert [match[1] for match in found if match] == [
        "base image 61.0 MB", "apt 20.0 MB", "pip 9.0 MB", "compiled 3.0 MB"
    ]  # fmt: skip
    colours = [look[f"pie{number}"] for number in range(1, len(PARTS) + 3)]  # and the base, and the rest
    assert len(set(colours)) == len(colours)
    for colour in colours:
        assert contrast(colour, "#ffffff") >= 4.5
        assert contrast(colour, "#0d1117") >= 2.5  # the dark page's own


def contrast(one: str, other: str) -> float:
    """Return https://www.w3.org/TR/WCAG22/#dfn-contrast-ratio of two colours."""
    darker, lighter = sorted((luminance(one), luminance(other)))
    return (lighter + 0.05) / (darker + 0.05)


def luminance(colour: str) -> float:
    """Return https://www.w3.org/TR/WCAG22/#dfn-relative-luminance of ``#rrggbb``."""
    parts = [int(colour[index : index + 2], 16) / 255 for index in (1, 3, 5)]
    red, green, blue = (part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue
