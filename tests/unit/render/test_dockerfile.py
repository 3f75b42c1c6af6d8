"""The Dockerfile's layers: their order, what each format's commands mean, and that no value becomes an instruction."""

from __future__ import annotations

import dataclasses
import json
import os
import re
import shutil
import subprocess
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from roslab.config.model import Base, Config, Custom, Source
from roslab.decide.decision import Decision, OwnScript
from roslab.decide.python.compiling import Compiling
from roslab.decide.python.image_python import Python
from roslab.errors import ConfigurationError
from roslab.pipeline import plan_repository
from roslab.plan.plan import Plan, from_json, image_name, make_plan, to_json
from roslab.render import image_scripts
from roslab.render.dockerfile import OLD_FORMATS, TODAY, dockerfile
from roslab.render.layers import python, python_projects
from roslab.render.layers.manifests import MOST_COPIES
from roslab.values.requirement_line import stated


def decision(**changes: Any) -> Decision:
    ros1 = Decision(
        kind="ros1",
        ros_distro="noetic",
        ubuntu="focal",
        base_image="ros:noetic-ros-base",
        build_tool="catkin_make",
        rosdep=("roscpp",),
        python=Python(version="3.8", manager="system"),
        packages=("talker/package.xml",),
        package_names=("talker",),
        workspace="overlay",
    )
    return dataclasses.replace(ros1, **changes)


def plan(config: Config | None = None, **changes: Any) -> Plan:
    return make_plan(decision(**changes), config or Config(), folder_name="Paper")


def written(found: Plan) -> str:
    """Return the Dockerfile without the stage of scripts that are the same in every image."""
    text = dockerfile(found)
    carried = re.search(r"^FROM scratch AS scripts\n(?:.|\n)*?\n(?=FROM )", text, re.MULTILINE)
    assert carried
    return text.replace(carried[0], "")


def positions(text: str, *parts: str) -> list[int]:
    missing = [part for part in parts if part not in text]
    assert not missing, f"{missing} not in\n{text}"
    return [text.index(part) for part in parts]


CERES = Source(name="ceres", repo="https://example.org/ceres.git", ref="1.14.0", depends=("libgoogle-glog-dev",))
SISTER = Source(name="sister", repo="https://example.org/sister.git", ref="v1", build="catkin_make")


def test_layers_go_from_rarely_to_often_changing() -> None:
    python = Python(version="3.8", manager="system", pip=(stated("numpy==1.17"),))
    text = written(plan(apt=("libeigen3-dev",), apt_guessed=("libglew-dev",), source=(CERES, SISTER), python=python))
    order = positions(
        text,
        "FROM ros:noetic-ros-base AS base",
        " create-user",
        "FROM base AS library-1-ceres",
        "FROM base AS dependencies\n",
        "libeigen3-dev",
        "libglew-dev",
        "COPY --from=library-1-ceres",
        "sister.git",
        "COPY talker/package.xml /tmp/manifests/talker/",
        " && install-rosdep-keys",
        "numpy==1.17",
        "FROM dependencies AS compiled\n",
        " install-ccache\n",
        "USER ${NB_USER}\nWORKDIR /home/${NB_USER}/ws/src/paper\nWORKDIR /home/${NB_USER}/ws\n",
        "COPY --from=source --chown=${NB_UID}:${NB_UID} / /home/${NB_USER}/ws/src/paper/\nRUN ",
        "catkin_make -j",
        "COPY --from=compiled --chown=${NB_UID}:${NB_UID} /home/${NB_USER}/built/ /home/${NB_USER}/ws/",
        "COPY --chown=${NB_UID}:${NB_UID} . .",
        "ENTRYPOINT",
        "CMD",
    )
    assert order == sorted(order)
    assert "# syntax" not in text


def test_both_orders_have_every_block_of_python() -> None:
    own = {python.environment, python.jupyter, python.constraints, python.packages, python.guessed_packages}
    own |= {python_projects.versions, python_projects.projects}
    for order in (TODAY, OLD_FORMATS):
        assert own <= {*order.image, *order.source}
        assert order.source.index(python_projects.versions) < order.source.index(python_projects.projects)


def test_a_new_system_package_rebuilds_no_library() -> None:
    before, after = (dockerfile(plan(apt=apt, source=(CERES,))) for apt in ((), ("libopencv-dev",)))
    stage = re.compile(r"FROM base AS library-1-ceres\n.*?\n\n\n", re.DOTALL)
    assert stage.findall(before) == stage.findall(after) != []
    assert before.partition("FROM base AS library")[0] == after.partition("FROM base AS library")[0]


def test_declared_packages_stop_the_build_and_guessed_ones_are_named() -> None:
    text = written(plan(apt=("libeigen3-dev",), apt_guessed=("libglew-dev",)))
    declared, guessed = text.split("# Read in code or prose")
    assert "apt-get install --yes --no-install-recommends libeigen3-dev" in declared
    assert "libglew-dev" not in declared
    assert "    install-optional-apt libglew-dev\n" in guessed


def test_what_is_tried_because_a_module_has_its_name_is_told_to_the_script() -> None:
    guessed = (stated("numpy"), stated("rarelySeen"), stated("often-seen==2"))
    by_name = tuple(each.key for each in guessed[1:])
    python = Python(version="3.8", manager="system", pip_guessed=guessed, by_name=by_name)
    text = written(plan(python=python)).replace("\\\n", "")
    assert "numpy --by-name=rarelySeen often-seen==2" in " ".join(text.split())


