"""What apt's own index of files is asked, and what its answer repairs."""

from __future__ import annotations

import io
import os
import re
import subprocess
from pathlib import Path

import pytest

from roslab.cli.repairing import given
from roslab.explain.answer import Answer, explain
from roslab.pipeline import plan_repository
from roslab.render import dockerfile
from roslab.repair.change import Change, Repair
from roslab.repair.holders import changes, completed, sought

SCRIPT = Path(__file__).parents[3] / "scripts/roslab/render/image_scripts/packages-holding.sh"
HEADER = "/src/main.cpp:1:10: fatal error: fstrcmp.h: No such file or directory"


def answer(*lines: str) -> Answer:
    said = "".join(f"#6 1.2 {line}\n" for line in lines)
    log = f'#6 [3/4] RUN make\n{said}#6 ERROR: process "/bin/sh -c make" did not complete: exit code: 1\n'
    return explain(io.BytesIO(log.encode()))


@pytest.mark.parametrize(
    ("lines", "held"),
    [
        ((HEADER,), ("usr/include/fstrcmp.h", "usr/include/x86_64-linux-gnu/fstrcmp.h", "usr/include/one/fstrcmp.h")),
        (
            ("/usr/bin/ld: cannot find -lfstrcmp",),
            ("usr/lib/libfstrcmp.so", "usr/lib/aarch64-linux-gnu/libfstrcmp.a"),
        ),
        (
            (
                "CMake Error at CMakeLists.txt:4 (find_package):",
                '  By not providing "FindZoo++.cmake" in CMAKE_MODULE_PATH',
            ),
            ("usr/lib/x86_64-linux-gnu/cmake/zoo/Zoo++Config.cmake", "usr/share/zoo/zoo++-config.cmake"),
        ),
        (
            ("configure: error: Package requirements (zoo-2.0) were not met:",),
            ("usr/lib/x86_64-linux-gnu/pkgconfig/zoo-2.0.pc", "usr/share/pkgconfig/zoo-2.0.pc"),
        ),
        (
            ("./robot: error while loading shared libraries: libzoo.so.7: cannot open shared object file",),
            ("usr/lib/x86_64-linux-gnu/libzoo.so.7", "lib/x86_64-linux-gnu/libzoo.so.7", "usr/lib/libzoo.so.7"),
        ),
        (("/bin/sh: 1: zoo: not found",), ("usr/bin/zoo", "sbin/zoo")),
    ],
)
def test_the_paths_are_those_under_which_a_package_holds_what_is_missing(
    lines: tuple[str, ...], held: tuple[str, ...]
) -> None:
    (one,) = sought(answer(*lines))
    for path in held:
        assert any(re.fullmatch(wanted, path) for wanted in one.paths), path
    for path in ("usr/share/doc/fstrcmp.h", "usr/include/a/b/fstrcmp.h", "usr/lib/libzooXso.7", "opt/bin/zoo"):
        assert not any(re.fullmatch(wanted, path) for wanted in one.paths), path


def test_each_of_several_is_sought() -> None:
    found = sought(answer("/usr/bin/ld: cannot find -lzoo", "/usr/bin/ld: cannot find -larm"))
    assert [one.paths[0].rpartition(")?")[2] for one in found] == [r"libzoo\.(so|a)", r"libarm\.(so|a)"]


def test_nothing_is_sought_where_no_file_is_missing() -> None:
    assert sought(answer("main.cpp:3:9: error: expected primary-expression before ';' token")) == ()


