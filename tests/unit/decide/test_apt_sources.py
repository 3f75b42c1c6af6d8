"""Package sources that a page adds and installs from are added to the image, with a key that came by https."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from roslab.decide.decision import Decision
from roslab.pipeline import plan_repository
from roslab.render import image_scripts
from roslab.render.dockerfile import dockerfile

Tree = Callable[[dict[str, str]], Decision]
CODE = {
    "CMakeLists.txt": "project(demo CXX)\nadd_executable(a a.cpp)\n",
    "a.cpp": "#include <acme/arm.hpp>\nint main() {}\n",
}
KEY = "curl -fsSL https://apt.acme.org/acme.gpg --output /usr/share/keyrings/acme.gpg\n"
SIGNED = "signed-by=/usr/share/keyrings/acme.gpg"
ADD = (
    f'echo "deb [arch=$(dpkg --print-architecture) {SIGNED}] https://apt.acme.org/stable $(lsb_release -cs) main" \\\n'
    "  | sudo tee /etc/apt/sources.list.d/acme.list > /dev/null\n"
)
INSTALL = "sudo apt-get update\nsudo apt-get install libacme-dev\n"
ADDED = "deb [signed-by=https://apt.acme.org/acme.gpg] https://apt.acme.org/stable jammy main"
SERVER = "https://keyserver.ubuntu.com/pks/lookup?op=get&search=0x57A5ACB6110576A657A5ACB6110576A657A5ACB6"
FINGERPRINT = "57A5ACB6110576A657A5ACB6110576A657A5ACB6"


def page(*commands: str) -> dict[str, str]:
    return CODE | {"README.md": "Tested on Ubuntu 22.04\n## Install\n```\n" + "".join(commands) + "```\n"}


@pytest.mark.parametrize(
    ("commands", "added"),
    [
        ((KEY, ADD), ADDED),
        (
            (
                "curl https://apt.acme.org/acme.asc | sudo gpg --dearmor -o /etc/apt/keyrings/acme.gpg\n",
                (
                    'echo "deb [signed-by=/etc/apt/keyrings/acme.gpg] https://apt.acme.org/x ./" '
                    "> /etc/apt/sources.list.d/a.list\n"
                ),
            ),
            "deb [signed-by=https://apt.acme.org/acme.asc] https://apt.acme.org/x ./",
        ),
        (
            (
                (
                    'sudo sh -c \'echo "deb http://apt.acme.org/x `lsb_release -cs` main" '
                    "> /etc/apt/sources.list.d/a.list'\n"
                ),
                "wget https://apt.acme.org/acme.key -O - | sudo apt-key add -\n",
            ),
            "deb [signed-by=https://apt.acme.org/acme.key] http://apt.acme.org/x jammy main",
        ),
        (
            (
                f"sudo apt-key adv --keyserver hkp://keyserver.ubuntu.com:80 --recv-keys {FINGERPRINT}\n",
                'sudo add-apt-repository "deb https://apt.acme.org/x $(lsb_release -cs) main" -u\n',
            ),
            f"deb [signed-by={SERVER}] https://apt.acme.org/x jammy main",
        ),
        (
            (
                "wget https://apt.acme.org/keys/ACME-2019.PUB\n",
                "sudo apt-key add ACME-2019.PUB\n",
                "sudo sh -c 'echo deb https://apt.acme.org/x all main > /etc/apt/sources.list.d/acme.list'\n",
            ),
            "deb [signed-by=https://apt.acme.org/keys/ACME-2019.PUB] https://apt.acme.org/x all main",
        ),
    ],
)
def test_a_source_is_added_with_its_key(tree: Tree, commands: tuple[str, ...], added: str) -> None:
    decision = tree(page(*commands, INSTALL))
    assert decision.repositories == (added,)
    assert "libacme-dev" in decision.apt_guessed
    assert [r.line for r in decision.reasons if "installs libacme-dev from it" in r.reason]


@pytest.mark.parametrize(
    ("file", "after", "added"),
    [
        ("README.md", INSTALL, ("ppa:acme/stable",)),
        ("install.sh", INSTALL, ("ppa:acme/stable",)),
        ("README.md", "sudo apt-get install nvidia-driver-470 ros-noetic-tf\n", ()),
        ("README.md", "", ()),
        (".github/workflows/ci.yml", INSTALL, ()),
    ],
)
def test_a_ppa_is_added_where_what_adds_it_installs_from_it(
    tree: Tree, file: str, after: str, added: tuple[str, ...]
) -> None:
    text = f"sudo add-apt-repository -y ppa:acme/stable\n{after}"
    said = f"## Install\n```\n{text}```\n" if file.endswith(".md") else text
    said = f"run: |\n  {text.replace(chr(10), chr(10) + '  ')}" if file.endswith(".yml") else said
    decision = tree(CODE | {file: said})
    assert decision.repositories == added
    told = [w for w in decision.warnings if "ppa:" in w.message]
    assert bool(told) == (not added and not file.endswith(".yml"))


def test_a_ppa_whose_name_a_script_computes_is_told(tree: Tree) -> None:
    script = f'for PPA in a/b c/d; do\n  sudo apt-add-repository -y ppa:"${{PPA}}"\ndone\n{INSTALL}'
    decision = tree(CODE | {"install.sh": script, "README.md": "```\n./install.sh\n```\n"})
    assert decision.repositories == ()
    assert [w.line for w in decision.warnings if "computes its address" in w.message] == [2]


def test_a_known_key_takes_the_place_of_one_without_https(tree: Tree) -> None:
    source = "deb http://packages.osrfoundation.org/gazebo/ubuntu-stable jammy main"
    add = f"sh -c 'echo \"{source}\" > /etc/apt/sources.list.d/g.list'\n"
    key = "wget http://packages.osrfoundation.org/gazebo.key -O - | sudo apt-key add -\n"
    (line,) = tree(page(add, key, "sudo apt install gz-harmonic\n")).repositories
    assert line.startswith("deb [signed-by=https://packages.osrfoundation.org/gazebo.gpg] http://packages.osrf")


OTHERS = f"sudo apt-key adv --keyserver hkp://keyserver.ubuntu.com:80 --recv-keys {FINGERPRINT}\n"


def test_a_known_key_takes_the_place_of_the_one_of_another_source(tree: Tree) -> None:
    source = "deb http://packages.osrfoundation.org/gazebo/ubuntu `lsb_release -cs` main"
    add = f"sudo sh -c 'echo \"{source}\" > /etc/apt/sources.list.d/g.list'\n"
    (line,) = tree(page(OTHERS, add, "sudo apt install gz-harmonic\n")).repositories
    assert line.startswith("deb [signed-by=https://packages.osrfoundation.org/gazebo.gpg] http://packages.osrf")


@pytest.mark.parametrize("scheme", ["https", "http"])
def test_the_key_of_its_own_host_is_its_key(tree: Tree, scheme: str) -> None:
    key = f"wget {scheme}://keys.acme.org/acme.key -O - | sudo apt-key add -\n"
    decision = tree(page(OTHERS, ADD.replace(f" {SIGNED}", ""), key, INSTALL))
    assert [line.split()[1] for line in decision.repositories] == ["[signed-by=https://keys.acme.org/acme.key]"] * (
        scheme == "https"
    )
    told = [w.message for w in decision.warnings if w.message.startswith("not added: ")]
    assert [message.endswith("its key is fetched without https") for message in told] == [True] * (scheme == "http")


def test_an_address_whose_host_cannot_be_read_is_passed_by(tree: Tree) -> None:
    key = "wget https://[HOST/acme.key -O - | sudo apt-key add -\n"
    assert tree(page(key, KEY, ADD, INSTALL)).repositories == (ADDED,)


@pytest.mark.parametrize(
    ("commands", "why"),
    [
        ((KEY.replace("https", "http"), ADD), "its key is fetched without https"),
        ((ADD,), "nothing beside it fetches its key"),
        ((KEY, ADD.replace(SIGNED, "trusted=yes")), "it is trusted without a key"),
        ((KEY, ADD.replace("$(lsb_release -cs)", "focal")), "it is for focal, the image is jammy"),
        (
            (
                "apt-key adv --keyserver keyserver.ubuntu.com --recv-keys 110576A6\n",
                'add-apt-repository "deb https://apt.acme.org/x jammy main"\n',
            ),
            "110576A6 is no whole fingerprint of its key",
        ),
    ],
)
def test_a_source_that_cannot_be_trusted_is_told_with_its_line(tree: Tree, commands: tuple[str, ...], why: str) -> None:
    decision = tree(page(*commands, INSTALL))
    assert not decision.repositories
    (told,) = [w for w in decision.warnings if w.message.startswith("not added: ")]
    assert told.message.endswith(why)
    assert (told.file, told.line) == ("README.md", 3 + len(commands))


@pytest.mark.parametrize(
    "commands",
    [
        (KEY, ADD),
        (INSTALL, KEY, ADD),
        (KEY, ADD.replace("apt.acme.org/stable", "packages.ros.org/ros2/ubuntu"), INSTALL),
        (KEY, ADD, "sudo apt install ros-humble-acme\n"),
        (KEY, f"# {ADD}", INSTALL),
    ],
)
def test_a_source_from_which_nothing_is_installed_is_not_added(tree: Tree, commands: tuple[str, ...]) -> None:
    decision = tree(page(*commands))
    assert not decision.repositories
    assert not [w for w in decision.warnings if w.message.startswith("not added: ")]


def test_the_dockerfile_adds_it_before_the_packages(tmp_path: Path) -> None:
    for name, text in page(KEY, ADD, INSTALL).items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    text = dockerfile(plan_repository(tmp_path).plan)
    assert f"add-package-sources '{ADDED}'" in text
    assert text.index("add-package-sources '") < text.index("install-optional-apt libacme-dev")


@pytest.mark.parametrize(("answer", "added"), [("cp key", True), ("exit 22", False)])
def test_the_script_names_the_file_of_the_key(tmp_path: Path, answer: str, added: bool) -> None:
    """A stand-in of ``curl`` answers with a key that is not armoured, or not at all."""
    script = (Path(image_scripts.__path__[0]) / "add-package-sources.sh").read_text(encoding="utf-8")
    function = script[script.index("add_line() {") : script.index("\n}\n") + 3]
    curl = tmp_path / "curl"
    curl.write_text(f'#!/bin/bash\nwhile [ "$1" != --output ]; do shift; done\n{answer} "$2"\n', encoding="utf-8")
    curl.chmod(0o755)
    (tmp_path / "key").write_bytes(b"\x99\x01")
    call = f"set -euo pipefail\n{function}\nkeyring=./a.gpg list=./a.list\nadd_line '{ADDED}'"
    run = subprocess.run(["bash", "-c", call], cwd=tmp_path, check=False, env={"PATH": f"{tmp_path}:/usr/bin:/bin"})
    assert (run.returncode == 0) is added
    assert (tmp_path / "a.list").exists() is added
    if added:
        line = (tmp_path / "a.list").read_text(encoding="utf-8")
        assert line == "deb [signed-by=./a.gpg] https://apt.acme.org/stable jammy main\n"
        assert (tmp_path / "a.gpg").read_bytes() == b"\x99\x01"


@pytest.mark.parametrize(
    ("host", "package", "added"),
    [
        ("packages.osrfoundation.org/gazebo", "ignition-dome", True),
        ("apt.acme.org", "ignition-dome", False),
    ],
)
def test_a_known_source_of_a_dockerfile_that_is_not_built(tree: Tree, host: str, package: str, added: bool) -> None:
    url = f"http://{host}/ubuntu-stable"
    recipe = (
        "FROM ubuntu:22.04\nARG user\n"
        f"RUN sh -c 'echo \"deb [trusted=yes] {url} `lsb_release -cs` main\" > /etc/apt/sources.list.d/a.list'\n"
        f"RUN apt-get update \\\n && apt-get install -y {package}\nRUN adduser ${{user}}\n"
    )
    found = tree(CODE | {"docker/Dockerfile": recipe, "README.md": "Tested on Ubuntu 22.04\n"})
    assert found.dockerfile is None
    assert [url in line for line in found.repositories] == [True] * added


@pytest.mark.parametrize(
    ("address", "added", "told"),
    [
        (
            "$(lsb_release -cs)",
            "deb [signed-by=https://apt.acme.org/acme.gpg] https://apt.acme.org/jammy jammy main",
            "",
        ),
        (
            "${UBUNTU_CODENAME}/x",
            "deb [signed-by=https://apt.acme.org/acme.gpg] https://apt.acme.org/jammy/x jammy main",
            "",
        ),
        ("$(lsb_release -rs)", None, "the page computes its address"),
        ("$VERSION", None, "the page computes its address"),
    ],
)
def test_the_release_in_an_address(tree: Tree, address: str, added: str | None, told: str) -> None:
    add = ADD.replace("apt.acme.org/stable", f"apt.acme.org/{address}")
    decision = tree(page(KEY, add, INSTALL))
    assert decision.repositories == ((added,) if added else ())
    assert any(told in each.message for each in decision.warnings) if told else True


STEPS = "jobs:\n  build:\n    runs-on: ${{ matrix.os }}\n    steps:\n"
STEP = "      - name: for one\n        if: matrix.os == '%s'\n        run: |\n          sudo apt-get install %s\n"


def workflow(*commands: str) -> str:
    lines = "".join(commands).replace("\\\n", "").splitlines()
    return STEPS + "      - run: |\n" + "".join(f"          {line}\n" for line in lines)


def test_a_source_that_ci_adds_is_added(tree: Tree) -> None:
    decision = tree({**page("cmake .\n"), ".github/workflows/build.yml": workflow(KEY, ADD, INSTALL)})
    assert decision.repositories == (ADDED,)


def test_a_source_of_ci_whose_key_came_without_https_is_told(tree: Tree) -> None:
    insecure = KEY.replace("https://", "http://")
    decision = tree({**page("cmake .\n"), ".github/workflows/build.yml": workflow(insecure, ADD, INSTALL)})
    assert decision.repositories == ()
    assert any("without https" in warning.message for warning in decision.warnings)


def test_of_a_matrix_only_the_step_for_this_ubuntu_counts(tree: Tree) -> None:
    steps = STEP % ("ubuntu-20.04", "libacme1-dev") + STEP % ("ubuntu-22.04", "libacme2-dev")
    text = "on: push\n" + STEPS + steps + "      - run: sudo apt-get install libacme-common-dev\n"
    decision = tree({**page("cmake .\n"), ".github/workflows/build.yml": text})
    assert decision.ubuntu == "focal"  # the first that CI names
    named = [name for name in decision.apt_guessed if name.startswith("libacme")]
    assert named == ["libacme-common-dev", "libacme1-dev"]


def test_a_condition_that_names_no_release_leaves_nothing_out(tree: Tree) -> None:
    steps = STEP % ("ubuntu-20.04", "libacme1-dev") + STEP.replace("==", "!=") % ("ubuntu-22.04", "libacme2-dev")
    apt = tree({**page("cmake .\n"), ".github/workflows/build.yml": STEPS + steps}).apt_guessed
    assert [name for name in apt if name.startswith("libacme")] == ["libacme1-dev", "libacme2-dev"]
