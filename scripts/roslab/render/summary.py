"""The job's summary: what was built, proved and published, how to run it, and the reasons for each decision."""

from __future__ import annotations

import shlex
from collections.abc import Sequence

from roslab.decide.decision import Reason
from roslab.plan.plan import Plan
from roslab.render import climbed, slim
from roslab.render.markdown import block, code, folded, prose, table, text
from roslab.render.outcome import PlatformReport, ProofReport, Repair, Report
from roslab.render.sizes import chart, human

MAX_ROWS = 60
"""Most reasons or warnings that are shown; a repository of three hundred packages has thousands."""
FEW = 5
"""Number of warnings that are shown without a click."""
NOT_PROVED = "not proved"
"""First words of the outcome of a failed proof whose command was only guessed."""
PASSED = "✅"
PHONE = 40
"""Number of characters of a code line that fit on a phone."""


def summary(report: Report) -> str:
    """Return the summary as GitHub's Markdown, with the most important parts first.

    Every text from the repository or a log is escaped. Only code, which scrolls, may be wider than a phone.
    """
    parts = [
        _headline(report),
        *(pasted(repair) for repair in report.repairs),
        _platforms(report),
        slim.section(report),
        _failed_proofs(report),
        _screens(report),
        climbed.sections(report.platforms),
        _doubts(report),
        _sizes(report),
        _passed_proofs(report),
        _other_ways(report),
        _badge(report),
        _decisions(report.plan),
    ]
    return "\n".join(part for part in parts if part)


def _headline(report: Report) -> str:
    """Return whether the run succeeded, and the command that runs the image."""
    if report.failures:
        items = "".join(f"- {prose(failure)}\n" for failure in report.failures)
        return f"### ❌ Failed: {code(report.plan.name)}\n\n{items}\nNo tag was made or moved.\n"
    if report.published:
        reference = f"{report.image}:{_tag(report)}"
        notes = "".join(f"\n{note}\n" for note in report.notes)
        return f"### ✅ Published as {code(reference)}\n\n{_run(report.plan, reference)}{notes}{_signature(report)}"
    why = prose(report.reason[:1].upper() + report.reason[1:])
    return f"### ✅ Built and proved, not published: {code(report.plan.name)}\n\n{why}.\n{_archives(report)}"


def _archives(report: Report) -> str:
    """Return how to try an image that was not published, and why a platform's is not there."""
    parts = []
    for entry in report.platforms:
        if kept := entry.archive:
            commands = (
                _broken((*report.artifacts, shlex.join(["--name", kept.artifact]))),
                _broken(("docker load", shlex.join(["--input", kept.file]))),
                _broken(_running(report.plan, kept.name)),
            )
            parts.append(f"To try it on {code(entry.platform)} ({human(kept.size)}, kept for two weeks):\n")
            parts.append(block("\n".join(commands), "bash"))
        elif entry.archive_remark:
            parts.append(f"There is nothing to try on {code(entry.platform)}: {prose(entry.archive_remark)}.\n")
    if any(entry.archive for entry in report.platforms):
        parts += [f"{note}\n" for note in report.notes]
    return "".join(f"\n{part}" for part in parts)


def _signature(report: Report) -> str:
    """Return how to check that the image is this repository's, or why that cannot be checked."""
    if report.verify:
        return f"\nIt is signed: this tells that a workflow of the repository made it.\n\n{_lines(report.verify)}"
    return f"\nIt is not signed: {prose(report.unsigned)}.\n" if report.unsigned else ""


def pasted(repair: Repair) -> str:
    """Return the lines of a repair as Markdown, with the file that they belong to."""
    what = "This diff repairs" if repair.diff else "Lines for the new file" if repair.new else "Lines to add to"
    what = f"So that the default command starts: {what[:1].lower()}{what[1:]}" if repair.start else what
    return f"{what} {code(repair.file)}:\n\n{block(repair.text, 'diff' if repair.diff else 'yaml')}"


def _tag(report: Report) -> str:
    """Return the tag to show: the branch's or the release's if there is one, not the commit's."""
    names = [tag.rpartition(":")[2] for tag in report.tags]
    return next((name for name in names if not name.startswith("sha-")), names[0] if names else "latest")


