"""A page that calls a task of a Makefile or of a project's manager runs what that runs."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from hanging import ends
from roslab.evidence.lex.make_tasks import parsed
from roslab.evidence.prose.make_recipes import of_makefile
from roslab.evidence.prose.manager_tasks import of_managers
from roslab.pipeline import plan_repository

CODE = {
    "main.py": "import numpy\nif __name__ == '__main__':\n    print('a')\n",
    "other.py": "if __name__ == '__main__':\n    print('a')\n",
    "requirements.txt": "numpy\n",
}
MAKEFILE = """\
PY ?= python3
VENV = .venv
DATA := data
ifdef FAST
DATA := few
endif

.PHONY: train sim test
train: venv
	@echo start
	$(PY) main.py --data $(DATA) $(ARGS) \\
		--epochs 3

venv: clean
	pip install einops

sim:
	cd arm && $(VENV)/bin/python demo.py --home $(HOME)

both:
	$(MAKE) sim
	python other.py

clean:
	rm -rf build

robot: src/main.cpp
	g++ -o robot src/main.cpp

start: robot
	./robot --fast

demo: ; bash demo.sh

boxed:
	docker run --rm demo python main.py

written:
	python main.py --day $(shell date)

test:
	python -m pytest
lint-run:
	python main.py
one-test:
	python -m pytest tests
around: around
	make around

ifeq ($(OS),Windows_NT)
RUN := python.exe
else
RUN := python3
endif
ported:
	$(RUN) main.py

chosen:
ifdef FAST
	python main.py --fast
else
	python main.py
endif

pathed:
	PATH=$(CURDIR)/bin:$(PATH) python main.py

plain:
	python main.py
define HELP
	python other.py
