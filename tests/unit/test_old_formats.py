"""Old files through the whole pipeline: everything that they ask for stands in the Dockerfile, in the order of old.

The Dockerfile is taken apart into instructions and words; no text is compared. What is expected is read from the file
itself by PyYAML, not by the program's own reader.
"""

from __future__ import annotations

import dataclasses
import functools
import json
import os
import re
import shlex
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from roslab.config import read
from roslab.config.migrate import migrate
from roslab.decide import decide
from roslab.errors import ConfigurationError, RoslabError
from roslab.evidence.facts import Evidence
from roslab.evidence.gather import gather
from roslab.plan.plan import Plan, from_json, make_plan, to_json
from roslab.render import FILES, render_all
from roslab.repository.checkout import Repository

ROOT = Path(__file__).resolve().parents[2]
SHARED = Path(os.environ.get("REPRO_SHARED") or ROOT.parent / "shared") / "roslab-yaml"
REFUSED = {
    "ICRA-2018__Omni-CNN.v2": [(6, 'unknown key "apt-packages"', "did you mean `apt`?"), (9, "pip-packages", "`pip`")],
    "ICRA-2018__superquadric-grasp.v2": [(23, "no git URL that can be cloned", "tactile-control.git")],
}
OWN = {
    "paper": "name: vins\ndistro: kinetic\nbuild: catkin_make\nruntime: nvidia\nrepos: ['ppa:some/thing']\n"
    "packages: [ros-kinetic-cv-bridge, 'libeigen3-dev git']\npython-packages: [tensorflow==1.3, pandas]\n"
    "source:\n- {name: ceres, repo: 'https://h.org/ceres.git', depends: [libgoogle-glog-dev], build: cmake}\n"
    "- {name: glow, repo: 'https://h.org/glow.git', depends: null, build: catkin_build}\n"
    "volume: [{host_path: /media/data, container_path: /DATA, options: ro}]\ncustom: ['cd ws', 'make all']\n",
    "later": "name: dex-net\nbase: {ubuntu: 16.04, ros: kinetic-desktop-full, opengl: devel, cmake_update: 3.18.4}\n"
    "build: catkin_build\nrepo: ['ppa:some/thing']\napt: [libhdf5-dev, 'collada-dom2.4-dp*', 'xvfb=2:1.19.6-1']\n"
    "pip3: [GPy, -U matplotlib, 'git+https://h.org/a.git@1.0#egg=a']\npip: [numpy==1.11.3]\nsource:\n"
    "- {name: argos3, repo: 'https://h.org/argos3.git', checkout: d406b52, build: cmake, cmake_folder: ../src, "
    "make_command: make -j2 && make install, cmake_options: -DA=1, keep_source: true}\n"
    "- {name: opencv, zip: 'https://h.org/opencv/archive/3.3.0.zip', build: cmake, depends: [yasm]}\n"
    "- {name: pr2_common, repo: 'https://h.org/pr2_common.git', build: catkin_make}\n"
    "- {name: zipped, zip: 'https://h.org/zipped/archive/1.0.zip', build: catkin_make}\n"
    "custom: ['cd $HOME/dex-net', make, ldconfig]\n",
    "later-plain": "name: plain\nbase: {ubuntu: 18.04}\nbuild: cmake\ncmake_options: -DB=2\napt: [git]\npip: [numpy]\n",
    "later-cuda-ros": "name: both\nbase: {ubuntu: xenial, cuda: 8.0-runtime, cudnn: 6-runtime, ros: kinetic-ros-base}\n"
    "pip: [Cython]\nmatlab: {host_path: /usr/local/MATLAB/R2017a, mac_address: '2c:60:0c:d6:50:36'}\n",
    "later-icub": "name: icub\nbase: {ubuntu: 16.04, icub: binary}\nbuild: cmake\n",
    "interim": "name: ompl\nbase: {system: ubuntu, version: 18.04, cuda: '10.0'}\napt-packages: [cmake]\n"
    "pip-packages: [numpy]\npip3-packages: [torch]\n",
}
KEYS = {
    "apt": ("packages", "apt", "apt-packages"),
    "pip": ("python-packages", "pip", "pip-packages"),
    "pip3": ("pip3", "pip3-packages"),
    "repo": ("repos", "repo"),
}
PACKAGE = (
    '<package format="2"><name>talker</name><version>1.0.0</version><description>d</description>'
    '<maintainer email="a@example.org">a</maintainer><license>MIT</license><buildtool_depend>catkin</buildtool_depend>'
    "<depend>roscpp</depend></package>\n"
)
TREE = {
    "README.md": "# Talker\n\n```bash\n$ rosrun talker talker\n```\n",
    "package.xml": PACKAGE,
    "CMakeLists.txt": "cmake_minimum_required(VERSION 3.5)\nproject(talker)\nfind_package(catkin REQUIRED roscpp)\n"
    "find_package(Ceres REQUIRED)\ncatkin_package()\nadd_executable(talker talker.cpp)\n",
    "talker.cpp": '#include "ros/ros.h"\nint main() {}\n',
    "requirements.txt": "scipy==99\n",
    "setup.py": "from setuptools import setup\nsetup(name='talker', install_requires=['torch'])\n",
    "Dockerfile": "FROM ubuntu:12.04\nRUN true\n",
}


