"""The benchmark of repositories that nobody prepared: whose a failure is, what is measured, what its pages say."""

from __future__ import annotations

import csv
import re
from dataclasses import replace
from pathlib import Path

import pytest
from benchmarks.running import blame, page
from benchmarks.running.figures import over_time, sums
from benchmarks.running.rows import OUTCOMES, Listed, Outcome, Row, Whose, chosen, due, listed, read, write
from benchmarks.running.standins import Base, facts

FOCAL = Base(
    name="ros:noetic-ros-base",
    ubuntu="focal",
    python="3.8",
    stand_in="Debian 12",
    lacking=frozenset({"nmea_msgs", "rviz", "velodyne_msgs"}),
)
NOBLE = replace(FOCAL, ubuntu="noble", python="3.12")
OLDEST = replace(FOCAL, name="ubuntu:20.04", stand_in="Debian 11")
BIONIC = replace(OLDEST, ubuntu="bionic", python="3.6")
EDITION = "error: this version of Cargo is older than the `2021` edition, and only supports `2015` and `2018` editions."
REAL = replace(FOCAL, stand_in="", lacking=frozenset())
ASKED = (
    'Could not find a configuration file for package "OpenCV" that is compatible with requested version "{}".\n#9 1.1\n'
)
ASKED += "#9 1.1   The following configuration files were considered but not accepted:\n#9 1.1\n"
ASKED += "#9 1.1     /usr/lib/cmake/opencv4/OpenCVConfig.cmake, version: 4.5.1"
UNFIT = 'CMake Error: Could NOT find Boost: Found unsuitable version "{}", but required is {} "{}" (found /usr/include)'
BOOST = "/ws/src/a.cpp:8:30: error: '_1' was not declared in this scope"
HIDDEN = (
    "/usr/bin/ld: liba.a(loop.cpp.o): relocation R_X86_64_PC32 against undefined hidden symbol "
    "`_ZTCN5boost10wrapexceptINS_17bad_function_callEEE0_NS_16exception' can not be used when making a PIE object"
)
GENERATORS = """\
CMake Error at CMakeLists.txt:14 (find_package):
#9 1.0   By not providing "Findrosidl_default_generators.cmake" in CMAKE_MODULE_PATH
#9 1.0   this project has asked CMake to find a package configuration file provided
#9 1.0   by "rosidl_default_generators", but CMake did not find one."""
TWO = f"{GENERATORS}\n#9 1.1 " + GENERATORS.replace("rosidl_default_generators", "{0}")
JAZZY = replace(NOBLE, name="ros:jazzy-ros-base")
CERES = "/usr/include/ceres/internal/jet_traits.h:118:21: error: 'enable_if_t' is not a member of 'std'"
JAMMY = replace(FOCAL, name="ubuntu:22.04", ubuntu="jammy", python="3.10")
FORMAT = "/src/a.hpp:7:10: fatal error: format: No such file or directory"
CHOSEN = """\
Could not find compiler set in environment variable CC:
#9 1.1
#9 1.1   gcc-14.
#9 1.1 CMake Error: CMAKE_C_COMPILER not set"""
TAKEN = "Note, selecting 'clang-14' for regex 'g++-14'"
APT = "E: Unable to locate package {}"
NO_ARGUMENTS = "src/Matrix.c:45:40: error: unknown type name 'PyNoArgsFunction'; did you mean 'PyCFunction'?"
WHEEL = """\
Collecting matplotlib<3.6
#9 1.1   Downloading matplotlib-{release}.tar.gz (35.9 MB)
#9 1.2   error: subprocess-exited-with-error
#9 1.3   src/a.c:1:2: error: too few robots"""
OTHER_WHEEL = "#9 1.4   ERROR: Failed building wheel for armpy\n#9 1.5   ERROR: Failed building wheel for matplotlib"
INDEX = """\
WARNING: Retrying (Retry(total=0)) after connection broken by 'NewConnectionError': /whl/cpu/torch/
#9 2.0 ERROR: No matching distribution found for torch==1.13.1+cpu"""
CONFLICT = """\
ERROR: Cannot install {0} because these package versions have conflicting dependencies.
#9 1.1
#9 1.1 The conflict is caused by:
#9 1.1     The user requested {0}
#9 1.1     {1}"""
OLD = "tensorflow-gpu==1.13.2"
LOG = """\
#9 [5/5] RUN catkin_make
#9 1.0 {error}
#9 ERROR: process "/bin/sh -c catkin_make" did not complete successfully: exit code: 1
------
 > [5/5] RUN catkin_make:
------
ERROR: failed to solve: process "/bin/sh -c catkin_make" did not complete successfully: exit code: 1
"""


