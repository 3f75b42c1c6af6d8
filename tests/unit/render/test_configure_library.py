"""A library of which nothing was read is configured without what its own options leave out, where it is not with it."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from roslab.pipeline import plan_repository
from roslab.render import image_scripts
from roslab.render.dockerfile import dockerfile
from trees import tree_of

SCRIPT = Path(image_scripts.__path__[0]) / "configure-library.sh"
CACHE = """\
BUILD_SHARED_LIBS:BOOL=ON
PYTHON_BINDING:BOOL=ON
PYTHON_BINDING_FORCE_PYTHON3:BOOL=OFF
build_examples:BOOL=TRUE
ACME_BUILD_TESTS:BOOL=ON
WITHOUT_TESTS:BOOL=ON
FASTEST_PATH:BOOL=ON
CMAKE_INSTALL_DOCDIR:PATH=share/doc
"""


def configured(folder: Path, *options: str, works_with: str) -> tuple[int, str, list[str]]:
    """Run the script with a stand-in of CMake that works with one option alone; return its code, words and calls."""
    stand_in = folder / "bin" / "cmake"
    stand_in.parent.mkdir()
    body = f'echo "$*" >>calls\ncat >CMakeCache.txt <<"EOF"\n{CACHE}EOF\n[[ " $* " == *"{works_with}"* ]]\n'
    stand_in.write_text(f"#!/bin/bash\n{body}", encoding="utf-8")
    stand_in.chmod(0o755)
    command = ["bash", str(SCRIPT), *options, "../"]
    path = {"PATH": f"{stand_in.parent}:{os.environ['PATH']}"}
    done = subprocess.run(command, cwd=folder, env=path, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout, (folder / "calls").read_text(encoding="utf-8").splitlines()


def test_it_is_configured_once_where_that_works(tmp_path: Path) -> None:
    assert configured(tmp_path, "-DA=1", works_with="-DA=1") == (0, "", ["-DA=1 ../"])


def test_it_is_configured_again_without_what_nothing_links(tmp_path: Path) -> None:
    code, said, calls = configured(tmp_path, "-DA=1", works_with="-DPYTHON_BINDING=OFF")
    without = "-DPYTHON_BINDING=OFF -Dbuild_examples=OFF -DACME_BUILD_TESTS=OFF"
    assert (code, calls) == (0, ["-DA=1 ../", f"{without} -DA=1 ../"])
    assert said == f"roslab: what the library does not need is left out, {without}: once more\n"


def test_an_option_that_the_page_gives_stays(tmp_path: Path) -> None:
    given = ("-DACME_BUILD_TESTS=ON", "-DPYTHON_BINDING:BOOL=ON", "-Dbuild_examples=ON")
    code, said, calls = configured(tmp_path, *given, works_with="-DACME_BUILD_TESTS=OFF")
    assert (code, said, calls) == (1, "", [f"{' '.join(given)} ../"])


CONFIG = """\
cmake_minimum_required(VERSION 3.5)
project(acme NONE)
set(HEADERS "${{PROJECT_SOURCE_DIR}}/{}")
file(WRITE "${{PROJECT_BINARY_DIR}}/config.in" "set(ACME_INCLUDE_DIRS @HEADERS@)\n")
configure_file("${{PROJECT_BINARY_DIR}}/config.in" "${{PROJECT_BINARY_DIR}}/acmeConfig.cmake" @ONLY)
configure_file("${{PROJECT_BINARY_DIR}}/config.in" "${{PROJECT_BINARY_DIR}}/acmeOther.cmake" @ONLY)
install(DIRECTORY include/ DESTINATION include)
install(FILES "${{PROJECT_BINARY_DIR}}/acmeConfig.cmake" DESTINATION lib/cmake/acme)
"""


@pytest.mark.skipif(shutil.which("cmake") is None, reason="CMake writes what is installed")
@pytest.mark.parametrize(
    ("headers", "options", "named"),
    [
        ("include", (), "/usr/local/include"),
        ("include/acme", ("-DCMAKE_INSTALL_PREFIX=/opt/acme",), "/opt/acme/include/acme"),
        ("includes", (), "{source}/includes"),
    ],
)
def test_what_is_installed_names_the_headers_that_are(
    tmp_path: Path, headers: str, options: tuple[str, ...], named: str
) -> None:
    source = tmp_path / "a.b++"
    (source / "include").mkdir(parents=True)
    (source / "CMakeLists.txt").write_text(CONFIG.format(headers))
    build = source / "build"
    build.mkdir()
    done = subprocess.run(["bash", str(SCRIPT), *options, "../"], cwd=build, capture_output=True, text=True, check=True)
    assert (build / "acmeConfig.cmake").read_text() == f"set(ACME_INCLUDE_DIRS {named.format(source=source)})\n"
    assert (build / "acmeOther.cmake").read_text() == f"set(ACME_INCLUDE_DIRS {source}/{headers})\n"
    assert ("acmeConfig.cmake names the headers" in done.stdout) is (headers != "includes")


@pytest.mark.parametrize(
    "said",
    ["Missing executable acme!", "  Missing executable acme.", "Could NOT find Acme (missing: ACME_EXECUTABLE) "],
)
def test_a_program_that_cmake_misses_is_installed(tmp_path: Path, said: str) -> None:
    programs = tmp_path / "bin"
    programs.mkdir()
    for name, body in (
        ("cmake", f"echo \"$*\" >>calls\n[ -e installed ] || {{ echo 'CMake Error: {said}' >&2; exit 1; }}"),
        ("apt-get", '[ "$1" = update ] || { [ "${!#}" = acme ] && touch installed; }'),
        ("id", "echo 0"),
    ):
        (programs / name).write_text(f"#!/bin/bash\n{body}\n", encoding="utf-8")
        (programs / name).chmod(0o755)
    environment = {"PATH": f"{programs}:{os.environ['PATH']}"}
    command = ["bash", str(SCRIPT), "../"]
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=True)
    assert "roslab: CMake misses programs, apt installs them: acme: once more" in done.stdout
    assert (tmp_path / "calls").read_text(encoding="utf-8").splitlines() == ["../", "../"]


SAID = """\
CMake Warning at a.cmake:1 (find_package):
  By not providing "FindMaybe.cmake" in CMAKE_MODULE_PATH this project has
