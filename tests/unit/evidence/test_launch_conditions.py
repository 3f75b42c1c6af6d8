"""Whether a part of a launch file is started by the defaults of its arguments."""

from __future__ import annotations

import re

import pytest

from hanging import ends
from roslab.evidence.ros.launch_conditions import started

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
        (ARG.format("$(eval 1)") + NODE.format('if="$(arg gui)"'), None),
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


SIM = '<arg name="sim" default="False"/><arg name="real" default="true"/><arg name="arm" default="ur5"/><arg name="x"/>'


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
        ("not (sim or real)", None),
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
