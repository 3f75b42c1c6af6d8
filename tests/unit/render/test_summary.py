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
from roslab.render.outcome import PlatformReport, ProofReport, Report
from roslab.render.sizes import LayerSize, human, part
from roslab.render.summary import summary

HOSTILE = (
    "`x` | <script>alert(1)</script> ![a](https://evil.example/a.png) @everyone **b** $(id) ]( \x1b[31m</details> "
    "www.evil.example"
)


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
        proofs=(proof(passed=passed, text="passed in 1.0 s" if passed else "failed: no end within 1800 s"),),
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
    assert text.startswith("### ✅ Published as `ghcr.io/lab/robot:main`\n\n```bash\ndocker run ")
    assert "docker run --rm -it \\\n  ghcr.io/lab/robot:main\n" in text
    assert f"docker run --rm -it \\\n  ghcr.io/lab/robot@{report.digest}\n" in text
    assert "rocker ghcr.io/lab/robot:main" in text
    assert text.count("1.00 GB") == 3
    assert "Tags: `sha-1234567`, `main`" in text
    assert "700.0 MB of 1.00 GB (70%) are layers of" in text
    assert "3 min 20 s" in text
    assert '"base image 700.0 MB" : 700.000' in text
    assert '"apt 299.0 MB" : 299.000' in text
    assert "<details open>" not in text
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
    assert text.startswith("### ❌ Failed: `robot`\n\n- on linux/arm64: failed\n\nNo tag was made or moved.\n")
    assert "docker run" not in text
    assert "| `linux/arm64` | ❌ failed |" in text
    assert "| `linux/amd64` | ❌ no image |" in text
    # What the failed proof printed is seen without a click, and nothing that matters only when all is well
    assert "<details open><summary>❌ Proof on linux/arm64: the test</summary>" in text
    assert "mermaid" not in text


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
    assert text.startswith("### ✅ Built and proved, not published: `robot`\n\nA pull request …")
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
    assert "www." not in outside  # GitHub makes a link of it: https://github.github.com/gfm/#autolinks-extension-
    assert "\x1b" not in rendered
    assert outside.count("</details>") == len(re.findall(r"<details(?: open)?>", outside))
    rows = [row for row in re.findall(r"<tr>.*?</tr>", rendered, flags=re.DOTALL) if "<td" in row]
    assert {row.count("<td") for row in rows} == {4}


def test_a_guess_that_failed_is_no_success(report: Report) -> None:
    guessed = dataclasses.replace(proof(), summary="not proved: the guessed command failed; name `command`")
    entry = dataclasses.replace(platform("linux/amd64"), proofs=(guessed,))
    text = summary(dataclasses.replace(report, platforms=(entry,)))
    assert "| `linux/amd64` | ⚠️ not proved |" in text
    assert "⚠️ Proof on linux/amd64: the test" in text
    assert "Not proved: the guessed command failed; name `command`." in text
    assert "✅ Proof" not in text


def test_the_proofs_of_a_platform_that_passed_are_one_section(report: Report) -> None:
    two = (proof(), dataclasses.replace(proof(), name="the command", command="", output=""))
    entry = dataclasses.replace(platform("linux/amd64"), proofs=two)
    text = summary(dataclasses.replace(report, platforms=(entry,)))
    assert (
        "<details><summary>✅ 2 proofs on linux/amd64</summary>\n\n**the test**\n\n```bash\nbash -c true\n```" in text
    )
    told = "The command that the image itself starts.\n\nPassed in 1.0 s. It printed nothing."
    assert f"**the command**\n\n{told}\n\n</details>" in text


def test_colours_of_a_terminal_are_left_out() -> None:
    said = "\x1b]2;title\x07\x1b[31m[ERROR]\x1b[0m bad\x1b"
    assert markdown.block(said, "text") == "```text\n[ERROR] bad\\x1b\n```\n"
    assert markdown.code(said) == "`[ERROR] bad\\x1b`"


