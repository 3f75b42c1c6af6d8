"""What ``inspect`` prints: the JSON object of the contract, and the same as text for a person."""

from __future__ import annotations

import json
import shlex
from collections.abc import Iterable
from typing import Any

from roslab.config.model import Source
from roslab.decide.decision import Decision, Reason
from roslab.knowledge.os_releases import of_debian
from roslab.plan.plan import Plan
from roslab.repository.checkout import printable
from roslab.values.words import line_of

COLUMN = 44
"""Longest answer that counts for the width of the column of answers; the reasons are aligned to its right."""


def _ubuntu(decision: Decision) -> str | None:
    """Return the Ubuntu of the image; what the author's own Dockerfile starts from may be Debian."""
    return None if decision.dockerfile and of_debian(decision.base_image) else decision.ubuntu


def inspection(decision: Decision, plan: Plan) -> dict[str, Any]:
    """Return the object of ``inspect --format json``; its keys are a contract with other programs."""
    python = decision.python
    return {
        "kind": decision.kind,
        "ros_distro": decision.ros_distro,
        "ubuntu": _ubuntu(decision),
        "base_image": decision.base_image,
        "build_tool": decision.build_tool,
        "dependencies": {
            "rosdep": list(decision.rosdep),
            "apt": list(dict.fromkeys((*plan.apt_first, *plan.apt, *plan.apt_tools, *plan.apt_guessed))),
            "pip": list(dict.fromkeys(asked.told for asked in (*decision.pip, *python.python2))),
            "conda": python.conda_file,
            "source": [{"name": s.name, "url": s.repo or s.zip, "ref": s.ref} for s in decision.source],
        },
        "dockerfile": decision.dockerfile,
        "command": ["bash", "-c", decision.command] if isinstance(decision.command, str) else list(decision.command),
        "command_candidates": [list(candidate) for candidate in decision.command_candidates],
        "platforms": list(decision.platforms),
        "platforms_refused": dict(decision.platforms_refused),
        "warnings": [{"message": w.message, "file": w.file, "line": w.line} for w in plan.warnings],
        "evidence": [
            {"question": r.question, "answer": r.answer, "file": r.file, "line": r.line, "reason": r.reason}
            for r in decision.reasons
            if r.decisive
        ],
    }


def inspection_json(decision: Decision, plan: Plan) -> str:
    """Return the contract's object as JSON; invalid bytes in file names are escaped, so that it is always valid."""
    return json.dumps(inspection(decision, plan), indent=2, ensure_ascii=True) + "\n"


def inspection_text(decision: Decision, plan: Plan) -> str:
    """Return what was found and why, as text for a person."""
    lines = [f"{plan.name}: a {_kind(decision)} repository", ""]
    rows = [
        ("base image", decision.base_image, "base_image"),
        ("ROS", decision.ros_distro, "ros_distro"),
        ("Ubuntu", _ubuntu(decision), "ubuntu"),
        ("built with", decision.build_tool, "build_tool"),
        ("Python", None if decision.dockerfile else _python(decision), "python"),
        ("pip's day", None if decision.dockerfile else decision.python.day, "pip_date"),
        ("CUDA", decision.cuda, "cuda"),
        ("dockerfile", decision.dockerfile, "dockerfile"),
        (
            "command",
            line_of(decision.command),
            "command",
        ),
        ("platforms", ", ".join(decision.platforms), "platforms"),
    ]
    shown = [(label, printable(value), _because(decision, question)) for label, value, question in rows if value]
    width = max(len(value) for _, value, _ in shown if len(value) <= COLUMN)
    lines += [f"  {label:<11} {value:<{width}}  {because}".rstrip() for label, value, because in shown]
    lines += _packages(decision, plan)
    replaced = (f"{base.name} by {base.image}: {base.why}" for base in decision.bases if base.recipe is None)
    lines += _section("bases that the build of the Dockerfile replaces", replaced, rows=True)
    first = (f"{base.name}: {base.why}" for base in decision.bases if base.recipe is not None)
    lines += _section("bases that are built before the Dockerfile", first, rows=True)
    gone = (f"{each.name} → {each.instead}: {each.why}" for each in plan.upstreams)
    lines += _section("upstreams that no longer answer → what replaces them", gone, rows=True)
    lines += _section(
        "from source",
        (f"{s.name} {s.repo or s.zip or ''} {_ref(s)}".strip() for s in decision.source if not s.holding),
        rows=True,
    )
    sought = (f"{', '.join(s.holding)} in {s.repo} {s.ref or ''}".rstrip() for s in decision.source if s.holding)
    lines += _section("looked for while the image is built", sought, rows=True)
    command = line_of(decision.command)
    others = (said for c in decision.command_candidates if (said := shlex.join(c)) != command)
    lines += _section("other commands", others, rows=True)
    lines += _section("not built for", (f"{name}: {why}" for name, why in decision.platforms_refused), rows=True)
    lines += _section("warnings", (_placed(w.message, w.file, w.line) for w in plan.warnings), rows=True)
    questions = ", ".join(sorted({reason.question for reason in decision.reasons}))
    lines += [
        "",
        "All evidence for and against one answer: `roslab inspect --explain QUESTION`, one of",
        f"  {questions}",
    ]
    return "\n".join(lines) + "\n"


