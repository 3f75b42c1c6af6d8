"""Texts that repeat what begins a pattern are read in a time that grows with their length alone."""

from __future__ import annotations

import posixpath
from pathlib import Path

import pytest

from hanging import ends
from roslab.evidence.launch_file import LaunchFile
from roslab.evidence.lex import braces
from roslab.evidence.lex.dockerfile import instructions
from roslab.evidence.lex.shell import Command
from roslab.evidence.lex.yaml import Scalar
from roslab.evidence.native import autotools
from roslab.evidence.prose import asciidoc, called_in_scripts, checkouts, ci_variables, container_scripts, said_runs
from roslab.evidence.prose.notes_behind import without_notes
from roslab.evidence.prose.ros_in_image import ros_of
from roslab.evidence.python import caught, conda, notebooks, on_gpu, ros_tools, told_ways
from roslab.evidence.ros import (
    handed_lists,
    lost_folders,
    named_in_code,
    only_in_manifest,
    own_setup,
    package_xml,
)
from roslab.evidence.ros.only_programs import only_programs
from trees import tree_of

LONG = 20_000
WIDE = "\uff08"
SAID = "'ros2 bag play a'"


def scalar(text: str, **variables: str) -> Scalar:
    return Scalar("run", text, 1, item=False, variables=variables)


def test_a_setting_of_many_blanks_before_no_file(tmp_path: Path) -> None:
    repository = tree_of(tmp_path, {"a.py": f"# /setup.\na={' ' * 2 * LONG}x\n"})
    with ends():
        assert not [*own_setup.read(repository)]


@pytest.mark.parametrize("named", ["{here}", "{other}", "{}"])
def test_the_folder_in_a_command_of_python(tmp_path: Path, named: str) -> None:
    code = "import os\nhere  =  os.path.dirname(os.path.dirname(__file__))\n"
    run = f"run('source {named}/install/setup.bash'.format(here))\n"
    found = [each.value for each in own_setup.read(tree_of(tmp_path, {"a.py": code + run}))]
    assert found == ([] if named == "{other}" else ["../install"])


def test_many_variables_and_many_commands_that_name_them(tmp_path: Path) -> None:
    count = 1_500
    shell = "".join(f'source "$v{each}/install/setup.bash"\n' for each in range(count))
    code = "".join(f"v{each}=__file__\n" for each in range(count)) + 'run("source {}/install/setup.sh")\n' * 500
    repository = tree_of(tmp_path, {**{f"a{n}.sh": shell for n in range(40)}, **{f"a{n}.py": code for n in range(40)}})
    with ends():
        assert not [*own_setup.read(repository)]


def test_the_first_set_of_a_folder_counts() -> None:
    text = 'export a="${BASH_SOURCE%/*}/.."\na=$(dirname "$0")\n  b="$(dirname "${0}")"\nc=/opt\n'
    assert own_setup.of_root(text, "a", 1)
    assert own_setup.of_root(text, "b", 0)
    assert not any(own_setup.of_root(text, name, depth) for name, depth in (("a", 0), ("b", 1), ("c", 0), ("d", 0)))


def test_a_command_that_names_a_variable_many_times() -> None:
    with ends():
        assert ci_variables.filled(scalar("echo " + "$A " * 2 * LONG, A="b")) == "echo " + "b " * 2 * LONG


@pytest.mark.parametrize("own", ["A=c; ", "export A=c\n", "a;A=c ", "export export A=c\n"])
def test_a_variable_that_a_command_sets_itself_stays(own: str) -> None:
    assert ci_variables.filled(scalar(f"{own}echo $A $AB ${{{{ env.A }}}}", A="b", AB="d")) == f"{own}echo $A d b"


@pytest.mark.parametrize("entry", ["pip", "{pip", "{ pip", "{  pip "])
def test_the_part_of_pip_in_brackets(tmp_path: Path, entry: str) -> None:
    close = "}" if "{" in entry else ""
    text = f"name: a\ndependencies:\n  - python=3.9\n  -   {entry}: [numpy]{close}\n"
    (found,) = conda.read(tree_of(tmp_path, {"environment.yml": text}))
    assert found.flow == {"pip"}


