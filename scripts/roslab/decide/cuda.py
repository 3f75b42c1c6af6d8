"""Which CUDA and cuDNN the frameworks need."""

from __future__ import annotations

from dataclasses import dataclass

from roslab.config.model import Config
from roslab.decide.decision import Reason, Warning_
from roslab.evidence.facts import Evidence


@dataclass(frozen=True, kw_only=True, slots=True)
class CudaChoice:
    """Versions (``11.8``, ``8``), ``None`` where nothing asks for one."""

    cuda: str | None = None
    cudnn: str | None = None
    reasons: tuple[Reason, ...] = ()
    warnings: tuple[Warning_, ...] = ()


def decide_cuda(evidence: Evidence, config: Config) -> CudaChoice:
    """Return the CUDA and cuDNN that the repository's frameworks need."""
    del evidence
    return CudaChoice(cuda=config.base.cuda, cudnn=config.base.cudnn)