@functools.cache
def texts() -> dict[str, str]:
    """Return the files: this test's own, and the real ones where they lie beside the checkout."""
    real = {file.stem: file.read_text(encoding="utf-8") for file in sorted(SHARED.glob("*.yaml"))}
    return OWN | real


@pytest.fixture(scope="session")
def evidence(tmp_path_factory: pytest.TempPathFactory) -> Evidence:
    """Return what a small repository holds, with everything that an old generator never looked at."""
    folder = tmp_path_factory.mktemp("old") / "talker"
    folder.mkdir()
    for name, text in TREE.items():
        (folder / name).write_text(text)
    return gather(Repository.open(folder))


def planned(text: str, evidence: Evidence) -> Plan:
    config = read(text)
    return make_plan(decide(evidence, config, folder_name="talker"), config, folder_name="talker")


def files(plan: Plan) -> dict[str, str]:
    found = render_all(plan, readme=TREE["README.md"], output_is_root=True, context=".")
    return {file.path: file.text for file in found}


@dataclasses.dataclass(frozen=True)
class Instruction:
    """One instruction of a Dockerfile: its name, its text with the continued lines joined, and its words."""

    number: int
    name: str
    text: str

    @property
    def words(self) -> list[str]:
        lexer = shlex.shlex(self.text, posix=True, punctuation_chars=";&|(){}")
        lexer.whitespace_split, lexer.commenters = True, ""
        return list(lexer)


def instructions(dockerfile: str) -> list[Instruction]:
    """Return the instructions from the base on: the stage of scripts before it is the same for every repository."""
    lines = iter(
        re.sub(r"^FROM scratch AS scripts\n(?:.|\n)*?(?=^FROM )", "", dockerfile, flags=re.MULTILINE).splitlines()
    )
    found: list[Instruction] = []
    for line in lines:
        if not line.strip() or line.startswith("#"):
            continue
        text = line
        while text.endswith("\\"):
            text = text[:-1] + next(lines)
        name, _, rest = text.partition(" ")
        if end := re.search(r"<<'(\w+)'", rest):
            while next(lines) != end[1]:
                pass
        found.append(Instruction(len(found), name, rest))
    return found


def where(found: list[Instruction], command: str, word: str) -> int:
    """Return the number of the last RUN that holds a command and the word; a failure where there is none."""
    fits = [i for i in found if i.name == "RUN" and command in i.text and word in i.words]
    assert fits, f"{command}: {word!r} is nowhere"
    return fits[-1].number


def asked(data: dict[str, Any], kind: str) -> list[str]:
    items = [item for key in KEYS[kind] for item in data.get(key) or ()]
    return [word for item in items for word in (str(item).split() if kind != "repo" else [str(item)])]


def in_order(numbers: list[int], what: str) -> None:
    assert numbers == sorted(numbers), what


