"""The CUDA of the libtorch that a script or a page takes, where there are an archive and an image for it."""

from __future__ import annotations

from roslab.evidence import places
from roslab.evidence.facts import Evidence, Mention
from roslab.evidence.native.torch_on_gpu import TOPIC
from roslab.knowledge.frameworks import cuda_image
from roslab.values.version import Version

CUDNN = "7"
"""CMake stops in libtorch's configuration without one at least as new: https://github.com/pytorch/pytorch/issues/40965."""


def for_libtorch(evidence: Evidence) -> tuple[Mention, str] | None:
    """Return the address with its CUDA; ``None`` where none is taken, or nothing is known that has it.

    Not of a workflow, which is for another machine; nor one without a release, whose archive may not exist.
    """
    said = next(
        (m for m in evidence.mentions if m.topic == TOPIC and m.value and not m.file.endswith(places.OF_CI)), None
    )
    cuda, _, release = said.value.partition(" ") if said else ("", "", "")
    if said is None or not release:
        return None
    from roslab.knowledge.libtorch import libtorch_archive, oldest  # noqa: PLC0415 - few trees need it

    image = cuda_image(cuda)
    archived = Version(release) >= oldest() and "/libtorch/cpu/" not in libtorch_archive(release, cuda)
    return (said, cuda) if archived and image and image.tag else None
