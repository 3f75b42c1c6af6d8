"""Layer 1: the base, apt sources, locale and the image's user."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import shell

START = f"""\
SHELL ["/bin/bash", "-eo", "pipefail", "-c"]
USER root
ARG DEBIAN_FRONTEND=noninteractive
# The image's user, by Binder's names
ARG NB_USER=jovyan
ARG NB_UID=1000
ENV LANG=C.UTF-8 LC_ALL=C.UTF-8 NB_USER=${{NB_USER}} NB_UID=${{NB_UID}}
{shell.copy_script("create-user")}RUN create-user"""


def start(_: Plan) -> str:
    """Start with bash as the shell, no questions from apt, a UTF-8 locale and the image's user."""
    return START


def answering_sources(plan: Plan) -> str:
    """Leave out NVIDIA's package source where the base has its old key: CUDA itself is in the base."""
    if not plan.nvidia_source:
        return ""
    return shell.call("remove-unsigned-cuda-source", comment="Older images of CUDA know only NVIDIA's old key")


def ros_source(plan: Plan) -> str:
    """Add ROS's own package source to a base that is not an image of ROS, such as NVIDIA's."""
    source = plan.ros_source
    if source is None:
        return ""
    keyring = "/usr/share/keyrings/ros-archive-keyring.gpg"
    line = f"deb [signed-by={keyring}] {source.url} {source.ubuntu} main"
    run = shell.run(
        "apt-get update",
        "apt-get install --yes --no-install-recommends ca-certificates curl gnupg",
        f"curl --fail --silent --show-error --location {quote.shell(source.key)} | gpg --dearmor --output {keyring}",
        f"echo {quote.shell(line)} >/etc/apt/sources.list.d/roslab-ros.list",
        "rm -rf /var/lib/apt/lists/*",
        comment="ROS's package source, which this base lacks",
    )
    return f"ENV ROS_DISTRO={quote.docker(source.distro)}\n{run}"


def repositories(plan: Plan) -> str:
    """Add the extra apt sources that roslab.yaml names; one that does not answer any more is named and left out."""
    if not plan.repositories:
        return ""
    return shell.call("add-package-sources", shell.words(plan.repositories), comment="Package sources of roslab.yaml")
