"""The job's summary: what was built, proved and published, how to run it, and why it is as it is."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterable
from dataclasses import dataclass

from roslab.plan import Plan
from roslab.render.markdown import block, code, folded, table, text

MAX_ROWS = 60
"""Of reasons and warnings; a repository of three hundred packages has thousands."""
MAX_SLICES = 7
"""Of the chart: more cannot be told apart on a phone."""


@dataclass(frozen=True, kw_only=True, slots=True)
class LayerSize:
    """One layer as the chart shows it."""

    size: int
    """Compressed bytes."""
    text: str
    """The instruction that made it, ``""`` where it is not known."""
    base: bool


@dataclass(frozen=True, kw_only=True, slots=True)
class ProofReport:
    """What one proof came to."""

    name: str
    command: str
    passed: bool
    summary: str
    output: str


@dataclass(frozen=True, kw_only=True, slots=True)
class PlatformReport:
    """What was built and proved for one platform."""

    platform: str
    digest: str
    """Of the image's manifest."""
    source: str
    """Digest that was pushed: the manifest's own, or that of an index of several platforms or with attestations."""
    layers: tuple[LayerSize, ...]
    """Empty where the image was not pushed."""
    proofs: tuple[ProofReport, ...]
    build_seconds: float | None
    """``None`` where it was not measured; one build of several platforms takes the same time for each."""

    @property
    def size(self) -> int:
        """Bytes that a first pull transfers."""
        return sum(layer.size for layer in self.layers)

    @property
    def passed(self) -> bool:
        """Every proof passed."""
        return all(proof.passed for proof in self.proofs)


@dataclass(frozen=True, kw_only=True, slots=True)
class Report:
    """A whole run."""

    plan: Plan
    image: str
    """``HOST/OWNER/NAME``."""
    published: bool
    """Its tags were made."""
    reason: str
    """Why the run publishes or does not."""
    digest: str = ""
    tags: tuple[str, ...] = ()
    platforms: tuple[PlatformReport, ...] = ()
    failures: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    """What else to know: the cache, whether the package is public. Markdown."""
    badge: str = ""
    """Markdown to paste into the README, ``""`` where there is no page to point at."""


def summary(report: Report) -> str:
    """Return the summary as GitHub's Markdown; every text from the repository or a log is escaped."""
    parts = [
        _headline(report),
        _platforms(report),
        _how_to_run(report),
        _sizes(report),
        *(f"{note}\n" for note in report.notes),
        _badge(report),
        _proofs(report),
        _decisions(report.plan),
        _refused(report),
    ]
    return "\n".join(part for part in parts if part)


def _headline(report: Report) -> str:
    name = code(f"{report.image}:{_tag(report)}" if report.published else report.plan.name)
    if report.failures:
        items = "".join(f"- {text(failure)}\n" for failure in report.failures)
        return f"### {name}: failed\n\n{items}\nNo tag was made or moved.\n"
    if report.published:
        tags = ", ".join(code(tag.rpartition(":")[2]) for tag in report.tags)
        return f"### {name} is published\n\nTags: {tags}  \nDigest: {code(report.digest)}\n"
    why = text(report.reason[:1].upper() + report.reason[1:])
    return f"### {name} was built and proved, and not published\n\n{why}.\n"


def _tag(report: Report) -> str:
    """Return the tag to show: the branch's or the release's, rather than that of one commit."""
    names = [tag.rpartition(":")[2] for tag in report.tags]
    return next((name for name in names if not name.startswith("sha-")), names[0] if names else "latest")


def _platforms(report: Report) -> str:
    if not report.platforms:
        return ""
    rows = []
    for entry in report.platforms:
        failed = next((proof for proof in entry.proofs if not proof.passed), None)
        proof = failed or (entry.proofs[-1] if entry.proofs else None)
        told = f"{'✅' if not failed else '❌'} {text(proof.name)}: {text(proof.summary)}" if proof else "none"
        size = human(entry.size) if entry.layers else "not pushed"
        build = duration(entry.build_seconds) if entry.build_seconds is not None else ""
        rows.append((code(entry.platform), size, build, told, code(entry.digest[:19]) if entry.digest else ""))
    return table(("platform", "compressed", "build", "proof", "digest"), rows)


def _how_to_run(report: Report) -> str:
    if not report.published:
        return ""
    run = report.plan.run
    reference = f"{report.image}:{_tag(report)}"
    flags = ["--rm", "-it", *(["--gpus", "all"] if run.gpu else [])]
    flags += [word for port in run.ports for word in ("-p", port)]
    if run.gui:
        flags += ["-e", "DISPLAY", "-v", "/tmp/.X11-unix:/tmp/.X11-unix"]  # noqa: S108 - where X keeps its sockets
    rocker = [*(["--x11"] if run.gui else []), *(["--nvidia"] if run.gpu else [])]
    lines = [
        shlex.join(["docker", "run", *flags, reference]),
        shlex.join(["rocker", *rocker, reference]) + "  # https://github.com/osrf/rocker",
        shlex.join(["docker", "run", *flags, f"{report.image}@{report.digest}"]) + "  # these very bytes",
    ]
    return f"#### Run it\n\n{block(chr(10).join(lines), 'console')}"


