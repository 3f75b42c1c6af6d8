"""Logs as they come: encodings, colours, carriage returns, prefixes of services, cut at either end, and very long."""

from __future__ import annotations

import base64
import io
import json
import random
import tracemalloc

import pytest

from hanging import ends
from roslab.explain import reading, steps
from roslab.explain.answer import Answer, explain
from roslab.explain.words import as_json, text

PLAIN = """\
#1 [internal] load build definition from Dockerfile
#1 DONE 0.0s

#5 [2/4] RUN apt-get update
#5 0.412 W: 404 of something optional, error of nobody
#5 DONE 3.1s

#6 [3/4] RUN make -j8
#6 0.3 building
#6 1.2 src/a.cpp:3:10: fatal error: glog/logging.h: No such file or directory
#6 1.3 make: *** [all] Error 2
#6 ERROR: process "/bin/sh -c make -j8" did not complete successfully: exit code: 2
------
 > [3/4] RUN make -j8:
0.3 building
1.2 src/a.cpp:3:10: fatal error: glog/logging.h: No such file or directory
1.3 make: *** [all] Error 2
------
Dockerfile:7
--------------------
   6 |     COPY . .
   7 | >>> RUN make -j8
   8 |     CMD ["fatal error: other.h: No such file or directory"]
--------------------
ERROR: failed to solve: process "/bin/sh -c make -j8" did not complete successfully: exit code: 2
"""
CLASSIC = """\
Sending build context to Docker daemon  106kB
Step 1/3 : FROM ubuntu:20.04
 ---> a600fa955058
Step 2/3 : RUN echo "E: Unable to locate package nothing" || true
 ---> Running in dab6c576653c
E: Unable to locate package nothing
Removing intermediate container dab6c576653c
 ---> ca881a048382
Step 3/3 : RUN make -j8
 ---> Running in 4990f52dd3d2
src/a.cpp:3:10: fatal error: glog/logging.h: No such file or directory
make: *** [all] Error 2
The command '/bin/sh -c make -j8' returned a non-zero code: 2
"""


def said(log: str | bytes) -> Answer:
    return explain(io.BytesIO(log.encode() if isinstance(log, str) else log))


def header_is_missing(answer: Answer, command: str = "RUN make -j8") -> None:
    assert [found.id for found in answer.explanations] == ["header-missing"]
    assert answer.explanations[0].step == command
    assert dict(answer.explanations[0].names)["header"] == "glog/logging.h"


@pytest.mark.parametrize("log", [PLAIN, CLASSIC], ids=["BuildKit", "classic"])
@pytest.mark.parametrize(
    "encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "utf-32", "latin-1", "cp1252"]
)
def test_every_encoding_is_read(log: str, encoding: str) -> None:
    header_is_missing(said(log.replace("building", "baut für alle").encode(encoding)))


def test_quotation_marks_of_windows_in_a_log_of_utf_8_are_read() -> None:
    log = PLAIN.replace("#6 0.3 building", "#6 0.3 \x91caf\xe9\x92").encode("latin-1")
    assert "\u2018café\u2019" in "\n".join(line.text for line in reading.lines(io.BytesIO(log)))


@pytest.mark.parametrize("log", [PLAIN, CLASSIC], ids=["BuildKit", "classic"])
def test_colours_and_carriage_returns_are_gone_before_anything_is_matched(log: str) -> None:
    red = log.replace("src/a.cpp", "\x1b[91m\x1b[1msrc/a.cpp").replace("fatal error: glog", "fatal \x1b[0merror: glog")
    header_is_missing(said(red))
    header_is_missing(said(log.replace("\n", "\r\n")))
    header_is_missing(said(log.replace("src/a.cpp", "[91msrc/a.cpp").replace("directory\n", "directory[0m\n")))
    bar = "".join(f" {percent}% [{'#' * (percent // 4)}]\r" for percent in range(100))
    header_is_missing(said(log.replace("src/a.cpp", f"{bar}src/a.cpp")))