def test_what_is_installed_without_its_own_list_is_told_to_the_script() -> None:
    guessed = (stated("numpy"), stated("argoverse @ git+https://github.com/argoverse/argoverse-api"))
    text = written(plan(python=Python(version="3.8", manager="system", pip_guessed=guessed))).replace("\\\n", "")
    line = "numpy '--no-deps=argoverse @ git+https://github.com/argoverse/argoverse-api'"
    assert line in " ".join(text.split())


@pytest.mark.parametrize(("name", "linked"), [("Paper", True), ("paper", False)])
def test_a_link_of_the_repository_s_own_spelling_stands_beside_its_folder(name: str, *, linked: bool) -> None:
    bare: dict[str, Any] = {"build_tool": "none", "packages": (), "workspace": "none", "kind": "python"}
    text = dockerfile(plan(author_folders=((f"~/{name}", "source"),), ros_distro=None, **bare))
    assert ("ln --symbolic /home/${NB_USER}/paper /home/${NB_USER}/Paper;" in text) is linked
    assert ("Files name these folders" in text) is linked


def test_a_declared_package_that_a_page_builds_beside_torch_is_isolated_only_where_that_fails() -> None:
    pip = (stated("numpy==1.21.6"), replace(stated("git+https://github.com/lab/sdf"), beside=True))
    text = written(plan(python=Python(version="3.8", manager="system", pip=pip)))
    assert re.search(
        r"&& \{ python3 -m pip install \S+ --no-build-isolation git\+https://github.com/lab/sdf \\\n"
        r"      \|\| python3 -m pip install \S+ git\+https://github.com/lab/sdf; \}",
        text,
    )


def test_what_a_file_asks_for_that_pip_refuses_is_tried_one_by_one() -> None:
    pip = (stated("numpy==1.21.6"), stated("bzip2==1.0.8"))
    text = written(plan(python=Python(version="3.8", manager="system", pip=pip, pip_tried=pip[1:])))
    declared, tried = text.split("# Of a file that pip refuses")
    assert "numpy==1.21.6" in declared.rpartition("# Python packages that are declared")[2]
    assert "bzip2" not in declared
    assert re.search(
        r"pip install .* bzip2==1.0.8 \\\n      \|\| install-optional-pip python3 .* -- bzip2==1.0.8; }", tried
    )


def test_a_script_is_carried_where_it_is_used_and_copied_once_in_a_stage() -> None:
    carried = re.compile(r"<<'EOF' /([\w-]+)$", re.MULTILINE)
    python = Python(version="3.8", manager="system", pip_guessed=(stated("numpy"),))
    plain = dockerfile(plan(build_tool="none", packages=(), kind="python", ros_distro=None))
    assert carried.findall(plain) == ["create-user", "renew-package-sources"]
    full = plan(Config(base=Base(cmake_update="3.18.4")), apt_guessed=("libglew-dev",), python=python, source=(CERES,))
    text = dockerfile(full)
    names = [
        "create-user",
        "renew-package-sources",
        "compile-jobs",
        "install-optional-apt",
        "install-rosdep-keys",
        "install-optional-pip",
        "pip-cache",
        "ask-pip-again",
        "install-wheel-libraries",
    ]
    assert carried.findall(text) == [*names, "roslab-entrypoint", "reuse-build", "headers-first"]
    library, image = text.split("\nFROM base AS library-1-ceres\n")[1].split("\nFROM base AS dependencies\n")
    image = image.partition("\nFROM dependencies AS compiled\n")[0]
    for stage in (library, image):
        assert stage.count("COPY --from=scripts /compile-jobs") == 1
        assert stage.index("COPY --from=scripts /compile-jobs") < stage.index("$(compile-jobs)")


def test_each_library_has_the_scripts_that_it_calls() -> None:
    other = replace(CERES, name="sophus", repo="https://example.org/sophus.git", depends=())
    text = dockerfile(plan(source=(CERES, other)))
    stages = re.split(r"\nFROM \w+ AS library-", text)[1:]
    assert len(stages) == 2
    for stage in stages:
        assert stage.index("COPY --from=scripts /compile-jobs") < stage.index("$(compile-jobs)")


def test_what_compiles_several_libraries_is_installed_once() -> None:
    other = replace(CERES, name="sophus", repo="https://example.org/sophus.git", depends=("libfmt-dev",))
    alone, both = dockerfile(plan(source=(CERES,))), dockerfile(plan(source=(CERES, other)))
    assert "AS compilers" not in alone
    common, *stages = re.split(r"\nFROM compilers AS library-", both.partition("\nFROM base AS compilers\n")[2])
    assert re.findall(r"^ {6}([\w-]+)", common, re.MULTILINE) == ["build-essential", "ca-certificates", "cmake", "git"]
    assert len(stages) == 2
    assert " libfmt-dev " in stages[1].partition("git clone")[0]
    assert not any("build-essential" in stage.partition("\nFROM ")[0] for stage in stages)


def test_a_library_that_is_fetched_as_a_zip_has_what_unpacks_it() -> None:
    archive = replace(CERES, name="torch", repo=None, ref=None, zip="https://example.org/torch.zip", depends=())
    zipped, cloned = re.split(r"\nFROM \w+ AS library-", dockerfile(plan(source=(archive, CERES))))[1:]
    for tool in ("curl", "unzip"):
        installed = re.compile(rf"^ +{tool}( |$)", re.MULTILINE)
        assert installed.search(zipped.partition("&& curl")[0])
        assert not installed.search(cloned.partition("\nFROM ")[0])


