"""The archives on projects' own sites that stand for tags of their repositories."""

from __future__ import annotations

import pytest

from roslab.evidence.prose.archives import is_release
from roslab.knowledge.source_archives import source_archive

EIGEN = ("https://gitlab.com/libeigen/eigen", "eigen", "3.3.4")


@pytest.mark.parametrize(
    ("url", "found"),
    [
        ("http://dlib.net/files/dlib-19.13.tar.bz2", ("https://github.com/davisking/dlib", "dlib", "v19.13")),
        ("http://dlib.net/files/shape_predictor_68_face_landmarks.dat.bz2", None),
        (
            "http://ceres-solver.org/ceres-solver-1.14.0.tar.gz",
            ("https://github.com/ceres-solver/ceres-solver", "ceres-solver", "1.14.0"),
        ),
        ("https://gitlab.com/libeigen/eigen/-/archive/3.3.4/eigen-3.3.4.zip", EIGEN),
        ("http://bitbucket.org/eigen/eigen/get/3.3.4.tar.bz2", EIGEN),
        ("https://gitlab.com/lab/eigen/-/archive/3.3.4/eigen-3.3.4.zip", None),
    ],
)
def test_an_archive_is_a_tag(url: str, found: tuple[str, str, str] | None) -> None:
    assert source_archive(url) == found
    assert is_release(url) is (found is not None)
