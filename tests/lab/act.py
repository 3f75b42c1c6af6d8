"""Run a workflow with act: on this machine, without GitHub, in an environment that holds only what is named here."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from functools import wraps
from pathlib import Path
from typing import Any, ParamSpec

from . import caller, facts
from .api_stub import api_stub
from .artifact_door import artifact_door
from .home import CHECKOUT, folder, memory
from .laboratory import Laboratory

# What pip, git, docker and certificates need on this machine; everything else of the environment stays outside.
PASSED = (
    "LANG",
    "SSL_CERT_FILE",
    "SSL_CERT_DIR",
    "REQUESTS_CA_BUNDLE",
    "CURL_CA_BUNDLE",
    "NODE_EXTRA_CA_CERTS",
    "GIT_SSL_CAINFO",
    "HTTP_PROXY",
    "HTTPS_PROXY",
    "NO_PROXY",
    "http_proxy",
    "https_proxy",
    "no_proxy",
)

Parameters = ParamSpec("Parameters")
RACE = "fatal error: concurrent map"
"""act 0.2 itself ends so where two jobs look up a local action at once (pkg/runner/local_repository_cache.go)."""
MOST_RUNS = 3

RUN_TOKEN = "the-token-of-the-run"
"""What stands for GITHUB_TOKEN: no registry of the lab takes it."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Result:
    """What came of a run: act's exit code, its log, the result of each job, and what the steps put out.

    `jobs` maps `workflow/job` (of a called workflow `workflow/job/inner`, a matrix job with its number) to "success",
    "failure" or "skipped" as act names them, and is empty, with exit code 0, when nothing answered the event; `outputs`
    maps the same names to every output their steps set.
    """

    exit_code: int
    log: str
    jobs: Mapping[str, str]
    outputs: Mapping[str, Mapping[str, str]]
    summary: str

    def output(self, name: str) -> str:
        """Return the last value that any step gave this output; KeyError when none did."""
        values = [outputs[name] for outputs in self.outputs.values() if name in outputs]
        if not values:
            raise KeyError(name)
        return values[-1]


def unless_raced(run: Callable[Parameters, Result]) -> Callable[Parameters, Result]:
    """Have a run that act's own race ended started again, from nothing; one over a folder that is kept is not."""

    @wraps(run)
    def again(*args: Parameters.args, **kwargs: Parameters.kwargs) -> Result:
        kept = kwargs.get("place") is not None or kwargs.get("artifacts") is not None
        result = run(*args, **kwargs)
        for _ in range(0 if kept else MOST_RUNS - 1):
            if RACE not in result.log:
                break
            result = run(*args, **kwargs)
        return result

    return again


