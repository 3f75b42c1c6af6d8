"""How many arguments a program of C++ needs, by its main."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from roslab.evidence.native import argument_counts, cmake
from roslab.evidence.native.argument_counts import needed
from trees import tree_of

MAIN = "#include <ros/ros.h>\nint main(int argc, char **argv)\n{{\n    {}\n}}\n"


@pytest.mark.parametrize(
    ("body", "number", "said"),
    [
        ("System sys(argv[1]);", 1, "argv[1]"),
        ('ros::init(argc, argv, "demo");\n    System sys(argv[1], argv[2]);', 2, "argv[1]"),
        ("if (argc < 3) { usage(); return 1; }\n    run(argv[1]);", 2, "argc < 3"),
        ("if (argc != 2)\n        return -1;\n    run(argv[1]);", 1, "argc != 2"),
        ("if (argc <= 1) {\n  exit(1);\n}", 1, "argc <= 1"),
        ("if (argc < 2) throw std::runtime_error(usage);", 1, "argc < 2"),
        ('if (argc < 2) { puts("Usage: slam MAP"); return 0; }\n    run(argv[1]);', 1, "argc < 2"),
        ("#if 0\n    #if 1\n    #endif\n    if (argc < 2) return 1;\n    #endif\n    run(argv[1]);", 1, "argv[1]"),
        ("// if (argc < 2) return 1;\n    run(argv[1]);", 1, "argv[1]"),
        ("std::cout << argv[0];\n    run(argv[1]);", 1, "argv[1]"),
    ],
)
def test_what_it_needs(body: str, number: int, said: str) -> None:
    text = MAIN.format(body)
    found = needed(text)
    assert found is not None
    assert (found[0], found[2]) == (number, said)
    assert text[found[1] :].startswith(("if (", "argv["))


@pytest.mark.parametrize(
    "body",
    [
        "run();",
        'ros::init(argc, argv, "demo");',
        "std::cout << argv[0];",
        "// run(argv[1]);",
        "/* run(argv[1]); */",
        'if (argc < 2) { path = "a.yaml"; }\n    run(argv[1]);',
        'path = argc > 1 ? argv[1] : "a.yaml";',
        "if (argc > 1) run(argv[1]);",
        "if (argc != 1) { return 1; }",
        "if (argv[1]) run(argv[1]);",
        "if (argv[1] != nullptr) run(argv[1]);",
        "for (int i = 1; i < argc; i++) run(argv[i]);",
        "std::vector<std::string> all(argv, argv + argc);\n    run(argv[1]);",
        "gflags::ParseCommandLineFlags(&argc, &argv, true);\n    run(argv[1]);",
        'if (argc < 2) { puts("default"); run("demo.map"); return 0; }\n    run(argv[1]);',
        "if (argc < 2) { run(); exit(EXIT_SUCCESS); }\n    run(argv[1]);",
        "#if 0\n    if (argc < 2) return 1;\n    #else\n    run();\n    #endif",
        "char **next = argv;\n    run(argv[1]);",
    ],
)
def test_what_may_need_none(body: str) -> None:
    assert needed(MAIN.format(body)) is None


def test_comments_that_are_never_closed_take_no_time() -> None:
    start = time.monotonic()
    assert needed(MAIN.format("/* */" + "/* " * 80_000)) is None
    assert time.monotonic() - start < 2


def test_no_main() -> None:
    assert needed("int run(int argc, char **argv) { return use(argv[1]); }") is None
    assert needed("int main() { return use(argv[1]); }") is None


@pytest.mark.parametrize(
    ("files", "found"),
    [
        ({"src/slam.cc": MAIN.format("run(argv[1]);")}, [("src/slam.cc", 4, "1")]),
        ({"src/other.cc": MAIN.format("run(argv[1]);")}, []),
        ({"src/slam.cc": MAIN.format("run(argv[1]);"), "more/slam.cpp": MAIN.format("run();")}, []),
        ({"test/slam.cc": MAIN.format("run(argv[1]);")}, []),
    ],
)
def test_the_file_of_a_program(tmp_path: Path, files: dict[str, str], found: list[tuple[str, int, str]]) -> None:
    repository = tree_of(tmp_path, {"CMakeLists.txt": "project(a)\nadd_executable(slam src/slam.cc)\n", **files})
    told = argument_counts.read(repository, cmake.read(repository))
    assert [(each.file, each.line, each.value) for each in told] == found
