"""Layer 4, what all calls of pip share: their day, wheels first, GPUs that no build sees, git over https."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.plan.python import installs
from roslab.render import quote
from roslab.render.layers import shell

OLDER_NAMES = "/usr/local/share/roslab/older-names.h"
"""A header that both compilers include before each file."""
_FLAGS = frozenset({"CFLAGS", "CXXFLAGS", "CPPFLAGS", "FFLAGS", "LDFLAGS"})
"""What compilers are told through CMake, make and Autotools:
https://www.gnu.org/software/make/manual/html_node/Implicit-Variables.html."""
_LISTS = frozenset({"LD_LIBRARY_PATH", "CMAKE_PREFIX_PATH"})


def settings(plan: Plan) -> str:
    """Say how pip builds: from wheels where there are any, for GPUs that no build sees, with git over https."""
    python = plan.python
    lines: list[str] = []
    if plan.compatible:
        return ""
    if python.day:
        lines.append(of_day(python.day))
    if python.clones and (python.day or plan.as_of):
        lines.append(shell.copy_script("git-as-of").rstrip())
    if python.manager != "system" or installs(python):
        lines += ["# An older wheel is taken before the source of a newer release", "ENV PIP_PREFER_BINARY=1"]
    if python.cuda_architectures:
        lines.append("# No GPU is seen while an image is built: extensions are compiled for all of these")
        pairs = (("FORCE_CUDA", "1"), ("TORCH_CUDA_ARCH_LIST", python.cuda_architectures), *python.cuda_variables)
        lines.append("ENV " + " \\\n    ".join(f"{name}={quote.docker(value)}" for name, value in pairs))
    if python.defines and not plan.workspace.python_projects:
        lines.append("# A script compiles C++ that is written for an older release")
        lines += [text] if (text := older_names(plan)) else []
        lines.append("ENV " + " \\\n    ".join(f"{name}={quote.docker(flags)}" for name, flags in macros(plan)))
    return "\n".join(lines)


def of_day(day: str) -> str:
    """Return the comment that says of which day it is what pip installs."""
    return f"# What pip installs without a version is of {day}: `pip_date` in roslab.yaml says which"


def macros(plan: Plan) -> tuple[tuple[str, str], ...]:
    """Return the variables in which both compilers are told the macros that older C++ needs.

    setuptools gives CPPFLAGS to the host's compiler only, whatever the language; nvcc reads its own.
    https://docs.nvidia.com/cuda/cuda-compiler-driver-nvcc/#nvcc-environment-variables.
    """
    names = plan.python.defines
    flags = f"-include {OLDER_NAMES}" if older_names(plan) else " ".join(f"-D{name}" for name in names)
    return (("CPPFLAGS", flags), ("NVCC_APPEND_FLAGS", flags)) if flags else ()


def older_names(plan: Plan) -> str:
    """Write the macros to a header where one of them takes arguments: not every build tool quotes its parentheses."""
    if not any("(" in name for name in plan.python.defines):
        return ""
    lines = ("#define " + quote.checked(name).replace("=", " ", 1) for name in plan.python.defines)
    return shell.heredoc(OLDER_NAMES, "\n".join(lines))


def variables(plan: Plan) -> str:
    """Set the variables that the build, a launch file or a simulator reads, and the flags of roslab.yaml for compilers.

    Its other variables are the container's alone.
    """
    given = {} if plan.compatible else {name: value for name, value in plan.env if name in _FLAGS}
    found = dict(plan.workspace.variables) | given
    pairs = [f"{name}={_value(name, value, plan)}" for name, value in found.items()]
    return "# What the build or a program reads\nENV " + " \\\n    ".join(pairs) if pairs else ""


def _value(name: str, value: str, plan: Plan) -> str:
    """Return a value as it is written, with folders of the repository (``./models``) and of the home at their place.

    Those of PATH come before the others, and those of the linker and of CMake before what the base image tells them.
    """
    parts = value.split(":")
    at_home = all(part.startswith("~/") for part in parts)
    if at_home:
        value = ":".join(f"/home/{quote.USER}/{part[2:]}" for part in parts)
    if name == "PATH":
        return f'"{quote.docker_path(value)}:${{PATH}}"'
    if name == "LIBRARY_PATH" or (at_home and name in _LISTS):
        return f'"{quote.docker_path(value)}${{{name}:+:${{{name}}}}}"'
    if at_home:
        return f'"{quote.docker_path(value)}"'
    if not all(part.startswith("./") for part in parts):
        return quote.docker(value)
    placed = ":".join(f"/home/{quote.USER}/{plan.workspace.folder}/{part[2:]}".rstrip("/") for part in parts)
    return f'"{quote.docker_path(placed)}"'


def also_with_what_is_there(plan: Plan, pip: str, words: str) -> str:
    """Return a call of pip, and one more where it fails and some package builds with others that are there already.

    In an environment of its own such a package does not find them: its setup.py imports torch or NumPy, which no list
    of what it builds with names.
    """
    whole = f"{pip}{words}"
    again = f"{pip} --no-build-isolation{words}"
    return f"{{ {whole} \\\n      || {again}; }}" if plan.python.first else whole


def with_what_is_there(pip: str, words: str) -> str:
    """Return a call of pip for packages that a page has built beside what is there, and an isolated one else.

    Alone some would be built too, without the extension for which they need torch.
    """
    return f"{{ {pip} --no-build-isolation{words} \\\n      || {pip}{words}; }}"


def also_one_by_one(plan: Plan, python: str, pip: str) -> str:
    """Return a call of pip for what is asked by name, and one each where that fails: none of them stops the build."""
    words = shell.words(plan.python.pip_tried)
    options = pip.partition(" -m pip install ")[2]
    return f"{{ {pip}{words} \\\n      || install-optional-pip {python} {options} --{words}; }}"


def with_option(pip: str, option: str, line: str) -> str:
    """Return a call of pip that gives a package's setup.py an option, and one for a pip of 25.3 or newer.

    Older ones read that spelling and do not heed it. What fails is tried without the option where the package is
    asked for. https://pip.pypa.io/en/stable/news/#v25-3, 2026-11-23.
    """
    package = f"{pip} --no-build-isolation --no-deps"
    older = f"{package} --global-option={quote.shell(option)} {quote.shell(line)}"
    newer = f"{package} --config-settings=--global-option={quote.shell(option)} {quote.shell(line)}"
    failed = quote.shell(f"roslab: {line} cannot be compiled with {option}")
    return f"{{ {older} \\\n      || {newer} \\\n      || echo {failed}; }}"
