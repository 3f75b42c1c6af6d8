"""Layer 4, Python's part: an environment, what is declared, what was guessed, JupyterLab."""

from __future__ import annotations

from collections.abc import Sequence

from roslab.knowledge.tools import OLD_METADATA, python2_installers, tool_image
from roslab.plan.plan import Plan
from roslab.plan.python import installs
from roslab.render import quote
from roslab.render.layers import building, caches, conda_lines, locks, manifests, secrets, shell
from roslab.values.version import Version, minor_of

GET_PIP = "https://bootstrap.pypa.io/pip/2.7/get-pip.py"
NUMBERED_SINCE = "3.9"
"""The first Python whose ``venv`` makes ``python3.9`` beside ``python3``: https://bugs.python.org/issue39656."""
DOWNLOADS = "/tmp/pip-downloads"  # noqa: S108 - a folder of the image while it is built
"""Of the pip that a conda environment calls, removed in the same step."""


def environment(plan: Plan) -> str:
    """Make the Python environment: the base's own interpreter, a virtual one over it, or a conda one."""
    python = plan.python
    if python.manager == "conda":
        return _conda(plan)
    if python.manager == "venv":
        return "\n".join(
            (
                "# A virtual environment of the user's own; the base's Python packages stay visible in it",
                "ENV VIRTUAL_ENV=/opt/venv \\\n    PATH=/opt/venv/bin:${PATH}",
                shell.run(
                    secrets.REPEATABLE,
                    *_venv("/opt/venv"),
                    *_numbered(python.version, "/opt/venv"),
                    "sed --in-place '/^include-system-site-packages/s/false/true/' /opt/venv/pyvenv.cfg",
                    *_upgrades(plan),
                    around=locks.constraints(plan),
                ),
            )
        )
    lines = []
    installed = installs(plan.python)
    if installed or plan.rosdep or plan.compatible:
        lines.append("# The image is the environment: packages go beside the distribution's own")
        lines.append("ENV PIP_BREAK_SYSTEM_PACKAGES=1")
    if plan.compatible:
        return "\n".join((*lines, _both_pips(plan)))
    if installed and plan.python_tools.pinned:
        # An old distribution's pip knows no wheels of today, and today's pip does not run on its Python
        lines.append(shell.run(secrets.REPEATABLE, *_upgrades(plan), around=locks.constraints(plan)))
    return "\n".join(lines)


def _upgrades(plan: Plan) -> tuple[str, ...]:
    """Return the commands that bring pip and what it builds with; where only packages are of a day, pip is not."""
    upgrade, tools = f"{interpreter(plan)} -m pip install --no-cache-dir --upgrade", plan.python_tools.installers
    own = tuple(line for line in tools if line.startswith("pip"))
    first_alone = plan.python_tools.pip_first
    if plan.python.day or first_alone:
        others = tuple(line for line in tools if line not in own)
        first = upgrade.replace(" --no-cache-dir", "") if first_alone else upgrade
        return f"{first}{shell.words(own)}", *secrets.of_pip_day(plan), f"{upgrade}{shell.words(others)}"
    # What is pinned may be newer than the day
    return *(() if plan.python_tools.pinned else secrets.as_of(plan)), f"{upgrade}{shell.words(tools)}"


def _venv(folder: str) -> tuple[str, str]:
    """Return the commands that make a virtual environment with a pip of its own.

    ``venv`` itself calls ensurepip without Python's variables, one of which makes compiled modules the same each time.
    """
    return f"python3 -m venv --without-pip {folder}", f"{folder}/bin/python -m ensurepip --upgrade --default-pip"


def _numbered(version: str | None, folder: str) -> tuple[str, ...]:
    """Return the command that makes ``python3.8``, which a page may start: it would be the base's, without packages."""
    number = minor_of(version or "")
    if number is None or Version(number) >= Version(NUMBERED_SINCE):
        return ()
    return (f"ln --symbolic python3 {folder}/bin/python{number}",)


def _both_pips(plan: Plan) -> str:
    """Bring both pips to the newest versions that their Pythons run: older ones install packages that do not run there.

    ``pip`` is Python 3's, as it was; where the author has packages for Python 2 it becomes Python 2's with them.
    """
    return f"""\
RUN {secrets.REPEATABLE} \\
 && if python2 -m pip --version >/dev/null 2>&1; then \\
      python2 -m pip install --no-cache-dir --upgrade{_words(python2_installers())}; \\
    fi; \\
    python3 -m pip install --no-cache-dir --upgrade{shell.words(plan.python_tools.installers)}"""


