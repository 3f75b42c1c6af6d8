"""One failure as each builder, service and build tool writes it down: the same cause comes out of all."""

from __future__ import annotations

import io
from collections.abc import Sequence

import pytest

from roslab.explain.answer import explain

ERROR = "/ws/src/arm/main.cpp:4:10: fatal error: glog/logging.h: No such file or directory"
SAID = (
    "Starting >>> arm",
    "--- stderr: arm",
    ERROR,
    "    4 | #include <glog/logging.h>",
    "compilation terminated.",
    "gmake: *** [Makefile:146: all] Error 2",
    "---",
    "Failed   <<< arm [7.50s, exited with code 2]",
)
END = 'process "/bin/sh -c colcon build" did not complete successfully: exit code: 2'
EXCERPT = ("Dockerfile:21", "-" * 20, "  20 |     ", "  21 | >>> RUN colcon build", "  22 |     ", "-" * 20)
AGAIN = (
    "------",
    " > [4/5] RUN colcon build:",
    *(f"{n}.203 {line}" for n, line in enumerate(SAID)),
    "------",
    *EXCERPT,
)
PLAIN = (
    "#7 [3/5] RUN rosdep update",
    "#7 DONE 4.1s",
    "",
    "#8 [4/5] RUN colcon build",
    *(f"#8 {n}.203 {line}" for n, line in enumerate(SAID)),
    f"#8 ERROR: {END}",
    *AGAIN,
    f"ERROR: failed to solve: {END}",
)
TERMINAL = (
    "[+] Building 70.0s (9/10)                                                        docker:default",
    " => [internal] load build definition from Dockerfile                                       0.0s",
    " => => transferring dockerfile: 4.20kB                                                     0.0s",
    " => CACHED [3/5] RUN rosdep update                                                         0.0s",
    " => ERROR [4/5] RUN colcon build                                                          58.2s",
    *AGAIN,
    f"ERROR: failed to solve: {END}",
)
CLASSIC = (
    "Step 3/5 : RUN rosdep update",
    " ---> Using cache",
    " ---> 3b9c3dde9c01",
    "Step 4/5 : RUN colcon build",
    " ---> Running in 6f0d6b4ce0a1",
    *SAID,
    "The command '/bin/sh -c colcon build' returned a non-zero code: 2",
)
BUILDAH = (
    "STEP 3/5: RUN rosdep update",
    "--> 3b9c3dde9c01",
    "STEP 4/5: RUN colcon build",
    *SAID,
    'Error: building at STEP "RUN colcon build": while running runtime: exit status 2',
)
KANIKO = (
    "INFO[0012] RUN rosdep update",
    "INFO[0012] Taking snapshot of full filesystem...",
    "INFO[0023] RUN colcon build",
    "INFO[0023] Cmd: /bin/sh",
    "INFO[0023] Args: [-c colcon build]",
    "INFO[0023] Running: [/bin/sh -c colcon build]",
    *SAID,
    "error building image: error building stage: failed to execute command: waiting for process to exit: exit status 2",
)
CATKIN = (
    "Errors     << arm:make /ws/logs/arm/build.make.000.log",
    ERROR,
    "compilation terminated.",
    "make: *** [all] Error 2",
    "cd /ws/build/arm; catkin build --get-env arm | catkin env -si  /usr/bin/make --jobserver-auth=3,4; cd -",
    "",
    "Failed     << arm:make             [ Exited with code 2 ]",
    "[build] Summary: 0 of 1 packages succeeded.",
)
STEP = "RUN colcon build"
NONE = ""


def behind(prefix: str, lines: Sequence[str]) -> list[str]:
    return [prefix + line for line in lines]


def at(lines: Sequence[str], form: str = "2024-10-16T10:00:{:02d}.0000000Z ") -> list[str]:
    return [form.format(n % 60) + line for n, line in enumerate(lines)]


