"""The decisions of a run, passed between the steps of a job as files and between jobs as one compressed line."""

from __future__ import annotations

import base64
import hashlib
import json
import tempfile
import zlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from roslab.errors import ConfigurationError, Problem
from roslab.github.inputs import Cache
from roslab.plan.plan import Plan, from_json
from roslab.render.outcome import PlatformReport
from roslab.render.outcome import from_json as report_of
from roslab.render.outcome import to_json as report_json
from roslab.values.dataclass import asdict, dataclass, replace

PORTABLE = 100_000
"""Most bytes of the line: a step reads another job's output from an environment variable, and Linux allows 128 KiB."""
LARGEST = 64 * 1024 * 1024
"""Most bytes of a run after decompression."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Run:
    """The plan, and what the event and the inputs add to it."""

    plan: Plan
    image: str
    """``HOST/OWNER/NAME`` without a tag."""
    username: str
    push: bool
    reason: str
    cache: Cache
    rebuilt: str | None = None
    """Full name of an old commit's git tag, ``""`` if it has none; ``None`` if the event's own commit is built."""
    archive: bool = False
    """Whether the image is kept as an archive among the run's artifacts."""
    path: str = ""
    """Folder of the checkout that is built, ``""`` for all of it."""
    revision: str = ""
    """Commit of the checkout that was planned for."""
    config: str = ""
    """The roslab.yaml that was read, relative to the built folder, ``""`` if there is none."""
    lock: bool = False
    """Whether the lock of the published image is kept."""
    variant: str = ""
    """Text that distinguishes calls for one image: two workflows may build it for two distributions."""

    @property
    def registry(self) -> str:
        """Host of the image."""
        return self.image.partition("/")[0]

    def here(self, environment: Mapping[str, str]) -> tuple[str, ...]:
        """Return the platforms of this job: the one that it was given, otherwise all of the plan's."""
        platform = environment.get("ROSLAB_PLATFORM")
        return (platform,) if platform else self.plan.platforms


def to_line(run: Run) -> str:
    """Return a run as one line of text that fits into an environment variable.

    If it is too long, explanations are left out: first the evidence for answers that lost, then all evidence.
    Raises ``ConfigurationError`` if the rest does not fit either.
    """
    text = _packed(run)
    if len(text) > PORTABLE:
        reasons = tuple(reason for reason in run.plan.reasons if reason.decisive)
        text = _packed(_thinner(run, reasons=reasons[:200], warnings=run.plan.warnings[:50]))
    if len(text) > PORTABLE:
        text = _packed(_thinner(run, reasons=(), warnings=run.plan.warnings[:20]))
    if len(text) > PORTABLE:
        problem = f"the plan has {len(text)} characters when it is packed, and one job hands {PORTABLE} to the next"
        hint = "build a part of the repository: name its folder by the input path"
        raise ConfigurationError(Problem(message=problem, hint=hint))
    return text


def _thinner(run: Run, **changes: Any) -> Run:
    return replace(run, plan=replace(run.plan, **changes))


def _packed(run: Run) -> str:
    text = json.dumps(asdict(run), ensure_ascii=True, separators=(",", ":"))
    return base64.b64encode(zlib.compress(text.encode(), 9)).decode()


def from_line(text: str) -> Run:
    """Read a run back. Raises ``ConfigurationError`` for anything that ``to_line`` did not write."""
    try:
        data = json.loads(zlib.decompressobj().decompress(base64.b64decode(text, validate=True), LARGEST))
        plan = from_json(json.dumps(data.pop("plan")))
        return Run(plan=plan, **data)
    except (ValueError, KeyError, TypeError, AttributeError, zlib.error) as error:
        raise ConfigurationError(Problem(message=f"not a run: {type(error).__name__}: {error}")) from None


@dataclass(frozen=True, kw_only=True, slots=True)
class Folder:
    """The private folder of one use of the action, under the runner's own temporary folder."""

    path: Path

    @classmethod
    def new(cls, environment: Mapping[str, str]) -> Folder:
        """Make a new folder; the runner empties RUNNER_TEMP before and after every job."""
        return cls(path=Path(tempfile.mkdtemp(prefix="roslab-", dir=environment.get("RUNNER_TEMP") or None)))

    @classmethod
    def of(cls, environment: Mapping[str, str]) -> Folder:
        """Return the folder that an earlier step made. Raises ``ConfigurationError`` if there is none."""
        path = Path(environment.get("ROSLAB_FOLDER") or "/nonexistent")
        if not (path / "run").is_file():
            raise ConfigurationError(
                Problem(message="ROSLAB_FOLDER names no run", hint="`roslab github plan` must have run in this job")
            )
        return cls(path=path)

    @property
    def run(self) -> Run:
        """The run that was written into this folder."""
        return from_line(self.read("run"))

    @property
    def dockerfile(self) -> Path:
        """Path of the generated Dockerfile."""
        return self.path / "dockerfile"

    @property
    def artifact(self) -> Path:
        """Folder of what the job keeps for later jobs and for people: reports, screenshots."""
        return self.path / "artifact"

    @property
    def archives(self) -> Path:
        """Folder of images that people may try, an artifact of its own."""
        return self.path / "archives"

    def write(self, name: str, text: str) -> None:
        """Keep a text."""
        (self.path / name).write_text(text, encoding="utf-8")

    def read(self, name: str) -> str:
        """Return a kept text, ``""`` if there is none."""
        file = self.path / name
        return file.read_text(encoding="utf-8") if file.is_file() else ""

    def write_report(self, report: PlatformReport) -> None:
        """Keep what was built and proved for one platform."""
        self.artifact.mkdir(exist_ok=True)
        self._report(report.platform).write_text(report_json(report), encoding="utf-8")

    def report(self, platform: str) -> PlatformReport:
        """Return what this job has kept for one platform."""
        return report_of(self._report(platform).read_text(encoding="utf-8"))

    def _report(self, platform: str) -> Path:
        return self.artifact / f"report-{slug(platform)}.json"


def candidate(folder: Folder, run: Run, platform: str) -> str:
    """Return the name in the engine of an image that is proved and not pushed."""
    return f"{run.plan.name}:{folder.path.name.lower()}-{slug(platform)}"


def image_folder_name(repository: str, path: str) -> str:
    """Return what an image is called after if nothing names it: the repository, and the folder of it that is built."""
    return "-".join(filter(None, (repository.partition("/")[2], path)))


def slug(platform: str) -> str:
    """Return a platform as part of a file name: ``linux-arm-v7``."""
    return platform.replace("/", "-")


def short(*values: str) -> str:
    """Return eight characters that stand for these values in a name that cannot contain the values themselves."""
    return hashlib.sha256("\0".join(values).encode()).hexdigest()[:8]


def artifact_name(what: str, run: Run) -> str:
    """Return the beginning of the name of an artifact of this call, which no other call of the workflow has."""
    return f"{what}-{run.image.partition('/')[2].replace('/', '-')}-{short(run.image, run.variant)}"


def reports_folder(folder: Folder, environment: Mapping[str, str]) -> Path:
    """Return the folder of all platforms' reports: ROSLAB_REPORTS if the job fetched them, else its own folder."""
    return Path(environment.get("ROSLAB_REPORTS") or folder.artifact)
