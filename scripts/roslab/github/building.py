"""The step that writes the Dockerfile, and what docker/build-push-action is given."""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Mapping

from roslab.engine.bases import Mended, mend
from roslab.errors import BuildError, Problem
from roslab.github import builder, cache, checkout, disk, event, locking, rebuild, secrets, tree, workflow
from roslab.github import run as runs
from roslab.github.labels import labels
from roslab.github.run import Folder, Run, slug
from roslab.pipeline import bases_of, preflight, write_bases, write_plan, write_policy
from roslab.repository import git as commits
from roslab.values.dataclass import replace

Environment = Mapping[str, str]


def dockerfile(environment: Environment) -> None:
    """Write the Dockerfile and output everything that docker/build-push-action needs."""
    folder = Folder.of(environment)
    run = folder.run
    what = rebuild.event_of(event.read(environment), run.rebuilt, run.revision)
    root = checkout.part(checkout.workspace(environment), run.path)
    folder.dockerfile.mkdir(exist_ok=True)
    for found in preflight(run.plan, run.here(environment)):
        if found.certain:
            workflow.warn(Problem(message=found.text))
        else:
            workflow.say(found.text)
    given = secrets.held(folder, run, environment)
    run = replace(run, plan=locking.available(run.plan, run.here(environment), given))
    dockerfile, context = write_plan(run.plan, root, folder.dockerfile)
    authored = run.plan.author_dockerfile
    if authored and (copy := checkout.shielded(dockerfile, context, folder.dockerfile)):
        dockerfile = copy
        hint = "write `persist-credentials: false` below `with:` of actions/checkout"
        workflow.warn(Problem(message="the checkout left a token in .git, so the build does not see .git", hint=hint))
    revision, seconds = commits.head(root)
    if revision and run.revision and revision != run.revision:
        raise BuildError(Problem(message=f"the checkout is at {revision}, and the plan was made for {run.revision}"))
    named = labels(run.plan, what, revision=run.revision, seconds=seconds)
    platforms = run.here(environment)
    disk.before_build(run, platforms, environment)
    publication = event.Publication(push=run.push, reason=run.reason)
    part = slug(platforms[0]) if len(platforms) == 1 else "all"
    layers = cache.layers(what, publication, run.cache, image=run.image, part=part, variant=run.variant)
    workflow.say(f"layer cache: {layers.reason}")
    mended = _mended(
        folder,
        run,
        platforms,
        lambda stage: cache.layers(
            what, publication, run.cache, image=run.image, part=f"{part}-{stage}", variant=run.variant
        ),
        seconds,
    )
    mounts = cache.mounts(what, run.cache, variant=run.variant)
    kept = cache.tree(what, publication, run.cache, image=run.image, part=part, variant=run.variant)
    source = tree.source_of(run.plan, root)
    carrier = tree.Carrier(plan=run.plan, folder=folder.dockerfile, platforms=platforms, mounts=mounts, source=source)
    tree.take(carrier, kept.read)
    arguments = (*(authored.args if authored else ()), ("BUILDKIT_CACHE_MOUNT_NS", mounts))
    by_digest = f"type=image,name={run.image},push=true,push-by-digest=true,name-canonical=true"
    if run.plan.as_of:
        by_digest += ",rewrite-timestamp=true"  # the same day gives the same image, whenever it is built
    loaded = f"type=docker,name={runs.candidate(folder, run, platforms[0])}" if len(platforms) == 1 else ""
    build = {
        "dockerfile": str(dockerfile),
        "context": str(context),
        "labels": "\n".join(f"{name}={value}" for name, value in named),
        # Those of the index are made with it: the build of one platform has none
        "annotations": "\n".join(f"manifest:{name}={value}" for name, value in named) if run.push else "",
        "platforms": ",".join(platforms),
        "build-args": "\n".join(f"{name}={value}" for name, value in arguments),
        "build-contexts": "\n".join(f"{name}={value}" for name, value in mended.contexts),
        "slim": workflow.flag(run.plan.slim),
        "target": (authored.target or "") if authored else "",
        # A pull request's image goes straight to the engine; several platforms stay in the builder, to be loaded singly
        "exporter": by_digest if run.push else loaded or "type=cacheonly",
        "cache-from": "\n".join(layers.read),
        "cache-to": "\n".join(layers.write),
        "epoch": str(seconds) if seconds is not None else "",
        "source-policy": "".join(write_policy(run.plan, folder.dockerfile).values()),
        "provenance": ("mode=max" if what.public else "mode=min,inline-only=true") if run.push else "false",
        "sbom": builder.scanner(environment, wanted=run.push and what.public, act=what.act),
    }
    build |= secrets.outputs(given)
    later = {"started": time.time(), "tree": kept.write, "mounts": mounts, "source": source}
    folder.write("build.json", json.dumps({**build, **later}))
    workflow.outputs(build, environment)


def _mended(
    folder: Folder, run: Run, platforms: tuple[str, ...], layers: Callable[[str], cache.Layers], seconds: int | None
) -> Mended:
    """Build what replaces the images of the author's Dockerfile that no longer answer, each with a cache of its own."""
    file = write_bases(run.plan, folder.dockerfile)
    if file is None:
        return Mended()
    stages = bases_of(run.plan)
    options = {}
    for stage, _ in stages:
        cached = layers(stage)
        options[stage] = (
            *(f"--cache-from={entry}" for entry in cached.read),
            *(f"--cache-to={entry}" for entry in cached.write),
        )
    # The same commit gives the same image, so that the layers above it are found in the cache
    epoch = {} if seconds is None else {"SOURCE_DATE_EPOCH": str(seconds)}
    return mend(stages, file, platforms=platforms, options=options, environment=epoch)