def _packages(decision: Decision, plan: Plan) -> list[str]:
    """Return the packages that the image installs, or those that an author's Dockerfile and the code name."""
    python = decision.python
    apt, apt_guessed = (*plan.apt_first, *plan.apt), (*plan.apt_tools, *plan.apt_guessed)
    guessed = [asked.told for asked in python.pip_guessed]
    certain = (asked.told for asked in (*decision.pip, *python.python2) if asked not in python.pip_guessed)
    pip = dict.fromkeys(certain)
    if decision.dockerfile:
        named = dict.fromkeys((*decision.rosdep, *apt, *apt_guessed, *pip, *guessed))
        return _section("named by the Dockerfile and the code; what is installed, the Dockerfile says", named)
    return [
        *_section("rosdep keys", decision.rosdep),
        *_section("apt packages", apt),
        *_section("apt packages, where this base knows them", apt_guessed),
        *_section("pip packages", pip),
        *_section("pip packages, guessed", guessed),
        *_section("no newer than", (asked.written for asked in python.bounds)),
    ]


def explanation(reasons: Iterable[Reason], question: str) -> str:
    """Return all evidence for one question, the strongest first, including that for answers that lost.

    What one line says for one answer stands once, in the words of the strongest.
    """
    found = sorted((r for r in reasons if r.question == question), key=lambda r: (not r.decisive, -r.weight))
    doubted = {reason.answer for reason in found if question == "dockerfile" and reason.weight < 0}  # not built
    won = {reason.answer for reason in found if reason.decisive} - doubted
    found.sort(key=lambda r: r.answer not in won or r.weight < 0)
    lines = [f"{question}:"]
    told = set()
    for reason in found:
        place = (reason.answer, reason.file, reason.line)
        if place in told:
            continue
        if reason.file:
            told.add(place)
        mark = "+" if reason.answer in won and (reason.decisive or reason.weight >= 0) else "-"
        lines.append(f"  {mark} {printable(reason.answer)}: {_placed(reason.reason, reason.file, reason.line)}")
    return "\n".join(lines) + "\n"


def _kind(decision: Decision) -> str:
    names = {"ros1": "ROS 1", "ros2": "ROS 2", "cuda": "CUDA", "python": "Python", "cpp": "C++"}
    return names[decision.kind]


def _python(decision: Decision) -> str | None:
    python = decision.python
    if not python.version:
        return None
    managers = {"conda": "conda", "venv": "virtual environment", "system": "the base image's own"}
    return f"{python.version} ({managers[python.manager]})"


def _because(decision: Decision, question: str) -> str:
    reason = next((r for r in decision.reasons if r.question == question and r.decisive), None)
    return _placed(reason.reason, reason.file, reason.line) if reason else ""


def _placed(text: str, file: str | None, line: int | None) -> str:
    place = f" ({printable(file)}{f':{line}' if line else ''})" if file else ""
    return printable(text) + place


def _section(title: str, items: Iterable[str], *, rows: bool = False) -> list[str]:
    values = [printable(item) for item in items]
    if not values:
        return []
    if rows:
        return ["", f"{title}:", *(f"  {value}" for value in values)]
    lines, current = [], " "
    for value in values:
        if len(current) + len(value) > 98:
            lines.append(current)
            current = " "
        current += f" {value}"
    return ["", f"{title} ({len(values)}):", *lines, current]


def _ref(source: Source) -> str:
    day = f"as of {source.before}" if source.before else ""
    return " ".join(word for word in (source.ref, day) if word) or "(no fixed ref)"