def test_every_script_is_called_by_some_dockerfile() -> None:
    folder = Path(image_scripts.__path__[0])
    calls = "".join(path.read_text() for path in folder.parent.rglob("*.py"))
    names = sorted(path.stem for path in folder.glob("*.sh"))
    assert "create-user" in names
    assert [name for name in names if not re.search(rf"""["'/]{name}["' ]""", calls)] == []


def test_a_new_script_repeats_no_step_before_its_first_use() -> None:
    """BuildKit compares what `COPY --from` brings by content: all before the first use must be the same text."""
    before, after = (written(plan(apt=("git",), apt_guessed=guessed)) for guessed in ((), ("libglew-dev",)))
    first = "COPY --from=scripts /install-optional-apt"
    assert before.startswith(
        after.partition(f"# Read in code or prose, declared nowhere: none of them stops the build\n{first}")[0]
    )


def test_manifests_are_copied_by_name_each_step_its_own() -> None:
    python = Python(version="3.8", manager="system", requirements=("a b/req.txt",), manifests=("a b/more.txt",))
    text = written(plan(packages=("package.xml", "b/package.xml"), python=python))
    rosdep, pip = text.split(" && install-rosdep-keys /tmp/manifests")
    assert "COPY package.xml /tmp/manifests/\nCOPY b/package.xml /tmp/manifests/b/\n" in rosdep
    assert "req.txt" not in rosdep, "an edit of the requirements repeats nothing of rosdep's"
    assert 'COPY ["a b/more.txt", "a b/req.txt", "/tmp/manifests/a b/"]\n' in pip
    assert "--requirement '/tmp/manifests/a b/req.txt'" in pip
    assert "manifests AS" not in text


@pytest.mark.parametrize(
    ("count", "stage_of", "first"),
    [
        (5, "scratch", "COPY part_0/package.xml /tmp/manifests/part_0/\n"),
        (50, "scratch", "COPY part_0/package.xml /tmp/manifests/part_0/\n"),
        # What no build file names repeats nothing here either
        (51, "base", "RUN --mount=type=bind,from=source,target=/repository "),
    ],
)
def test_many_manifests_are_one_layer(count: int, stage_of: str, first: str) -> None:
    names = tuple(f"part_{number}/package.xml" for number in range(count))
    text = written(plan(packages=names))
    stage, image = text.split(f"\nFROM {stage_of} AS manifests\n")[1].split("\nFROM base AS dependencies\n")
    assert stage.startswith(first)
    assert all(name in stage for name in names)
    assert "package.xml" not in image.replace("# What the package.xml files name", "")
    assert "COPY --from=manifests /tmp/manifests/ /tmp/manifests/\n" in image


def test_what_no_build_file_names_is_blank_for_the_compilation_and_whole_in_the_image() -> None:
    found = plan()
    found = replace(found, workspace=replace(found.workspace, unread=("README.md", "docs")))
    text = dockerfile(found)
    assert "FROM scratch AS source\nCOPY . /\nCOPY --link <<README.md <<docs /\nREADME.md\ndocs\n" in text
    compiled, image = text.split("\nFROM dependencies AS compiled\n")[1].split("\nFROM dependencies\n")
    assert "COPY --from=source --chown=${NB_UID}:${NB_UID} / /home/${NB_USER}/ws/src/paper/" in compiled
    assert "COPY --chown=${NB_UID}:${NB_UID} . ." in image
    assert "RUN" not in image, "an edit of these repeats no step"


def test_no_folder_is_blank_in_which_a_manifest_lies() -> None:
    lists = Python(version="3.8", manager="system", manifests=("docs/requirements.txt",))
    found = decision(packages=("talker/package.xml", "test/sync/package.xml"), python=lists)
    made = make_plan(found, Config(), folder_name="paper", unread=("README.md", "docs", "media", "test"))
    assert made.workspace.unread == ("README.md", "media")


def test_a_repository_that_is_a_workspace_is_copied_before_what_was_compiled() -> None:
    """It may hold a folder devel of its own."""
    found = plan()
    text = dockerfile(replace(found, workspace=replace(found.workspace, folder="ws")))
    image = text.split("\nFROM dependencies\n")[1]
    assert image.index("COPY --chown=${NB_UID}:${NB_UID} . .") < image.index("COPY --from=compiled ")


def test_what_needs_the_source_in_the_image_is_compiled_there() -> None:
    custom = Custom(commands=("make a",), as_root=False, chained=False, workdir="home")
    text = dockerfile(plan(Config(custom=custom)))
    assert "AS compiled" not in text
    assert "reuse-build" not in text
    assert "headers-first catkin_make -j" in text


@pytest.mark.parametrize(("place", "apart"), [("source/bin", False), ("source/", False), ("build/bin", True)])
def test_programs_that_are_written_into_the_source_are_compiled_where_it_stays(place: str, apart: bool) -> None:
    made = plan(
        kind="cpp",
        ros_distro=None,
        base_image="ubuntu:22.04",
        build_tool="cmake",
        workspace="none",
        packages=(),
        package_names=(),
        rosdep=(),
        program_folders=(place,),
    )
    text = dockerfile(made)
    assert "cmake -D" in text
    assert ("AS compiled" in text) == apart
    link = "/home/${NB_USER}/paper/build"
    linked = f"RUN [ -e {link} ] || ln --symbolic --relative --force /home/${{NB_USER}}/paper-build {link}\n"
    assert linked in text
    assert text.index("cmake -D") < text.index(linked), "CMake lists no file twice"
    assert text.index("COPY --chown=${NB_UID}:${NB_UID} . .") < text.index(linked)


