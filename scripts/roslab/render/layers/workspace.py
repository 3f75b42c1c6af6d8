"""Layers 4 to 6, the workspace's part: manifests, rosdep, the source, the compilation."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator

from roslab.plan.plan import Plan
from roslab.plan.ros_build import WORKSPACE, RosBuild
from roslab.render import quote
from roslab.render.layers import attempts, cloned_heads, compiler_cache, locks, manifests, prepared, secrets, shell
from roslab.render.layers.called import with_called
from roslab.render.layers.prepared import RAISED, WITHOUT_LACKING
from roslab.render.layers.system import LENIENT

HOME = f"/home/{quote.USER}"
WS = f"{HOME}/{WORKSPACE}"
ROSMAKE = "rosmake-workspace"
"""The script that compiles packages of rosbuild."""
WITHOUT_TESTS = "leave-out-tests"
WITHOUT_DOUBLES = "leave-out-doubles"
DECLARED = "declare-needs"
"""The script that completes package.xml files by what CMake requires of the workspace."""
HOLDING = "clone-holding"
"""The script that keeps a repository where it holds what the workspace lacks."""
HEADERS_FIRST = "headers-first"
REUSES = "reuse-build"
"""The script that compiles once more where a header was not generated in time."""
PLAIN_APART = "plain-apart"
"""The script that compiles packages one by one where a clone brings one that catkin_make refuses."""
UNKNOWN = "clone-unknown"
"""The script that clones what cloned repositories need in turn."""
_LOGS = "-path '*/CMakeFiles/CMake*.log' -o -name CMakeConfigureLog.yaml"
"""CMake's logs, which name random targets, others at each build."""
TIDY = rf"find . \( -name '*.o' -o {_LOGS} \) -delete"
"""Removes what no program needs of a build folder."""


def source_folder(plan: Plan) -> str:
    """Folder of the repository inside the image, with ``${NB_USER}`` for the user's name."""
    return f"{HOME}/{plan.workspace.folder}"


def rosdep(plan: Plan) -> str:
    """Install what the package.xml files name, by rosdep inside the image; name the keys that it does not know."""
    if plan.rosdep is None:
        return ""
    files = manifests.of_rosdep(plan)
    tag, skip = plan.rosdep.rosdistro_tag, " ".join(plan.rosdep.skip_keys)
    old = any(name.endswith("manifest.xml") for name in files)
    before = manifests.copy(plan, files)
    if old:
        before += f"{shell.copy_script('write-package-xml')}RUN write-package-xml {manifests.FOLDER}\n"
    complete, folders = _complete(plan), rosdep_folders(plan)
    if complete and not files:
        folders = folders * 2  # all that is cloned is wanted
    called = [UNKNOWN] if complete else []
    required = _required(plan)
    if required:
        called += ["required-components", "install-optional-apt"]
        before += shell.copy_data((f"cmake-{plan.ubuntu or 'other'}.txt",))
    before += "".join(map(shell.copy_script, with_called(called)))
    return shell.call(
        "install-rosdep-keys",
        (f" --tables {quote.shell(tag)}" if tag else "")
        + (f" --skip {quote.shell(skip)}" if skip else "")
        + complete
        + required
        + "".join(f" {folder}" for folder in folders),
        comment="What the package.xml files name; keys that rosdep does not know stop nothing and are told",
        before=before,
        secrets=secrets.for_both(plan),
        around=locks.apt(plan, "rosdep") + locks.constraints(plan),
    )


def _complete(plan: Plan) -> str:
    """Return the options that clone what cloned repositories need in turn, ``""`` where nothing is cloned."""
    if not completes(plan):
        return ""
    day = next((source.before for source in plan.workspace.sources if source.before), "")
    wanted = f" --want {quote.shell(' '.join(plan.workspace.wanted))}" if plan.workspace.wanted else ""
    return f" --complete{wanted}" + (f" --before {quote.shell(day)}" if day else "")


def completes(plan: Plan) -> bool:
    """Tell whether the build looks for what cloned repositories need in turn."""
    place = plan.workspace
    return bool(plan.rosdep and place.sources) and not plan.compatible and place.folder != WORKSPACE


def _required(plan: Plan) -> str:
    """Return the option that installs what CMake of what is cloned requires, ``""`` where nothing is cloned."""
    place = plan.workspace
    return "" if plan.compatible or not (place.sources or place.submodules) else " --required"


def rosdep_folders(plan: Plan) -> list[str]:
    """Return the folders of the image whose package.xml files name what is installed."""
    folders = [manifests.FOLDER, *_nested(manifests.of_rosdep(plan))] if manifests.of_rosdep(plan) else []
    cloned = [f"{WS}/src"] if plan.workspace.sources else []
    return folders + (cloned or ([source_folder(plan)] if plan.workspace.submodules else []))


