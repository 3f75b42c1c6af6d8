"""A package of Debian that the repository holds, and that a script or a page of it installs, is in the image."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.config.model import Config
from roslab.decide.decision import Decision
from roslab.plan.plan import make_plan
from roslab.render.dockerfile import dockerfile
from roslab.render.ignore import ignore
from roslab.values.dataclass import replace

Tree = Callable[[dict[str, str]], Decision]
FILE = "setup/libacmesdk-dev_1.4_amd64.deb"
MANIFEST = "<package format='3'><name>demo</name><buildtool_depend>ament_cmake</buildtool_depend>"
MANIFEST += "<depend>acmesdk</depend></package>"
FILES = {
    "src/demo/package.xml": MANIFEST,
    "src/demo/CMakeLists.txt": "project(demo)\nfind_package(ament_cmake REQUIRED)\nfind_package(ACMESDK REQUIRED)\n",
    FILE: "",
}
PAGE = "# Demo\nROS 2 Humble\n"


@pytest.mark.parametrize(
    "more",
    [
        {"setup/setup.bash": "sudo apt install git\nsudo dpkg -i libacmesdk-dev_1.4_amd64.deb\n"},
        {"README.md": f"{PAGE}## Install\n```\nsudo apt install ./{FILE}\n```\n"},
        {"README.md": f"{PAGE}## Install\n```\ncd setup\nsudo dpkg -i libacmesdk-dev_1.4_amd64.deb\n```\n"},
    ],
)
def test_what_the_tree_has_is_installed(tree: Tree, more: dict[str, str]) -> None:
    decision = tree({"README.md": PAGE, **FILES, **more})
    assert decision.own_packages == (FILE,)
    assert not [w.message for w in decision.warnings if "colcon will stop" in w.message or ".deb" in w.message]
    assert not [source for source in decision.source if source.name == "acmesdk"]
    assert decision.platforms == ("linux/amd64",), "CMake stops without it"
    plan = make_plan(decision, Config(), folder_name="demo", ignore=("*.deb", "setup/*"))
    text = dockerfile(plan)
    mounted = f"--mount=type=bind,source={FILE},target=/tmp/packages/libacmesdk-dev_1.4_amd64.deb"
    assert mounted in text
    assert text.index("install-own-packages /tmp/packages/") < text.rindex("    install-optional-apt")
    assert f"!{FILE}" in ignore(plan, ())
    assert "install-own-packages" not in dockerfile(replace(plan, own_packages=()))


@pytest.mark.parametrize(
    ("page", "told"),
    [
        ("sudo dpkg -i libother-dev_1.4_amd64.deb", True),
        ("wget https://x.example/libother-dev_1.4_amd64.deb", True),  # nothing installs it
        ("wget https://x.example/libother-dev_1.4_amd64.deb\nsudo dpkg -i *.deb", True),
        ("sudo dpkg -i libother-dev_1.4_amd64.deb\nwget https://x.example/libother-dev_1.4_amd64.deb", True),
        ("wget https://x.example/cuda-repo_12_amd64.deb\nsudo dpkg -i cuda-repo_12_amd64.deb", True),
        ("wget https://x.example/nvidia-driver-535_1_amd64.deb\nsudo dpkg -i nvidia-driver-535_1_amd64.deb", True),
        ("sudo apt install libacmesdk-dev", False),
    ],
)
def test_what_it_lacks_is_not(tree: Tree, page: str, told: bool) -> None:
    decision = tree({**FILES, "README.md": f"{PAGE}## Install\n```\n{page}\n```\n"})
    assert decision.own_packages == ()
    assert any("not part of the image" in each.message for each in decision.warnings) == told


@pytest.mark.parametrize(
    ("also", "called", "installed", "platforms"),
    [
        ("libacmesdk-dev_1.4_arm64.deb", False, True, ("linux/amd64", "linux/arm64")),
        ("libacmesdk-dev_1.5_arm64.deb", True, True, ("linux/amd64", "linux/arm64")),
        ("libother-dev_1.4_arm64.deb", True, True, ("linux/amd64",)),
        ("libacmesdk-dev_1.4_armhf.deb", False, False, ("linux/amd64",)),
    ],
)
def test_one_for_arm_beside_it_is_installed_there(
    tree: Tree, also: str, called: bool, installed: bool, platforms: tuple[str, ...]
) -> None:
    line = f"sudo dpkg -i setup/{also}\n" if called else ""
    page = f"{PAGE}## Install\n```\nsudo dpkg -i {FILE}\n{line}```\n"
    decision = tree({**FILES, f"setup/{also}": "", "README.md": page})
    assert decision.own_packages == ((FILE, f"setup/{also}") if installed else (FILE,))
    assert decision.platforms == platforms


@pytest.mark.parametrize(
    ("script", "text", "installed"),
    [
        ("tools/acme.sh", f"#!/bin/bash\nset -e\nsudo dpkg -i {FILE}\n", True),
        ("setup/acme.sh", f"#!/bin/bash\nsudo dpkg -i {FILE}\n", True),
        ("tools/acme.sh", f"#!/bin/bash\nsudo dpkg -i {FILE}\n./flash --board 1\n", False),
        ("tools/acme.sh", "#!/bin/bash\necho dpkg\n", False),
    ],
)
def test_a_script_that_only_installs_them(tree: Tree, script: str, text: str, installed: bool) -> None:
    assert tree({**FILES, script: text}).own_packages == ((FILE,) if installed else ())


@pytest.mark.parametrize(
    ("name", "installed"),
    [
        ("libacmesdk-dev_1.4_ubuntu22.04_amd64.deb", True),
        ("libacmesdk-dev_1.4_ubuntu20.04_amd64.deb", False),
        ("libacmesdk-dev_1.4~focal_amd64.deb", False),
        ("libacmesdk-dev_1.4+ubuntu1804_amd64.deb", False),
        ("libacmesdk-dev_1.4_debian12_amd64.deb", True),
    ],
)
def test_one_for_another_ubuntu_is_told(tree: Tree, name: str, installed: bool) -> None:
    page = f"{PAGE}## Install\n```\nsudo dpkg -i setup/{name}\n```\n"
    decision = tree({**FILES, f"setup/{name}": "", "README.md": page})
    assert decision.ubuntu == "jammy"
    assert decision.own_packages == ((f"setup/{name}",) if installed else ())
    told = [each.message for each in decision.warnings if each.message.startswith("not installed: setup/")]
    assert len(told) == (not installed)


URL = "https://x.example/v1.4/libother-dev_1.4_amd64.deb"


@pytest.mark.parametrize(
    "lines",
    [
        f"wget {URL}\nsudo dpkg -i libother-dev_1.4_amd64.deb",
        f"curl -LO {URL}\nsudo apt install -y ./libother-dev_1.4_amd64.deb",
        f"wget {URL} && sudo dpkg -i libother-dev_1.4_amd64.deb; sudo apt-get install -f",
    ],
)
def test_what_a_page_fetches_and_installs_is_installed(tree: Tree, lines: str) -> None:
    decision = tree({**FILES, "README.md": f"{PAGE}## Install\n```\n{lines}\n```\n"})
    assert decision.own_packages == (URL,)
    assert "libother-dev" in decision.apt_guessed  # apt has it then
    assert not [w.message for w in decision.warnings if ".deb" in w.message]
    plan = make_plan(decision, Config(), folder_name="demo", ignore=())
    assert f"    install-own-packages {URL}" in dockerfile(plan)
    assert "x.example" not in ignore(plan, ())


def test_a_fetched_one_for_another_ubuntu_is_told(tree: Tree) -> None:
    url = URL.replace("_1.4_", "_1.4-1focal_")
    page = f"wget {url}\nsudo dpkg -i {url.rpartition('/')[2]}"
    decision = tree({**FILES, "README.md": f"{PAGE}## Install\n```\n{page}\n```\n"})
    assert decision.own_packages == ()
    assert any(f"not installed: {url}, which is for Ubuntu focal" in w.message for w in decision.warnings)


@pytest.mark.parametrize("login", ["me:s3cret@", "s3cret@", "me%40lab:s3cret@", "a.b:s3cret@lab@"])
def test_an_address_with_a_login_goes_nowhere(tree: Tree, login: str) -> None:
    url = URL.replace("https://", f"https://{login}")
    page = f"sudo dpkg -i {FILE}\nwget {url}\nsudo dpkg -i libother-dev_1.4_amd64.deb"
    decision = tree({**FILES, "README.md": f"{PAGE}## Install\n```\n{page}\n```\n"})
    assert decision.own_packages == (FILE,)
    assert "s3cret" not in dockerfile(make_plan(decision, Config(), folder_name="demo", ignore=()))


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        (f"sudo dpkg -i {FILE}", "the repository holds"),
        (f"wget {URL}\nsudo dpkg -i libother-dev_1.4_amd64.deb", "a page has its readers fetch"),
        (
            f"sudo dpkg -i {FILE}\nwget {URL}\nsudo dpkg -i libother-dev_1.4_amd64.deb",
            "the repository holds or a page has its readers fetch",
        ),
    ],
)
def test_the_image_says_where_they_come_from(tree: Tree, lines: str, said: str) -> None:
    decision = tree({**FILES, "README.md": f"{PAGE}## Install\n```\n{lines}\n```\n"})
    text = dockerfile(make_plan(decision, Config(), folder_name="demo", ignore=()))
    assert f"# Packages that {said}: none of them stops the build\n" in text
