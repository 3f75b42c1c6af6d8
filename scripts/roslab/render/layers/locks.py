"""The versions of roslab.lock: each step gets its own, so that a change of one repeats no step before it."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from roslab.plan.locked import Distribution, Package
from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import caches, shell
from roslab.render.layers.shell import Around
from roslab.values.pattern import pattern

FOLDER = "/usr/local/share/roslab/lock"
MACHINES = {"linux/amd64": "x86_64", "linux/arm64": "aarch64"}
"""What Python calls the machines of platforms."""
_FROM_GIT = pattern(r"(git\+[a-z+]+://[^/]+/[^@#]+)(?:@[^#]*)?(#subdirectory=.*)?")
"""The address of a repository, a ref, and a folder in it."""


def apt(plan: Plan, *steps: str) -> Around:
    """Return what pins the packages of steps to their locked versions, for as long as one RUN lasts."""
    lines = apt_lines(plan, lambda package: package.step in (*steps, ""))
    if not lines:
        return shell.NOTHING
    name = f"apt-{steps[0]}"
    return Around(
        before=f"{shell.heredoc(f'{FOLDER}/{name}', lines)}{shell.copy_script('pin-packages')}",
        first=(f"pin-packages {name}",),
        last=("rm /etc/apt/preferences.d/roslab-lock",),
    )


def apt_lines(plan: Plan, wanted: Callable[[Package], bool]) -> str:
    """Return the lines of a list of locked packages: name, version, and the machine where it is that one's alone."""
    machines = plan.lock.machines if plan.lock else ()
    found: dict[tuple[str, str], list[str]] = {}
    for machine in machines:
        for package in machine.apt:
            if wanted(package):
                found.setdefault((package.name, package.version), []).append(machine.platform)
    return "\n".join(
        quote.checked(f"{name} {version}{where}")
        for (name, version), platforms in sorted(found.items())
        for where in ([""] if len(platforms) == len(machines) else [f" {_architecture(each)}" for each in platforms])
    )


def _architecture(platform: str) -> str:
    """Return dpkg's name of a platform's machine."""
    return {"linux/arm/v7": "armhf"}.get(platform, platform.split("/")[1])


def constraints(plan: Plan, environment: str = "image") -> Around:
    """Return what keeps every call of pip in one RUN at an environment's locked versions."""
    lines = sorted({f"{p.name}=={p.version}{m}" for p, m in _packages(plan, environment) if not p.url})
    if not lines:
        return shell.NOTHING
    file = f"{FOLDER}/constraints-{environment}"
    text = "\n".join(map(quote.checked, lines))
    return Around(before=shell.heredoc(file, text), first=(f"export PIP_CONSTRAINT={file}",))


def pip(plan: Plan, python: str, options: str, environment: str = "image") -> tuple[str, tuple[str, ...]]:
    """Return the instruction that brings an environment's locked files, and the commands that install from them.

    What pip checks by a hash and what has none (a commit of git) are installed by two calls, as pip wants all or none.
    What is cloned and installed editable is not among them: ``at_commit`` tells its step.
    """
    cloned = set(map(_place, plan.python.editable))
    packages = [each for each in _packages(plan, environment) if not each[0].url or _place(each[0].url) not in cloned]
    hashed: dict[tuple[str, str, str], dict[str, None]] = {}
    for package, marker in packages:
        if package.hashes:
            hashed.setdefault((package.name, package.version, marker), {}).update(dict.fromkeys(package.hashes))
    checked = [
        f"{name}=={version}{marker} {' '.join(f'--hash={each}' for each in hashes)}"
        for (name, version, marker), hashes in sorted(hashed.items())
    ]
    others = sorted({f"{_unchecked(package)}{marker}" for package, marker in packages if not package.hashes})
    before, commands = "", []
    for name, lines, flag in (("pip", checked, " --require-hashes"), ("pip-unchecked", others, "")):
        if lines:
            file = f"{FOLDER}/{name}-{environment}"
            before += shell.heredoc(file, "\n".join(map(quote.checked, lines)))
            commands.append(
                f"{python} -m pip install {caches.pip_option(plan)} --no-deps{flag}{options} --requirement {file}"
            )
    return before, tuple(commands)


def at_commit(plan: Plan, line: str) -> str:
    """Return a line of pip that names a repository of git with the locked commit in the place of its ref."""
    locked = (package.url for package, _ in _packages(plan, "image") if package.url)
    return next((url for url in locked if _place(url) == _place(line)), line)


def _place(url: str) -> tuple[str, str] | None:
    """Return a repository and a folder in it, without a ref; ``None`` for what is from elsewhere."""
    match = _FROM_GIT.fullmatch(url)
    return (match[1], match[2] or "") if match else None


def conda(plan: Plan) -> tuple[str, str]:
    """Return the instructions that bring the locked list of the conda environment, and its path for each machine."""
    before = ""
    for machine in plan.lock.machines if plan.lock else ():
        if machine.conda:
            lines = "\n".join(("@EXPLICIT", *map(quote.checked, machine.conda)))
            before += shell.heredoc(f"{FOLDER}/conda-{_architecture(machine.platform)}", lines)
    return before, f'{FOLDER}/conda-"$(dpkg --print-architecture)"' if before else ""


def _packages(plan: Plan, environment: str) -> list[tuple[Distribution, str]]:
    """Return the packages of an environment, each with the marker of the machines that it is for."""
    machines = plan.lock.machines if plan.lock else ()
    found: dict[tuple[str, str], list[tuple[Distribution, str]]] = {}
    for machine in machines:
        for each in machine.python:
            if each.name == environment:
                for package in each.packages:
                    found.setdefault((package.name, package.version), []).append((package, machine.platform))
    return [
        (package, "" if len(places) == len(machines) else f"; {_marker([platform])}")
        for places in found.values()
        for package, platform in places
    ]


def _marker(platforms: Iterable[str]) -> str:
    return " or ".join(f"platform_machine == '{MACHINES.get(each, each.split('/')[1])}'" for each in platforms)


def _unchecked(package: Distribution) -> str:
    if package.url.startswith("git+"):
        return f"{package.url}{'&' if '#' in package.url else '#'}egg={package.name}"
    return package.url or f"{package.name}=={package.version}"
