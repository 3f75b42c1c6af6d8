"""The table of known failures: its shape, and each row's own sample and look-alike."""

from __future__ import annotations

import datetime as dt
import io
import re

import pytest

from hanging import ends
from roslab.config import generation
from roslab.explain.answer import Answer, explain
from roslab.explain.names import LOOKUPS
from roslab.explain.signatures import fields
from roslab.knowledge.failures import WORLDS, Failure, compiled, failures
from roslab.knowledge.table import rows

ALL = failures()
PATTERNS = [(f"{row.id}.{name}", getattr(row, name)) for row in ALL for name in ("pattern", "also", "unless", "extra")]
PATTERNS = [(name, pattern) for name, pattern in PATTERNS if pattern]
LOOKED_UP = {
    "limit",
    "advice",
    "last",
    "what",
    "name",
    "package",
    "release",
    "archive",
    "note",
    "why",
    "repair_words",
    "library",
    "low",
    "hint",
    "before_step",
    "how",
    "since",
    "ros",
    "releases",
}


def said(log: str) -> Answer:
    return explain(io.BytesIO(log.encode()))


@pytest.mark.parametrize("row", ALL, ids=lambda row: row.id)
def test_a_failure_explains_its_sample(row: Failure) -> None:
    found = said(row.sample).explanations
    assert [one.id for one in found] == [row.id]
    for text in (found[0].cause, found[0].fix):
        assert text.endswith((".", ")", ":", "}", "`"))
        assert "{" not in text.replace("{contents", "").replace("${", "")
        assert "  " not in text
        assert "()" not in text.replace("get_include()", "").replace("main()", "")


@pytest.mark.parametrize("row", ALL, ids=lambda row: row.id)
def test_a_failure_leaves_its_look_alike_alone(row: Failure) -> None:
    answer = said(row.unlike)
    assert len(answer.explanations) == 1, "a look-alike is a log of a step that failed"
    assert answer.explanations[0].id != row.id


def test_every_failure_has_a_look_alike_of_its_own() -> None:
    assert [row.id for row in ALL if not row.unlike.strip() or row.unlike.strip() == row.sample.strip()] == []


@pytest.mark.parametrize("row", ALL, ids=lambda row: row.id)
def test_a_failure_has_all_that_its_sentences_use(row: Failure) -> None:
    groups = {
        re.sub(r"\d+$", "", group)
        for pattern in (row.pattern, row.also, row.extra, row.before)
        for group in compiled(pattern).groupindex
    }
    used = {name for text in (row.cause, row.fix, row.otherwise) for name in fields(text)}
    assert used <= groups | (LOOKED_UP if row.lookup or row.before else set())
    assert not row.lookup or row.lookup in LOOKUPS
    assert row.source.startswith("https://")
    assert dt.date.fromisoformat(row.date)
    assert row.certainty in {"certain", "likely"}
    assert 1 <= row.rank <= 9
    assert row.repair.partition(":")[0] in {"", *generation.keys("today")}


def test_a_name_is_given_once() -> None:
    assert len({row.id for row in ALL}) == len(ALL)
    assert WORLDS


@pytest.mark.parametrize(("name", "pattern"), PATTERNS, ids=[name for name, _ in PATTERNS])
def test_a_pattern_is_bounded(name: str, pattern: str) -> None:
    """Repetitions without an end made a log of one long line hang for minutes."""
    plain = re.sub(r"\[(?:\\.|[^\]\\])*\]", "x", re.sub(r"\\.", "x", pattern))
    assert not re.search(r"[*+]|\{\d*,\}", plain)


LONG = {
    "one word": "a" * 100_000,
    "a path": "/usr/lib" * 12_000,
    "dots and dashes": ".-_:" * 25_000,
    "a name and a colon": "fatal error: x: " * 6_000,
    "an address": "https://example.org/" + "a/" * 45_000,
    "capitals": "ERROR CMAKE_" * 8_000,
    "spaces": " " * 100_000,
    "quotes": "'" * 50_000 + '"' * 50_000,
}


@pytest.mark.parametrize("line", LONG.values(), ids=LONG)
def test_no_pattern_hangs_on_a_long_line(line: str) -> None:
    """A pattern whose time grows with the square would need minutes for one of these lines."""
    for name, pattern in PATTERNS:
        print(name)  # pytest shows it where the pattern below does not end
        with ends():
            compiled(pattern).search(line)


