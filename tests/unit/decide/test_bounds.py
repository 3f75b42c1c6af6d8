"""Code that uses what a package has removed keeps the versions that still have it."""

from __future__ import annotations

import datetime as dt
from pathlib import Path

import pytest
from packaging.requirements import Requirement

from hanging import ends
from roslab.decide.python.bounds import decide_bounds
from roslab.evidence.python import removed
from roslab.evidence.removed_name import Removed
from roslab.knowledge.removals import removals
from roslab.knowledge.table import rows
from roslab.repository.checkout import Repository
from roslab.values.requirement_line import stated


def bounds(tmp_path: Path, code: str) -> dict[str, int]:
    (tmp_path / "demo.py").write_text(code, encoding="utf-8")
    return {use.bound.text: use.line for use in removed.read(Repository.open(tmp_path))}


@pytest.mark.parametrize(
    ("code", "found"),
    [
        ('def f():\n    """Return\n\n    <np.float: 3>.\n    """\n    return 1\n', {}),
        ("'''\nx = np.float(1)\n'''\n", {}),
        ('def f():\n    """np.float"""\n    return np.float(1)\n', {"numpy<1.24": 3}),
        ('a = """\n{}\n""".format(np.float(1))\n', {"numpy<1.24": 3}),
        ('"""np.float"""\nprint np.float(1)\n', {"numpy<1.24": 1}),
    ],
)
def test_a_docstring_uses_nothing(tmp_path: Path, code: str, found: dict[str, int]) -> None:
    assert bounds(tmp_path, code) == found


@pytest.mark.parametrize(
    ("code", "bound"),
    [
        ("rc = {'text.latex.preamble': [r'\\usepackage{amsmath}']}", "matplotlib<3.5"),
        ("plt.rcParams['text.latex.preamble'] = [r'\\usepackage{bm}']", "matplotlib<3.5"),
        ("ax = fig.gca(projection='3d')", "matplotlib<3.6"),
        ("if name in registry.env_specs:", "gym<0.26"),
        ("x = np.zeros(3, dtype=np.float)", "numpy<1.24"),
        ("limit = np.Inf", "numpy<2"),
        ("from scipy.misc import imread, toimage", "scipy<1.2"),
        ("from scipy.misc import derivative", "scipy<1.15"),
        ("from sklearn.externals import joblib", "scikit-learn<0.23"),
        ("cfg = yaml.load(open('a.yaml'))", "PyYAML<6"),
        ("df = df.append({'a': 1}, ignore_index=True)", "pandas<2"),
        ("from diffusers.optimization import (\n    SchedulerType, Union,\n    Optimizer)", "diffusers<0.37"),
        ("from diffusers.optimization import Optional, get_scheduler", "diffusers<0.37"),
        ("import drawSvg as draw", "drawSvg<2"),
        ("from rsl_rl.utils import resolve_obs_groups, store_code_state", "rsl-rl-lib<3.2"),
        ("from rsl_rl.modules import ActorCritic, ActorCriticRecurrent", "rsl-rl-lib<4"),
        ("from rsl_rl.networks import EmpiricalNormalization", "rsl-rl-lib<4"),
    ],
)
def test_a_removed_name_gives_a_bound(tmp_path: Path, code: str, bound: str) -> None:
    assert bounds(tmp_path, f"import os\n{code}\n") == {bound: 2}


@pytest.mark.parametrize(
    "code",
    [
        "x = np.float32(1) + np.int64(2) + np.bool_(1)",
        "plt.rcParams['text.latex.preamble'] = r'\\usepackage{bm}'",
        "cfg = yaml.load(stream, Loader=yaml.SafeLoader)",
        "rows.append(row)",
        "limit = np.inf",
        "import drawsvg as draw",
        "from rsl_rl.modules import EmpiricalNormalization\nfrom rsl_rl.utils import resolve_obs_groups",
        "from diffusers.optimization import (\n    get_scheduler)\nfrom typing import Union",
    ],
)
def test_todays_names_give_none(tmp_path: Path, code: str) -> None:
    assert bounds(tmp_path, code) == {}


def test_the_lowest_bound_of_a_package_counts(tmp_path: Path) -> None:
    assert bounds(tmp_path, "a = np.Inf\nb = np.float(1)\n") == {"numpy<1.24": 2}


