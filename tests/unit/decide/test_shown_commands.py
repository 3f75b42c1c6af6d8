"""How pages show the program that is meant: where it starts, in which terminal, in what section."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PROGRAM = "import numpy\nif __name__ == '__main__':\n    pass\n"
PYTHON = {"requirements.txt": "numpy\n"}


@pytest.mark.parametrize(
    ("argument", "started"),
    [
        ("--cfg cfgs/a.yaml", "cd tools && exec python run.py --cfg cfgs/a.yaml"),
        ("--cfg=./cfgs/a.yaml", "cd tools && exec python run.py --cfg=./cfgs/a.yaml"),
        ("cfg=cfgs/a.yaml", "cd tools && exec python run.py cfg=cfgs/a.yaml"),
        ("--cfg ../own/b.yaml cfgs/", "cd tools && exec python run.py --cfg ../own/b.yaml cfgs/"),
        ("--cfg=../own/b.yaml", "cd tools && exec python run.py --cfg=../own/b.yaml"),
        ("--cfg ../own/b.yaml", "cd tools && exec python run.py --cfg ../own/b.yaml"),
        ("--cfg gone/a.yaml --rate 0.5", ("python", "tools/run.py", "--cfg", "gone/a.yaml", "--rate", "0.5")),
        ("--cfg both/a.yaml", ("python", "tools/run.py", "--cfg", "both/a.yaml")),
    ],
)
def test_a_program_starts_where_its_arguments_are_found(tree: Tree, argument: str, started: object) -> None:
    names = ("tools/cfgs/a.yaml", "own/b.yaml", "tools/both/a.yaml", "both/a.yaml")
    files = {**PYTHON, "tools/run.py": PROGRAM, **dict.fromkeys(names, "rate: 1\n")}
    page = f"# Usage\n```\ncd tools\npython run.py {argument}\n```\n"
    assert tree({**files, "README.md": page}).command == started


@pytest.mark.parametrize(
    "path", ["export PYTHONPATH=src\n", "export PYTHONPATH=$PWD/src:$PYTHONPATH\n", "export PYTHONPATH=other\n", ""]
)
def test_a_module_below_a_folder_is_started_with_that_on_the_path(tree: Tree, path: str) -> None:
    files = {**PYTHON, "src/points/__init__.py": "", "src/points/align.py": PROGRAM, "src/points/show.py": PROGRAM}
    page = f"# Usage\n```\n{path}python -m points.align --fast\n```\n"
    decision = tree({**files, "other/a.txt": "", "README.md": page})
    assert decision.command == ("python", "-m", "points.align", "--fast")
    assert "src" in decision.python_path


@pytest.mark.parametrize(
    ("shown", "command"),
    [
        ("[terminal 1]$ {}", "launch"),
        ("[Terminal 2]$ {}", "launch"),
        ("Terminal 1: {}", "launch"),
        ("(shell #2) $ {}", "launch"),
        ("Usage: {}", "launch"),
        ("Usage {}", ""),
        ("usage: {}", ""),
        ("terminals 1: {}", ""),
        ("terminal one: {}", ""),
    ],
)
def test_the_name_of_a_terminal_or_usage_before_a_command_is_a_prompt(tree: Tree, shown: str, command: str) -> None:
    files = {
        "package.xml": "<package><name>demo</name><buildtool_depend>catkin</buildtool_depend></package>",
        "CMakeLists.txt": "project(demo)\nfind_package(catkin REQUIRED)\n",
        "launch/map.launch": "<launch/>",
        "launch/drive.launch": "<launch/>",
    }
    page = f"# Usage\n```\n[terminal 1]$ roscore\n{shown.format('roslaunch demo map.launch')}\n```\n"
    found = tree({**files, "README.md": page}).command
    assert found == (("roslaunch", "demo", "map.launch") if command else ("bash",))


@pytest.mark.parametrize(
    ("title", "config"),
    [("Inference on the test-set", "a"), ("Results on test splits", "a"), ("Testing", "b"), ("Unit tests", "b")],
)
def test_a_set_of_data_for_tests_is_no_test(tree: Tree, title: str, config: str) -> None:
    page = f"# Usage\n## {title}\n`python main.py --rate a`\n## Training\n`python main.py --rate b`\n"
    assert tree({**PYTHON, "main.py": PROGRAM, "README.md": page}).command == ("python", "main.py", "--rate", config)


@pytest.mark.parametrize(
    ("title", "program"),
    [
        ("Quick start", "eval"),
        ("Quickstart", "eval"),
        ("Demo", "eval"),
        ("Quick start / Evaluation", "train"),
        ("Results", "train"),
        ("Benchmark demo", "train"),
    ],
)
def test_a_quick_start_may_evaluate_what_is_trained_already(tree: Tree, title: str, program: str) -> None:
    first, _, second = title.partition(" / ")
    page = f"# {first}\n" + (f"## {second}\n" if second else "") + "`python eval.py --fast`\n"
    page += "# Training\n`python train.py --rate 1`\n"
    found = tree({**PYTHON, "eval.py": PROGRAM, "train.py": PROGRAM, "README.md": page}).command
    assert found[1] == f"{program}.py"


RUN = "docker run --rm -it --gpus all -v $PWD:/data"


@pytest.mark.parametrize(
    ("lines", "command"),
    [
        (f"{RUN} lab/demo python align.py --fast", ("python", "align.py", "--fast")),
        (f"{RUN} <image> python3 align.py --fast", ("python3", "align.py", "--fast")),
        (f'{RUN} lab/demo:1 bash -c "cd /app && python align.py --fast"', ("python", "align.py", "--fast")),
        ("sudo docker exec -it demo python align.py --fast", ("python", "align.py", "--fast")),
        ("docker compose run --rm demo python align.py --fast", ("python", "align.py", "--fast")),
        (f"{RUN} --name python lab/demo", ("bash",)),
        (f"{RUN} lab/demo python gone.py", ("bash",)),
        (f"{RUN} lab/demo bash", ("bash",)),
        (f"{RUN} lab/demo python show.py\n```\n# Results\n```\npython align.py", ("python", "align.py")),
    ],
)
def test_what_a_page_starts_only_in_a_container_is_started(tree: Tree, lines: str, command: tuple[str, ...]) -> None:
    files = {**PYTHON, "align.py": PROGRAM, "show.py": PROGRAM}
    assert tree({**files, "README.md": f"# Run\n```\n{lines}\n```\n"}).command == command


def test_what_a_page_starts_in_a_container_leaves_pages_below_theirs(tree: Tree) -> None:
    files = {**PYTHON, "align.py": PROGRAM, "show.py": PROGRAM, "points/README.md": "# Run\n`python align.py --fast`\n"}
    page = f"# Run\n```\n{RUN} lab/demo python show.py\n```\n"
    assert tree({**files, "README.md": page}).command == ("python", "align.py", "--fast")


@pytest.mark.parametrize(
    ("page", "file", "started"),
    [
        ("cd tools\npython run.py", "tools/lib/names.py", "cd tools && exec python run.py"),
        ("cd tools && python run.py", "tools/lib/more/names.py", "cd tools && exec python run.py"),
        ("cd tools\npython run.py", "tools/third_party/names.py", ("python", "tools/run.py")),
        ("cd tools\npython run.py", "lib/names.py", ("python", "tools/run.py")),
        ("python tools/run.py", "tools/lib/names.py", ("python", "tools/run.py")),
    ],
)
def test_a_program_starts_where_its_own_packages_find_their_files(
    tree: Tree, page: str, file: str, started: object
) -> None:
    files = {**PYTHON, "tools/run.py": PROGRAM, "tools/cfgs/a.yaml": "rate: 1\n", file: "A = 'cfgs/a.yaml'\n"}
    assert tree({**files, "README.md": f"# Usage\n```\n{page}\n```\n"}).command == started


PREDICTS = "#!/bin/bash\nset -e\nexport OUT=out\npython -m net.predict --test\n"


@pytest.mark.parametrize(
    ("script", "command"),
    [
        (PREDICTS, ("bash", "scripts/test_demo.sh")),
        ("CUDA_VISIBLE_DEVICES=0 python3 $1 --eval\n", ("bash", "scripts/test_demo.sh")),
        ("python -m pytest tests\n", ("bash", "scripts/train.sh")),
        ("python setup.py test\n", ("bash", "scripts/train.sh")),
        ("pytest\n", ("bash", "scripts/train.sh")),
        ("# python net/predict.py\necho ok\n", ("bash", "scripts/train.sh")),
    ],
)
def test_a_script_named_like_a_test_that_starts_a_program_of_python(
    tree: Tree, script: str, command: tuple[str, ...]
) -> None:
    page = "# Demo\n```\nbash scripts/test_demo.sh\n```\n# Training\n```\nbash scripts/train.sh\n```\n"
    files = {
        "net/predict.py": "import numpy\n",
        "scripts/test_demo.sh": script,
        "scripts/train.sh": "python net/a.py\n",
    }
    assert tree({**files, "README.md": page}).command == command


def test_such_a_script_of_compiled_code_is_a_test(tree: Tree) -> None:
    page = "# Demo\n```\nbash scripts/run_test.sh\nbash scripts/run_all.sh\n```\n"
    cmake = "cmake_minimum_required(VERSION 3.5)\nproject(align CXX)\nadd_executable(align a.cpp)\n"
    files = {"CMakeLists.txt": cmake, "a.cpp": "int main() {}\n", "scripts/run_all.sh": "python plot.py\n"}
    found = tree({**files, "scripts/run_test.sh": "python check.py\n", "README.md": page})
    assert found.command == ("bash", "scripts/run_all.sh")


SEVERAL = ("demo/small/run.py", "demo/large/run.py", "demo/large/old/run.py")


@pytest.mark.parametrize(
    ("page", "started"),
    [
        ("cd demo/large\npython run.py", ("python", "demo/large/run.py")),
        (
            "git clone https://github.com/lab/own.git\ncd own\ncd demo/small\npython run.py",
            ("python", "demo/small/run.py"),
        ),
        ("cd demo\npython run.py", ("bash",)),
    ],
)
def test_of_several_of_a_name_the_one_where_the_page_went(tree: Tree, page: str, started: tuple[str, ...]) -> None:
    files = {**PYTHON, **dict.fromkeys(SEVERAL, PROGRAM), "README.md": f"# Usage\n```\n{page}\n```\n"}
    assert tree(files).command == started


STARTS = "mkdir -p logs\npython train.py fit --config configs/a.yaml > logs/a.txt\nPORT=1 python3 -u tools/check.py\n"
LABELS = ("labels/train.py", "labels/tools/check.py", "labels/configs/a.yaml")


@pytest.mark.parametrize(
    ("text", "more", "page", "started"),
    [
        (STARTS, (), "Then execute [run.sh](labels/run.sh).", "cd labels && exec bash run.sh"),
        (STARTS, (), "```\nbash labels/run.sh\n```", "cd labels && exec bash run.sh"),
        (STARTS, (), "```\nbash labels/run.sh labels/configs/a.yaml\n```",
         ("bash", "labels/run.sh", "labels/configs/a.yaml")),
        (STARTS, ("train.py",), "```\nbash labels/run.sh\n```", ("bash", "labels/run.sh")),
        ("cd $(dirname $0)\n" + STARTS, (), "```\nbash labels/run.sh\n```", ("bash", "labels/run.sh")),
        (STARTS + "python gone.py\n", (), "```\nbash labels/run.sh\n```", ("bash", "labels/run.sh")),
        ("python labels/train.py\n", (), "```\nbash labels/run.sh\n```", ("bash", "labels/run.sh")),
    ],
)  # fmt: skip
def test_a_script_starts_where_all_that_it_starts_lies(
    tree: Tree, text: str, more: tuple[str, ...], page: str, started: object
) -> None:
    files = {**PYTHON, **dict.fromkeys((*LABELS, *more), PROGRAM), "labels/run.sh": text}
    assert tree(files | {"README.md": f"# Running the code\n{page}\n"}).command == started
