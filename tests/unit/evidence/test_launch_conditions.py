"""Whether a part of a launch file is started by the defaults of its arguments."""

from __future__ import annotations

import re

import pytest

from hanging import ends
from roslab.evidence.ros.launch_conditions import decided_by, holds, kept_by, started

ARG = '<arg name="gui" default="{}"/>'
NODE = '<node pkg="rviz" type="rviz" name="a" {}/>'
CALL = "Node(package='rviz', executable='rviz'{})"
PASSED = '<include file="a.launch"><arg name="gui" value="{}"/></include>'
UNLESS = ", condition=UnlessCondition(LaunchConfiguration('gui'))"
ON = ", condition=IfCondition(LaunchConfiguration('gui'))"
DECLARED = "DeclareLaunchArgument('gui', default_value='{}')\n"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (NODE.format(""), True),
        (ARG.format("false") + NODE.format('if="$(arg gui)"'), False),
        (ARG.format("true") + NODE.format('if="$(arg gui)"'), True),
        (ARG.format("true") + NODE.format('unless="$(arg gui)"'), False),
        ('<arg name="gui"/>' + NODE.format('if="$(arg gui)"'), None),
        (ARG.format("$(eval 1)") + NODE.format('if="$(arg gui)"'), True),
        (ARG.format("$(eval 1 + x)") + NODE.format('if="$(arg gui)"'), None),
        (ARG.format("true") + ARG.format("false") + NODE.format('if="$(arg gui)"'), None),
        (ARG.format("false") + '<group if="$(var gui)"><group ns="a">' + NODE.format("") + "</group></group>", False),
        (ARG.format("false") + '<group if="$(arg gui)"></group>' + NODE.format(""), True),
        (ARG.format("false") + PASSED.format("$(arg gui)") + NODE.format('if="$(arg gui)"'), False),
        (ARG.format("false") + PASSED.format("true") + NODE.format('if="$(arg gui)"'), False),
        (ARG.format("false") + ARG.format("$(arg gui)") + NODE.format('if="$(arg gui)"'), False),
        (PASSED.format("true") + NODE.format('if="$(arg gui)"'), None),
        (CALL.format(""), True),
        (DECLARED.format("false") + CALL.format(", condition=IfCondition(LaunchConfiguration('gui'))"), False),
        (DECLARED.format("True") + CALL.format(", condition=IfCondition(LaunchConfiguration('gui'))"), True),
        (DECLARED.format("true") + CALL.format(", condition=UnlessCondition(LaunchConfiguration('gui'))"), False),
        (
            f"on = LaunchConfiguration('gui')\n{DECLARED.format('false')}{CALL.format(', condition=IfCondition(on)')}",
            False,
        ),
        (CALL.format(", condition=IfCondition(LaunchConfiguration('gui'))"), None),
        (DECLARED.format("false") + CALL.format("") + f", TimerAction(period=1.0, actions=[a]{ON})", True),
        (DECLARED.format("false") + f"LifecycleNode(name='a'{ON}), " + CALL.format(""), True),
        (DECLARED.format("false") + f"GroupAction(actions=[{CALL.format('')}]{ON})", False),
        (DECLARED.format("true") + f"GroupAction(actions=[{CALL.format(UNLESS)}]{ON})", False),
        (DECLARED.format("true") + f"GroupAction(actions=[Node(){UNLESS}]); {CALL.format(ON)}", True),
        (DECLARED.format("false") + CALL.format(f", name='a)'  # all (\n{ON}"), False),
        (CALL.format(", condition=IfCondition(PythonExpression(['1']))"), None),
    ],
)
def test_by_defaults(text: str, expected: bool | None) -> None:
    begin = text.index("rviz")
    assert started(text, begin, begin + 4) is expected


SIM = (
    '<arg name="sim" default="False"/><arg name="real" default="true"/><arg name="arm" default="ur5"/><arg name="x"/>'
    '<arg name="number" default="3"/><arg name="empty" default=""/><arg name="other" value="$(arg arm)"/>'
    """<arg name="derived" value="$(eval arg('arm') == 'ur5')"/><arg name="loop" value="$(eval not arg('loop'))"/>"""
)


