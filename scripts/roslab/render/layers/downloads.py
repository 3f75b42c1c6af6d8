"""Files that the command or the build needs: fetched in a stage of their own, which no edit of the source repeats."""

from __future__ import annotations

from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import secrets, shell
from roslab.render.layers.workspace import HOME, source_folder

STAGE = "downloads"
FOLDER = "/fetched"
AT_HOME = "/fetched-home"
AT_ROOT = "/fetched-system"


def stage(plan: Plan) -> str:
    """Fetch each file; what does not answer, or is too large, is told and left out."""
    files = plan.workspace.downloads
    if not files:
        return ""
    fetched = []
    for file in files:
        below = f"{AT_HOME}/" if file.home else f"{AT_ROOT}/" if file.system else ""
        into = () if file.unpack is None else (f"{below}{file.unpack}", *((str(file.strip),) if file.strip else ()))
        fetched.append(f"fetch-optional{shell.words((file.url, f'{below}{file.path}', *into))}")
    lines = [f"FROM base AS {STAGE}"]
    lines.append(shell.apt_install(("ca-certificates", "curl", "unzip", "xz-utils"), secrets.for_apt(plan)))
    lines.append(shell.copy_script("fetch-optional").rstrip())
    lines += [f"WORKDIR {FOLDER}", shell.run(*fetched)]
    return "\n".join(lines)


def bring(plan: Plan) -> str:
    """Bring the files to where the source is copied afterwards, and those for the home or for the compiler there."""
    blocks = []
    if any(not (file.home or file.system) for file in plan.workspace.downloads):
        folder = source_folder(plan)
        copy = f"COPY --from={STAGE} --chown=${{NB_UID}}:${{NB_UID}} {FOLDER}/ {quote.docker_path(folder)}/"
        made = shell.run(f"mkdir --parents {quote.shell_with_user(folder)}")
        why = "# What the README fetches for the program or its build"
        blocks.append(f"{why}\nUSER ${{NB_USER}}\n{made}\n{copy}\nUSER root")
    if any(file.home for file in plan.workspace.downloads):
        copy = f"COPY --from={STAGE} --chown=${{NB_UID}}:${{NB_UID}} {AT_HOME}/ {HOME}/"
        blocks.append(f"# What the program or its build looks for in the home of its user\n{copy}")
    if any(file.system for file in plan.workspace.downloads):
        blocks.append(f"# Headers that the README fetches\nCOPY --from={STAGE} {AT_ROOT}/ /")
    return "\n".join(blocks)
