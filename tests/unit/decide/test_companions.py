"""What functions of a package need beside it, and pip does not bring, is installed with it."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
LANDER = 'import gymnasium as gym\nenv = gym.make("LunarLander-v3")\n'


def guessed(tree: Tree, code: str, **files: str) -> set[str]:
    python = tree({"train.py": code, "README.md": "# Net\nRun `python train.py`.\n", **files}).python
    return {each.written for each in python.pip_guessed}


@pytest.mark.parametrize(
    ("code", "needs"),
    [
        ("import torch\nfrom torch_geometric.nn import voxel_grid, knn_graph\n", "torch-cluster"),
        ("import torch\nfrom torch_geometric.nn import (\n    GCNConv,\n    XConv,\n)\n", "torch-cluster"),
        ("import torch_geometric.nn as gnn\nedges = gnn.radius_graph(x, 2)\n", "torch-cluster"),
        ("import torch_geometric.transforms as T\nt = T.Compose([T.KNNGraph(k=6)])\n", "torch-cluster"),
        ("from stable_baselines3 import PPO\nPPO('MlpPolicy', e, tensorboard_log='logs')\n", "tensorboard"),
        ("from stable_baselines3 import PPO\nPPO().learn(9, progress_bar=True)\n", "rich"),
        ("from stable_baselines3 import PPO\nPPO().learn(9, progress_bar=True)\n", "tqdm"),
        ("import torch\nfrom torch.utils.tensorboard import SummaryWriter\n", "tensorboard"),
        ("import torch\nfrom torch.utils.cpp_extension import load as compiled\n", "ninja"),
        ("import torch\nfrom torch.utils.cpp_extension import (\n    CUDA_HOME,\n    load_inline,\n)\n", "ninja"),
        ("import torch.utils.cpp_extension\ntorch.utils.cpp_extension.load('a', ['a.cpp'])\n", "ninja"),
        ("from torch.utils import cpp_extension as cpp\ncpp.load_inline('a', 'int a;')\n", "ninja"),
        ("import mujoco\nfrom mujoco import mjx\n", "mujoco-mjx"),
        ("import mujoco.mjx as mjx\n", "mujoco-mjx"),
        (LANDER, "gymnasium[box2d]"),
        (LANDER.replace("env =", '# gym.make("LunarLander-v3")\nenv ='), "gymnasium[box2d]"),
        (LANDER.replace("env =", "colour = '#fff'; env ="), "gymnasium[box2d]"),
        ("import gymnasium as gym\nenv = gym.make('CartPole-v1', render_mode='human')\n", "pygame"),
    ],
)
def test_a_used_function_brings_it(tree: Tree, code: str, needs: str) -> None:
    assert needs in guessed(tree, code)


@pytest.mark.parametrize(
    "code",
    [
        "import mujoco\nfrom mine import mjx\n",
        "import torch_geometric\n# knn_graph\n",
        "import torch_geometric\ndef knn_graph(x):\n    return x\nknn_graph(1)\n",
        "from torch_geometric.data import Data\nclass XConv:\n    pass\n",
        '"""It replaces radius_graph of old code."""\nimport torch_geometric\n',
        LANDER.replace("env =", 'a = "b"  # env ='),
        "import torch\nfrom mine import knn_graph\n",
        "from stable_baselines3 import PPO\nPPO('MlpPolicy', e, tensorboard_log=None)\n",
        "from stable_baselines3 import PPO\nPPO().learn(9, progress_bar=False)\n",
        "import gymnasium as gym\nenv = gym.make('CartPole-v1')\n",
        "import gymnasium as gym\nname = 'LunarLander'\n",
        "import torch\nfrom torch.utils.cpp_extension import BuildExtension\ndef load():\n    return 1\n",
        "import torch\nfrom torch.utils import cpp_extension as cpp\nother.load('a')\n",
    ],
)
def test_what_does_not_use_it_brings_none(tree: Tree, code: str) -> None:
    assert not guessed(tree, code) & {
        "torch-cluster",
        "tensorboard",
        "rich",
        "tqdm",
        "gymnasium[box2d]",
        "pygame",
        "mujoco-mjx",
        "ninja",
    }


def test_what_compiles_while_it_runs_has_a_compiler(tree: Tree) -> None:
    code = "import torch\nfrom torch.utils.cpp_extension import load\nload('a', ['a.cpp'])\n"
    files = {"train.py": code, "README.md": "# Net\nRun `python train.py`.\n", "requirements.txt": "torch==2.1.0\n"}
    decision = tree(files)
    assert {each.written for each in decision.python.pip_guessed} == {"ninja"}
    assert decision.compiling.compiler
    assert not tree({**files, "train.py": "import torch\n"}).compiling.compiler


def test_beside_a_list_of_packages(tree: Tree) -> None:
    assert "gymnasium[box2d]" in guessed(tree, LANDER, **{"requirements.txt": "gymnasium==1.0.0\n"})
    named = guessed(
        tree,
        "from stable_baselines3 import PPO\nPPO(tensorboard_log='a')\n",
        **{"requirements.txt": "stable-baselines3\ntensorboard==2.14\n"},
    )
    assert not named


@pytest.mark.parametrize(
    ("line", "asked"),
    [
        ("gymnasium==0.29.1", True),
        ("gymnasium[box2d]==0.29.1", False),
        ("gymnasium[all]==0.29.1", False),
        ("gymnasium[mujoco]==0.29.1", True),
    ],
)
def test_box2d_is_asked_for_once_and_compiled(tree: Tree, line: str, *, asked: bool) -> None:
    decision = tree({"train.py": LANDER, "requirements.txt": f"{line}\n", "README.md": "Run `python train.py`.\n"})
    assert ("gymnasium[box2d]" in {each.written for each in decision.python.pip_guessed}) == asked
    assert decision.compiling.compiler


def test_a_turtle_needs_tk(tree: Tree) -> None:
    page = "# Net\n## Requirements\n- Ubuntu 22.04\n- Python 3.10\n"
    decision = tree({"watch.py": "from turtle import done\nimport numpy\ndone()\n", "README.md": page})
    assert decision.base_image == "ubuntu:22.04"
    assert "python3-tk" in {*decision.apt, *decision.apt_guessed}


def test_descartes_keeps_the_shapely_of_its_time(tree: Tree) -> None:
    page = "# Net\n```\npip install shapely descartes\n```\n"
    python = tree({"README.md": page, "draw.py": "import descartes, shapely\n"}).python
    assert "shapely<2" in {each.written for each in python.pip_guessed}
