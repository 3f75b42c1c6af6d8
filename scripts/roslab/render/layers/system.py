"""Layers 2 and 3: system packages, and libraries that are built from their source."""

from __future__ import annotations

import posixpath
import shlex

from roslab.config.model import Source
from roslab.knowledge.launched_simulators import launched_simulators
from roslab.plan.packages import asked_files, own_files
from roslab.plan.plan import Plan
from roslab.render import quote
from roslab.render.layers import caches, locks, packaged, patches, required, secrets, shell
from roslab.values.pattern import pattern
from roslab.values.secret import NETRC, SSH

SOURCES = "/tmp/sources"  # noqa: S108 - a folder of the image while it is built
BRANCH = pattern(r"(?![0-9a-f]{7,40}$)(?!.*\d+[._]\d)(?!refs/).+")
"""A ref that is no commit and has no number of a release: a branch, which may be gone."""
CONFIGURE = "configure-library"
"""A script that calls CMake for a library, once more with a newer one where the library asks for it."""
INSTALL_BY_MAKE = "install-by-make"
"""A script that installs a library by its own Makefile."""
LENIENT = "warnings-pass"
"""The script that compiles once more without warnings that count as errors."""
COMPILERS = "compilers"
"""The stage below those of several libraries."""


def first_packages(plan: Plan) -> str:
    """Install what was in every image of the old generators, and ROS."""
    if not plan.apt_first:
        return ""
    installed = shell.apt_install(plan.apt_first, secrets.for_apt(plan), locks.apt(plan, "first"))
    return f"# What every old image had\n{installed}"


def packages(plan: Plan) -> str:
    """Install what is declared; a name that apt does not know stops the build."""
    if not plan.apt:
        return ""
    return f"# System packages\n{shell.apt_install(plan.apt, secrets.for_apt(plan), locks.apt(plan, 'packages'))}"


def tools(plan: Plan) -> str:
    """Install the tools of the workspace, and the pip of Python 2 that old images had."""
    return _where_known(plan, plan.apt_tools, "Tools, where this base's apt knows them", "tools")


def own_packages(plan: Plan) -> str:
    """Install packages that the repository holds or a page fetches; what is for another machine or Ubuntu is told."""
    if not plan.own_packages:
        return ""
    files = own_files(plan.own_packages)
    mounts = (f"--mount=type=bind,source={quote.checked(path)},target={into}" for path, into in files)
    given, around = secrets.for_apt(plan), locks.apt(plan, "own")
    started = sum(each.file in plan.own_packages for each in launched_simulators().values())
    fetched = len(files) + started < len(plan.own_packages)
    said = (
        (bool(files), "the repository holds"),
        (fetched, "a page has its readers fetch"),
        (bool(started), "the default command starts"),
    )
    holder = " or ".join(text for holds, text in said if holds)
    return shell.call(
        "install-own-packages",
        shell.words(asked_files(plan.own_packages)),
        comment=f"Packages that {holder}: none of them stops the build",
        secrets=secrets.Secrets(mounts=(*given.mounts, *mounts), commands=given.commands),
        around=around,
    )


def guessed_packages(plan: Plan) -> str:
    """Install what was only read in code or prose, where the base's apt knows it; name what it does not."""
    comment = "Read in code or prose, declared nowhere: none of them stops the build"
    return _where_known(plan, plan.apt_guessed, comment, "guessed")


def _where_known(plan: Plan, packages: tuple[str, ...], comment: str, step: str) -> str:
    if not packages:
        return ""
    given, around = secrets.for_apt(plan), locks.apt(plan, step)
    return shell.call("install-optional-apt", shell.words(packages), comment=comment, secrets=given, around=around)


def icub(plan: Plan) -> str:
    """Install the iCub's packages where their source still answers: they were given up in 2023.

    https://github.com/orgs/robotology/discussions/612, and components/icub.py of the original ROSLab.
    """
    if not plan.icub or not plan.ubuntu:
        return ""
    comment = "The iCub's packages, where they are still served"
    given, around = secrets.for_apt(plan), locks.apt(plan, "icub")
    return shell.call("install-icub", f" {quote.shell(plan.ubuntu)}", comment=comment, secrets=given, around=around)


def package_data(plan: Plan) -> str:
    """Fetch what packages need and do not bring; where it is not served, that is told and stops nothing."""
    runs = []
    for package, script in plan.package_data:
        left_out = quote.shell(f"roslab: left out: the data of {package} cannot be fetched")
        path = quote.shell(script)
        fetched = f"if [ -x {path} ]; then {path} || echo {left_out}; fi"
        runs.append(shell.run(fetched, comment=f"What {package} needs at its start and does not bring"))
    return "\n".join(runs)


