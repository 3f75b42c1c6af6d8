"""What a failed run hands over: the place that asked, the lines to paste, and the same in the summary."""

from __future__ import annotations

import io
from collections.abc import Sequence
from pathlib import Path

import pytest

from roslab.errors import Problem, RoslabError
from roslab.explain.answer import explain
from roslab.github import kept, workflow
from roslab.github.explaining import explain_proof, explain_start, mend
from roslab.github.run import Folder, Run, to_line
from roslab.pipeline import plan_repository
from roslab.render.outcome import Report
from roslab.render.summary import summary
from roslab.repair.chain import Asking

LOG = b"""\
#6 [3/4] RUN make
#6 1.2 /home/jovyan/robot/src/main.cpp:1:13: fatal error: glog/logging.h: No such file or directory
#6 ERROR: process "/bin/sh -c make" did not complete successfully: exit code: 2
"""
LINE = "  - libgoogle-glog-dev  # for the header glog/logging.h (src/main.cpp:1)\n"


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    folder = tmp_path / "robot"
    (folder / "src").mkdir(parents=True)
    (folder / "CMakeLists.txt").write_text("project(robot CXX)\nadd_executable(robot src/main.cpp)\n")
    (folder / "src" / "main.cpp").write_text("#define L <glog/logging.h>\n#include L\nint main() {}\n")
    return folder


def run_of(folder: Path, *, path: str = "") -> Run:
    planned = plan_repository(folder)
    return Run(
        plan=planned.plan, image="ghcr.io/o/robot", username="o", push=False, reason="a pull request", cache="none",
        path=path, config=planned.config.file or "",
    )  # fmt: skip


@pytest.mark.parametrize(
    ("config", "lines", "new"),
    [
        (None, f"format: 3\napt:\n{LINE}", True),
        ("format: 3\napt:\n  - git\n", f"apt:\n{LINE}", False),
    ],
)  # fmt: skip
def test_the_place_and_the_lines(checkout: Path, config: str | None, lines: str, new: bool) -> None:
    if config:
        (checkout / "roslab.yaml").write_text(config)
    mending = mend(explain(io.BytesIO(LOG)), run_of(checkout, path="robots/arm"), checkout)
    (problem,) = mending.problems
    (told,) = mending.repairs
    assert (problem.file, problem.line) == ("robots/arm/src/main.cpp", 1)
    assert workflow.error_commands(RoslabError(problem)).startswith("::error file=robots/arm/src/main.cpp,line=1::")
    assert "In roslab.yaml: `apt: [libgoogle-glog-dev]`." in str(problem)
    assert (told.file, told.text, told.new) == ("robots/arm/roslab.yaml", lines, new)
    assert (mending.hunk is None) == new, "a file that does not exist has no line for a suggestion"


def test_a_package_that_the_build_has_left_out_is_not_asked_for(checkout: Path) -> None:
    log = f"#5 [2/4] RUN x\n#5 1.2 roslab: left out: apt libgoogle-glog-dev\n{LOG.decode()}"
    mending = mend(explain(io.BytesIO(log.encode())), run_of(checkout), checkout)
    assert (mending.repairs, mending.hunk) == ((), None)


def test_what_no_table_knows_apt_is_asked_for(checkout: Path) -> None:
    asked: list[str] = []

    def asking(paths: Sequence[str]) -> str:
        asked.extend(paths)
        return "1 libzoo-dev\n"

    log = LOG.replace(b"glog/logging.h", b"zoo/arm.h")
    mending = mend(explain(io.BytesIO(log)), run_of(checkout), checkout, Asking(files=asking))
    assert asked[0].endswith(r"zoo/arm\.h")
    assert "In roslab.yaml: `apt: [libzoo-dev]`." in str(mending.problems[0])
    assert mending.repairs[0].text == "format: 3\napt:\n  - libzoo-dev  # for the header zoo/arm.h (src/main.cpp:1)\n"
    asked.clear()
    mend(explain(io.BytesIO(LOG)), run_of(checkout), checkout, Asking(files=asking))
    assert not asked, "a table knows it"


def test_an_own_dockerfile_gets_a_diff(checkout: Path) -> None:
    (checkout / "roslab.yaml").write_text("format: 3\ndockerfile: Dockerfile\n")
    (checkout / "Dockerfile").write_text("FROM ubuntu:22.04\nCOPY . .\nRUN make\n")
    mending = mend(explain(io.BytesIO(LOG)), run_of(checkout), checkout)
    assert mending.repairs[0].diff
    assert "\n+RUN apt-get update" in mending.repairs[0].text
    assert mending.hunk is not None
    assert (mending.hunk.file, mending.hunk.start) == ("Dockerfile", 2)


