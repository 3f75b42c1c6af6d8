"""The event that started the run, and whether it may publish an image."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Literal

from roslab.config.model import PullImage
from roslab.errors import ConfigurationError, Problem, RefusedError
from roslab.values.dataclass import dataclass

Push = Literal["auto", "true", "false"]
PUBLISHING = ("push", "create", "release", "schedule", "workflow_dispatch", "repository_dispatch", "workflow_run")
"""Events that publish by default, because their code is the repository's own."""
PRIVILEGED = ("pull_request_target", "workflow_run")
"""Events that run with the repository's rights although the code may come from a stranger.
https://docs.github.com/en/actions/reference/security/securely-using-pull_request_target"""

QUEUE = "refs/heads/gh-readonly-queue/"
"""https://docs.github.com/en/repositories/configuring-branches-and-merges-in-your-repository/configuring-pull-request-merges/managing-a-merge-queue"""


@dataclass(frozen=True, kw_only=True, slots=True)
class Event:
    """What the runner's environment says about the run."""

    name: str
    repository: str
    """``owner/name`` as GitHub spells it."""
    ref: str
    """``refs/heads/main``, ``refs/tags/v1``, ``refs/pull/7/merge``."""
    sha: str
    default_branch: str
    server: str = "https://github.com"
    actor: str = ""
    workflow_file: str = ""
    """File name of the workflow that was started, ``""`` if the runner does not say."""
    base_branch: str = ""
    """The branch that a pull request is to be merged into."""
    proposed: bool = False
    """The code is only proposed: the event is a pull request or follows from one."""
    head: str | None = None
    """Repository that the code of a pull request comes from, ``None`` if it was deleted or there is none."""
    pull: int | None = None
    """Number of the pull request, ``None`` if the event names none."""
    head_branch: str = ""
    """Branch that a pull request comes from."""
    head_sha: str = ""
    """Newest commit of that branch when the run began; ``sha`` is its merge into the base branch."""
    closed: bool = False
    """The pull request was just closed, merged or not."""
    head_commit: str = ""
    """The newest commit of the pull request; ``sha`` is that of its merge."""
    public: bool = False
    """The repository is known to be public."""
    enterprise: bool = False
    """The repository belongs to an enterprise, so GitHub signs for it although it is private."""
    description: str = ""
    """What GitHub shows below the repository's name."""
    licence: str = ""
    """Identifier of SPDX, ``""`` if GitHub does not know the licence."""
    signing: bool = False
    """The caller granted ``id-token: write``."""
    act: bool = False
    run: str = ""
    """Number of the run, by which its artifacts are found."""

    @property
    def owner(self) -> str:
        """Owner of the repository."""
        return self.repository.partition("/")[0]

    @property
    def page(self) -> str:
        """Address of the run."""
        return f"{self.server}/{self.repository}/actions/runs/{self.run}"

    @property
    def branch(self) -> str | None:
        """Name of the branch that is built, ``None`` for a tag or a pull request."""
        return self.ref.removeprefix("refs/heads/") if self.ref.startswith("refs/heads/") else None

    @property
    def tag(self) -> str | None:
        """Name of the git tag that is built, ``None`` for anything else."""
        return self.ref.removeprefix("refs/tags/") if self.ref.startswith("refs/tags/") else None

    @property
    def queued(self) -> bool:
        """The code waits in a merge queue and is not merged yet; the queue's branches trigger ``push`` too."""
        return self.name == "merge_group" or self.ref.startswith(QUEUE)

    @property
    def dependabot(self) -> bool:
        """Dependabot started the run, whose token may then only read.

        https://docs.github.com/en/code-security/dependabot/troubleshooting-dependabot/troubleshooting-dependabot-on-github-actions
        """
        return self.actor == "dependabot[bot]"

    @property
    def foreign(self) -> bool:
        """The proposed code comes from another repository, or from one that was deleted."""
        return self.proposed and (self.head or "").lower() != self.repository.lower()


@dataclass(frozen=True, kw_only=True, slots=True)
class Publication:
    """Whether this run publishes, why, and which of the caller's wishes was refused."""

    push: bool
    reason: str
    warning: str | None = None


