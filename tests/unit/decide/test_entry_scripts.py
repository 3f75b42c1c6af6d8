"""An author's entry point that no command reaches, and the variables that its script expects."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

import pytest

from hanging import ends
from roslab.decide.decision import Decision
from roslab.evidence.prose.entry_defaults import starts_alone
from roslab.pipeline import plan_repository

Tree = Callable[[dict[str, str]], Decision]
IMAGE = 'FROM python:3.10\nCOPY . /app\nWORKDIR /app\nENV LEVEL=1\nENTRYPOINT ["/app/docker/entry.sh"]\nCMD ["bash"]\n'
PAGE = "# Demo\n## Usage\n```\npython demo.py\n```\n"
FILES = {"demo.py": "print(1)\n", "README.md": PAGE, "Dockerfile": IMAGE}
IN_SHELL = 'set -e\nif [ "$EUID" -eq 0 ]; then\n  sudo -u x bash\nelse\n  exec bash\nfi\n'
COMPOSE = "services:\n  demo:\n    build: .\n    environment:\n      - ROBOT=${ROBOT:-atlas}\n"


def of(tree: Tree, script: str, **more: str) -> Decision:
    return tree(FILES | {"docker/entry.sh": f"#!/bin/bash\n{script}"} | more)


def told(decision: Decision) -> list[tuple[str, str | None, int | None]]:
    return [(w.message, w.file, w.line) for w in decision.warnings if "ENTRYPOINT" in w.message or "reads" in w.message]


def test_a_script_that_ends_in_a_shell_is_replaced_by_the_command_of_the_page(tree: Tree) -> None:
    decision = of(tree, IN_SHELL)
    assert (decision.command, decision.command_given, decision.command_through_entrypoint) == (
        ("python", "demo.py"),
        True,
        False,
    )
    assert decision.entrypoint_takes == "nothing"
    ((message, file, line),) = told(decision)
    assert "never starts the command that it is given" in message
    assert (file, line) == ("docker/entry.sh", 6)


@pytest.mark.parametrize("line", ['exec "$@"', "exec $*", 'set -x\n"$@"', 'exec gosu me "${@}"'])
def test_a_script_that_starts_what_it_is_given_is_a_wrapper(tree: Tree, line: str) -> None:
    decision = of(tree, f"export A=1\n{line}\n")
    assert decision.entrypoint_takes == "commands"
    assert (decision.command, decision.command_through_entrypoint, told(decision)) == (("python", "demo.py"), True, [])


def test_a_script_that_starts_a_program_is_the_command(tree: Tree) -> None:
    decision = of(tree, "cd /app\npython3 other.py\nexec bash\n")
    assert (decision.command, decision.command_given) == (("/app/docker/entry.sh",), False)
    assert decision.entrypoint_takes == "nothing"


def test_arguments_of_a_program_are_its_own(tree: Tree) -> None:
    decision = of(tree, "python3 other.py --mode $1\n")
    assert (decision.entrypoint_takes, told(decision)) == ("arguments", [])


def test_a_line_of_a_shell_never_sees_its_words(tree: Tree) -> None:
    decision = tree(FILES | {"Dockerfile": IMAGE.replace('["/app/docker/entry.sh"]', "python other.py")})
    assert decision.entrypoint_takes == "nothing"
    ((message, file, line),) = told(decision)
    assert 'a line of a shell without "$@"' in message
    assert (file, line) == ("Dockerfile", 6)


def test_a_variable_that_nothing_sets_is_told_and_the_shell_takes_the_script_s_place(tree: Tree) -> None:
    script = 'export HOME=/home/$ROBOT\necho $LEVEL ${OWN:-1} $PATH\nA_B=1; echo $A_B "$ROBOT"\nexec bash\n'
    decision = of(tree, script, **{"README.md": "# Demo\n", "demo.py": "a = 1\n"})
    assert (decision.command, decision.command_given, decision.command_through_entrypoint) == (("bash",), True, False)
    message, file, line = told(decision)[1]
    assert message.startswith("docker/entry.sh reads ROBOT; neither it nor the Dockerfile sets it")
    assert (file, line) == ("docker/entry.sh", 2)
    assert len(told(decision)) == 2


def test_a_variable_is_given_what_compose_would_set(tree: Tree) -> None:
    page = "# Demo\n```\ndocker compose up\n```\n"
    decision = of(tree, "python3 other.py $ROBOT\n", **{"README.md": page, "docker-compose.yml": COMPOSE})
    assert decision.command == ("env", "ROBOT=atlas", "/app/docker/entry.sh")
    assert (decision.command_given, decision.command_through_entrypoint) == (True, False)
    assert "docker_run.sh gives it atlas, as Docker Compose would" in told(decision)[1][0]


@pytest.mark.parametrize(
    "script",
    ['[ -z "$ROBOT" ] && ROBOT=x\necho $ROBOT\n', ". ./robot.env\necho $ROBOT\n", "echo ${ROBOT:?say it}\n",
     "read ROBOT\necho $ROBOT\n", "for ROBOT in a b; do echo $ROBOT; done\n", "# $ROBOT\n", "echo \\$ROBOT\n"],
)  # fmt: skip
def test_no_variable_is_told_that_the_script_knows_about(tree: Tree, script: str) -> None:
    assert not [each for each in told(of(tree, f"{script}exec bash\n")) if "reads" in each[0]]


def test_a_script_that_the_dockerfile_adds_to_is_not_judged(tree: Tree) -> None:
    adds = IMAGE.replace("ENV", "RUN echo 'exec \"$@\"' >> /app/docker/entry.sh\nENV")
    assert told(of(tree, "export A=1\n", Dockerfile=adds)) == []


def test_a_test_takes_the_place_of_an_entry_point_that_would_not_start_it(tmp_path: Path) -> None:
    said = "format: 3\ntest: python -m pytest\n"
    for path, text in (FILES | {"docker/entry.sh": f"#!/bin/bash\n{IN_SHELL}", "roslab.yaml": said}).items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    plan = plan_repository(tmp_path).plan
    assert [proof.entrypoint for proof in plan.proofs if proof.rung == 4] == [False]
    assert plan.run.entrypoint_takes == "nothing"


@pytest.mark.parametrize(
    ("script", "found"),
    [
        (
            'set -e\ncd "$HOME/atlas_ws/src/demo"\nexec "$@"\n',
            ("$HOME/atlas_ws/src/demo", "atlas_ws", "stops there", 3),
        ),
        (
            "cd /home/ann/atlas_ws && ls\ncd /home/ann/atlas_ws\nexec bash\n",
            ("/home/ann/atlas_ws", "ann", "goes on in another folder", 2),
        ),
        (
            'if a; then b; fi\nf() { echo "${A}"; }\ncase a in\nb) ;;\nesac\ncd /atlas_ws/src\nexec bash\n',
            ("/atlas_ws/src", "atlas_ws", "goes on in another folder", 7),
        ),
    ],
)
def test_a_folder_that_nothing_makes_is_told(tree: Tree, script: str, found: tuple[str, str, str, int]) -> None:
    decision = of(tree, script)
    (told,) = [warning for warning in decision.warnings if "changes to" in warning.message]
    folder, part, then, line = found
    assert told.message.startswith(f"docker/entry.sh changes to {folder}; ")
    assert f"names {part}: a container {then} unless it is mounted" in told.message
    assert (told.file, told.line) == ("docker/entry.sh", line)


@pytest.mark.parametrize(
    "script",
    [
        "cd /app/docker\n",  # of the tree
        "cd /opt/ros/humble/share\n",
        "cd /data\ncd ..\ncd $FOLDER/atlas_ws\n",
        "mkdir -p /home/atlas_ws\ncd /home/atlas_ws\n",
        "cd /home/atlas_ws || true\n",
        "[ -d /home/atlas_ws ] && cd /home/atlas_ws\n",
        "# cd /home/atlas_ws\n",
        '[ -n "$A" ] && cd /home/atlas_ws\n',
        '[ -n "$A" ] && \\\n  cd /home/atlas_ws\n',
        'if [ "$A" = dev ]; then\n  cd /home/atlas_ws\nfi\n',
        "if false\nthen\n  for a in b; do echo; done\n  cd /home/atlas_ws\nfi\n",
        'case "$1" in\n  dev)\n    cd /home/atlas_ws\n    ;;\nesac\n',
        "work() {\n  cd /home/atlas_ws\n}\n",
        "function work\n{\n  cd /home/atlas_ws\n}\n",
    ],
)
def test_a_folder_that_may_be_there_is_not_told(tree: Tree, script: str) -> None:
    decision = of(tree, f'{script}exec "$@"\n')
    assert not any("changes to" in warning.message for warning in decision.warnings)


def test_a_folder_of_a_step_of_the_dockerfile_is_there(tree: Tree) -> None:
    image = IMAGE.replace("ENV LEVEL=1", "RUN git clone https://github.com/acme/atlas_ws.git /home/atlas_ws")
    decision = of(tree, 'cd /home/atlas_ws\nexec "$@"\n', Dockerfile=image)
    assert not any("changes to" in warning.message for warning in decision.warnings)


def test_a_folder_that_compose_mounts_is_told_as_that(tree: Tree) -> None:
    page = "# Demo\n```\ndocker compose up\n```\n"
    compose = "services:\n  demo:\n    build: .\n    volumes:\n      - ./data:/home/atlas_ws\n"
    more = {"README.md": page, "docker-compose.yml": compose, "data/a.txt": "1"}
    decision = of(tree, 'cd /home/atlas_ws/x\nexec "$@"\n', **more)
    (told,) = [warning for warning in decision.warnings if "changes to" in warning.message]
    assert "only as the volume of Docker Compose, which docker_run.sh mounts" in told.message


def test_many_folders_take_no_time(tree: Tree) -> None:
    script = "".join(f"cd /home/ann/f{number}\n" for number in range(3_000))
    before = time.process_time()
    decision = of(tree, f'{script}exec "$@"\n')
    assert any("changes to" in warning.message for warning in decision.warnings)
    assert time.process_time() - before < 5


ALONE = IMAGE.replace('CMD ["bash"]\n', "")


@pytest.mark.parametrize(
    "script",
    [
        'if [ $# -eq 0 ]; then\n  exec python3 other.py\nelse\n  exec "$@"\nfi\n',
        'if [[ -z "$1" ]]\nthen\n  if [ -d x ]; then\n    ls\n  fi\n  python3 other.py\n  exit\nfi\nexec "$@"\n',
        'if [ "$#" -gt 0 ]; then\n  exec "$@"\nfi\nsource /opt/a.sh\nroslaunch demo a.launch\n',
        'if [ -n "$1" ]; then\n  exec "$@"\nelse\n  ros2 launch demo a.launch.py\nfi\n',
        "exec ${@:-python3 other.py}\n",
        '[ $# -eq 0 ] && exec python3 other.py\nexec "$@"\n',
        'if (( $# == 0 )); then\n  rosrun demo a\nfi\nexec "$@"\n',
        'if [ $# -eq 0 ]; then exec python3 other.py; fi\nexec "$@"\n',
        'if [ $# -gt 0 ]; then exec "$@"; else python3 other.py; fi\nexec "$@"\n',
        'if [ $# -gt 0 ]; then exec "$@"; fi\npython3 other.py\nexec "$@"\n',
    ],
)
def test_a_script_that_starts_a_program_where_it_is_given_nothing(tree: Tree, script: str) -> None:
    decision = of(tree, script, Dockerfile=ALONE, **{"README.md": "# Demo\n"})
    assert (decision.command, decision.command_given) == (("/app/docker/entry.sh",), False)
    assert decision.entrypoint_takes == "commands"
    other = of(tree, script, **{"README.md": "# Demo\n"})  # CMD gives it a shell
    assert other.command == ("bash",)


@pytest.mark.parametrize(
    "script",
    [
        'exec "$@"\n',
        'python3 set_up.py\nexec "$@"\n',
        'if [ "$1" = train ]; then\n  python3 other.py\nfi\nexec "$@"\n',
        'if [ $# -gt 0 ]; then\n  python3 other.py\nfi\nexec "$@"\n',
        'if [ $# -eq 0 ]; then\n  bash\nelse\n  python3 check.py\n  exec "$@"\nfi\n',
        'if [ $# -eq 0 ]; then\n  echo "Usage: python3 other.py --fast"\n  exit 1\nfi\nexec "$@"\n',
        'if [ $# -eq 0 ]; then exec bash; fi\nif [ "$X" ]; then\n  python3 other.py\nfi\nexec "$@"\n',
        'if [ $# -eq 0 ]; then\n  if [ "$X" ]; then ls; fi\nelse\n  python3 other.py\nfi\nexec "$@"\n',
        'if ! [ $# -eq 0 ]; then\n  python3 other.py\nfi\nexec "$@"\n',
        'if [ $# -eq 0 ]; then\n  python3 -m pip install -e .\nfi\nexec "$@"\n',
        'if [ $# -eq 0 ]; then\n  python3 --version\nfi\nexec "$@"\n',
        '[ $# -eq 0 ] && { printf "try python3 other.py\\n"; exit 1; }\nexec "$@"\n',
    ],
)
def test_a_script_that_starts_no_program_alone(tree: Tree, script: str) -> None:
    assert of(tree, script, Dockerfile=ALONE, **{"README.md": "# Demo\n"}).command == ("bash",)


def test_blanks_without_end_take_no_time() -> None:
    with ends():
        assert not starts_alone([f"(({blanks}$#{blanks}" for blanks in (" " * 200_000, "\t" * 200_000)])
