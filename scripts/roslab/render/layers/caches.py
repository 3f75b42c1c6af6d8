"""Caches that single steps mount: in no layer, kept by the builder, and a build without them gives the same image.

https://docs.docker.com/reference/dockerfile/#run---mounttypecache
"""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.values.secret import NETRC, PIP_INDEX

APT_LISTS = "/var/lib/apt/lists"


def apt_lists(name: str) -> str:
    """Return the mount of apt's lists of packages, of which a later step or build of ``name`` fetches what is new.

    Each platform has its own: the stage, or one that it is based on, declares ``TARGETARCH``. apt lets one process
    alone at its lists: steps of one platform that run at the same time wait for each other.
    """
    return f"--mount=type=cache,id=apt-lists-{name}-${{TARGETARCH}},target={APT_LISTS},sharing=locked"


def pip_downloads(plan: Plan) -> tuple[str, ...]:
    """Return the mount of what pip has downloaded for each platform; none where it keeps nothing.

    Beside an answer pip may keep what it was asked with: nothing is kept of an index that asks for a password.
    """
    if plan.compatible or {NETRC, PIP_INDEX} & set(plan.secrets):
        return ()
    return (f"--mount=type=cache,id=pip-{plan.name}-${{TARGETARCH}},target=/root/.cache/pip,sharing=locked",)


def pip_option(plan: Plan) -> str:
    """Return the option that says where a call of pip keeps what it downloads: in the mount, or nowhere."""
    return '"$(pip-cache)"' if pip_downloads(plan) else "--no-cache-dir"
