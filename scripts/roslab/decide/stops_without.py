"""What the code says that it stops without, and no source of the image's base has."""

from __future__ import annotations

from roslab.config.model import Config
from roslab.decide.decision import Choice
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence


def decide_stops(evidence: Evidence, config: Config, image: str) -> Choice[None]:
    """Return a warning for each library without which a program stops, on a base that is not NVIDIA's."""
    if config.compatible or "nvidia" in image or "nvcr.io" in image:
        return Choice(answer=None)
    return Choice(
        answer=None,
        warnings=tuple(
            warn(
                f"a program stops here without {mention.value}, which {image} and its package sources do not have: "
                "give an image with it as `base.image` in roslab.yaml",
                mention,
            )
            for mention in evidence.mentions
            if mention.topic == "stops"
        ),
    )
