"""A pin beside which another package does not work, though that one does not say so, is told with what to write."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.decide.python.contradicted import contradicted
from roslab.values.requirement_line import stated

Tree = Callable[[dict[str, str]], Decision]


@pytest.mark.parametrize(
    ("lines", "advice"),
    [
        (["stable-baselines==2.7.0", "tensorflow==2.4.1"], ["write tensorflow<2 there, with a Python of 3.7 or older"]),
        (["stable_baselines", "tensorflow-gpu>=2.1"], ["write tensorflow-gpu<2 there, with a Python of 3.7 or older"]),
        (["stable-baselines[mpi]", "tensorflow==1.15"], []),
        (["stable-baselines", "tensorflow"], []),
        (["stable-baselines3", "tensorflow==2.4.1"], []),
        (["stable-baselines @ git+https://github.com/hill-a/stable-baselines", "tensorflow==2.4.1"], []),
        (["torchvision==0.4.0", "Pillow==8.1.0"], ["write Pillow<7 there, with a Python of 3.8 or older"]),
        (["torchvision==0.6.0", "Pillow==8.1.0"], []),
        (["flask==1.1.2", "jinja2>=3.1", "werkzeug==2.2"], ["write jinja2<3.1 there", "write werkzeug<2.1 there"]),
        (["torch==1.8.0", "torchvision==0.8.0"], ["write `torchvision==0.9.0` here"]),
        (["torchvision==0.8.2+cu110", "torch==1.7.1+cu110", "torchaudio==0.7.0"], ["write `torchaudio==0.7.2` here"]),
        (["torch==1.7.1", "torchvision==0.8.2+cu110"], []),
        (["torch==0.1.0", "torchvision==0.9.0"], ["write the release of torchvision for that one here"]),
        (["torch>=1.8", "torchvision==0.8.0"], []),
        (["torch==1.8.*", "torchvision==0.8.0"], []),
        (["torchvision==0.8.0"], []),
        (["torch==1.8.0; python_version<'3.9'", "torch==1.7.0; python_version>='3.9'", "torchvision==0.8.0"], []),
        (["descartes", "shapely==2.0.1", "shapely==2.0.1"], ["write shapely<2 there, or take a release of descartes"]),
    ],
)
def test_pairs_that_no_package_says_to_be_none(lines: list[str], advice: list[str]) -> None:
    found = [each.message for each in contradicted(stated(line, "manifest", "list.txt") for line in lines)]
    assert len(found) == len(advice)
    assert all(part in message for part, message in zip(advice, found, strict=True))


def test_the_line_to_change_is_told(tree: Tree) -> None:
    code = "import stable_baselines\nimport tensorflow\n"
    found = tree({"requirements.txt": "numpy\ntensorflow==2.4.1\n", "main.py": code})
    ((message, file, line),) = [
        (w.message, w.file, w.line) for w in found.warnings if "stable-baselines3, which" in w.message
    ]
    assert (file, line) == ("requirements.txt", 2)
    assert "(main.py:1) needs tensorflow<2" in message


@pytest.mark.parametrize(
    ("line", "brought"),
    [
        ("stable-baselines==2.7.0", True),
        ("stable-baselines<2.8", True),
        ("stable-baselines==2.10.2", False),
        ("stable-baselines", False),
        ("stable-baselines[mpi]==2.10.2", True),
    ],
)
def test_what_comes_with_a_release_needs_its_libraries(tree: Tree, line: str, brought: bool) -> None:
    found = tree({"requirements.txt": f"tensorflow==1.15\n{line}\n", "main.py": "import stable_baselines\n"})
    assert ("libopenmpi-dev" in {*found.apt, *found.apt_guessed}) is brought