def checked(text: str, dockerfile: str) -> None:
    data: dict[str, Any] = yaml.safe_load(text)
    found = instructions(dockerfile)
    name = data["name"].lower()
    apt = [where(found, "apt", word) for word in asked(data, "apt")]
    pip3 = [where(found, "python3 -m pip install", option(word)) for word in asked(data, "pip3")]
    pip2 = [where(found, "python2 -m pip install", option(word)) for word in asked(data, "pip")]
    repositories = [where(found, "add-package-sources", word) for word in asked(data, "repo")]
    libraries: list[int] = []
    sisters: list[int] = []
    for source in [*(data.get("source") or ()), *(data.get("source-packages") or ())]:
        number, compiled_by = source_of(found, source)
        (libraries if compiled_by == "cmake" else sisters).append(number)
    jupyter = next(i.number for i in found if "bash_kernel.install" in i.text)
    copied = next(
        i.number for i in found if i.name == "COPY" and i.text.startswith("--chown") and i.words[-2:] == [".", "."]
    )
    made = [i.number for i in found if re.search(r"catkin_make -j|catkin build|&& cmake(?: .*)? \S*/home", i.text)]
    made = [number for number in made if number > copied]
    wanted = data.get("build") or ("cmake" if "system" in (data.get("base") or {}) else None)
    if "distro" not in data and not sisters:
        assert bool(made) == bool(wanted), "the later format built nothing where nothing was said"
    custom = custom_of(found, data)
    user = max(i.number for i in found if i.name == "USER")
    steps = [[jupyter], repositories, apt, pip3, pip2, libraries, sisters, [copied], made, custom]
    firsts = [min(step) for step in steps if step]
    in_order(firsts, "the steps come in the order of old")
    in_order(libraries, "libraries in the order of the file")
    in_order(sisters, "sister packages in the order of the file")
    assert found[user].text == "${NB_USER}"
    assert [i.text for i in found if i.name == "WORKDIR"][-1].endswith(f"/{name}")
    assert "scipy==99" not in dockerfile, "the old generators read no requirement files"
    base_of(found, data)
    if any(i.text.endswith(f"/ws/src/{name}") for i in found if i.name == "WORKDIR"):
        links = " ".join(i.text for i in found if "ln --symbolic" in i.text)
        assert f"/home/${{NB_USER}}/{name}" in links, "`cd $HOME/NAME` finds the source of a package"
        assert "/home/${NB_USER}/catkin_ws" in links


def option(word: str) -> str:
    return {"-U": "--upgrade"}.get(word, word)


def source_of(found: list[Instruction], source: dict[str, Any]) -> tuple[int, str]:
    url = re.sub(r"^git://", "https://", re.sub(r"-b \S+ |--branch \S+ ", "", source.get("repo") or source["zip"]))
    run = next((i for i in found if i.name == "RUN" and url in i.words), None)
    assert run, f"{url} is fetched nowhere"
    for word in (source.get("checkout"), *shlex.split(source.get("cmake_options") or "")):
        assert word is None or word in run.words
    for text in (source.get("make_command"), source.get("cmake_folder")):
        assert text is None or text in run.text
    if source["build"] == "cmake":
        assert "cmake" in run.words
        if source.get("keep_source"):
            assert "cp --recursive" in run.text
    for package in source.get("depends") or ():
        assert where(found, "apt-get install", package.strip()) < run.number
    return run.number, source["build"]


def custom_of(found: list[Instruction], data: dict[str, Any]) -> list[int]:
    commands = [command.strip() for command in data.get("custom") or ()]
    if not commands:
        return []
    if "distro" in data:  # one RUN each, as the user, in the home folder
        runs = [next(i for i in found if i.name == "RUN" and i.text == command) for command in commands]
        user, folder = "${NB_USER}", "/home/${NB_USER}"
    else:  # one chain as root, from / on
        chain = r"\s*&&\s*".join(map(re.escape, commands))
        runs = [i for i in found if i.name == "RUN" and re.fullmatch(chain, i.text)]
        assert len(runs) == 1
        user, folder = "root", "/"
    before = found[: runs[0].number]
    assert [i.text for i in before if i.name == "USER"][-1] == user
    assert [i.text for i in before if i.name == "WORKDIR"][-1] == folder
    assert user != "root" or any(i.name == "ENV" and "HOME=/home/${NB_USER}" in i.text for i in before)
    return [run.number for run in runs]