@pytest.mark.parametrize("before", ["Reading package lists...", "0.573 Reading state information... ", ""])
def test_a_message_behind_the_progress_of_apt_is_read(before: str) -> None:
    message = "E: Version '1.06-1' for 'bc' was not found"
    log = f"""\
#14 [dependencies 4/4] RUN apt-get update && apt-get install --yes bc=1.06-1
#14 0.5 Building dependency tree...
#14 {before or "0.6 "}{message}
#14 0.6 Package bc is not available, but is referred to by another package.
#14 ERROR: process "/bin/sh -c apt-get update" did not complete successfully: exit code: 100
"""
    assert [found.id for found in said(log).explanations] == ["apt-version-gone"]


def test_what_follows_a_carriage_return_stays_with_its_step() -> None:
    log = PLAIN.replace("#6 1.2 src", "#6 1.2  10%\r 50%\rsrc").replace("\n1.2 src", "\n1.2 ")
    header_is_missing(said(log))


def prefixed(log: str, prefix: str) -> str:
    return "".join(f"{prefix}{line}\n" for line in log.splitlines())


@pytest.mark.parametrize("log", [PLAIN, CLASSIC], ids=["BuildKit", "classic"])
@pytest.mark.parametrize(
    "prefix",
    [
        "2026-01-02T03:04:05.1234567Z ",
        "image\tBuild the image\t2026-01-02T03:04:05.1234567Z ",
        "2026-01-02T03:04:05.123456Z 00O ",
        "2026-01-02T03:04:05.123456Z 01E+",
        "[image/build]   | ",
        "[2026-01-02 03:04:05] ",
        "robot_1  | ",
    ],
    ids=["GitHub", "gh run view", "GitLab", "GitLab, continued", "act", "a clock", "docker compose"],
)
def test_prefixes_of_services_are_taken_off(log: str, prefix: str) -> None:
    header_is_missing(said(prefixed(log, prefix)))


def test_a_part_of_a_repetition_is_read_without_its_seconds() -> None:
    log = (
        "15.11 RuntimeError:\n15.12 The detected CUDA version (11.8) mismatches the version that was used to compile\n"
    )
    log += "15.12 PyTorch (12.1). Please make sure to use the same CUDA versions.\n"
    assert [found.id for found in said(log).explanations] == ["torch-other-cuda"]


def test_sections_of_gitlab_are_no_lines_of_a_step() -> None:
    log = (
        "section_start:1700000000:build\r\x1b[0K\x1b[36;1mBuild\x1b[0;m\n"
        + PLAIN
        + "section_end:1700000009:build\r\x1b[0K\n"
    )
    header_is_missing(said(log))


def test_the_failed_step_wins_over_what_earlier_ones_printed() -> None:
    for log in (PLAIN, CLASSIC):
        assert said(log).explanations[0].error.startswith("src/a.cpp:3:10")


def test_the_echo_of_the_instruction_explains_nothing() -> None:
    command = "apt-get update || echo 'E: Unable to locate package x' && exit 3"
    end = f'ERROR: process "/bin/sh -c {command}" did not complete successfully: exit code: 3\n'
    log = f"#6 [3/4] RUN {command}\n#6 {end}"
    found = said(log + end.replace("ERROR: ", "ERROR: failed to solve: "))
    assert found.explanations[0].id is None
    assert found.explanations[0].error == "exit code: 3"


def test_a_log_cut_at_its_beginning_or_its_end_is_read() -> None:
    lines = PLAIN.splitlines(keepends=True)
    for begin in range(len(lines) - 13):
        assert said("".join(lines[begin:])).explanations[0].id == "header-missing", begin
    for end in range(11, len(lines)):
        assert said("".join(lines[:end])).explanations[0].id == "header-missing", end
    only_the_repetition = PLAIN[PLAIN.index("------") :]
    header_is_missing(said(only_the_repetition))


def test_the_file_and_the_line_are_those_that_the_builder_names() -> None:
    found = said(PLAIN).explanations[0]
    assert (found.file, found.line) == ("Dockerfile", 7)