@pytest.mark.parametrize(
    ("there", "to"), [(None, "../paper-build"), ("/nowhere/else", "../paper-build"), ("../own", "../own")]
)
def test_the_link_of_the_build_folder_takes_no_place_of_what_is_there(
    tmp_path: Path, there: str | None, to: str
) -> None:
    (tmp_path / "demo").mkdir()
    for name in ("CMakeLists.txt", "main.cpp"):
        (tmp_path / "demo" / name).write_text("project(a)\nadd_executable(a main.cpp)\n")
    text = dockerfile(plan_repository(tmp_path / "demo", folder_name="paper").plan)
    line = next(each for each in text.splitlines() if each.startswith("RUN [ -e ")).removeprefix("RUN ")
    for name in ("paper", "own", "paper-build"):
        (tmp_path / name).mkdir()
    link = tmp_path / "paper/build"
    if there:
        link.symlink_to(there)
    shell = shutil.which("bash") or pytest.skip("bash is not here")
    subprocess.run([shell, "-ec", line.replace("/home/${NB_USER}", str(tmp_path))], check=True)
    assert str(link.readlink()) == to


@pytest.mark.parametrize(
    ("tool", "command", "setup"),
    [
        ("catkin_make", "catkin_make -j", "ws/devel/setup.bash"),
        ("catkin_make_isolated", "catkin_make_isolated -j", "ws/devel_isolated/setup.bash"),
        ("catkin_tools", "catkin build --no-status", "ws/devel/setup.bash"),
        ("colcon", "colcon build", "ws/install/setup.bash"),
    ],
)
def test_each_build_tool(tool: str, command: str, setup: str) -> None:
    text = dockerfile(plan(build_tool=tool))
    assert command in text
    assert setup in text
    assert "-DCMAKE_BUILD_TYPE=Release" in text


def test_the_image_runs_as_the_user_with_the_source_at_hand() -> None:
    lines = dockerfile(plan(command=("roslaunch", "talker", "a b.launch"))).splitlines()
    assert lines[-8:] == [
        "USER ${NB_USER}",
        "WORKDIR /home/${NB_USER}/ws/src/paper",
        "COPY --from=compiled --chown=${NB_UID}:${NB_UID} /home/${NB_USER}/built/ /home/${NB_USER}/ws/",
        "COPY --chown=${NB_UID}:${NB_UID} . .",
        "",
        "ENV HOME=/home/${NB_USER} USER=${NB_USER} LOGNAME=${NB_USER}",
        'ENTRYPOINT ["roslab-entrypoint"]',
        'CMD ["roslaunch", "talker", "a b.launch"]',
    ]


def test_a_command_given_as_text_runs_in_bash() -> None:
    assert dockerfile(plan(command="cd x && ./run")).endswith('CMD ["bash", "-c", "cd x && ./run"]\n')


@pytest.mark.parametrize("changes", [{}, {"apt": ("git",), "source": (CERES,)}, {"kind": "python", "packages": ()}])
def test_the_slim_image_is_made_of_the_whole_one_and_starts_as_it_does(changes: dict[str, Any]) -> None:
    config = Config(slim=True, env=(("DEPTH", "3"),), skip_keys=("gazebo",))
    text = written(plan(config, **changes))
    image, pruned, slim, whole = (text.index(f"\nFROM {each}") for each in _slim_stages(text))
    assert image < pruned < slim < whole
    assert text[slim:].startswith("\nFROM scratch AS slim\nCOPY --from=pruned / /\n")
    assert text.endswith("\nFROM image\n"), "a build without a target makes the whole image"
    variables = re.compile(r"^ENV (?:.*\\\n)*.*$", re.MULTILINE)
    assert set(variables.findall(text[:pruned])) <= set(variables.findall(text[slim:whole]))
    assert "ENV ROS_DISTRO=noetic" in text[slim:whole]
    assert len(started := re.findall(r"^(?:CMD|WORKDIR|USER) .*$", text[slim:whole], re.MULTILINE)) == 3
    assert all(line in text[image:pruned] for line in started)
    assert 'ENTRYPOINT ["roslab-entrypoint"]' in text[slim:whole]


def _slim_stages(text: str) -> tuple[str, str, str, str]:
    image = re.search(r"\nFROM (\S+ AS image\n)", text)
    assert image
    return image[1], "image AS pruned\n", "scratch AS slim\n", "image\n"


def test_of_the_manifests_a_slim_image_keeps_what_running_needs() -> None:
    found = written(make_plan(decision(skip_keys=("gazebo",)), Config(slim=True), folder_name="Paper"))
    assert "RUN keep-what-runs --skip gazebo /tmp/manifests\n" in found
    assert "AS slim" not in written(plan())


def test_an_authors_dockerfile_has_no_slim_image() -> None:
    with pytest.raises(
        ConfigurationError, match="`slim` is made of a generated Dockerfile, and docker/Dockerfile is built"
    ):
        plan(Config(slim=True), dockerfile="docker/Dockerfile")


