"""The whole chain, once, for real: an example through the action under act, into a registry, run by its digest."""

from __future__ import annotations

import argparse
import json
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from lab import laboratory, registry
from lab.act import run_workflow
from lab.command import LabError

ROOT = Path(__file__).resolve().parent.parent
PLATFORMS = ("linux/amd64", "linux/arm64")
CHECKOUT = "actions/checkout@3d3c42e5aac5ba805825da76410c181273ba90b1"
WORKFLOW = f"""\
name: image
on: push
jobs:
  image:
    runs-on: ubuntu-24.04
    permissions:
      contents: read
      packages: write
    steps:
      - uses: {CHECKOUT} # v7.0.1
        with:
          persist-credentials: false
      - uses: org/repro-action@v1
        with:
          registry: THE-HOST
          username: THE-USER
          token: ${{{{ secrets.REGISTRY_PASSWORD }}}}
          platforms: {",".join(PLATFORMS)}
"""


def main() -> int:
    """Run the demonstration; return 0 only where an image of both platforms was published, and ran by its digest."""
    examples = sorted(path.name for path in (ROOT / "examples").iterdir())
    parser = argparse.ArgumentParser(prog="bash tests/demo", description=__doc__)
    parser.add_argument("example", nargs="?", default="python_filter", choices=examples, help="default: python_filter")
    options = parser.parse_args()
    start = time.monotonic()
    try:
        laboratory.up(bases=bases(ROOT / "examples" / options.example))
        lab = laboratory.current()
        say(f"examples/{options.example} is pushed by a stranger who wrote one workflow")
        reference, tags = publish(lab, options.example)
        for platform in PLATFORMS:
            run(lab, reference, platform)
    except LabError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    say(f"done in {time.monotonic() - start:.0f} s: {reference}")
    print("tags: " + " ".join(tags))
    if lab.standins:
        print("No container registry is in reach: the base images were stand-ins made from Debian's packages,")
        print("and so were the Docker actions unless REPRO_LAB_ACTIONS names a folder of the real ones.")
    print("`python3 tests/lab down` ends the engine and the registry.")
    return 0


def bases(example: Path) -> tuple[str, ...]:
    """Return the base images of an example's image: of its generated Dockerfile, or of its author's."""
    roslab: list[str | Path] = [sys.executable, "-I", ROOT / "scripts"]
    with tempfile.TemporaryDirectory(prefix="repro-demo-") as folder:
        text = subprocess.run([*roslab, "inspect", example, "--format", "json"], check=True, capture_output=True).stdout
        own = json.loads(text)["dockerfile"]
        if own is None:
            command = [*roslab, "create", example, "--output", folder]
            subprocess.run(command, check=True, capture_output=True)
        written = (example / own if own else Path(folder, "Dockerfile")).read_text(encoding="utf-8")
    lines = re.findall(r"^FROM +(?:--\S+ +)*(\S+)(?: +AS +(\S+))?", written, re.MULTILINE | re.IGNORECASE)
    stages = {"scratch", *(stage for _, stage in lines)}
    return tuple(dict.fromkeys(base for base, _ in lines if base not in stages))


def publish(lab: laboratory.Laboratory, example: str) -> tuple[str, tuple[str, ...]]:
    """Run the action for a push; return the image by its digest and its tags."""
    name = lab.fresh_repository(f"demo/{example}").partition("/")[2]
    with tempfile.TemporaryDirectory(prefix="repro-demo-") as folder:
        caller = Path(folder) / "caller"
        shutil.copytree(ROOT / "examples" / example, caller)
        workflow = caller / ".github" / "workflows" / "image.yml"
        workflow.parent.mkdir(parents=True)
        text = WORKFLOW.replace("THE-HOST", lab.registry).replace("THE-USER", lab.username)
        workflow.write_text(text, encoding="utf-8")
        payload = {"ref": "refs/heads/main", "repository": {"full_name": name, "default_branch": "main"}}
        result = run_workflow(lab, caller, "push", payload, tell=tell, timeout=3600)
    if result.exit_code:
        raise LabError("the workflow failed; its log stands above")
    image, digest = result.output("image"), result.output("digest")
    index, _ = registry.manifest(f"{image}@{digest}".removeprefix(f"{lab.registry}/"))
    found = {f"{m['platform']['os']}/{m['platform']['architecture']}" for m in index["manifests"]}
    say(f"{image}@{digest} is an index of {', '.join(sorted(found & set(PLATFORMS)))}")
    if missing := set(PLATFORMS) - found:
        raise LabError(f"the index lacks {', '.join(sorted(missing))}")
    return f"{image}@{digest}", registry.tags(image.removeprefix(f"{lab.registry}/"))


def run(lab: laboratory.Laboratory, reference: str, platform: str) -> None:
    """Run the image by its digest on one platform, its own output as it comes."""
    say(f"docker run --rm --platform {platform} {reference}")
    command = ["docker", "run", "--rm", "--init", "--quiet", "--platform", platform, reference]
    # The machine's own emulation starts a program some seconds later; a talker has no end of its own
    code = subprocess.run(["timeout", "60", *command], env=dict(lab.environment), check=False).returncode
    if code not in {0, 124}:
        raise LabError(f"the image ended with exit code {code} on {platform}")


def tell(line: str) -> None:
    """Print a line of act's, without its own bookkeeping."""
    if not line.startswith(("LocalRepositoryCache", "  ✅  Success - Pre", "⭐ Run Pre")):
        print(line, flush=True)


def say(text: str) -> None:
    """Print a step of the demonstration."""
    print(f"\n=== {text}", flush=True)


if __name__ == "__main__":
    sys.exit(main())