@pytest.mark.parametrize(
    ("said", "wanted"),
    [
        ("1 libfstrcmp-dev\n", ["apt: [libfstrcmp-dev]"]),
        ("2 libfstrcmp-dev\n", ["apt: [libfstrcmp-dev]"]),
        ("1 libfstrcmp-dev\n2 libother-dev\n", ["apt: [libfstrcmp-dev]"]),  # the likelier path
        ("1 fstrcmp-doc\n1 libfstrcmp-dev\n", ["apt: [libfstrcmp-dev]"]),
        (
            "1 libone-dev\n1 libtwo-dev\n",
            ["the header fstrcmp.h (main.cpp:1) is in libone-dev and libtwo-dev: name one under `apt`"],
        ),
        (
            "".join(f"1 {name}\n" for name in ("aa", "bb", "cc", "dd", "ee", "ff", "gg")),
            ["the header fstrcmp.h (main.cpp:1) is in aa, bb, cc, dd, ee and 2 more: name one under `apt`"],
        ),
        ("", ["no package of the image's sources holds the header fstrcmp.h (main.cpp:1)"]),
    ],
)
def test_one_package_that_holds_it_is_certain(tmp_path: Path, said: str, wanted: list[str]) -> None:
    (tmp_path / "CMakeLists.txt").write_text("project(robot CXX)\nadd_executable(robot main.cpp)\n")
    (tmp_path / "main.cpp").write_text("#include <fstrcmp.h>\nint main() {}\n")
    found = list(changes(sought(answer(HEADER)), said, given(plan_repository(tmp_path))))
    assert [str(one) for one in found] == wanted
    assert all(one.certain for one in found if isinstance(one, Change))


def test_the_reasons_of_other_failures_stay(tmp_path: Path) -> None:
    (tmp_path / "roslab.yaml").write_text("format: 3\nkind: cpp\napt: [libzoo-dev]\n")
    (tmp_path / "CMakeLists.txt").write_text("project(robot CXX)\n")
    what, told = given(plan_repository(tmp_path)), Repair(refused=(("disk-full", "free some"), ("header-missing", "?")))
    for said, reason in (
        ("", "no package of the image's sources holds the header fstrcmp.h"),
        ("1 libzoo-dev\n", "roslab.yaml has libzoo-dev already, and that did not help"),
    ):
        found = completed(told, answer(HEADER), what, lambda _, said=said: said)  # type: ignore[misc]
        assert found == Repair(refused=(("header-missing", reason), ("disk-full", "free some")))


@pytest.mark.parametrize(("code", "said"), [(0, "1 libzoo-dev\n1 zoo2\n"), (1, ""), (3, None)])
def test_without_an_index_of_files_nobody_says_that_no_package_holds_it(
    tmp_path: Path, code: int, said: str | None
) -> None:
    asked = tmp_path / "asked"
    asked.write_text("usr/include/zoo\\.h\n")
    lines = "libzoo-dev: /usr/include/zoo.h\nzoo2: /usr/include/zoo.h\n" if code == 0 else ""
    for name, does in (
        ("apt-get", "echo noise"),
        ("apt-file", f"[ $1 = search ] || exit 0\necho \"$*\" >{tmp_path}/called\nprintf '{lines}'\nexit {code}"),
    ):
        (tmp_path / name).write_text(f"#!/bin/bash\n{does}\n")
        (tmp_path / name).chmod(0o755)
    path = f"{tmp_path}:{os.environ['PATH']}"
    ran = subprocess.run(
        ["bash", SCRIPT, asked], env={**os.environ, "PATH": path}, capture_output=True, text=True, check=False
    )
    assert (ran.stdout if ran.returncode == 0 else None) == said
    assert (tmp_path / "called").read_text() == "search --regexp ^/usr/include/zoo\\.h$\n"


def test_the_question_is_put_to_the_base_and_its_sources(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text(
        '<package format="2"><name>robot</name><version>1.0.0</version><description>d</description><maintainer '
        'email="a@example.org">a</maintainer><license>MIT</license><buildtool_depend>catkin</buildtool_depend></package>'
    )
    (tmp_path / "CMakeLists.txt").write_text("project(robot)\n")
    (tmp_path / "roslab.yaml").write_text("format: 3\nbase: {ros: noetic}\n")
    plan = plan_repository(tmp_path).plan
    text = dockerfile.holders(plan, ["usr/include/zoo\\.h", "usr/bin/zoo"])
    assert "--mount" not in text.rpartition("ARG ASKED")[2]
    assert f"FROM {plan.base_image} AS base\n" in text
    assert "renew-package-sources --ros" in text
    assert (
        "ARG ASKED\nRUN : ${ASKED} && packages-holding\n"
        "COPY <<'EOF' /asked\nusr/include/zoo\\.h\nusr/bin/zoo\nEOF\n"
        "RUN : ${ASKED} && packages-holding /asked >/answer\n"
    ) in text
    assert "apt-get install --yes --no-install-recommends build-essential" not in text
    assert text.endswith("FROM scratch\nCOPY --from=base /answer /\n")
