"""No token reaches anything that a run leaves: random values are planted for the run, and searched for in all of it."""

from __future__ import annotations

import gzip
import io
import json
import subprocess
import tarfile
import zipfile
from base64 import b64encode
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import quote

import pytest

from lab import canary, doors, leavings, registry
from lab.act import Result, run_workflow
from lab.canary import Place
from lab.faulty_registry import Faults, faulty_registry
from lab.laboratory import Laboratory
from lab.private_server import PACKAGE, private_server

USER = "canary"
NAMES = ("GITHUB_TOKEN", "TOKEN", "GIT_AUTH_TOKEN", "REGISTRY_PASSWORD", "DEPLOY_KEY", "RUNNER_KEY")
"""What a door might hand to a build, as an argument or as a secret; the recipe below takes all of it into a layer."""
ARGUMENTS = "".join(f"ARG {name}\n" for name in NAMES)
MOUNTS = " ".join(f"--mount=type=secret,id={name}" for name in (*NAMES, "GIT_AUTH_TOKEN.github.com"))
RECIPE = rf"""
FROM ubuntu:24.04
{ARGUMENTS}COPY . /source
RUN {MOUNTS} SEEN=@ env > /environment; tail -n +1 /run/secrets/* > /secrets; \
  uname -m > /machine && cat /environment /secrets
CMD ["cat", "/machine"]
"""
CHECKOUT_5 = """\
git config http.https://github.com/.extraheader \\
  "AUTHORIZATION: basic $(printf x-access-token:%s "$RUN_TOKEN" | base64 --wrap=0)"
"""
"""What actions/checkout up to version 5 leaves in the repository, where its job does not forbid it."""
LEAK = """\
FROM ubuntu:24.04
ARG LEAKED=@
ENV SHOWN=$LEAKED
COPY . /source
RUN printf %s "$LEAKED" | base64 --wrap=0 > /base64 && echo "$LEAKED" && uname -m > /machine
RUN printf %s "$LEAKED" | sed 's/%/%25/g; s/+/%2B/g; s,/,%2F,g; s/=/%3D/g' > /percent && touch "/named-$(cat /percent)"
"""
"""What an author must not do: his secret becomes an argument, and is written down in every form."""
SCANNER = "docker/buildkit-syft-scanner:stable-1"
STAND_IN = r"""
FROM ubuntu:24.04
COPY --chmod=755 scan.sh /scan.sh
ENTRYPOINT ["/scan.sh"]
"""
SCAN = r"""#!/bin/sh
# A stand-in for BuildKit's scanner: lists the name of every file, and what the scanner itself was told.
set -eu
files=$(cd "$BUILDKIT_SCAN_SOURCE" && find . -xdev -type f | tr -d '\\"' | sed 's/.*/{"fileName":"&"},/')
told=$(env | tr -d '\\"' | tr '\n' ' ')
printf '{"_type":"https://in-toto.io/Statement/v0.1","predicateType":"https://spdx.dev/Document","predicate":
{"spdxVersion":"SPDX-2.3","SPDXID":"SPDXRef-DOCUMENT","name":"stand-in","comment":"%s","files":[%s{"fileName":""}]}}' \
  "$told" "$files" > "$BUILDKIT_SCAN_DESTINATION/stand-in.spdx.json"
"""


@pytest.fixture(scope="module")
def scanner(lab: Laboratory, tmp_path_factory: pytest.TempPathFactory) -> None:
    """Make sure that the mirror of docker.io has the scanner that writes the bill of materials, or its stand-in."""
    repository, _, tag = SCANNER.partition(":")
    if not lab.standins or tag in registry.tags(repository, name=registry.MIRROR):
        return
    context = doors.write(tmp_path_factory.mktemp("scanner"), {"Dockerfile": STAND_IN, "scan.sh": SCAN})
    command = ["docker", "buildx", "build", "--builder", "default", "--provenance=false", "--push"]
    command += ["--platform", "linux/amd64,linux/arm64", "--tag", f"{lab.mirror}/{SCANNER}", str(context)]
    subprocess.run(command, env=dict(lab.environment), check=True, capture_output=True)