def test_the_papers_custom_runs_one_by_one_as_the_user_at_home() -> None:
    custom = Custom(commands=("make a", "make b"), as_root=False, chained=False, workdir="home")
    text = dockerfile(plan(Config(file="roslab.yaml", generation="paper", compatible="paper", name="x", custom=custom)))
    before, after = text.split("\nWORKDIR /home/${NB_USER}\nRUN make a\nRUN make b")
    assert re.findall(r"^USER .*", before, re.MULTILINE)[-1] == "USER ${NB_USER}"
    assert "\nWORKDIR /home/${NB_USER}/ws/src/x\n" in after


def test_the_later_custom_is_one_chain_as_root() -> None:
    custom = Custom(commands=("cd $HOME/x", "make"), as_root=True, chained=True, workdir="root")
    text = dockerfile(
        plan(Config(file="roslab.yaml", generation="later", compatible="later", notebook=True, name="x", custom=custom))
    )
    assert re.search(r"USER root\nWORKDIR /\nRUN cd \$HOME/x \\\n && make\n", text)


def test_old_formats_build_libraries_in_place_after_pythons_packages() -> None:
    python = Python(version="3.5", manager="system", pip=(stated("scipy"),))
    config = Config(
        file="roslab.yaml",
        generation="later",
        compatible="later",
        notebook=True,
        name="x",
        base=Base(cmake_update="3.18.4"),
    )
    text = written(plan(config, source=(CERES,), python=python))
    jupyter, libraries = ("/opt/jupyter", "cmake-3.18.4.tar.gz"), ("example.org/ceres.git", " && install-rosdep-keys")
    order = positions(text, *jupyter, "scipy", *libraries)
    assert order == sorted(order)
    assert "AS library-" not in text
    assert "CMAKE_BUILD_TYPE" not in text


def test_an_archive_is_unpacked_whatever_its_top_folder_is_called() -> None:
    source = Source(name="opencv", zip="https://example.org/opencv/archive/3.3.0.zip", cmake_options="-DA='b c'")
    text = dockerfile(plan(source=(source,)))
    assert "mv /tmp/archive/* /tmp/sources/opencv" in text
    assert "'-DA=b c'" in text


HOSTILE = 'x\'; rm -rf ~; $(touch /pwned) `id` "${HOME}" #'


@pytest.mark.parametrize(
    "changes",
    [
        {"apt": (HOSTILE,)},
        {"apt_guessed": (HOSTILE,)},
        {"skip_keys": (HOSTILE,)},
        {"packages": (HOSTILE, *(f"{number}/x" for number in range(MOST_COPIES)))},
        {"source": (Source(name="x", repo=HOSTILE, ref=HOSTILE),)},
        {
            "python": Python(
                version="3.8", manager="venv", pip=(stated(HOSTILE),), requirements=(HOSTILE,), projects=(HOSTILE,)
            )
        },
    ],
    ids=lambda changes: next(iter(changes)),
)
def test_no_value_leaves_its_quotes(changes: dict[str, Any]) -> None:
    text = dockerfile(plan(**changes))
    quoted = HOSTILE.replace("'", "'\"'\"'")
    assert quoted in text
    assert HOSTILE not in text


def test_no_manifest_leaves_its_copy() -> None:
    text = dockerfile(plan(packages=(HOSTILE,)))
    (line,) = [line for line in text.splitlines() if "rm -rf ~" in line]
    assert line.startswith('COPY ["')
    source, _ = json.loads(line.removeprefix("COPY "))
    assert re.sub(r"\\(.)", r"\1", source) == HOSTILE


@pytest.mark.parametrize(
    "changes",
    [
        {"apt": ("a\nRUN evil",)},
        {"base_image": "ubuntu:24.04\nRUN evil"},
        {"command": ("a\0",)},
        {"packages": ("a\nb/package.xml",)},
    ],
    ids=lambda changes: next(iter(changes)),
)
def test_a_newline_in_a_value_is_an_error(changes: dict[str, Any]) -> None:
    with pytest.raises(ConfigurationError):
        dockerfile(plan(**changes))


def test_a_plan_survives_its_json() -> None:
    custom = Custom(commands=("make",), as_root=True, chained=True, workdir="source")
    config = Config(file="roslab.yaml", name="x", custom=custom, env=(("A", "b c"),), test="true")
    whole = plan(config, source=(CERES,), platforms_refused=(("linux/arm64", "no wheel"),))
    assert from_json(to_json(whole)) == whole
    assert to_json(whole) == to_json(from_json(to_json(whole)))


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"version": 2}', '{"version": 1}', "[" * 100_000])
def test_what_is_no_plan_is_refused(text: str) -> None:
    with pytest.raises(ConfigurationError):
        from_json(text)


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("SqueezeSegV2", "squeezesegv2"),
        ("a b/ç", "a-b"),
        ("-x-", "x"),
        ("--", "image"),
        ("a._b", "a_b"),
        ("a__b", "a_b"),
    ],
)
def test_every_text_gives_an_image_name(text: str, name: str) -> None:
    assert image_name(text) == name


def test_a_sister_is_prepared_after_its_clone_and_gives_the_workspace_its_options() -> None:
    sister = dataclasses.replace(SISTER, prepare="cp a.xml package.xml", cmake_options="-DEDITION='R 1'")
    text = dockerfile(plan(source=(sister,)))
    clone, prepare, build = positions(text, "git clone", "cp a.xml package.xml", "catkin_make -j")
    assert clone < prepare < build
    assert "'-DEDITION=R 1'" in text[build:].splitlines()[0]