def test_an_entry_of_many_blanks(tmp_path: Path) -> None:
    text = f"name: a\ndependencies:\n  - python=3.9\n  -{' ' * 12 * LONG}numpy\n"
    with ends():
        (found,) = conda.read(tree_of(tmp_path, {"environment.yml": text}))
    assert found.flow == frozenset()


def test_many_lists_whose_names_variables_hold(tmp_path: Path) -> None:
    script = "".join(f"A{each}=lists\nvcs import < $A{each}/b{each}.repos\n" for each in range(2_500))
    with ends():
        found = handed_lists.read(tree_of(tmp_path, {f"a{each}.sh": f"{script}A7=other\n" for each in range(20)}))
    assert [each.value for each in found] == [f"lists/b{each}.repos" for each in range(2_500)] * 20


def test_many_lists_that_a_script_fetches(tmp_path: Path) -> None:
    script = "".join(f"wget https://a.org/{each}/a.repos\nvcs import < a.repos\n" for each in range(1_500))
    with ends():
        found = handed_lists.read(tree_of(tmp_path, {f"a{each}.sh": script for each in range(20)}))
    assert {each.value for each in found} == {"https://a.org/0/a.repos"}


def test_a_quote_that_is_not_closed_before_many_others() -> None:
    quotes = '\\"' * 4 * LONG
    with ends():
        assert braces.expanded(f'apt install lib{{a,b}} "{quotes}') == f'apt install liba libb "{quotes}'


def test_a_place_for_a_token_of_many_signs() -> None:
    word = f"https://{'<' * 8 * LONG}"
    with ends():
        assert checkouts.cloned(Command(("git", "clone", word), (1,)), "README.md", "", "", inside=False) is None


def test_a_path_of_many_folders_that_is_to_be_run(tmp_path: Path) -> None:
    repository = tree_of(tmp_path, {"README.md": f"Run `{'bin/' * LONG} it.\n"})
    (page,) = repository.files
    with ends():
        assert not [*said_runs.read(repository, page, repository.read(page), ())]


@pytest.mark.parametrize("order", [1, -1])
def test_attributes_that_name_each_other_many_times(order: int) -> None:
    lines = [":a0: long", *(f":a{each}: {f'{{a{each - 1}}}' * 30}" for each in range(1, 6))][::order]
    assert len(asciidoc.as_markdown("\n".join((*lines, "", "{a5}")))) < LONG


def test_a_language_of_many_letters() -> None:
    line = f"[source,{'a' * 20 * LONG}"
    with ends():
        assert asciidoc.as_markdown(line) == line


def test_many_attributes_and_many_lines_that_name_none() -> None:
    with ends():
        asciidoc.as_markdown("".join(f":a{each}: b\n" for each in range(LONG)) + "{b} c\n" * LONG)


@pytest.mark.parametrize(
    ("code", "left_over"),
    [
        ("/* " * 2 * LONG, True),
        ("/* my_old_thing */ int a; // my_old_thing */\n/*/ my_old_thing */", True),
        ("*//* my_old_thing */", True),
        ("// /*\nint my_old_thing; // */", False),
        ('a("b/*"); my_old_thing();', False),
        ("/* a */ my_old_thing /* b */", False),
        ("/**/ my_old_thing", False),
    ],
)
def test_a_name_in_comments_is_none_of_the_code(tmp_path: Path, code: str, *, left_over: bool) -> None:
    xml = "<package format='2'><name>a</name><depend>my_old_thing</depend></package>"
    repository = tree_of(
        tmp_path, {"package.xml": xml, "CMakeLists.txt": "project(a)\n", **{f"a{n}.cpp": code for n in range(40)}}
    )
    with ends():
        found = [each.value for each in only_in_manifest.read(repository, package_xml.read(repository))]
    assert found == (["my_old_thing"] if left_over else [])


