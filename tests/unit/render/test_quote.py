"""The one quoting: what a shell or BuildKit makes of a quoted value is the value again."""

from __future__ import annotations

import json
import subprocess

import pytest

from roslab.errors import ConfigurationError
from roslab.render import quote

HOSTILE = [
    "",
    "plain",
    "two words",
    "a; rm -rf ~",
    "$(touch /tmp/owned)",
    "`touch /tmp/owned`",
    "$HOME ${HOME}",
    "it's",
    'say "hi"',
    "back\\slash\\",
    "~",
    "*",
    "# no comment",
    "-n",
    "a&&b|c>d<e",
    "{a,b}!",
    "grün ✓",
]
WITHOUT_FACE = ["a\nb", "a\rb", "a\0b", "a\tb", "a\x1b[31m", "a\x7f", "a\u202eb", "a\u2028b", "a\udcff"]


@pytest.mark.parametrize("text", HOSTILE)
def test_a_shell_reads_the_word_again(text: str) -> None:
    script = f"printf '%s\\0' {quote.words(['x', text, text])}; printf '%s\\0' {quote.shell(text)}"
    answer = subprocess.run(["bash", "-c", script], capture_output=True, check=True).stdout.decode()
    assert answer.split("\0")[:-1] == ["x", text, text, text]


def test_a_program_named_like_an_assignment_is_no_assignment() -> None:
    answer = subprocess.run(["bash", "-c", quote.words(["A=b"])], capture_output=True, check=False)
    assert answer.returncode == 127


@pytest.mark.parametrize("text", HOSTILE)
def test_only_the_users_name_is_filled_into_a_path(text: str) -> None:
    word = quote.shell_with_user("/home/${NB_USER}/" + text)
    script = f"NB_USER='j o'; printf '%s' {word}"
    answer = subprocess.run(["bash", "-c", script], capture_output=True, check=True).stdout.decode()
    assert answer == ("/home/j o/" + text if word.startswith('"') else answer)
    assert text in answer


def buildkit(text: str, variables: dict[str, str]) -> str:
    """Expand one word of a Dockerfile by the rules of BuildKit's shell/lex.go, as this test reads them."""
    result, quoted, index = "", "", 0
    while index < len(text):
        c = text[index]
        if quoted == "'":
            quoted, result = ("", result) if c == "'" else (quoted, result + c)
        elif c == "\\" and index + 1 < len(text):
            index += 1
            keep = quoted == '"' and text[index] not in '"$\\'
            result += ("\\" if keep else "") + text[index]
        elif c == '"':
            quoted = "" if quoted else '"'
        elif c == "'" and not quoted:
            quoted = "'"
        elif c == "$":
            assert text[index + 1] == "{", f"a variable in {text!r}"
            end = text.index("}", index)
            result += variables[text[index + 2 : end]]
            index = end
        else:
            result += c
        index += 1
    assert not quoted
    return result


@pytest.mark.parametrize("text", HOSTILE)
def test_buildkit_reads_the_value_again(text: str) -> None:
    assert buildkit(quote.docker(text), {}) == text
    assert buildkit(quote.docker_path("/home/${NB_USER}/" + text), {"NB_USER": "jovyan"}) == f"/home/jovyan/{text}"
    assert json.loads(quote.json_form([text, "x"])) == [text, "x"]


def test_wildcards_in_a_copied_name_are_letters() -> None:
    source, target = json.loads(quote.copy(["data [1]*.txt"], "/home/${NB_USER}/$x"))
    assert buildkit(source, {}) == "data [[]1][*].txt"
    assert buildkit(target, {"NB_USER": "u"}) == "/home/u/$x"


@pytest.mark.parametrize("text", WITHOUT_FACE)
def test_what_no_quoting_survives_is_an_error(text: str) -> None:
    functions = (
        quote.shell,
        quote.docker,
        quote.docker_path,
        quote.path,
        quote.shell_with_user,
        lambda t: quote.json_form([t]),
        lambda t: quote.words([t]),
        lambda t: quote.copy([t], "/x"),
        quote.image,
    )
    for function in functions:
        with pytest.raises(ConfigurationError) as caught:
            function(text)
        assert caught.value.exit_code == 2
        assert str(caught.value).isprintable()


def test_a_path_is_no_option() -> None:
    assert quote.path("--target") == "./--target"
    assert quote.path("a/-b") == "a/-b"


@pytest.mark.parametrize(
    "reference",
    [
        "ubuntu",
        "ubuntu:24.04",
        "ghcr.io/org/name:1.0",
        "localhost:5000/a/b@sha256:" + "a" * 64,
        "ros:noetic-ros-base@sha256:" + "0" * 64,
        "nvcr.io/nvidia/l4t-base:r32.4.3",
    ],
)
def test_a_reference(reference: str) -> None:
    assert quote.image(reference) == reference


@pytest.mark.parametrize("reference", ["", "a b", "$BASE", "--platform=x", "a AS b", "org/Name", "a:b:c", "a@b", "a\\"])
def test_no_reference(reference: str) -> None:
    with pytest.raises(ConfigurationError, match="is no image reference"):
        quote.image(reference)