def base_of(found: list[Instruction], data: dict[str, Any]) -> None:
    image = found[0].words[0]
    base = data.get("base") or {}
    distro, _, variant = str(data.get("distro") or base.get("ros") or "").partition("-")
    if "runtime" in data:
        variant = "desktop-full"
    installed = {word for i in found if re.search("apt-get install|install-optional-apt", i.text) for word in i.words}
    if base.get("cuda"):
        assert image.startswith("nvidia/cuda:")
        assert image.endswith({"16.04": "16.04", "xenial": "16.04"}.get(str(base.get("ubuntu")), "18.04"))
    elif distro:
        assert image in {f"ros:{distro}-ros-base", f"ros:{distro}-ros-core"}
    else:
        assert (
            image
            == f"ubuntu:{ {'xenial': '16.04'}.get(str(base.get('ubuntu')), base.get('ubuntu') or base.get('version')) }"
        )
    if distro and (base.get("cuda") or variant not in {"", "ros-base", "ros-core"}):
        assert f"ros-{distro}-{variant or 'ros-base'}" in installed
    if base.get("cmake_update"):
        assert any(f"cmake-{base['cmake_update']}.tar.gz" in i.text for i in found)
    if base.get("icub"):
        assert any("install-icub" in i.words for i in found)


@pytest.mark.parametrize("name", texts())
def test_everything_that_an_old_file_asks_for_is_in_the_dockerfile(name: str, evidence: Evidence) -> None:
    text = texts()[name]
    if name in REFUSED:
        with pytest.raises(ConfigurationError) as caught:
            planned(text, evidence)
        told = [(problem.line, str(problem)) for problem in caught.value.problems]
        assert len(told) == len(REFUSED[name])
        for (line, message), (expected, what, hint) in zip(told, REFUSED[name], strict=True):
            assert line == expected
            assert what in message
            assert hint in message
        return
    plan = planned(text, evidence)
    written = files(plan)
    assert written.keys() == {file.path for file in FILES if file.goes_with != "bases"}
    checked(text, written["Dockerfile"])
    data = yaml.safe_load(text)
    script = written["docker_run.sh"]
    for volume in data.get("volume") or ():
        assert all(str(part) in script for part in volume.values())
    shown = bool(data.get("runtime") or (data.get("base") or {}).keys() & {"opengl", "cuda"})
    for key in ("gpu", "gui"):
        assert f"{key}={'yes' if shown else 'no'}\n" in script
    if "matlab" in data:
        assert data["matlab"]["host_path"] in script
        assert data["matlab"]["mac_address"] in script
        assert any("MATLAB" in warning.message for warning in plan.warnings)
    assert plan.notebook


def test_all_39_files_are_there(shared: Path) -> None:
    assert len(texts()) - len(OWN) == len(list((shared / "roslab-yaml").glob("*.yaml"))) == 39


def test_melodic_as_an_ubuntu_builds_with_a_warning(evidence: Evidence) -> None:
    plan = planned("name: rosin\nbase: {ubuntu: melodic, ros: melodic-ros-base}\n", evidence)
    assert plan.base_image == "ros:melodic-ros-base"
    assert [w for w in plan.warnings if "`ubuntu: melodic`" in w.message and w.line == 2]


def test_what_is_gone_is_mapped_with_a_reason(evidence: Evidence) -> None:
    plan = planned(OWN["later-cuda-ros"], evidence)
    assert plan.base_image.startswith("nvidia/cuda:11.")
    assert any("CUDA 8.0" in w.message and "deleted" in w.message for w in plan.warnings)
    text = files(plan)["Dockerfile"]
    wanted = "renew-package-sources --ros http://snapshots.ros.org/kinetic/final/ubuntu xenial ros-snapshots --add"
    assert wanted in text, "NVIDIA's image has no ROS"
    assert 'PATH="${PATH}:/usr/local/MATLAB/R2017a/bin"' in text
    ppa = planned(OWN["paper"].replace("some/thing", "chronitis/jupyter"), evidence)
    assert any("ppa:chronitis/jupyter" in w.message for w in ppa.warnings)


def test_requirements_that_an_old_generator_never_read_are_named(evidence: Evidence) -> None:
    left = [w.message for w in planned(OWN["later-plain"], evidence).warnings]
    assert [m for m in left if m.startswith("requirements.txt is not installed")]
    assert [m for m in left if m.startswith("setup.py is not installed")]


