"""What tells that a pattern need not be tried."""

from __future__ import annotations

import pytest

from roslab.knowledge.hints import Hints, Search, hints, words_of
from roslab.knowledge.windows import shown
from roslab.values.dataclass import dataclass


@dataclass(frozen=True, kw_only=True)
class Row:
    """A row that has hints and nothing else."""

    hints: Hints


def row(cell: str) -> Row:
    return Row(hints=hints(cell))


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
    (wanted,) = rows = [row(cell)]
    assert Search(rows, words=True).possible(text, words_of(text)) == ([wanted] if found else [])


def test_of_other_texts_every_hint_is_a_part() -> None:
    (wanted,) = rows = [row("gca")]
    assert Search(rows).possible("agca gcas") == [wanted]


@pytest.mark.parametrize(
    ("text", "found"),
    [("xGetTime()", [0]), ("GpuMat Get", [1]), ("GpuMat.GetTime", [0, 1]), ("Get Gpu", []), ("cv", [2]), ("G.h", [3])],
)
def test_parts_that_begin_with_one_letter_are_told_apart(text: str, found: list[int]) -> None:
    rows = [row("GetTime"), row("GpuMat"), row("cv"), row("G.")]
    assert Search(rows).possible(text) == [rows[number] for number in found]


def test_rows_come_in_their_order_each_once_and_can_be_left_out() -> None:
    first, second, third = rows = [row("gca|np."), row("tomllib"), row("np.|gca")]
    text = "import tomllib\nnp.gca()"
    search = Search(rows, words=True)
    assert search.possible(text, words_of(text)) == [first, second, third]
    assert search.without(first).possible(text, words_of(text)) == [second, third]


def test_every_call_of_a_row_has_a_hint() -> None:
    text = "o3d.draw_geometries([cloud])"
    assert shown(text, words=words_of(text)) == {"open3d": 4}
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
        ("pybullet.connect(pybullet.GUI)", {"pybullet": 9}),
        ("p.connect(p.DIRECT)", {}),
        ("viewer = MjViewer(sim)", {"mujoco": 9}),
        ("class Seen(MjViewer):", {"mujoco": 11}),
        ("mujoco.viewer.launch_passive(m, d)", {"mujoco": 7}),
        ("gym.create_viewer(sim, props)", {"isaacgym": 4}),
    ],
)
def test_a_call_begins_with_a_whole_name(text: str, found: dict[str, int]) -> None:
    assert shown(text, words=words_of(text)) == found
