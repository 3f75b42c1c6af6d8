"""An archive that is unpacked into the home, where the build or the code looks for it, is there in the image."""

from __future__ import annotations

from collections.abc import Callable
from textwrap import indent

import pytest

from roslab.config.model import Config
from roslab.decide.decision import Decision, Download
from roslab.plan.plan import make_plan
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]
NAME = "acme-3.2.7-linux-x86_64.tar.gz"
URL = f"https://files.example/releases/{NAME}"
CMAKE = """\
cmake_minimum_required(VERSION 3.16)
project(demo CXX)
set(ACME_DIR "$ENV{HOME}/.acme/acme-3.2.7")
if(NOT EXISTS ${ACME_DIR})
  message(FATAL_ERROR "Acme is not at ${ACME_DIR}")
endif()
link_directories(${ACME_DIR}/lib)
add_executable(demo main.cpp)
target_link_libraries(demo acme)
"""
FILES = {"CMakeLists.txt": CMAKE, "main.cpp": "#include <acme/acme.h>\nint main() {}\n"}
THERE = Download(url=URL, path=f".acme/{NAME}", unpack=".acme", home=True)
FETCH = f"mkdir -p ~/.acme\nwget {URL}\ntar -xf {NAME} -C ~/.acme"


def of(tree: Tree, lines: str, **more: str) -> Decision:
    return tree({**FILES, "README.md": f"# Demo\n## Install\n```bash\n{lines}\n```\n", **more})


@pytest.mark.parametrize(
    "lines",
    [
        FETCH,
        f"mkdir -p ~/.acme && curl -L {URL} | tar -xz -C ~/.acme",
        f"curl -L {URL} -o /tmp/acme.tar.gz\nsudo tar xzf /tmp/acme.tar.gz -C $HOME/.acme/",
        f"mkdir -p ${{HOME}}/.acme; cd ${{HOME}}/.acme\nwget -q {URL}\ntar -xvf {NAME}",
        f"$ cd /home/me/.acme\n$ wget {URL} -O - | tar xz",
        f"V=3.2.7\nwget {URL.replace('3.2.7', '${V}')}\ntar xf acme-$V-linux-x86_64.tar.gz -C ~/.acme",
    ],
)
def test_it_is_unpacked_there(tree: Tree, lines: str) -> None:
    decision = of(tree, lines)
    assert [each.unpack for each in decision.downloads if each.home and each.url == URL] == [".acme"]
    assert decision.platforms == ("linux/amd64",), "the build takes what is compiled for it"
    assert not [each.message for each in decision.warnings if "acme" in each.message.lower()]


@pytest.mark.parametrize(
    ("lines", "file"),
    [
        (FETCH.replace("-C ~/.acme", "-C ~/acme_ws/src"), CMAKE),
        (FETCH.replace("-C ~/.acme", "-C build"), CMAKE),
        (FETCH.replace("linux-x86_64", "macos-arm64"), CMAKE),
        (FETCH, CMAKE.replace("$ENV{HOME}/.acme/acme-3.2.7", "/opt/acme")),
        (FETCH, CMAKE.replace("$ENV{HOME}/.acme/acme-3.2.7", "$ENV{HOME}/.acmeware")),
        ("tar -xf other.tar.gz -C ~/.acme", CMAKE),
    ],
)
def test_what_nothing_looks_for_is_not(tree: Tree, lines: str, file: str) -> None:
    assert of(tree, lines, **{"CMakeLists.txt": file}).downloads == ()


@pytest.mark.parametrize(
    ("path", "text"),
    [
        ("install.sh", f"#!/bin/bash\nset -e\n{FETCH}\n"),
        (".github/workflows/ci.yml", f"jobs:\n  a:\n    steps:\n      - run: |\n{indent(FETCH, ' ' * 10)}\n"),
    ],
)
def test_also_of_a_script_and_of_ci(tree: Tree, path: str, text: str) -> None:
    assert of(tree, "cmake ..", **{path: text}).downloads == (THERE,)


