"""The CUDA where nothing names one."""

from __future__ import annotations

from roslab.config.model import Config, Kind
from roslab.decide.cuda.for_extensions import for_extensions
from roslab.decide.cuda.for_ubuntu import with_an_image_for
from roslab.decide.cuda.for_wheels import for_wheels
from roslab.decide.cuda.version import Cuda
from roslab.decide.decision import Choice
from roslab.decide.python.own import OwnPython
from roslab.evidence.facts import Evidence


def where_unnamed(cuda: Choice[Cuda], evidence: Evidence, config: Config, kind: Kind, own: OwnPython) -> Choice[Cuda]:
    """Return the CUDA, also where nothing names one: of a named Ubuntu, of extensions of torch, of its wheel."""
    with_image = with_an_image_for(cuda, evidence, config, kind, own.version)
    return for_wheels(for_extensions(with_image, evidence, config, kind, own), evidence, config, kind, own)
