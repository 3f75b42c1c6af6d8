"""The stand-in images: made from the recipes in images/, tagged in the engine and pushed to the mirror of docker.io."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Any

from . import facts, packages_folder, registry, rootfs
from .command import LabError, run, succeeds
from .home import HERE, folder, recipe

RECIPES = HERE / "images"


@dataclass(frozen=True, kw_only=True, slots=True)
class Image:
    """One stand-in: its recipe, the image below it, the real names it answers to, and what it is made for."""

    id: str
    recipe: str
    base: str | None
    suite: str | None
    args: tuple[tuple[str, str], ...]
    names: tuple[str, ...]
    architectures: tuple[str, ...]
    contexts: tuple[tuple[str, Path], ...] = ()
    """Folders beside the recipe's, by the names of the stages that they replace."""
    patterns: tuple[str, ...] = ()
    """Further names, which it gets when somebody asks for one of them."""
    on_request: bool = False
    """It is made only when somebody asks for one of its names."""


def wanted(architectures: Sequence[str], *, everything: bool = False) -> tuple[Image, ...]:
    """Return the stand-ins of images.toml, each after the one it is based on, for these architectures.

    Those that take long under emulation are made for their own architecture only, unless `everything` is wanted.
    An image of a distribution's own packages is made only where they are, with the names of the one it replaces.
    """
    rows = [
        row for row in facts.table("images")["image"] if "packages" not in row or packages_folder.place(row["packages"])
    ]
    replaced = {row["replaces"]: row["id"] for row in rows if "replaces" in row}
    names = {replaced.get(row["id"], row["id"]): row["names"] for row in rows if "replaces" not in row}
    return tuple(
        Image(
            id=row["id"],
            recipe=row["recipe"],
            base=row.get("base"),
            suite=row.get("suite"),
            args=tuple(sorted(row.get("args", {}).items())),
            names=tuple(names[row["id"]]),
            contexts=_contexts(row),
            patterns=tuple(row.get("patterns", ())),
            on_request=row.get("on_request", False),
            architectures=tuple(
                a for a in architectures if a in row["platforms"] and (everything or a not in row.get("slow", ()))
            ),
        )
        for row in rows
        if row["id"] not in replaced
    )


def needed(images: Sequence[Image], names: Sequence[str]) -> tuple[Image, ...]:
    """Return the stand-ins with these real names, and those that they are based on.

    Raises LabError for a name that no stand-in has.
    """
    by_id = {image.id: image for image in images}
    found: dict[str, Image] = {}
    for name in names:
        image = next((image for image in images if name in image.names or _matches(image, name)), None)
        if image is None:
            raise LabError(f"there is no stand-in for {name}, and the real one is out of reach")
        while image is not None:
            known = found.get(image.id, image)
            found[image.id] = replace(known, names=(*known.names, name)) if _matches(image, name) else known
            image = by_id[image.base] if image.base else None
    return tuple(found[image.id] for image in images if image.id in found)


def _matches(image: Image, name: str) -> bool:
    return any(fnmatchcase(name, pattern) for pattern in image.patterns)


def references(images: Sequence[Image]) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Return the lab's own name of each of these stand-ins, with its real names."""
    by_id = {image.id: image for image in images}
    return tuple((_reference(image, by_id), image.names) for image in images)


def _contexts(row: dict[str, Any]) -> tuple[tuple[str, Path], ...]:
    """Return the folders that an image takes beside its recipe: other recipes, and a distribution's own packages."""
    beside = tuple((name, RECIPES / recipe) for name, recipe in sorted(row.get("contexts", {}).items()))
    packages = packages_folder.place(row["packages"]) if "packages" in row else None
    return (*beside, ("packages", packages)) if packages else beside


def make(image: Image, others: Sequence[Image], env: dict[str, str]) -> str:
    """Make sure that one stand-in is in the engine and in the mirror under all its names; return a note.

    `others` are all images of the same call; `env` names the engine and the Docker client's folder.
    """
    by_id = {other.id: other for other in others}
    reference = _reference(image, by_id)
    known = succeeds(["docker", "image", "inspect", reference], env=env)
    if not known:
        context, arguments = _context(image, by_id)
        platforms = ",".join(f"linux/{a}" for a in image.architectures)
        command = ["nice", "docker", "buildx", "build", "--builder", "default", "--platform", platforms]
        options = ["--provenance=false", "--progress", "plain", "--tag", reference]
        run([*command, *options, *arguments, context], log=f"image-{image.id}", env=env)
        _forget_older(image, reference, env)
    digest = _digests([reference], env)[reference]
    changed = _tag(image, reference, digest, env) + _publish(image, digest, env)
    state = "built" if not known else "tagged" if changed else "was there"
    return f"{state} for {', '.join(image.architectures)}; {digest[7:19]}"