def _run(plan: Plan, reference: str) -> str:
    """Return the command that runs an image."""
    return _lines(_running(plan, reference))


def _running(plan: Plan, reference: str) -> list[str]:
    """Return that command in groups of words that belong together."""
    run = plan.run
    groups = [["docker", "run", "--rm", "-it", *(["--gpus", "all"] if run.gpu else [])]]
    groups += [["-p", port] for port in run.ports]
    if run.gui:
        groups += [["-e", "DISPLAY"], ["-v", "/tmp/.X11-unix:/tmp/.X11-unix"]]  # noqa: S108 - where X keeps its sockets
    command = list(run.given.command) if run.given else []
    if run.given and not run.given.entrypoint:
        groups.append(["--entrypoint", command.pop(0)])
    return [shlex.join(group) for group in (*groups, [reference], *([command] if command else []))]


def _lines(words: Sequence[str]) -> str:
    """Return a command as a block of code."""
    return block(_broken(words), "bash")


def _broken(words: Sequence[str]) -> str:
    """Return a command, broken between these groups of words if it does not fit on a phone."""
    line = " ".join(words)
    return line if len(line) <= PHONE else " \\\n  ".join(words)


def _platforms(report: Report) -> str:
    rows = []
    for entry in report.platforms:
        failed = next((proof for proof in entry.proofs if not proof.passed), None)
        proof = failed or (entry.proofs[-1] if entry.proofs else None)
        told = f"{_mark(proof)} {text(_short(proof))}" if proof else "none"
        if reached := climbed.cell(entry.ladder):
            told += f"; {reached}"
        size = human(entry.size) if entry.layers else "not pushed"
        build = duration(entry.build_seconds) if entry.build_seconds is not None else ""
        rows.append((code(entry.platform), told, size, build))
    seen = {entry.platform for entry in report.platforms}
    rows += [(code(name), "❌ no image", "", "") for name in report.plan.platforms if rows and name not in seen]
    refused = [f"- Not built for {code(name)}: {prose(why)}\n" for name, why in report.plan.platforms_refused]
    head = ("platform", "proof", "size", "build")
    return "\n".join(part for part in (table(head, rows) if rows else "", "".join(refused)) if part)


def _failed_proofs(report: Report) -> str:
    return "\n".join(_proof(entry, proof) for entry in report.platforms for proof in entry.proofs if not proof.passed)


def _passed_proofs(report: Report) -> str:
    """Return one section for each platform; one for each proof would be too long on a phone."""
    parts = []
    for entry in report.platforms:
        passed = [proof for proof in entry.proofs if proof.passed]
        if len(passed) == 1:
            parts.append(_proof(entry, passed[0]))
        elif passed:
            mark = next((mark for proof in passed if (mark := _mark(proof)) != PASSED), PASSED)
            body = "\n".join(f"**{text(proof.name)}**\n\n{_told(proof)}" for proof in passed)
            parts.append(folded(f"{mark} {len(passed)} proofs on {_html(entry.platform)}", body))
    return "\n".join(parts)


def _proof(entry: PlatformReport, proof: ProofReport) -> str:
    title = f"{_mark(proof)} Proof on {_html(entry.platform)}: {_html(proof.name)}"
    return folded(title, _told(proof), opened=not proof.passed)


def _told(proof: ProofReport) -> str:
    outcome = prose(proof.summary[:1].upper() + proof.summary[1:])
    command = block(proof.command, "bash") if proof.command else "The command that the image itself starts.\n"
    printed = f"It printed:\n\n{block(proof.output, 'text')}" if proof.output.strip() else "It printed nothing.\n"
    return f"{command}\n{outcome}. {printed}"


def _short(proof: ProofReport) -> str:
    """Return an outcome in a few words; the proof's own section has the rest."""
    return proof.summary.partition(":")[0]


def _screens(report: Report) -> str:
    """List the screenshots of programs that open windows, and why one is missing."""
    lines = []
    for entry in report.platforms:
        for proof in entry.proofs:
            place = f"{code(proof.screenshot)}, among the artifacts of this run" if proof.screenshot else "none"
            if proof.screenshot or proof.screenshot_remark:
                told = "; ".join(part for part in (place, prose(proof.screenshot_remark)) if part)
                lines.append(f"- Screenshot on {code(entry.platform)}: {told}.\n")
    return "".join(lines)


