"""The build tree that travels: into the builder's cache mount before a build, and beside the layers after its proof.

A runner of GitHub's starts without cache mounts. Nothing here decides what an image holds: without a tree, everything
is compiled, with the same result. So nothing here fails a run.
"""

from __future__ import annotations

import hashlib
import tempfile
import uuid
from collections.abc import Sequence
from pathlib import Path

from roslab.engine import docker, registry
from roslab.errors import BuildError
from roslab.github import workflow
from roslab.plan.plan import Plan
from roslab.render import tree as dockerfiles
from roslab.render.dockerfile import dockerfile
from roslab.repository import git as commits
from roslab.values.dataclass import dataclass

LARGEST = 2_000_000_000
"""Most bytes of a tree that is kept. To fetch more takes a runner about as long as to compile it."""
SOURCE = "org.roslab.tree.source"
"""Annotation of a kept tree: what it was compiled of."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Carrier:
    """The builds that move the tree of a plan, in the namespace of cache mounts that the image's build has."""

    plan: Plan
    folder: Path
    """Of the generated Dockerfile; another is written beside it."""
    platforms: tuple[str, ...]
    mounts: str
    source: str = ""
    """Of what the tree is compiled, ``""`` if that is not known."""

    @property
    def carries(self) -> bool:
        """Whether there is a tree at all."""
        return dockerfiles.carries(self.plan)

    def build(self, target: str, output: str, contexts: tuple[tuple[str, str], ...] = ()) -> None:
        """Build one of the stages. Raises ``FailedBuild``."""
        file = self.folder / dockerfiles.FILE
        file.write_text(dockerfiles.tree(self.plan), encoding="utf-8")
        with tempfile.TemporaryDirectory() as nothing:
            job = docker.Build(
                context=Path(nothing),
                dockerfile=file,
                platforms=self.platforms,
                arguments=(("BUILDKIT_CACHE_MOUNT_NS", self.mounts), (dockerfiles.ONCE, uuid.uuid4().hex)),
                contexts=contexts,
                target=target,
                output=output,
                extra=("--provenance=false",),
            )
            docker.build(job)


def source_of(plan: Plan, root: Path) -> str:
    """Return a text that is another whenever the compilation has to be repeated, ``""`` where git tells nothing.

    While it is the same, the layers that are kept beside the tree are enough, and nobody has to fetch the tree.
    """
    if not dockerfiles.carries(plan) or not (entries := commits.entries(root)):
        return ""
    read = sorted((name, what) for name, what in entries.items() if name not in plan.workspace.unread)
    return hashlib.sha256(repr((dockerfile(plan), read)).encode()).hexdigest()


def take(carrier: Carrier, references: Sequence[str]) -> None:
    """Fill the mount from the first of these images that exists, if it has no tree yet."""
    if not references or not carrier.carries:
        return
    with workflow.group("Take the build tree of the last build"):
        any(_taken(carrier, reference) for reference in references)


def _taken(carrier: Carrier, reference: str) -> bool:
    try:
        image = f"{reference.rpartition(':')[0]}@{registry.digest_of(reference, attempts=1)}"
        if _is_of(carrier, image):
            workflow.say(f"nothing is to be compiled that is not in {image}")
            return True
        carrier.build(dockerfiles.TAKEN, "type=cacheonly", ((dockerfiles.BEFORE, f"docker-image://{image}"),))
    except BuildError as error:
        workflow.say(f"no build tree from {reference}: {error.problems[0].message}")
        return False
    workflow.say(f"build tree from {image}")
    return True


def keep(carrier: Carrier, reference: str) -> None:
    """Write the mount's tree to an image, unless it is the one that was taken or too large; ``""`` is no image."""
    if not reference or not carrier.carries:
        return
    with workflow.group("Keep the build tree for the next build"):
        try:
            sizes = () if _is_kept(carrier, reference) else _sizes(carrier)
            if not sizes:
                workflow.say("the build tree is the one that is kept already")
            elif max(sizes) > LARGEST:
                workflow.say(f"the build tree of {max(sizes)} bytes is not kept: {LARGEST} are the most")
            else:
                kind = "annotation" if len(carrier.platforms) == 1 else "annotation-index"
                named = f",{kind}.{SOURCE}={carrier.source}" if carrier.source else ""
                # Docker's own media types know neither zstd nor annotations
                form = "push=true,oci-mediatypes=true,compression=zstd"
                carrier.build(dockerfiles.PACKED, f"type=image,name={reference},{form}{named}")
        except BuildError as error:
            workflow.say(f"the build tree is not kept: {error.problems[0].message}")


def _is_of(carrier: Carrier, image: str) -> bool:
    return bool(carrier.source) and registry.annotations_of(image).get(SOURCE) == carrier.source


def _is_kept(carrier: Carrier, reference: str) -> bool:
    try:
        return _is_of(carrier, reference)
    except BuildError:
        return False


def _sizes(carrier: Carrier) -> tuple[int, ...]:
    """Return the bytes of each platform's tree that is not kept yet. Raises ``FailedBuild``."""
    with tempfile.TemporaryDirectory() as folder:
        carrier.build(dockerfiles.SIZE, f"type=local,dest={folder}")
        found = [file.read_text(encoding="utf-8").strip() for file in Path(folder).rglob("size")]
    return tuple(int(text) for text in found if text.isdigit())
