"""Which requirement files, projects and packages the image's Python gets."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable
from dataclasses import dataclass, replace

from roslab.config.model import Config, Kind
from roslab.decide.python.pins import DEVELOPMENT, Pin, name_of, pins
from roslab.evidence import places
from roslab.evidence.facts import Dependency, Evidence, PythonProject, RequirementFile
from roslab.knowledge.frameworks import canonical, imports

_VARIANT = re.compile(
    r"(?:^|[-_.])(?:frozen|freeze|lock|locked|full|all|extra|extras|optional|mac|macos|osx|darwin|windows|win|"
    r"cpu|gpu|cuda|rocm|tpu|jetson|arm|colab|"
    r"notebooks?|examples?|demo|eval|train|py2|python2|py27|min|minimum|old|backup|hpc|cluster|benchmark|ros|"
    r"real|robot|server|web|app|viz|vis)(?:[-_.\d]|$)",
    re.IGNORECASE,
)
_TOOLS = frozenset(
    [
        "pip", "setuptools", "wheel", "virtualenv", "virtualenvwrapper", "conda", "uv", "pipenv", "poetry",
        "pipx", "twine", "build", "tox", "nox", "mamba",
    ]
)  # fmt: skip
_CI_TOOLS = frozenset(
    [
        "black", "flake8", "isort", "pylint", "mypy", "pytest", "pytest-cov", "coverage", "codecov", "coveralls",
        "cpp-coveralls", "ros-buildfarm", "catkin-lint",
        "pre-commit", "sphinx", "ruff", "autopep8", "clang-format", "clang-tidy", "cpplint", "cmakelang",
        "cmake-format", "codespell", "gcovr", "yapf", "bandit", "pydocstyle", "pycodestyle", "mkdocs",
    ]
)  # fmt: skip
_FOR_DEVELOPERS = re.compile(
    r"(?:^|/)(?:\.(?:github|circleci|travis|gitlab)|(?:bitbucket|azure)-pipelines\.|docs?\d?/)"
)
_FRAMEWORKS = frozenset({"torch", "tensorflow", "jax", "keras"})
MAX_GUESSES = 40
MAX_PROJECTS = 6


@dataclass(frozen=True, kw_only=True, slots=True)
class Chosen:
    """What was chosen, each with the dependency or file that says so."""

    files: tuple[RequirementFile, ...] = ()
    projects: tuple[PythonProject, ...] = ()
    declared: tuple[Dependency, ...] = ()
    """Lines to install one by one."""
    guessed: tuple[Dependency, ...] = ()
    options: tuple[str, ...] = ()
    conda: str | None = None


def choose(evidence: Evidence, config: Config, kind: Kind) -> Chosen:
    """Return what pip (or conda) is asked for."""
    ros = kind in {"ros1", "ros2"}
    conda = _conda(evidence, config, kind)
    if config.requirements is not None:
        wanted = {posixpath.normpath(path) for path in config.requirements}
        files = tuple(file for file in evidence.requirements if file.file in wanted)
    else:
        files = _files(evidence, kind, conda)
    projects = _projects(evidence, kind)
    manifests = bool(files or conda or any(project.dependencies for project in projects))
    known = _known(evidence, files, projects, conda)
    guessed = _guesses(evidence, ros=ros, manifests=manifests, known=known)
    options = [
        d.name for d in evidence.prose if d.namespace == "pip" and d.role == "option" and not DEVELOPMENT.search(d.file)
    ]
    options += [
        d.name for r in evidence.dockerfiles for d in r.dependencies if d.role == "option" and r.purpose == "project"
    ]
    options = [o.replace("--index-url", "--extra-index-url") if o.startswith("--index-url") else o for o in options]
    return Chosen(files=files, projects=projects, guessed=guessed, options=tuple(dict.fromkeys(options)), conda=conda)


def with_guess(chosen: Chosen, dependency: Dependency) -> Chosen:
    """Add a guess in the place of what else was guessed of the same package."""
    others = (guess for guess in chosen.guessed if name_of(guess.name) != name_of(dependency.name))
    return replace(chosen, guessed=(*others, dependency))


def _conda(evidence: Evidence, config: Config, kind: Kind) -> str | None:
    """Return the environment file of the project, the plainest name nearest to the root first.

    A requirements.txt or a project with requirements beside it is the way that more people can go.
    """
    if config.conda:
        return config.conda
    if kind in {"ros1", "ros2", "cpp"}:
        return None
    own = [
        environment
        for environment in evidence.conda
        if not places.vendored(environment.file) and environment.file.count("/") <= 1
    ]
    if not own:
        return None
    best = min(
        own, key=lambda e: (e.file.count("/"), bool(_VARIANT.search(e.file.rpartition(".")[0])), len(e.file), e.file)
    )
    folder = best.file.rpartition("/")[0]
    beside = any(
        file.purpose == "run"
        and file.file.rpartition("/")[0] in {"", folder}
        and not _VARIANT.search(file.file.rpartition(".")[0])
        for file in evidence.requirements
    )
    declared = any(p.installable and not p.folder and any(not d.role for d in p.dependencies) for p in evidence.python)
    return None if beside or declared else best.file


def _files(evidence: Evidence, kind: Kind, conda: str | None) -> tuple[RequirementFile, ...]:
    """Return the requirement files to install: what the README installs and the root's, else the nearest."""
    run = {file.file: file for file in evidence.requirements if file.purpose == "run" and not places.example(file.file)}
    if conda:
        named = {d.name for e in evidence.conda if e.file == conda for d in e.dependencies if d.role == "file"}
        folder = conda.rpartition("/")[0]
        return tuple(
            run[joined] for name in sorted(named) if (joined := posixpath.normpath(posixpath.join(folder, name))) in run
        )
    chosen: dict[str, RequirementFile] = {}
    for dependency in _prose(evidence):
        if dependency.role == "file" and (path := _resolve(dependency, run)):
            chosen[path] = run[path]
    root = [file for path, file in run.items() if "/" not in path or re.match(r"^requirements?/[^/]+$", path)]
    plain = [file for file in root if not _VARIANT.search(file.file.rpartition(".")[0])]
    standard = [file for file in plain if re.search(r"(?:^|/)requirements?\.(?:txt|in)$", file.file)]
    for file in standard or plain[:3] or ([] if chosen else root[:1]):
        chosen.setdefault(file.file, file)
    if not chosen or kind in {"ros1", "ros2"}:
        nested = [
            file for path, file in run.items() if not _VARIANT.search(path.rpartition(".")[0]) and path.count("/") <= 3
        ]
        depth = min((file.file.count("/") for file in nested), default=0)
        for file in nested if kind in {"ros1", "ros2"} else [f for f in nested if f.file.count("/") == depth][:4]:
            chosen.setdefault(file.file, file)
    included = {path for file in chosen.values() for path in file.includes}
    return tuple(
        chosen[path] for path in sorted(chosen, key=lambda path: (path.count("/"), path)) if path not in included
    )