def test_a_line_of_three_megabytes_is_read_in_time() -> None:
    for row in ALL[::8]:
        words = row.sample.strip().splitlines()
        near = words[-2:][0]
        log = "\n".join([*words[:-1], (near + " ") * (3_000_000 // len(near)), words[-1]])
        with ends():
            said(log)


@pytest.mark.parametrize(
    "table",
    [
        "os_releases",
        "programs",
        "apt_names",
        "shared_objects",
        "shared_objects_given",
        "api_changes",
        "cmake_commands",
        "cmake_messages",
        "dropped_names",
        "headers",
        "package_advice",
        "symbols",
        "localised",
        "other_wordings",
    ],
)
def test_every_row_of_a_table_has_a_source_and_a_date(table: str) -> None:
    assert rows(table)
    for row in rows(table):
        assert row["source"].startswith(("https://", "PyPI: "))
        assert dt.date.fromisoformat(row["date"])
        assert all(isinstance(value, str) for value in row.values())


@pytest.mark.parametrize(
    "row",
    [
        row
        for name in ("symbols", "localised", "other_wordings", "dropped_names", "cmake_messages")
        for row in rows(name)
    ],
    ids=lambda row: row["pattern"][:30],
)
def test_a_pattern_of_a_table_is_bounded(row: dict[str, str]) -> None:
    test_a_pattern_is_bounded("", row["pattern"])


@pytest.mark.parametrize("row", rows("api_changes"), ids=lambda row: row["why"][:60])
def test_a_change_of_an_api_has_a_bounded_pattern(row: dict[str, str]) -> None:
    test_a_pattern_is_bounded("", row["pattern"])
    assert not row["fix"].endswith(".")


def test_absent_lists_are_no_renamed_package() -> None:
    """Without lists every name is unknown, one that was renamed too."""
    log = """
Step 2/9 : RUN apt-get install -y libpng12-dev git
 ---> Running in 1a2b3c4d5e6f
Reading package lists...
E: Unable to locate package libpng12-dev
E: Unable to locate package git
The command '/bin/sh -c apt-get install -y libpng12-dev git' returned a non-zero code: 100
"""
    assert [found.id for found in said(log).explanations] == ["apt-lists-absent"]


def test_the_failed_step_s_first_error_wins_over_what_follows_from_it() -> None:
    log = """
#8 [3/4] RUN make -j8
#8 9.0 a.cpp:3:10: fatal error: glog/logging.h: No such file or directory
#8 9.0 b.o: undefined reference to `robot_move(int)'
#8 9.0 make: *** [all] Error 2
#8 ERROR: process "/bin/sh -c make -j8" did not complete successfully: exit code: 2
"""
    assert [found.id for found in said(log).explanations] == ["header-missing"]


@pytest.mark.parametrize(("name", "known"), [("nav2_msgs", "ros-package-missing"), ("glog", "cmake-package")])
def test_a_workspace_s_missing_package_is_told_from_a_library(name: str, known: str) -> None:
    log = f"""
#9 [5/6] RUN . /opt/ros/humble/setup.sh && colcon build
#9 9.2 CMake Error at CMakeLists.txt:12 (find_package):
#9 9.2   By not providing "Find{name}.cmake" in CMAKE_MODULE_PATH this project has
#9 9.3 Failed   <<< robot [4.20s, exited with code 1]
#9 ERROR: process "/bin/sh -c colcon build" did not complete successfully: exit code: 1
"""
    found = said(log).explanations[0]
    assert found.id == known
    assert known != "ros-package-missing" or found.repair == (("apt", ("ros-humble-nav2-msgs",)),)


def test_the_library_of_a_missing_symbol_is_named() -> None:
    found = said("a.cpp:90: undefined reference to `cv::Mat::Mat()'\ncollect2: error: ld returned 1 exit status\n")
    assert [one.id for one in found.explanations] == ["link-undefined"]
    assert "OpenCV" in found.explanations[0].cause
    assert "find_package(OpenCV REQUIRED)" in found.explanations[0].fix


@pytest.mark.parametrize(
    ("line", "known"),
    [
        ("/ws/libslam.so：对‘cv::String::deallocate()’未定义的引用", "link-library-incomplete"),  # noqa: RUF001
        ("a.cpp:3:10: 致命错误：glog/logging.h：没有那个文件或目录", "header-missing"),  # noqa: RUF001
        ("a.cpp:3:10: schwerwiegender Fehler: glog/logging.h: Datei oder Verzeichnis nicht gefunden", "header-missing"),
        ("a.cpp:3:10: erreur fatale : glog/logging.h: Aucun fichier ou dossier de ce type", "header-missing"),
        ("a.cpp:9: référence indéfinie vers « cv::Mat::Mat() »", "link-undefined"),
    ],
)
def test_messages_in_other_languages_are_read(line: str, known: str) -> None:
    assert [one.id for one in said(f"{line}\nmake: *** [all] Error 2\n").explanations] == [known]


def test_what_a_build_survives_gives_way_to_what_stops_it() -> None:
    """A package's script complains of systemd in every image; the missing package after it is what stops the build."""
    log = """
Step 3/5 : RUN dnf install -y robot && dnf install -y missing
 ---> Running in 1a2b3c4d5e6f
System has not been booted with systemd as init system (PID 1). Can't operate.
Complete!
No match for argument: missing
Error: Unable to find a match: missing
The command '/bin/sh -c dnf install -y robot && dnf install -y missing' returned a non-zero code: 1
"""
    assert [one.id for one in said(log).explanations] == ["yum-missing"]


def test_the_address_of_the_traced_command_is_named() -> None:
    log = """
Step 3/5 : RUN set -x && curl -fL http://a.example.org/a.tgz -o a && curl -fL http://b.example.org/b.tgz -o b
 ---> Running in 1a2b3c4d5e6f
+ curl -fL http://a.example.org/a.tgz -o a
+ curl -fL http://b.example.org/b.tgz -o b
curl: (22) The requested URL returned error: 404 Not Found
The command '/bin/sh -c set -x && curl' returned a non-zero code: 22
"""
    found = said(log).explanations
    assert [one.id for one in found] == ["download-gone"]
    assert "http://b.example.org/b.tgz" in found[0].cause


def test_the_variable_that_gives_a_version_is_named() -> None:
    log = """
Step 3/5 : RUN echo $suite && apt-get install -y robot=$version
 ---> Running in 1a2b3c4d5e6f
E: Version '' for 'robot' was not found
The command '/bin/sh -c echo $suite && apt-get install -y robot=$version' returned a non-zero code: 100
"""
    assert dict(said(log).explanations[0].names)["name"] == "version"


def test_a_script_with_windows_line_endings_is_known_under_dash() -> None:
    log = """#7 [3/4] RUN sh build.sh
#7 0.3 build.sh: 2: \r: not found
#7 0.4 build.sh: 9: cd: can't cd to /ws\r
#7 ERROR: process "/bin/sh -c sh build.sh" did not complete successfully: exit code: 2
"""
    assert [one.id for one in said(log).explanations] == ["line-endings"]


def test_an_error_at_the_end_of_a_check_of_configure_is_read() -> None:
    log = """#7 [3/4] RUN ./configure
#7 0.3 checking for the location of zlib... configure: error: zip support requires ZLIB. Use --with-zlib-dir=<DIR>
#7 0.4 make: *** No rule to make target 'clean'.  Stop.
#7 ERROR: process "/bin/sh -c ./configure" did not complete successfully: exit code: 1
"""
    assert [one.id for one in said(log).explanations] == ["php-extension-library"]


def test_a_log_without_its_beginning_says_nothing_of_lists_that_were_never_fetched() -> None:
    step = """#5 [2/3] RUN apt-get install -y libserial-dev
#5 0.5 E: Unable to locate package libserial-dev
#5 ERROR: process "/bin/sh -c apt-get install -y libserial-dev" did not complete successfully: exit code: 100
"""
    assert [one.id for one in said(step).explanations] == ["apt-unknown"]
    whole = f"#4 [1/3] FROM docker.io/library/ubuntu:22.04\n#4 DONE 0.1s\n{step}"
    assert [one.id for one in said(whole).explanations] == ["apt-lists-never-fetched"]
    updated = whole.replace(
        "#5 [2/3]", "#6 [2/3] RUN apt-get update && rm -rf /var/lib/apt/lists/*\n#6 DONE 1.0s\n#5 [2/3]"
    )
    assert [one.id for one in said(updated).explanations] == ["apt-lists-never-fetched"]


def test_a_tree_of_packages_is_not_what_matters() -> None:
    log = """#7 [3/4] RUN npm install
#7 3.1 | +-- error@1.0.0
#7 3.2 | | `-- fatal@2.0.0
#7 4.0 the strange thing failed
#7 ERROR: process "/bin/sh -c npm install" did not complete successfully: exit code: 1
"""
    assert said(log).explanations[0].error == "the strange thing failed"


def test_what_builds_survive_gives_way_to_a_later_failure_of_its_own_rank() -> None:
    log = """
Step 4/6 : RUN yum install -y golang && curl -o /tmp/a.tar.gz http://files.example.org/a.tar.gz && tar xzf /tmp/a.tar.gz
 ---> Running in 1a2b3c4d5e6f
Failed to get D-Bus connection: Operation not permitted
Complete!
gzip: stdin: not in gzip format
tar: Error is not recoverable: exiting now
The command '/bin/sh -c yum install' returned a non-zero code: 2
"""
    assert [one.id for one in said(log).explanations] == ["download-no-archive"]


def test_an_empty_version_in_an_address_is_no_download_that_is_gone() -> None:
    log = """
Step 4/6 : RUN set -ex; mkdir -p "${ROOT}"; curl --fail -o glpi.tgz -L "https://example.org/download/${VERSION}/glpi-${VERSION}.tgz"
 ---> Running in 1a2b3c4d5e6f
+ mkdir -p /srv
+ curl --fail -o glpi.tgz -L https://example.org/download//glpi-.tgz
  % Total    % Received % Xferd  Average Speed   Time    Time     Time  Current
curl: (22) The requested URL returned error: 404 Not Found
The command '/bin/sh -c curl' returned a non-zero code: 22
"""
    found = said(log).explanations
    assert [one.id for one in found] == ["argument-empty-value"]
    assert dict(found[0].names)["name"] == "VERSION"


def test_a_package_called_curl_downloads_nothing() -> None:
    log = """
Step 4/6 : RUN apk del --purge curl make && true
 ---> Running in 1a2b3c4d5e6f
The command '/bin/sh -c apk del --purge curl make' returned a non-zero code: 8
"""
    assert said(log).explanations[0].id is None


def test_what_the_step_went_on_after_gives_way() -> None:
    log = """
Step 4/6 : RUN yum install -y unzip more; unzip /tmp/database.zip
 ---> Running in 1a2b3c4d5e6f
No package more available.
Complete!
unzip:  cannot find or open /tmp/database.zip, /tmp/database.zip.zip or /tmp/database.zip.ZIP.
The command '/bin/sh -c yum install' returned a non-zero code: 9
"""
    assert [one.id for one in said(log).explanations] == ["file-missing"]
    alone = log.replace("unzip:  cannot find or open /tmp/database.zip, /tmp/database.zip.zip or", "and then")
    assert [one.id for one in said(alone).explanations] == ["yum-missing"]


def test_a_name_that_begins_like_a_common_package_tells_nothing_of_the_lists() -> None:
    log = """#9 [5/9] RUN apt install -y python3-catkin-tools
#9 1.4 E: Unable to locate package python3-catkin-tools
#9 ERROR: process "/bin/sh -c apt install -y python3-catkin-tools" did not complete successfully: exit code: 100
"""
    assert [one.id for one in said(log).explanations] == ["apt-unknown"]


def test_the_last_line_of_a_step_says_more_than_its_exit_code() -> None:
    log = """#7 [3/4] RUN ./plan
#7 0.3 planner: the arm has no elbow
#7 ERROR: process "/bin/sh -c ./plan" did not complete successfully: exit code: 7
"""
    assert said(log).explanations[0].error == "planner: the arm has no elbow (exit code: 7)"


def test_of_several_changes_of_an_interface_the_first_is_told() -> None:
    log = """
#8 [3/4] RUN make
#8 1.0 a.cpp:1:5: error: 'PyString_FromString' was not declared in this scope
#8 1.1 a.cpp:9:5: error: 'uint8_t' does not name a type
#8 ERROR: process "/bin/sh -c make" did not complete successfully: exit code: 2
"""
    assert "Python 2" in said(log).explanations[0].cause


def test_what_follows_from_an_old_standard_is_no_change_of_an_interface() -> None:
    log = """
#8 [3/4] RUN make
#8 1.0 warning.h:32:2: error: #error This file requires compiler and library support for the ISO C++ 2011 standard.
#8 1.1 a.cpp:9:5: error: 'uint8_t' does not name a type
#8 ERROR: process "/bin/sh -c make" did not complete successfully: exit code: 2
"""
    assert [one.id for one in said(log).explanations] == ["cxx-standard"]


def test_a_probe_for_a_program_is_no_failure_where_the_step_goes_on() -> None:
    probe = "which: no helper in (/usr/local/sbin:/usr/bin)"
    log = "\n".join(["#8 [3/4] RUN ./install", f"#8 1.0 {probe}", *(f"#8 1.{at} fetched {at}" for at in range(1, 9))])
    end = '#8 ERROR: process "/bin/sh -c ./install" did not complete successfully: exit code: 1\n'
    assert said(f"{log}\n{end}").explanations[0].id is None
    assert said(f"#8 [3/4] RUN ./install\n#8 1.0 {probe}\n{end}").explanations[0].id == "program-missing"


def test_what_the_build_of_a_wheel_imports_is_not_brought_by_one_more_package() -> None:
    log = """#8 [3/4] RUN pip install example
#8 1.0   Building wheel for example (pyproject.toml) did not run successfully.
#8 1.0   ModuleNotFoundError: No module named 'torch'
#8 1.1 ERROR: Failed building wheel for example
#8 ERROR: process "/bin/sh -c pip install example" did not complete successfully: exit code: 1
"""
    assert [one.id for one in said(log).explanations] == ["build-needs-module"]
