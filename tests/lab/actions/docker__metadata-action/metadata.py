"""Compute image tags as docker/metadata-action does, which this stands in for, from the event alone.

Source: https://github.com/docker/metadata-action README and src/meta.ts, v6.2.0; read 2026-11-21. A rule is a line of
`key=value` separated by commas. The rule of highest priority gives the version; `latest` follows where its flavor says
so, or by itself (auto) for a git tag and a semver that is no pre-release.
"""

from __future__ import annotations

import csv
import json
import os
import re
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime, timezone
from pathlib import Path
from typing import Any

DEFAULT_RULES = "type=schedule\ntype=ref,event=branch\ntype=ref,event=tag\ntype=ref,event=pr"
PRIORITY = {"schedule": 1000, "semver": 900, "edge": 700, "ref": 600, "raw": 200, "sha": 100}
NUMBER = r"(?:0|[1-9]\d*)"
SEMVER = re.compile(
    rf"v?(?P<major>{NUMBER})\.(?P<minor>{NUMBER})\.(?P<patch>{NUMBER})(?:-(?P<pre>[\w.-]+))?(?:\+[\w.-]+)?", re.ASCII
)
MOMENT = {"YYYY": "%Y", "MM": "%m", "DD": "%d", "HH": "%H", "mm": "%M", "ss": "%S"}


@dataclass(frozen=True, kw_only=True)
class Context:
    """What the event says."""

    event: str
    ref: str
    sha: str
    default_branch: str
    base_ref: str
    now: datetime

    @property
    def on_default_branch(self) -> bool:
        return self.ref == f"refs/heads/{self.default_branch}"


def lines(text: str) -> list[str]:
    """Return the lines that say something."""
    return [line.strip() for line in text.splitlines() if line.strip() and not line.strip().startswith("#")]


def attributes(rule: str) -> dict[str, str]:
    """Parse `type=sha,prefix=,format=long`; a rule without a key is a raw value."""
    found: dict[str, str] = {}
    for part in next(csv.reader([rule])):
        key, equals, value = part.strip().partition("=")
        found["value" if not equals else key.strip().lower()] = value.strip() if equals else key
    return {"type": "raw", **found}


def expand(text: str, context: Context) -> str:
    """Fill in the {{…}} that do not belong to a version."""

    def fill(match: re.Match[str]) -> str:
        word, _, argument = match[1].strip().partition(" ")
        branch, tag = context.ref.removeprefix("refs/heads/"), context.ref.removeprefix("refs/tags/")
        known = {
            "is_default_branch": "true" if context.on_default_branch else "false",
            "is_not_default_branch": "false" if context.on_default_branch else "true",
            "branch": branch if branch != context.ref else "",
            "tag": tag if tag != context.ref else "",
            "sha": context.sha[:7],
            "base_ref": context.base_ref,
        }
        if word in {"date", "commit_date"}:
            return moment(argument.strip("'\""), context.now)
        return known.get(word, match[0])

    return re.sub(r"\{\{([^}]*)\}\}", fill, text)


def moment(pattern: str, now: datetime) -> str:
    """Format a time by the few words of moment.js that tags use."""
    return re.sub("|".join(MOMENT), lambda match: now.strftime(MOMENT[match[0]]), pattern)


def clean(tag: str) -> str:
    """Replace what a tag cannot hold."""
    return re.sub(r"[^a-zA-Z0-9._-]+", "-", tag)


def value_of(rule: Mapping[str, str], context: Context) -> tuple[str, bool] | None:
    """Return the tag of one rule and whether `latest` goes with it by itself; None when the rule does not apply."""
    kind = rule["type"]
    if kind == "raw":
        return expand(rule.get("value", ""), context), False
    if kind == "sha":
        return context.sha if rule.get("format") == "long" else context.sha[:7], False
    if kind == "schedule":
        return (expand(rule.get("pattern", "nightly"), context), False) if context.event == "schedule" else None
    if kind == "edge":
        branch = rule.get("branch", context.default_branch)
        return ("edge", False) if context.ref == f"refs/heads/{branch}" else None
    if kind == "ref":
        return _reference(rule.get("event", ""), context)
    if kind == "semver":
        return _version(rule, context)
    raise SystemExit(f"::error::the stand-in of metadata-action does not know type={kind}")


def _reference(event: str, context: Context) -> tuple[str, bool] | None:
    pull = re.match(r"refs/pull/(\d+)/", context.ref)
    if event == "branch" and context.ref.startswith("refs/heads/"):
        return context.ref.removeprefix("refs/heads/"), False
    if event == "tag" and context.ref.startswith("refs/tags/"):
        return context.ref.removeprefix("refs/tags/"), True
    return (pull[1], False) if event == "pr" and pull else None