def library_stages(plan: Plan) -> str:
    """Build each library in a stage of its own, on the base and what the libraries before it installed.

    A new system package of the repository therefore rebuilds none of them. What compiles several is installed once.
    """
    common = (
        "build-essential",
        "ca-certificates",
        "cmake",
        "git",
        *(("openssh-client",) if SSH in plan.secrets else ()),
    )
    stages: list[str] = []
    below = "base"
    if plan.libraries[1:]:
        below = COMPILERS
        stages.append(f"FROM base AS {below}\n{shell.apt_install(common, secrets.for_apt(plan))}")
    for index, library in enumerate(plan.libraries):
        lines = [f"FROM {below} AS {stage_name(index, library)}"]
        unpacks = ("curl", "unzip") if library.zip else ()  # as `fetch` does
        depends = tuple(dict.fromkeys((*common, *unpacks, *library.depends)))
        more = tuple(name for name in depends if below == "base" or name not in common)
        if more:
            lines.append(shell.apt_install(more, secrets.for_apt(plan)))
        earlier = plan.libraries[:index]
        offered = (*(name for each in earlier for name in each.instead), *library.offered)
        lines += _offered(plan, library, offered, depends)
        lines += [f"COPY --from={stage_name(i, each)} /installed/ /" for i, each in enumerate(earlier)]
        fetched, given = _fetch(plan, library), secrets.for_git(plan)
        reads = required.reads(library)
        if given.mounts or reads or library.patches:  # what is compiled has no part in them
            cloned = _told(library, fetched, "cloned")
            lines.append(packaged.run(plan, library, cloned, patches.mounted(library, given)))
            fetched = []
        if reads:
            lines.append(required.of_library(plan, library, f"{SOURCES}/{library.name}"))
        by_make = library.by_make or library.unread  # what nobody has read may have a Makefile alone
        for script in (CONFIGURE, LENIENT) * _by_script(plan, library) + (INSTALL_BY_MAKE,) * by_make:
            lines.append(shell.copy_script(script).rstrip())
        compiled = _told(library, [*fetched, *_compile(plan, library, "export DESTDIR=/installed")], "compiled")
        needed = secrets.for_pip(plan) if library.build == "pip" else secrets.NONE
        lines.append(packaged.run(plan, library, compiled, needed, "mkdir --parents /installed"))
        stages.append("\n".join(lines))
    return "\n\n".join(stages)


def _offered(plan: Plan, library: Source, offered: tuple[str, ...], there: tuple[str, ...]) -> list[str]:
    """Return the instruction that installs what a page installs before it builds a library, as far as apt knows it.

    So it is with the packages of libraries before it that are not compiled where apt has them.
    """
    names = [name for name in dict.fromkeys(offered) if name not in there]
    if not names:
        return []
    comment = f"What is installed before {library.name} where its author's page or CI builds it"
    return [shell.call("install-optional-apt", shell.words(names), comment=comment, secrets=secrets.for_apt(plan))]


def _told(library: Source, commands: list[str], step: str) -> list[str]:
    """Return the commands, so that the failure of a library that nobody has read is told, with what named it.

    Of one that nothing requires it stops nothing.
    """
    if not commands or not (library.unasked or required.reads(library)):
        return commands
    tried = " \\\n && ".join(commands)
    if library.unasked:
        why = "cannot be built, which nothing that must be there requires"
        why = f"was looked for in {library.repo}, and cannot be cloned or built" if library.holding else why
        left_out = quote.shell(f"roslab: left out: {library.name} {why}")
        return [f"{{ ( {tried} ) || {{ rm -rf /installed; echo {left_out}; }}; }}"]
    where = f", which {library.place.file}:{library.place.line} names," if library.place else ""
    stops = quote.shell(
        f"roslab: {library.name} of {library.repo}{where} cannot be {step}: the build stops, see above why"
    )
    return [f"{{ {{ {tried}; }} \\\n || {{ echo {stops} >&2; exit 1; }}; }}"]


def libraries(plan: Plan) -> str:
    """Bring the libraries out of their stages into the image."""
    if not plan.libraries:
        return ""
    copies = "\n".join(
        f"COPY --from={stage_name(i, library)} /installed/ /" for i, library in enumerate(plan.libraries)
    )
    return f"# Libraries built from their source\n{copies}\nRUN ldconfig{required.in_image(plan)}"


def libraries_in_place(plan: Plan) -> str:
    """Build the libraries in the image itself, as the old formats did."""
    return "\n\n".join(_in_place(plan, library) for library in plan.libraries)


def stage_name(index: int, library: Source) -> str:
    """Name of a library's stage: a valid one for any library name, unlike every other."""
    slug = "".join(c if c.isalnum() and c.isascii() else "-" for c in library.name.lower()).strip("-")
    return f"library-{index + 1}-{slug}" if slug else f"library-{index + 1}"