def test_a_release_that_a_script_lets_the_reader_choose(tree: Tree) -> None:
    named, file = URL.replace("3.2.7", "${V}"), "${HOME}/got/acme-${V}-linux-x86_64.tar.gz"
    lines = ("#!/bin/bash", 'V="${ACME_VERSION:-3.2.7}"', f'FILE="{file}"', "wget -q \\", f'  "{named}" \\')
    script = "\n".join((*lines, '  -O "${FILE}"', 'tar -xzf "${FILE}" -C "${HOME}/.acme"', ""))
    assert of(tree, "cmake ..", **{"setup/acme.sh": script}).downloads == (THERE,)


@pytest.mark.parametrize(
    ("code", "there"),
    [
        ('import os\nPATH = os.path.expanduser("~/.acme/acme-3.2.7")\n', True),
        ('from pathlib import Path\nPATH = Path.home() / ".acme" / "acme-3.2.7"\n', True),
        ('import os\nPATH = os.environ["ACME_PATH"]\n', True),
        ('import os\nPATH = os.environ["OTHER"]\n', False),
    ],
)
def test_what_the_program_looks_for(tree: Tree, code: str, there: bool) -> None:
    page = f"# Demo\n```\n{FETCH}\nexport ACME_PATH=$HOME/.acme/acme-3.2.7\npython demo.py\n```\n"
    decision = tree({"demo.py": code, "requirements.txt": "numpy\n", "README.md": page})
    assert decision.downloads == ((THERE,) if there else ())
    assert dict(decision.variables) == ({"ACME_PATH": "~/.acme/acme-3.2.7"} if there else {})


def test_of_two_releases_the_one_that_is_named(tree: Tree) -> None:
    older = FETCH.replace("3.2.7", "2.1.0")
    assert of(tree, f"{older}\n{FETCH}").downloads == (THERE,)


def test_the_image_has_it_and_its_variables(tree: Tree) -> None:
    lines = f"{FETCH}\nexport LD_LIBRARY_PATH=$LD_LIBRARY_PATH:~/.acme/acme-3.2.7/lib"
    text = dockerfile(make_plan(of(tree, lines), Config(), folder_name="demo"))
    assert f"fetch-optional \\\n      {URL} \\\n      /fetched-home/.acme/{NAME} \\\n      /fetched-home/.acme" in text
    brought = text.index("COPY --from=downloads --chown=${NB_UID}:${NB_UID} /fetched-home/ /home/${NB_USER}/\n")
    assert brought < text.index("cmake -D")
    place = "/home/${NB_USER}/.acme/acme-3.2.7/lib"
    assert f'LD_LIBRARY_PATH="{place}${{LD_LIBRARY_PATH:+:${{LD_LIBRARY_PATH}}}}"' in text


def test_folders_of_its_paths_are_left_out(tree: Tree) -> None:
    lines = f"mkdir -p ~/acme/3\ncurl -LO {URL}\ntar -xzf {NAME} -C ~/acme/3 --strip-components 1"
    file = CMAKE.replace("/.acme/acme-3.2.7", "/acme/3")
    decision = of(tree, lines, **{"CMakeLists.txt": file})
    assert decision.downloads == (Download(url=URL, path=f"acme/3/{NAME}", unpack="acme/3", home=True, strip=1),)
    assert "/fetched-home/acme/3 \\\n      1" in dockerfile(make_plan(decision, Config(), folder_name="demo"))


def test_what_pip_is_compiled_against_is_fetched_once(tree: Tree) -> None:
    name = "mujoco210-linux-x86_64.tar.gz"
    url = f"https://github.com/google-deepmind/mujoco/releases/download/2.1.0/{name}"
    page = f"# Demo\n```\nmkdir ~/.mujoco\nwget {url}\ntar -xf {name} -C ~/.mujoco\npython demo.py\n```\n"
    code = "import mujoco_py\nPATH = '~/.mujoco/mujoco210'\n"
    decision = tree({"demo.py": code, "requirements.txt": "mujoco-py==2.1.2.14\n", "README.md": page})
    assert [part.folder for part in decision.python.native_parts] == [".mujoco/mujoco210"]
    assert decision.downloads == ()


