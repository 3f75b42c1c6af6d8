"""Old files as files of today: the same image, the comments kept."""

import pathlib

import pytest
import yaml

from roslab.config import read
from roslab.config.migrate import comparable, migrate
from roslab.config.written import written
from roslab.errors import ConfigurationError


def same(old: str, new: str) -> bool:
    return comparable(read(old)) == comparable(read(new))


def test_every_format_becomes_todays(checkout: pathlib.Path) -> None:
    for file in sorted((checkout / "tests" / "data" / "config" / "good").glob("*.yaml")):
        text = file.read_text(encoding="utf-8")
        migration = migrate(text)
        config = read(migration.text)
        assert config.generation == "today", file
        assert comparable(config) == comparable(read(text)), file
        assert bool(migration.changes) == (read(text).generation != "today"), file
        assert not any("written anew" in change for change in migration.changes), file
        assert migrate(migration.text).changes == (), file
        if file.name != "interim.yaml":
            comments = [line.partition("#")[2] for line in text.splitlines() if " #" in line or line.startswith("#")]
            assert all(comment in migration.text for comment in comments), file


def test_real_files(shared: pathlib.Path) -> None:
    results = {}
    for file in sorted((shared / "roslab-yaml").glob("*.yaml")):
        text = file.read_text(encoding="utf-8")
        try:
            migration = migrate(text)
        except ConfigurationError:
            results[file.name] = "refused"
            continue
        assert same(text, migration.text), file
        results[file.name] = "written anew" if any("anew" in change for change in migration.changes) else "edited"
    assert [name for name, result in results.items() if result == "refused"] == [
        "ICRA-2018__Omni-CNN.v2.yaml",
        "ICRA-2018__superquadric-grasp.v2.yaml",
    ]
    assert "written anew" not in results.values()


def test_a_paper_file_in_full() -> None:
    old = "# mine\nname: a   # the name\n\ndistro: kinetic\nruntime: nvidia  # we draw\n"
    old += "packages:\n  - git # tool\npython-packages: [numpy]\ncustom:\n- make\n"
    migration = migrate(old)
    assert migration.text == (
        "# mine\nformat: 3\ncompatible: paper\nnotebook: true\nname: a   # the name\n\n"
        "base: {ros: kinetic-desktop-full, opengl: devel}\ngpu: true\ngui: true  # we draw\napt:\n  - git # tool\n"
        "pip2: [numpy]\ncustom:\n  user: jovyan\n  folder: home\n  chained: false\n  commands:\n  - make\n"
    )
    assert migration.changes == (
        "new: `format: 3`, the mark of a file of today",
        (
            "new: `compatible: paper`, as before: what the file names is installed, old paths work; "
            "take it out for today's way"
        ),
        "new: `notebook: true`, as every image of the old formats held JupyterLab",
        "line 4: `distro` becomes `base: {ros: kinetic-desktop-full, opengl: devel}`",
        "line 5: `runtime: nvidia` becomes `gpu: true` and `gui: true`",
        "line 6: `packages` becomes `apt`",
        "line 8: `python-packages` becomes `pip2`",
        "line 9: `custom` says who runs it and where: user: jovyan, folder: home, chained: false",
    )


def test_a_later_file_in_full() -> None:
    old = (
        "name: Demo\nbase:\n  ubuntu: melodic # sic\n  opengl: runtime\npip:\n  - numpy\nsource:\n"
        "  - name: a\n    repo: -b v1.0 git://h.org/a.git # old\n    checkout: v1.0\n"
        "  - name: b\n    repo: --branch 1.0 https://h.org/b.git\n    build: cmake\n"
        "custom:\n  # first\n  - cd /tmp # then\n  - make\n"
        "volume:\n  - host_path: /a\n  - container_path: /b\napt: git cmake\n"
    )
    assert migrate(old).text == (
        "format: 3\ncompatible: later\nnotebook: true\ngpu: true\ngui: true\nbuild: none\nname: demo\n"
        "base:\n  ubuntu: bionic # sic\n  opengl: runtime\n"
        "pip2:\n  - numpy\nsource:\n"
        "  - name: a\n    repo: https://h.org/a.git # old\n    ref: v1.0\n"
        '  - name: b\n    repo: https://h.org/b.git\n    ref: "1.0"\n    build: cmake\n'
        "custom:\n  user: root\n  folder: /\n  chained: true\n  commands:\n  # first\n  - cd /tmp # then\n  - make\n"
        'volume:\n  - host_path: /a\n    container_path: /b\napt: ["git", "cmake"]\n'
    )


@pytest.mark.parametrize(
    "text",
    [
        "{name: a, distro: kinetic, runtime: nvidia, custom: [a, 'b # c'], packages: git curl}",
        "? name\n: a\n? distro\n: kinetic\n",
        "distro: kinetic\r\nname: a\r\nruntime: nvidia\r\ncustom:\r\n  - a\r\n",
        "\ufeffname: a\npip: [b]",
        "name: a\ncustom: |\n  make\n",
        "name: a\ncustom:\n- >\n  make\n  all\n- b\n",
        "'pip' : [a]",
        "runtime: nvidia",
        "runtime: nvidia\ngui: false\ngpu: false\ndistro: melodic",
        "packages: &p [git]\ndistro: kinetic\nsource:\n - name: a\n   repo: https://h.org/b\n   depends: *p\n",
        "custom: &c [a]\nname: x",
        "custom: &c\n  - a\nname: x",
        "env: {A: '#'}\n# end",
        "x-y: 1",
        "base: {system: ubuntu, version: 16.04, opengl: devel, cuda: 9.0}",
        "pip3: -U numpy\npip: [-f https://h.org/w torch]\nrequirements: []\nvcs: []\n",
        "volume: [{host_path: /a}, {container_path: /b}]",
        "name: a\n\n\n# only comments follow\n",
    ],
)
def test_unusual_layouts_mean_the_same_afterwards(text: str) -> None:
    try:
        before = comparable(read(text))
    except ConfigurationError:
        with pytest.raises(ConfigurationError):
            migrate(text)
        return
    migration = migrate(text)
    assert comparable(read(migration.text)) == before
    assert yaml.safe_load(migration.text)["format"] == 3


def test_what_is_wrong_is_not_migrated() -> None:
    with pytest.raises(ConfigurationError, match=r"mine\.yaml:1:1"):
        migrate("apt-packages: [git]", file="mine.yaml")


def test_the_model_can_be_written_as_a_file(checkout: pathlib.Path) -> None:
    for file in sorted((checkout / "tests" / "data" / "config" / "good").glob("*.yaml")):
        config = read(file.read_text(encoding="utf-8"))
        assert comparable(read(written(config))) == comparable(config), file
