"""Run `docker buildx build` for the inputs of docker/build-push-action, which this stands in for.

Source: https://github.com/docker/build-push-action README and src/context.ts, v7.3.0; read 2026-11-21. A list input is
lines; platforms, tags, allow and the like may be separated by commas too. With `push`, an output of type image or
registry pushes; without `outputs`, --push does. Without `provenance`, a public repository's build gets all of it, a
private one's the least.
"""

from __future__ import annotations

import csv
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path

# Input -> option of buildx; the input's lines are one value each ("lines"), or words between commas too ("words").
OPTIONS = (
    ("add-hosts", "--add-host", "words"),
    ("allow", "--allow", "words"),
    ("annotations", "--annotation", "lines"),
    ("attests", "--attest", "lines"),
    ("build-args", "--build-arg", "lines"),
    ("build-contexts", "--build-context", "lines"),
    ("builder", "--builder", "one"),
    ("cache-from", "--cache-from", "lines"),
    ("cache-to", "--cache-to", "lines"),
    ("call", "--call", "one"),
    ("file", "--file", "one"),
    ("labels", "--label", "lines"),
    ("load", "--load", "flag"),
    ("network", "--network", "one"),
    ("no-cache", "--no-cache", "flag"),
    ("no-cache-filters", "--no-cache-filter", "words"),
    ("outputs", "--output", "lines"),
    ("platforms", "--platform", "joined"),
    ("provenance", "--provenance", "one"),
    ("pull", "--pull", "flag"),
    ("push", "--push", "flag"),
    ("sbom", "--sbom", "one"),
    ("secret-files", "--secret", "files"),
    ("secret-envs", "--secret", "environment"),
    ("shm-size", "--shm-size", "one"),
    ("ssh", "--ssh", "lines"),
    ("tags", "--tag", "words"),
    ("target", "--target", "one"),
    ("ulimit", "--ulimit", "words"),
)


def command(inputs: Mapping[str, str], secrets: Path) -> list[str]:
    """Return the command line; the content of `secrets` goes into files of this folder, not onto the command line."""
    words = ["docker", "buildx", "build", "--progress", "plain"]
    for name, option, kind in OPTIONS:
        value = inputs.get(name, "").strip()
        if not value or (kind == "flag" and value != "true"):
            continue
        lines = [line.strip() for line in value.splitlines() if line.strip()]
        split = [word.strip() for line in lines for word in line.split(",") if word.strip()]
        if kind == "flag":
            words.append(option)
        elif kind == "one":
            words += [option, value]
        elif kind == "joined":
            words += [option, ",".join(split)]
        elif kind in {"files", "environment"}:
            source = "src" if kind == "files" else "env"
            words += [w for line in lines for w in (option, "id={0},{2}={1}".format(*line.split("=", 1), source))]
        else:
            words += [word for item in (split if kind == "words" else lines) for word in (option, item)]
    for line in inputs.get("secrets", "").splitlines():
        if line.strip():
            key, _, content = next(csv.reader([line.strip()]))[0].partition("=")
            (secrets / key).write_text(content)
            words += ["--secret", f"id={key},src={secrets / key}"]
    return words


def provenance(event: Path) -> str:
    """Return the provenance of a build that asks for none."""
    payload = json.loads(event.read_text(encoding="utf-8")) if event.is_file() else {}
    return "mode=min,inline-only=true" if payload.get("repository", {}).get("private") else "mode=max"


def main(environment: Mapping[str, str]) -> int:
    """Build, write the outputs, return buildx's exit code."""
    inputs = {key: str(value) for key, value in json.loads(environment["BUILD_INPUTS"]).items()}
    if inputs.get("load") != "true" and "type=docker" not in inputs.get("outputs", ""):
        inputs["provenance"] = inputs.get("provenance") or provenance(Path(environment.get("GITHUB_EVENT_PATH", "")))
    with tempfile.TemporaryDirectory() as name:
        metadata, identity = Path(name) / "metadata.json", Path(name) / "id"
        words = [*command(inputs, Path(name)), "--metadata-file", str(metadata), "--iidfile", str(identity)]
        words.append(inputs.get("context") or ".")
        print("::group::Build", *words, "::endgroup::", sep="\n", flush=True)
        code = subprocess.run(words, check=False).returncode
        if code:
            print("::error::buildx failed with exit code", code)
            return code
        said = json.loads(metadata.read_text()) if metadata.exists() else {}
        outputs = {
            "imageid": identity.read_text().strip() if identity.exists() else "",
            "digest": said.get("containerimage.digest", ""),
            "metadata": json.dumps(said),
        }
        with Path(environment["GITHUB_OUTPUT"]).open("a", encoding="utf-8") as handle:
            handle.writelines(f"{key}<<end-of-{key}\n{value}\nend-of-{key}\n" for key, value in outputs.items())
    return 0


if __name__ == "__main__":
    sys.exit(main(os.environ))