ACTION = (
    "##[group]Run docker/build-push-action@v6",
    "with:",
    "  push: false",
    "##[endgroup]",
    *PLAIN,
    f"##[error]buildx failed with: ERROR: failed to solve: {END}",
)
WRAPPINGS: dict[str, tuple[Sequence[str], str]] = {
    "BuildKit, plain": (PLAIN, STEP),
    "BuildKit, terminal": (TERMINAL, STEP),
    "BuildKit, indented in a page": (behind("    ", PLAIN), STEP),
    "BuildKit 0.10, its repetition": ([f"#0 {each}" if each[:1].isdigit() else each for each in TERMINAL], STEP),
    "BuildKit, the end alone": ((*AGAIN, f"ERROR: failed to solve: {END}"), STEP),
    "classic builder": (CLASSIC, STEP),
    "docker-compose 1": (("Building ros", *CLASSIC, "ERROR: Service 'ros' failed to build : Build failed"), STEP),
    "docker compose": ([each.replace("[4/5]", "[ros 4/5]") for each in PLAIN], STEP),
    "Python's client of docker": (behind("INFO:Docker Client:", CLASSIC), STEP),
    "buildah": (BUILDAH, STEP),
    "podman, several stages": ([f"[2/2] {each}" if each.startswith("STEP") else each for each in BUILDAH], STEP),
    "podman 3": ((*BUILDAH[:-1], "Error: error building at STEP \"RUN colcon build\": exit status 2"), STEP),
    "kaniko": (KANIKO, STEP),
    "no builder": (SAID, NONE),
    "GitHub, raw": (at(ACTION), STEP),
    "GitHub, raw, classic": (at(("##[group]Run docker build .", "\x1b[36;1mdocker build .\x1b[0m", "##[endgroup]",
                                 *CLASSIC, "##[error]Process completed with exit code 2.")), STEP),
    "GitHub, no builder": (at(("##[group]Run colcon build", "shell: /usr/bin/bash -e {0}", "##[endgroup]", *SAID,
                               "##[error]Process completed with exit code 2.")), NONE),
    "gh run view --log": (at(ACTION, "image\tBuild the image\t2024-10-16T10:00:{:02d}.0000000Z "), STEP),
    "gh run view --log-failed": (at(ACTION, "image\tUNKNOWN STEP\t2024-10-16T10:00:{:02d}.0000000Z "), STEP),
    "act": ((*behind("[CI/image]   | ", PLAIN), "[CI/image]   ❌  Failure - Main Build the image"), STEP),
    "act, prefixes of its own": (behind("| ", PLAIN), STEP),
    "GitLab": (("section_start:1714557600:step_script\r\x1b[0K\x1b[0K\x1b[36;1mExecuting\x1b[0;m", *CLASSIC), STEP),
    "GitLab, with times": (at(PLAIN, "2024-10-16T10:00:{:02d}.000000Z 00O "), STEP),
    "Jenkins, with times": (at(PLAIN, "[2024-10-16T10:00:{:02d}.000Z] "), STEP),
    "Jenkins, with the hour alone": (at(PLAIN, "10:00:{:02d} "), STEP),
    "Jenkins, the hour, no builder": (at(SAID, "10:00:{:02d}  "), NONE),
    "industrial_ci": (behind("  ", SAID), NONE),
    "no builder, indented in a page": (behind("    ", SAID), NONE),
    "Travis": (("travis_fold:start:build\r\x1b[0K$ docker build .", *CLASSIC), STEP),
    "colours": ([f"\x1b[91m{each}\x1b[0m" for each in CLASSIC], STEP),
    "colours without their escape": ([f"[91m{each}[0m" for each in CLASSIC], STEP),
    "Windows": ([f"{each}\r" for each in CLASSIC], STEP),
    "quoted in an issue": (behind("> ", CLASSIC), STEP),
    "copied as HTML": (
        [f"<b>{each}</b>".replace("fatal error:", '</b><font color="#C01C28"><b>fatal error:</b></font>') for each in (
            each.replace("<", "&lt;").replace(">", "&gt;") for each in CLASSIC)],
        STEP,
    ),
    "docker compose, the services": (behind("ros_dev  | ", SAID), NONE),
    "colcon's stderr.log": ((ERROR, "compilation terminated.", "gmake: *** [Makefile:146: all] Error 2"), NONE),
    "colcon's streams.log": ([f"[{n}.024s] {line}" for n, line in enumerate(("Invoking command", *SAID))], NONE),
    "colcon's events.log": (
        [
            "[0.000000] (-) TimerEvent: {}",
            "[0.000337] (arm) JobQueued: {'identifier': 'arm', 'dependencies': OrderedDict()}",
            *(f"[{n}.120000] (arm) StderrLine: {{'line': b'{line}\\n'}}" for n, line in enumerate(SAID[2:6])),
            *(f"[7.4] (arm) StderrLine: {{'line': b'{cut}\\n'}}" for cut in (r"a \xZZ", r"\x4", "b\\")),
            "[7.500000] (arm) CommandEnded: {'returncode': 2}",
            "[7.500000] (arm) JobEnded: {'identifier': 'arm', 'rc': 2}",
        ],
        NONE,
    ),
    "catkin build": (CATKIN, NONE),
    "catkin build, tailed": (behind("[arm:make] ", (*SAID[:5], "make: *** [all] Error 2")), NONE),
    "catkin's build.make.log": (("\x1b[0mScanning dependencies of arm", f"\x1b[31m{ERROR}\x1b[0m", SAID[4]), NONE),
}  # fmt: skip


@pytest.mark.parametrize("name", WRAPPINGS)
def test_the_cause_is_the_same(name: str) -> None:
    lines, step = WRAPPINGS[name]
    answer = explain(io.BytesIO("".join(f"{line}\n" for line in lines).encode()))
    (found,) = answer.explanations
    assert (found.id, dict(found.names)["header"], found.step) == ("header-missing", "glog/logging.h", step)
    assert found.repair == (("apt", ("libgoogle-glog-dev",)),)
    assert found.error == ERROR
    told = any(sign in line for line in lines for sign in ("<<", "&lt;&lt;", "JobEnded"))
    assert found.packages == (("arm",) if told else ())
