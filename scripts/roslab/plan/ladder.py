"""The ladder of a proof: how far an image got on one platform, rung by rung, and never further than was seen."""

from __future__ import annotations

from typing import Any, Literal

from roslab.values.dataclass import asdict, dataclass

NAMES = ("installs", "starts", "talks", "shows", "agrees", "runs on a GPU")
"""What holds on each rung, in their order."""
LOWER = "correct the code, or ask for a lower `rung` under `proof` in roslab.yaml"
"""What to do where an image is not as high as it should be."""
COMMAND = "a program in the place of the shell: name it as `command` in roslab.yaml"
State = Literal["held", "missed", "unseen"]
"""``unseen``: it could not be looked at here, which is no failure of the image."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Rung:
    """What was seen of one rung."""

    number: int
    state: State
    said: str
    """What was seen, in one line."""
    needed: str = ""
    """What it would have needed; ``""`` if it holds."""
    facts: tuple[str, ...] = ()
    """What two climbs of one image have in common, one fact a line: ``topic /scan [sensor_msgs/LaserScan] talks``."""

    @property
    def name(self) -> str:
        """What holds on it."""
        return NAMES[self.number]


@dataclass(frozen=True, kw_only=True, slots=True)
class Ladder:
    """The rungs that an image can have, from the lowest; the others are left out."""

    rungs: tuple[Rung, ...] = ()

    @property
    def reached(self) -> int | None:
        """The highest rung that holds with all below it, ``None`` if the lowest does not hold."""
        found = None
        for rung in self.rungs:
            if rung.state != "held":
                break
            found = rung.number
        return found

    @property
    def next(self) -> Rung | None:
        """The lowest rung that does not hold."""
        return next((rung for rung in self.rungs if rung.state != "held"), None)

    @property
    def beyond(self) -> str:
        """What the next rung would need, or why that is not known, as a clause; ``""`` where nothing is above.

        Where the command is a shell, an image has no rung 1, though its repository could have one.
        """
        if (missing := self.next) is None:
            shell = self.reached == 0 and all(rung.number != 1 for rung in self.rungs)
            return f"{title(1)}, would need {COMMAND}" if shell else ""
        why = f", would need {missing.needed}" if missing.needed else f": {missing.said}"
        return f"{title(missing.number)}{why}"

    def __str__(self) -> str:
        """Return how far it got, ``rung 2, talks``, and what the next rung would need."""
        return f"{title(self.reached)}; {self.beyond}" if self.beyond else title(self.reached)


def title(reached: int | None) -> str:
    """Return the name of a rung: ``rung 2, talks``."""
    return "no rung" if reached is None else f"rung {reached}, {NAMES[reached]}"


def lines(ladder: Ladder) -> tuple[str, ...]:
    """Return a ladder as lines of text, from the lowest rung, and how far it got."""
    marks = {"held": "holds", "missed": "does not hold", "unseen": "not seen"}
    told = (f"rung {rung.number}, {rung.name}, {marks[rung.state]}: {rung.said}" for rung in ladder.rungs)
    return (*told, f"reached: {ladder}") if ladder.rungs else ()


def missed(ladder: Ladder, number: int) -> bool:
    """Tell whether a rung was looked at and does not hold."""
    return any(rung.number == number and rung.state == "missed" for rung in ladder.rungs)


def lost(before: Ladder, now: Ladder) -> Rung | None:
    """Return the first rung of ``now`` that does not hold, and held before."""
    held = {rung.number for rung in before.rungs if rung.state == "held"}
    return next((rung for rung in now.rungs if rung.number in held and rung.state == "missed"), None)


def below(ladder: Ladder, wanted: int | None) -> str:
    """Return why a ladder is not as high as wanted, ``""`` if it is.

    A wanted rung that this image cannot have is as good as the highest one below it.
    """
    if wanted is None:
        return ""
    short = next((rung for rung in ladder.rungs if rung.number <= wanted and rung.state != "held"), None)
    if short is None and any(rung.number == wanted for rung in ladder.rungs):
        return ""
    if short is None:
        return f"roslab.yaml asks for {title(wanted)}, which this image cannot have: it has {title(ladder.reached)}"
    why = short.needed or short.said
    return f"roslab.yaml asks for {title(wanted)}, and rung {short.number}, {short.name}, does not hold: {why}"


def to_data(ladder: Ladder) -> list[dict[str, Any]]:
    """Return a ladder for JSON."""
    return [asdict(rung) for rung in ladder.rungs]