def test_a_source_without_a_ref_takes_the_one_that_the_package_names(tmp_path: Path) -> None:
    export = '<export><git_url target="glow" url="https://h.org/glow" branch="v0.1"/></export></package>'
    for name, text in (TREE | {"package.xml": PACKAGE.replace("</package>", export)}).items():
        (tmp_path / name).write_text(text)
    plan = planned(OWN["paper"], gather(Repository.open(tmp_path)))
    (glow,) = plan.workspace.sources
    assert glow.ref == "v0.1"
    assert any("glow has no `ref`; v0.1 is built" in w.message for w in plan.warnings)
    assert any("ceres has no `ref`: its latest commit" in w.message and w.line == 9 for w in plan.warnings)


@pytest.mark.parametrize(
    ("ubuntu", "python2"), [("16.04", True), ("20.04", True), ("22.04", True), ("24.04", False), ("26.04", False)]
)
def test_python_2_where_an_ubuntu_has_it(ubuntu: str, python2: bool, evidence: Evidence) -> None:
    plan = planned(f"format: 3\nkind: python\nbase: {{ubuntu: {ubuntu}}}\npip2: [enum34]\n", evidence)
    text = files(plan)["Dockerfile"]
    assert ("python2 -m pip install --no-cache-dir" in text) == python2
    assert "enum34" in text, "never dropped"
    assert any("no Python 2" in w.message for w in plan.warnings) != python2


def test_options_stay_with_their_own_list(evidence: Evidence) -> None:
    text = files(planned("name: x\nbase: {ubuntu: 16.04}\npip: [-U a]\npip3: [--pre b]\n", evidence))["Dockerfile"]
    runs = [i.words for i in instructions(text) if i.name == "RUN"]
    (first,) = [words for words in runs if "b" in words]
    (second,) = [words for words in runs if "a" in words]
    assert "--pre" in first
    assert "--upgrade" not in first[-3:]
    assert second[-2:] == ["--upgrade", "a"]


HOLES = {
    "name": "name: 'a; rm -rf ~'\n",
    "a host path": "name: a\nvolume: [{host_path: '/x\" --privileged \"', container_path: /y, options: ro}]\n",
    "a container path": "name: a\nvolume: [{host_path: /x, container_path: '/y:rw --privileged', options: ro}]\n",
    "options": "name: a\nvolume: [{host_path: /x, container_path: /y, options: 'ro\" --privileged \"'}]\n",
    "a package": "name: a\nPACKAGES: ['git; curl h.org | sh']\n",
    "a requirement": "name: a\nPIP: ['x; curl h.org | sh']\n",
    "a source": "name: a\nsource: [{name: b, repo: 'https://h.org/b; id', build: cmake}]\n",
    "a source's name": "name: a\nsource: [{name: ../../etc, repo: 'https://h.org/b', build: cmake}]\n",
    "a source's ref": "name: a\nsource: [{name: b, repo: '--upload-pack=id https://h.org/b', build: cmake}]\n",
    "a second instruction": 'name: a\ncustom: ["true\\nUSER root"]\n',
}
FORMATS = {
    "paper": ("distro: kinetic\nbuild: catkin_make\n", "packages", "python-packages"),
    "later": ("base: {ubuntu: 16.04}\n", "apt", "pip3"),
}


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("hole", HOLES)
def test_the_holes_of_the_original_are_refused(hole: str, form: str, evidence: Evidence) -> None:
    """The original wrote each of these into a Dockerfile or a script that then ran it."""
    head, packages, pip = FORMATS[form]
    text = head + HOLES[hole].replace("PACKAGES", packages).replace("PIP", pip)
    with pytest.raises(ConfigurationError) as caught:
        files(planned(text, evidence))
    assert all(problem.line for problem in caught.value.problems)


@pytest.mark.parametrize("form", ["paper", "later"])
def test_the_doors_of_the_original_are_shut(form: str, evidence: Evidence) -> None:
    """JupyterLab had no token and every address, the X cookie every reader, the ignore file replaced the author's."""
    written = files(planned(OWN[form], evidence))
    for path, text in written.items():
        assert not re.search(r"token='?'?$|0\.0\.0\.0:|(?:-p|--publish)[ =]8888|chmod a\+r", text, re.MULTILINE), path
    assert ".dockerignore" not in written
    assert "**/.git" in written["Dockerfile.dockerignore"].splitlines()
    assert "EXPOSE" not in written["Dockerfile"]
    assert "jupyter" not in [i.text for i in instructions(written["Dockerfile"]) if i.name == "CMD"][-1]
    assert "JUPYTER_TOKEN" in written["docker_run.sh"]


