"""Removing an image's unneeded versions: by default they are only listed.

A run that the closing of a pull request starts removes that pull request's image alone.
"""

from __future__ import annotations

import datetime as dt
import re
from collections.abc import Mapping, Sequence
from pathlib import Path

from roslab.config.model import Config, TagParts
from roslab.engine import credentials, versions
from roslab.engine.versions import Manifest, Store, Version
from roslab.errors import BuildError, ConfigurationError, Problem
from roslab.github import access, api, checkout, event, inputs, packages, unneeded, workflow
from roslab.github.event import Event
from roslab.github.inputs import Inputs
from roslab.github.run import image_folder_name
from roslab.github.unneeded import Names, Removal, Rules
from roslab.pipeline import read_configuration
from roslab.plan.plan import image_name
from roslab.render.markdown import code, prose, table
from roslab.values.origin import Input

MOST_ROWS = 200


def clean(environment: Mapping[str, str]) -> None:
    """List the versions of an image that are not needed, and remove them if ``dry-run`` is false.

    Raises ``ConfigurationError`` for a wrong input, ``RefusedError`` if the registry would receive the run's own token,
    and ``BuildError``, with nothing removed, if GitHub or the registry does not give all the necessary information.
    """
    what, asked = event.read(environment), inputs.read(environment)
    if reason := _nothing_of(what):
        workflow.notice(reason)
        return
    config = _configuration(asked, environment)
    dry, rules = _read(environment, what, config.tags)
    name = config.name or image_name(image_folder_name(what.repository, asked.path))
    image = inputs.image(asked, owner=what.owner, name=name)
    given = environment.get("ROSLAB_SECRET_GIVEN") == "true"
    access.require_secret(asked.registry, name="registry-token", given=given)
    store = _store(image, asked.username or what.actor, environment)
    names = Names() if rules.pull else names_of(what, api.asker(environment))
    found = _versions(store, rules)
    going = unneeded.chosen(found, manifests_of(store, found), names, rules)
    staying = len({version.digest for version in found} - {each.version.digest for each in going})
    title = f"{len(going)} versions {'would go' if dry else 'go'}, {staying} stay" if going else "Nothing has to go"
    notes = (
        ()
        if store.whole
        else (f"{asked.registry} lists no digests without a tag: its own garbage collector has those.",)
    )
    workflow.summary(_page(image, title, going, notes, dry=dry), environment)
    for each in going:
        workflow.say(f"{each.version.digest} {' '.join(each.version.tags)}: {each.reason}")
    if not dry:
        for each in going:
            store.remove(each.version)
    workflow.outputs({"found": "\n".join(each.version.digest for each in going)}, environment)
    workflow.notice(f"{image}: {title[0].lower()}{title[1:]}")


def _nothing_of(what: Event) -> str:
    """Return why a pull request's closing leaves nothing to remove, ``""`` if something may be there.

    Raises ``ConfigurationError`` for a pull request that is open.
    """
    if not what.proposed:
        return ""
    if not what.closed:
        hint = "write `types: [closed]` below `pull_request:` in the workflow that calls this"
        raise ConfigurationError(Problem(message=f"an event {what.name} that closes no pull request", hint=hint))
    if what.foreign:
        return f"the pull request {what.pull} is another repository's, and has no image here"
    return "this run may only read: a later one removes the image, if there is one" if what.dependabot else ""


def _configuration(asked: Inputs, environment: Mapping[str, str]) -> Config:
    """Return what roslab.yaml and the inputs say of the image."""
    workspace = Path(environment.get("GITHUB_WORKSPACE") or ".").resolve()
    root = checkout.part(workspace, asked.path)
    with checkout.placed(asked.path):
        return read_configuration(root, config_file=asked.config, overrides=asked.overrides, top=workspace)


def _versions(store: Store, rules: Rules) -> tuple[Version, ...]:
    """Return the versions; a repository whose pull request is closed may have published nothing yet."""
    try:
        return store.versions()
    except packages.NoPackageError as error:
        if not rules.pull:
            raise
        workflow.warn(error.problems[0])
        return ()


