"""The record of a proof that an image carries: what was run, and how far each platform got, as one line of JSON."""

from __future__ import annotations

import json
from collections.abc import Mapping

from roslab.config.model import ProofGoals, ProofLimits
from roslab.errors import ConfigurationError, Problem
from roslab.plan.ladder import Ladder, Rung, title
from roslab.plan.plan import Plan
from roslab.plan.proof import Proof
from roslab.values.dataclass import asdict, dataclass

KEY = "roslab.proof"
"""Annotation of an index and label of an image that hold the record."""
VERSION = 1
MACHINES = (3, 5)
"""Rungs for which a machine needs a display or a GPU: where one has none, nothing is known of the image."""
RESULT = "https://in-toto.io/attestation/test-result/v0.1"
"""https://github.com/in-toto/attestation/blob/main/spec/predicates/test-result.md"""


@dataclass(frozen=True, kw_only=True, slots=True)
class Record:
    """What was proved, and what it showed."""

    version: int
    proofs: tuple[Proof, ...]
    limits: ProofLimits
    goals: ProofGoals
    gpu: bool
    """It ran with the machine's GPUs, where there were any."""
    platforms: tuple[tuple[str, Ladder], ...]

    def of(self, platform: str) -> Ladder | None:
        """Return the ladder of a platform, ``None`` if it was not proved."""
        return dict(self.platforms).get(platform)


def record(plan: Plan, ladders: Mapping[str, Ladder]) -> Record:
    """Return the record of a plan's image, by platform."""
    return Record(
        version=VERSION,
        proofs=plan.proofs,
        limits=plan.proof_limits,
        goals=plan.proof_goals,
        gpu=plan.run.gpu,
        platforms=tuple(ladders.items()),
    )


def to_json(made: Record) -> str:
    """Return a record as one line."""
    return json.dumps(asdict(made), ensure_ascii=True, separators=(",", ":"))


def to_result(made: Record, *, url: str) -> str:
    """Return a record as in-toto's predicate for the result of tests, which is signed; ``url`` is the run's page.

    A rung is a test. One that does not hold is a warning: what had to hold did, or nothing would be published.
    """
    told = {"held": "passedTests", "missed": "warnedTests", "unseen": "warnedTests"}
    tests: dict[str, list[str]] = {"passedTests": [], "warnedTests": [], "failedTests": []}
    for platform, ladder in made.platforms:
        for rung in ladder.rungs:
            tests[told[rung.state]].append(f"{platform}: {title(rung.number)}")
    used = {"name": KEY, "mediaType": "application/json", "annotations": asdict(made)}
    result = "WARNED" if tests["warnedTests"] else "PASSED"
    return json.dumps({"result": result, "configuration": [used], "url": url, **tests}, ensure_ascii=True) + "\n"


def from_json(text: str) -> Record:
    """Read a record back. Raises ``ConfigurationError`` for anything that ``to_json`` did not write."""
    from cattrs import Converter  # noqa: PLC0415 - slow to import, and only `verify` reads records
    from cattrs.errors import BaseValidationError  # noqa: PLC0415

    try:
        made = Converter(forbid_extra_keys=True).structure(json.loads(text), Record)
    except (ValueError, AttributeError, RecursionError, BaseValidationError) as error:
        raise ConfigurationError(Problem(message=f"not the record of a proof: {type(error).__name__}")) from None
    if made.version != VERSION:
        message = f"the record of the proof has version {made.version}, and this program reads version {VERSION}"
        raise ConfigurationError(Problem(message=message, hint="use the roslab that made the image, or a newer one"))
    return made


def difference(recorded: Ladder, seen: Ladder) -> str:
    """Return the first difference of what was seen from what was recorded, from the lowest rung, ``""`` if none.

    Numbers of messages and seconds differ from climb to climb, and are no difference.
    """
    now = {rung.number: rung for rung in seen.rungs}
    for before in recorded.rungs:
        name = f"rung {before.number}, {before.name}"
        after = now.pop(before.number, None)
        if after is None:
            return f"{name}: recorded ({before.said}), and now there is nothing of it"
        if found := _difference(before, after):
            return f"{name}: {found}"
    more = next(iter(now.values()), None)
    return f"{title(more.number)}: not recorded, and now seen ({more.said})" if more else ""


def _difference(before: Rung, after: Rung) -> str:
    if before.number in MACHINES and "unseen" in (before.state, after.state):
        return ""
    if before.state != after.state:
        told = {"held": "held", "missed": "did not hold", "unseen": "was not seen"}
        return (
            f"it {told[before.state]} when it was recorded ({before.said}), and now {told[after.state]} ({after.said})"
        )
    if gone := [fact for fact in before.facts if fact not in after.facts]:
        new = next((fact for fact in after.facts if fact not in before.facts), "")
        return f"`{gone[0]}` was recorded, and is not so now" + (f"; now there is `{new}`" if new else "")
    if new := next((fact for fact in after.facts if fact not in before.facts), ""):
        return f"`{new}` is so now, and was not recorded"
    return ""
