"""How many builds that are broken on purpose ``roslab explain`` explains rightly.

``python -m benchmarks.broken`` builds every Dockerfile of ``broken.toml`` in the lab (``python3 tests/lab up``), one
after the other, and prints those whose log is explained by another cause than the expected one. Names of cases as
arguments build these alone; ``--keep FOLDER`` keeps the logs. Ends with code 1 where fewer are right than the goal.
"""

from __future__ import annotations

import argparse
import io
import subprocess
import sys
import tempfile
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from lab.laboratory import current
from roslab.explain.answer import explain

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

RIGHT = 0.95
"""Share of the builds that must be explained rightly."""
HERE = Path(__file__).resolve().parent
RECIPE = HERE.parent / "tests" / "lab" / "repair"
BASES = {
    "native": ("repro-lab/repair:native", "ros:noetic-ros-base"),
    "python": ("repro-lab/repair:python", "python:3.11"),
}


def built(case: Mapping[str, Any], environment: Mapping[str, str]) -> bytes:
    """Build one broken case; return its log."""
    base = BASES[case["base"]][0] if case["base"] in BASES else case["base"]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for path, text in case.get("files", {}).items():
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / path).write_bytes(text.encode())
        recipe = folder.with_name(f"{folder.name}.Dockerfile")
        recipe.write_text(f"FROM {base}\n{case['steps']}\n", encoding="utf-8")
        command = ["docker", "buildx", "build", "--progress", "plain", "--no-cache", "--file", str(recipe), name]
        try:
            done = subprocess.run(
                command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=900, check=False
            )
        finally:
            recipe.unlink()
    if done.returncode == 0:
        raise SystemExit(f"this build did not fail: {case['steps']}")
    return done.stdout


def main() -> int:
    """Build, explain and count."""
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("names", nargs="*", metavar="CASE")
    options.add_argument("--keep", type=Path, metavar="FOLDER")
    given = options.parse_args()
    environment = current().environment
    for name, base in BASES.values():
        make = ["docker", "build", "--quiet", "--tag", name, "--build-arg", f"BASE={base}", str(RECIPE)]
        subprocess.run(make, env=environment, check=True, capture_output=True)
    cases = tomllib.loads((HERE / "broken.toml").read_text(encoding="utf-8"))
    wanted = {name: case for name, case in cases.items() if name in (given.names or cases)}
    right, begun = 0, time.monotonic()
    for name, case in wanted.items():
        log = built(case, environment)
        if given.keep:
            given.keep.mkdir(parents=True, exist_ok=True)
            (given.keep / f"{name}.log").write_bytes(log)
        found = [one.id or "" for one in explain(io.BytesIO(log)).explanations]
        right += found == [case["cause"]]
        if found != [case["cause"]]:
            print(f"{name}: {', '.join(found) or 'nothing'}, expected {case['cause'] or 'no known cause'}", flush=True)
    share = right / len(wanted)
    print(
        f"{right} of {len(wanted)} explained rightly ({share:.0%}; goal {RIGHT:.0%}), {time.monotonic() - begun:.0f} s"
    )
    return 0 if share >= RIGHT else 1


if __name__ == "__main__":
    sys.exit(main())
