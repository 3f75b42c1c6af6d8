"""Libraries that pip's packages need and do not bring, fetched in a stage of their own; and what compiles with them."""

from __future__ import annotations

import posixpath

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import python, secrets, shell
from roslab.render.layers.workspace import HOME
from roslab.values.native_part import NativePart

STAGE = "native-parts"
FOLDER = "/native"
COMPILE = "compile-on-import"


def stage(plan: Plan) -> str:
    """Fetch each library and its key; what does not answer is told, with what then fails."""
    parts = plan.python.native_parts
    if not parts:
        return ""
    lines = [f"FROM base AS {STAGE}"]
    lines.append(shell.apt_install(("ca-certificates", "curl", "unzip"), secrets.for_apt(plan)))
    lines.append(shell.copy_script("fetch-optional").rstrip())
    lines.append(f"WORKDIR {FOLDER}")
    moved_first = sorted(parts, key=lambda part: posixpath.basename(part.folder) == part.unpacks)
    lines += [shell.run(*_fetched(part), comment=f"{part.name} for {part.package}") for part in moved_first]
    return "\n".join(lines)


def _fetched(part: NativePart) -> list[str]:
    above = posixpath.dirname(part.folder)
    file = posixpath.join(above, part.archive.rpartition("/")[2])
    unpacked = quote.shell(posixpath.join(above, part.unpacks))
    folder = quote.shell(part.folder)
    commands = [f"fetch-optional{shell.words((part.archive, file, above))}"]
    if unpacked != folder:
        commands.append(f"if [ -d {unpacked} ]; then mv {unpacked} {folder}; fi")
    commands.append(_told(part, folder, part.name))
    if part.key:
        name, address = part.key
        commands.append(f"fetch-optional{shell.words((address, name))}")
        commands.append(_told(part, quote.shell(name), f"the key of {part.name}"))
    return commands


def _told(part: NativePart, path: str, what: str) -> str:
    why = f"roslab: left out: {what} is missing, and {part.package} does not work without it"
    return f"{{ [ -e {path} ] || echo {quote.shell(why)}; }}"


def bring(plan: Plan) -> str:
    """Bring the libraries to the user's home, before pip builds what asks for them, and say where they are."""
    parts = plan.python.native_parts
    if not parts:
        return ""
    pairs = [(name, f"{HOME}/{path}") for part in parts for name, path in part.variables]
    libraries = "".join(f"{HOME}/{part.folder}/bin:" for part in parts).rstrip(":")
    pairs.append(("LD_LIBRARY_PATH", f'"{libraries}${{LD_LIBRARY_PATH:+:${{LD_LIBRARY_PATH}}}}"'))
    return "\n".join(
        (
            f"# What pip's packages are compiled against and do not bring: {', '.join(each.name for each in parts)}",
            f"COPY --from={STAGE} --chown=${{NB_UID}}:${{NB_UID}} {FOLDER}/ {HOME}/",
            "ENV " + " \\\n    ".join(f"{name}={value}" for name, value in pairs),
        )
    )


def compile_modules(plan: Plan) -> str:
    """Compile the modules that would do so at their first import, where the steps above installed them."""
    if not plan.python.compiled_modules:
        return ""
    calls = [f"{COMPILE} {python.interpreter(plan)} {quote.shell(name)}" for name in plan.python.compiled_modules]
    why = "It compiles itself at its first import, and writes beside itself at each: it becomes the user's\n"
    return f"# {why}USER root\n{shell.copy_script(COMPILE)}{shell.run(secrets.REPEATABLE, *calls)}"


def compile_of_projects(plan: Plan) -> str:
    """Compile those that come with the repository's own projects; one that was there before is only imported."""
    return compile_modules(plan) if plan.workspace.python_projects else ""
