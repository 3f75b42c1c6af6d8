"""What to know where the image has the ONNX Runtime for the CPU, and the code asks for a GPU."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roslab.config.model import Source
from roslab.decide.decision import Warning_
from roslab.decide.reasons import warn
from roslab.evidence.facts import Evidence
from roslab.evidence.native.onnx_on_gpu import TOPIC

NAME = "onnxruntime"


def onnx_on_cpu(sources: Iterable[Source], evidence: Evidence) -> Iterator[Warning_]:
    """Yield a warning for the first place where the code asks for a GPU, if an archive of the table is unpacked."""
    said = next((each for each in evidence.mentions if each.topic == TOPIC), None)
    if said and any(source.name == NAME and source.zip_arm64 for source in sources):
        message = f"{said.text} is called here, and the image has the ONNX Runtime for the CPU"
        hint = "install the archive for CUDA under `custom` in roslab.yaml"
        yield warn(f"{message}: it computes there, or stops where that error is not caught; {hint}", said)