def _version(rule: Mapping[str, str], context: Context) -> tuple[str, bool] | None:
    given = expand(rule.get("value", ""), context)
    if not given and not context.ref.startswith("refs/tags/"):
        return None
    given = given or context.ref.removeprefix("refs/tags/")
    found = SEMVER.fullmatch(given)
    if not found:
        print(f"::warning::{given} is not a valid semver. More info: https://semver.org/")
        return None
    plain = given.removeprefix("v")
    words = {"raw": given, "version": plain.partition("+")[0], **found.groupdict()}
    pattern = rule.get("pattern", "{{version}}")
    if found["pre"]:
        return words["raw" if pattern.replace(" ", "") == "{{raw}}" else "version"], False
    return re.sub(r"\{\{\s*(\w+)\s*\}\}", lambda match: words.get(match[1], match[0]), pattern), True


def tags(rules: str, flavor: Mapping[str, str], context: Context) -> list[str]:
    """Return the tags of all rules, the one that names the version first and `latest` last."""
    wanted = [attributes(line) for line in lines(rules) or lines(DEFAULT_RULES)]
    wanted.sort(key=lambda rule: -int(rule.get("priority", PRIORITY.get(rule["type"], 0))))
    found: list[str] = []
    latest: bool | None = None
    for rule in wanted:
        if expand(rule.get("enable", "true"), context) != "true":
            continue
        result = value_of(rule, context)
        if result is None or not result[0]:
            continue
        own = "sha-" if rule["type"] == "sha" else "pr-" if rule.get("event") == "pr" else ""
        prefix, suffix = rule.get("prefix", own or flavor["prefix"]), rule.get("suffix", flavor["suffix"])
        tag = clean(expand(prefix, context) + result[0] + expand(suffix, context))
        if tag not in found:
            found.append(tag)
        if latest is None:
            latest = result[1] if flavor["latest"] == "auto" else flavor["latest"] == "true"
    if latest and "latest" not in found:
        found.append("latest")
    return found


def context_of(environment: Mapping[str, str]) -> Context:
    """Read the event as GitHub and act tell it."""
    payload: dict[str, Any] = {}
    event = Path(environment.get("GITHUB_EVENT_PATH", "nowhere"))
    if event.is_file():
        payload = json.loads(event.read_text(encoding="utf-8"))
    return Context(
        event=environment["GITHUB_EVENT_NAME"],
        ref=environment["GITHUB_REF"],
        sha=environment["GITHUB_SHA"],
        default_branch=str(payload.get("repository", {}).get("default_branch") or "main"),
        base_ref=environment.get("GITHUB_BASE_REF", ""),
        now=datetime.now(timezone.utc),
    )


def main(environment: Mapping[str, str]) -> None:
    """Write the outputs."""
    context = context_of(environment)
    flavor = {"latest": "auto", "prefix": "", "suffix": ""}
    for line in lines(environment["META_FLAVOR"]):
        flavor |= {key: value for key, value in attributes(line).items() if key in flavor}
    listed = [attributes(line) for line in lines(environment["META_IMAGES"])]
    enabled = [row for row in listed if row.get("enable", "true") == "true"]
    images = [row.get("name", row.get("value", "")).lower() for row in enabled]
    names = tags(environment["META_TAGS"], flavor, context)
    full = [f"{image}:{name}" for image in images for name in names]
    repository = f"{environment.get('GITHUB_SERVER_URL', 'https://github.com')}/{environment['GITHUB_REPOSITORY']}"
    labels = [
        f"org.opencontainers.image.source={repository}",
        f"org.opencontainers.image.revision={context.sha}",
        f"org.opencontainers.image.version={names[0] if names else ''}",
        *lines(environment["META_LABELS"]),
    ]
    annotations = [f"manifest:{line}" for line in [*labels[:3], *lines(environment["META_ANNOTATIONS"])]]
    separator = {name: environment.get(f"META_SEP_{name}") or "\n" for name in ("TAGS", "LABELS", "ANNOTATIONS")}
    everything = {"tags": full, "tag-names": names, "labels": dict(line.partition("=")[::2] for line in labels)}
    outputs = {
        "version": names[0] if names else "",
        "tags": separator["TAGS"].join(full),
        "tag-names": separator["TAGS"].join(names),
        "labels": separator["LABELS"].join(labels),
        "annotations": separator["ANNOTATIONS"].join(annotations),
        "json": json.dumps(everything),
    }
    with Path(environment["GITHUB_OUTPUT"]).open("a", encoding="utf-8") as handle:
        handle.writelines(f"{key}<<end-of-{key}\n{value}\nend-of-{key}\n" for key, value in outputs.items())
    print("\n".join(full) or "no tags")


if __name__ == "__main__":
    main(os.environ)
