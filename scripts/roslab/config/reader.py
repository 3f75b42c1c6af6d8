"""Reads roslab.yaml of any format into one ``Config``, or reports every problem in it at once."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, cast

from roslab.config import base as bases
from roslab.config import generation as generations
from roslab.config import packages, running, vocabulary
from roslab.config.model import Base, BuildTool, Compatible, Config, Generation, Kind, PullImage
from roslab.config.node import Mapping, Scalar, Sequence, in_file
from roslab.config.reading import Reading
from roslab.config.shape import Shape
from roslab.config.source import OLD_TOOLS, sources
from roslab.errors import ConfigurationError, Problem
from roslab.values.origin import Place

if TYPE_CHECKING:
    from roslab.config.document import Document

_KEYS: dict[Generation, dict[str, str]] = {
    "paper": {"repo": "repos", "apt": "packages", "pip": "python-packages"},
    "interim": {"apt": "apt-packages", "pip": "pip-packages", "pip3": "pip3-packages", "source": "source-packages"},
    "later": {},
    "today": {},
}
"""Names of today's keys in the old formats."""


def read(text: str | bytes, *, file: str = "roslab.yaml") -> Config:
    """Read a roslab.yaml; ``file`` is its path relative to the repository, for messages.

    Raises ``ConfigurationError`` with every problem found, in the order of the lines.
    """
    from roslab.config.document import parse  # noqa: PLC0415 - it loads YAML's parser, for those who wrote a file

    document = parse(text, file=file)
    root = mapping_of(document)
    generation = generations.tell(root, file=file)
    strange = generations.rivals(root, generation)
    shape = Shape(where=in_file(file), unknown=lambda name: _elsewhere(generation, name, strange))
    shape.problems += document.problems
    if mixed := generations.mixture(root, generation, file=file):
        shape.problems.append(mixed)
    checked = shape.check(root, vocabulary.definition(generation))
    reading = Reading(where=in_file(file))
    config = config_of(reading, checked, generation, file) if isinstance(checked, Mapping) else Config()
    problems = [*shape.problems, *reading.problems]
    problems = [problem for problem in problems if problem.hint != ""]  # see _elsewhere
    if problems:
        raise ConfigurationError(*sorted(problems, key=_by_place))
    return config


def mapping_of(document: Document) -> Mapping:
    """Return the mapping that a file must be.

    Raises ``ConfigurationError`` if it is empty or something else.
    """
    root = document.root
    if isinstance(root, Mapping) and root.pairs:
        return root
    if isinstance(root, Mapping) and document.problems:  # of its keys, none of which is left
        raise ConfigurationError(*document.problems)
    if root is None or (isinstance(root, Scalar) and root.kind == "null") or isinstance(root, Mapping):
        message, hint = "the file is empty", "begin with `format: 3`, or delete it: no roslab.yaml is needed"
    else:
        was = "a list" if isinstance(root, Sequence) else "text"
        message, hint = f"the file is {was}, not a mapping", "write KEY: VALUE lines, `format: 3` first"
    origin = in_file(document.file)(root.start) if root else Place(file=document.file)
    problem = Problem(message=message, hint=hint, origin=origin)
    raise ConfigurationError(*document.problems, problem)


def _elsewhere(generation: Generation, name: str, strange: tuple[str, ...]) -> str | None:
    """Return a hint about an unknown key, ``""`` if the problem about mixed formats already names that key."""
    return "" if name in strange else generations.elsewhere(generation, name)


def _by_place(problem: Problem) -> tuple[int, int]:
    return problem.line or 0, problem.column or 0


