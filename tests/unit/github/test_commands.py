"""``roslab github STEP``: each step is a process of its own, which imports what it needs."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from roslab.github.commands import STEPS, function

SCRIPTS = Path(__file__).parents[3] / "scripts"


@pytest.mark.parametrize("step", STEPS)
def test_a_step_is_a_function_of_its_module(step: str) -> None:
    assert callable(function(step))


@pytest.mark.parametrize("step", ["ready", "dockerfile", "prove", "index", "tag", "summary", "explain"])
def test_a_step_that_reads_a_plan_imports_nothing_that_makes_one(step: str) -> None:
    code = (
        f"import json, sys\nsys.path.insert(0, {str(SCRIPTS)!r})\n"
        f"from roslab.github.commands import function\nfunction({step!r})\nprint(json.dumps(list(sys.modules)))"
    )
    answer = subprocess.run([sys.executable, "-I", "-c", code], capture_output=True, text=True, check=True)
    assert not {"roslab.decide.deciding", "roslab.evidence.gather"}.intersection(json.loads(answer.stdout))