@pytest.mark.parametrize(
    ("error", "base", "whose"),
    [
        (BOOST, FOCAL, "stand-in"),
        (BOOST, REAL, "ours or the code's"),
        (BOOST, NOBLE, "ours or the code's"),
        (GENERATORS, JAZZY, "stand-in"),
        (GENERATORS, replace(NOBLE, name="ubuntu:24.04"), "ours or the code's"),
        (TWO.format("action_msgs"), JAZZY, "stand-in"),  # which the real base has
        (TWO.format("nav2_msgs"), JAZZY, "ours or the code's"),  # which it lacks, too
        (GENERATORS, FOCAL, "ours or the code's"),
        ("E: Unable to locate package nvidia-cuda-toolkit", NOBLE, "stand-in"),
        (f"{APT.format('libarm-dev')}\n#9 1.1 {APT.format('nvidia-cuda-toolkit')}", NOBLE, "ours or the code's"),
        (f"{APT.format('g++-14')}\n#9 1.1 {APT.format('nvidia-cuda-toolkit')}", NOBLE, "stand-in"),
        ("E: Unable to locate package nvidia-cuda-toolkit", replace(NOBLE, ubuntu="trusty"), "ours or the code's"),
        ("E: Unable to locate package nvidia-cuda-toolkit-12-4", NOBLE, "ours or the code's"),
        (HIDDEN, replace(FOCAL, ubuntu="bionic"), "stand-in"),
        (HIDDEN, replace(FOCAL, ubuntu="jammy", python="3.10"), "ours or the code's"),
        ("/usr/include/pcl/pcl_config.h:7:4: error: #error PCL requires C++14 or above", FOCAL, "ours or the code's"),
        ("/usr/include/pcl/pcl_config.h:7:4: error: #error PCL requires C++14 or above",
         replace(FOCAL, ubuntu="bionic"), "stand-in"),
        ("a.cpp:7:8: error: 'pcl_isnan' was not declared in this scope", FOCAL, "stand-in"),
        ("a.cpp:7:8: error: 'pcl_isnan' was not declared in this scope",
         replace(FOCAL, ubuntu="jammy", python="3.10"), "ours or the code's"),
        ("a.cpp:23:8: error: 'uint64_t' is not a member of 'pcl'", FOCAL, "stand-in"),
        ("a.cpp:23:8: error: 'uint64_t' is not a member of 'pcl'",
         replace(FOCAL, ubuntu="jammy", python="3.10"), "ours or the code's"),
        (ASKED.format("2.4"), replace(OLDEST, ubuntu="xenial"), "stand-in"),
        (ASKED.format("2.4"), OLDEST, "ours or the code's"),
        (ASKED.format("3"), replace(OLDEST, ubuntu="xenial"), "ours or the code's"),
        (ASKED.format("4.5"), replace(OLDEST, ubuntu="jammy", stand_in="Debian 11"), "ours or the code's"),
        (ASKED.format("2.4").replace("4.5.1", "3.4.9"), replace(OLDEST, ubuntu="xenial"), "ours or the code's"),
        (UNFIT.format("1.74.0", "at least", "1.80"), NOBLE, "stand-in"),
        (UNFIT.format("1.74.0", "exact version", "1.83"), NOBLE, "stand-in"),
        (UNFIT.format("1.74.0", "exact version", "1.80"), NOBLE, "ours or the code's"),
        (UNFIT.format("1.70.0", "at least", "1.80"), NOBLE, "ours or the code's"),  # one that the build brought
        ("a.cpp:1:10: fatal error: nmea_msgs/Sentence.h: No such file or directory", FOCAL, "stand-in"),
        ("a.cpp:1:10: fatal error: sensor_msgs/Imu.h: No such file or directory", FOCAL, "ours or the code's"),
        ("a.cpp:1:10: fatal error: pluginlib/class_list_macros.h: No such file or directory", FOCAL, "stand-in"),
        ("a.cpp:1:10: fatal error: pluginlib/class_list_macros.h: No such file or directory",
         NOBLE, "ours or the code's"),
        ("a.h:1:10: fatal error: pluginlib/class_loader.h: No such file or directory", FOCAL, "stand-in"),
        (EDITION, OLDEST, "stand-in"),
        (EDITION, replace(OLDEST, ubuntu="bionic"), "ours or the code's"),
        ("Package 'pluginlib', required by 'rosbag_storage', not found", replace(FOCAL, ubuntu="bionic"), "stand-in"),
        (CERES, replace(FOCAL, ubuntu="bionic"), "stand-in"),
        ("E: Package 'libav-tools' has no installation candidate", replace(FOCAL, ubuntu="xenial"), "stand-in"),
        ("E: Package 'libav-tools' has no installation candidate", FOCAL, "ours or the code's"),
        ("a.cpp:42:3: error: 'av_register_all' was not declared in this scope", FOCAL, "stand-in"),
        ("a.cpp:42:3: error: 'av_register_all' was not declared in this scope", NOBLE, "ours or the code's"),
        ("E: Package 'python-pip' has no installation candidate", replace(FOCAL, ubuntu="xenial"), "stand-in"),
        ("E: Package 'python-pip' has no installation candidate", FOCAL, "ours or the code's"),
        (CERES, replace(FOCAL, ubuntu="jammy", python="3.10"), "ours or the code's"),
        ("a.h:46:8: error: 'shared_ptr' in namespace 'std' does not name a template type", FOCAL, "stand-in"),
        ("fatal: unable to access 'https://github.com/a/b/': Could not resolve host: github.com", FOCAL, "stand-in"),
        ("a.cpp:2:10: fatal error: zmq.hpp: No such file or directory", FOCAL, "stand-in"),
        ("a.cpp:2:10: fatal error: zmq.hpp: No such file or directory", NOBLE, "ours or the code's"),
        (FORMAT, NOBLE, "stand-in"),
        (FORMAT, JAMMY, "ours or the code's"),
        (f"{TAKEN}\n#9 1.1 {CHOSEN}", NOBLE, "stand-in"),
        (f"{TAKEN}\n#9 1.1 {CHOSEN}", JAMMY, "ours or the code's"),
        (CHOSEN, NOBLE, "ours or the code's"),  # nothing installs it
        (APT.format("g++-14"), NOBLE, "stand-in"),
        (APT.format("g++-14"), JAMMY, "ours or the code's"),
        (NO_ARGUMENTS, OLDEST, "stand-in"),
        (NO_ARGUMENTS, NOBLE, "ours or the code's"),
        ("src/a.c:4:33: error: ‘PyNoArgsFunction’ undeclared (first use in this function)", OLDEST, "stand-in"),  # noqa: RUF001
        (WHEEL.format(release="3.5.3"), JAMMY, "stand-in"),
        (WHEEL.format(release="3.4.3"), JAMMY, "ours or the code's"),  # neither Python has a wheel of that
        (WHEEL.format(release="3.6.2"), JAMMY, "ours or the code's"),  # both have
        (WHEEL.format(release="3.5.3"), OLDEST, "ours or the code's"),
        (WHEEL.format(release="3.5.3").replace("matplotlib", "other"), JAMMY, "ours or the code's"),
        (f"{WHEEL.format(release='3.5.3')}\n{OTHER_WHEEL}", JAMMY, "ours or the code's"),
        (CONFLICT.format(OLD, f"The user requested (constraint) {OLD}"), BIONIC, "stand-in"),
        (CONFLICT.format(OLD, f"The user requested (constraint) {OLD}"), OLDEST, "ours or the code's"),
        (CONFLICT.format(OLD, "The user requested (constraint) tensorflow-gpu==1.14.0"), BIONIC, "ours or the code's"),
        (CONFLICT.format(OLD, "tensorflow-gpu 1.13.2 depends on six>=1.10"), BIONIC, "ours or the code's"),
        (CONFLICT.format("tensorflow==2.6.0", "The user requested (constraint) tensorflow==2.6.0"), OLDEST,
         "ours or the code's"),
        (CONFLICT.format("gym==0.2 and tensorflow==1.13.2", "gym 0.2 depends on six"), BIONIC, "ours or the code's"),
        (INDEX, FOCAL, "stand-in"),
        (INDEX, REAL, "ours or the code's"),
        ("fatal: unable to access 'https://github.com/a/b/': Could not resolve host: github.com", REAL,
         "ours or the code's"),
    ],
)  # fmt: skip
def test_whose_a_failed_build_is(error: str, base: Base, whose: str) -> None:
    assert blame.of_build(LOG.format(error=error), base)[0] == whose