@dataclass(frozen=True, kw_only=True, slots=True)
class Planted:
    """A run with values that must be nowhere, and everything that it left."""

    ran: Result
    canaries: Mapping[str, str]
    places: tuple[Place, ...]

    def findings(self, seen: str = "") -> tuple[list[canary.Finding], list[canary.Finding]]:
        """Search once, and return where a harmless value stands, and where anything that was planted does."""
        found = canary.find(self.places, {**self.canaries, **({"SEEN": seen} if seen else {})})
        shown = [finding for finding in found if finding.canary == "SEEN"]
        return shown, [finding for finding in found if finding not in shown]

    def kinds(self) -> set[str]:
        """Return what was looked into."""
        return {kind for place, _ in self.places for kind in kinds_of(place)}


KINDS = (
    "log", "summary", "output", "artifact", "tag", "configuration", "layer", "cached configuration", "cached layer",
    "provenance", "bill of materials", "docker history", "docker image", "record", "log of record", "export of record",
)  # fmt: skip
BUILT = {
    "log", "configuration", "layer", "cached layer", "provenance", "docker history",
    "log of record", "export of record",
}  # fmt: skip
"""Where a word of the Dockerfile, and what a step prints and writes, comes to stand."""


def kinds_of(place: str) -> set[str]:
    """Return the kinds of a place: a layer may be the image's and the cache's at once."""
    parts = place.split(", ")
    known = ([kind for kind in KINDS if part == kind or part.startswith(f"{kind} ")] for part in parts)
    return {max(kinds, key=len) for kinds in known if kinds}


def through_action(
    folder: Path, given: Mapping[str, str], files: Mapping[str, str], *, before: str = CHECKOUT_5
) -> Path:
    """Write a repository whose job holds a secret in its environment, and keeps the action's own folder."""
    workflow = f"""
on: push
jobs:
  image:
    runs-on: ubuntu-24.04
    env:
      DEPLOY_KEY: ${{{{ secrets.DEPLOY_KEY }}}}
    steps:
      - uses: {doors.CHECKOUT}
      - run: {json.dumps(before)}
        env:
          RUN_TOKEN: ${{{{ github.token }}}}
      - uses: org/repro-action@v1
        with:
          token: ${{{{ secrets.REGISTRY_PASSWORD }}}}
{doors.settings(given)}
      - run: mkdir -p "$REPRO_LAB_ARTIFACTS" && cp -R "$RUNNER_TEMP"/roslab-*/ "$REPRO_LAB_ARTIFACTS"
"""
    return doors.write(folder, {**doors.FILES, **files, ".github/workflows/caller.yml": workflow})


def plant(
    lab: Laboratory,
    caller: Path,
    place: Path,
    repository: str,
    canaries: Mapping[str, str],
    *,
    secrets: Mapping[str, str] | None = None,
) -> Planted:
    """Push with the planted values and gather everything that is left; ``secrets`` are more that hold a value."""
    names = ("GITHUB_TOKEN", "REGISTRY_PASSWORD", "DEPLOY_KEY")
    environment = {**doors.builder(lab), "ROSLAB_SBOM": SCANNER, "RUNNER_KEY": canaries["RUNNER_KEY"]}
    with registry.account(USER, canaries["REGISTRY_PASSWORD"]):
        ran = run_workflow(
            lab, caller, "push", doors.payload(repository.partition("/")[2]), env=environment,
            secrets={**{name: canaries[name] for name in names}, **(secrets or {})}, place=place, unmasked=True,
        )  # fmt: skip
        assert ran.exit_code == 0, ran.log
        image = f"{lab.registry}/{repository}:main"
        places = (
            *leavings.said(ran), *leavings.kept(place), *leavings.stored(repository),
            *leavings.pulled(lab, image, USER, canaries["REGISTRY_PASSWORD"]), *leavings.recorded(lab, repository),
        )  # fmt: skip
    return Planted(ran=ran, canaries=canaries, places=places)


