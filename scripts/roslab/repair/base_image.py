"""The tag of an image that fits what a failed step asks for."""

from __future__ import annotations

from roslab.explain.answer import Explanation
from roslab.explain.signatures import filled
from roslab.knowledge.distros import ubuntus
from roslab.knowledge.repairs import complete, repairs
from roslab.knowledge.table import rows
from roslab.repair.ways import required
from roslab.values.pattern import pattern
from roslab.values.specifier import admits, specifiers

_TAG = pattern(r"^(?P<version>\d{1,3}(?:\.\d{1,3}){0,2}|latest)?(?P<variant>(?:-(?:slim|alpine|fpm|cli|apache))*)")
_LIMIT = pattern(r"(?P<sign>[<>=!]=|~>|[<>^~=])?\s{0,3}v?(?P<version>\d{1,3}(?:\.\d{1,4}){0,3})(?:\.[x*])?")
_NEWER = "newer"
"""The next version after that of the image; there is none for an image without a number."""
_DEVEL = "devel"
"""The same version with its compiler, for images that have both."""
_ANY_PROCESSOR = "any-processor"
"""The image that has the same tag for several processors, of one for a single processor: `arm32v7/ubuntu`."""
_WITHOUT_COMPILER = pattern(r"-(?:base|runtime)(?=-|$)")
_BELOW = ("<", "<=", "!=")


def fitting(found: Explanation, image: str) -> str:
    """Return the reference that repairs a failure in place of ``image``, ``""`` if none does.

    The variant (``-slim``, ``-alpine``) stays; a release of Debian or Alpine in the tag does not, as newer versions are
    not made for older ones.
    """
    known = repairs().get(found.id or "")
    name, _, tag = image.partition(":")
    names = dict(found.names)
    names |= {"required": required(names, found.log)}
    if known is not None and known.tag == _ANY_PROCESSOR:
        owner, _, plain = image.partition("/")
        return plain if owner in known.image.split() else ""
    if known is None or name not in known.image.split() or not complete(known.tag, names):
        return ""
    if known.tag == _DEVEL:
        other = _WITHOUT_COMPILER.sub("-devel", tag)
        return f"{name}:{other}" if other != tag else ""
    said = _TAG.match(tag)
    now, variant = ((said["version"] or ""), said["variant"]) if said else ("", "")
    now = now or next((version for version, codename in ubuntus().items() if codename == tag), "")
    needs = f">{now}" if known.tag == _NEWER and now else filled(known.tag, names)
    version = _version(name, needs, now)
    return f"{name}:{version}{variant}" if version else ""


def _version(name: str, needs: str, now: str) -> str:
    """Return the version of an image that the first of several alternatives admits, ``""`` if ``now`` is one.

    It is the oldest from the lower limit on; where there are only upper limits, the newest below them. A release that
    is too old within a series that is admitted gives the series.
    """
    row = next((row for row in rows("language_images") if row["image"] == name), None)
    limits = [(found["sign"] or "", found["version"]) for found in _LIMIT.finditer(needs.partition("||")[0])]
    if row is None or not limits:
        return ""
    if name == "ruby" and not limits[0][0] and limits[0][1].count(".") == 2:
        return limits[0][1]  # a Gemfile that names one release takes no other
    allowed = specifiers(",".join(_pep440(sign, version) for sign, version in limits))
    admitted = [each for each in row["versions"].split() if allowed is not None and admits(allowed, each)]
    series = next((each for each in admitted if f"{now}.".startswith(f"{each}.")), "")
    if series:
        return series if allowed is not None and not allowed.contains(now) else ""  # the newest of the same series
    only_above = all(sign in _BELOW for sign, _ in limits)
    return next(iter(reversed(admitted) if only_above else admitted), "")


def _pep440(sign: str, version: str) -> str:
    """Return one limit of npm, RubyGems, Go or Cargo as Python's packaging writes it; a bare version is a lower one."""
    if sign in ("=", "=="):
        return f"=={version}.*"
    if sign == "~>":
        return f"~={version}" if "." in version else f">={version}"
    return f"{sign if sign in (*_BELOW, '>') else '>='}{version}"
