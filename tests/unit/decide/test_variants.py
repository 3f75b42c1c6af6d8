"""An import is no reason to install a second build of a package that the repository names."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
CONDA = "name: demo\ndependencies:\n  - python=3.10\n  - {package}\n  - pip\n"


@pytest.mark.parametrize(
    ("files", "module", "guessed"),
    [
        ({"environment.yml": CONDA.format(package="faiss-gpu=1.8.0")}, "faiss", []),
        ({"environment.yml": CONDA.format(package="faiss")}, "faiss", []),
        ({"environment.yml": CONDA.format(package="opencv")}, "cv2", []),
        ({"environment.yml": CONDA.format(package="tensorflow-gpu")}, "tensorflow", []),
        ({"environment.yml": CONDA.format(package="scipy")}, "faiss", ["faiss-cpu"]),
        ({"requirements.txt": "faiss-gpu==1.7.2\n"}, "faiss", []),
        ({"requirements.txt": "opencv-contrib-python\n"}, "cv2", []),
        ({"requirements.txt": "opencv-python-headless\n"}, "cv2", []),
        ({"requirements.txt": "tensorflow-gpu==2.4.0\n"}, "tensorflow", []),
        ({"requirements.txt": "onnxruntime-gpu\n"}, "onnxruntime", []),
        ({"requirements.txt": "scipy\n"}, "onnxruntime", ["onnxruntime"]),
    ],
)
def test_what_a_named_build_has_is_not_guessed(
    tree: Tree, files: dict[str, str], module: str, guessed: list[str]
) -> None:
    code = {"run.py": f"import {module}\nif __name__ == '__main__':\n    print({module})\n"}
    assert [each.name for each in tree({**code, **files}).python.pip_guessed] == guessed