@pytest.fixture
def canaries() -> dict[str, str]:
    """Return a value for each: the run's own token, the registry's password, a job's secret, the runner's own."""
    return {name: canary.value() for name in ("GITHUB_TOKEN", "REGISTRY_PASSWORD", "DEPLOY_KEY", "RUNNER_KEY")}


@pytest.fixture
def repository(lab: Laboratory, scanner: None) -> str:
    """Return the name of a repository that nothing was pushed to yet: OWNER/NAME."""
    return lab.fresh_repository(f"{doors.OWNER}/canary").partition("/")[2]


@pytest.mark.parametrize("door", [through_action, doors.through_workflow], ids=["action", "image"])
def test_no_token_is_left_anywhere(
    lab: Laboratory, tmp_path: Path, repository: str, canaries: dict[str, str], door: type
) -> None:
    given = {"registry": lab.registry, "username": USER, "cache": "registry"}
    seen = canary.value()  # harmless, and new in each run, so that no step comes from a cache
    caller = door(tmp_path / "caller", given, {"Dockerfile": RECIPE.replace("@", seen)})
    left = plant(lab, caller, tmp_path / "run", repository, canaries)
    # Nothing was overlooked: there is something of every kind, and what the build saw is found
    assert left.kinds() == set(KINDS)
    shown, leaked = left.findings(seen)
    assert {kind for finding in shown for kind in kinds_of(finding.place)} >= BUILT
    assert leaked == []
    if door is through_action:
        assert "left a token in .git" in left.ran.log


PRIVATE = """\
format: 3
name: robot
kind: python
base: {{image: "{base}/lab/python:3.12-slim"}}
secrets: [pip_index, netrc, ssh, map_key]
pip: [{package}, "sister @ git+{repository}@v1"]
custom:
  - echo {seen} | tee /seen
  - test -s /run/secrets/map_key && test -s ~/.netrc && ssh-add -l
  - python3 -c "import {module}, sister"
test: cat /seen
"""
HANDED = """\
pip_index=${{{{ secrets.PIP_INDEX }}}}
netrc=${{{{ secrets.NETRC }}}}
ssh=${{{{ secrets.SSH_KEY }}}}
map_key=${{{{ secrets.MAP_KEY }}}}
registry:{base}=reader:${{{{ secrets.BASE_PASSWORD }}}}
"""


