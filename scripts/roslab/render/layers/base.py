"""Layer 1: the base, apt sources, locale and the image's user."""

from __future__ import annotations

from roslab.knowledge.distros import distro
from roslab.knowledge.ros_packages import ros_packages
from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import shell

USER = """\
# The image's user has Binder's name and number. Ubuntu 24.04 and newer come with a user of that number: it is renamed.
ARG NB_USER=jovyan
ARG NB_UID=1000
ENV NB_USER=${NB_USER} \\
    NB_UID=${NB_UID}
RUN present="$(getent passwd "${NB_UID}" | cut -d: -f1)" || true; \\
    if [ -z "${present}" ]; then \\
      useradd --create-home --user-group --uid "${NB_UID}" --shell /bin/bash "${NB_USER}"; \\
    elif [ "${present}" != "${NB_USER}" ]; then \\
      usermod --login "${NB_USER}" --home "/home/${NB_USER}" --move-home --shell /bin/bash "${present}"; \\
      groupmod --new-name "${NB_USER}" "$(id --group --name "${NB_UID}")"; \\
    fi; \\
    mkdir --parents /usr/local/share/roslab"""


def base(plan: Plan) -> str:
    """Start from the base image with bash as the shell, a UTF-8 locale and no questions from apt."""
    return "\n".join(
        (
            f"FROM {quote.image(plan.base_image)} AS base",
            'SHELL ["/bin/bash", "-eo", "pipefail", "-c"]',
            "USER root",
            "ARG DEBIAN_FRONTEND=noninteractive",
            "ENV LANG=C.UTF-8 \\\n    LC_ALL=C.UTF-8",
        )
    )


def user(_: Plan) -> str:
    """Make sure that the image's user exists."""
    return USER


def answering_sources(plan: Plan) -> str:
    """Leave out NVIDIA's package source where the base has its old key: CUDA itself is in the base."""
    if not plan.base_image.startswith("nvidia/"):
        return ""
    return f"""\
# NVIDIA changed the key of its package source in 2022: a base that has the old one does without, CUDA is in it
RUN apt-get update >/tmp/update 2>&1 || true; \\
    if grep --quiet 'NO_PUBKEY A4B469963BF863CC' /tmp/update; then \\
      {{ grep -lr developer.download.nvidia.com /etc/apt/sources.list.d || true; }} | xargs --no-run-if-empty rm; \\
      echo "source developer.download.nvidia.com" | tee --append {shell.REPORT}; \\
    fi; \\
    rm -rf /tmp/update /var/lib/apt/lists/*"""


def ros_source(plan: Plan) -> str:
    """Add ROS's own package source to a base that is not an image of ROS, such as NVIDIA's."""
    release = distro(plan.ros_distro)
    if not plan.ros_source or release is None:
        return ""
    source = ros_packages(release)
    keyring = "/usr/share/keyrings/ros-archive-keyring.gpg"
    line = f"deb [signed-by={keyring}] {source.url} {release.ubuntu} main"
    run = shell.run(
        "apt-get update",
        "apt-get install --yes --no-install-recommends ca-certificates curl gnupg",
        f"curl --fail --silent --show-error --location {quote.shell(source.key)} | gpg --dearmor --output {keyring}",
        f"echo {quote.shell(line)} >/etc/apt/sources.list.d/roslab-ros.list",
        "rm -rf /var/lib/apt/lists/*",
        comment="ROS's package source, which this base lacks",
    )
    return f"ENV ROS_DISTRO={quote.docker(release.name)}\n{run}"


def early_repositories(plan: Plan) -> str:
    """Add the extra sources before everything else; an image in an old way adds them where it always did."""
    return "" if plan.compatible else repositories(plan)


def repositories(plan: Plan) -> str:
    """Add the extra apt sources that roslab.yaml names; one that does not answer any more is named and left out."""
    if not plan.repositories:
        return ""
    names = shell.words(plan.repositories)
    return f"""\
# Extra package sources from roslab.yaml; one that does not answer is named and left out
RUN apt-get update; \\
    apt-get install --yes --no-install-recommends ca-certificates gnupg software-properties-common; \\
    for name in{names}; do \\
      if ! {{ add-apt-repository --yes "${{name}}" && apt-get update; }}; then \\
        add-apt-repository --yes --remove "${{name}}" || true; \\
        echo "source ${{name}}" | tee --append {shell.REPORT}; \\
      fi; \\
    done; \\
    rm -rf /var/lib/apt/lists/*"""