def test_each_platform_that_failed_is_explained() -> None:
    one = PLAIN[: PLAIN.index("------")].replace("[3/4]", "[linux/amd64 3/4]")
    other = one.replace("#6", "#16").replace("#5", "#15").replace("#1 ", "#11 ").replace("amd64", "arm64")
    other = other.replace("src/a.cpp:3:10: fatal error: glog/logging.h: No such", "c++: fatal error: Killed")
    found = said(one + other).explanations
    assert [(each.platform, each.id) for each in found] == [
        ("linux/amd64", "header-missing"),
        ("linux/arm64", "memory"),
    ]


def test_a_cache_that_is_not_there_yet_fails_nothing() -> None:
    name = "ghcr.io/example/robot:cache"
    cache = f"#4 importing cache manifest from {name}\n#4 ERROR: {name}: not found\n"
    header_is_missing(said(cache + PLAIN))


def test_an_old_buildkit_numbers_the_lines_of_its_repetition() -> None:
    log = """\
 => ERROR [3/4] RUN make -j8                                                            3.6s
------
 > [3/4] RUN make -j8:
#12 1.137 building
#12 3.374 src/a.cpp:3:10: fatal error: glog/logging.h: No such file or directory
------
executor failed running [/bin/sh -c make -j8]: exit code: 2
"""
    header_is_missing(said(log))


def test_a_bracket_before_a_word_is_no_colour() -> None:
    log = "\x1b[31m#3 [internal] load metadata\x1b[0m\n#3 ERROR: status code [manifests 2022]: 403 [0mForbidden\n"
    assert "[manifests 2022]" in "\n".join(line.text for line in reading.lines(io.BytesIO(log.encode())))


def test_a_step_that_was_cancelled_did_not_fail() -> None:
    log = "#9 [other 2/2] RUN sleep 99\n#9 0.1 error: nothing\n#9 CANCELED\n" + PLAIN
    header_is_missing(said(log))


@pytest.mark.parametrize("log", ["", "\n\n", "Successfully built 0123456789ab\nSuccessfully tagged robot:latest\n"])
def test_a_log_without_a_failure_says_so(log: str) -> None:
    answer = said(log)
    assert "cause" not in text(answer).replace("no known cause", "")


def test_raw_json_is_read_as_plain_progress_is() -> None:
    def data(line: str) -> str:
        return base64.b64encode(line.encode()).decode()

    vertex = {"digest": "sha256:1", "name": "[3/4] RUN make -j8"}
    records: list[dict[str, object]] = [
        {"vertexes": [{"digest": "sha256:0", "name": "[2/4] RUN true", "completed": "2026-01-01T00:00:00Z"}]},
        {"vertexes": [vertex]},
        {
            "logs": [
                {
                    "vertex": "sha256:1",
                    "data": data("src/a.cpp:3:10: fatal error: glog/logging.h: No such file or directory\n"),
                }
            ]
        },
        {
            "vertexes": [
                {**vertex, "error": 'process "/bin/sh -c make -j8" did not complete successfully: exit code: 2'}
            ]
        },
    ]
    header_is_missing(said("".join(json.dumps(record) + "\n" for record in records)))
    header_is_missing(
        said("".join(json.dumps(record) + "\n" for record in [*records, {"logs": [{"data": "!"}]}, {"logs": 3}]))
    )


def test_probes_of_a_configure_step_are_no_errors() -> None:
    probes = """\
#6 1.0 _configtest.c:1:10: fatal error: cblas.h: No such file or directory
#6 1.0 conftest.c:9:28: fatal error: ac_nonexistent.h: No such file or directory
#6 1.0 CMakeFiles/CMakeTmp/src.c:11:1: fatal error: pthreads.h: No such file or directory
#6 1.0 -- Performing Test HAVE_X - Failed
"""
    header_is_missing(said(PLAIN.replace("#6 0.3 building\n", probes)))


