"""XML: what Python's own reader takes, lxml reads alike."""

from __future__ import annotations

import pytest

from roslab.evidence.lex import xml

WELL_FORMED = {
    "children": "<package format='3'>\n <name> a\n</name>\n <depend version_gte='1'>b</depend><c/>\n</package>",
    "comments": "<p><!-- one --><name>a<!-- two -->b</name>tail<c><!-- --></c></p>",
    "instructions": "<?xml version='1.0'?>\n<?xml-model href='a.xsd'?>\n<p><?go on?><name>a</name></p>",
    "references": "<p a='&lt;&#10;&quot;'>&amp;&#xe4;<![CDATA[<x> & ]]></p>",
    "attributes": "<p a='x\t\ty' b=\"it's >\"><c condition='$ROS_VERSION &gt; 1'/></p>",
    "characters": "<p>ä€😀\u0085\u2028\ufffd</p>",
    "depth": f"{'<a>' * 200}x{'</a>' * 200}",
}
OTHERS = {
    "entity": "<p>a&own;b</p>",
    "entities": '<!DOCTYPE p [<!ENTITY a "x"><!ENTITY b "&a;&a;">]><p>&b;</p>',
    "namespace": '<p xmlns:x="http://a.example/"><x:c x:d="1"/></p>',
    "prefix": "<p><x:c/></p>",
    "prefixed attribute": "<p x:a='1'/>",
    "encoding": "<?xml version='1.0' encoding='ISO-8859-1'?><p>ä</p>",
    "blank first": "\n<?xml version='1.0'?><p/>",
    "unclosed": "<p><name>a</name><depend>b</depend>",
    "mismatched": "<p>\n<name>a</nam>\n<depend>b</depend></p>",
    "ampersand": "<p><name>a & b</name></p>",
    "twice": "<p a='1' a='2'/>",
    "after": "<p/><q/>",
    "depth": f"{'<a>' * 400}x{'</a>' * 400}",
    "control": "<p>\x01</p>",
    "nothing": "",
    "text": "no XML",
}


def told(text: str) -> tuple[object, str | None]:
    root, problem = xml.parse(text)

    def plain(element: xml.Element) -> object:
        return element.tag, element.attributes, element.line, element.text, [plain(each) for each in element.children]

    return (plain(root) if root else None), problem


@pytest.mark.parametrize("name", WELL_FORMED)
def test_both_readers_agree(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    found, problem = told(WELL_FORMED[name])
    assert problem is None
    monkeypatch.setattr(xml, "MAX_DEPTH", 0)  # every document is lxml's
    assert told(WELL_FORMED[name]) == (found, None)


@pytest.mark.parametrize("name", OTHERS)
def test_what_is_not_plain_is_read_as_before(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    found = told(OTHERS[name])
    monkeypatch.setattr(xml, "MAX_DEPTH", 0)  # every document is lxml's
    assert told(OTHERS[name]) == found


def test_lines_and_paths() -> None:
    root, _ = xml.parse("<p>\n<name>a</name>\n<export>\n<build_type>b</build_type><x><name/></x></export></p>")
    assert root
    assert [(each.text, each.line) for each in root.below("export", "build_type")] == [("b", 4)]
    assert [each.line for each in root.all("name")] == [2, 4]
    assert not list(root.below("build_type"))


@pytest.mark.parametrize("version", ["1.1", "0.1.0"])
def test_a_package_s_own_version_in_the_declaration_is_no_error(version: str) -> None:
    """catkin and colcon read it with Python's own reader, too."""
    root, problem = xml.parse(f"<?xml version='{version}'?><package><name>a</name></package>")
    assert problem is None
    assert root is not None
    assert [each.text for each in root.below("name")] == ["a"]
