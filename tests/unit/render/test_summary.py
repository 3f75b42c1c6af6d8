"""The job's summary: complete, and nothing of the repository is read as markup."""

from __future__ import annotations

import dataclasses
import re
from pathlib import Path

import pytest
from markdown_it import MarkdownIt

from roslab.decide.decision import Reason, Warning_
from roslab.pipeline import plan_repository
from roslab.render import markdown
from roslab.render.summary import LayerSize, PlatformReport, ProofReport, Report, human, instruction, summary

HOSTILE = "`x` | <script>alert(1)</script> ![a](https://evil.example/a.png) @everyone **b** $(id) ]( \x1b[31m</details>"


def proof(*, passed: bool = True, text: str = "passed in 1.0 s") -> ProofReport:
    return ProofReport(name="the test", command="bash -c true", passed=passed, summary=text, output="hello\n")


def platform(name: str, *, passed: bool = True, layers: bool = True) -> PlatformReport:
    sizes = (
        LayerSize(size=700_000_000, text="/bin/sh -c #(nop) ADD file:abc in / ", base=True),
        LayerSize(size=299_000_000, text="RUN /bin/sh -c apt-get update && apt-get install x # buildkit", base=False),
        LayerSize(size=1_000_000, text='COPY . /home/jovyan/"x" # buildkit', base=False),
    )
    return PlatformReport(
        platform=name,
        digest="sha256:" + "a" * 64,
        source="sha256:" + "b" * 64,
        layers=sizes if layers else (),
        proofs=(proof(passed=passed),),
        build_seconds=200.0,
    )


@pytest.fixture
def report(examples: Path) -> Report:
    return Report(
        plan=plan_repository(examples / "ros2_filter", folder_name="robot").plan,
        image="ghcr.io/lab/robot",
        published=True,
        reason="the event is `push`",
        digest="sha256:" + "c" * 64,
        tags=("ghcr.io/lab/robot:sha-1234567", "ghcr.io/lab/robot:main"),
        platforms=(platform("linux/amd64"), platform("linux/arm64")),
        badge="[![image](https://x/badge.svg)](https://y)",
    )


def test_published(report: Report) -> None:
    text = summary(report)
    assert "### `ghcr.io/lab/robot:main` is published" in text
    assert report.digest in text
    assert "docker run --rm -it ghcr.io/lab/robot:main" in text
    assert "rocker ghcr.io/lab/robot:main" in text
    assert text.count("1.00 GB") == 3
    assert "700.0 MB of 1.00 GB (70%) are layers of" in text
    assert "3 min 20 s" in text
    assert '"apt-get update apt-get install x, 299.0 MB" : 299.000' in text
    assert "[![image](https://x/badge.svg)](https://y)" in text


def test_failed(report: Report) -> None:
    failed = dataclasses.replace(
        report,
        published=False,
        tags=(),
        failures=("on linux/arm64: failed",),
        platforms=(platform("linux/arm64", passed=False),),
    )
    text = summary(failed)
    assert "failed" in text.splitlines()[0]
    assert "No tag was made or moved." in text
    assert "docker run" not in text
    assert "❌" in text


def test_a_pull_request(report: Report) -> None:
    proved = dataclasses.replace(
        report,
        published=False,
        tags=(),
        digest="",
        platforms=(platform("linux/amd64", layers=False),),
        reason="a pull request …",
    )
    text = summary(proved)
    assert "built and proved, and not published" in text
    assert "not pushed" in text
    assert "mermaid" not in text


def test_nothing_of_the_repository_is_markup(report: Report) -> None:
    plan = dataclasses.replace(
        report.plan,
        reasons=(Reason(question=HOSTILE, answer=HOSTILE, reason=HOSTILE, file=HOSTILE, line=1),),
        warnings=(Warning_(message=HOSTILE, file=HOSTILE),),
        platforms_refused=(("linux/arm64", HOSTILE),),
    )
    entry = dataclasses.replace(
        platform("linux/amd64"),
        layers=(LayerSize(size=5, text=f'RUN {HOSTILE}"\n    "x" : 1', base=False),),
        proofs=(
            ProofReport(name=HOSTILE, command=HOSTILE, passed=False, summary=HOSTILE, output=f"````\n{HOSTILE}\n```"),
        ),
    )
    text = summary(dataclasses.replace(report, plan=plan, platforms=(entry,), failures=(HOSTILE,)))
    rendered = MarkdownIt("commonmark").enable("table").render(text)
    # What is not in a code element may hold only the markup that the summary itself writes
    outside = re.sub(r"<code.*?</code>", "", rendered, flags=re.DOTALL)
    assert "<script" not in rendered
    assert "<img" not in rendered
    assert "evil.example" not in " ".join(re.findall(r'(?:href|src)="([^"]*)"', rendered))
    assert "@everyone" not in outside
    assert "\x1b" not in rendered
    assert outside.count("</details>") == outside.count("<details>")
    rows = [row for row in re.findall(r"<tr>.*?</tr>", rendered, flags=re.DOTALL) if "<td" in row]
    assert {row.count("<td") for row in rows} == {5, 4}


def test_a_fence_is_longer_than_what_it_holds() -> None:
    assert markdown.block("a\n````\nb").startswith("`````")
    assert markdown.code("a ``` b") == "````a ``` b````"


@pytest.mark.parametrize(
    ("history", "expected"),
    [
        ("RUN /bin/sh -c make # buildkit", "make"),
        ("RUN |2 NB_USER=jovyan NB_UID=1000 /bin/bash -o pipefail -c pip install x # buildkit", "pip install x"),
        ("/bin/sh -c #(nop) ADD file:1 in /", "ADD file 1 in /"),
        ("", "layer"),
        ('x" : 1', "x 1"),
    ],
)
def test_instruction(history: str, expected: str) -> None:
    assert instruction(history) == expected


@pytest.mark.parametrize(
    ("size", "expected"), [(999, "999 B"), (1500, "1.5 kB"), (45_600_000, "45.6 MB"), (1_230_000_000, "1.23 GB")]
)
def test_human(size: int, expected: str) -> None:
    assert human(size) == expected
