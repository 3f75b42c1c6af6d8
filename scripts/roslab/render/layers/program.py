"""Layer 6 of a plain CMake project: its compilation."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import cloned_heads, compiler_cache, secrets, shell, system, workspace

INSTALL = "install-program"
KEEPS_GOING = "make-what-compiles"


def _compiler(variable: str, name: str) -> str:
    """Return the command that names a compiler to CMake, the usual one where the image does not have it."""
    return f'export {variable}="$(command -v {quote.shell(name)} || command -v {"cc" if variable == "CC" else "c++"})"'


def _needed(plan: Plan) -> str:
    """Return the option that says which program has to be there, none for a shell."""
    command = plan.run.command
    return "" if isinstance(command, str) or command[0] == "bash" else f"--program {quote.shell(command[0])} "


def compile_program(plan: Plan) -> str:
    """Compile a plain CMake project as the user."""
    program = plan.workspace.program
    if program is None:
        return ""
    source = f"{workspace.source_folder(plan)}/{program.folder}".rstrip("/")
    build = quote.shell_with_user(f"{workspace.HOME}/{program.build}")
    launchers = compiler_cache.launchers(plan)
    kept = secrets.Secrets(mounts=(compiler_cache.tree_mount(plan),)) if launchers else secrets.NONE
    told = f"{compiler_cache.WITH_CACHE} --told " if launchers else ""
    going = f"{KEEPS_GOING} {_needed(plan)}" if program.keeps_going else ""
    passing = workspace.warnings_pass(plan, quote.shell_with_user(workspace.source_folder(plan)))
    scripts = {KEEPS_GOING: going, system.LENIENT: passing, compiler_cache.WITH_CACHE: told}
    script = "".join(shell.copy_script(name) for name, called in scripts.items() if called)
    run = shell.run(
        *(f"source {setup}" for setup in workspace.setups(plan)),
        f"mkdir --parents {build}",
        f"cd {build}",
        *(_compiler(variable, name) for variable, name in program.compilers),
        f"cmake{workspace.words(program.cmake_options)}{launchers} {quote.shell_with_user(source)}",
        f"{going}{passing}{told}make --jobs={shell.JOBS}{workspace.words(program.arguments)}",
        workspace.TIDY,
        secrets=kept,
        around=cloned_heads.of_day(plan),
    )
    return f"# The program\nUSER ${{NB_USER}}\n{script}{run}"


def install_program(plan: Plan) -> str:
    """Install what was compiled, in the image that keeps it."""
    program = plan.workspace.program
    if program is None or not program.install:
        return ""
    installed = shell.run(f"{INSTALL} {quote.shell_with_user(f'{workspace.HOME}/{program.build}')}")
    return f"USER root\n{shell.copy_script(INSTALL)}{installed}\nUSER ${{NB_USER}}"


def where_pages_have_it(plan: Plan) -> str:
    """Link the build folder as ``build`` in the source, where a README has it: commands and scripts start from there.

    After the compilation, which may list the source's files, and not where the repository has such a folder itself; a
    link of that name that leads nowhere, as to a folder of its author's computer, gives way.
    """
    program = plan.workspace.program
    if program is None or plan.compatible:
        return ""
    link = quote.shell_with_user(f"{workspace.source_folder(plan)}/{program.folder}".rstrip("/") + "/build")
    build = quote.shell_with_user(f"{workspace.HOME}/{program.build}")
    run = shell.run(f"[ -e {link} ] || ln --symbolic --relative --force {build} {link}")
    return f"# The build folder, where a README has it\n{run}"