def _nested(files: Iterable[str]) -> Iterator[str]:
    """Yield the folders of manifests inside other packages, where rosdep does not look by itself.

    https://github.com/ros-infrastructure/catkin_pkg (packages.py: find_package_paths), 2026-11-25
    """
    folders = {posixpath.dirname(name) for name in files if posixpath.basename(name) == "package.xml"}
    for folder in sorted(folders - {""}):
        above = folder
        while above:
            above = posixpath.dirname(above)
            if above in folders:
                yield quote.shell(posixpath.join(manifests.FOLDER, folder))
                break


def copy_source(plan: Plan) -> str:
    """Copy the repository; the user owns it, and the folders on the way to it, which WORKDIR makes."""
    return f"# The source\n{source_copied(plan)}"


def source_copied(plan: Plan) -> str:
    """Return the lines that copy the source as the user's into the repository's folder."""
    return f"{enter_source(plan)}\nCOPY --chown=${{NB_UID}}:${{NB_UID}} . ."


def enter_source(plan: Plan) -> str:
    """Return the lines that make the repository's folder as the user, and go there."""
    return f"USER ${{NB_USER}}\nWORKDIR {quote.docker_path(source_folder(plan))}"


def old_paths(plan: Plan) -> str:
    """Keep the paths of an old image, which its commands and its README name."""
    if not plan.workspace.links:
        return ""
    commands = (
        f"ln --symbolic {quote.shell(target)} {quote.shell_with_user(f'{HOME}/{name}')}"
        for name, target in plan.workspace.links
    )
    return f"# The paths of the old format's images\nUSER root\n{shell.run(*commands)}"


def set_up_inside(plan: Plan) -> str:
    """Link what the build wrote into the repository's folder, where its scripts look for the setup script."""
    if not plan.workspace.links or plan.compatible:
        return ""
    placed = [(quote.shell_with_user(f"{HOME}/{name}"), quote.shell(target)) for name, target in plan.workspace.links]
    commands = (f"{{ [ -e {path} ] || ln --symbolic {target} {path}; }}" for path, target in placed)
    return f"# Scripts of the repository source the workspace from there\n{shell.run(*commands)}"


def folders_of_data(plan: Plan) -> str:
    """Make the folders in which code of the repository has data, where its source is copied again after the build."""
    build = plan.workspace.ros
    lost = [each for each in build.not_there if each.endswith("/")] if build and build.tool.startswith("catkin") else []
    if not lost:
        return ""
    made = " ".join(quote.shell_with_user(f"{source_folder(plan)}/{each.rstrip('/')}") for each in lost)
    return f"# Folders that git does not keep and in which programs write\n{shell.run(f'mkdir --parents {made}')}"


def setups(plan: Plan) -> list[str]:
    """Return the setup scripts of ROS and of the compiled workspace, each quoted for a shell."""
    found = ['"/opt/ros/${ROS_DISTRO}/setup.bash"'] if plan.workspace.underlay else []
    if plan.workspace.ros:
        found.append(f'"{HOME}/{plan.workspace.ros.setup}"')
    return found


def any_processor(plan: Plan) -> str:
    """Let what is compiled run on all machines of a platform."""
    place = plan.workspace
    if not (place.native or place.without) or not (place.ros or place.program or place.inside or place.scripts):
        return ""
    folder = f"{WS}/src" if place.ros else quote.shell_with_user(source_folder(plan))
    comment = "For every machine of the platform, not only for the one that builds"
    return f"USER ${{NB_USER}}\n{shell.call('any-processor', f' {folder}{words(place.without)}', comment=comment)}"


def compile_workspace(plan: Plan) -> str:
    """Compile the ROS workspace as the user, who can then compile it again."""
    build = plan.workspace.ros
    if build is None:
        return ""
    run = shell.run(
        f"source {setups(plan)[0]}",
        *_commands(plan, build, again=attempts.tried(plan)),
        *_without_logs(build),
        around=cloned_heads.of_day(plan),
    )
    called = (*_scripts(run), *(("compile-jobs", ROSMAKE) if ROSMAKE in run else ()))
    scripts = "".join(map(shell.copy_script, called))
    return f"# The workspace\nUSER ${{NB_USER}}\nWORKDIR {WS}\n{scripts}{run}"


def _scripts(run: str) -> tuple[str, ...]:
    """Return the scripts that a step which compiles the workspace calls, and those that these call."""
    before = (WITHOUT_DOUBLES, WITHOUT_LACKING, prepared.MAKES_FOLDERS, DECLARED, RAISED, WITHOUT_TESTS)
    names = (*before, *attempts.SCRIPTS, PLAIN_APART, LENIENT, HEADERS_FIRST)
    return with_called(name for name in names if name in run)


def _without_logs(build: RosBuild) -> tuple[str, ...]:
    """Return what removes what differs between two builds of a workspace and is not needed to compile it again."""
    folder = "build_isolated" if build.tool == "catkin_make_isolated" else "build"
    return () if build.tool == "rosmake" else (rf"find {folder} \( {_LOGS} \) -delete", "rm -rf log logs")


