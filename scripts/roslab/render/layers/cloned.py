"""What is cloned: sister packages into the workspace, submodules into the repository."""

from __future__ import annotations

import posixpath

from roslab.config.model import Source
from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import locks, required, secrets, shell
from roslab.render.layers.called import PACKAGES, with_called
from roslab.render.layers.system import BRANCH, CONFIGURE, LENIENT, fetch, prepared
from roslab.render.layers.workspace import HOLDING, WS, completes, source_folder, words
from roslab.values.pattern import pattern

PLAIN = "install-plain-clones"
"""The script that compiles and installs clones in which catkin finds no package."""
LISTED = "clone-listed"
"""The script that clones what a list or a page names, where its host lets anybody."""
TAKES_LISTED = "take-listed"
"""The script that clones what a workspace's repository lists."""
INTERFACES = "take-message-branches"
"""The script that looks for the messages that the code includes."""
_RECORDED = pattern(r"[0-9a-f]{7,40}")
"""A ref that is a commit."""


def large_files(plan: Plan) -> str:
    """Have git fetch the files of Git LFS of what is cloned, where a page does so; what is not served stays a pointer.

    https://github.com/git-lfs/git-lfs/blob/main/docs/man/git-lfs-config.adoc (lfs.skipdownloaderrors), 2026-11-26
    """
    if not plan.workspace.large_files:
        return ""
    steps = "git lfs install --system --skip-repo && git config --system lfs.skipdownloaderrors true"
    comment = "Files of Git LFS in what is cloned"
    return shell.run(f"if command -v git-lfs >/dev/null; then {steps}; fi", comment=comment)


def sister_sources(plan: Plan) -> str:
    """Clone the sister packages into the workspace, each at its ref."""
    sources = plan.workspace.sources
    if not sources:
        return ""
    depends = tuple(dict.fromkeys(d for s in sources for d in s.depends))
    blocks = [shell.apt_install(depends, secrets.for_apt(plan), locks.apt(plan, "sisters"))] if depends else []
    listed = [s for s in sources if _from_list(s)]
    sure = [s for s in sources if not (s.holding or s.lists) and s not in listed]
    sure_runs = [shell.run(*_fetched(plan, s), secrets=secrets.for_git(plan, "user")) for s in sure]
    hiding = with_called([PACKAGES]) if any(s.only for s in sure) else ()
    sure_runs = [*(shell.copy_script(name).rstrip() for name in hiding), *sure_runs]
    runs = ["# Sister packages, from their source", *sure_runs] if sure else []
    runs += _all_listed(plan, listed)
    sought = tuple(dict.fromkeys(name for s in sources for name in s.holding))
    tried = [shell.run(_tried(plan, s, sought), secrets=secrets.for_git(plan, "user")) for s in sources if s.holding]
    if tried:
        why = "# Packages that nothing known brings: what is not there is told and stops nothing"
        runs += [why, *(shell.copy_script(name).rstrip() for name in with_called([HOLDING])), *tried]
    runs += [line for s in sources if s.lists for line in _of_workspace(plan, s)]
    runs += _of_interfaces(plan)
    return "\n".join([*blocks, "USER ${NB_USER}", f"RUN mkdir --parents {WS}/src", *runs, "USER root"])


def _of_workspace(plan: Plan, source: Source) -> list[str]:
    """Return the instructions that clone what a workspace's repository lists."""
    branch = f" --branch {quote.shell(source.ref)}" if source.ref else ""
    day = f" --before {quote.shell(source.before)}" if source.before else ""
    own = f" --but {quote.shell(posixpath.basename(plan.workspace.folder))}"
    where = f"{quote.shell(source.repo or '')} {quote.shell_with_user(f'{WS}/src/{source.name}')}"
    sent = (
        "A list has what this one lists cloned, too" if source.listed else "A page sends the reader to this workspace"
    )
    why = f"# {sent}: what it lists is taken"
    scripts = (shell.copy_script(name).rstrip() for name in with_called([TAKES_LISTED]))
    return [
        why,
        *scripts,
        shell.run(f"{TAKES_LISTED}{branch}{day}{own} {where}", secrets=secrets.for_git(plan, "user")),
    ]


def _of_interfaces(plan: Plan) -> list[str]:
    """Return the instructions that take the branch of a clone which holds the headers that the code includes."""
    place = plan.workspace
    if not place.interfaces:
        return []
    days = {source.before for source in place.sources if source.before}
    before = f" --before {days.pop()}" if len(days) == 1 else ""
    kept = "".join(f" --keep {quote.shell(s.name)}" for s in place.sources if s.ref and not _is_branch(s))
    command = f"{INTERFACES}{before}{kept} {WS}/src{words(place.interfaces)}"
    why = "# The code includes these headers: another branch of a clone may have what the usual one lacks"
    return [why, shell.copy_script(INTERFACES).rstrip(), shell.run(command)]


def _from_list(source: Source) -> bool:
    """Tell whether a source may be one that only its author can clone; what a table changes in it, anybody can."""
    return source.listed and not (source.lists or source.unasked or source.holding or source.prepare or source.zip)