def constraints(plan: Plan) -> str:
    """Keep out what newer versions no longer have, in every later call of pip and in the reader's own too."""
    if not plan.python.bounds:
        return ""
    file = "/usr/local/share/roslab/constraints.txt"
    why = "# Newer versions no longer have what the code uses, or are not what it was written for\n"
    text = why + "\n".join(map(quote.checked, plan.python.bounds))
    return f"{shell.heredoc(file, text)}\nENV PIP_CONSTRAINT={file}"


def interpreter(plan: Plan) -> str:
    """Name of the interpreter that the packages are for."""
    return "python2" if (plan.python.version or "").startswith("2") else "python3"


def _conda(plan: Plan) -> str:
    python = plan.python
    pip = f"pip<{OLD_METADATA}" if python.day else "pip"
    copy, source = "", f"--channel conda-forge {quote.shell(f'python={python.version}')} {quote.shell(pip)}"
    if python.conda_specs:
        channels = "".join(f" --channel {quote.shell(channel)}" for channel in python.conda_channels)
        source = f"{channels.lstrip()}{shell.words((*conda_lines.specs(python), pip))}"
    elif python.conda_file:
        copy = manifests.copy(plan, manifests.of_conda(plan))
        source = f"--file {quote.shell(f'{manifests.FOLDER}/{python.conda_file}')}"
    without = conda_lines.changed(python, f"{manifests.FOLDER}/{python.conda_file}")
    of_page = () if python.conda_specs else python.conda_channels
    further = ",".join((*of_page, *(["defaults"] if python.conda_defaults else ())))
    more = f"CONDA_CHANNELS={quote.shell(further)} " if further else ""
    if python.conda_limits:  # they hold only for what is taken: arm64 has no mkl
        more += f"MAMBA_PINNED_PACKAGES={quote.shell(','.join(python.conda_limits))} "
    if python.conda_cuda:
        more += f"CONDA_OVERRIDE_CUDA={quote.shell(python.conda_cuda)} "
    lists, file = locks.conda(plan)
    pip_part = _conda_pip(plan)
    for script in (conda_lines.UNFOLD, conda_lines.TAKE):
        if any(command.startswith(f"{script} ") for command in without):
            copy = shell.copy_script(script) + copy
    if file:
        copy, source, without = lists, f"--file {file}", ()
    old = f"{interpreter(plan)} -m pip install --no-cache-dir {quote.shell(python.setuptools)}"
    after = (*pip_part, *([old] if python.setuptools else ()))
    create = (
        f"{more}PIP_CACHE_DIR={DOWNLOADS} micromamba create --yes --quiet --prefix /opt/conda {source}",
        "micromamba clean --all --yes --quiet",
        *(secrets.helped(plan) if after else ()),
        *after,
        f"rm -rf {DOWNLOADS}",
    )
    return (
        "# A conda environment: the author's own, or for a Python that the base does not have\n"
        f"COPY --from={tool_image('micromamba')} /bin/micromamba /usr/local/bin/micromamba\n{copy}"
        "ENV MAMBA_ROOT_PREFIX=/opt/mamba \\\n    CONDA_PREFIX=/opt/conda \\\n    PATH=/opt/conda/bin:${PATH}\n"
        + shell.run(*without, *create, secrets=secrets.for_conda(plan, pip=bool(pip_part)))
    )


def _conda_pip(plan: Plan) -> tuple[str, ...]:
    """Return the commands for the ``pip:`` part of a conda file; none where roslab.lock has it."""
    _, file = locks.conda(plan)
    return () if file else conda_lines.pip_part(plan, interpreter(plan), pip_options(plan.python.options))


def locked(plan: Plan) -> str:
    """Install exactly the files of roslab.lock; the steps below then find that everything is there."""
    options = pip_options((*plan.python.options, *plan.python.pip_options))
    before, commands = locks.pip(plan, interpreter(plan), options)
    if not commands:
        return ""
    why = "# Python packages of roslab.lock: the steps below find them installed\n"
    return f"{why}{before}{shell.run(*commands, secrets=secrets.for_pip(plan))}"