def compile_again(plan: Plan) -> tuple[str, str]:
    """Compile the ROS workspace with the build tree of the last build, where a cache has kept it.

    Returns what comes before the source, since an edit of that does not concern it, and what comes after.
    """
    build = plan.workspace.ros
    if build is None:
        return enter_source(plan), ""
    kept = secrets.Secrets(mounts=(compiler_cache.tree_mount(plan),))
    run = shell.run(
        f". {setups(plan)[0]}",
        *_commands(plan, build, again=f"{attempts.tried(plan)}{REUSES} "),
        secrets=kept,
        around=cloned_heads.of_day(plan),
    )
    launcher = (compiler_cache.WITH_CACHE,) if compiler_cache.launchers(plan) else ()
    scripts = ("compile-jobs", REUSES, *launcher, *_scripts(run))
    script = f"COPY --from=scripts{''.join(f' /{name}' for name in scripts)} /usr/local/bin/\n"
    return f"{script}{enter_source(plan)}\nWORKDIR {WS}", run.replace(shell.copy_script("compile-jobs"), "")


def _commands(plan: Plan, build: RosBuild, again: str = "") -> list[str]:
    source = source_folder(plan)
    unsure = [without_doubles(build)] if build.unsure else []
    declared = [f"{DECLARED} src"] if build.undeclared else []
    before = [*prepared.not_there(source, build), *prepared.ignoring(source, build), *unsure]
    before += prepared.in_bin(source, build)
    before += [*prepared.lacking(source, build), *prepared.of_clones(plan, build), *declared]
    behind = prepared.executable(build, moved=REUSES in again)
    return [*before, *prepared.raised(plan.workspace, build), *_building(plan, build, again), *behind]


def without_doubles(build: RosBuild) -> str:
    """Return the command that hides packages of clones which others have too."""
    return f"{WITHOUT_DOUBLES}{words(f'src/{name}' for name in build.unsure)}"


def _building(plan: Plan, build: RosBuild, again: str) -> list[str]:
    options, arguments = words(build.cmake_options) + compiler_cache.launchers(plan), words(build.arguments)
    cmake = f" \\\n      --cmake-args{options}" if options else ""
    jobs = shell.jobs(build.jobs)
    passing = warnings_pass(plan, "src") if build.tool != "rosmake" else ""
    first = f"{again}{passing}{HEADERS_FIRST} "
    match build.tool:
        case "catkin_make":
            cloned = plan.workspace.sources or plan.workspace.submodules
            apart = f"{PLAIN_APART} " if cloned and not plan.compatible else ""
            return [f"{again}{apart}{passing}{HEADERS_FIRST} catkin_make -j{jobs}{options}{arguments}"]
        case "catkin_make_isolated":
            return [f"{first}catkin_make_isolated -j{jobs}{arguments}{cmake}"]
        case "catkin_tools":
            catkin = f'{first}catkin build --no-status --jobs "${{jobs}}" --parallel-packages "${{jobs}}"'
            return [f"jobs={jobs}", f"{catkin}{words(build.named)}{cmake}{arguments}"]
        case "rosmake":
            return [f"{ROSMAKE}{arguments}"]
        case "colcon":
            colcon = f'{again}{passing}colcon build --event-handlers console_direct+ --parallel-workers "${{jobs}}"'
            chosen = f" \\\n      --packages-up-to{words(build.named)}" if build.named else ""
            build_all = f'MAKEFLAGS="-j${{jobs}} -l${{jobs}}" \\\n    {colcon}{chosen}{cmake}{arguments}'
            return [*_without_tests(plan, build), shell.SET_JOBS, build_all]


def warnings_pass(plan: Plan, folder: str) -> str:
    """Return what stands before a command that compiles what is in a folder, where a warning may count as an error."""
    return f"{LENIENT} {folder} " if plan.workspace.strict else ""


def _without_tests(plan: Plan, build: RosBuild) -> list[str]:
    """Return the command that leaves the tests of others out, unless somebody says whether tests are compiled."""
    place = plan.workspace
    own = f"{place.folder.removeprefix(WORKSPACE)}/".removeprefix("/")
    folders = [f"src/{source.name}" for source in place.sources] + [f"{own}{folder}" for folder in place.apart]
    said = any("BUILD_TESTING" in option for option in (*build.cmake_options, *build.arguments))
    return [f"{WITHOUT_TESTS}{words(folders)}"] if folders and not said else []


def words(items: Iterable[str]) -> str:
    """Return quoted words that go on a line after others, with folders of the home (``-DX=~/sdk``) at their place."""
    return "".join(f" {_at_home(item) if '=~/' in item else quote.shell(item)}" for item in items)


def _at_home(item: str) -> str:
    return quote.shell_with_user(item.replace("=~/", f"={HOME}/", 1))