def test_the_tests_of_sisters_are_not_compiled() -> None:
    sister = dataclasses.replace(SISTER, build="colcon")
    with_sister: dict[str, Any] = {"source": (sister,), "ros_distro": "jazzy", "build_tool": "colcon"}
    text = dockerfile(plan(**with_sister))
    assert " && leave-out-tests src/sister \\\n" in text
    scripts = "/compile-jobs /reuse-build /with-ccache /leave-out-doubles /make-installed-folders /declare-needs"
    scripts += " /raise-standard /leave-out-tests /leave-out-failed /build-needed /warnings-pass"
    scripts += " /read-manifest /required-by-cmake /workspace-packages"
    assert f"COPY --from=scripts {scripts} /usr/local/bin/" in text
    launchers = "-DCMAKE_C_COMPILER_LAUNCHER=with-ccache -DCMAKE_CXX_COMPILER_LAUNCHER=with-ccache"
    assert f"{launchers} -DCMAKE_TARGET_MESSAGES=OFF" in text
    for stated_by in (
        dockerfile(plan(Config(cmake_options="-DBUILD_TESTING=ON"), **with_sister)),
        dockerfile(plan(**{**with_sister, "source": ()})),
    ):
        assert "leave-out-tests" not in stated_by


def test_the_tests_of_submodules_are_not_compiled() -> None:
    changed = plan(ros_distro="jazzy", build_tool="colcon")
    place = dataclasses.replace(changed.workspace, apart=("deps/part",))
    text = dockerfile(dataclasses.replace(changed, workspace=place))
    folder = place.folder.removeprefix("ws").lstrip("/")
    assert f" && leave-out-tests {folder}/deps/part \\\n" in text


def test_packages_that_a_sister_has_twice_are_hidden_before_the_build() -> None:
    text = dockerfile(plan(source=(SISTER,)))
    clone, hidden, build = positions(text, "git clone", " && leave-out-doubles src/sister \\\n", "catkin_make -j")
    assert clone < hidden < build
    known = dataclasses.replace(SISTER, repo="https://github.com/ethz-asl/eigen_catkin.git")
    assert "leave-out-doubles src" not in dockerfile(plan(source=(known,)))
    assert "leave-out-doubles src" not in dockerfile(plan(Config(compatible="later"), source=(SISTER,)))


def test_packages_that_two_clones_have_are_hidden_before_rosdep_reads_them() -> None:
    other = dataclasses.replace(SISTER, name="other", repo="https://example.org/other.git")
    text = written(plan(source=(SISTER, other)))
    first, second = (match.start() for match in re.finditer("leave-out-doubles src/sister src/other", text))
    clone, rosdep = positions(text, "other.git", " && install-rosdep-keys")
    assert clone < first < rosdep < second
    assert text.count("leave-out-doubles src/sister") == 2
    alone = written(plan(source=(SISTER,)))
    assert alone.index("leave-out-doubles src/sister") > alone.index(" && install-rosdep-keys")


def test_submodules_are_cloned_before_sisters_whose_packages_they_may_have() -> None:
    submodule = dataclasses.replace(SISTER, name="deps/part", repo="https://example.org/part.git")
    text = written(plan(source=(SISTER,), submodules=(submodule,)))
    part, sister, hidden, rosdep = positions(
        text, "part.git", "sister.git", "leave-out-doubles src/sister", " && install-rosdep-keys"
    )
    assert part < sister < hidden < rosdep


def test_colcon_is_told_of_each_sister(tmp_path: Path) -> None:
    """The listing is what colcon prints; what colcon makes of the file is seen in the lab's builds with sisters."""
    (tmp_path / "colcon").write_text("#!/bin/sh\nprintf 'beta\\nalpha_msgs\\n'\n")
    (tmp_path / "colcon").chmod(0o755)
    script = Path(image_scripts.__path__[0]) / "leave-out-tests.sh"
    environment = {"PATH": f"{tmp_path}:{os.environ['PATH']}"}
    subprocess.run(["bash", script, "src/gone"], cwd=tmp_path, env=environment, check=True)
    assert not (tmp_path / "colcon.meta").exists()
    (tmp_path / "src/sisters").mkdir(parents=True)
    subprocess.run(["bash", script, "src/gone", "src/sisters"], cwd=tmp_path, env=environment, check=True)
    off = {"cmake-args": ["-DBUILD_TESTING=OFF"]}
    assert json.loads((tmp_path / "colcon.meta").read_text()) == {"names": {"alpha_msgs": off, "beta": off}}


def test_how_pip_builds(plan: Callable[..., Plan]) -> None:
    text = dockerfile(
        plan(
            manager="conda",
            conda_file="environment.yml",
            conda_defaults=True,
            cuda_architectures="7.0;7.5+PTX",
            cuda_variables=(("TCNN_CUDA_ARCHITECTURES", "70;75"),),
        )
    )
    assert "ENV PIP_PREFER_BINARY=1" in text
    assert '\n    TORCH_CUDA_ARCH_LIST="7.0;7.5+PTX" \\\n    TCNN_CUDA_ARCHITECTURES="70;75"\n' in text
    assert " && CONDA_CHANNELS=defaults PIP_CACHE_DIR=/tmp/pip-downloads micromamba create" in text
    assert " && rm -rf /tmp/pip-downloads" in text
    assert "TORCH_CUDA_ARCH_LIST" not in dockerfile(plan())