@pytest.mark.parametrize(
    ("setting", "told"),
    [
        ("device: cuda", True),
        ("  'my_device_name' : cuda:0  # a", True),
        ("devices: cpu", False),
        ("device" * 2 * LONG + " cuda", False),
    ],
    ids=["plain", "quoted", "cpu", "long"],
)
def test_a_setting_for_the_gpu(tmp_path: Path, setting: str, *, told: bool) -> None:
    files = {"launch/a.launch": "", "a.yaml": f"{setting}\n", "node.py": "import rospy\n"}
    repository = tree_of(tmp_path, files)
    launch = LaunchFile(
        file="launch/a.launch",
        line=1,
        package="a",
        ros=1,
        dependencies=(),
        gui=False,
        loaded=("node.py", "a.yaml"),
    )
    with ends():
        found = [posixpath.basename(each.value) for each in on_gpu.read(repository, [launch])]
    assert found == (["a.launch"] if told else [])


def test_a_word_of_many_installs_in_a_build(tmp_path: Path) -> None:
    build = f"set(x {'install' * LONG})\nament_package()\n"
    with ends():
        assert not only_programs("go/a.py", "", tree_of(tmp_path / "large", {"CMakeLists.txt": build, "go/a.py": ""}))
    build = f"set(x {'install' * (LONG // 3)})\nament_package()\n"
    with ends():
        assert only_programs("go/a.py", "", tree_of(tmp_path / "small", {"CMakeLists.txt": build, "go/a.py": ""}))


@pytest.mark.parametrize("calls", ["my_install(a)", "x_install_all (a)", "installs(a)", "install(FILES a.b)"])
def test_what_may_install_a_launch_file(tmp_path: Path, calls: str) -> None:
    build = f"{calls}\nament_python_install_package(x)\nament_package()\n"
    assert not only_programs("go/a.py", "", tree_of(tmp_path, {"CMakeLists.txt": build, "go/a.py": ""}))


def test_a_container_with_many_mounts(tmp_path: Path) -> None:
    script = f"docker run {'--mount=source=$1' * 1_150} a\n" * 2
    with ends():
        assert not [*container_scripts.read(tree_of(tmp_path, {"a.sh": script}))]


def test_a_step_of_many_settings() -> None:
    written = [*instructions("FROM ubuntu:20.04\n" + f"RUN {'=a' * 9_000}\n" * 16)]
    assert len(written) == 17
    with ends():
        assert ros_of(written, "ubuntu:20.04") == "none"


def test_a_long_word_of_a_script_is_no_function() -> None:
    word = "a." * 12 * LONG
    with ends():
        assert [*called_in_scripts.calls_of(word)] == [(word, 1)]