def packages(plan: Plan) -> str:
    """Install the declared packages from the manifests alone, so that an edit of the source reuses the layer."""
    python = plan.python
    blocks = []
    pip = f"{interpreter(plan)} -m pip install {caches.pip_option(plan)}{pip_options(python.options)}"
    there = python.manager == "conda" and bool(_conda_pip(plan))
    commands = [f"{pip}{shell.words(python.first)}"] if python.first and not there else []
    commands += [building.with_option(pip, option, line) for line, option in python.cuda_options]
    by_then = (*python.pip_tried, *(python.conda_instead if there else ()))
    required = [line for line in python.pip if line not in by_then]
    if isolated := [line for line in required if line not in python.beside]:
        words = f"{pip_options(python.pip_options)}{shell.words(_arguments(isolated))}"
        commands.append(building.also_with_what_is_there(plan, pip, words))
    if beside := [line for line in required if line in python.beside]:
        commands.append(building.with_what_is_there(pip, f"{pip_options(python.pip_options)}{shell.words(beside)}"))
    if commands:
        blocks.append(shell.run(*commands, comment="Python packages that are declared", secrets=secrets.for_pip(plan)))
    if python.pip_tried:
        tried = shell.run(building.also_one_by_one(plan, interpreter(plan), pip), secrets=secrets.for_pip(plan))
        why = "# Of a file that pip refuses: together, else one by one"
        blocks.append(f"{why}\n{shell.copy_script('install-optional-pip')}{tried}")
    if python.requirements:
        files = "".join(f" --requirement {quote.shell(f'{manifests.FOLDER}/{name}')}" for name in python.requirements)
        copy = manifests.copy(plan, manifests.of_pip(plan))
        install = building.also_with_what_is_there(plan, pip, files)
        if python.beside_files:  # where these cannot be had, the files alone
            install = f"{{ {pip}{_words(python.beside_files)}{files} \\\n      || {install}; }}"
        run = shell.run(install, secrets=secrets.for_pip(plan))
        blocks.append(f"# Requirement files\n{copy}{run}")
    if python.python2:
        options = pip_options(python.python2_options)
        blocks.append(
            shell.run(
                f"if ! python2 -m pip --version >/dev/null 2>&1; then curl --fail --silent {GET_PIP} | python2; fi",
                f"python2 -m pip install --no-cache-dir --upgrade{_words(python2_installers())}",
                "ln --symbolic --force pip2 /usr/local/bin/pip",
                f"python2 -m pip install {caches.pip_option(plan)}{options}{shell.words(_arguments(python.python2))}",
                comment="Packages of Python 2",
                secrets=secrets.for_pip(plan),
            )
        )
    return "\n\n".join(blocks)


def guessed_packages(plan: Plan) -> str:
    """Install what is imported but declared nowhere, one by one: a wrong guess is named and breaks nothing."""
    python = plan.python
    if not python.pip_guessed:
        return ""
    options = f"{caches.pip_option(plan)}{pip_options(python.options)}"
    beside, editable, by_name, bare = python.beside, python.editable, python.by_name, python.bare
    lines = (
        f"{'--no-build-isolation=' * (line in beside)}{'--no-deps=' * (line in bare)}{'--by-name=' * (line in by_name)}"
        + (f"--editable={locks.at_commit(plan, line)}" if line in editable else line)
        for line in python.pip_guessed
    )
    return shell.call(
        "install-optional-pip",
        f" {interpreter(plan)} {options} --{shell.words(lines)}",
        comment="Imported or named in a page, declared nowhere else: none of them stops the build",
        before=shell.copy_script("clone-editable") if editable else "",
        secrets=secrets.for_tries_of_pip(plan),
    )


def jupyter(plan: Plan) -> str:
    """Install JupyterLab with a bash kernel in an environment of its own: it disturbs no package of the author's."""
    if not plan.notebook:
        return ""
    pip = "/opt/jupyter/bin/python -m pip install --no-cache-dir"
    programs = shell.words(f"/opt/jupyter/bin/{name}" for name in ("jupyter", "jupyter-lab", "jupyter-notebook"))
    before, files = locks.pip(plan, "/opt/jupyter/bin/python", "", "jupyter")
    around = locks.constraints(plan, "jupyter")
    return shell.run(
        secrets.REPEATABLE,
        *_venv("/opt/jupyter"),
        f"{pip} --upgrade{shell.words(plan.python_tools.installers)}",
        *files,
        f"{pip}{shell.words(plan.python_tools.jupyter)}",
        "/opt/jupyter/bin/python -m bash_kernel.install --sys-prefix",
        f"ln --symbolic --target-directory=/usr/local/bin{programs}",
        comment="JupyterLab with a bash kernel; docker_run.sh --notebook starts it",
        around=shell.Around(before=before) + around,
    )


def pip_options(options: Sequence[str]) -> str:
    """Return options of pip as quoted words, each after a space."""
    return "".join(f" {quote.shell(word)}" for option in options for word in option.split())


def _words(items: Sequence[str]) -> str:
    return "".join(f" {quote.shell(item)}" for item in items)


def _arguments(lines: Sequence[str]) -> list[str]:
    """Split requirement lines that carry a flag of pip (``-U matplotlib``) into words; others stay one word."""
    return [word for line in lines for word in (line.split() if line.startswith("-") else [line])]