@unless_raced
def run_workflow(
    lab: Laboratory,
    caller_dir: Path,
    event: str,
    event_payload: dict[str, Any] | None = None,
    *,
    jobs: Sequence[str] | None = None,
    workflow: str | None = None,
    env: Mapping[str, str] | None = None,
    secrets: Mapping[str, str] | None = None,
    inputs: Mapping[str, str] | None = None,
    actions_dir: Path | None = None,
    timeout: float = 900,
    tell: Callable[[str], None] | None = None,
    place: Path | None = None,
    unmasked: bool = False,
    artifacts: Path | None = None,
    attempt: int = 1,
    matrix: str | None = None,
    github: Mapping[str, Any] | None = None,
    raw: Callable[[str], None] | None = None,
    subject: str = "Everything",
    staged: Sequence[tuple[str, ...]] = (),
) -> Result:
    """Run the caller's workflows for an event in a throw-away copy and return what came of it.

    `jobs` and `workflow` (a path below the caller) narrow what runs; `env` is added to every step's environment;
    `tell` is given each line as it comes, `raw` the same as act's JSON;
    `place` is where it runs, and stays there afterwards; `unmasked` has act log secrets as they are, for a search;
    `inputs` are those of workflow_dispatch; `actions_dir` holds copies of real actions in folders OWNER__NAME.
    `attempt` above 1 is a run that is started again over the `artifacts` of an earlier attempt, a folder, and `matrix`
    (KEY:VALUE) narrows its matrix, as "re-run failed jobs" does; `github` is what GitHub's API says: `heads`, commits
    of branches (unless said, the event's branch is where it is built), and `tags`, names of git tags.
    `subject` is the commit's, `staged` are git's commands that change the index before it.
    The caller's folder and the user's home are not touched. Raises LabError when an action has no stand-in.
    """
    payload = _payload(event_payload or {})
    branch = str(payload["repository"]["default_branch"])
    with (
        _folder(place) as name,
        api_stub(known := {"default_branch": branch, "heads": {}, **(github or {})}) as api,
        artifact_door(server := f"127.0.0.1:{_free_port()}") as service,
    ):
        place = Path(name)
        copy = caller.prepare(caller_dir, place / "caller", payload, subject=subject, staged=staged)
        ref = str(payload.get("ref") or f"refs/heads/{branch}")
        if "heads" not in (github or {}) and ref.startswith("refs/heads/"):
            known["heads"] = {ref.removeprefix("refs/heads/"): caller.commit(copy)}
        event_file = place / "event.json"
        event_file.write_text(json.dumps(payload))
        environment = {**_environment(lab, place), "ACTIONS_RUNTIME_URL": service}
        steps = {
            "GITHUB_API_URL": api,
            # As on runners of their own: a job that ends logs out, while another still needs its login
            "DOCKER_CONFIG": "${{ runner.temp }}/docker-config",
            "REPRO_LAB_SOURCE": str(CHECKOUT),
            "REPRO_LAB_PROGRAM": str(caller.program(CHECKOUT)),
            "REPRO_LAB_BUILDKIT": lab.buildkit,
            "REPRO_LAB_ARTIFACTS": str((artifacts or place) / "artifacts"),
            "GITHUB_RUN_ATTEMPT": str(attempt),
            **(env or {}),
        }
        command = [str(lab.act), event, "--json", "-C", str(copy), "-e", str(event_file)]
        command += ["--defaultbranch", branch, "--actor", payload["sender"]["login"]]
        command += [*_host_labels(), *_offline(artifacts or place, server)]
        command += ["--insecure-secrets"] if unmasked else []
        command += ["--matrix", matrix] if matrix else []
        for job in jobs or ():
            command += ["--job", job]
        if workflow:
            command += ["-W", str(copy / caller.moved(workflow))]
        for pair, target in caller.mappings(copy, actions_dir).items():
            command += ["--local-repository", f"{pair}={target}"]
        hidden = {"GITHUB_TOKEN": RUN_TOKEN, "REGISTRY_PASSWORD": lab.password, **(secrets or {})}
        for option, values in (("--env", steps), ("--secret", hidden), ("--input", inputs or {})):
            for key, value in values.items():
                command += [option, f"{key}={value}"]
        code, lines = _run(command, environment, timeout, tell, raw)
    return _result(code, lines)


def _folder(place: Path | None) -> AbstractContextManager[str]:
    if place is None:
        # Every job copies the actions: on a disk, a thousand small files cost more than what the step then does
        return tempfile.TemporaryDirectory(prefix="repro-act-", dir=memory(), ignore_cleanup_errors=True)
    place.mkdir(parents=True)
    return nullcontext(str(place))


def _payload(given: dict[str, Any]) -> dict[str, Any]:
    """Complete an event: act leaves it nearly empty, and rules about the default branch need it."""
    known = {"full_name": "someone/something", "default_branch": "main", "private": False}
    repository = {**known, **given.get("repository", {})}
    owner, _, name = repository["full_name"].partition("/")
    repository = {"name": name, "owner": {"login": owner}, **repository}
    return {"sender": {"login": owner}, **given, "repository": repository}


