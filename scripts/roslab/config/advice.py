"""Advice on what to write instead of a bad value, for cases in which listing the allowed values is not enough."""

from __future__ import annotations

import re

from roslab.config import vocabulary
from roslab.config.cited import shown
from roslab.knowledge.distros import releases_of
from roslab.values.pattern import pattern

_TREE = pattern(r"(https?://[^/\s]+/[^/\s]+/[^/\s]+?)(?:\.git)?/(?:-/)?(?:tree|blob)/([^/\s]+)(?:/(\S+))?")


def advice(title: str, text: str) -> str | None:
    """Return what to write instead of a value, given the title of its schema; ``None`` if there is no advice."""
    if "\ufffd" in text:
        return "a character is broken: save the file as UTF-8"
    if "\n" in text and title == "shell command":
        return "one line each: join them with ` && `, or write an entry for each"
    if any(not c.isprintable() for c in text):
        return "write one line of plain text, without line breaks, control characters or invisible ones"
    find = _BY_TITLE.get(title)
    return find(text) if find else None


def _name(text: str) -> str | None:
    better = re.sub(r"[^a-z0-9]+", "-", text.lower()).strip("-")[:100]
    return f"only letters, digits and single `.`, `_`, `-` between them: write `{better}`" if better else None


def _git_url(text: str) -> str | None:
    found = _TREE.search(text)
    if found:
        url, ref, path = found.groups()
        where = f"; what you want lies in its folder {shown(path).removesuffix('.git')}" if path else ""
        return (
            "this is a page of the website, which git cannot clone: "
            f"write `repo: {shown(url, 200)}.git` and `ref: {shown(ref)}`{where}"
        )
    if re.match(r"\s*(?:git@|ssh://)", text):
        return (
            "no address of ssh that git takes: write `git@HOST:OWNER/NAME.git` and `secrets: [ssh]`, or the https URL"
        )
    if re.search(r"//[^/\s]*@", text):
        return "take the user and password out: everyone can read roslab.yaml"
    if re.search(r"(?:^|\s)-", text):
        return "of git's options only `-b BRANCH` is read: write the URL alone, and `ref: BRANCH`"
    return None


def _pip(text: str) -> str | None:
    if found := re.fullmatch(r"\s*([\w.-]+)\s*=\s*([\w.]+)\s*", text):
        return f"pip wants two equals signs: write `{found[1]}=={found[2]}`"
    if re.match(r"\s*(?:-r|--requirement)\b", text):
        return "write the file under `requirements:`"
    if re.match(r"\s*(?:\.|/|~)", text):
        return "to install the repository itself write `build: pip`"
    if re.search(r"//[^/\s]*@", text):
        return "take the user and password out: everyone can read roslab.yaml"
    if re.match(r"\s*-", text):
        return "this option is not allowed; -U, --pre, --no-deps, --extra-index-url https://… and a few more are"
    return None


def _apt(text: str) -> str | None:
    if re.match(r"\s*-", text):
        return "options of apt are not allowed: write names of packages only"
    if found := re.search(r"[\w.+-]+==[\w.+:~-]+", text):
        return f"apt wants one equals sign: write `{found[0].replace('==', '=')}`"
    if "," in text:
        return "write each package on a line of its own"
    if re.fullmatch(r"[\w.+-]+", text) and text != (better := text.lower().replace("_", "-")):
        return f"names of apt packages are in lower case, with `-`: write `{better}`"
    return None


def _ubuntu(text: str) -> str | None:
    releases = releases_of().get(text)
    if releases:
        return f"that is a ROS distribution: write `ubuntu: {releases[-1]}` and `ros: {text}`"
    if re.fullmatch(r"\d\d\.(?:04|10)", text):
        return "only long-term releases last: 14.04, 16.04, 18.04, 20.04, 22.04, 24.04, 26.04"
    return None


def _ros(text: str) -> str | None:
    distro, _, variant = text.partition("-")
    allowed = releases_of()
    if distro not in allowed:
        meant = vocabulary.nearest(distro, allowed)
        full = f"{meant}-{variant}" if variant else meant
        return f"did you mean `{full}`? distributions: {', '.join(allowed)}" if meant else None
    variants = ("ros-core", "ros-base", "robot", "perception", "simulators", "simulation", "desktop", "desktop-full")
    meant = next((v for v in reversed(variants) if variant.endswith(v)), vocabulary.nearest(variant, variants))
    return f"did you mean `{distro}-{meant}`? variants: {', '.join(variants)}" if meant else None


def _path(text: str) -> str | None:
    if text.startswith(("/", "~")) or "\\" in text or ".." in text.split("/"):
        return "a path inside the repository, relative to its root, with `/` between its parts"
    return None


def _system(_: str) -> str:
    return "only Ubuntu can still be built: write `system: ubuntu` and its `version`"


def _format(text: str) -> str | None:
    if text in {"1", "2"}:
        return "the old formats have no such line: take it out, or let `roslab migrate` write the file anew"
    return "`format: 3` is the newest that this version of roslab reads"


_BY_TITLE = {
    "image name": _name,
    "git URL that can be cloned": _git_url,
    "pip requirement": _pip,
    "apt package": _apt,
    "Ubuntu release": _ubuntu,
    "ROS distribution": _ros,
    "path inside the repository": _path,
    "format": _format,
    "system": _system,
}