@pytest.mark.parametrize(
    ("package", "variable", "base", "whose"),
    [
        ("ros-noetic-libnmea-msgs", "NMEA", FOCAL, "ours or the code's"),
        ("ros-noetic-nmea-msgs", "LIBNMEA_MSGS", FOCAL, "stand-in"),
        ("ros-noetic-nmea-msgs", "NMEA_MSGS", REAL, "ours or the code's"),
        ("libnmea-dev", "NMEA", FOCAL, "ours or the code's"),
        ("libnmea-dev", "NMEA_MSGS", FOCAL, "stand-in"),  # the variable alone names what the stand-in lacks
    ],
)
def test_a_library_that_only_the_stand_in_leaves_out(package: str, variable: str, base: Base, whose: str) -> None:
    error = (
        "CMake Error: The following variables are used in this project, but they are set to NOTFOUND.\n"
        "#9 1.2 Please set them or make sure they are set and tested correctly in the CMake files:\n"
        f"#9 1.2 {variable}_INCLUDE_DIR\n#9 1.2    used as include directory in directory /ws/src/a"
    )
    log = f"#6 [4/5] RUN install-optional-apt {package}\n#6 1.0 roslab: left out: apt {package}\n{LOG}"
    assert blame.of_build(log.format(error=error), base)[0] == whose