def plain(value: Any) -> Any:
    """Return a plan's data without what tells of the file that it came from: places, reasons, warnings, the format."""
    if isinstance(value, dict):
        aside = {"place", "generation", "reasons", "warnings"}
        return {key: plain(inner) for key, inner in value.items() if key not in aside}
    return [plain(inner) for inner in value] if isinstance(value, list) else value


@pytest.mark.parametrize("name", [name for name in texts() if name not in REFUSED])
def test_a_migrated_file_plans_the_same_image(name: str, evidence: Evidence) -> None:
    before = planned(texts()[name], evidence)
    today = migrate(texts()[name]).text
    assert read(today).generation == "today"
    after = planned(today, evidence)
    assert plain(json.loads(to_json(after))) == plain(json.loads(to_json(before)))
    assert files(after) == files(before)
    assert from_json(to_json(before)) == before


MUTANTS = int(os.environ.get("REPRO_MUTANTS", "800"))
"""Files tried; a campaign before a release takes more."""
SCALARS: st.SearchStrategy[Any] = st.one_of(
    st.none(), st.booleans(), st.integers(-1, 99_999), st.floats(0, 30, allow_nan=False), st.text(max_size=12),
    st.sampled_from(["kinetic", "16.04", "8.0-devel", "nvidia", "a; rm -rf ~", "$(id)", "-x", "https://h.org", "x\ny"]),
)  # fmt: skip
VALUES = st.recursive(
    SCALARS,
    lambda inner: st.one_of(
        st.lists(inner, max_size=3),
        st.dictionaries(st.sampled_from(["name", "repo", "build", "host_path", "ros", "cuda"]), inner, max_size=3),
    ),
    max_leaves=5,
)


def spots(data: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    for key, inner in data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ():
        yield (*path, key)
        yield from spots(inner, (*path, key))


@st.composite
def mutants(draw: st.DrawFn) -> str:
    """Return a file with one to three changes: a key gone, a value of another type, nested, doubled, the text cut."""
    text = draw(st.sampled_from(list(texts().values())))
    data = yaml.safe_load(text)
    for _ in range(draw(st.integers(1, 3))):
        paths = list(spots(data))
        if not paths:
            break
        *above, last = draw(st.sampled_from(paths))
        holder = functools.reduce(lambda inner, key: inner[key], above, data)
        match draw(st.sampled_from(["delete", "swap", "nest", "wrap", "double", "borrow"])):
            case "delete":
                del holder[last]
            case "swap":
                holder[last] = draw(VALUES)
            case "nest":
                holder[last] = {draw(st.sampled_from(["name", "apt", "base"])): holder[last]}
            case "wrap":
                holder[last] = [holder[last]]
            case "double" if isinstance(holder, list):
                holder.append(holder[last])
            case _:
                other = yaml.safe_load(draw(st.sampled_from(list(texts().values()))))
                data[draw(st.sampled_from(sorted(other)))] = other[draw(st.sampled_from(sorted(other)))]
    text = yaml.safe_dump(data, default_flow_style=draw(st.sampled_from([None, True, False])), sort_keys=False)
    match draw(st.sampled_from(["whole", "whole", "whole", "cut", "doubled lines"])):
        case "cut":
            return text[: draw(st.integers(0, len(text)))]
        case "doubled lines":
            lines = text.splitlines(keepends=True)
            at = draw(st.integers(0, len(lines) - 1))
            return "".join([*lines[: at + 1], *lines[at:]])
    return text


@settings(max_examples=MUTANTS, derandomize=True, deadline=None, database=None, suppress_health_check=list(HealthCheck))
@given(text=mutants())
def test_no_mutant_breaks_the_pipeline(text: str, evidence: Evidence) -> None:
    try:
        written = files(planned(text, evidence))
    except RoslabError:
        return
    instructions(written["Dockerfile"])
    COUNTS.append(text)


COUNTS: list[str] = []
"""The mutants that gave a Dockerfile all the same."""


def test_enough_mutants_got_through() -> None:
    assert len(COUNTS) > MUTANTS / 10, "the mutants are so wild that nothing beyond the reader is tried"
