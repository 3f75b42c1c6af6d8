"""The report of a run, collected from the files that its steps and jobs kept."""

from __future__ import annotations

import json
from pathlib import Path, PurePosixPath
from urllib.parse import quote

from roslab.errors import ConfigurationError
from roslab.github import kept
from roslab.github.event import Event
from roslab.github.run import Folder, Run
from roslab.plan.locked import NAME
from roslab.render import climbed
from roslab.render.markdown import code
from roslab.render.outcome import Report, platforms_of


def collect(folder: Folder, reports: Path, event: Event) -> Report:
    """Return the report; ``reports`` is the folder that holds every platform's."""
    run = folder.run
    published = json.loads(folder.read("published.json") or "{}")
    own = kept.gather(folder.artifact)
    try:
        jobs = kept.gather(reports)
    except ConfigurationError:  # an earlier step has reported it
        jobs = ()
    failures = tuple(dict.fromkeys(line for job in (*jobs, *own) for line in job.failures))
    repairs = tuple(dict.fromkeys(repair for job in (*jobs, *own) for repair in job.repairs))
    platforms = platforms_of(kept.reports(jobs), run.plan)
    unpublished = folder.read("unpublished")
    if not published and not unpublished and not failures and (run.push or not platforms):
        failures = ("the run stopped early: the failed step's log says why",)
    return Report(
        plan=run.plan,
        repairs=repairs,
        image=run.image,
        published=bool(published),
        reason=unpublished or run.reason,
        digest=published.get("digest", ""),
        tags=tuple(published.get("tags", ())),
        platforms=platforms,
        failures=failures,
        artifacts=(f"gh run download {event.run}", f"--repo {event.repository}"),
        verify=tuple(published.get("verify", ())),
        unsigned=published.get("unsigned", ""),
        notes=(*_visibility(run, event, public=published.get("public")), *_lock(folder, run, event))
        if published
        else _origin(event),
        slim=tuple(published.get("slim", ())),
        badge="\n".join(filter(None, (_badge(run, event), climbed.badge(platforms, run.revision)))),
    )


def _visibility(run: Run, event: Event, *, public: bool | None) -> tuple[str, ...]:
    """Return a note on who may pull the image; on ghcr.io the first push makes a package that only its owner sees."""
    if public is None:
        return ()
    if public:
        return ("Anybody may pull this image.",)
    if run.registry != "ghcr.io":
        return (f"Nobody may pull this image from {code(run.registry)} without a password.",)
    page = _package(run, event)
    private = "**The package is private**, so readers of the paper cannot pull it."
    return (f"{private} Open [its page]({page}), Package settings, Danger Zone, Change visibility, Public.",)


def _lock(folder: Folder, run: Run, event: Event) -> tuple[str, ...]:
    """Return how the lock of the image comes into the repository, if it was kept."""
    name = folder.read("lock-artifact")
    if not name:
        return ()
    where = PurePosixPath(run.path, run.config).parent
    fetch = code(f"gh run download {event.run} --repo {event.repository} --name {name} --dir {where}")
    return (f"{code(NAME)} of this image: {fetch}; once it is committed, the next build takes the same versions.",)


def _origin(event: Event) -> tuple[str, ...]:
    """Return a note on the code of an image that is offered to be tried."""
    if not event.foreign:
        return ()
    return ("It holds code from outside this repository: read the changes before you run it.",)


def _package(run: Run, event: Event) -> str:
    """Return the package's page: https://docs.github.com/en/packages/learn-github-packages/viewing-packages."""
    name = quote(run.image.split("/", 2)[2], safe="")
    return f"{event.server}/{event.repository}/pkgs/container/{name}"


def _badge(run: Run, event: Event) -> str:
    """Return the badge of the workflow, which shows whether the last image was proved."""
    if run.registry != "ghcr.io" or not event.workflow_file or event.proposed:
        return ""
    page = f"{event.server}/{event.repository}/actions/workflows/{quote(event.workflow_file)}"
    branch = quote(event.default_branch, safe="")
    return f"[![image]({page}/badge.svg?branch={branch})]({_package(run, event)})"
