"""Layer 1: the base, apt sources, locale and the image's user."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.knowledge.apt_sources import folder_of_source
from roslab.knowledge.distros import python_of_ubuntu
from roslab.plan.package_sources import PackageSources, RosSource
from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import locks, secrets, shell
from roslab.values.secret import APT_AUTH, SSH

START = f"""\
SHELL ["/bin/bash", "-eo", "pipefail", "-c"]
USER root
ARG DEBIAN_FRONTEND=noninteractive
ARG TARGETARCH
# The image's user, by Binder's names
ARG NB_USER=jovyan
ARG NB_UID=1000
ENV LANG=C.UTF-8 LC_ALL=C.UTF-8 NB_USER=${{NB_USER}} NB_UID=${{NB_UID}}
{shell.copy_script("create-user")}{shell.copy_data(("git-hosts.txt",))}"""


def start(plan: Plan) -> str:
    """Start with bash as the shell, no questions from apt, a UTF-8 locale and the image's user.

    Where package sources are renewed, that step makes the user: each step costs a container and a layer. Not where it
    has a secret, which is nobody else's.
    """
    return START.rstrip("\n") if _together(plan) else f"{START}RUN {_user(plan)}"


def package_sources(plan: Plan) -> str:
    """Make the base's package sources answer, and add ROS's own to a base that is no image of ROS, such as NVIDIA's."""
    found = plan.package_sources
    if found is None:
        return ""
    called = renewal(found, secrets.for_apt(plan), before=(_user(plan),) if _together(plan) else ())
    ros = found.ros
    return called if ros is None or ros.in_base else f"ENV ROS_DISTRO={quote.docker(ros.distro)}\n{called}"


def snapshots(plan: Plan) -> str:
    """Take packages as they were on the plan's day, those of the base too."""
    if plan.as_of is None:
        return ""
    words = "".join(f" {quote.shell(word)}" for pair in plan.as_of.archives for word in pair)
    comment = f"Packages as of {plan.as_of.day}, the base's too"
    return shell.call("take-snapshots", f" {plan.as_of.day}{words}", comment=comment, secrets=secrets.for_apt(plan))


def _together(plan: Plan) -> bool:
    return plan.package_sources is not None and APT_AUTH not in plan.secrets


def _user(plan: Plan) -> str:
    return "create-user --ssh" if SSH in plan.secrets else "create-user"


def renewal(found: PackageSources, given: secrets.Secrets = secrets.NONE, *, before: tuple[str, ...] = ()) -> str:
    """Return the step that makes the package sources of a base answer, today or once it has ended.

    ``before``: commands of the same step, ahead of it.
    """
    why = "ROS's package source" if found.ros else "Package sources"
    if found.ended:
        why = "Package sources that answer: this base's release has ended, or its keys may be old"
    elif found.end:
        why += f"{', and' if found.ros else ':'} what to do once this base has ended, on {found.end.day}"
    options = _options(found.ros, ended=found.ended)
    data = [f"{found.ros.key}.asc"] if found.ros else []
    if found.end:
        options += f" --after {found.end.day}{_options(found.end.ros, ended=True)}"
        data += [f"{found.end.ros.key}.asc"] if found.end.ros else []
    data += ["archives.txt"] if found.ended or found.end else []
    copied = shell.copy_data(dict.fromkeys(data))
    around = shell.Around(first=before)
    return shell.call("renew-package-sources", options, comment=why, before=copied, secrets=given, around=around)


def _options(ros: RosSource | None, *, ended: bool) -> str:
    named = ""
    if ros:
        named = f" --ros {quote.shell(ros.url)} {quote.shell(ros.ubuntu)} {quote.shell(ros.key)}"
        named += f" --or {quote.shell(ros.otherwise)}" if ros.otherwise else ""
        named += "" if ros.in_base else " --add"
    return named + (" --ended" if ended else "")


def repositories(plan: Plan) -> str:
    """Add the extra apt sources of roslab.yaml or a page; one that does not answer any more is named and left out."""
    if not plan.repositories:
        return ""
    names = shell.words(plan.repositories)
    comment = "Package sources of roslab.yaml, or of the page that installs from them"
    given, around = secrets.for_apt(plan), locks.apt(plan, "repositories")
    called = shell.call("add-package-sources", names, comment=comment, secrets=given, around=around)
    return "\n".join((called, *_where_packages_lie(plan)))


def python_folders(plan: Plan) -> tuple[str, ...]:
    """Return the folders of Python modules that packages of added sources have, where these do not lie in Ubuntu's.

    They are compiled for Ubuntu's own Python: where the image has another one, it does not see them.
    """
    python = python_of_ubuntu().get(plan.ubuntu or "")
    if plan.python.version not in {None, python}:
        return ()
    return tuple(f"{each}/lib/python{python}/site-packages" for each in _folders(plan) if python)


def _where_packages_lie(plan: Plan) -> Iterator[str]:
    """Yield the variables by which programs, CMake, pkg-config, the linker and Python find what lies elsewhere."""
    for folder in _folders(plan):
        values = {
            "PATH": f"{folder}/sbin:{folder}/bin:${{PATH}}",
            "CMAKE_PREFIX_PATH": f"{folder}${{CMAKE_PREFIX_PATH:+:${{CMAKE_PREFIX_PATH}}}}",
            "PKG_CONFIG_PATH": f"{folder}/lib/pkgconfig${{PKG_CONFIG_PATH:+:${{PKG_CONFIG_PATH}}}}",
            "LD_LIBRARY_PATH": f"{folder}/lib${{LD_LIBRARY_PATH:+:${{LD_LIBRARY_PATH}}}}",
        }
        if python := ":".join(python_folders(plan)):
            values["PYTHONPATH"] = python
        yield "ENV " + " \\\n    ".join(f"{name}={value}" for name, value in values.items())


def _folders(plan: Plan) -> tuple[str, ...]:
    return tuple(dict.fromkeys(filter(None, map(folder_of_source, plan.repositories))))
