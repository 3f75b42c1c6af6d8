"""The distribution that belongs to an Ubuntu which the author names."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.decide.decision import Reason
from roslab.decide.reasons import because
from roslab.decide.ros.distro_weights import Weight
from roslab.evidence.facts import AuthorDockerfile, Evidence, Mention
from roslab.knowledge.distros import distros_of, ubuntus


def of_ubuntu(mention: Mention, evidence: Evidence, ros: int) -> Iterator[Reason]:
    """Yield the distribution that belongs to a mentioned Ubuntu."""
    codename = ubuntus().get(mention.value, mention.value)
    if codename == mention.value and mention.source == "readme" and "ubuntu" not in mention.text.lower():
        return  # "bionic" and "focal" are also ordinary words
    weight = weight_of_ubuntu(mention, evidence)
    for name in distros_of(codename, 1 if ros == 1 else 2)[:1]:
        yield because("ros_distro", name, f"Ubuntu {mention.value}: {mention.text[:120]}", mention, weight=weight)


def weight_of_ubuntu(mention: Mention, evidence: Evidence) -> int:
    """Return how much an Ubuntu counts; the date of the last commit tells more than an image for something else."""
    if any(each.file == mention.file and _for_something_else(each) for each in evidence.dockerfiles):
        return Weight.EXAMPLE
    return Weight.UBUNTU[mention.source] - Weight.DEEPER * mention.file.count("/")


def _for_something_else(authored: AuthorDockerfile) -> bool:
    """Tell whether a Dockerfile has neither ROS nor this code: it is for training, or for another program."""
    return authored.ros == "none" and not authored.copies_repository
