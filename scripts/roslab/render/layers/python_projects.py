"""Layer 5, Python's part: the repository's own projects, from its source."""

from __future__ import annotations

import posixpath
from collections.abc import Sequence

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import building, caches, gpu_said, python, secrets, shell
from roslab.values.secret import NETRC


def versions(plan: Plan) -> str:
    """Tell projects the version that they would read from git, in the files that their tools read without it."""
    source = plan.source_version
    if source is None:
        return ""
    lines = [
        "# These take their version from git, which the build does not see: the tag's, as in a source distribution"
    ]
    commands = []
    if source.distributions:
        lines.append(f"ARG SOURCE_VERSION={quote.docker(source.version)}")
        text = "'Metadata-Version: 2.1\\nName: %s\\nVersion: %s\\n'"
        for folder, name in source.distributions:
            file = quote.shell(f"./{folder}/PKG-INFO" if folder else "./PKG-INFO")
            commands.append(f'{{ [ -e {file} ] || printf {text} {quote.shell(name)} "${{SOURCE_VERSION}}" >{file}; }}')
    if source.archives and source.tag:
        lines.append(f"ARG SOURCE_TAG={quote.docker(source.tag)}")
        for folder in source.archives:
            place = quote.shell(f"./{folder}" if folder else ".")
            commands.append(
                f"find {place} -name _version.py -exec sed --in-place --regexp-extended "
                f"\"s|^( *git_refnames = ).[$]Format:%d[$].\\$|\\1'(tag: ${{SOURCE_TAG}})'|\" {{}} +"
            )
    lines += [f"ARG {name}={quote.docker(source.version)}" for name in source.variables]  # later steps see it, no image
    if not (commands or source.variables):
        return ""
    return "\n".join([*lines, *([shell.run(*commands)] if commands else [])])


def projects(plan: Plan) -> str:
    """Install the repository's own Python projects, editable: the reader changes a line and runs it."""
    folders = plan.workspace.python_projects
    if not folders:
        return ""
    isolation = " --no-build-isolation" if plan.python.first else ""
    options = f"{caches.pip_option(plan)}{isolation}{python.pip_options(plan.python.options)}"
    pip = f"{python.interpreter(plan)} -m pip install {options}"
    pip = f"{gpu_said.PATH} {pip}" if any(gpu_said.asked(plan, folder) for folder in folders) else pip
    pip = "".join(f"{name}={quote.shell(flags)} " for name, flags in building.macros(plan)) + pip
    if plan.python.native_parts and NETRC not in plan.secrets:  # a setup.py looks for them at home; root's has a .netrc
        pip = f'HOME="/home/${{NB_USER}}" {pip}'
    unseen = [folder for folder in folders if folder in plan.python.unseen]
    lost = {folder: lines for folder, lines in plan.python.lost_extensions if folder in folders}
    whole = [folder for folder in folders if folder not in (*plan.python.alone, *unseen, *lost)]
    alone = [folder for folder in folders if folder in plan.python.alone and folder not in lost]
    copied = frozenset(plan.python.copied)
    commands = [_if_there(folder, f"{pip}{_own([folder], copied)}{_or_not(folder, plan)}", plan) for folder in unseen]
    if not plan.workspace.ros:
        commands += [_reached(folder, python.interpreter(plan)) for folder in unseen if _stands_for(folder, plan)]
    if whole and set(whole) <= set(plan.python.isolated):  # a package that they require may build beside the others
        commands.append(building.also_with_what_is_there(plan, pip.replace(isolation, "", 1), _own(whole, copied)))
    elif whole:
        commands.append(f"{pip}{_own(whole, copied)}")
    commands += [f"{pip} --no-deps{_own(alone, copied)}"] if alone else []
    for folder, lines in lost.items():
        needs = f"{pip}{shell.words(lines)}" if lines else ""
        commands.append(_or_its_needs(folder, f"{pip}{_own([folder], copied)}", needs, python.interpreter(plan)))
    run = shell.run(*commands, secrets=secrets.for_pip(plan))
    editable = "" if copied.issuperset(folders) else ", editable"
    header = f"{text}\n" if (text := building.older_names(plan)) else ""
    copy = "".join(f"{line}\n" for line in gpu_said.script(commands))
    return f"# The repository's own Python packages{editable}\nUSER root\n{header}{copy}{run}"


def _if_there(folder: str, install: str, plan: Plan) -> str:
    """Return the command that installs a folder of a submodule, which nobody has seen, if it has something for pip.

    A package of ROS for which nothing but an import speaks is left to the tool that builds the workspace.
    """
    unless = ""
    if plan.workspace.ros and folder in plan.python.imported:
        built = quote.shell(f"roslab: {folder} is built with the workspace")
        unless = f"if [ -e {quote.shell(f'./{folder}/package.xml')} ]; then echo {built}; \\\n    el"
    has = " || ".join(f"[ -e {quote.shell(f'./{folder}/{name}')} ]" for name in ("setup.py", "pyproject.toml"))
    left_out = quote.shell(f"roslab: left out: {folder} has neither setup.py nor pyproject.toml")
    return f"{unless}if {has}; then \\\n      {install}; \\\n    else echo {left_out}; fi"


def _or_not(folder: str, plan: Plan) -> str:
    """Return what follows the command of a folder that is left out where pip cannot install it."""
    told = quote.shell(f"roslab: left out: pip cannot install {folder}")
    return f" || echo {told}" if folder in plan.python.imported else ""


def _or_its_needs(folder: str, install: str, needs: str, interpreter: str) -> str:
    """Return the command for a project whose extension lacks something: where it fails, that of what it requires."""
    name = folder if folder not in ("", ".") else "the repository"
    told = f"roslab: left out: pip cannot compile the extension of {name}"
    told += "; what that requires is installed alone" if needs else ""
    then = (f"echo {quote.shell(told)}", needs, _on_path(folder, interpreter))
    otherwise = " \\\n      && ".join(filter(None, then))
    return f"{{ {install} \\\n      || {{ {otherwise}; }}; }}"


def _stands_for(folder: str, plan: Plan) -> bool:
    """Tell whether a folder is that of an imported submodule, and not only its part that has the module's name."""
    return folder in plan.python.imported and folder.rpartition("/")[0] not in plan.python.imported


def _reached(folder: str, interpreter: str) -> str:
    """Return the command that lets Python find such a submodule as a package, or the modules in it, behind all others.

    pip may have nothing to install there, or install it under another name than the code imports.
    """
    return _find_in(folder, ("", "/.."), interpreter)


def _on_path(folder: str, interpreter: str) -> str:
    """Return the command that lets Python find the modules of a folder, and of its ``src``, without an installation."""
    return _find_in(folder, ("", "/src"), interpreter)


def _find_in(folder: str, below: Sequence[str], interpreter: str) -> str:
    inside = "" if folder in ("", ".") else f"/{folder}"
    there = (posixpath.normpath(f"/{inside}{each}").lstrip("/") for each in below)
    places = " ".join(f'"${{PWD}}"{quote.shell(f"/{each}") if each else ""}' for each in there)
    purelib = f"$({interpreter} -c 'import sysconfig; print(sysconfig.get_path(\"purelib\"))')"
    name = quote.shell(f"/roslab{inside.replace('/', '-')}.pth")
    return f"printf '%s\\n' {places} >\"{purelib}\"{name}"


def _own(folders: Sequence[str], copied: frozenset[str]) -> str:
    paths = ((folder, quote.shell(f"./{folder}" if folder not in ("", ".") else ".")) for folder in folders)
    return "".join(f" {path}" if folder in copied else f" --editable {path}" for folder, path in paths)