def _prose(evidence: Evidence) -> Iterable[Dependency]:
    """Return the pip lines of READMEs of the root, of scripts, and of the project's own Dockerfiles."""
    for dependency in evidence.prose:
        if (
            dependency.namespace == "pip"
            and dependency.file.count("/") <= 1
            and not DEVELOPMENT.search(dependency.file)
        ):
            yield dependency
    for authored in evidence.dockerfiles:
        if authored.purpose in {"project", "deploy"}:
            yield from (dependency for dependency in authored.dependencies if dependency.namespace == "pip")


def _resolve(dependency: Dependency, known: Iterable[str]) -> str | None:
    """Return the path of the tree that an argument means: from the root, from its own folder, or by its unique end."""
    name = dependency.name.partition("[")[0].strip("\"'")
    folder = dependency.file.rpartition("/")[0]
    for candidate in (posixpath.normpath(name), posixpath.normpath(posixpath.join(folder, name))):
        if candidate in known:
            return candidate
    parts = [part for part in name.split("/") if part not in {"", ".", "..", "~"}]  # "pip install ." in a folder
    for start in range(len(parts)):
        tail = "/".join(parts[start:])
        if tail in known:
            return tail
    tail = "/" + "/".join(parts[-2:])
    ends = [path for path in known if path.endswith(tail)] if parts else []
    return ends[0] if len(ends) == 1 else None


def _projects(evidence: Evidence, kind: Kind) -> tuple[PythonProject, ...]:
    """Return the folders to install: the root, what the README installs, else the nearest below."""
    manifests = {manifest.file.rpartition("/")[0] for manifest in evidence.manifests if not manifest.ignored}
    usable = {p.folder: p for p in evidence.python if p.installable}
    chosen: dict[str, PythonProject] = {}
    if "" in usable and not ("" in manifests and kind in {"ros1", "ros2"}):
        members = {name_of(d.name) for d in usable[""].dependencies if d.role == "member"}
        chosen = {p.folder: p for p in usable.values() if p.name and canonical(p.name) in members}
        chosen[""] = usable[""]
    for dependency in _prose(evidence):
        if dependency.role != "project" or dependency.name in {".", "./"}:
            continue
        folder = _resolve(dependency, {folder for folder in usable if folder})
        if folder and folder not in manifests:
            chosen.setdefault(folder, usable[folder])
    if not chosen and kind != "cpp":
        own = [
            folder
            for folder in usable
            if not _inside(folder, manifests if kind in {"ros1", "ros2"} else set())
            and not places.vendored(folder + "/")
            and not places.test(folder + "/")
            and not places.example(folder + "/")
            and not places.documentation(folder + "/")
        ]
        depth = min((folder.count("/") for folder in own), default=0)
        chosen = {folder: usable[folder] for folder in own if folder.count("/") == depth and depth <= 1}
    return tuple(chosen[folder] for folder in list(chosen)[:MAX_PROJECTS])