def test_a_package_that_sees_no_gpu_is_told_by_an_option_before_the_rest(plan: Callable[..., Plan]) -> None:
    text = dockerfile(
        plan(first=("torch",), cuda_options=(("MinkowskiEngine", "--force_cuda"),), requirements=("requirements.txt",))
    )
    told = text.index("--no-build-isolation --no-deps --global-option=--force_cuda MinkowskiEngine \\\n")
    assert "--config-settings=--global-option=--force_cuda MinkowskiEngine \\\n" in text
    assert "|| echo 'roslab: MinkowskiEngine cannot be compiled with --force_cuda'; }" in text
    assert text.index(" torch \\\n") < told < text.index("--requirement /tmp/manifests")


def test_old_extensions_are_compiled_with_the_macros_that_they_need(plan: Callable[..., Plan]) -> None:
    flags = "CPPFLAGS=-DAT_CHECK=TORCH_CHECK NVCC_APPEND_FLAGS=-DAT_CHECK=TORCH_CHECK"
    installed = dockerfile(plan(python_projects=("ops",), defines=("AT_CHECK=TORCH_CHECK",)))
    assert f" && {flags} python3 -m pip install" in installed
    assert "ENV CPPFLAGS" not in installed
    by_script = dockerfile(plan(defines=("AT_CHECK=TORCH_CHECK",)))
    assert "\nENV CPPFLAGS=-DAT_CHECK=TORCH_CHECK \\\n    NVCC_APPEND_FLAGS=-DAT_CHECK=TORCH_CHECK\n" in by_script
    assert "CPPFLAGS" not in dockerfile(plan())


@pytest.mark.parametrize("projects", [(), ("ops",)])
def test_a_macro_with_arguments_stands_in_a_header(plan: Callable[..., Plan], projects: tuple[str, ...]) -> None:
    text = dockerfile(plan(python_projects=projects, defines=("A=B", "STREAM(...)=now()")))
    header = text.index("/usr/local/share/roslab/older-names.h\n#define A B\n#define STREAM(...) now()\nEOF\n")
    for name in ("CPPFLAGS", "NVCC_APPEND_FLAGS"):
        assert text.rindex(f"{name}=") > header
    assert text.count("-include /usr/local/share/roslab/older-names.h") == 2
    assert "-DA=B" not in text


def test_pip_compiles_with_what_the_base_lacks() -> None:
    def apt(**changes: Any) -> tuple[str, ...]:
        python = Python(version="3.10", manager=changes.pop("manager", "venv"), pip=(stated("mpi4py"),))
        values = {"kind": "python", "ubuntu": "jammy", "base_image": "ubuntu:22.04", **changes}
        compiling = Compiling(compiler=True)
        decision = Decision(ros_distro=None, build_tool="pip", python=python, compiling=compiling, **values)
        return make_plan(decision, Config(), folder_name="a").apt

    assert {"build-essential", "python3-dev"} < set(apt())
    assert "python3-dev" not in apt(manager="conda")
    assert "python3-dev" not in apt(base_image="python:3.7-slim-bookworm", ubuntu=None)
    assert "build-essential" not in apt(kind="cuda", base_image="nvidia/cuda:11.8.0-devel-ubuntu22.04")


def test_a_conda_file_has_its_pip_part_installed_by_the_environment(plan: Callable[..., Plan]) -> None:
    """Its own Python serves the index of pip's day: a base without Python got the packages of today."""
    text = dockerfile(
        plan(manager="conda", conda_file="conda/environment.yml", day="2021-05-04", setuptools="setuptools<66")
    )
    parts = (
        "take-pip-part /tmp/manifests/conda/environment.yml \\\n",
        "micromamba create --yes --quiet --prefix /opt/conda --file /tmp/manifests/conda/environment.yml \\\n",
        '&& eval "$(index-as-of 2021-05-04 --or-today)" \\\n',
        'python3 -m pip install "$(pip-cache)" --upgrade --requirement environment.yml.pip)',
        "&& python3 -m pip install --no-cache-dir 'setuptools<66' \\\n",
    )
    places = [text.index(part) for part in parts]
    assert places == sorted(places)
    assert text.count("index-as-of 2021") == 1
    without = dockerfile(plan(manager="conda", conda_file="environment.yml", conda_pip=False, day="2021-05-04"))
    assert "take-pip-part" not in without
    assert "index-as-of" not in without


def test_what_the_pip_part_of_a_conda_file_is_compiled_with_comes_before_it(plan: Callable[..., Plan]) -> None:
    first = ("numpy==1.16.1", "Cython<3")
    text = dockerfile(plan(manager="conda", conda_file="environment.yml", first=first))
    parts = ("micromamba create", "numpy==1.16.1", "--upgrade --requirement environment.yml.pip")
    places = [text.index(part) for part in parts]
    assert places == sorted(places)
    assert "--no-build-isolation --upgrade --requirement environment.yml.pip" in text
    assert text.count("numpy==1.16.1") == 1
    alone = dockerfile(plan(manager="conda", conda_file="environment.yml", conda_pip=False, first=first))
    assert alone.index("# Python packages that are declared") < alone.index("numpy==1.16.1")


def test_the_pip_part_of_a_conda_file_has_the_index_of_the_build_for_the_image_s_cuda(
    plan: Callable[..., Plan],
) -> None:
    option = "--find-links https://download.pytorch.org/whl/cu110/torch_stable.html"
    text = dockerfile(plan(manager="conda", conda_file="environment.yml", options=(option,)))
    assert f'"$(pip-cache)" {option} --upgrade --requirement environment.yml.pip' in text


