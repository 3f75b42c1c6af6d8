"""A library that is only looked for: where it is not there, the image is built without it."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Callable
from pathlib import Path

from roslab.config.model import Source
from roslab.plan.plan import Plan
from roslab.render.layers.system import library_stages


def test_where_it_cannot_be_cloned_the_step_tells_it_and_goes_on(plan: Callable[..., Plan], tmp_path: Path) -> None:
    repo = "https://github.com/lab/acmesim.git"
    source = Source(name="acmesim", repo=repo, unread=True, unasked=True, holding=("acmesim",))
    step = re.search(r"^RUN (\{ \( mkdir(?:.*\\\n)*.*)$", library_stages(plan(libraries=(source,))), re.MULTILINE)
    assert step is not None
    (tmp_path / "git").write_text("#!/bin/bash\nexit 128\n")
    (tmp_path / "git").chmod(0o755)
    script = step[1].replace("/tmp/sources", f"{tmp_path}/sources").replace("/installed", f"{tmp_path}/installed")
    environment = {"PATH": f"{tmp_path}:/usr/bin:/bin"}
    done = subprocess.run(
        ["bash", "-euo", "pipefail", "-c", script],
        env=environment,
        capture_output=True,
        text=True,
        timeout=60,
        check=True,
    )
    assert done.stdout == f"roslab: left out: acmesim was looked for in {repo}, and cannot be cloned or built\n"