def test_an_image_of_a_stage_that_nothing_stands_in_for_is_the_stand_ins() -> None:
    log = "ERROR: failed to solve: a/b:1.2: failed to resolve source metadata for docker.io/a/b:1.2: not found\n"
    whose, cause, _ = blame.of_build(log, FOCAL)
    assert (whose, blame.is_base(cause)) == ("stand-in", True)
    assert blame.of_build(log, REAL)[0] == "ours or the code's"


@pytest.mark.parametrize(
    ("output", "base", "whose"),
    [
        ("usage: demo.py [-h] bag\ndemo.py: error: the following arguments are required: bag", FOCAL, "needs"),
        ("[ERROR] unable to open port /dev/ttyUSB0", FOCAL, "needs"),
        ("ERROR: cannot launch node of type [rviz/rviz]: rviz", FOCAL, "stand-in"),
        ("ERROR: cannot launch node of type [own/own]: own", FOCAL, "ours or the code's"),
        ("  print 'x'\nSyntaxError: Missing parentheses in call to 'print'. Did you mean print(...)?",
         replace(FOCAL, ubuntu="bionic", name="ros:melodic-ros-base"), "stand-in"),
        ("Segmentation fault (core dumped)", FOCAL, "ours or the code's"),
        ("", FOCAL, "unclear"),
    ],
)  # fmt: skip
def test_why_a_command_does_not_run_on(output: str, base: Base, whose: str) -> None:
    assert blame.of_run(output, base)[0] == whose


def test_the_line_that_asks_for_what_the_stand_in_lacks_is_why() -> None:
    output = "\x1b[31mIt wants the package [rviz]\nROS path [0]=/opt\x1b[0m\n\x1b[31mThe traceback was written\x1b[0m\n"
    assert blame.of_run(output, FOCAL) == ("stand-in", "", "It wants the package [rviz]")
    assert blame.of_run(output, replace(FOCAL, lacking=frozenset()))[2] == "The traceback was written"


def test_every_pattern_is_one_and_has_its_library() -> None:
    known = facts()
    for row in (*known["change"], *known["needs"]):
        re.compile(row["pattern"])
        re.compile(row.get("also", ""))
    libraries = {name for versions in known["versions"].values() for name in versions}
    assert {row["library"] for row in known["change"]} <= libraries


def test_a_reserve_takes_the_place_of_what_is_not_there(tmp_path: Path) -> None:
    file = tmp_path / "some.csv"
    file.write_text("# chosen\nkind,repository,field\nros1,a/one,x\ncpp,a/two,y\nreserve cpp,b/three,z\n")
    for name in ("a__one", "b__three"):
        (tmp_path / name).mkdir()
    found = [(line.repository, tree.name) for line, tree in chosen(listed(file), tmp_path)]
    assert found == [("a/one", "a__one"), ("b/three", "b__three")]


def test_what_was_late_is_measured_again_after_what_was_not_measured(tmp_path: Path) -> None:
    lines = [(Listed(repository=name, kind="cpp", reserve=False), tmp_path) for name in ("a/late", "a/done", "a/new")]
    row = Row(repository="a/done", commit="", date="2026-11-22", kind="cpp", outcome="runs")
    rows = {"a/done": row, "a/late": replace(row, repository="a/late", outcome="late")}
    assert [line.repository for line, _ in due(lines, rows, None)] == ["a/new", "a/late"]
    assert [line.repository for line, _ in due(lines, rows, ["a/done"])] == ["a/done"]


