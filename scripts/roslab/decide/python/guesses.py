"""What the image's Python gets although no manifest names it: from install lines and from imports."""

from __future__ import annotations

import re

from packaging.utils import canonicalize_name

from roslab.decide.python.manifests import with_includes
from roslab.decide.python.pins import Pin, of_conda
from roslab.decide.python.pythons import ANY
from roslab.evidence import places
from roslab.evidence.facts import Evidence, PythonProject, RequirementFile
from roslab.knowledge.frameworks import imports
from roslab.values.requirement import Requirement, stated

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


def guesses(
    evidence: Evidence, pins: tuple[Pin, ...], *, ros: bool, manifests: bool, known: set[str]
) -> tuple[Requirement, ...]:
    """Return what prose, Dockerfiles and imports name beyond the manifests, each once, the best source first."""
    found: dict[str, Requirement] = {}
    urls = {_repository(pin.requirement.url) for pin in pins if pin.trust >= 2} - {""}
    for pin in sorted((pin for pin in pins if pin.trust == 1), key=_specific):
        aside = bool(_FOR_DEVELOPERS.search(pin.requirement.file))
        if (
            pin.requirement.origin != "prose"
            or _repository(pin.requirement.url) in urls
            or pin.name in known
            or pin.name == "pip"
            or (pin.name in _TOOLS and not pin.release)
            or (aside and pin.name in _CI_TOOLS)
        ):
            continue
        found.setdefault(pin.name, pin.requirement)
    heavy = bool(known & {"torch", "tensorflow", "jax"})
    strengths = {"used"} if manifests else {"used", "optional"}
    for dependency in evidence.code:
        if dependency.namespace != "import" or dependency.strength not in strengths or places.test(dependency.file):
            continue
        package, apt = imports().get(dependency.name) or (None, None)
        name = canonicalize_name(package) if package else ""
        covered = name in known or name in found or any(_same(name, other) for other in (*known, *found))
        if not package or covered or name in _TOOLS | _CI_TOOLS or (heavy and name in _FRAMEWORKS):
            continue
        if ros and (apt or name in _FRAMEWORKS):  # a ROS image's Python is the system's: what apt has comes from there
            continue
        found[name] = stated(package, "import", dependency.file, dependency.line)
    return tuple(found.values())[:MAX_GUESSES]


def _repository(url: str) -> str:
    """Return the repository of a ``git+`` URL, so that two spellings of one package are not both installed."""
    match = re.search(r"git\+\w+://(?:[^@/]*@)?([\w.-]+/[\w.-]+/[\w.-]+?)(?:\.git)?(?:[@#].*)?$", url)
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
    authored = pin.requirement.file.lower().rpartition("/")[2]
    return (not pin.release, pin.requirement.file.count("/"), "docker" in authored)


def known_names(
    evidence: Evidence, files: tuple[RequirementFile, ...], projects: tuple[PythonProject, ...], conda: str | None
) -> set[str]:
    """Return the packages that are installed anyway, and the names of the tree's own projects."""
    asked = [each for file in with_includes(evidence, files) for each in file.requirements]
    asked += [each for project in projects for each in project.requirements if each.role in {"", "source"}]
    for environment in evidence.conda:
        if environment.file == conda:
            asked += [*environment.requirements, *of_conda(environment)]
    known = {each.key for each in asked if ANY.may(each)}
    known |= {canonicalize_name(project.name) for project in evidence.python if project.name}
    return known | {"tensorflow" for name in known if name.startswith("tensorflow-")}
