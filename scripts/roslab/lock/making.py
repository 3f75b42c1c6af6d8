"""From an image that was proved to its lock."""

from __future__ import annotations

from collections.abc import Sequence

from roslab import __version__
from roslab.engine import docker as engine
from roslab.engine import registry
from roslab.engine.docker import output
from roslab.errors import BuildError, Problem
from roslab.lock import online
from roslab.lock.check import GIT
from roslab.lock.inventory import Inventory, inspect
from roslab.lock.steps import placed
from roslab.plan.lock import python_of
from roslab.plan.locked import Environment, Lock, LockedSource, Machine, Material
from roslab.plan.plan import Plan
from roslab.values.dataclass import replace
from roslab.values.image import without_tag

ROSDISTRO = "https://github.com/ros/rosdistro.git"
PYTHONS = {"image": "python3", "jupyter": "/opt/jupyter/bin/python", "python2": "python2"}
"""The interpreter of each environment of an image."""


def make(
    plan: Plan,
    images: Sequence[tuple[str, Inventory]],
    materials: tuple[Material, ...] = (),
    *,
    seconds: float = online.SECONDS,
) -> Lock:
    """Return the lock of the images of one plan, one for each platform, which the engine holds.

    ``materials`` are those of an author's own Dockerfile, whose base is one of them; ``seconds`` is the longest that
    the package sources are asked for each image.

    Raises ``BuildError`` where the base that they were made from is no longer the one of its name.
    """
    base = plan.base_image.partition("@")[0]
    digest = "" if plan.author_dockerfile else base_digest(plan.base_image, images)
    machines = tuple(_machine(plan, platform, image, seconds) for platform, image in images)
    return Lock(
        base=base,
        digest=digest,
        python=python_of(plan),
        rosdistro=_rosdistro(plan),
        tools=_tools(),
        sources=_sources(plan, images),
        machines=machines,
        materials=materials,
    )


def _machine(plan: Plan, platform: str, image: Inventory, seconds: float) -> Machine:
    options = [word for option in (*plan.python.options, *plan.python.pip_options) for word in option.split()]
    origins = online.ask(image, platform, pythons=PYTHONS, options=options, seconds=seconds)
    packages = tuple(
        replace(package, origin=origins.apt.get((package.name, package.version), "")) for package in image.apt
    )
    environments = []
    for name in PYTHONS:
        found = tuple(
            replace(package, hashes=package.hashes or origins.hashes.get((name, package.name), ()))
            for package in sorted((i.package for i in image.python if i.environment == name), key=lambda p: p.name)
        )
        if found:
            environments.append(Environment(name=name, packages=found))
    return Machine(
        platform=platform,
        apt=placed(plan, packages, image.history),
        python=tuple(environments),
        conda=image.conda,
    )


def base_digest(base: str, images: Sequence[tuple[str, Inventory]]) -> str:
    """Return the digest of the base that the images were made from.

    A tag moves: its image counts only if its layers are the images' first. Raises ``BuildError`` if it is another.
    """
    name, _, digest = base.partition("@")
    if digest:
        return digest
    for found, layers in _bases(name, images):
        known = [(layers[platform], image) for platform, image in images if platform in layers]
        if known and all(image.layers[: len(of_base)] == of_base for of_base, image in known):
            return found
    message = f"{name} is another image now than the one that this was built from"
    raise BuildError(Problem(message=message, hint="build again with `roslab build --no-cache`, then lock"))


def _bases(name: str, images: Sequence[tuple[str, Inventory]]) -> list[tuple[str, dict[str, tuple[str, ...]]]]:
    """Return the digests by which a base is known, each with its layers by platform: the engine's, the registry's."""
    found = []
    try:
        about = inspect(name)
        layers = tuple(about.get("RootFS", {}).get("Layers") or ())
        own = f"{about.get('Os')}/{about.get('Architecture')}"
        known = {platform: layers for platform, _ in images if platform == own}
        digests = [str(each).partition("@")[2] for each in about.get("RepoDigests") or ()]
        found += [(digest, known) for digest in dict.fromkeys(digests) if known]
    except BuildError:
        pass  # BuildKit keeps what it pulled to itself
    try:
        digest = registry.digest_of(name)
        repository = without_tag(name)
        configurations = registry.configurations(repository, digest)
        layers_of = {
            platform: tuple(entry.get("rootfs", {}).get("diff_ids") or ()) for platform, entry in configurations.items()
        }
        found.append((digest, layers_of))
    except BuildError as error:
        if not found:
            raise BuildError(
                Problem(message=f"the digest of the base {name} is not known: {error.problems[0].message}")
            ) from None
    return found


def _rosdistro(plan: Plan) -> str | None:
    if plan.rosdep is None:
        return None
    if plan.rosdep.rosdistro_tag:
        return plan.rosdep.rosdistro_tag
    answer = output([*GIT, "ls-remote", ROSDISTRO, "HEAD"])
    return answer.stdout.split()[0] if answer.returncode == 0 and answer.stdout.split() else None


def _sources(plan: Plan, images: Sequence[tuple[str, Inventory]]) -> tuple[LockedSource, ...]:
    """Return the commits of what was cloned; of a library whose stage is gone, the one that its ref names."""
    found = {(s.name, s.url): s for _, image in images for s in image.sources}
    for library in plan.libraries:
        url = library.repo or ""
        if url and (library.name, url) not in found and (commit := _commit(url, library.ref)):
            found[library.name, url] = LockedSource(name=library.name, url=url, commit=commit)
    return tuple(sorted(found.values(), key=lambda source: (source.name, source.url)))


def _commit(url: str, ref: str | None) -> str | None:
    if ref and len(ref) == 40 and set(ref) <= set("0123456789abcdef"):
        return ref
    answer = output([*GIT, "ls-remote", "--", url, ref or "HEAD", f"{ref}^{{}}"])
    lines = sorted(answer.stdout.splitlines(), key=lambda line: not line.endswith("^{}"))
    return lines[0].split()[0] if lines else None  # a tag that is an object of its own names its commit in a line more


def _tools() -> tuple[tuple[str, str], ...]:
    answer = output(["docker", "buildx", "version"])
    buildx = answer.stdout.split()[1] if len(answer.stdout.split()) > 1 else ""
    return (("roslab", __version__), ("docker", engine.check()), ("buildx", buildx))