def config_of(reading: Reading, root: Mapping, generation: Generation, file: str | None = None) -> Config:
    """Return a checked tree as the model; problems that the schema cannot find are added to ``reading``."""
    old = generation != "today"
    key = {name: name for name in ("repo", "apt", "pip", "pip3", "source")} | _KEYS[generation]
    base = bases.base(reading, root, generation)
    shared = bases.implied(reading, root, generation, base)
    gui, gpu = reading.truth(root, "gui", "gui"), reading.truth(root, "gpu", "gpu")
    notebook = reading.truth(root, "notebook", "notebook")
    compatible = _compatible(reading, root, generation, base)
    python2 = "pip2" in root.names or compatible is not None
    pip, pip_options = packages.pip(reading, root, "pip2" if "pip2" in root.names else key["pip"], "pip")
    pip3, pip3_options = packages.pip(reading, root, key["pip3"], "pip3")
    _advise(reading, root, generation)
    return Config(
        file=file,
        generation=generation,
        compatible=compatible,
        name=_name(reading, root),
        kind=cast(Kind | None, reading.value(root, "kind", "kind")),
        date=running.day(reading, root, "date"),
        pip_date=running.day(reading, root, "pip_date"),
        base=base,
        repositories=packages.repositories(reading, root, key["repo"]),
        apt=packages.apt(reading, root, key["apt"]),
        pip=pip,
        pip_options=pip_options,
        pip_python="2" if python2 and pip else "image",
        pip3=pip3,
        pip3_options=pip3_options,
        requirements=_files(reading, root, "requirements"),
        conda=reading.value(root, "conda", "conda"),
        vcs=_files(reading, root, "vcs"),
        source=sources(reading, root, key["source"]),
        build=_build(reading, root, generation, compatible),
        build_args=running.arguments(reading, root, "build_args"),
        cmake_options=reading.value(root, "cmake_options", "cmake_options") or "",
        skip_keys=reading.values(root, "skip_keys", "skip_keys") or (),
        skip_packages=reading.values(root, "skip_packages", "skip_packages") or (),
        custom=running.custom(reading, root, generation),
        env=running.environment(reading, root),
        command=running.command(reading, root, "command"),
        test=running.command(reading, root, "test"),
        dockerfile=_dockerfile(reading, root),
        context=reading.value(root, "context", "context"),
        args=running.environment(reading, root, "args"),
        target=reading.value(root, "target", "target"),
        secrets=running.secrets(reading, root),
        repair=reading.truth(root, "repair", "repair"),
        lock=reading.truth(root, "lock", "lock"),
        submodules=cast(Literal["optional", "required"] | None, reading.value(root, "submodules", "submodules")),
        tags=running.tag_parts(reading, root),
        pr=cast(PullImage | None, reading.value(root, "pr", "pr")),
        proof=running.proof(reading, root),
        goals=running.goals(reading, root),
        gui=shared if gui is None else gui,
        gpu=shared if gpu is None else gpu,
        volume=running.volumes(reading, root),
        ports=reading.values(root, "ports", "ports") or (),
        platforms=reading.values(root, "platforms", "platforms"),
        notebook=True if notebook is None and old else notebook,
        slim=reading.truth(root, "slim", "slim"),
        matlab=running.matlab(reading, root),
        origins=tuple(reading.origins.items()),
        warnings=tuple(reading.warnings),
    )


def _dockerfile(reading: Reading, root: Mapping) -> str | Literal[False] | None:
    text = reading.text(root, "dockerfile", "dockerfile")
    if text is None or text.node.kind != "boolean":
        return text.value if text else None
    return False


def _advise(reading: Reading, root: Mapping, generation: Generation) -> None:
    """Warn if a file without ``format: 3`` is probably not meant to be in an old format.

    It uses today's keys, or does not say what the image starts from, as every file of the later format did.
    """
    if generation == "today":
        return
    used = [name for name in root.names if name in generations.news()]
    if used:
        reading.warn(
            f"`{used[0]}` is a key of today's format, but without `format: 3` the file is read as "
            f"{generations.NAMES[generation]}: JupyterLab is installed, and `custom` keeps its old meaning",
            root.key(used[0]),
        )
    elif generation == "later" and "base" not in root.names:
        reading.warn(
            f"without `format: 3` as its first line the file is read as {generations.NAMES[generation]}: only what it "
            "names is installed, beside JupyterLab, and `custom` runs as root in `/`",
            root.key(root.names[0]) if root.names else None,
        )


def _name(reading: Reading, root: Mapping) -> str | None:
    text = reading.text(root, "name", "name")
    if text is None:
        return None
    if text.value != text.value.lower():
        reading.warn(f"image names are in lower case: `{text.value}` becomes `{text.value.lower()}`", text.node)
    return text.value.lower()


_OLD_UBUNTU = frozenset({"xenial", "bionic"})
"""The releases that the later format's generator supported: every file that worked names one of them."""


def _compatible(reading: Reading, root: Mapping, generation: Generation, base: Base) -> Compatible | None:
    """Return the old generator that the image imitates; ``None`` also if no old generator could build such a file."""
    if generation == "today":
        return cast(Compatible | None, reading.value(root, "compatible", "compatible"))
    if generation == "later":
        return "later" if base.ubuntu in _OLD_UBUNTU and base.image is None else None
    return "paper" if generation == "paper" else "later"


def _build(reading: Reading, root: Mapping, generation: Generation, compatible: Compatible | None) -> BuildTool | None:
    tool = reading.value(root, "build", "build")
    if tool is None and generation == "interim":
        return "cmake"  # repolab built every repository with cmake
    if tool is None:
        return "none" if generation == "later" and compatible else None
    return cast(BuildTool, OLD_TOOLS.get(tool, tool))


def _files(reading: Reading, root: Mapping, key: str) -> tuple[str, ...] | None:
    """Read a list of files: an empty list means no files, a missing key gives ``None``."""
    return reading.values(root, key, key)
