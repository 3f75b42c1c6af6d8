"""Layer 1: the base, apt sources, locale and the image's user."""

from __future__ import annotations

from roslab.plan import Plan
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


def repositories(plan: Plan) -> str:
    """Add the extra apt sources that roslab.yaml names."""
    if not plan.repositories:
        return ""
    return shell.run(
        "apt-get update",
        "apt-get install --yes --no-install-recommends ca-certificates gnupg software-properties-common",
        *(f"add-apt-repository --yes {quote.shell(name)}" for name in plan.repositories),
        "rm -rf /var/lib/apt/lists/*",
        comment="Extra package sources from roslab.yaml",
    )