def _inside(folder: str, packages: set[str]) -> bool:
    """Tell whether a folder is, or lies in, a ROS package: its build installs what is there."""
    parts = folder.split("/")
    return any("/".join(parts[:end]) in packages for end in range(len(parts), -1, -1))


def _known(
    evidence: Evidence, files: tuple[RequirementFile, ...], projects: tuple[PythonProject, ...], conda: str | None
) -> set[str]:
    """Return the packages that are installed anyway, and the names of the tree's own projects."""
    known = {name_of(d.name) for file in with_includes(evidence, files) for d in file.dependencies}
    known |= {name_of(d.name) for project in projects for d in project.dependencies if d.role in {"", "source"}}
    known |= {canonical(project.name) for project in evidence.python if project.name}
    for environment in evidence.conda:
        if environment.file == conda:
            known |= {name_of(d.name) for d in environment.dependencies}
            known |= {pin.name for pin in pins(Evidence(conda=(environment,)))}
    return known | {"tensorflow" for name in known if name.startswith("tensorflow-")}


def with_includes(evidence: Evidence, files: Iterable[RequirementFile]) -> list[RequirementFile]:
    """Return the files and all that they include."""
    by_path = {file.file: file for file in evidence.requirements}
    found: dict[str, RequirementFile] = {}
    pending = list(files)
    while pending:
        file = pending.pop(0)
        if file.file not in found:
            found[file.file] = file
            pending += [by_path[path] for path in file.includes if path in by_path]
    return list(found.values())


def _guesses(evidence: Evidence, *, ros: bool, manifests: bool, known: set[str]) -> tuple[Dependency, ...]:
    """Return what prose, Dockerfiles and imports name beyond the manifests, each once, the best source first."""
    found: dict[str, Dependency] = {}
    urls = {_repository(pin.line) for pin in pins(evidence) if pin.trust >= 2} - {""}
    for pin in sorted((pin for pin in pins(evidence) if pin.trust == 1), key=_specific):
        declared = pin.dependency.strength == "declared"
        aside = bool(_FOR_DEVELOPERS.search(pin.dependency.file))
        if (
            declared
            or _repository(pin.line) in urls
            or pin.name in known
            or pin.name == "pip"
            or (pin.name in _TOOLS and not pin.release)
            or (aside and pin.name in _CI_TOOLS)
        ):
            continue
        found.setdefault(pin.name, pin.dependency)
    heavy = bool(known & {"torch", "tensorflow", "jax"})
    strengths = {"used"} if manifests else {"used", "optional"}
    for dependency in evidence.code:
        if dependency.namespace != "import" or dependency.strength not in strengths or places.test(dependency.file):
            continue
        package, apt = imports().get(dependency.name) or (None, None)
        name = canonical(package) if package else ""
        covered = name in known or name in found or any(_same(name, other) for other in (*known, *found))
        if not package or covered or name in _TOOLS | _CI_TOOLS or (heavy and name in _FRAMEWORKS):
            continue
        if ros and (apt or name in _FRAMEWORKS):  # a ROS image's Python is the system's: what apt has comes from there
            continue
        found[name] = Dependency(
            namespace="pip", name=package, strength="used", file=dependency.file, line=dependency.line, role="import"
        )
    return tuple(found.values())[:MAX_GUESSES]


def _repository(line: str) -> str:
    """Return the repository of a ``git+`` line, so that two spellings of one package are not both installed."""
    match = re.search(r"git\+\w+://(?:[^@/]*@)?([\w.-]+/[\w.-]+/[\w.-]+?)(?:\.git)?(?:[@#].*)?$", line)
    return match[1].lower() if match else ""


def _same(name: str, other: str) -> bool:
    """Tell whether two packages bring the same module: the builds of OpenCV, the spellings of scikit-learn."""
    stems = ("opencv-", "mmcv", "scikit-learn", "protobuf", "pin", "cupy")
    return any(name.startswith(stem) and other.startswith(stem) for stem in stems) or {name, other} in (
        {"scikit-learn", "sklearn"},
        {"pyyaml", "yaml"},
        {"mujoco-py", "free-mujoco-py"},
        {"hydra-core", "hydra"},
        {"torch", "pytorch"},
    )


def _specific(pin: Pin) -> tuple[int, int, int]:
    """Order mentions of one package: a pinned one first, the README nearest to the root first."""
    authored = pin.dependency.file.lower().rpartition("/")[2]
    return (not pin.release, pin.dependency.file.count("/"), "docker" in authored)