def test_few_doubts_are_seen_and_many_are_folded(report: Report) -> None:
    def said(number: int) -> str:
        warnings = tuple(Warning_(message=f"doubt {index}", file="a.txt", line=3) for index in range(number))
        return summary(dataclasses.replace(report, plan=dataclasses.replace(report.plan, warnings=warnings)))

    assert "<details open><summary>⚠️ One thing is doubtful</summary>\n\n- doubt 0 `a.txt:3`" in said(1)
    assert "<details><summary>⚠️ 100 things are doubtful</summary>" in said(100)
    assert "- 40 more: `roslab inspect`" in said(100)


@pytest.mark.parametrize("cell", ["a|b", r"a\|b", r"a\\|b", "|"])
def test_a_border_in_a_cell_is_no_border(cell: str) -> None:
    rendered = MarkdownIt("commonmark").enable("table").render(markdown.table(("x", "y"), [(markdown.code(cell), "z")]))
    assert rendered.count("<td>") == 2
    assert "<td>z</td>" in rendered


def test_only_what_a_message_marks_is_code() -> None:
    assert markdown.prose("name `a b` in *x*: 1 ` 2") == r"name `a b` in \*x\*: 1 \` 2"


def test_a_fence_is_longer_than_what_it_holds() -> None:
    assert markdown.block("a\n````\nb").startswith("`````")
    assert markdown.code("a ``` b") == "````a ``` b````"


@pytest.mark.parametrize(
    ("history", "expected"),
    [
        ("RUN /bin/sh -c make -j2 # buildkit", "compiled"),
        ("RUN |2 NB_USER=jovyan NB_UID=1000 /bin/bash -o pipefail -c python3 -m pip install x # buildkit", "pip"),
        ("RUN /bin/sh -c apt-get update  && apt-get install --yes cmake # buildkit", "apt"),
        ("RUN /bin/sh -c apt-get --quiet install cmake && pip3 install numpy", "pip"),
        ("RUN /bin/bash -c apt-get update; rosdep update; rosdep install --from-paths /tmp/manifests", "rosdep"),
        (
            "RUN |2 NB_USER=a NB_UID=1000 /bin/bash -c install-rosdep-keys --tables noetic/final /tmp/manifests",
            "rosdep",
        ),
        ("RUN /bin/bash -c install-optional-apt python3-numpy # buildkit", "apt"),
        ("RUN /bin/bash -c install-optional-pip python3 -- numpy # buildkit", "pip"),
        ("RUN /bin/bash -c create-user # buildkit", "set-up"),
        ("RUN /bin/bash -c conda env create --file environment.yml", "conda"),
        ("/bin/sh -c #(nop) ADD file:1 in / ", "Ubuntu"),
        ("ADD amd64.tar / # buildkit", "Ubuntu"),
        ("COPY . /home/jovyan/make # buildkit", "files"),
        ("RUN /bin/sh -c useradd robot", "set-up"),
        ("", "set-up"),
        ('x" : 1', "set-up"),
    ],
)
def test_part(history: str, expected: str) -> None:
    assert part(history) == expected


@pytest.mark.parametrize(
    ("size", "expected"), [(999, "999 B"), (1500, "1.5 kB"), (45_600_000, "45.6 MB"), (1_230_000_000, "1.23 GB")]
)
def test_human(size: int, expected: str) -> None:
    assert human(size) == expected


def test_the_screenshots_are_named(report: Report) -> None:
    shown = dataclasses.replace(proof(), screenshot="screenshot-linux-amd64-default-command-starts.png")
    blank = dataclasses.replace(shown, screenshot_remark="nothing was drawn: it is wholly blank")
    none = dataclasses.replace(proof(), screenshot_remark="Xvfb is not installed")
    entries = [dataclasses.replace(platform(f"linux/{n}"), proofs=(p,)) for n, p in enumerate((shown, blank, none))]
    text = summary(dataclasses.replace(report, platforms=tuple(entries)))
    file = "`screenshot-linux-amd64-default-command-starts.png`, among the artifacts of this run"
    assert f"- Screenshot on `linux/0`: {file}.\n" in text
    assert f"- Screenshot on `linux/1`: {file}; nothing was drawn: it is wholly blank.\n" in text
    assert "- Screenshot on `linux/2`: none; Xvfb is not installed.\n" in text
    assert "Screenshot on" not in summary(report)