def test_an_unknown_failure_shows_what_matters_and_no_more_than_twenty_lines() -> None:
    noise = "".join(f"#6 0.{number} compiling part {number}\n" for number in range(500))
    odd = "#6 9.0 widget.rb: error: the frobnicator is out of phase\n#6 9.1 it was set to 7\n"
    end = '#6 ERROR: process "/bin/sh -c ./odd" did not complete successfully: exit code: 1\n'
    answer = said(f"#6 [3/4] RUN ./odd\n{noise}{odd}{noise}{end}")
    found = answer.explanations[0]
    assert found.id is None
    assert found.error == "widget.rb: error: the frobnicator is out of phase"
    assert found.error in found.lines
    assert 0 < len(found.lines) <= 20
    words = text(answer)
    assert words.count("no known cause") == 1
    assert "docker buildx debug" in words


def test_json_has_every_field_of_an_explanation() -> None:
    found = json.loads(as_json(said(PLAIN)))["explanations"][0]
    assert found["id"] == "header-missing"
    assert found["names"]["header"] == "glog/logging.h"
    assert (found["step"], found["file"], found["line"]) == ("RUN make -j8", "Dockerfile", 7)
    assert found["repair"] == {"apt": ["libgoogle-glog-dev"]}
    assert found["certainty"] == "certain"
    assert found["fix"]