def _environment(lab: Laboratory, place: Path) -> dict[str, str]:
    """Return everything that act and, in host mode, every step inherits."""
    home = place / "home"
    home.mkdir()
    # The interpreter below a test's own virtual environment: a step must not see what the tests installed.
    path = os.pathsep.join([str(lab.node), str(Path(sys.base_prefix) / "bin"), os.environ.get("PATH", os.defpath)])
    passed = {name: value for name, value in os.environ.items() if name in PASSED or name.startswith("PIP_")}
    return {
        **passed,
        "HOME": str(home),
        "PATH": path,
        "DOCKER_HOST": lab.docker_host,
        "PIP_CACHE_DIR": str(folder("pip-cache")),
        # As the owner of a runner may have it: made once, not by every job of every test
        "ROSLAB_PYTHON_CACHE": str(folder("runner")),
    }


def _host_labels() -> list[str]:
    return [word for label in facts.texts("act", "labels") for word in ("-P", f"{label}=-self-hosted")]


def _free_port() -> int:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        return int(free.getsockname()[1])


def _offline(place: Path, server: str) -> list[str]:
    kept = place / "act-artifacts"
    (kept / "1").mkdir(parents=True, exist_ok=True)  # of the run: act's server cannot list what was never begun
    port = server.partition(":")[2]
    artifacts = ["--artifact-server-path", str(kept), "--artifact-server-port", port]
    servers = ["--artifact-server-addr", "127.0.0.1", "--cache-server-addr", "127.0.0.1", "--no-cache-server"]
    return [*artifacts, *servers, "--container-daemon-socket", "-", "--action-offline-mode"]


def _run(
    command: Sequence[str],
    environment: Mapping[str, str],
    timeout: float,
    tell: Callable[[str], None] | None,
    raw: Callable[[str], None] | None,
) -> tuple[int, list[str]]:
    """Run act in a process group of its own and end the whole of it when it takes too long."""
    process = subprocess.Popen(
        command, env=dict(environment), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        text=True, errors="replace", start_new_session=True,
    )  # fmt: skip
    late = threading.Timer(timeout, os.killpg, (process.pid, signal.SIGKILL))
    late.start()
    lines: list[str] = []
    try:
        for line in process.stdout or ():
            lines.append(line.rstrip("\n"))
            if tell is not None:
                tell(_spoken(lines[-1]))
            if raw is not None:
                raw(lines[-1])
        code = process.wait()
    finally:
        if late.finished.is_set():
            lines.append(f"act did not end within {timeout:.0f} s and was ended")
        late.cancel()
        if process.stdout:
            process.stdout.close()
    return code, lines


def _spoken(line: str) -> str:
    """Return what a line of act's JSON says, the line itself where it is none."""
    try:
        return str(json.loads(line)["msg"]).rstrip("\n")
    except (ValueError, KeyError, TypeError):
        return line


def _result(code: int, lines: Sequence[str]) -> Result:
    log: list[str] = []
    jobs: dict[str, str] = {}
    outputs: dict[str, dict[str, str]] = {}
    summary: list[str] = []
    for line in lines:
        try:
            entry = json.loads(line)
        except ValueError:
            entry = {"msg": line}
        if not isinstance(entry, dict):
            entry = {"msg": line}
        job, message = str(entry.get("job", "")).strip(), str(entry.get("msg", "")).rstrip("\n")
        log.append(f"[{job}] {message}" if job else message)
        if "jobResult" in entry:
            jobs[job] = str(entry["jobResult"])
        if entry.get("command") == "set-output" and "name" in entry:
            outputs.setdefault(job, {})[str(entry["name"])] = str(entry.get("arg", ""))
        if entry.get("command") == "summary":
            summary.append(str(entry.get("content", message)))
    return Result(exit_code=code, log="\n".join(log), jobs=jobs, outputs=outputs, summary="\n".join(summary))
