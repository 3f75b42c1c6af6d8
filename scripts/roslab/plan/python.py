"""The Python part of a plan: the decision's, with each requirement as the line that pip is given."""

from __future__ import annotations

from collections.abc import Iterable

from roslab.decide.python.bare import bare
from roslab.decide.python.compiling import NOTHING, Compiling
from roslab.decide.python.image_python import Manager, Python
from roslab.knowledge.tools import STRICT_SINCE
from roslab.values.dataclass import dataclass
from roslab.values.native_part import NativePart
from roslab.values.requirement import Requirement


@dataclass(frozen=True, kw_only=True, slots=True)
class PythonPlan:
    """The fields of ``decide.python.image_python.Python``, which say what each is."""

    version: str | None
    manager: Manager
    pip: tuple[str, ...]
    pip_guessed: tuple[str, ...]
    requirements: tuple[str, ...]
    manifests: tuple[str, ...]
    projects: tuple[str, ...]
    alone: tuple[str, ...]
    conda_file: str | None
    first: tuple[str, ...]
    bounds: tuple[str, ...]
    options: tuple[str, ...]
    pip_options: tuple[str, ...]
    python2: tuple[str, ...]
    python2_options: tuple[str, ...]
    pip_tried: tuple[str, ...] = ()
    beside: tuple[str, ...] = ()
    """Lines of ``pip`` and ``pip_guessed`` that a page has built without isolation."""
    editable: tuple[str, ...] = ()
    """Lines of ``pip_guessed`` that a page clones and installs editable: the clone stays in the image."""
    by_name: tuple[str, ...] = ()
    """Lines of ``pip_guessed`` that are nothing but the name of a module."""
    bare: tuple[str, ...] = ()
    """Lines of ``pip_guessed`` that are installed without what their packages ask for."""
    conda_specs: tuple[str, ...] = ()
    conda_channels: tuple[str, ...] = ()
    conda_defaults: bool = False
    conda_local: tuple[str, ...] = ()
    conda_pip: bool = True
    conda_instead: tuple[str, ...] = ()
    conda_flow: bool = False
    conda_no_channels: tuple[str, ...] = ()
    conda_old_pip: str = ""
    conda_pip_below: str = ""
    conda_limits: tuple[str, ...] = ()
    conda_cuda: str = ""
    beside_files: tuple[str, ...] = ()
    cloned_files: tuple[str, ...] = ()
    unseen: tuple[str, ...] = ()
    gpu_asked: tuple[str, ...] = ()
    imported: tuple[str, ...] = ()
    """Those of ``unseen`` that are left out where pip cannot install them."""
    lost_extensions: tuple[tuple[str, tuple[str, ...]], ...] = ()
    setuptools: str = ""
    copied: tuple[str, ...] = ()
    """Own projects that are not installed editable."""
    cuda_architectures: str = ""
    cuda_variables: tuple[tuple[str, str], ...] = ()
    """Further variables that tell packages the GPUs to compile for, with their values."""
    cuda_options: tuple[tuple[str, str], ...] = ()
    """Lines of pip that are installed by themselves, each with the option of its setup.py that compiles for GPUs."""
    defines: tuple[str, ...] = ()
    day: str | None = None
    clones: bool = False
    """pip installs from repositories of git."""
    native_parts: tuple[NativePart, ...] = ()
    isolated: tuple[str, ...] = ()
    """Folders of projects that pip builds in isolation, though ``first`` is not empty."""
    compiled_modules: tuple[str, ...] = ()


def installs(python: Python | PythonPlan) -> bool:
    """Tell whether pip installs anything for the image's own Python."""
    named = python.pip or python.pip_guessed or python.first
    return bool(named or python.requirements or python.cloned_files or python.projects)


def python_plan(python: Python, compiling: Compiling = NOTHING) -> PythonPlan:
    """Write the decision's requirements out as lines."""
    return PythonPlan(
        version=python.version,
        manager=python.manager,
        pip=_lines(python.pip),
        pip_tried=_lines(python.pip_tried),
        pip_guessed=_lines(python.pip_guessed),
        beside=_lines(each for each in (*python.pip, *python.pip_guessed) if each.beside),
        editable=_lines(each for each in python.pip_guessed if each.editable),
        by_name=_lines(each for each in python.pip_guessed if each.key in python.by_name and each.text == each.name),
        bare=_lines(each for each in python.pip_guessed if bare(each)),
        requirements=python.requirements,
        manifests=python.manifests,
        projects=python.projects,
        alone=python.alone,
        conda_file=python.conda_file,
        first=_lines(python.first),
        bounds=_lines(python.bounds),
        options=python.options,
        pip_options=python.pip_options,
        python2=_lines(python.python2),
        python2_options=python.python2_options,
        conda_specs=python.conda_specs,
        conda_channels=python.conda_channels,
        conda_defaults=python.conda_defaults,
        conda_local=python.conda_local,
        conda_pip=python.conda_pip,
        conda_instead=_lines(python.conda_instead),
        conda_flow=python.conda_flow,
        conda_no_channels=python.conda_no_channels,
        conda_old_pip=python.conda_old_pip,
        conda_pip_below=python.conda_pip_below,
        conda_limits=python.conda_limits,
        conda_cuda=python.conda_cuda,
        beside_files=_lines(python.beside_files),
        cloned_files=python.cloned_files,
        unseen=python.unseen,
        gpu_asked=python.gpu_asked,
        imported=python.imported,
        lost_extensions=tuple((folder, _lines(asked)) for folder, asked in python.lost_extensions),
        setuptools=python.setuptools.written if python.setuptools else "",
        copied=compiling.copied,
        cuda_architectures=compiling.architectures,
        cuda_variables=compiling.gpus,
        cuda_options=compiling.options,
        defines=python.defines,
        day=python.day,
        clones=compiling.git,
        native_parts=python.native_parts,
        isolated=python.isolated,
        compiled_modules=python.compiled_modules,
    )


def _lines(asked: Iterable[Requirement]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(each.text for each in asked))


def asks_for_old(python: Python) -> bool:
    """Tell whether pip may be asked for packages whose metadata today's pip refuses.

    So it is where its packages are of a day before that pip; later, where lists, projects or lines name releases.
    """
    if not python.day or python.day < STRICT_SINCE:
        return bool(python.day)
    lists = (*python.requirements, *python.cloned_files, *python.manifests, *python.projects, *python.python2)
    lines = (*python.pip, *python.pip_guessed, *python.first)
    names = {each.key for each in lines}
    lines += tuple(each for each in python.bounds if each.key in names)
    return bool(lists or python.conda_file or python.conda_specs or any(each.limited for each in lines))
