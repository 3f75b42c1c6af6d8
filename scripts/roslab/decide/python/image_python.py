"""What was decided about the Python of the image."""

from __future__ import annotations

from typing import Literal

from roslab.decide.python.pythons import ANY
from roslab.values.dataclass import dataclass
from roslab.values.interpreter import Interpreter
from roslab.values.native_part import NativePart
from roslab.values.requirement import Requirement

Manager = Literal["system", "venv", "conda"]
"""``system``: the base's own interpreter (ROS); ``venv``: /opt/venv over it; ``conda``: by micromamba."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Python:
    """The Python part of the image."""

    version: str | None
    """``3.8``; ``None`` where the image needs none of its own."""
    manager: Manager
    day: str | None = None
    """``YYYY-MM-DD``: pip's packages are those of that day, ``None`` for those of the image's."""
    interpreter: Interpreter = ANY
    """The Pythons that it may be, for the markers of requirements."""
    pip: tuple[Requirement, ...] = ()
    """Declared in a manifest: they must install."""
    pip_tried: tuple[Requirement, ...] = ()
    """Those of ``pip`` whose file pip refuses: one by one where they do not install together, so that none stops it."""
    pip_guessed: tuple[Requirement, ...] = ()
    """Read from imports or prose: installed where pip can, reported where not."""
    by_name: tuple[str, ...] = ()
    """Those of ``pip_guessed`` that are tried because a module has their name: not where something else brings it."""
    requirements: tuple[str, ...] = ()
    """Requirement files of the tree to install as they are, relative to the root."""
    beside_files: tuple[Requirement, ...] = ()
    """Those of ``pip_guessed`` that are packages of these files with extras of a page: one call of pip chooses both."""
    cloned_files: tuple[str, ...] = ()
    """Requirement files of submodules that the image clones, relative to the root; nothing has read them."""
    manifests: tuple[str, ...] = ()
    """Every file that ``requirements`` and ``conda_file`` need to be read: what they include, their constraints."""
    projects: tuple[str, ...] = ()
    """Folders to ``pip install``, ``.`` for the root; installed in this order, editable, after the source is copied."""
    unseen: tuple[str, ...] = ()
    """Those of ``projects`` that lie in submodules which are not checked out: they may be none."""
    gpu_asked: tuple[str, ...] = ()
    """Folders with a setup.py that stops where torch sees no GPU, and asks for nothing else of one."""
    imported: tuple[str, ...] = ()
    """Those of ``unseen`` for which an import alone speaks, or of several: what pip cannot install is left out."""
    lost_extensions: tuple[tuple[str, tuple[Requirement, ...]], ...] = ()
    """Those of ``projects`` whose extension lacks a library, each with what pip installs where it stops there."""
    alone: tuple[str, ...] = ()
    """Those of ``projects`` to install without their dependencies, because one of these cannot be had anywhere."""
    isolated: tuple[str, ...] = ()
    """Folders of projects that are built in isolation though something must be there first, for other packages."""
    conda_file: str | None = None
    conda_specs: tuple[str, ...] = ()
    """conda's packages where ``conda_file`` is pixi's, which micromamba does not read, or where there is none."""
    conda_channels: tuple[str, ...] = ()
    """Those of ``conda_specs``; of a ``conda_file`` that names none, those of its page and of its builds."""
    conda_defaults: bool = False
    """The environment file counts on conda's default channels, which conda adds by itself and micromamba does not."""
    conda_local: tuple[str, ...] = ()
    """Lines for pip that are taken out of the conda file: folders of the tree, and what pip cannot install."""
    conda_pip: bool = True
    """The conda file has pip install something else."""
    conda_instead: tuple[Requirement, ...] = ()
    """Those of ``pip`` that stand for lines which are taken out: one call of pip chooses them and the others."""
    conda_flow: bool = False
    """A list of the conda file stands in brackets, which are unfolded before lines of it are changed."""
    conda_no_channels: tuple[str, ...] = ()
    """What the conda file lists as channels and is none: the page or the file of a package."""
    conda_old_pip: str = ""
    """The version of pip that the conda file pins and that is not taken: it knows no wheels of today."""
    conda_pip_below: str = ""
    """The first pip that is too new for the conda file, which names it in any version."""
    conda_limits: tuple[str, ...] = ()
    """What conda must not take, if it takes that package at all: ``mkl<2024.1`` beside an old torch."""
    conda_cuda: str = ""
    """The CUDA of the drivers for which conda takes packages; ``""``: as on the machine that builds."""
    setuptools: Requirement | None = None
    """The setuptools of the environment, where a package is too old for newer ones."""
    first: tuple[Requirement, ...] = ()
    """What must be installed before the others are built (numpy, torch, Cython)."""
    defines: tuple[str, ...] = ()
    """Macros with which the C++ of the own projects is compiled: ``AT_CHECK=TORCH_CHECK``."""
    bounds: tuple[Requirement, ...] = ()
    """pip constraints: newer versions lack what the code uses, or do not fit its compiled parts or the CUDA."""
    options: tuple[str, ...] = ()
    """pip options: index URLs and find-links of the framework's own wheels."""
    pip_options: tuple[str, ...] = ()
    """Options among the lines of ``pip`` in roslab.yaml (``--upgrade``), for these lines only."""
    python2: tuple[Requirement, ...] = ()
    """Requirements for a Python 2 beside the image's Python (``pip`` in the old formats)."""
    python2_options: tuple[str, ...] = ()
    native_parts: tuple[NativePart, ...] = ()
    """Libraries that packages need before they are built, and do not bring."""
    compiled_modules: tuple[str, ...] = ()
    """Modules that compile themselves when they are first imported."""
