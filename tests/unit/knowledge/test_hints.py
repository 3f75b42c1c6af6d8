"""What tells that a pattern need not be tried."""

from __future__ import annotations

import pytest

from roslab.knowledge.hints import hints, words_of
from roslab.knowledge.windows import shown


def test_only_words_that_somebody_looks_for_are_kept() -> None:
    text = "import tomllib\nfigure.gca(projection)  # é_six\nxgca gcax nothing"
    assert words_of(text) == {"tomllib", "gca", "_six"}


@pytest.mark.parametrize(
    ("cell", "text", "found"),
    [
        ("gca", "plt.gca()", True),
        ("gca", "agca gcas", False),
        ("gca|get_cmap", "cm.get_cmap(1)", True),
        ("np.", "jnp.float", True),
        ("np.", "np", False),
        ("f\"|f'", "print(f'{x}')", True),
    ],
)
def test_a_name_is_a_whole_word_and_anything_else_a_part(cell: str, text: str, found: bool) -> None:
    assert hints(cell).stand_in(text) is found


def test_every_call_of_a_row_has_a_hint() -> None:
    assert shown("o3d.draw_geometries([cloud])") == {"open3d": 4}
    assert shown("cv::imshow(name, image);", "c++") == {"opencv": 0}


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("cv2.imshow('a', b)", {"opencv": 0}),
        ("cv.imshow('a', b)", {"opencv": 0}),
        ("mycv2.imshow('a', b)", {}),
        ("open3d.visualization.draw(x)", {"open3d": 7}),
        ("myvisualization.draw(x)", {}),
        ("plt.show()", {"matplotlib": 0}),
    ],
)
def test_a_call_begins_with_a_whole_name(text: str, found: dict[str, int]) -> None:
    assert shown(text) == found