def _sizes(report: Report) -> str:
    entry = next((entry for entry in report.platforms if entry.layers), None)
    if entry is None:
        return ""
    base = sum(layer.size for layer in entry.layers if layer.base)
    image = report.plan.base_image
    shared = (
        f"{human(base)} of {human(entry.size)} ({base / entry.size:.0%}) are layers of {code(image)}: "
        "whoever has another image on that base has them already.\n"
        if base and entry.size
        else f"{code(image)} did not tell its layers, so what other images on it share is not known.\n"
    )
    return f"#### Size\n\n{shared}\n{_chart(entry, base)}"


def _chart(entry: PlatformReport, base: int) -> str:
    """Draw the layers as a pie: https://mermaid.js.org/syntax/pie.html, which GitHub renders."""
    slices = [(f"base image, {human(base)}", base)] if base else []
    own = [layer for layer in entry.layers if not layer.base]
    largest = sorted(own, key=lambda layer: -layer.size)[: MAX_SLICES - len(slices) - 1]
    slices += [(f"{instruction(layer.text)}, {human(layer.size)}", layer.size) for layer in largest]
    rest = sum(layer.size for layer in own) - sum(layer.size for layer in largest)
    slices += [(f"{len(own) - len(largest)} smaller layers, {human(rest)}", rest)] if rest > 0 else []
    lines = [f'    "{label}" : {max(size / 1e6, 0.001):.3f}' for label, size in slices if size]
    return block("\n".join([f"pie title Compressed layers, {entry.platform}", *lines]), "mermaid")


def instruction(history: str) -> str:
    """Return an image's history entry as a label of a chart: short, and only characters that mean nothing there."""
    said = re.sub(
        r"^(?:RUN )?(?:\|\d+ (?:\w+=\S* )*)?/bin/(?:ba)?sh (?:-\w+ (?:pipefail )?)*(?:#\(nop\) +)?", "", history
    )
    said = re.sub(r"\s*# buildkit$", "", said).strip()
    said = " ".join(re.sub(r"[^A-Za-z0-9 ._/=+-]+", " ", said).split())
    return (said if len(said) <= 40 else said[:39].rstrip() + "...") or "layer"


def _badge(report: Report) -> str:
    return f"#### For the README\n\n{block(report.badge, 'markdown')}" if report.published and report.badge else ""


def _proofs(report: Report) -> str:
    parts = []
    for entry in report.platforms:
        for proof in entry.proofs:
            title = f"{'✅' if proof.passed else '❌'} {_html(entry.platform)}: {_html(proof.name)}"
            body = f"{code(proof.command)}: {text(proof.summary)}\n\n{block(proof.output or '(no output)', 'text')}"
            parts.append(folded(title, body))
    return "\n".join(["#### Proofs\n", *parts]) if parts else ""


def _decisions(plan: Plan) -> str:
    reasons = [reason for reason in plan.reasons if reason.decisive]
    rows = [
        (text(r.question), code(r.answer) if r.answer else "", text(r.reason), _place(r.file, r.line))
        for r in reasons[:MAX_ROWS]
    ]
    more = f"\n{len(reasons) - MAX_ROWS} more: `roslab inspect --format json`\n" if len(reasons) > MAX_ROWS else ""
    if not rows:
        return ""
    return folded("What was decided, and why", table(("question", "answer", "reason", "where"), rows) + more)


def _refused(report: Report) -> str:
    plan = report.plan
    lines = [f"- {code(platform)} is not built: {text(why)}" for platform, why in plan.platforms_refused]
    if not report.published and not report.failures:
        lines.append(f"- Nothing is published: {text(report.reason)}")
    lines += [f"- {text(w.message)} {_place(w.file, w.line)}".rstrip() for w in plan.warnings[:MAX_ROWS]]
    return folded("What was refused or is doubtful, and why", "\n".join(lines)) if lines else ""


def _place(file: str | None, line: int | None) -> str:
    return code(f"{file}:{line}" if line else file) if file else ""


def _html(value: str) -> str:
    """Markdown is not read inside a summary element: HTML alone is escaped."""
    return text(value).replace("\\", "")


def human(size: int) -> str:
    """Return a size as registries show it: ``1.23 GB``, ``45.6 MB``."""
    for unit, factor in (("GB", 1e9), ("MB", 1e6), ("kB", 1e3)):
        if size >= factor:
            return f"{size / factor:.{2 if unit == 'GB' else 1}f} {unit}"
    return f"{size} B"


def duration(seconds: float) -> str:
    """Return a duration as a person says it: ``42 s``, ``3 min 20 s``."""
    whole = round(seconds)
    return f"{whole} s" if whole < 120 else f"{whole // 60} min {whole % 60} s"


def platforms_of(reports: Iterable[PlatformReport], plan: Plan) -> tuple[PlatformReport, ...]:
    """Return the reports in the plan's order of platforms."""
    order = {platform: index for index, platform in enumerate(plan.platforms)}
    return tuple(sorted(reports, key=lambda report: order.get(report.platform, len(order))))
