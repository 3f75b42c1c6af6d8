"""Instructions that install with apt, for images whose programs come from elsewhere."""

from __future__ import annotations

from roslab.knowledge.table import rows
from roslab.values.pattern import pattern

_INSTALL = pattern(r"RUN apt-get update && apt-get install -y (?:--no-install-recommends )?(?P<packages>[\w.+ -]+)")
_APT = pattern(r"\bapt(?:-get|-key)?\b")
_ALPINE = pattern(r"\balpine\b|\bapk (?:-\S+ )*add\b")
_OTHERS = pattern(
    r"^FROM \S*(?:fedora|centos|rockylinux|almalinux|amazonlinux|oraclelinux|\bubi\d|opensuse|archlinux)"
    r"|\b(?:yum|dnf|microdnf|zypper) (?:-\S+ )*install\b|\bpacman -S"
)
"""Images without apt; `multiarch/ubuntu-core` or an image of somebody's own tells nothing."""


def for_base(lines: list[str], base: str, command: str) -> list[str]:
    """Return the instructions as the base image takes them; none that it cannot run.

    On Alpine, apk installs the packages where a table has all their names there.
    """
    text = f"{base}\n{command}"
    if _ALPINE.search(text):
        return [line for each in lines if (line := _with_apk(each))]
    if _OTHERS.search(text):
        return [line for line in lines if not _APT.search(line)]
    return lines


def _with_apk(line: str) -> str:
    if not _APT.search(line):
        return line
    found = _INSTALL.fullmatch(line)
    known = {row["apt"]: row["apk"] for row in rows("apk_packages")}
    packages = found["packages"].split() if found else []
    if not packages or not known.keys() >= set(packages):
        return ""
    return f"RUN apk add --no-cache {' '.join(dict.fromkeys(' '.join(known[each] for each in packages).split()))}"