endef
"""


@pytest.mark.parametrize(
    ("call", "line"),
    [
        ("train", "pip install einops && echo start && python3 main.py --data data  --epochs 3"),
        (
            "train ARGS=--fast PY=python",
            "pip install einops && echo start && python main.py --data data --fast --epochs 3",
        ),
        ("sim", "cd arm && python demo.py --home $HOME"),
        ("both", "(cd arm && python demo.py --home $HOME) && python other.py"),
        ("start", "./robot --fast"),
        ("demo", "bash demo.sh"),
        ("boxed", "docker run --rm demo python main.py"),
        ("written", None),
        ("test", None),
        ("lint-run", None),
        ("one-test", None),
        ("clean", None),
        ("around", None),
        ("ported", None),
        ("ported RUN=python", "python main.py"),
        ("chosen", None),
        ("pathed", "PATH=./bin:$PATH python main.py"),
        ("plain", "python main.py"),
        ("nothing", None),
    ],
)
def test_what_a_target_runs(call: str, line: str | None) -> None:
    assert of_makefile(MAKEFILE).line_of(call) == line


def test_lines_that_one_shell_runs_are_left_to_make() -> None:
    assert of_makefile("sim:\n\tcd arm\n\tpython main.py\n").line_of("sim") == "(cd arm) && python main.py"
    assert of_makefile(".ONESHELL:\nsim:\n\tcd arm\n\tpython main.py\n").line_of("sim") is None


@pytest.mark.parametrize(
    "text",
    [
        "a" + " " * 60_000,
        "".join(f"a{n}: {' '.join(f'a{m}' for m in range(300))}\n\tpython a.py\n" for n in range(300)),
        "run:\n\tpython a.py " + "$(" * 900,
        "".join(f"A{n} = $(A{n + 1}) $(A{n + 1}) $(A{n + 1})\n" for n in range(60)) + "run:\n\tpython $(A0)\n",
        "".join("A += $(A) b\n" for _ in range(3_000)) + "run:\n\tpython $(A)\n",
        "".join(f"{'a ' * 90}\n" for _ in range(300)),
        f"A = {'a' * 1_900}\nrun:\n" + f"\tpython {'$(A)' * 450}\n" * 30,
        "A = a\n" + "".join(f"run{n}:\n" for n in range(400)) + "run:\n" + "\tpython $(A)\n" * 2_000,
    ],
    ids=["blanks", "needed", "brackets", "doubled", "grown", "words", "long", "lines"],
)
def test_a_hostile_makefile_takes_no_long_time(text: str) -> None:
    with ends():
        found = of_makefile(text)
        for name in parsed(text).targets:
            found.line_of(name)
        found.line_of("run")


def plan_of(folder: Path, files: Mapping[str, str]) -> tuple[tuple[str, ...] | str, tuple[str, ...]]:
    for path, text in {**CODE, **files}.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text)
    plan = plan_repository(folder).plan
    return plan.run.command, plan.python.pip_guessed


@pytest.mark.parametrize(
    "page", ["```\nmake train\n```\n", "    make train\n", "Start it with `make train`.\n", "- `make train`: learns\n"]
)
def test_the_image_runs_the_recipe_of_make(tmp_path: Path, page: str) -> None:
    command, guessed = plan_of(tmp_path, {"Makefile": MAKEFILE, "README.md": f"# Usage\n\n{page}"})
    assert command == ("python3", "main.py", "--data", "data", "--epochs", "3")
    assert "einops" in guessed


def test_make_in_a_folder_has_the_recipes_of_that_folder(tmp_path: Path) -> None:
    page = "# Usage\n\n```\ncd arm\nmake run\n```\n"
    arm = {"arm/Makefile": "run:\n\tpython go.py --fast\n", "arm/go.py": CODE["main.py"]}
    files = {"Makefile": "run:\n\tpython main.py\n", "README.md": page, **arm}
    assert plan_of(tmp_path, files)[0] == ("python", "arm/go.py", "--fast")


def test_a_makefile_starts_what_it_compiles(tmp_path: Path) -> None:
    (tmp_path / "src").mkdir()
    (tmp_path / "src/main.cpp").write_text("int main() { return 0; }\n")
    (tmp_path / "Makefile").write_text(
        "all: bin/robot\nbin/robot: src/main.cpp\n\tmkdir -p bin\n\tg++ -o bin/robot src/main.cpp\n"
        "run: all\n\t./bin/robot --fast\n"
    )
    (tmp_path / "README.md").write_text("# Usage\n\n```\nmake\nmake run\n```\n")
    assert plan_repository(tmp_path).plan.run.command == ("./bin/robot", "--fast")


PROJECT = "[project]\nname = 'demo'\nversion = '1'\ndependencies = ['numpy']\n"


@pytest.mark.parametrize(
    ("call", "file", "text"),
    [
        ("hatch run sim", "pyproject.toml", "[tool.hatch.envs.default.scripts]\nsim = 'python main.py --fast'\n"),
        ("hatch run sim", "hatch.toml", "[envs.default.scripts]\nsim = ['echo a', 'python main.py --fast']\n"),
        ("hatch run rl:sim", "pyproject.toml", "[tool.hatch.envs.rl.scripts]\nsim = 'python main.py {args:--fast}'\n"),
        ("hatch run sim --fast", "hatch.toml", "[envs.default.scripts]\nsim = 'go {args}'\ngo = 'python main.py'\n"),
        ("pdm run sim --fast", "pyproject.toml", "[tool.pdm.scripts]\nsim = {cmd = ['python', 'main.py']}\n"),
        (
            "pdm run sim",
            "pyproject.toml",
            "[tool.pdm.scripts]\nsim = {composite = ['go --fast']}\ngo = 'python main.py'\n",
        ),
        ("rye run sim", "pyproject.toml", "[tool.rye.scripts]\nsim = {cmd = 'python main.py --fast'}\n"),
        ("poe sim", "pyproject.toml", "[tool.poe.tasks]\nsim.shell = 'python main.py --fast'\n"),
        ("uv run poe sim", "pyproject.toml", "[tool.poe.tasks]\nsim = 'python main.py --fast'\n"),
        ("poetry run task sim", "pyproject.toml", "[tool.taskipy.tasks]\nsim = 'python main.py --fast'\n"),
        ("pipenv run sim", "Pipfile", "[packages]\nnumpy = '*'\n[scripts]\nsim = 'python main.py --fast'\n"),
        ("task sim", "Taskfile.yml", "version: '3'\ntasks:\n  sim:\n    cmds:\n      - python main.py --fast\n"),
        ("task sim -- --fast", "Taskfile.yml", "tasks:\n  sim: python main.py {{.CLI_ARGS}}\n"),
    ],
)
def test_the_image_runs_the_task_of_a_manager(tmp_path: Path, call: str, file: str, text: str) -> None:
    text = f"{PROJECT}{text}" if file == "pyproject.toml" else text
    command, _ = plan_of(tmp_path, {file: text, "README.md": f"# Usage\n\n```\n{call}\n```\n"})
    assert command == ("python", "main.py", "--fast")


@pytest.mark.parametrize(
    ("file", "task", "call"),
    [
        ("pyproject.toml", "[tool.poe.tasks]\nsim = {cmd = 'python go.py', cwd = 'arm'}\n", "poe sim"),
        ("pyproject.toml", "[tool.pdm.scripts]\nsim = {cmd = 'python go.py', working_dir = 'arm'}\n", "pdm run sim"),
        ("Taskfile.yml", "tasks:\n  sim:\n    dir: arm\n    cmds: [echo a, python go.py]\n", "task sim"),
    ],
)
def test_a_task_is_run_in_its_folder(tmp_path: Path, file: str, task: str, call: str) -> None:
    files = {file: task, "arm/go.py": CODE["main.py"], "README.md": f"# Usage\n\n```\n{call}\n```\n"}
    assert plan_of(tmp_path, files)[0] == ("python", "arm/go.py")


NEEDS = "  sim:\n    deps: [{}]\n    cmds: [python main.py --fast]\n  bring: pip install einops\n"


@pytest.mark.parametrize(
    ("call", "file", "text"),
    [
        ("task sim", "Taskfile.yml", "tasks:\n" + NEEDS.format("bring")),
        ("task sim", "Taskfile.yml", "tasks:\n" + NEEDS.format("{task: bring}")),
        ("task sim", "Taskfile.yml", "tasks:\n" + NEEDS.format("all") + "  all:\n    deps: [bring, sim, all]\n"),
        (
            "poe sim",
            "pyproject.toml",
            "[tool.poe.tasks]\nbring = 'pip install einops'\nsim = {cmd = 'python main.py --fast', deps = ['bring']}\n",
        ),
    ],
)
def test_what_a_task_needs_is_run_before(tmp_path: Path, call: str, file: str, text: str) -> None:
    text = f"{PROJECT}{text}" if file == "pyproject.toml" else text
    command, pip = plan_of(tmp_path, {file: text, "README.md": f"# Usage\n\n```\n{call}\n```\n"})
    assert command == ("python", "main.py", "--fast")
    assert "einops" in pip


NESTED: dict[str, Any] = {"cmds": [""]}
for _ in range(90):
    NESTED = {"cmds": [NESTED] * 30}


@pytest.mark.parametrize(
    "tasks",
    [
        {**{f"a{n}": [f"a{n + 1}"] * 30 for n in range(30)}, "a30": "python main.py"},
        {f"a{n}": [f"a{n + 1}"] * 30 for n in range(30)},
        {"a0": NESTED},
        {f"a{n}": {"deps": [f"a{m}" for m in range(30)]} for n in range(30)},
    ],
    ids=["calls", "calls of nothing", "aliases", "needs"],
)
def test_hostile_tasks_take_no_long_time(tasks: dict[str, Any]) -> None:
    with ends():
        assert of_managers({"poe": tasks}).line_of("poe a0") is None


@pytest.mark.parametrize(
    ("call", "file", "text"),
    [
        ("poe sim", "pyproject.toml", "[tool.poe.tasks]\nsim = {script = 'demo.a:run'}\n"),
        ("poe sim", "pyproject.toml", "[tool.poe.tasks]\nsim = ['sim', 'go']\ngo = ['sim']\n"),
        ("poe other", "pyproject.toml", "[tool.poe.tasks]\nsim = 'python main.py'\n"),
        ("poe sim", "pyproject.toml", "[tool.poe.tasks\nsim = 'python main.py'\n"),
        ("task sim", "Taskfile.yml", "tasks: [\n"),
        ("task sim", "Taskfile.yml", "tasks:\n  sim: python {{.FILE}}\n"),
    ],
)
def test_a_call_of_what_is_not_known_starts_nothing(tmp_path: Path, call: str, file: str, text: str) -> None:
    command, _ = plan_of(tmp_path, {file: text, "README.md": f"# Usage\n\n```\n{call}\n```\n"})
    assert command == ("bash",)
