"""What the launch file of a command demands and the command does not give: an address is filled in, nothing else."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from roslab.decide.candidate import Candidate, launched_by, program_of
from roslab.decide.decision import Warning_
from roslab.decide.launch_calls import demanded
from roslab.decide.reasons import page_of, warn
from roslab.evidence.launch_file import LaunchFile
from roslab.values.dataclass import replace
from roslab.values.pattern import pattern

HERE = "127.0.0.1"
_ADDRESS = pattern(
    r"(?:\w+_)?(?:ip|ip_?addr(?:ess)?|host|hostname|host_ip)|(?:robot_|server_)?address|(?:robot|server|host)ip",
    re.IGNORECASE,
)
"""The name of an argument for the address of a machine in the network."""


def with_demands(candidate: Candidate, files: Mapping[tuple[str, ...], LaunchFile]) -> Candidate:
    """Return a command as one that lacks arguments, if its launch file demands some that it does not give.

    What a page runs without nothing but addresses gets that of the machine itself. ``files``: by their calls.
    """
    rest = launched_by(candidate.argv)
    launch = files.get(rest[:1]) or files.get(rest[:2])
    asked = demanded(launch, rest) if launch else frozenset()
    if not asked:
        return candidate
    if not candidate.strong or not all(map(_ADDRESS.fullmatch, asked)):
        return replace(candidate, cut=True, lacking=tuple(sorted(asked)))
    given = (f"{name}:={HERE}" for name in sorted(asked))
    return replace(candidate, cut=True, argv=(*candidate.argv, *given))


def without_lacking(candidates: Iterable[Candidate]) -> list[Candidate]:
    """Return the commands without those that lack such arguments, unless another call of the program gives them."""
    found = list(candidates)
    return [c for c in found if not c.lacking or any(_gives(each, c) for each in found)]


def _gives(other: Candidate, lacking: Candidate) -> bool:
    same = program_of(other.argv) == program_of(lacking.argv) and not (other.cut or other.blanks)
    return same and {*lacking.lacking} <= {word.partition(":=")[0] for word in other.argv if ":=" in word}


def told(candidates: Iterable[Candidate]) -> Iterator[Warning_]:
    """Yield a warning for the first command of a page that is no default since it lacks such arguments."""
    for each in candidates:
        if each.strong and each.lacking:
            names = ", ".join(each.lacking)
            message = f"{page_of(each.file)} runs {' '.join(each.argv)}, which stops without {names}"
            yield warn(f"{message}: give the whole command under `command` in roslab.yaml", each)
            return


def filled_in(page: Candidate, said: str) -> Iterator[Warning_]:
    """Yield a warning where the default command has the machine's own address and its page, which says so much, not."""
    here = [word.partition(":=")[0] for word in page.argv if word.endswith(f":={HERE}") and word not in said.split()]
    if here:
        message = f"the default command has {HERE} for {', '.join(here)}, which the page leaves to the reader"
        yield warn(f"{message}: give it under `command` in roslab.yaml", page)
