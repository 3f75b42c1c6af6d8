"""Code of MATLAB beside what is built, of which the image has nothing to run it with."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.config.model import Config
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence
from roslab.evidence.prose.octave import file_of


def matlab_code(evidence: Evidence, config: Config) -> Iterator[Warning_]:
    """Yield a warning where most code of the tree is MATLAB's, and neither roslab.yaml nor a page runs it otherwise.

    Not where the code is elsewhere: in submodules, or in what a list names.
    """
    said = next((each for each in evidence.mentions if each.topic == "matlab"), None)
    elsewhere = any(git.kind in {"submodule", "vcs"} for git in evidence.sources)
    if said is None or elsewhere or config.matlab or any(file_of(each) for each in evidence.mentions):
        return
    message = f"most of the code is MATLAB's ({said.value} .m files), which is licensed and never in an image"
    hint = "start the container with the MATLAB of the host: `matlab: {host_path: …}` in roslab.yaml"
    yield warn(f"{message}: the image is for the rest alone; {hint}", said)
