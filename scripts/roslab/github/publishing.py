"""Tagging a proved image: first the commit's own tag, which is signed, then the tags that move."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence

from roslab.engine import credentials, registry
from roslab.errors import BuildError, Problem, RefusedError
from roslab.github import api, event, kept, locking, offering, rebuild, signing, slim, tags, workflow
from roslab.github.event import Event
from roslab.github.labels import PREFIX
from roslab.github.run import Folder, Run, reports_folder
from roslab.plan import record
from roslab.render.outcome import PlatformReport, SlimReport, platforms_of

REVISION = f"{PREFIX}.revision"


def index(environment: Mapping[str, str]) -> None:
    """Push one index of the proved images under the tag of their commit, which no other commit has.

    ROSLAB_TAGS has one complete reference per line, ROSLAB_REPORTS names the folder with every platform's report.
    Raises ``BuildError`` if a platform has no passed proof or the registry refuses, ``RefusedError`` if a report
    belongs to another commit.
    """
    folder = Folder.of(environment)
    run, what, said = _asked(folder, environment)
    proved = platforms_of(kept.reports(kept.gather(reports_folder(folder, environment))), run.plan)
    missing = [p for p in run.plan.platforms if not any(r.platform == p and r.passed and r.source for r in proved)]
    if not run.push or missing:
        reason = f"no passed proof for {', '.join(missing)}" if missing else run.reason
        raise BuildError(Problem(message=f"nothing gets a tag: {reason}"))
    verify(run, proved)
    if what.proposed and api.branch_head(what, api.asker(environment)) != what.head_sha:
        reason = f"the pull request {what.pull} has another commit now, or is gone: its tag stays where it is"
        folder.write("unpublished", reason)
        workflow.warn(Problem(message=reason))
        return
    own = tags.dressed(tags.own(said, run.image, what), run.plan.tags)
    annotated = _annotations(f"{run.image}@{proved[0].digest}")
    made = record.record(run.plan, {each.platform: each.ladder for each in proved})
    annotated[record.KEY] = record.to_json(made)
    annotated |= locking.kept(folder, reports_folder(folder, environment), environment)
    digest = registry.create_index(run.image, tuple(dict.fromkeys(report.source for report in proved)), own, annotated)
    digests = {report.platform: report.digest for report in proved}
    small = _slim_index(run, proved, tags.dressed(tags.own(said, run.image, what), tags.of_slim(run.plan.tags)))
    unsigned = signing.unsigned(what)
    made_now = {"digest": digest, "own": own, "digests": digests, "unsigned": unsigned, "slim": small}
    folder.write("index.json", json.dumps(made_now))
    folder.write("proof.json", record.to_result(made, url=what.page))
    signing_of = {"sign": "false" if unsigned else "true", "result": str(folder.path / "proof.json")}
    signing_of |= {"slim-digest": small["digest"] if small else "", "result-type": record.RESULT}
    workflow.outputs({"digest": digest, **signing_of}, environment)


def _slim_index(run: Run, proved: Sequence[PlatformReport], own: str) -> dict[str, str] | None:
    """Push the index of the slim images under its commit's tag; ``None`` if one of them failed, or none was wanted."""
    images = {each.platform: each.slim for each in proved if each.slim}
    if not slim.complete(run, proved):
        return None
    sources = tuple(dict.fromkeys(image.source for image in images.values()))
    annotated = _annotations(f"{run.image}@{next(iter(images.values())).digest}")
    annotated[record.KEY] = record.to_json(record.record(run.plan, {on: each.ladder for on, each in images.items()}))
    return {"digest": registry.create_index(run.image, sources, own, annotated), "own": own}


def _annotations(reference: str) -> dict[str, str]:
    """Return what an image's annotations say of its commit, for the index that holds it."""
    return {name: value for name, value in registry.annotations_of(reference).items() if name.startswith(PREFIX)}


def _asked(folder: Folder, environment: Mapping[str, str]) -> tuple[Run, Event, str]:
    """Return the run, the event of the commit that was built, and the requested tags, one per line."""
    run = folder.run
    what = rebuild.event_of(event.read(environment), run.rebuilt, run.revision)
    said = environment.get("ROSLAB_TAGS", "") if run.rebuilt is None else rebuild.names(what, run.image)
    return run, what, said