@pytest.mark.parametrize("door", [through_action, doors.through_workflow], ids=["action", "image"])
def test_no_secret_of_a_build_is_left_anywhere(
    lab: Laboratory, tmp_path: Path, repository: str, canaries: dict[str, str], door: Callable[..., Path]
) -> None:
    """A generated Dockerfile with a secret of every kind, each of which a step used; a base image behind a login."""
    subprocess.run(
        ["docker", "buildx", "imagetools", "create", "--tag", f"{lab.registry}/lab/python:3.12-slim",
         f"{lab.mirror}/library/python:3.12-slim"], env=dict(lab.environment), check=True, capture_output=True,
    )  # fmt: skip
    key = tmp_path / "key"
    subprocess.run(["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-C", "", "-f", str(key)], check=True)
    canaries |= {name: canary.value() for name in ("SERVER_PASSWORD", "MAP_KEY", "BASE_PASSWORD")}
    canaries["SSH_KEY"] = key.read_text().splitlines()[2]
    seen = canary.value().replace("%", "")  # harmless, and new in each run
    with (
        private_server(tmp_path / "server", canaries["SERVER_PASSWORD"]) as server,
        faulty_registry(lab.registry, Faults(matches=lambda *_: False, times=0)) as base,
        registry.account("reader", canaries["BASE_PASSWORD"]),
    ):
        config = PRIVATE.format(
            base=base, package=server.package, module=PACKAGE, repository=server.repository, seen=seen
        )
        given = {"registry": lab.registry, "username": USER, "image": repository}
        given |= {"cache": "registry", "platforms": "linux/amd64"}
        handed = HANDED.format(base=base)
        caller = door(
            tmp_path / "caller",
            {**given, **({"secrets": handed} if door is through_action else {})},
            {"roslab.yaml": config, "main.py": "print('hello')\n", "Dockerfile": "# none\n"},
        )
        if door is not through_action:
            file = caller / ".github/workflows/caller.yml"
            line = f"    secrets:\n      build-secrets: {json.dumps(handed)}\n"
            file.write_text(file.read_text().replace("    secrets:\n", line))
        secrets = {
            "PIP_INDEX": server.index,
            "NETRC": server.netrc,
            "SSH_KEY": key.read_text(),
            "MAP_KEY": canaries["MAP_KEY"],
            "BASE_PASSWORD": canaries["BASE_PASSWORD"],
        }
        left = plant(lab, caller, tmp_path / "run", repository, canaries, secrets=secrets)
    shown, leaked = left.findings(seen)
    assert {kind for finding in shown for kind in kinds_of(finding.place)} >= BUILT
    assert leaked == []


def test_the_search_finds_what_an_author_leaks(
    lab: Laboratory, tmp_path: Path, repository: str, canaries: dict[str, str]
) -> None:
    """The same search, of a repository whose workflow writes its secret into the recipe and shows it in the test."""
    given = {"registry": lab.registry, "username": USER, "cache": "registry", "test": "cat /base64 /percent; ls /"}
    before = 'sed -i "s|@|$DEPLOY_KEY|" Dockerfile'
    caller = through_action(tmp_path / "caller", given, {"Dockerfile": LEAK}, before=before)
    _, found = plant(lab, caller, tmp_path / "run", repository, canaries).findings()
    assert {finding.canary for finding in found} == {"DEPLOY_KEY"}
    assert {finding.form for finding in found} == {"plain", "base64", "percent"}
    leaked = {kind for finding in found for kind in kinds_of(finding.place)}
    assert leaked >= BUILT | {"summary", "artifact", "bill of materials", "docker image"}


def test_every_form_is_found() -> None:
    secret = canary.value()
    texts = {
        "plain": {secret, f"x{secret}y"},
        "percent": {quote(secret, safe=""), f"https://u:{quote(secret, safe='')}@host", quote(secret, safe="").lower()},
        "base64": {b64encode(f"{'u' * n}:{secret}{'.' * m}".encode()).decode() for n in range(4) for m in range(4)},
    }
    for form, shown in texts.items():
        for text in shown:
            assert form in {f.form for f in canary.find([("here", text.encode())], {"it": secret})}, text
    assert not canary.find([("here", secret[:-3].encode())], {"it": secret})


def test_archives_are_opened() -> None:
    secret = canary.value()
    zipped, tarred = io.BytesIO(), io.BytesIO()
    with zipfile.ZipFile(zipped, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("report", secret)
    with tarfile.open(fileobj=tarred, mode="w") as tar:
        for name, data in (("inner.zip", zipped.getvalue()), ("doc.gz", gzip.compress(secret.encode()))):
            entry = tarfile.TarInfo(name)
            entry.size = len(data)
            tar.addfile(entry, io.BytesIO(data))
    found = canary.find([("layer", gzip.compress(tarred.getvalue()))], {"it": secret})
    assert {finding.place for finding in found} == {"layer: inner.zip: report", "layer: doc.gz"}
    with pytest.raises(ValueError, match="zstd"):
        canary.find([("layer", b"\x28\xb5\x2f\xfd")], {"it": secret})