def big(megabytes: int) -> bytes:
    head, _, tail = PLAIN.partition("#6 0.3 building\n")
    line = "#6 7.1 [ 12%] Building CXX object src/CMakeFiles/robot.dir/planner_with_a_long_name.cpp.o\n"
    return (head + line * (megabytes * 1_000_000 // len(line)) + tail).encode()


def test_a_large_log_is_read_in_bounded_memory() -> None:
    """A part of the largest log that must be read: 100 MB in 200 MB of memory; its time is ``benchmarks.explain``'s."""
    with ends():
        tracemalloc.start()
        header_is_missing(said(big(10)))
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 40_000_000


@pytest.mark.parametrize("prefix", ["", "2024-08-01T14:47:29.1234567Z "], ids=["plain", "GitHub"])
def test_a_large_log_is_skimmed_where_nothing_failed(prefix: str) -> None:
    """Far from any failure only the lines that might matter are kept, each with its own number."""
    texts = [f"{prefix}#6 7.1 [ 12%] Building CXX object {number}.o" for number in range(1, 200_000)]
    texts[0] = f"{prefix}#6 [3/4] RUN make -j8"
    texts[100_000] = f"{prefix}#6 9.2 a.cpp:3:10: fatal error: glog/logging.h: No such file or directory"
    texts[150_000] = f"{prefix}#7 [2/2] RUN true"
    texts[-1] = f'{prefix}#6 ERROR: process "/bin/sh -c make" did not complete successfully: exit code: 2'
    log = "\n".join(texts).encode()
    found = list(reading.lines(io.BytesIO(log)))
    assert len(found) < 100_000
    assert all(texts[line.number - 1] == prefix + line.text for line in found)
    assert {100_001, 150_001, len(texts)} <= {line.number for line in found}
    header_is_missing(said(log))


def test_mutated_logs_end_without_a_traceback() -> None:
    source = random.Random(7)  # noqa: S311
    for _ in range(150):
        data = bytearray(source.choice([PLAIN, CLASSIC]).encode())
        for _ in range(source.randrange(1, 40)):
            at = source.randrange(len(data))
            change = source.randrange(3)
            if change == 0:
                data[at] = source.randrange(256)
            elif change == 1:
                del data[at : at + source.randrange(60)]
            else:
                data[at:at] = bytes(data[source.randrange(len(data)) :][: source.randrange(200)])
        answer = said(bytes(data))
        assert text(answer)
        assert json.loads(as_json(answer))


def test_one_line_of_three_megabytes_is_cut() -> None:
    found = list(reading.lines(io.BytesIO(b"x" * 3_000_000 + b"end\n")))
    assert len(found) == 1
    assert len(found[0].text) <= reading.LONGEST
    assert found[0].text.endswith("end")


def test_a_step_keeps_its_first_error_however_much_follows() -> None:
    lines = [reading.Line(1, "#6 [3/4] RUN make -j8"), reading.Line(2, "#6 0.1 a.c:1:1: error: the first")]
    lines += [reading.Line(number, f"#6 0.2 compiling {number}") for number in range(3, 60_000)]
    lines += [reading.Line(60_000, "#6 ERROR: process did not complete")]
    log = steps.read(iter(lines))
    kept = log.failed[0].lines
    assert len(kept) <= steps.MOST
    assert kept[0].text == "a.c:1:1: error: the first"
    assert kept[-1].number == 59_999


def test_an_instruction_in_small_letters_is_the_same() -> None:
    log = b"""Step 3/4 : run curl -s http://files.example.org/a.repo > /etc/a.repo
 ---> Running in 1a2b3c4d5e6f
The command '/bin/sh -c curl -s http://files.example.org/a.repo > /etc/a.repo' returned a non-zero code: 7
"""
    (found,) = explain(io.BytesIO(log)).explanations
    assert found.step.startswith("RUN curl")
    assert found.id == "download-silent"


def test_a_repeated_line_loses_its_seconds_and_no_other_number() -> None:
    said = b'npm ERR! notsup Required: {"node":"^18.17.0 || >=20.5.0"}'
    log = b"#6 [2/9] RUN npm i npm@latest -g\n#6 3.257 %s\n#6 ERROR: process failed: exit code: 1\n------\n" % said
    log += b" > [2/9] RUN npm i npm@latest -g:\n3.257 %s\n------\n" % said
    (found,) = explain(io.BytesIO(log)).explanations
    assert dict(found.names)["needs"] == "^18.17.0 || >=20.5.0"


def test_the_builder_s_last_words_name_the_step_of_a_log_without_its_beginning() -> None:
    log = r"""9.2 ERROR: your rosdep installation has not been initialized yet.  Please run:
------
Dockerfile:7
--------------------
   7 | >>> RUN cd /ws && rosdep install --from-paths src
--------------------
ERROR: failed to solve: process "/bin/bash -o pipefail -c echo \"a\" && rosdep install" did not complete successfully: x
"""
    (found,) = explain(io.BytesIO(log.encode())).explanations
    assert found.step == 'RUN echo "a" && rosdep install'
    assert (found.file, found.line) == ("Dockerfile", 7)


def test_the_step_that_was_running_at_the_builder_s_last_words_failed() -> None:
    log = """#9 177.5 c++: internal compiler error: Killed (program cc1plus)
#9 357.7 make: *** [all] Error 2
------
executor failed running [/bin/sh -c cmake . && make -j4]: exit code: 2
"""
    found = said(log).explanations
    assert [(one.id, one.step) for one in found] == [("memory", "RUN cmake . && make -j4")]


def test_a_copied_part_of_a_repetition_loses_its_seconds() -> None:
    log = "4.1 Get:1 list\n20.2 CMake Error at CMakeLists.txt:3 (message):\n20.2   Lidar > 2 not found.\n20.2 \n"
    found = said(log).explanations
    assert [one.error for one in found]
    assert not found[0].error.startswith("20.2")


def test_what_misses_a_package_that_was_left_out_has_the_cause_of_that_one() -> None:
    log = """\
#9 [5/5] RUN leave-out-failed -- catkin build
#9 1.0 Errors     << arm_core:make /ws/logs/arm_core/build.make.000.log
#9 1.1 /ws/src/arm_core/a.cpp:1:10: fatal error: glog/logging.h: No such file or directory
#9 1.2 make: *** [all] Error 2
#9 1.3 Failed     << arm_core:make                [ Exited with code 2 ]
#9 1.4 roslab: the workspace does not build: once more without what failed
#9 1.5 roslab: left out: arm_core
#9 2.0 Errors     << arm:cmake /ws/logs/arm/build.cmake.000.log
#9 2.1 CMake Error at /ws/src/arm/CMakeLists.txt:23 (find_package):
#9 2.2   By not providing "Findarm_core.cmake" in CMAKE_MODULE_PATH this project has
#9 2.3 -- Configuring incomplete, errors occurred!
#9 2.4 Failed     << arm:cmake [ Exited with code 1 ]
#9 ERROR: process "/bin/sh -c leave-out-failed -- catkin build" did not complete successfully: exit code: 1
"""
    (found,) = explain(io.BytesIO(log.encode())).explanations
    assert (found.id, found.packages) == ("header-missing", ("arm_core",))
    other = log.replace("Findarm_core", "FindCeres")
    (found,) = explain(io.BytesIO(other.encode())).explanations
    assert (found.id, dict(found.names)["name"]) == ("cmake-package", "Ceres")


def test_what_an_earlier_attempt_of_a_step_said_is_not_its_cause() -> None:
    log = """\
#9 [5/5] RUN reuse-build catkin_make
#9 1.0 /ws/src/a/a.cpp:1:10: fatal error: robot_msgs/Pose.h: No such file or directory
#9 1.1 make: *** [Makefile:146: all] Error 2
#9 1.2 roslab: what includes robot_msgs/Pose.h does not wait until it is generated: once more, with all generated
#9 1.3 /ws/src/a/b.cpp:8:30: error: 'other' was not declared in this scope
#9 1.4 make: *** [Makefile:146: all] Error 2
#9 ERROR: process "/bin/sh -c reuse-build catkin_make" did not complete successfully: exit code: 2
------
 > [5/5] RUN reuse-build catkin_make:
1.3 /ws/src/a/b.cpp:8:30: error: 'other' was not declared in this scope
------
ERROR: failed to solve: process "/bin/sh -c reuse-build catkin_make" did not complete successfully: exit code: 2
"""
    (found,) = explain(io.BytesIO(log.encode())).explanations
    assert "b.cpp:8:30" in found.error
    assert not any("robot_msgs" in line for line in found.lines)


def test_tables_in_whose_place_others_are_used_are_no_cause() -> None:
    log = """\
#6 [3/4] RUN install-rosdep-keys --tables noetic/final /tmp/manifests
#6 1.0 ERROR: unable to process source [https://raw.githubusercontent.com/ros/rosdistro/noetic/final/rosdep/base.yaml]:
#6 1.0 	<urlopen error [Errno -2] Name or service not known> (https://raw.githubusercontent.com/base.yaml)
#6 1.1 roslab: the tables of rosdistro noetic/final do not answer: the base's own are used
#6 2.0 error: the robot has no arms
#6 ERROR: process "/bin/sh -c install-rosdep-keys" did not complete successfully: exit code: 1
"""
    told = explain(io.BytesIO(log.encode())).explanations[0]
    assert not told.id
    assert "no arms" in told.error
    without = log.replace("roslab: the tables of rosdistro", "roslab: other tables of rosdistro")
    assert explain(io.BytesIO(without.encode())).explanations[0].id == "host-unknown"


def test_one_of_two_indexes_that_does_not_answer_is_no_cause_where_pip_went_on() -> None:
    retry = "WARNING: Retrying (Retry(total=0, connect=None)) after connection broken by 'NewConnectionError('<a>')'"
    log = f"""\
#6 [3/4] RUN pip install --extra-index-url https://other.example.org/simple -e .
#6 1.0 {retry}: /simple/opencv-python/
#6 1.1 Collecting opencv-python (from demo==0.0.1)
#6 1.2   Downloading opencv_python-4.5.5.64-cp36-abi3-manylinux_2_17_x86_64.whl (60.5 MB)
#6 2.0 {retry}: /simple/demo-tools/
#6 2.1 ERROR: Could not find a version that satisfies the requirement demo_tools (from demo) (from versions: none)
#6 2.1 ERROR: No matching distribution found for demo_tools
#6 ERROR: process "/bin/sh -c pip install" did not complete successfully: exit code: 1
"""
    told = explain(io.BytesIO(log.encode())).explanations[0]
    assert (told.id, "demo_tools" in told.cause) == ("pip-name-unknown", True)
    without = "\n".join(line for line in log.splitlines() if "Downloading" not in line) + "\n"
    assert explain(io.BytesIO(without.encode())).explanations[0].id == "pip-no-network"
