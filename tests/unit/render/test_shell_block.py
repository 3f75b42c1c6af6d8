"""Which code blocks are shell for the image, and what of them is typed."""

from __future__ import annotations

import pytest

from roslab.render.shell_block import Step, steps


def typed(info: str, content: str) -> list[str]:
    return [step.text for step in steps(info, content) if step.typed]


@pytest.mark.parametrize("info", ["bash", "sh", "shell", "Bash", "{.bash}", "{bash}", "zsh", 'bash title="x"', " sh "])
def test_a_block_that_says_it_is_shell(info: str) -> None:
    assert typed(info, "./run_everything --now\n# then\n\nfrobnicate\n") == [
        "./run_everything --now\n# then\n\nfrobnicate"
    ]


@pytest.mark.parametrize(
    "info", ["python", "cpp", "c++", "text", "yaml", "xml", "output", "dockerfile", "powershell", "bat"]
)
def test_a_block_of_another_language(info: str) -> None:
    assert steps(info, "cd x\nmake\n") == ()


@pytest.mark.parametrize(
    "content",
    [
        "roslaunch vins_estimator euroc.launch\n",
        "cd ~/catkin_ws && catkin_make\nsource devel/setup.bash\n",
        "mkdir build; cd build\ncmake .. \\\n  -DCMAKE_BUILD_TYPE=Release\n",
        "./demo --fast\n",
        "CUDA_VISIBLE_DEVICES=0 python3 train.py\n",
        "# build it\ncolcon build\n",
        "../build/demo\n",
        "make build\n./run.sh euroc.launch   # takes long\n",
        "experiments/train.py --map loop\n",
    ],
)
def test_a_block_without_a_language_that_is_all_commands(content: str) -> None:
    assert typed("", content) == [content.strip("\n")]


@pytest.mark.parametrize(
    "content",
    [
        "[ INFO] [1700000000.12]: I heard: hello\n",
        "cmake >= 3.5\npython 3.6\n",
        "src/\n  robot/\n    package.xml\n",
        "x = f(y)\n",
        ">>> import demo\n>>> demo.run()\n",
        "error of the measurements: 0.201\n",
        "cd build\nResult: 0.2\n",
        "",
        "\n\n",
        "# only a comment\n",
    ],
)
def test_a_block_without_a_language_that_is_something_else(content: str) -> None:
    assert steps("", content) == ()


@pytest.mark.parametrize(
    "prompt",
    [
        "$ ",
        "  $ ",
        "user@host:~/ws$ ",
        "root@0a1b2c:/# ",
        "(venv) $ ",
        "(base) me@pc:~$ ",
        "[me@pc ws]$ ",
        "(base)[ws]$ ",
        "~/ws$ ",
        "$ ../src> ",
        "C:\\ws\\src> ",
    ],
)
@pytest.mark.parametrize("info", ["", "bash", "console"])
def test_prompts_are_stripped(info: str, prompt: str) -> None:
    assert typed(info, f"{prompt}cd src\n{prompt}frobnicate --now\n") == ["cd src\nfrobnicate --now"]


def test_what_came_back_is_text() -> None:
    content = "$ ls\nREADME.md\nsrc\n\n$ pwd\n/home/me\n"
    assert steps("console", content) == (
        Step(typed=True, text="ls"),
        Step(typed=False, text="README.md\nsrc"),
        Step(typed=True, text="pwd"),
        Step(typed=False, text="/home/me"),
    )


@pytest.mark.parametrize(
    ("content", "wanted"),
    [
        ("$ cmake .. \\\n>   -DX=1\ndone\n", "cmake .. \\\n  -DX=1"),
        ("$ cmake .. \\\n    -DX=1\ndone\n", "cmake .. \\\n    -DX=1"),
        ("$ make &&\n> ./demo\ndone\n", "make &&\n./demo"),
        ("$ for i in 1 2; do\n> echo $i\n> done\n", "for i in 1 2; do\necho $i"),
        ("$ echo 'a\n> b'\nout\n", "echo 'a\nb'"),
        ("$ cat <<EOF\n> a\n> EOF\nout\n", "cat <<EOF\na\nEOF"),
        ("$ make  # don't stop\nout\n", "make  # don't stop"),
    ],
)
def test_a_command_over_several_lines(content: str, wanted: str) -> None:
    assert typed("console", content)[0] == wanted


def test_margins_and_tabs_go() -> None:
    """In a notebook a tab asks bash for a completion."""
    assert typed("", "\tcd x\n\tcatkin build\n\n") == ["cd x\ncatkin build"]
    assert typed("sh", "if x; then\n\tmake\nfi") == ["if x; then\n    make\nfi"]
    assert typed("sh", "cat <<-END\n\ta\n\tEND") == ["cat <<-END\n\ta\n\tEND"]


def test_root_prompts_where_nothing_else_marks_a_command() -> None:
    assert typed("console", "# rosrun a b\nok\n") == ["rosrun a b"]
    assert typed("console", "# a comment\n$ rosrun a b\n") == ["# a comment\nrosrun a b"]
    assert typed("bash", "# make it\nmake\n") == ["# make it\nmake"]


def test_a_session_without_a_prompt_is_output_unless_it_is_all_commands() -> None:
    assert steps("console", "Loading map\nDone\n") == ()
    assert typed("console", "rosrun a b\n") == ["rosrun a b"]


@pytest.mark.parametrize(
    "content",
    [
        "docker build -t x .\ndocker run x\n",
        "git clone https://example.org/x && cd x && docker compose up\n",
        "./docker_run.sh --notebook\n",
        "roslab create\n",
        "xhost +local:\n",
    ],
)
def test_what_needs_a_program_around_the_image_is_text(content: str) -> None:
    assert steps("bash", content) == ()


def test_what_only_root_does_is_text_but_not_what_follows_it() -> None:
    assert steps("bash", "sudo apt-get install libeigen3-dev\nsudo ldconfig\n") == ()
    mixed = "sudo apt install libeigen3-dev\nmake\n./demo"
    assert typed("bash", mixed) == [mixed]


def test_a_long_block_takes_no_long_time() -> None:
    assert steps("", "x " * 50_000) == ()
    assert steps("console", "$ a 'b\n" * 2_000)
