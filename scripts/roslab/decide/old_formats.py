"""The image of a roslab.yaml in an old format: it requires what the file and the package.xml files name, nothing else.

The old generators read only roslab.yaml and package.xml. An image that also took requirements from elsewhere could
break where the old one worked: a requirements.txt of 2018 for Python 2 does not install on Python 3. Other manifests
are therefore ignored, and a warning names those at the root that would be installed today.
"""

from __future__ import annotations

from roslab.config.model import WORKSPACE_TOOLS, Config, Kind, Source
from roslab.decide.decision import Choice
from roslab.decide.python.image_python import Python
from roslab.decide.ros.built_sources import Sources
from roslab.decide.ros.layout import Layout
from roslab.decide.system.packages import SystemPackages
from roslab.evidence import places
from roslab.evidence.dependency import GitSource
from roslab.evidence.facts import Evidence
from roslab.evidence.ros.vcs import https
from roslab.values.dataclass import replace
from roslab.values.origin import Origin, Place

Warned = tuple[str, Origin | None]
_KEPT_TOPICS = frozenset({"command", "distro", "ubuntu", "build_tool"})


def narrowed(evidence: Evidence, config: Config) -> tuple[Evidence, Config]:
    """Return the evidence that an old file allows, and the configuration with the defaults of its format filled in."""
    if not config.compatible:
        return evidence, config
    files = {*(config.requirements or ()), *(config.vcs or ()), config.conda, config.dockerfile or None}
    left = _named(evidence, files)
    sources, warnings = _with_refs(config.source, evidence)
    config = replace(
        config,
        kind=_kind(left, config),
        vcs=config.vcs or (),
        source=sources,
        warnings=(*config.warnings, *_left_out(evidence, files), *warnings),
    )
    return left, config


def _named(evidence: Evidence, files: set[str | None]) -> Evidence:
    """Return the evidence from files that roslab.yaml names, from the packages, and on how these are built."""
    return replace(
        evidence,
        python=(),
        requirements=tuple(file for file in evidence.requirements if file.file in files),
        conda=tuple(file for file in evidence.conda if file.file in files),
        dockerfiles=tuple(authored for authored in evidence.dockerfiles if authored.file in files),
        code=tuple(found for found in evidence.code if found.namespace != "import"),
        prose_pip=(),
        sources=tuple(git for git in evidence.sources if git.file in files),
        mentions=tuple(mention for mention in evidence.mentions if mention.topic in _KEPT_TOPICS),
        bounds=(),
        cuda_files=(),
    )


def _left_out(evidence: Evidence, files: set[str | None]) -> list[Warned]:
    """Warn about manifests at the root that would be installed today but are not named."""
    left = [file.file for file in evidence.requirements if file.purpose == "run" and "/" not in file.file]
    left += [project.file for project in evidence.python if project.installable and not project.folder]
    return [
        (f"{name} is not installed: the old format installs only what roslab.yaml names", Place(file=name, line=1))
        for name in sorted(set(left) - files)
    ]


def _with_refs(named: tuple[Source, ...], evidence: Evidence) -> tuple[tuple[Source, ...], list[Warned]]:
    """Give sources without a ref the one that a package.xml names, and warn about each that had none."""
    sources: list[Source] = []
    warnings: list[Warned] = []
    for source in named:
        git = _pinned(source, evidence)
        sources.append(replace(source, ref=git.ref) if git else source)
        if git:
            text = f"{source.name} has no `ref`; {git.ref} is built, which {git.file}:{git.line} asks for"
            warnings.append((text, source.place or Place(file=git.file, line=git.line)))
        elif source.repo and not source.ref:
            text = f"{source.name} has no `ref`: its latest commit is built, which may no longer fit this base"
            warnings.append((text, source.place))
    return tuple(sources), warnings


def _kind(evidence: Evidence, config: Config) -> Kind | None:
    """Return the kind of an image without ROS: the later format installed no ROS unless ``base.ros`` was set."""
    if config.kind or config.base.ros or config.compatible == "paper" or config.build in WORKSPACE_TOOLS:
        return config.kind
    if config.base.cuda:
        return "cuda"
    built = any(project.top_level and not places.vendored(project.file) for project in evidence.cmake)
    return "cpp" if config.build == "cmake" or built else "python"


def _pinned(source: Source, evidence: Evidence) -> GitSource | None:
    """Return the place in a package.xml that names a branch for a source that has no ref in roslab.yaml.

    Today's latest commit is not what the file was written for.
    """
    if source.ref or not source.repo:
        return None
    url = _plain(source.repo)
    named = (git for git in evidence.sources if git.kind == "git_url" and git.ref and _plain(git.url) == url)
    return next(named, None)


def _plain(url: str) -> str:
    return https(url).removesuffix(".git").rstrip("/").lower()


def as_it_was(
    config: Config,
    *,
    base_packages: tuple[str, ...],
    python: Choice[Python],
    system: Choice[SystemPackages],
    sources: Choice[Sources],
    layout: Choice[Layout],
) -> tuple[Choice[Python], Choice[SystemPackages], Choice[Sources], Choice[Layout]]:
    """Return what an image installs and where its source lies, as in the old format.

    ``base_packages`` are the ROS packages that the base image lacks.
    """
    if not config.compatible:
        return python, system, sources, layout
    return (
        replace(python, answer=_python(python.answer, config)),
        replace(system, answer=_system(system.answer, {*config.apt, *base_packages})),
        replace(sources, answer=_sources(sources.answer, config)),
        replace(layout, answer=_layout(layout.answer)),
    )


def _python(python: Python, config: Config) -> Python:
    """Take the distribution's own Python, as the old formats did."""
    python = replace(python, native_parts=(), compiled_modules=())
    if config.conda or config.base.python:
        return python
    return replace(python, manager="system", version=None, projects=(), pip_guessed=())


def _system(system: SystemPackages, named: set[str]) -> SystemPackages:
    """Require only what the file names: what CMake files ask for besides must not stop a build."""
    others = (name for name in system.apt if name not in named)
    return replace(
        system,
        apt=tuple(name for name in system.apt if name in named),
        apt_guessed=tuple(sorted({*system.apt_guessed, *others})),
        recipes=(),
    )


def _sources(sources: Sources, config: Config) -> Sources:
    """Take only the sources of the file, in its order, unless it names vcs files."""
    return sources if config.vcs else replace(sources, sources=config.source, libraries=())


def _layout(layout: Layout) -> Layout:
    """Make the repository a folder of the workspace, as it always was in the old formats."""
    return replace(layout, workspace="overlay") if layout.workspace == "root" else layout
