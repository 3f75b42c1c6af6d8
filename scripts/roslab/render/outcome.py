"""The results of a run: each job writes a report of its platform, and a later job reads and shows them."""

from __future__ import annotations

import json
from collections.abc import Iterable

from roslab.plan.ladder import Ladder
from roslab.plan.plan import Plan
from roslab.render.sizes import LayerSize
from roslab.values.dataclass import asdict, dataclass, field
from roslab.values.pattern import pattern

DIGEST = pattern(r"sha256:[0-9a-f]{64}")
"""https://github.com/opencontainers/image-spec/blob/main/descriptor.md#digests"""


@dataclass(frozen=True, kw_only=True, slots=True)
class ProofReport:
    """The result of one proof."""

    name: str
    command: str
    """The command as a person would type it, ``""`` for the image's own command."""
    passed: bool
    summary: str
    output: str
    screenshot: str = ""
    """File in the run's artifacts; only a proof with a display has one."""
    screenshot_remark: str = ""
    """A note that nothing was drawn, or why there is no screenshot."""


ARCHIVE = pattern(r"[A-Za-z0-9][A-Za-z0-9_.:-]{0,500}")
"""A name of an archive, which the summary shows in a command."""


@dataclass(frozen=True, kw_only=True, slots=True)
class ArchiveReport:
    """An image that was not published and can be tried."""

    artifact: str
    """Name of the run's artifact."""
    file: str
    """Name of the file in it."""
    name: str
    """``NAME:TAG``, what the image is called once it is loaded."""
    size: int
    """Bytes of the file."""


@dataclass(frozen=True, kw_only=True, slots=True)
class SlimReport:
    """What became of the slim image of one platform."""

    digest: str = ""
    """Digest of the image's manifest."""
    source: str = ""
    """Digest that was pushed, as in ``PlatformReport``."""
    size: int = 0
    """Bytes that a first pull transfers, 0 if it was not pushed."""
    proofs: tuple[ProofReport, ...] = ()
    ladder: Ladder = field(default_factory=Ladder)
    failure: str = ""
    """Why it gets no tag, ``""`` if it holds."""


@dataclass(frozen=True, kw_only=True, slots=True)
class PlatformReport:
    """What was built and proved for one platform."""

    platform: str
    digest: str
    """Digest of the image's manifest."""
    source: str
    """Digest that was pushed: that of the manifest, or of an index with several platforms or attestations."""
    layers: tuple[LayerSize, ...]
    """Layers of the image, empty if it was not pushed."""
    proofs: tuple[ProofReport, ...]
    build_seconds: float | None
    """``None`` if it was not measured; if one build made several platforms, each has the time of the whole build."""
    archive: ArchiveReport | None = None
    archive_remark: str = ""
    """Why there is no archive although one was wanted."""
    ladder: Ladder = field(default_factory=Ladder)
    """How far the image got."""
    slim: SlimReport | None = None
    """``None`` if no slim image was wanted, or the whole one failed."""

    @property
    def size(self) -> int:
        """Number of bytes that a first pull transfers."""
        return sum(layer.size for layer in self.layers)

    @property
    def passed(self) -> bool:
        """Every proof passed."""
        return all(proof.passed for proof in self.proofs)


@dataclass(frozen=True, kw_only=True, slots=True)
class Repair:
    """Lines that repair a failed build."""

    file: str
    """Path of the file that they belong to, relative to the checkout."""
    text: str
    diff: bool = False
    """They are a unified diff."""
    new: bool = False
    """The file does not exist yet."""
    start: bool = False
    """The build did not fail: with them the default command starts."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Report:
    """The report of a whole run."""

    plan: Plan
    image: str
    """``HOST/OWNER/NAME``."""
    published: bool
    """Whether the image's tags were made."""
    reason: str
    """Why the run publishes or does not."""
    digest: str = ""
    tags: tuple[str, ...] = ()
    platforms: tuple[PlatformReport, ...] = ()
    failures: tuple[str, ...] = ()
    artifacts: tuple[str, ...] = ()
    """Command that fetches an artifact of the run, without the artifact's name, in groups of words."""
    verify: tuple[str, ...] = ()
    """Command that checks the image's signature, in groups of words; empty if it is not signed."""
    unsigned: str = ""
    """Why a published image is not signed."""
    repairs: tuple[Repair, ...] = ()
    notes: tuple[str, ...] = ()
    """Further notes in Markdown, for example on the cache or whether the package is public."""
    slim: tuple[str, ...] = ()
    """Tags of the slim image."""
    badge: str = ""
    """Markdown to paste into the README, ``""`` if there is no page to link to."""


def platforms_of(reports: Iterable[PlatformReport], plan: Plan) -> tuple[PlatformReport, ...]:
    """Return the reports in the plan's order of platforms."""
    order = {platform: index for index, platform in enumerate(plan.platforms)}
    return tuple(sorted(reports, key=lambda report: order.get(report.platform, len(order))))


def to_json(report: PlatformReport) -> str:
    """Return a platform's report as JSON, for a later job."""
    return json.dumps(asdict(report), indent=2) + "\n"


def from_json(text: str) -> PlatformReport:
    """Read a platform's report back. Raises ``ValueError`` for anything that ``to_json`` did not write."""
    from cattrs import Converter  # noqa: PLC0415 - slow to import, and only the later steps read reports
    from cattrs.errors import BaseValidationError  # noqa: PLC0415

    try:
        report = Converter(forbid_extra_keys=True).structure(json.loads(text), PlatformReport)
    except (RecursionError, BaseValidationError) as error:
        raise ValueError(type(error).__name__) from None
    digests = [digest for each in (report, report.slim) if each for digest in (each.digest, each.source) if digest]
    if strange := [digest for digest in digests if not DIGEST.fullmatch(digest)]:
        raise ValueError(f"{strange[0]!r} is no digest")
    kept = report.archive
    if kept and not all(ARCHIVE.fullmatch(name) for name in (kept.artifact, kept.file, kept.name)):
        raise ValueError("the archive has a name that no archive gets")
    return report
