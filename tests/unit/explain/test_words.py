"""An answer as what stopped a build, for annotations and summaries."""

from __future__ import annotations

import io

import pytest

from roslab.engine.docker import why
from roslab.explain import signatures, words
from roslab.explain.answer import explain

MISSING = """\
#6 [3/4] RUN make
#6 1.2 src/a.cpp:3:10: fatal error: glog/logging.h: No such file or directory
#6 ERROR: process "/bin/sh -c make" did not complete successfully: exit code: 2
"""


def test_a_known_cause_comes_with_its_line_and_what_to_write() -> None:
    (problem,) = why(MISSING)
    assert "header glog/logging.h is missing" in problem.message
    assert "src/a.cpp:3:10" in problem.message
    assert problem.hint is not None
    assert problem.hint.endswith("In roslab.yaml: `apt: [libgoogle-glog-dev]`.")


def test_an_unknown_cause_names_the_step_and_its_first_error() -> None:
    (problem,) = why(MISSING.replace("fatal error: glog/logging.h: No such file or directory", "error: odd"))
    assert problem.message == "the build failed in `RUN make`: src/a.cpp:3:10: error: odd"
    assert "no known cause" in (problem.hint or "")


def test_a_log_that_says_nothing_still_stops_the_build() -> None:
    assert why("Successfully built 0123456789ab\n")[0].message == "the build failed"


def test_a_step_of_the_classic_builder_is_tried_in_the_image_before_it() -> None:
    log = "Step 1/2 : FROM ubuntu:22.04\n ---> 0123456789ab\nStep 2/2 : RUN ./odd\n ---> Running in 1a2b3c4d5e6f\n"
    log += "odd: it is odd\nThe command '/bin/sh -c ./odd' returned a non-zero code: 1\n"
    (found,) = explain(io.BytesIO(log.encode())).explanations
    assert found.reproduce == "docker run --rm -it 0123456789ab /bin/sh"


def test_a_key_with_one_value_is_shown_without_a_list() -> None:
    log = "AttributeError: module 'pkgutil' has no attribute 'ImpImporter'. Did you mean: 'zipimporter'?\n"
    assert "roslab.yaml: base.python: 3.11\n" in words.text(explain(io.BytesIO(log.encode())))


def test_docker_that_a_step_calls_is_another_failure_than_docker_that_builds() -> None:
    said = "Cannot connect to the Docker daemon at unix:///var/run/docker.sock. Is the docker daemon running?\n"
    in_step = f"#6 [3/4] RUN docker pull robot\n#6 1.2 {said}#6 ERROR: process did not complete: exit code: 1\n"
    found = [explain(io.BytesIO(log.encode())).explanations[0].id for log in (said, in_step)]
    assert found == ["docker-daemon-absent", "service-not-running"]


def test_a_warning_of_an_old_python_is_not_taken_for_a_host_that_is_gone() -> None:
    said = "#6 1.2 ssl_.py:79: InsecurePlatformWarning: A true SSLContext object is not available.\n"
    gone = "#6 1.2 Retrying (Retry(total=0)) after connection broken by gaierror(-2, 'Name or service not known')\n"
    end = "#6 1.2 No matching distribution found for a==1\n#6 ERROR: process did not complete: exit code: 1\n"
    start = "#6 [3/4] RUN pip install a==1\n"
    found = [explain(io.BytesIO((start + log + end).encode())).explanations[0].id for log in (said, said + gone)]
    assert found[0] == "pip-ssl"
    assert found[1] != "pip-ssl"


@pytest.mark.parametrize(
    ("sentence", "names", "filled"),
    [
        ("It ends ({kind}): {why}.", {"kind": "odd", "why": "no arm"}, "It ends (odd): no arm."),
        ("It ends ({kind}): {why}.", {"kind": "odd"}, "It ends (odd)."),
        ("Others ({wants}) than it has (Python {python}).", {"python": "3.9"}, "Others than it has (Python 3.9)."),
    ],
)
def test_a_name_that_is_not_known_leaves_no_mark(sentence: str, names: dict[str, str], filled: str) -> None:
    assert signatures.filled(sentence, names) == filled


@pytest.mark.parametrize(
    ("module", "package"),
    [
        ("mesonpy", "meson-python"),
        ("poetry.core.masonry.api", "poetry-core"),
        ("poetry.masonry.api", "poetry"),
        ("pdm.pep517.api", "pdm-pep517"),
        ("jupyter_packaging.build_api", "jupyter-packaging"),
    ],
)
def test_a_build_backend_comes_with_its_package(module: str, package: str) -> None:
    log = f"#6 [3/4] RUN pip install .\n#6 1.2 BackendUnavailable: Cannot import '{module}'\n"
    log += "#6 ERROR: process did not complete: exit code: 1\n"
    assert dict(explain(io.BytesIO(log.encode())).explanations[0].names)["package"] == package


@pytest.mark.parametrize(
    "said",
    [
        "NameNotFound: Environment `{}` doesn't exist.",
        "VersionNotFound: Environment version `v9` for environment `{}` doesn't exist. It provides version v1.",
        "DeprecatedEnv: Environment version v0 for `{}` is deprecated. Please use another one.",
    ],
)
def test_the_environment_that_gym_does_not_have_is_named(said: str) -> None:
    log = f"Traceback (most recent call last):\ngymnasium.error.{said.format('ArmReach')}\n"
    found = explain(io.BytesIO(log.encode())).explanations[0]
    assert (found.id, dict(found.names)["name"]) == ("gym-environment-unknown", "ArmReach")


def test_what_a_terminal_would_obey_is_shown_and_not_sent() -> None:
    """ESC c clears the whole terminal; a log may hold it by chance, or on purpose."""
    odd = MISSING.replace("fatal error: glog/logging.h: No such file or directory", "error:\todd \x1bc\x08\x9b2J")
    said = words.text(explain(io.BytesIO(odd.encode())))
    assert "odd" in said
    assert not {"\x1b", "\x08", "\x9b"} & set(said)