@pytest.mark.parametrize(
    "code",
    [
        "if MAJOR == 1 and MINOR < 8:\n    from torch._six import istuple\nelse:\n    istuple = None\n",
        "if torch.__version__ >= '1.8':\n    import collections\nelse:\n    from torch._six import inf\n",
        "if digit_version(torch.__version__) < digit_version('2'):\n\n    from torch._six import inf\n",
        "def load():\n    if LooseVersion(v) < '2':\n        for a in b:\n            import torch._six\n",
        "try:\n    from torch._six import inf\nexcept ImportError:\n    from torch import inf\n",
        "try:\n    from torch import inf\nexcept (ImportError, KeyError):\n    from torch._six import inf\n",
        "import numpy as np\nkind = np.float if hasattr(np, 'float') else float\n",
        "if torch_major < 2:\n    from torch._six import inf\n",
        "if TORCH_VERSION < (2, 0):\n    from torch._six import inf\n",
        "try:\n    from torch._six import inf\nexcept:\n    from torch import inf\n",
        "try:\n    from torch import inf\nexcept:\n    from torch._six import inf\n",
        "def f(x):\n    try:\n        return np.float(x)\n    except AttributeError:\n        return float(x)\n",
    ],
)
def test_a_branch_for_some_versions_gives_none(tmp_path: Path, code: str) -> None:
    assert bounds(tmp_path, code) == {}


@pytest.mark.parametrize(
    ("code", "line"),
    [
        ("if args.version == 'v1.0':\n    from torch._six import inf\n", 2),
        ("if train:\n    x = 1\nelse:\n    from torch._six import inf\n", 4),
        ("try:\n    from torch._six import inf\nexcept ImportError:\n    raise SystemExit('install torch')\n", 2),
        ("try:\n    from torch._six import inf\nexcept KeyboardInterrupt:\n    stop()\n", 2),
        ("if torch.__version__ < '2':\n    a = 1\nfrom torch._six import inf\n", 3),
        ("if MAJOR < 2:\n    from torch._six import inf\nelse:\n    inf = 1\nfrom torch._six import b\n", 5),
        ("if hasattr(self, 'viewer'):\n    from torch._six import inf\n", 2),
        ("if major:\n    from torch._six import inf\n", 2),
        ("if tf_verbose:\n    from torch._six import inf\n", 2),
        ("if sys.version_info[0] >= 3:\n    from torch._six import inf\n", 2),
        ("if torch_verts is not None:\n    from torch._six import inf\n", 2),
        ("if row_major:\n    from torch._six import inf\n", 2),
        ("try:\n    from torch._six import inf\nexcept ImportError:\n    # none\n    pass\n", 2),
        ("try:\n    x = torch._six.inf\nexcept:\n    x = 0\n", 2),
        ("try:\n    from torch._six import inf\nexcept:\n    traceback.print_exc()\n", 2),
        ("try:\n    from torch._six import inf\nexcept ImportError: pass\nx = 1\n", 2),
        ("def f():\n    try:\n        import torch._six\n    except ImportError:\n        return None\n", 3),
        ("for a in b:\n    try:\n        import torch._six\n    except ImportError:\n        continue\n", 3),
    ],
)
def test_a_line_that_always_runs_gives_one(tmp_path: Path, code: str, line: int) -> None:
    assert bounds(tmp_path, code) == {"torch<2": line}


@pytest.mark.parametrize(
    ("line", "bounded"),
    [("numpy", True), ("NumPy>=1.10", True), ("numpy==1.26.4", False), ("numpy<3", False), ("scipy", False)],
)
def test_the_authors_own_limit_wins_and_what_is_not_installed_needs_none(
    tmp_path: Path, line: str, bounded: bool
) -> None:
    (tmp_path / "a.py").write_text("np.float(1)", encoding="utf-8")
    found = decide_bounds(removed.read(Repository.open(tmp_path)), [stated(line)])
    assert [bound.text for bound in found.answer] == (["numpy<1.24"] if bounded else [])
    assert [(reason.file, reason.line) for reason in found.reasons] == ([("a.py", 1)] if bounded else [])


def limits(uses: tuple[Removed, ...], *lines: str) -> list[str]:
    return [bound.text for bound in decide_bounds(uses, map(stated, lines)).answer]


def test_a_bound_that_the_author_excludes_is_none(tmp_path: Path) -> None:
    (tmp_path / "a.py").write_text("np.Inf\nfig.gca(projection='3d')\n", encoding="utf-8")
    uses = removed.read(Repository.open(tmp_path))
    assert limits(uses, "numpy>=2.0.0", "matplotlib>=3.5") == ["matplotlib<3.6"]
    assert limits(uses, "numpy>=1.26", "numpy>=2.1; python_version >= '3.13'") == ["numpy<2"]


