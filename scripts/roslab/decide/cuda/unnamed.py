"""The CUDA of what nobody names one for, one way after the other."""

from __future__ import annotations

from roslab.config.model import Config, Kind
from roslab.decide.cuda.for_distro import with_an_image_for_distro
from roslab.decide.cuda.for_extensions import for_extensions
from roslab.decide.cuda.for_packages import for_packages
from roslab.decide.cuda.for_ubuntu import with_an_image_for
from roslab.decide.cuda.for_wheels import for_wheels
from roslab.decide.cuda.version import Cuda
from roslab.decide.decision import Choice
from roslab.decide.python.own import OwnPython
from roslab.evidence.facts import Evidence
from roslab.knowledge.distros import Distro


def where_unnamed(  # noqa: PLR0917 - the order in which the questions are answered
    cuda: Choice[Cuda], evidence: Evidence, config: Config, kind: Kind, own: OwnPython, ros: Distro | None
) -> Choice[Cuda]:
    """Return the CUDA, also where nothing names one: of a named Ubuntu, of extensions of torch, of its wheel.

    For packages of ROS it is one that Ubuntu's toolkit does not have, and that has an image for their Ubuntu.
    """
    with_image = with_an_image_for(cuda, evidence, config, kind, own.version)
    of_wheels = for_wheels(for_extensions(with_image, evidence, config, kind, own), evidence, config, kind, own)
    return with_an_image_for_distro(for_packages(of_wheels, evidence, config, ros), evidence, config, ros)