PLACE = "~/.acme/acme-3.2.7/lib"
LISTED = "$LD_LIBRARY_PATH:$HOME/.acme/acme-3.2.7/lib"


@pytest.mark.parametrize(
    ("line", "found"),
    [
        (f"echo 'export LD_LIBRARY_PATH={LISTED}' >> ~/.bashrc", PLACE),
        (f'echo "export LD_LIBRARY_PATH={LISTED}" >> ~/.bashrc', PLACE),
        (f'echo "export LD_LIBRARY_PATH=\\{LISTED}" >> ~/.bashrc', PLACE),
        (f'echo "export LD_LIBRARY_PATH=\\"{LISTED}\\"" >> ~/.bashrc', PLACE),
        (f"echo export LD_LIBRARY_PATH={LISTED}>>~/.bashrc", PLACE),
        (f'export LD_LIBRARY_PATH="{LISTED}" && ls', PLACE),
        (f"export LD_LIBRARY_PATH={LISTED} python demo.py", PLACE),
        (f"export LD_LIBRARY_PATH={LISTED}\t# the libraries", PLACE),
        (f"export LD_LIBRARY_PATH={LISTED}\u00a0", PLACE),
        ("export LD_LIBRARY_PATH=~/.acme/<the release>/lib", None),
        (f"export LD_LIBRARY_PATH={LISTED}\x1b[0m", None),
        (f"export LD_LIBRARY_PATH={LISTED}\u202e", None),
        (f'export LD_LIBRARY_PATH="{LISTED}\t"', None),
        (f'export LD_LIBRARY_PATH={LISTED}\\"a', None),
        (f'export LD_LIBRARY_PATH="{LISTED}"64', None),
    ],
)
def test_a_value_ends_where_the_shell_s_word_does(tree: Tree, line: str, found: str | None) -> None:
    decision = of(tree, f"{FETCH}\n{line}")
    assert decision.downloads == (THERE,)
    assert dict(decision.variables).get("LD_LIBRARY_PATH") == found
    dockerfile(make_plan(decision, Config(), folder_name="demo"))


@pytest.mark.parametrize("strip", ["9" * 5000, "100", "-1", "one", "\u0661"])
def test_no_path_has_as_many_folders(tree: Tree, strip: str) -> None:
    assert of(tree, f"{FETCH} --strip-components={strip}").downloads == ()


@pytest.mark.parametrize(
    ("line", "there"),
    [
        ("tar -xf {} -C ~bob/.acme", False),
        ("cd ~/.acme\ntar -xf {} -C ~bob", False),
        ("cd ~/other\ntar -xf {} -C ~/.acme", True),
        ("cd ~ && tar -xf {} -C .acme", True),
    ],
)
def test_the_home_is_the_reader_s_own(tree: Tree, line: str, there: bool) -> None:
    decision = of(tree, f"wget {URL}\n{line.format(NAME)}")
    assert decision.downloads == ((THERE,) if there else ())


def test_what_every_program_starts_with_stays_and_folders_of_the_home_are_written_out(tree: Tree) -> None:
    names = ("HOME", "PATH", "LIBRARY_PATH", "ACME_DIR")
    lines = "".join(f"\nexport {name}=$HOME/.acme/acme-3.2.7" for name in names)
    decision = of(tree, FETCH + lines)
    assert {*dict(decision.variables)} & {*names} == {"LIBRARY_PATH", "ACME_DIR"}
    text = dockerfile(make_plan(decision, Config(), folder_name="demo"))
    place = "/home/${NB_USER}/.acme/acme-3.2.7"
    assert f'LIBRARY_PATH="{place}${{LIBRARY_PATH:+:${{LIBRARY_PATH}}}}"' in text
    assert f'ACME_DIR="{place}"' in text
    assert '="~' not in text