def read(environment: Mapping[str, str]) -> Event:
    """Read the event from the runner's environment.

    Raises ``ConfigurationError`` if the runner's variables are missing, ``RefusedError`` for a privileged event
    whose code comes from a stranger.
    """
    name = environment.get("GITHUB_EVENT_NAME", "")
    repository = environment.get("GITHUB_REPOSITORY", "")
    if not name or repository.count("/") != 1:
        missing = "GITHUB_REPOSITORY" if name else "GITHUB_EVENT_NAME"
        raise ConfigurationError(
            Problem(message=f"{missing} is not set", hint="`roslab github` is for a step of a workflow")
        )
    payload = _payload(environment.get("GITHUB_EVENT_PATH"))
    pull_request, head = _origin(name, payload)
    event = Event(
        name=name,
        repository=repository,
        ref=environment.get("GITHUB_REF", ""),
        sha=environment.get("GITHUB_SHA", ""),
        default_branch=_default_branch(name, payload, environment.get("GITHUB_REF", "")),
        server=environment.get("GITHUB_SERVER_URL") or "https://github.com",
        actor=environment.get("GITHUB_ACTOR", ""),
        workflow_file=environment.get("GITHUB_WORKFLOW_REF", "").partition("@")[0].rpartition("/")[2],
        base_branch=environment.get("GITHUB_BASE_REF") or _text(payload, "pull_request", "base", "ref"),
        proposed=pull_request,
        head=head,
        pull=_number(payload),
        head_branch=_text(payload, "pull_request", "head", "ref"),
        head_sha=_text(payload, "pull_request", "head", "sha"),
        closed=name == "pull_request" and _text(payload, "action") == "closed",
        head_commit=_text(payload, "pull_request", "head", "sha"),
        public=_get(payload, "repository", "private") is False,
        enterprise=bool(_get(payload, "enterprise")),
        description=_text(payload, "repository", "description"),
        licence=_text(payload, "repository", "license", "spdx_id").removesuffix("NOASSERTION"),
        signing=bool(environment.get("ACTIONS_ID_TOKEN_REQUEST_URL")),
        act=environment.get("ACT") == "true",
        run=environment.get("GITHUB_RUN_ID", ""),
    )
    if name in PRIVILEGED and event.foreign:
        raise RefusedError(
            Problem(
                message=f"refused: {name} holds this repository's rights, and the code comes from "
                f"{event.head or 'a repository that is gone'}",
                hint="start this workflow by `pull_request` instead: it builds and proves, without any right to push",
            )
        )
    return event


def _payload(path: str | None) -> dict[str, Any]:
    if not path:
        return {}
    try:
        data = json.loads(Path(path).read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise ConfigurationError(
            Problem(message=f"cannot read the event that GITHUB_EVENT_PATH names: {error}")
        ) from None
    return data if isinstance(data, dict) else {}


def _default_branch(name: str, payload: Mapping[str, Any], ref: str) -> str:
    """Return the default branch, which is the run's own for a schedule, whose event may not describe the repository.

    https://docs.github.com/en/actions/reference/workflows-and-actions/events-that-trigger-workflows#schedule
    """
    said = _text(payload, "repository", "default_branch")
    return said or (ref.removeprefix("refs/heads/") if name == "schedule" else "") or "main"


def _origin(name: str, payload: Mapping[str, Any]) -> tuple[bool, str | None]:
    """Return whether the code is a pull request's, and the repository that it comes from."""
    if name == "workflow_run":
        started_by = _text(payload, "workflow_run", "event")
        head = _text(payload, "workflow_run", "head_repository", "full_name") or None
        elsewhere = head != (_text(payload, "repository", "full_name") or head)
        return started_by.startswith("pull_request") or elsewhere or head is None, head
    if name.startswith("pull_request") or _get(payload, "pull_request") or _get(payload, "issue", "pull_request"):
        return True, _text(payload, "pull_request", "head", "repo", "full_name") or None
    return False, None


def _get(payload: Mapping[str, Any], *keys: str) -> Any:
    value: Any = payload
    for key in keys:
        value = value.get(key) if isinstance(value, dict) else None
    return value


def _number(payload: Mapping[str, Any]) -> int | None:
    value = _get(payload, "pull_request", "number")
    return value if isinstance(value, int) else None


def _text(payload: Mapping[str, Any], *keys: str) -> str:
    value = _get(payload, *keys)
    return value if isinstance(value, str) else ""


def _may_try(event: Event) -> bool:
    """Return whether the event is a pull request of the repository's own, started with its rights to publish."""
    own = event.name == "pull_request" and event.pull is not None and not event.foreign
    return own and not event.closed and not event.dependabot


def _refusal(event: Event) -> str:
    """Return why an event publishes nothing whatever the caller wishes, ``""`` if it may."""
    if event.proposed or event.queued:
        what = "a pull request from a fork" if event.foreign and event.head else "a pull request"
        what = "a merge queue" if event.queued else what
        return f"{what} builds and proves the image and publishes nothing"
    if event.name == "push" and event.dependabot:
        return "Dependabot's own pushes hold a token that may only read"
    return ""


def publication(event: Event, wish: Push, pr: PullImage | None = None) -> Publication:
    """Decide whether the run publishes.

    A pull request publishes only as ``pr-NUMBER``, only if ``pr`` of roslab.yaml is ``image`` and its code is the
    repository's own; a stranger's never does, whatever the caller wishes.
    """
    if pr == "image" and wish != "false" and _may_try(event):
        return Publication(push=True, reason="`pr: image` in roslab.yaml, and the pull request is the repository's own")
    if refused := _refusal(event):
        hint = "; `pr: image` in roslab.yaml publishes a pull request's image to be tried" if _may_try(event) else ""
        warning = f"`push: true` is ignored: {refused}{hint}" if wish == "true" else None
        return Publication(push=False, reason=refused, warning=warning)
    if wish == "false":
        return Publication(push=False, reason="`push: false` was asked for")
    if wish == "true":
        return Publication(push=True, reason="`push: true` was asked for")
    if event.name in PUBLISHING:
        return Publication(push=True, reason=f"the event is `{event.name}`, and the code is the repository's own")
    return Publication(push=False, reason=f"the event `{event.name}` publishes only with `push: true`")
