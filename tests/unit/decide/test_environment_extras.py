"""Games of Atari need an extra of the package that has them."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision
from roslab.decide.python.environment_extras import for_environments
from roslab.evidence.facts import Evidence, Mention
from roslab.values.requirement_line import stated

Tree = Callable[[dict[str, str]], Decision]
MADE = Mention(topic="environment", value="atari", source="code", file="a.py", line=2, text="PongNoFrameskip-v4")


def extras(line: str, day: str | None = None) -> list[str]:
    evidence = Evidence(mentions=(MADE,), pip_day=day)
    return [each.written for each in for_environments(evidence, [stated(line)], frozenset())]


@pytest.mark.parametrize(
    ("line", "day", "more"),
    [
        ("gym", "2018-11-22", ["gym[atari]", "atari-py"]),
        ("gym==0.17.3", None, ["gym[atari]==0.17.3", "atari-py"]),
        ("gym", None, ["gym[atari,accept-rom-license]"]),
        ("gymnasium", "2023-08-01", ["gymnasium[atari,accept-rom-license]"]),
        ("gymnasium", None, ["gymnasium[atari]"]),
        ("gym[mujoco]", None, []),
        ("gym @ git+https://host.test/gym", None, []),
        ("numpy", None, []),
    ],
)
def test_the_release_says_which(line: str, day: str | None, more: list[str]) -> None:
    assert extras(line, day) == more


@pytest.mark.parametrize(
    ("code", "atari"),
    [
        ("env = gym.make('PongNoFrameskip-v4')\n", True),
        ("env = gym.make('BreakoutDeterministic-v4')\n", True),
        ("env = gym.make('ALE/Pong-v5')\n", True),
        ("from stable_baselines.common.atari_wrappers import make_atari\n", True),
        ("from gym.wrappers import AtariPreprocessing\n", True),
        ("# as PongNoFrameskip-v4\nenv = gym.make('Pendulum-v1')\n", False),
        ("env = gym.make('CartPole-v1')\nscale = 1\n", False),
    ],
)
def test_the_code_says_whether(tree: Tree, code: str, atari: bool) -> None:
    guessed = [each.written for each in tree({"train.py": f"import gym\n{code}"}).python.pip_guessed]
    assert "gym" in guessed
    assert ("gym[atari,accept-rom-license]" in guessed) is atari


def test_what_is_declared_is_the_authors(tree: Tree) -> None:
    files = {"train.py": "import gym\nenv = gym.make('PongNoFrameskip-v4')\n", "requirements.txt": "gym==0.17.3\n"}
    assert not [each for each in tree(files).python.pip_guessed if each.key == "gym"]