def test_a_line_of_many_addresses(tmp_path: Path) -> None:
    code = "# " + "https://github.com/a/b " * (named_in_code.MAX_SIZE // 23 - 1)
    with ends():
        (found,) = named_in_code.read(tree_of(tmp_path, {"a.py": code}))
    assert not found.taken


def test_what_is_said_before_an_address(tmp_path: Path) -> None:
    code = f"{'a' * LONG} taken from https://github.com/a/b\n# see https://github.com/a/c\n"
    assert [each.taken for each in named_in_code.read(tree_of(tmp_path, {"a.py": code}))] == [True, False]


@pytest.mark.parametrize(
    "text",
    [
        f"AC_CHECK_LIB({' ' * 5 * LONG}",
        f"AC_CHECK_LIB(a{' ' * 5 * LONG}x",
        f"PKG_CHECK_MODULES(A,{' ' * 5 * LONG}",
        f"AC_CONFIG_MACRO_DIRS({' ' * 5 * LONG}",
    ],
)
def test_a_macro_of_autoconf_with_many_blanks(tmp_path: Path, text: str) -> None:
    repository = tree_of(tmp_path, {"configure.ac": text, "Makefile.am": "bin_PROGRAMS = a\n"})
    with ends():
        (made,) = autotools.read(repository)
    assert not made.linked


@pytest.mark.parametrize("asked", ["b c", "b >= $B_VERSION c >= 2", "b >= b_needed $MORE c ${OTHERS}"])
def test_what_pkg_config_is_asked_for_is_no_variable_and_no_version(tmp_path: Path, asked: str) -> None:
    told = f"PKG_CHECK_MODULES([A], [{asked}])\n"
    (made,) = autotools.read(tree_of(tmp_path, {"configure.ac": told, "Makefile.am": "bin_PROGRAMS = a\n"}))
    assert made.modules == ("b", "c")


@pytest.mark.parametrize("blank", ["", " ", "\n "])
def test_macros_of_autoconf_with_few(tmp_path: Path, blank: str) -> None:
    told = (
        f"AC_CHECK_LIB({blank}[{blank}z{blank}]{blank}, f)\n"
        f"PKG_CHECK_MODULES({blank}[A]{blank},{blank}[{blank}b c{blank}]{blank})\n"
        f"AC_CONFIG_MACRO_DIRS({blank}[{blank}m4{blank}])\n"
    )
    (made,) = autotools.read(tree_of(tmp_path, {"configure.ac": told, "Makefile.am": "bin_PROGRAMS = a\n"}))
    assert (made.linked, made.modules) == (("z",), ("b", "c"))
    assert made.configured.startswith("mkdir --parents m4 && ")


@pytest.mark.parametrize(("note", "left"), [("\u3042", "a"), ("1", None)])
def test_a_line_of_many_wide_brackets(note: str, left: str | None) -> None:
    text = f"a \uff08{note}{WIDE * 5 * LONG}\uff09x"
    with ends():
        assert without_notes(text) == (left or text)


@pytest.mark.parametrize("line", [f"except{' ' * 5 * LONG}x", f"except {'ImportError ' * LONG}"])
def test_a_handler_of_a_long_line(tmp_path: Path, line: str) -> None:
    repository = tree_of(tmp_path, {"a.py": f"try:\n    import b\n{line}:\n    print('pip install c')\n"})
    with ends():
        told_ways.read(repository)
        caught.read(repository)


@pytest.mark.parametrize(
    "text",
    [
        "try:\n" + "    import a\n" * LONG + "except ImportError:\n    pass  # install\n",
        "try:\n    import a\nexcept ImportError:\n    pass  # install\n" * 3_000,
        "    import a\n" * LONG,
    ],
)
def test_many_imports_in_a_try(tmp_path: Path, text: str) -> None:
    repository = tree_of(tmp_path, {"a.py": text})
    with ends():
        assert not told_ways.read(repository)
        assert bool(caught.read(repository)) is ("except" in text[:100])


def test_a_line_of_a_notebook_with_many_blanks() -> None:
    cell = f'{{"cell_type": "code", "source": ["!pip install a{" " * 5 * LONG}x"]}}'
    with ends():
        assert [*notebooks.installs(f'{{"cells": [{cell}]}}')]


def test_what_stands_before_a_call_of_ros(tmp_path: Path) -> None:
    code = f"import subprocess\n{'log' * 2 * LONG} {SAID}\n"
    with ends():
        assert [*ros_tools.read(tree_of(tmp_path, {"a.py": code}))]


def test_a_folder_that_is_looked_for_before_lines_of_many_blanks(tmp_path: Path) -> None:
    body = f"{' ' * 1_000}a\n" * 4
    code = f"d = rospkg.RosPack().get_path('demo') + '/results/'\nif os.path.exists(d):\n{body}os.makedirs(d)\n"
    repository = tree_of(tmp_path, {"package.xml": "<package><name>demo</name></package>", "a.py": code})
    with ends():
        assert [each.value for each in lost_folders.read(repository, package_xml.read(repository))] == ["results"]