def _in_place(plan: Plan, library: Source) -> str:
    keep = [f"cp --recursive {_folder(library)} /home/${{NB_USER}}/"] if library.keep_source else []
    around = locks.apt(plan, "libraries")
    depends = f"{shell.apt_install(library.depends, secrets.for_apt(plan), around)}\n" if library.depends else ""
    comment = f"{library.name}, from its source"
    return depends + shell.run(
        *_fetch(plan, library),
        *_compile(plan, library),
        "ldconfig",
        *keep,
        f"rm -rf {_folder(library)}",
        comment=comment,
        secrets=secrets.for_pip(plan) if library.build == "pip" else secrets.for_git(plan),
    )


def _folder(library: Source) -> str:
    return quote.shell(f"{SOURCES}/{library.name}")


def _fetch(plan: Plan, library: Source) -> list[str]:
    folder = _folder(library)
    return [f"mkdir --parents {SOURCES}", *prepared(plan, library, folder), *patches.applied(library, folder)]


def prepared(plan: Plan, source: Source, folder: str) -> list[str]:
    """Return the commands that fetch a source and change in it what its row of a table says."""
    return fetch(plan, source, folder) + ([f"(cd {folder} && {source.prepare})"] if source.prepare else [])


def fetch(plan: Plan, source: Source, folder: str) -> list[str]:
    """Return the commands that bring a source into an already quoted folder, whose parent is there."""
    if not source.zip:
        return clone(source, folder)
    curl = f"curl {'--netrc ' if NETRC in plan.secrets else ''}--fail --silent --show-error --location"
    url = quote.shell(source.zip)
    tar = source.zip.endswith((".tgz", ".tar.gz"))
    unpack = "tar --extract --gzip --directory /tmp/archive --file" if tar else "unzip -q -d /tmp/archive"
    if source.zip_arm64:
        arm64 = quote.shell(source.zip_arm64)
        url = f'"$(case "$(dpkg --print-architecture)" in arm64) echo {arm64} ;; *) echo {url} ;; esac)"'
    # The archive's own top folder is not always named as its file: strip it, whatever it is called
    return [
        "mkdir --parents /tmp/archive",
        f"{curl} --output /tmp/archive.packed {url}",
        f"{unpack} /tmp/archive.packed",
        f"mv /tmp/archive/* {folder}",
        "rm -rf /tmp/archive /tmp/archive.packed",
    ]


def clone(source: Source, folder: str) -> list[str]:
    """Return the commands that clone a source at its ref, with an author's all its submodules, else those there are."""
    commands = [f"git clone {quote.shell(source.repo or '')} {folder}"]
    if source.ref and BRANCH.fullmatch(source.ref):
        commands.append(f"{shell.CHECKOUT} {folder} {quote.shell(source.ref)}")
    elif source.ref:
        commands.append(f"git -C {folder} -c advice.detachedHead=false checkout {quote.shell(source.ref)}")
    if source.before:
        until = quote.shell(f"{source.before}T23:59:59Z")
        found = f'commit="$(git -C {folder} rev-list --max-count=1 --first-parent --before={until} HEAD)"'
        commands += [found, f'git -C {folder} -c advice.detachedHead=false checkout "${{commit:-HEAD}}"']
    by_author = not (source.unread or source.tabled or source.unasked)
    whole = f"git -C {folder} submodule update --init --recursive"
    return [*commands, whole if by_author else f"{shell.SUBMODULES} {folder}"]


def _by_script(plan: Plan, library: Source) -> bool:
    """Tell whether a failed call of CMake is made once more; an author's own, and an old format's, is made as it is."""
    return not plan.compatible and (library.unread or library.tabled)


def _compile(plan: Plan, library: Source, *first: str) -> list[str]:
    folder = _folder(library)
    if library.build == "pip":
        return [f"python3 -m pip install {caches.pip_option(plan)} {folder}"]
    if library.build != "cmake":
        return []
    if library.by_make:
        inside = posixpath.join(SOURCES, library.name, library.cmake_folder or "").rstrip("/")
        return [f"cd {quote.shell(inside)}", f"{INSTALL_BY_MAKE} {shell.JOBS}"]
    options = "".join(f" {quote.shell(word)}" for word in shlex.split(library.cmake_options))
    passing = f"{LENIENT} {folder} " if _by_script(plan, library) else ""
    make = library.make_command or f"{passing}make --jobs={shell.JOBS} install"
    return [
        f"mkdir --parents {folder}/build",
        f"cd {folder}/build",
        f"{CONFIGURE if _by_script(plan, library) else 'cmake'}{options} {quote.shell(library.cmake_folder or '../')}",
        *first,
        f"{{ {make}; }}" if library.make_command else make,
    ]