def names_of(what: Event, ask: api.Ask) -> Names:
    """Return the names of the repository's branches. Raises ``BuildError`` if GitHub does not list them."""
    path = f"/repos/{what.repository}"
    branches = api.pages(ask, f"{path}/branches") or []
    tags = api.pages(ask, f"{path}/tags")
    pulls = api.pages(ask, f"{path}/pulls?state=closed", whole=False)  # the newest first
    living = frozenset(str(entry["name"]) for entry in branches)
    if what.default_branch not in living or tags is None or pulls is None:
        hint = "grant the calling job `contents: read` and `pull-requests: read`"
        raise BuildError(Problem(message=f"GitHub does not list the branches of {what.repository}", hint=hint))
    own = [pull for pull in pulls if ((pull["head"].get("repo") or {}).get("full_name") or "") == what.repository]
    return Names(
        branches=living,
        git_tags=frozenset(str(entry["name"]) for entry in tags),
        closed=frozenset(str(pull["head"]["ref"]) for pull in own) - living,
        closed_pulls=frozenset(str(pull["number"]) for pull in pulls),
    )


def _read(environment: Mapping[str, str], what: Event, parts: TagParts) -> tuple[bool, Rules]:
    """Return whether this is a dry run, and the rules that the inputs and the event give."""
    dry = (environment.get("INPUT_DRY_RUN") or "true").strip().lower()
    days = (environment.get("INPUT_DAYS") or "30").strip()
    problems = []
    if dry not in ("true", "false"):
        problems.append(
            Problem(message=f"{dry!r} is not known", hint="write true or false", origin=Input(name="dry-run"))
        )
    if not re.fullmatch(r"[1-9]\d{0,3}", days):
        hint = "write a number from 1 on: a build may run for hours before its image has a tag"
        problems.append(Problem(message=f"{days!r} is no number of days", hint=hint, origin=Input(name="days")))
    if problems:
        raise ConfigurationError(*problems)
    keep = tuple(re.split(r"[\s,]+", (environment.get("INPUT_KEEP") or "").strip()))
    pull = str(what.pull) if what.closed else ""
    return dry == "true", Rules(days=int(days), keep=tuple(filter(None, keep)), parts=parts, pull=pull)


def _store(image: str, username: str, environment: Mapping[str, str]) -> Store:
    """Return the store for the image's registry; GitHub's API lists more than the standard protocol does."""
    password = environment.get("ROSLAB_TOKEN", "")
    if image.partition("/")[0] != access.OWN:
        return versions.store(credentials.session(image, username, password, "pull,delete"))
    theirs = {**environment, "ROSLAB_GITHUB_TOKEN": password}
    session = credentials.session(image, username, password, "pull")
    now = dt.datetime.now(tz=dt.timezone.utc)
    return packages.store(image, api.asker(theirs), api.asker(theirs, method="DELETE"), session, now=now)


def manifests_of(store: Store, found: Sequence[Version]) -> dict[str, Manifest]:
    """Return each version's manifest. Raises ``BuildError`` if one is missing: it may refer to what must stay."""
    known = {version.digest: store.manifest(version.digest) for version in found}
    missing = [digest for digest, manifest in known.items() if manifest is None]
    if missing:
        hint = "if a build was running, start this again after it; nothing was removed"
        raise BuildError(Problem(message=f"the registry lists {', '.join(missing)} and does not give it", hint=hint))
    return {digest: manifest for digest, manifest in known.items() if manifest is not None}


def _page(image: str, title: str, going: Sequence[Removal], notes: Sequence[str], *, dry: bool) -> str:
    """Return the summary."""
    rows = [
        (code(" ".join(each.version.tags) or each.version.digest[:19]), prose(each.reason))
        for each in going[:MOST_ROWS]
    ]
    parts = [f"### {title}", f"Of {code(image)}."]
    if going:
        parts.append(table(("version", "why"), rows).strip())
    if len(going) > MOST_ROWS:
        parts.append(f"And {len(going) - MOST_ROWS} more, which the log lists.")
    if going and dry:
        parts.append(f"Nothing was removed: write {code('dry-run: false')} to remove them.")
    return "\n\n".join([*parts, *map(prose, notes)]) + "\n"
