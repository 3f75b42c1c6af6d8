"""Whether a part of a launch file is started by the defaults of its arguments."""

from __future__ import annotations

import pytest

from roslab.evidence.ros.launch_conditions import started

ARG = '<arg name="gui" default="{}"/>'
NODE = '<node pkg="rviz" type="rviz" name="a" {}/>'
CALL = "Node(package='rviz', executable='rviz'{})"
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
        (CALL.format(""), True),
        (DECLARED.format("false") + CALL.format(", condition=IfCondition(LaunchConfiguration('gui'))"), False),
        (DECLARED.format("True") + CALL.format(", condition=IfCondition(LaunchConfiguration('gui'))"), True),
        (DECLARED.format("true") + CALL.format(", condition=UnlessCondition(LaunchConfiguration('gui'))"), False),
        (
            f"on = LaunchConfiguration('gui')\n{DECLARED.format('false')}{CALL.format(', condition=IfCondition(on)')}",
            False,
        ),
        (CALL.format(", condition=IfCondition(LaunchConfiguration('gui'))"), None),
        (CALL.format(", condition=IfCondition(PythonExpression(['1']))"), None),
    ],
)
def test_by_defaults(text: str, expected: bool | None) -> None:
    begin = text.index("rviz")
    assert started(text, begin, begin + 4) is expected
