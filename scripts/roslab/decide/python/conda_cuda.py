"""The CUDA for which conda solves an environment: while an image is built there is no driver that tells it."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.config.model import Kind
from roslab.decide.cuda.conda_builds import OF_CONDA
from roslab.evidence.conda_environment import CondaEnvironment
from roslab.evidence.facts import Evidence
from roslab.knowledge.frameworks import framework, newest_on_cuda
from roslab.values.conda import CondaPackage
from roslab.values.version import Version, minor_of, version_of

_BUILD = "pytorch=*=*cuda*"
"""A build is called ``py3.7_cuda11.1_cudnn8.0.5_0``. https://github.com/mamba-org/mamba/issues/1617, 2026-11-27."""
_CHANNEL = "pytorch"
_ALONE = "cudatoolkit"
_LAST_ALONE = "11.6"
"""The last CUDA that its builds take from this package; newer ones are ``pytorch-cuda`` of the channel nvidia.
https://pytorch.org/get-started/previous-versions/, read 2026-11-27."""


def cuda_of_conda(evidence: Evidence, kind: Kind, file: str | None, cuda: str | None) -> str:
    """Return the version that ``__cuda`` stands for: the base's, or a newer one that the ``file`` names; else ``""``.

    Without it conda takes builds for the CPU wherever one for the GPU asks for a driver.
    https://docs.conda.io/projects/conda/en/stable/user-guide/tasks/manage-virtual.html, read 2026-11-25.
    """
    if kind != "cuda" or not cuda:
        return ""
    packages = [package for each in evidence.conda if each.file == file for package in each.packages]
    named = [minor_of(package.version) for package in packages if package.name in OF_CONDA]
    return max((cuda, *(each for each in named if each)), key=Version)


def builds_for_cuda(environment: CondaEnvironment, channel: str) -> Iterator[tuple[str, str]]:
    """Yield the limit to builds for CUDA of a pytorch beside which an environment names CUDA, with the reason.

    micromamba takes builds for the CPU there, above all where a newer version has no others. Only where one for that
    CUDA and Python is known. ``channel``: the one that pytorch is of.
    """
    named = {package.name: package for package in environment.packages}
    torch, toolkit = named.get("pytorch"), named.get(_ALONE) or named.get("pytorch-cuda")
    if torch and toolkit and channel == _CHANNEL and "cpuonly" not in named and _there(environment, torch, toolkit):
        yield _BUILD, f"{torch.written} beside {toolkit.written}: micromamba may take a build for the CPU"


def _there(environment: CondaEnvironment, torch: CondaPackage, toolkit: CondaPackage) -> bool:
    """Tell whether there is a build of a release that the environment allows for its CUDA and Python."""
    cuda, python = minor_of(toolkit.version), minor_of(environment.python or "")
    if torch.build or "cpu" in torch.written:
        return False  # the author's choice
    if toolkit.name == _ALONE:
        cuda = cuda or _LAST_ALONE
        outside = Version(cuda) > Version(_LAST_ALONE)
    else:
        outside = all(each.rstrip("/").rpartition("/")[2] != "nvidia" for each in environment.channels)
    if outside or cuda is None:
        return False
    if torch.release:
        row = framework("torch", torch.release)
        return row is not None and cuda in row.cuda and (python is None or row.runs_with(python))
    row = newest_on_cuda("torch", cuda, python)
    least = version_of(torch.version) if torch.sign.startswith(">") else None
    return row is not None and torch.sign in {"", ">", ">="} and (least is None or least <= Version(row.first))
