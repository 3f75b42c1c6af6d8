"""The summary of a run that stopped before anything was decided."""

from __future__ import annotations

from markdown_it import MarkdownIt

from roslab.github.steps import nothing_built


def test_every_problem_is_a_line_whose_marked_words_are_code() -> None:
    said = nothing_built(
        ['"linux/amd46" is no platform (did you mean `linux/amd64`?)', "<b>x</b> [y](https://evil.example)"]
    )
    rendered = MarkdownIt("commonmark").render(said)
    assert "<h3>❌ Nothing was built</h3>" in rendered
    assert "did you mean <code>linux/amd64</code>?" in rendered
    assert rendered.count("<li>") == 2
    assert "<b>" not in rendered
    assert "<a " not in rendered