def test_a_path_cannot_add_properties_to_its_annotation(checkout: Path) -> None:
    (checkout / "a,line=9").mkdir()
    (checkout / "a,line=9" / "b.cpp").write_text("#include <glog/logging.h>\n")
    mending = mend(explain(io.BytesIO(LOG)), run_of(checkout), checkout)
    assert workflow.error_commands(RoslabError(*mending.problems)).startswith(
        "::error file=a%2Cline=9/b.cpp,line=1::The header"
    )


def test_what_a_job_keeps_is_in_the_summary(checkout: Path, tmp_path: Path) -> None:
    run = run_of(checkout)
    mending = mend(explain(io.BytesIO(LOG)), run, checkout)
    kept.begin(tmp_path / "artifact", platform="", attempt=1)
    kept.mend(tmp_path / "artifact", mending.repairs)
    kept.fail(tmp_path / "artifact", [str(problem) for problem in mending.problems])
    (job,) = kept.gather(tmp_path)
    assert job.repairs == mending.repairs
    report = Report(
        plan=run.plan, image=run.image, published=False, reason="", failures=job.failures, repairs=job.repairs
    )
    text = summary(report)
    assert "Lines for the new file `roslab.yaml`:\n\n```yaml\nformat: 3\napt:\n  - libgoogle-glog-dev" in text
    assert text.index("❌ Failed") < text.index("Lines for the new file")


def test_a_checkout_that_cannot_be_read_is_explained_by_its_log_alone(checkout: Path, tmp_path: Path) -> None:
    run = run_of(checkout)
    mending = mend(explain(io.BytesIO(LOG)), run, tmp_path / "gone")
    assert "glog/logging.h" in str(mending.problems[0])
    assert mending.repairs == ()


MODULE = """\
Traceback (most recent call last):
  File "run.py", line 1, in <module>
    import yaml
ModuleNotFoundError: No module named 'yaml'
"""
LIBRARY = "./viewer: error while loading shared libraries: libglfw.so.3: cannot open shared object file: No such file\n"
PROOFS = [
    (MODULE, "Python finds no module yaml", "pip:\n  - PyYAML"),
    (LIBRARY, "The shared library libglfw.so.3 is missing", "apt:\n  - libglfw3"),
    ("Unable to init server: Could not connect: refused\nViewer: cannot open display: \n", "no display", "gui: true"),
    ("RuntimeError: No CUDA GPUs are available\n", "needs a device", ""),
]


@pytest.mark.parametrize(("output", "cause", "lines"), PROOFS, ids=["import", "library", "display", "device"])
def test_a_failed_proof_says_why(checkout: Path, tmp_path: Path, output: str, cause: str, lines: str) -> None:
    folder = Folder(path=tmp_path / "run-folder")
    folder.path.mkdir()
    folder.write("run", to_line(run_of(checkout)))
    kept.begin(folder.artifact, platform="", attempt=1)
    failure = Problem(message="on linux/amd64, test: failed with exit code 1", hint="correct the code")
    names = {"GITHUB_WORKSPACE": str(checkout), "GITHUB_EVENT_NAME": "push", "GITHUB_REPOSITORY": "o/robot"}
    told = explain_proof(folder, failure, output, names)
    assert told.message.startswith("on linux/amd64, test: failed with exit code 1: ")
    assert cause in told.message
    (job,) = kept.gather(folder.artifact)
    assert [lines in repair.text for repair in job.repairs] == ([True] if lines else [])
    assert explain_proof(folder, failure, "the robot says no\n", names) is failure


@pytest.mark.parametrize("case", PROOFS, ids=["import", "library", "display", "device"])
def test_a_command_that_dies_is_told_though_the_image_is_good(
    checkout: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], case: tuple[str, str, str]
) -> None:
    output, cause, lines = case
    folder = Folder(path=tmp_path / "run-folder")
    folder.path.mkdir()
    folder.write("run", to_line(run_of(checkout)))
    kept.begin(folder.artifact, platform="", attempt=1)
    names = {"GITHUB_WORKSPACE": str(checkout), "GITHUB_EVENT_NAME": "push", "GITHUB_REPOSITORY": "o/robot"}
    explain_start(folder, "linux/amd64", output, names)
    said = capsys.readouterr().err
    assert said.startswith("::warning")
    assert "::the default command does not start on linux/amd64: " in said
    assert cause in said
    (job,) = kept.gather(folder.artifact)
    assert [lines in repair.text for repair in job.repairs] == ([True] if lines else [])
    told = Report(plan=folder.run.plan, image="ghcr.io/o/robot", published=True, reason="", repairs=job.repairs)
    shown = "So that the default command starts: lines for the new file `roslab.yaml`:"
    assert (shown in summary(told)) == bool(lines)
    explain_start(folder, "linux/amd64", "the robot says no\n", names)
    assert capsys.readouterr().err == ""