ROWS = (
    Row(repository="a/one", commit="1234567", date="2026-11-22", kind="ros1", base="ros:noetic-ros-base",
        stand_in="Debian 12", planned=True, built=True, imports=True, command="roslaunch a a.launch", started=True,
        alive=True, drawn=False, rung=1, outcome="runs", seconds=12.5),
    Row(repository="a/two", commit="1234567", date="2026-11-22", kind="cpp", planned=True, built=False,
        outcome="unbuilt", whose="stand-in", cause="api-known", why="<script>alert('|')</script>"),
    Row(repository="a/three", commit="1234567", date="2026-11-22", kind="cpp", planned=True, built=False,
        outcome="unbuilt", whose="ours or the code's", why="no `header`"),
)  # fmt: skip


def test_rows_are_kept_as_they_are(tmp_path: Path) -> None:
    rows = {row.repository: row for row in ROWS}
    write(tmp_path / "some-first.json", rows)
    assert read(tmp_path / "some-first.json") == rows


def test_what_only_the_stand_in_lacks_is_counted_apart() -> None:
    first, second, _ = sums(ROWS)
    assert first == (
        "Built: 1 of 3 (33%); without 1 that only the stand-ins prevent, and 0 that were not finished in time, "
        "1 of 2 (50%)."
    )
    assert "1 of 1 (100%)" in second


def test_lists_over_time_count_the_newest_reading_and_no_one_else_s_faults() -> None:
    def row(name: str, outcome: Outcome, date: str, whose: Whose = "", command: str = "") -> Row:
        built = {"runs": True, "stops": True, "shell": True, "unbuilt": False}.get(outcome)
        base = Row(repository=name, commit="0", date=date, kind="cpp", outcome=outcome)
        return replace(base, whose=whose, command=command, built=built)

    readings = {
        "built-10-first": (row("a/late", "late", "2026-11-03"), row("a/shell", "shell", "2026-11-03")),
        "built-9-fifth": (row("a/ours", "runs", "2026-11-02", command="b"),),
        "built-9-first": (
            row("a/ours", "unbuilt", "2026-11-01", "unclear"),
            row("a/stand-in", "unbuilt", "2026-11-01", "stand-in"),
            row("a/stops", "stops", "2026-11-01", "ours or the code's", "c"),
        ),
    }
    assert over_time(readings).splitlines()[2:] == [
        "| built-9 | 2026-11-01 | 3 | 1 | 0 | 2 of 2 (100%) | 1 of 2 (50%) | 2 of 2 (100%) | 1 of 2 (50%) |",
        "| built-10 | 2026-11-03 | 2 | 0 | 1 | 1 of 1 (100%) | 1 of 1 (100%) | 3 of 3 (100%) | 0 of 0 |",
        "| all | | 5 | 1 | 1 | 3 of 3 (100%) | | | 1 of 2 (50%) |",
    ]


def test_both_pages_say_what_was_below_the_names_and_run_nothing_of_a_log(tmp_path: Path) -> None:
    write(tmp_path / "some-first.json", {row.repository: row for row in ROWS})
    page.write(tmp_path)
    markdown, browser = ((tmp_path / f"running.{suffix}").read_text() for suffix in ("md", "html"))
    for text in (markdown, browser):
        assert "2026-11-22" in text
        assert "Debian 12" in text
        assert "<script>alert" not in text
    assert browser.count("<script") == 1
    assert not re.search(r"""(?:src|href)=["'](?!https://github\.com/a/)""", browser), "the page loads something"
    for outcome in ("runs", "unbuilt"):
        assert OUTCOMES[outcome] in browser
    assert OUTCOMES["base missing"] not in browser


def test_each_reading_is_of_a_list_and_of_what_its_columns_may_say() -> None:
    folder = Path(page.__file__).parent
    with (folder / "readings.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert {row["builds"] for row in rows} == {"yes", "no", "unsure"}
    assert {row["reading"] for row in rows} == {"first", "second"}
    notes = (folder / "readings.md").read_text(encoding="utf-8")
    for name, half, reading in {(row["list"], row["half"], row["reading"]) for row in rows}:
        assert (folder / f"{name}.csv").is_file()
        assert f"| {name} | {half} | {reading} |" in notes
    places = [(row["list"], row["half"], row["reading"], row["repository"]) for row in rows]
    assert len(set(places)) == len(places)