@pytest.mark.parametrize("line", ["numpy>1.26", "numpy~=2.1", "numpy>=1.24,!=1.25"])
def test_another_floor_than_at_least_excludes_it_too(tmp_path: Path, line: str) -> None:
    (tmp_path / "a.py").write_text("np.float(1)\n", encoding="utf-8")
    assert limits(removed.read(Repository.open(tmp_path)), line) == []


def test_what_was_compiled_against_numpy_1_keeps_numpy_2_out(tmp_path: Path) -> None:
    (tmp_path / "a.py").write_text("fig.gca(projection='3d')", encoding="utf-8")
    uses = removed.read(Repository.open(tmp_path))
    assert limits(uses, "matplotlib") == ["matplotlib<3.6", "numpy<2"]
    assert limits(uses, "matplotlib", "numpy==2.1") == ["matplotlib<3.6"], "the author's own pin wins"
    (tmp_path / "b.py").write_text("np.float(1)", encoding="utf-8")
    both = removed.read(Repository.open(tmp_path))
    assert limits(both, "matplotlib", "numpy") == ["matplotlib<3.6", "numpy<1.24"]


@pytest.mark.parametrize(
    ("code", "bound"),
    [
        ("app = socketio.Middleware(sio, app)\n", "python-socketio<5"),
        ("app = socketio.WSGIApp(sio, app)\n", None),
        ("import imageio\nimageio.plugins.ffmpeg.download()\n", "imageio<2.5"),
        ("ffmpeg.download()\n", None),
        ("from atari_py import get_game_path\n", "gym<0.20"),
        ("from sklearn.cross_validation import train_test_split\n", "scikit-learn<0.20"),
        ("from sklearn import svm, grid_search\n", "scikit-learn<0.20"),
        ("from sklearn.model_selection import cross_validate, learning_curve\n", None),
        ("from sklearn.utils.linear_assignment_ import linear_assignment\n", "scikit-learn<0.23"),
        ("from scipy.integrate import quad, simps\n", "scipy<1.14"),
        ("area = np.trapz(y, x)\n", None),
        ("from kornia import gaussian_blur2d, motion_blur\n", "kornia<0.6"),
        ("grey = kornia.rgb_to_grayscale(image)\n", "kornia<0.6"),
        ("steps = [kornia.sobel]\n", "kornia<0.6"),
        ("grey = kornia.color.rgb_to_grayscale(image)\nfrom kornia.filters import gaussian_blur2d\n", None),
        ("m = nx.to_numpy_matrix(g)\n", "networkx<3"),
        ("env = wrappers.Monitor(env, 'videos')\n", "gym<0.23"),
        ("class Monitor: pass\n", None),
    ],
)
def test_names_of_one_package_alone(tmp_path: Path, code: str, bound: str | None) -> None:
    (tmp_path / "a.py").write_text(code, encoding="utf-8")
    found = removed.read(Repository.open(tmp_path))
    assert [use.bound.text for use in found] == ([bound] if bound else [])


def test_every_row_is_whole() -> None:
    for row, removal in zip(rows("removals"), removals(), strict=True):
        assert Requirement(row["bound"]).name == row["package"]
        assert row["source"].startswith("https://")
        assert dt.date.fromisoformat(row["date"])
        assert removal.what


def test_patterns_take_linear_time() -> None:
    text = "np.x.append(from scipy.misc import yaml.load(((((" * 5_000
    with ends():
        for removal in removals():
            removal.pattern.search(text)


def test_a_comment_uses_nothing(tmp_path: Path) -> None:
    assert bounds(tmp_path, "    # scipy.misc.imsave(filename, image)\nx = np.float(1)  # np.float\n") == {
        "numpy<1.24": 2
    }


@pytest.mark.parametrize(
    ("newer", "bound"),
    [("data = tf.data.AUTOTUNE", False), ("writer = tf.summary.create_file_writer('a')", False), ("tf.ones(1)", True)],
)
def test_code_for_the_newer_version_beside_a_baseline_for_the_older_one(
    tmp_path: Path, newer: str, *, bound: bool
) -> None:
    (tmp_path / "baseline.py").write_text("import tensorflow as tf\nx = tf.placeholder(tf.float32)\n")
    (tmp_path / "train.py").write_text(f"import tensorflow as tf\n{newer}\n")
    found = removed.read(Repository.open(tmp_path))
    assert [use.bound.text for use in found] == (["tensorflow<2"] if bound else [])