def test_conda_takes_packages_for_the_gpu_while_no_driver_is_there(plan: Callable[..., Plan]) -> None:
    text = dockerfile(plan(manager="conda", conda_file="environment.yml", conda_cuda="11.3"))
    assert "CONDA_OVERRIDE_CUDA=11.3 PIP_CACHE_DIR=" in text
    assert "CONDA_OVERRIDE_CUDA" not in dockerfile(plan(manager="conda", conda_file="environment.yml"))


def test_conda_installs_what_a_manifest_of_pixi_names(plan: Callable[..., Plan]) -> None:
    made = plan(
        manager="conda",
        conda_file="pixi.toml",
        conda_specs=("python=3.11.*", "numpy<2"),
        conda_channels=("conda-forge",),
    )
    text = dockerfile(made)
    assert "--prefix /opt/conda --channel conda-forge" in text
    assert "'numpy<2'" in text
    assert "COPY pixi.toml" not in text
    assert "--file /tmp/manifests" not in text


@pytest.mark.parametrize(
    ("specs", "added"),
    [
        (("numpy<2", "python-dateutil"), True),
        (("numpy<2", "python=3.11.*"), False),
        (("conda-forge::python>=3.9", "numpy"), False),
        (("python", "numpy"), False),
    ],
)
def test_conda_takes_the_decided_python_where_no_package_names_one(
    plan: Callable[..., Plan], specs: tuple[str, ...], *, added: bool
) -> None:
    channels = ("conda-forge",)
    made = plan(manager="conda", conda_file="pixi.toml", conda_specs=specs, conda_channels=channels)
    text = dockerfile(made)
    assert (" python=3.12 " in " ".join(text.replace("\\\n", " ").split())) is added


def test_a_script_that_compiles_is_run_as_root_and_stops_nothing() -> None:
    script = OwnScript(folder="lib", path="lib/make.sh", command="bash make.sh")
    venv = Python(version="3.10", manager="venv")
    found = plan(
        kind="python",
        ros_distro=None,
        base_image="ubuntu:22.04",
        ubuntu="jammy",
        build_tool="pip",
        python=venv,
        packages=(),
        package_names=(),
        rosdep=(),
        workspace="none",
        scripts=(script,),
    )
    text = written(found)
    run = "RUN cd /home/${NB_USER}/paper/lib \\\n && { bash make.sh || echo 'roslab: left out: bash make.sh failed'; }"
    source, root, script_at, owner = positions(text, "COPY --chown", "USER root\nRUN cd /home", run, 'RUN find "/home/')
    assert source < root < script_at < owner < text.index("CMD ")
    assert positions(text, "      build-essential", "      cmake", "      python3-dev")


def test_any_pip_of_a_conda_file_is_limited(plan: Callable[..., Plan], tmp_path: Path) -> None:
    text = dockerfile(plan(manager="conda", conda_file="environment.yml", conda_pip_below="25.3"))
    command = next(line for line in text.splitlines() if " && sed --in-place --regexp" in line or "RUN sed" in line)
    assert text.index(command) < text.index("micromamba create")
    file = tmp_path / "environment.yml"
    file.write_text("dependencies:\n  - pip  # any\n  - 'pip'\n  - pipx\n  - pip=20\n  - pip:\n    - numpy\n")
    command = command.strip("RUN &\\").replace("/tmp/manifests/environment.yml", str(file))
    subprocess.run(["bash", "-c", command], check=True)
    limited = '  - "pip<25.3"  # any\n  - "pip<25.3"\n'
    assert file.read_text() == f"dependencies:\n{limited}  - pipx\n  - pip=20\n  - pip:\n    - numpy\n"


def test_an_old_pip_of_a_conda_file_is_not_taken(plan: Callable[..., Plan], tmp_path: Path) -> None:
    text = dockerfile(plan(manager="conda", conda_file="environment.yml", conda_old_pip="9.0.1"))
    command = next(line for line in text.splitlines() if " && sed --in-place --regexp" in line or "RUN sed" in line)
    assert text.index(command) < text.index("micromamba create")
    file = tmp_path / "environment.yml"
    file.write_text("dependencies:\n  - pip=9.0.1=py35_4  # old\n  - 'pip==10'\n  - pipx=1\n  - pip:\n    - numpy\n")
    command = command.strip("RUN &\\").replace("/tmp/manifests/environment.yml", str(file))
    subprocess.run(["bash", "-c", command], check=True)
    assert file.read_text() == "dependencies:\n  - pip  # old\n  - 'pip'\n  - pipx=1\n  - pip:\n    - numpy\n"


def test_what_only_lists_repositories_gets_what_they_need_in_turn_and_loses_none(tmp_path: Path) -> None:
    (tmp_path / "all.repos").write_text(
        "repositories:\n  arm: {type: git, url: 'https://github.com/lab/arm.git', version: humble}\n"
    )
    (tmp_path / "README.md").write_text("# ROS 2 Humble\n\n    vcs import src < all.repos\n    colcon build\n")
    text = dockerfile(plan_repository(tmp_path).plan)
    assert " --complete --required /home/${NB_USER}/ws/src /home/${NB_USER}/ws/src\n" in text
    assert "COPY --from=scripts /cmake-jammy.txt /usr/local/share/roslab/\n" in text
    assert "\noctomap = ros:octomap liboctomap-dev\n" in text
    assert "build-needed" not in text
