r"""What repairs a known failure, in roslab.yaml and in an author's own Dockerfile: ``repairs.toml``.

A repair is one table with the id of a failure (``failures_*.toml``):

==============  ========================================================================================
``key``         the key of roslab.yaml that answers, ``value`` what is written there, with ``{name}`` of
                what the failure captured
``way``         the way in which it is worked out from plan and log, see ``repair/ways.py``; ``value`` is then what
                that way is told besides (``Eigen3<3.4``), and mostly nothing
``dockerfile``  instructions to insert before the failed one in an author's own Dockerfile, with ``{name}``
``only``        regular expression, without names: these instructions are for a failed one that it matches
``find``        regular expression, with ``{name}``, on the failed instruction of such a Dockerfile;
                ``replace`` is what is written in its place, with ``\1`` for a group of it
``image``       official images of a language or a system: where the failed step builds on one, FROM gets the
                oldest of its tags (``language_images.csv``) that ``tag`` allows: limits with ``{name}``, ``newer``, or
                ``devel`` for the same tag with its compiler
``files``       regular expressions with ``{name}``, ``{low}`` in lower case, on the paths that apt's packages hold: the
                package of the first that has one repairs it, where no table names a package
``source``      addresses where the fact stands, ``date`` when it was read
==============  ========================================================================================

The packages that a failure's own ``lookup`` names need no table here.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from pathlib import Path

from roslab.values import toml
from roslab.values.dataclass import dataclass

SKIP = "skip_packages"
"""The key of packages that are left out."""
CLONES = "source"
"""The key of repositories that are cloned: a list of mappings, each written as ``{name: …, repo: …}``."""
LISTS = ("apt", "pip", "skip_keys", SKIP, "build_args")
"""The keys of roslab.yaml with lists of texts to which repairs add; the others have one value each."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Repair:
    """One repair; the fields are the table's."""

    source: str
    date: str
    key: str = ""
    value: str = ""
    way: str = ""
    dockerfile: tuple[str, ...] = ()
    only: str = ""
    find: str = ""
    replace: str = ""
    image: str = ""
    tag: str = ""
    files: tuple[str, ...] = ()


@cache
def repairs() -> dict[str, Repair]:
    """Return the repair of each failure that has one, by the failure's id."""
    found = toml.parsed(Path(__file__).with_name("repairs.toml").read_text(encoding="utf-8"))
    return {
        name: Repair(**{**row, **{key: tuple(row.get(key, ())) for key in ("dockerfile", "files")}})
        for name, row in found.items()
    }


def complete(template: str, names: Mapping[str, str]) -> bool:
    """Return whether every name that a template uses was captured; regular expressions have braces of their own."""
    wanted = re.findall(r"\{([a-z_]+)\}", template)
    return all(names.get(name) for name in wanted)
