"""What to know where the image has the libtorch for the CPU, and a script or the code asks for that of CUDA."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.config.model import Source
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.decide.system.libtorch import NAME
from roslab.evidence.facts import Evidence
from roslab.evidence.native.torch_on_gpu import TOPIC
from roslab.values.pattern import pattern

_OF_CPU = pattern(r"/libtorch/cpu/")


def libtorch_on_cpu(sources: Iterable[Source], evidence: Evidence) -> Iterator[Warning_]:
    """Yield a warning for the archive that a script or a page takes, and one for code that needs a GPU."""
    if not any(source.name == NAME and _OF_CPU.search(source.zip or "") for source in sources):
        return
    then = "give `base.cuda` in roslab.yaml (beside `base.ros`, if it is for ROS)"
    for said in evidence.mentions:
        if said.topic == TOPIC:
            what = f"{said.text} is taken here" if said.value else f"{said.text} is called here in any case"
            stops = "what it is for finds no GPU" if said.value else "a program stops where it comes to it"
            yield warn(f"{what}, and the image has the libtorch for the CPU: {stops}; {then}", said)