def verify(run: Run, reports: tuple[PlatformReport, ...]) -> None:
    """Raise ``RefusedError`` if a report names an image that was not planned by this run or built from this commit.

    Any job of the caller may upload an artifact that looks like a report, so the image's labels and platform are read
    from the registry.
    """
    problems = []
    images: list[tuple[str, str, PlatformReport | SlimReport]] = []
    for each in reports:
        images.append((f"the report for {each.platform}", each.platform, each))
        if each.slim and each.slim.source:
            images.append((f"the slim image's report for {each.platform}", each.platform, each.slim))
    sources = dict.fromkeys(image.source for _, _, image in images)
    configurations = {source: registry.configurations(run.image, source) for source in sources}
    held = {source: registry.held(run.image, source) for source in sources}
    for whose, platform, image in images:
        found = configurations[image.source].get(platform)
        made_from = ((found or {}).get("config", {}).get("Labels") or {}).get(REVISION, "")
        proofs = [proof.name for proof in image.proofs]
        if platform not in run.plan.platforms:
            problems.append(f"a report is for {platform}, which was not planned")
        elif proofs != [proof.name for proof in run.plan.proofs]:
            problems.append(f"{whose} has not the proofs that were planned")
        elif found is None or image.digest not in held[image.source]:
            problems.append(f"{whose} names {image.source}, which holds no such image")
        elif made_from != run.revision:
            problems.append(f"{whose} names an image of {made_from or 'no commit'}, and this is {run.revision}")
    if problems:
        raise RefusedError(*(Problem(message=f"refused: {problem}") for problem in problems))


def tag(environment: Mapping[str, str]) -> None:
    """Move the other tags to the index; those of a branch move only if its head is still this commit.

    ROSLAB_SIGNATURE is the outcome of the step that signed, ROSLAB_SIGNER the repository of the workflow that it
    belongs to. Raises ``BuildError`` if the registry refuses.
    """
    folder = Folder.of(environment)
    run, what, said = _asked(folder, environment)
    if folder.read("unpublished"):
        workflow.outputs({"digest": "", "digests": "", "tags": ""}, environment)
        return
    made = json.loads(folder.read("index.json"))
    digest = str(made["digest"])
    signed = environment.get("ROSLAB_SIGNATURE") == "success"
    unsigned = "" if signed else str(made["unsigned"]) or signing.FAILED
    if unsigned == signing.FAILED:
        workflow.warn(Problem(message="the image is not signed", hint=signing.FAILED))
    ask = api.asker(environment)
    # Asked as late as possible: somebody may have pushed while this commit was built
    head, releases = api.branch_head(what, ask), api.releases(what, ask)
    chosen = tags.chosen(said, run.image, what, head=head, releases=releases)
    for warning in chosen.warnings:
        workflow.warn(Problem(message=warning))
    moving = tuple(tags.dressed(reference, run.plan.tags) for reference in chosen.moving)
    registry.put_tags(run.image, digest, moving)
    names = (str(made["own"]), *moving)
    small = _slim_tags(run, made["slim"], chosen.moving, environment) if made["slim"] else ()
    public = credentials.is_public(run.image, digest)
    verify = signing.verification(run.image, digest, what, environment.get("ROSLAB_SIGNER", "")) if signed else ()
    published = {"digest": digest, "tags": names, "public": public, "verify": verify, "unsigned": unsigned}
    published["slim"] = small
    folder.write("published.json", json.dumps(published))
    digests = json.dumps(made["digests"], separators=(",", ":"))
    workflow.outputs({"digest": digest, "digests": digests, "tags": "\n".join(names)}, environment)
    workflow.notice(f"{names[-1]} is {digest}")
    if run.rebuilt is None:
        offering.offer(folder, run, what, digest, environment)


def _slim_tags(
    run: Run, made: Mapping[str, str], moving: Sequence[str], environment: Mapping[str, str]
) -> tuple[str, ...]:
    """Move the slim image's tags, and return them all."""
    signed = environment.get("ROSLAB_SLIM_SIGNATURE")
    if environment.get("ROSLAB_SIGNATURE") == "success" and signed != "success":
        workflow.warn(Problem(message="the slim image is not signed, and the whole one is"))
    found = tuple(tags.dressed(reference, tags.of_slim(run.plan.tags)) for reference in moving)
    registry.put_tags(run.image, made["digest"], found)
    return (made["own"], *found)
