"""What single steps mount: secrets, in no layer, without which a step stops, and the caches that go with them.

What a mount does: https://docs.docker.com/reference/dockerfile/#run---mounttypesecret
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Literal

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import caches
from roslab.values.dataclass import dataclass
from roslab.values.secret import APT_AUTH, NETRC, PIP_INDEX, SSH

User = Literal["root", "user"]
"""Whose home folder and whose rights the step has."""
HOMES: dict[str, str] = {"root": "/root", "user": f"/home/{quote.USER}"}
APT_FILE = "/etc/apt/auth.conf.d/roslab.conf"
AGAIN = "ask-pip-again"
"""The script that calls pip again where it failed for something that can be done about."""
FOLDER = "/run/secrets"
"""Where BuildKit mounts a secret if nothing else is said."""
GIT_SSH = "ssh -o BatchMode=yes -o StrictHostKeyChecking=accept-new -o UserKnownHostsFile=/dev/null"
"""An image that is built knows no host yet: the key that a host shows is believed, as by a fresh checkout."""


REPEATABLE = "export SOURCE_DATE_EPOCH=315532800 PYTHONHASHSEED=0"
"""Python then compiles modules to files that hold no time, and that are the same each time. 1980 is a zip's first year.

https://peps.python.org/pep-0552/
"""


@dataclass(frozen=True, kw_only=True, slots=True)
class Secrets:
    """What one step mounts, and the commands that tell its programs where to look."""

    mounts: tuple[str, ...] = ()
    commands: tuple[str, ...] = ()


NONE = Secrets()


def for_pip(plan: Plan) -> Secrets:
    """Return what pip needs: what it downloaded before, the private index, and logins for packages from git."""
    return _of(plan, (PIP_INDEX, NETRC, SSH), "root", first=before_pip(plan), mounted=caches.pip_downloads(plan))


def for_tries_of_pip(plan: Plan) -> Secrets:
    """Return what a script needs that calls pip for each package, so that a failure stops nothing."""
    first = (REPEATABLE, *(of_pip_day(plan) or as_of(plan)))
    return _of(plan, (PIP_INDEX, NETRC, SSH), "root", first=first, mounted=caches.pip_downloads(plan))


def for_conda(plan: Plan, *, pip: bool) -> Secrets:
    """Return what a conda environment needs, and what it has ``pip`` install.

    pip's day is not among it: the environment's Python serves the index, once it is there.
    """
    return _of(
        plan, (PIP_INDEX, NETRC, SSH), "root", first=(REPEATABLE,), mounted=caches.pip_downloads(plan) if pip else ()
    )


def for_git(plan: Plan, user: User = "root") -> Secrets:
    """Return what a clone or a download needs."""
    return _of(plan, (NETRC, SSH), user)


def for_apt(plan: Plan) -> Secrets:
    """Return what apt needs: its lists, and the password of a package source."""
    return _of(plan, (APT_AUTH,), "root", mounted=(caches.apt_lists(plan.name),))


def of_apt_sources(plan: Plan) -> Secrets:
    """Return the password of a package source alone: what is only asked leaves nothing among apt's lists."""
    return _of(plan, (APT_AUTH,), "root")


def for_both(plan: Plan) -> Secrets:
    """Return what rosdep needs, which calls apt and, for some keys, pip."""
    lists = caches.apt_lists(plan.name)
    wanted = (APT_AUTH, PIP_INDEX, NETRC, SSH)
    by_pip = plan.rosdep is not None and plan.rosdep.pip
    first = (REPEATABLE, *((of_pip_day(plan) if by_pip else ()) or as_of(plan)))
    return _of(plan, wanted, "root", first=first, mounted=(lists,))


def before_pip(plan: Plan) -> tuple[str, ...]:
    """Return the commands before those of pip: they write the same bytes again, of the plan's day if it has one."""
    return (REPEATABLE, *helped(plan))


def helped(plan: Plan) -> tuple[str, ...]:
    """Return the command that gives pip the index of a day or, unless all is of one, calls it again where it fails."""
    return of_pip_day(plan) or as_of(plan) or (f"source {AGAIN}",)


def of_pip_day(plan: Plan) -> tuple[str, ...]:
    """Return the command that gives pip the index of its own day as far as there is one, none without such a day."""
    return (f'eval "$(index-as-of {plan.python.day} --or-today)"',) if plan.python.day else ()


def as_of(plan: Plan) -> tuple[str, ...]:
    """Return the command that gives pip the index of the whole image's day, none without a day."""
    return (f'eval "$(index-as-of {plan.as_of.day})"',) if plan.as_of else ()


def everything(plan: Plan, *, home: User, user: User) -> Secrets:
    """Return all of them, for the author's own commands; those without a meaning of their own are files."""
    return _of(plan, plan.secrets, user, home=home)


def _of(
    plan: Plan,
    wanted: Iterable[str],
    user: User,
    *,
    home: User | None = None,
    first: tuple[str, ...] = (),
    mounted: tuple[str, ...] = (),
) -> Secrets:
    names = [name for name in wanted if name in plan.secrets]
    readable = ",mode=0444" if user == "user" else ""
    mounts = list(mounted)
    commands = list(first)
    for name in names:
        if name == SSH:
            mounts.append("--mount=type=ssh,required=true" + (",mode=0666" if readable else ""))
            commands.append(f"export GIT_SSH_COMMAND={quote.shell(GIT_SSH)}")
            continue
        target = {NETRC: f",target={HOMES[home or user]}/.netrc", APT_AUTH: f",target={APT_FILE}"}.get(name, "")
        mounts.append(f"--mount=type=secret,id={name},required=true{target}{readable}")
        if name == PIP_INDEX:
            commands += [f'PIP_EXTRA_INDEX_URL="$(cat {FOLDER}/{name})"', "export PIP_EXTRA_INDEX_URL"]
    return Secrets(mounts=tuple(mounts), commands=tuple(commands))
