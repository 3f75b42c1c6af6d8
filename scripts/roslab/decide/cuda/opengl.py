"""NVIDIA's images of CUDA with OpenGL, which authors start from for OpenGL alone."""

from __future__ import annotations

from roslab.decide.cuda.signs import includes_tensorrt, sign_of_cuda
from roslab.evidence.facts import AuthorDockerfile, Evidence
from roslab.values.pattern import pattern

_IMAGE = pattern(r"(?:^|/)cudagl:(?![\w.-]*devel)")


def for_opengl(evidence: Evidence, authored: AuthorDockerfile) -> bool:
    """Tell whether a Dockerfile starts from such an image without a compiler, and nothing of the tree is for CUDA.

    https://gitlab.com/nvidia/container-images/cudagl
    """
    if authored.purpose != "project" or not _IMAGE.search(authored.base or ""):
        return False
    said = any(each.topic == "cuda" and each.source != "dockerfile" for each in evidence.mentions)
    return not (said or sign_of_cuda(evidence) or includes_tensorrt(evidence))


def draws(evidence: Evidence) -> bool:
    """Tell whether a Dockerfile of the project shows that its programs draw on a GPU, and do not compute there."""
    return any(for_opengl(evidence, authored) for authored in evidence.dockerfiles)