def stands(identity: str, name: str, env: dict[str, str]) -> bool:
    """Tell whether the engine's image of this real name is the stand-in with this id, made by whatever recipe."""
    listed = ["docker", "image", "ls", "--no-trunc", "--format", "{{.ID}}", f"lab/{identity}"]
    return _digests([name], env).get(name, "") in run(listed, env=env).split()


def _forget_older(image: Image, reference: str, env: dict[str, str]) -> None:
    """Untag what earlier recipes of the same image made, so that a changed recipe does not fill the disk."""
    listed = run(["docker", "image", "ls", "--format", "{{.Repository}}:{{.Tag}}", f"lab/{image.id}"], env=env).split()
    for older in listed:
        if older != reference:
            succeeds(["docker", "rmi", older], env=env)


def _tag(image: Image, reference: str, digest: str, env: dict[str, str]) -> int:
    """Give the image its real names in the engine; return how many were not right already."""
    tagged = _digests(image.names, env)
    stale = [name for name in image.names if tagged.get(name) != digest]
    for name in stale:
        run(["docker", "tag", reference, name], env=env)
    return len(stale)


def _publish(image: Image, digest: str, env: dict[str, str]) -> int:
    """Put the image into the mirror under its real names: one push, the other names by the manifest alone."""
    official = [name for name in image.names if "/" not in name]
    stale = [name for name in official if registry.digest(f"library/{name}", name=registry.MIRROR) != digest]
    pushed: dict[str, str] = {}
    for name in stale:
        repository = f"library/{name.partition(':')[0]}"
        if repository in pushed:
            registry.alias(pushed[repository], name.partition(":")[2], name=registry.MIRROR)
            continue
        target = f"{registry.address(registry.MIRROR)}/library/{name}"
        run(["docker", "tag", name, target], env=env)
        run(["docker", "push", "--quiet", target], env=env, log=f"push-{image.id}")
        run(["docker", "rmi", target], env=env)
        pushed[repository] = f"library/{name}"
    return len(stale)


def _digests(names: Sequence[str], env: dict[str, str]) -> dict[str, str]:
    """Return the digest of each of these names that the engine has."""
    inspect = ["docker", "image", "inspect", "--format", "{{.Id}}"]
    return {name: run([*inspect, name], env=env).strip() for name in names if succeeds([*inspect, name], env=env)}


def _reference(image: Image, by_id: dict[str, Image]) -> str:
    """Return the lab's own name of an image, which changes with everything that goes into it."""
    return f"lab/{image.id}:{_key(image, by_id)}"


def _key(image: Image, by_id: dict[str, Image]) -> str:
    if image.base is not None:
        # An index of packages tells their content; the packages themselves would take seconds to read
        beside = [index if (index := place / packages_folder.INDEX).exists() else place for _, place in image.contexts]
        return recipe(RECIPES / image.recipe, image.args, image.architectures, _key(by_id[image.base], by_id), *beside)
    tars = [rootfs.make(architecture, image.suite).name for architecture in image.architectures]
    return recipe(RECIPES / image.recipe, tars, folder("rootfs", "machine"))


def _context(image: Image, by_id: dict[str, Image]) -> tuple[Path, list[str]]:
    """Return the build context of an image and the arguments that its build takes."""
    arguments = [word for name, value in image.args for word in ("--build-arg", f"{name}={value}")]
    arguments += [word for name, place in image.contexts for word in ("--build-context", f"{name}={place}")]
    if image.base is not None:
        return RECIPES / image.recipe, [*arguments, "--build-arg", f"BASE={_reference(by_id[image.base], by_id)}"]
    context = folder("rootfs", "context")
    shutil.rmtree(context)
    shutil.copytree(RECIPES / image.recipe, context)
    shutil.copytree(folder("rootfs", "machine"), context / "machine")
    for architecture in image.architectures:
        (context / f"{architecture}.tar").hardlink_to(rootfs.make(architecture, image.suite))
    return context, arguments


def several_platforms(env: dict[str, str]) -> bool:
    """Tell whether the engine keeps images of several platforms: only the containerd image store does."""
    return "io.containerd.snapshotter" in run(["docker", "info", "--format", "{{json .DriverStatus}}"], env=env)
