"""Layer 1: the base, apt sources, locale and the image's user."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import secrets, shell

START = f"""\
SHELL ["/bin/bash", "-eo", "pipefail", "-c"]
USER root
ARG DEBIAN_FRONTEND=noninteractive
# The image's user, by Binder's names
ARG NB_USER=jovyan
ARG NB_UID=1000
ENV LANG=C.UTF-8 LC_ALL=C.UTF-8 NB_USER=${{NB_USER}} NB_UID=${{NB_UID}}
{shell.copy_script("create-user")}RUN create-user"""

WHY = {
    False: "ROS's package source",
    True: "Package sources that answer: this base's release has ended, or its keys may be old",
}
"""The comment above the step, by whether the base has ended."""


def start(_: Plan) -> str:
    """Start with bash as the shell, no questions from apt, a UTF-8 locale and the image's user."""
    return START


def package_sources(plan: Plan) -> str:
    """Make the base's package sources answer, and add ROS's own to a base that is no image of ROS, such as NVIDIA's."""
    found = plan.package_sources
    if found is None:
        return ""
    options, before, ros = "", "", found.ros
    if ros:
        options = f" --ros {quote.shell(ros.url)} {quote.shell(ros.ubuntu)} {quote.shell(ros.key)}"
        options += "" if ros.in_base else " --add"
        before = shell.copy_key(ros.key)
    options += " --ended" if found.ended else ""
    given = secrets.for_apt(plan)
    called = shell.call("renew-package-sources", options, comment=WHY[found.ended], before=before, secrets=given)
    return called if ros is None or ros.in_base else f"ENV ROS_DISTRO={quote.docker(ros.distro)}\n{called}"


def repositories(plan: Plan) -> str:
    """Add the extra apt sources that roslab.yaml names; one that does not answer any more is named and left out."""
    if not plan.repositories:
        return ""
    names = shell.words(plan.repositories)
    comment = "Package sources of roslab.yaml"
    return shell.call("add-package-sources", names, comment=comment, secrets=secrets.for_apt(plan))