def _all_listed(plan: Plan, sources: list[Source]) -> list[str]:
    """Return the instructions that clone what lists and pages name; root notes what is left out."""
    if not sources:
        return []
    scripts = with_called([LISTED])
    why = "# What lists and pages name: what only its author can clone is told and left out"
    script = _for_ros(LISTED, plan)
    runs = [
        shell.run(_called(f"{script} --plain" if s.unread else script, s), secrets=secrets.for_git(plan))
        for s in sources
    ]
    return [why, "USER root", *(shell.copy_script(name).rstrip() for name in scripts), *runs, "USER ${NB_USER}"]


def _is_branch(source: Source) -> bool:
    return bool(source.ref and BRANCH.fullmatch(source.ref))


def _for_ros(script: str, plan: Plan) -> str:
    """Return the call of a script that takes branches for the ROS of the image, and packages that its tool knows."""
    rosmake = " --rosmake" if plan.workspace.ros and plan.workspace.ros.tool == "rosmake" else ""
    return f"{script} --{plan.kind}{rosmake}" if plan.kind in {"ros1", "ros2"} else script


def _tried(plan: Plan, source: Source, sought: tuple[str, ...]) -> str:
    """Return the call of the script that keeps a repository where it holds what the workspace lacks.

    ``sought``: what is looked for anywhere; it may hold more of that than its name tells.
    """
    more = tuple(name for name in sought if name not in source.holding)
    return (
        f"{_called(_for_ros(HOLDING, plan), source)}{words(source.holding)}{words(('--also', *more)) if more else ''}"
    )


def _called(script: str, source: Source) -> str:
    """Return the call of a script that clones a source."""
    option = "branch" if _is_branch(source) else "ref"
    at = f" --{option} {quote.shell(source.ref)}" if source.ref else ""
    at += f" --before {quote.shell(source.before)}" if source.before else ""
    return f"{script}{at} {quote.shell(source.repo or '')} {quote.shell_with_user(f'{WS}/src/{source.name}')}"


def plain_clones(plan: Plan) -> str:
    """Compile what CMake of the workspace asks for by its name, where it turns out to be no package of ROS.

    So may be what is only tried, and what clones need in turn: the script that clones these notes which.
    """
    folders = [quote.shell_with_user(f"{WS}/src/{s.name}") for s in plan.workspace.sources if s.unread]
    tried = completes(plan) or any(s.holding for s in plan.workspace.sources)
    noted = f" --in {WS}/src" if tried else ""
    if not folders and not noted:
        return ""
    scripts = "".join(map(shell.copy_script, (CONFIGURE, LENIENT, "compile-jobs")))
    comment = "Clones without a package.xml, which catkin passes by"
    words_of_call = noted + "".join(f" {each}" for each in folders)
    return f"USER root\n{shell.call(PLAIN, words_of_call, comment=comment, before=scripts)}"


def submodules(plan: Plan) -> str:
    """Clone what lies in the tree and is not checked out into the folder that the source is copied to afterwards.

    What is private or gone is told and left out, as where the workflows fetch submodules; of a commit that is gone,
    what is there instead is told. A repository that is only tried is left out with its commit. What their own
    CMakeLists.txt requires is installed where CMake compiles the tree.
    """
    if not plan.workspace.submodules:
        return ""
    runs = []
    for source in plan.workspace.submodules:
        folder = quote.shell_with_user(posixpath.normpath(f"{source_folder(plan)}/{source.name}"))
        recorded = _RECORDED.fullmatch(source.ref or "") and not (source.zip or source.unasked)
        fetched = _at_commit(source, folder) if recorded else fetch(plan, source, folder)
        commands = (f"mkdir --parents {folder}", _or_left_out(fetched, source, folder))
        runs.append(shell.run(*commands, secrets=secrets.for_git(plan, "user")))
    head = "# What belongs in the tree and is not checked out: submodules at the commits that the repository records"
    needed = required.in_tree(plan, source_folder(plan))
    return "\n".join([head, "USER ${NB_USER}", *runs, "USER root", *([needed] if needed else [])])


def _at_commit(source: Source, folder: str) -> list[str]:
    """Return the commands that clone a submodule at its commit: what is not there tells of itself what it is."""
    return [
        f"git clone {quote.shell(source.repo or '')} {folder}",
        f"{shell.COMMIT} {folder} {quote.shell(source.ref or '')}",
        f"{shell.SUBMODULES} {folder}",
    ]


def _fetched(plan: Plan, source: Source) -> list[str]:
    folder = quote.shell_with_user(f"{WS}/src/{source.name}")
    commands = prepared(plan, source, folder)
    if source.only:  # launch files alone want them
        needed = f'needed="$({PACKAGES} needed {folder}{words(source.only)} | cut --fields=1)"'
        nothing = (
            f"echo {quote.shell(f'roslab: {source.name} holds no {words(source.only).strip()}: all of it is compiled')}"
        )
        hidden = f'if [ -n "${{needed}}" ]; then {PACKAGES} hide {folder} ${{needed}} >/dev/null; else {nothing}; fi'
        commands = [*commands, needed, hidden]
    return [_or_left_out(commands, source)] if source.unasked else commands


def _or_left_out(commands: list[str], source: Source, folder: str = "") -> str:
    """Return the commands as one that does not fail: what is private or gone is told.

    A repository that is only tried leaves nothing in ``folder``.
    """
    cloned = " \\\n   && ".join(commands)
    told = f"echo {quote.shell(f'roslab: left out: {source.name} cannot be cloned')}"
    if source.unasked and folder:
        told = f"{{ {told} && rm -rf {folder}; }}"
    return f"{{ {cloned}; }} \\\n || {told}"