def _mark(proof: ProofReport) -> str:
    if proof.passed:
        return "⚠️" if proof.summary.startswith(NOT_PROVED) else PASSED
    return "❌"


def _doubts(report: Report) -> str:
    """Return the warnings that the author should look at; long lists are folded."""
    warnings = report.plan.warnings
    lines = [f"- {prose(w.message)} {_place(w.file, w.line)}".rstrip() for w in warnings[:MAX_ROWS]]
    if len(warnings) > MAX_ROWS:
        lines.append(f"- {len(warnings) - MAX_ROWS} more: {code('roslab inspect')}")
    title = "⚠️ One thing is doubtful" if len(warnings) == 1 else f"⚠️ {len(warnings)} things are doubtful"
    return folded(title, "\n".join(lines), opened=len(warnings) <= FEW) if lines else ""


def _sizes(report: Report) -> str:
    entry = next((entry for entry in report.platforms if entry.layers), None)
    if entry is None or report.failures:
        return ""
    base = sum(layer.size for layer in entry.layers if layer.base)
    image = report.plan.base_image
    shared = (
        f"{human(base)} of {human(entry.size)} ({base / entry.size:.0%}) are layers of {code(image)}: "
        "whoever has another image on that base has them already.\n"
        if base and entry.size
        else f"{code(image)} did not tell its layers, so what other images on it share is not known.\n"
    )
    return f"#### Size\n\n{shared}\n{chart(entry.platform, entry.layers)}"


def _other_ways(report: Report) -> str:
    if not report.published:
        return ""
    run = report.plan.run
    rocker = [*(["--x11"] if run.gui else []), *(["--nvidia"] if run.gpu else [])]
    tags = ", ".join(code(tag.rpartition(":")[2]) for tag in report.tags)
    digests = "".join(f"- {code(entry.platform)}: {code(entry.digest)}\n" for entry in report.platforms if entry.digest)
    reference = f"{report.image}:{_tag(report)}"
    body = (
        f"This very image, wherever its tags go later:\n\n{_run(report.plan, f'{report.image}@{report.digest}')}\n"
        f"By [rocker](https://github.com/osrf/rocker):\n\n"
        f"{block(shlex.join(['rocker', *rocker, reference]), 'bash')}\n"
        f"Tags: {tags}\n\nDigests of the platforms:\n\n{digests}"
    )
    return folded("Tags, digests, and other ways to run it", body)


def _badge(report: Report) -> str:
    return (
        folded("A badge for the README", block(report.badge, "markdown")) if report.published and report.badge else ""
    )


def _decisions(plan: Plan) -> str:
    """Return one line for each answer, because a table of four columns cannot be read on a phone."""
    reasons = [reason for reason in plan.reasons if reason.decisive]
    answers = [reason for reason in reasons if reason.question != "dependencies"]
    needed = [reason for reason in reasons if reason.question == "dependencies"]
    parts = [
        "".join(_reason(reason, f"**{text(reason.question.replace('_', ' '))}** ") for reason in answers[:MAX_ROWS])
    ]
    if needed:
        parts.append("What it needs:\n\n" + "".join(_reason(reason) for reason in needed[:MAX_ROWS]))
    if more := len(answers[MAX_ROWS:]) + len(needed[MAX_ROWS:]):
        parts.append(f"{more} more: {code('roslab inspect --format json')}\n")
    return folded("What was decided, and why", "\n".join(parts)) if reasons else ""


def _reason(reason: Reason, question: str = "") -> str:
    answer = code(reason.answer) if reason.answer else "none"
    place = f" ({_place(reason.file, reason.line)})" if reason.file else ""
    return f"- {question}{answer}: {prose(reason.reason)}{place}\n"


def _place(file: str | None, line: int | None) -> str:
    return code(f"{file}:{line}" if line else file) if file else ""


def _html(value: str) -> str:
    """Escape only HTML, because Markdown is not interpreted inside a summary element."""
    return text(value).replace("\\", "")


def duration(seconds: float) -> str:
    """Return a duration as text: ``42 s``, ``3 min 20 s``."""
    whole = round(seconds)
    return f"{whole} s" if whole < 120 else f"{whole // 60} min {whole % 60} s"