CMake Error at CMakeLists.txt:9 (find_package):
  By not providing "FindVISP.cmake" in CMAKE_MODULE_PATH this project has
CMake Error at FindPackageHandleStandardArgs.cmake:148 (message):
  Could NOT find GSL (missing: GSL_INCLUDE_DIR)
-- Checking for module 'libmaybe'
--   No package 'libmaybe' found
-- Checking for module 'libfoo'
--   No package 'libfoo' found
CMake Error at FindPkgConfig.cmake:607 (message):
  A required package was not found
-- Checking for module 'libbar'
--   Package 'libbar', required by 'virtual:world', not found
CMake Error at FindPkgConfig.cmake:607 (message):
  The following required packages were not found:
-- Could NOT find Doxygen (missing: DOXYGEN_EXECUTABLE)
CMake Error at CMakeLists.txt:30 (message):
  too old"""


def test_what_cmake_did_not_find_is_told_in_a_line(tmp_path: Path) -> None:
    body = f"cat >&2 <<'EOF'\n{SAID}\nEOF\nexit 1"
    programs = tmp_path / "bin"
    programs.mkdir()
    (programs / "cmake").write_text(f"#!/bin/bash\ntouch CMakeCache.txt\n{body}\n", encoding="utf-8")
    (programs / "cmake").chmod(0o755)
    environment = {"PATH": f"{programs}:{os.environ['PATH']}"}
    command = ["bash", str(SCRIPT), "../"]
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert done.stdout.splitlines()[-1].split() == [
        "roslab:",
        "CMake",
        "stops",
        "without:",
        *["GSL", "VISP", "libbar", "libfoo"],
    ]


@pytest.mark.parametrize(
    ("packages", "there", "prefix"),
    [
        ("ros-noetic-visp\n", "", "/opt/ros/noetic"),
        ("libeigen3-dev\n", "ros-noetic-roscpp\n", ""),
        ("", "ros-noetic-roscpp\nros-noetic-visp\n", "/opt/ros/noetic"),
    ],
)
def test_what_ros_brought_is_found(tmp_path: Path, packages: str, there: str, prefix: str) -> None:
    """Also what the plan alone has installed for the library: the base has no package of that name."""
    programs = tmp_path / "bin"
    programs.mkdir()
    (tmp_path / "there").write_text(there)
    (tmp_path / "base-packages").write_text("bash\t5.1\nros-noetic-roscpp\t1.16.0\n")
    for name, body in (("cmake", 'echo "${CMAKE_PREFIX_PATH:-}"'), ("dpkg-query", f"cat {tmp_path}/there")):
        (programs / name).write_text(f"#!/bin/bash\n{body}\n", encoding="utf-8")
        (programs / name).chmod(0o755)
    (tmp_path / "required").mkdir()
    (tmp_path / "required/acme.txt").write_text(packages, encoding="utf-8")
    text = SCRIPT.read_text(encoding="utf-8").replace("/usr/local/share/roslab", str(tmp_path))
    environment = {"PATH": f"{programs}:{os.environ['PATH']}", "ROS_DISTRO": "noetic"}
    command = ["bash", "-c", text, "x", "../"]
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=True)
    assert done.stdout.strip() == prefix


OLD = "CMake 3.13 or higher is required.  You are running 3.10.2"


def too_old(tmp_path: Path, python: str) -> tuple[int, list[str]]:
    """Run the script with a stand-in of a CMake that is too old; ``python`` is the body of that of a venv."""
    programs = tmp_path / "bin"
    programs.mkdir()
    for name, body in (
        ("cmake", f"echo old >>calls; echo BUILD_TESTS:BOOL=ON >CMakeCache.txt; echo '{OLD}' >&2; exit 1"),
        ("apt-get", 'echo "apt-get $*" >>calls'),
        ("id", "echo 0"),
        ("python3", "mkdir -p newer/bin; cp made newer/bin/python; cp bin/newer newer/bin/cmake"),
        ("newer", 'echo "$*" >>calls'),
    ):
        (programs / name).write_text(f"#!/bin/bash\n{body}\n", encoding="utf-8")
        (programs / name).chmod(0o755)
    made = tmp_path / "made"
    made.write_text(f'#!/bin/bash\necho "$*" >>calls\n{python}\n', encoding="utf-8")
    made.chmod(0o755)
    script = tmp_path / "configure.sh"
    text = SCRIPT.read_text(encoding="utf-8")
    script.write_text(text.replace("/opt/newer-cmake", f"{tmp_path}/newer"), encoding="utf-8")
    environment = {"PATH": f"{programs}:{os.environ['PATH']}"}
    command = ["bash", str(script), "-DA=1", "../"]
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
    return done.returncode, (tmp_path / "calls").read_text(encoding="utf-8").splitlines()


def test_a_cmake_that_is_too_old_is_not_used(tmp_path: Path) -> None:
    code, calls = too_old(tmp_path, "")
    assert (code, calls[0]) == (0, "old")
    assert calls[-2:] == ["-m pip install --quiet --no-cache-dir cmake>=3.13,<4", "-DA=1 ../"]


def test_a_pip_that_reads_no_bounds_is_given_them(tmp_path: Path) -> None:
    (said,) = [line for line in too_old(tmp_path, "")[1] if "--upgrade" in line]
    assert 'pip<21; python_version == "3.5"' in said


def test_where_pip_fails_the_other_ways_are_tried(tmp_path: Path) -> None:
    code, calls = too_old(tmp_path, "exit 1")
    assert code == 1
    assert calls[-1] == "old"  # with what its cache names left out
    assert calls.count("old") == 2


PAGE = "Needs [acme_lidar](https://github.com/lab/acme_lidar)"
OWN = "format: 3\nsource:\n  - {name: acme-lidar, repo: 'https://github.com/lab/acme_lidar', cmake_options: -DA=1}\n"


@pytest.mark.parametrize(
    ("asked", "yaml", "called"),
    [("acme_lidar", "", True), ("Pangolin", "", True), ("acme_lidar", OWN, False)],
    ids=["link", "table", "roslab.yaml"],
)
def test_it_is_for_a_library_that_no_author_configures(tmp_path: Path, asked: str, yaml: str, called: bool) -> None:
    made = f"project(demo)\nfind_package({asked} REQUIRED)\nadd_executable(a a.cpp)\n"
    files = {"CMakeLists.txt": made, "a.cpp": "int main() {}\n", "README.md": PAGE} | (
        {"roslab.yaml": yaml} if yaml else {}
    )
    tree_of(tmp_path, files)
    text = dockerfile(plan_repository(tmp_path).plan)
    assert f"AS library-1-{asked.lower().replace('_', '-')}" in text
    assert ("\nCOPY --from=scripts /configure-library /usr/local/bin/\n" in text) == called
    assert (" && configure-library " in text) == called
    assert ("\nCOPY --from=scripts /install-by-make /usr/local/bin/\n" in text) == (called and asked == "acme_lidar")


@pytest.mark.parametrize(
    ("file", "text", "calls"),
    [
        ("README.md", "```\ncmake -DINSTALL_DEPS=ON -DGUI=ON ..\n```\n", 2),
        (".github/workflows/ci.yml", "- run: cmake .. -DACME_FETCH_DEPENDENCIES:BOOL=ON\n", 2),
        ("README.md", "Never give -DINSTALL_DEPS=OFF\n", 1),
        ("README.md", "cmake -DUSE_GUI=ON -DBUILD_TOOLS=ON\n", 1),
    ],
)
def test_what_its_page_has_cmake_bring(tmp_path: Path, file: str, text: str, calls: int) -> None:
    build = tmp_path / "acme/build"
    build.mkdir(parents=True)
    (build.parent / file).parent.mkdir(parents=True, exist_ok=True)
    (build.parent / file).write_text(text)
    (build / "bin").mkdir()
    updates = 'echo "$*" >>updates\nexit 1'
    for name, body in (("id", "echo 0"), ("apt-get", updates), ("apt-mark", "exit 0"), ("rm", "exit 0")):
        (build / "bin" / name).write_text(f"#!/bin/bash\n{body}\n")
        (build / "bin" / name).chmod(0o755)
    script = build / "configure"
    script.write_text(SCRIPT.read_text().replace("/installed", str(tmp_path / "installed")))
    stand_in = build / "bin/cmake"
    stand_in.write_text('#!/bin/bash\necho "$*" >>calls\n[[ "$*" == *DEP*=ON* ]]\n')
    stand_in.chmod(0o755)
    path = {"PATH": f"{stand_in.parent}:{os.environ['PATH']}"}
    done = subprocess.run(
        ["bash", str(script), "../"], cwd=build, env=path, capture_output=True, text=True, check=False
    )
    called = (build / "calls").read_text().splitlines()
    assert (len(called), done.returncode) == (calls, 0 if calls == 2 else 1)
    assert ("have CMake bring what it needs" in done.stdout) == (calls == 2)
    assert (build / "updates").exists() == (calls == 2), (
        "apt has no lists in an image, and its packages are brought, too"
    )


def otherwise(folder: Path, files: dict[str, str]) -> tuple[str, Path]:
    """Call the script in the build folder of a library of these files, with a stand-in of CMake; return its words."""
    for name, text in files.items():
        (folder / "acme" / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / "acme" / name).write_text(text, encoding="utf-8")
    build = folder / "acme" / "build"
    build.mkdir()
    (folder / "bin").mkdir()
    (folder / "bin" / "cmake").write_text('#!/bin/bash\necho "cmake $*"\n', encoding="utf-8")
    (folder / "bin" / "cmake").chmod(0o755)
    path = {"PATH": f"{folder / 'bin'}:{os.environ['PATH']}"}
    command = ["bash", str(SCRIPT), "-DA=1", "../"]
    return subprocess.run(command, cwd=build, env=path, capture_output=True, text=True, check=True).stdout, build


def test_a_library_whose_project_lies_in_a_folder(tmp_path: Path) -> None:
    files = {
        "cpp/CMakeLists.txt": " project (acme)\n",
        "tests/CMakeLists.txt": "project(t)\n",
        "Makefile": "install:\n",
    }
    said, _ = otherwise(tmp_path, files)
    assert said == "roslab: acme has no CMakeLists.txt: that of its folder cpp is configured\ncmake -DA=1 ../cpp\n"


def test_a_library_with_a_configure_of_its_own(tmp_path: Path) -> None:
    said, _ = otherwise(tmp_path, {"configure": 'echo "configure $*"\n', "Makefile": "install:\n"})
    words = "roslab: acme has no CMakeLists.txt: its own configure is called"
    assert said == f"{words}\nconfigure --prefix=/usr/local\n"


@pytest.mark.parametrize(("mode", "called"), [(0o644, "sh"), (0o755, "bash")])
def test_its_own_configure_is_called_by_the_shell_that_it_names(tmp_path: Path, mode: int, called: str) -> None:
    script = tmp_path / "acme/configure"
    script.parent.mkdir()
    script.write_text("#!/bin/bash\necho ${BASH_VERSION:+bash}\n")
    script.chmod(mode)
    shells = tmp_path / "bin"
    shells.mkdir()
    (shells / "sh").write_text("#!/bin/bash\necho sh\n")
    (shells / "sh").chmod(0o755)
    (tmp_path / "acme/build").mkdir()
    done = subprocess.run(
        ["bash", str(SCRIPT), "../"],
        cwd=tmp_path / "acme/build",
        env={"PATH": f"{shells}:{os.environ['PATH']}"},
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout.splitlines()[-1] == called


def test_a_library_with_a_makefile_alone(tmp_path: Path) -> None:
    makefile = "all:\n\t@echo compiled\ninstall: all\n\t@echo installed [$(DESTDIR)]\n"
    said, build = otherwise(tmp_path, {"Makefile": makefile})
    assert said == "roslab: acme has no CMakeLists.txt: its own Makefile installs it\n"
    own = (SCRIPT.parent / "install-by-make.sh").read_text().replace("/installed", str(tmp_path / "installed"))
    for name, text in (("install-by-make", own), ("compile-jobs", "#!/bin/bash\necho 2\n")):
        (tmp_path / "bin" / name).write_text(text)
        (tmp_path / "bin" / name).chmod(0o755)
    made = subprocess.run(
        ["make", "--jobs=2", "install"],
        cwd=build,
        env={"PATH": f"{tmp_path / 'bin'}:{os.environ['PATH']}", "DESTDIR": "/other"},
        capture_output=True,
        text=True,
        check=True,
    )
    assert "compiled\n" in made.stdout
    assert "installed []\n" in made.stdout, "what it puts below /usr is copied"
    assert not made.stderr
    assert (tmp_path / "installed").is_dir()


def test_what_nothing_installs_is_left_to_cmake(tmp_path: Path) -> None:
    assert otherwise(tmp_path, {"Makefile": "all:\n"})[0] == "cmake -DA=1 ../\n"
