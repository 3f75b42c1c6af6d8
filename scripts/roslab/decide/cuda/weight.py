"""How much each reason for a version of CUDA counts."""

from __future__ import annotations

from typing import ClassVar


class Weight:
    """How much each reason for a CUDA version counts: builds for one version count more than what runs with several."""

    OWN_IMAGE = 200  # the author's Dockerfile is built as it is
    NEAREST = 101  # the replacement of a version without images
    LOCAL_VERSION = 82  # torch==1.13.1+cu117, plus the trust of the pin
    WHEEL_INDEX = 80  # a requirements file, or a line of a page, names the index of one CUDA's wheels
    CONDA = 75  # cudatoolkit of the environment file at the root
    CONDA_BELOW = 45
    EXTRA = 70  # jax[cuda11], plus the trust of the pin
    AUTHORS_IMAGE = 62
    OTHER_IMAGE = 20  # a Dockerfile for one machine, or one that does not parse
    COPIES = 3  # added for a Dockerfile that copies this source
    RELEASE: ClassVar = {
        "tensorflow": 60,  # it loads the CUDA of the system, so the version must match
        "torch": 46,
        "jax": 40,
    }
    TRUST = 3  # added for each step of the trust of a pin
    SAID: ClassVar = {"readme": 30, "script": 16, "ci": 14, "dockerfile": 12}
    SAID_ELSEWHERE = 8
    NEAR, DEEPER = 6, 2  # added for a mention at the root, minus the second for each folder above it, up to three
    LOCKED = 5  # the wheel of a lock, which nobody wrote by hand
    UNPINNED = 4  # the newest wheel
    AT_LEAST = 3  # a lower bound: what is pinned, or the newest wheel, lies above it
    ASIDE = 3  # a pin of an example, or one deep in the tree
    SOURCES = 2  # CUDA sources, if no version is named