@pytest.mark.parametrize(
    ("condition", "expected"),
    [
        ("arg('sim')", False),
        ("not arg('sim')", True),
        ("not sim", True),
        ("not not sim", False),
        ("not arm == 'ur5'", False),
        ("not arm != 'ur5'", True),
        ("arg('real') and not sim", True),
        ("real and sim", False),
        ("x and sim", False),
        ("x and real", None),
        ("x or real", True),
        ("sim or x", None),
        ("sim or arm == 'ur3'", False),
        ("sim and x or arm == 'ur5'", True),
        ("sim == 'false' or sim == 'False'", False),
        ("arm == 'UR5'", False),
        ("arm and number and real", True),
        ("not (sim or real)", False),
        ("not (sim or x)", None),
        ("(sim or arm == 'ur5') and not (x and sim)", True),
        ("arg('arm') in ['ur3', 'ur5']", True),
        ("arm not in ('ur3', 'ur5')", False),
        ("number == 3", True),
        ("arg('number') != 3 or 1 < number <= 2.5", False),
        ("empty == ''", True),
        ("empty != '' and real", False),
        ("len(arg('arm')) &gt; 2", True),
        ("arm == other", True),
        ("'on' if x else 'off'", None),
        ("true if real else false", True),
        ("arm", None),
        ("derived", True),
        ("not derived or sim", False),
        ("loop", None),
        ("&quot;'$(var arm)' == 'ur5'&quot;", True),
        (r"'\'$(var arm)\' == \'ur3\''", False),
        ("'$(var arm)' == 'ur5' and $(var real)", True),
        ("env('HOME') == ''", None),
        ("().__class__", None),
        ("real and", None),
        ("9 ** 9 ** 9", None),
        ("x", None),
        ("nowhere", None),
    ],
)
def test_what_is_evaluated(condition: str, expected: bool | None) -> None:
    for word, turned in (("if", False), ("unless", True)):
        text = SIM + NODE.format(f'{word}="$(eval {condition})"')
        begin = text.index("rviz")
        wanted = expected if expected is None or not turned else not expected
        assert started(text, begin, begin + 4) is wanted


@pytest.mark.parametrize(
    ("condition", "expected"),
    [
        ("$(not $(var sim))", True),
        ("$(and $(var real) $(not $(var sim)))", True),
        ("$(or $(var sim) $(var x))", None),
        ("$(any $(var x) $(var real))", True),
        ("$(all $(var sim) $(var x))", False),
        ("$(equals $(var arm) ur5)", True),
        ("$(not-equals $(var arm) 'UR5')", False),
        ("$(equals $(var sim) false)", True),
        ("$(not $(var derived))", False),
        ("$(not)", None),
        ("$(and $(var real) $(not $(var sim))", None),
        ("$(not $(find sim))", None),
        ("$(eval '$(var real)' in ['true', 'yes'])", True),
        ("$(eval '$(var sim)' in ['true', 'yes'])", False),
    ],
)
def test_substitutions_of_ros_2(condition: str, expected: bool | None) -> None:
    text = SIM + NODE.format(f'if="{condition}"')
    begin = text.index("rviz")
    assert started(text, begin, begin + 4) is expected


def test_what_a_command_gives_decides() -> None:
    text = SIM + """<group if="$(eval (arg('arm') == 'ur3' or derived) and not sim)"><node pkg="rviz"/></group>"""
    conditions = decided_by(text, text.index("rviz"), text.index("rviz"))
    cases: tuple[tuple[dict[str, str], bool], ...] = (
        ({}, True),
        ({"arm": "ur3"}, True),
        ({"arm": "ur10"}, False),
        ({"sim": "true"}, False),
    )
    assert [all(holds(when, given) for when in conditions) for given, _ in cases] == [expected for _, expected in cases]
    assert kept_by(text, text.index("rviz"), text.index("rviz")) == ()


def test_one_of_two_is_enough() -> None:
    text = SIM + NODE.format('if="$(eval sim or empty)"')
    (when,) = decided_by(text, text.index("rviz"), text.index("rviz"))
    assert [holds(when, given) for given in ({}, {"sim": "true"}, {"empty": "1"})] == [None, True, True]


@pytest.mark.parametrize(
    ("condition", "expected"),
    [
        ("$(arg sim)", {"sim": "false"}),
        ("$(eval number in [1, 2])", {"number": "3"}),
        ("$(eval other == 'ur3')", {"other": "ur5", "arm": "ur5"}),
        ("$(eval not (derived))", {"derived": "true", "arm": "ur5"}),
        ("$(eval real and sim)", {"sim": "false"}),
        ("$(eval real and x)", {}),
        ("$(arg real)", {}),
    ],
)
def test_arguments_that_keep_it(condition: str, expected: dict[str, str]) -> None:
    text = SIM + NODE.format(f'if="{condition}"')
    place = text.index("rviz")
    assert dict(kept_by(text, place, place)) == expected


def test_deep_and_long_expressions_end() -> None:
    chained = "".join(f"<arg name='a{n}' value='$(eval a{n + 1} and a{n + 1} or a{n + 1})'/>" for n in range(3000))
    for condition in ("a0", "(" * 190 + "x" + ")" * 190, "not " * 90 + "x", "[" * 300):
        text = chained + NODE.format(f'if="$(eval {condition})"')
        place = text.index('"rviz"')
        with ends():
            assert started(text, place, place + 4) is None


@pytest.mark.parametrize(
    "text",
    [
        ARG.format("true") + f'<group if="$(arg gui)">{NODE.format("")}</group>\n' * 6000,
        DECLARED.format("true") + f"{CALL.format(ON)},\n" * 6000,
    ],
    ids=["groups", "calls"],
)
def test_many_conditions(text: str) -> None:
    """Each name once looked through the whole file."""
    with ends():
        assert all(started(text, match.start(), match.end()) for match in re.finditer("rviz", text))
