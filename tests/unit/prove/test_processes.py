"""What ``docker top`` shows of a container, from one look to the next."""

from __future__ import annotations

from roslab.prove.processes import Census, read

HEAD = "PID PPID COMMAND\n"
LAUNCH = "11 10 /usr/bin/python3 /opt/ros/noetic/bin/roslaunch robot all.launch\n"


def seen(*looks: str) -> Census:
    census = Census()
    for look in looks:
        census.take(read(HEAD + "10 1 /sbin/docker-init -- x\n" + look))
    return census


def node(number: int, parent: int = 11) -> str:
    return f"{number} {parent} python3 /ws/talker __name:=talker __log:=/root/.ros/log/talker-2.log\n"


def test_a_launch_starts_a_node_anew() -> None:
    assert seen(LAUNCH, LAUNCH + node(20), LAUNCH + node(21), LAUNCH + node(22)).respawned == (
        "talker was started anew 2 times",
    )


def test_a_launch_that_waits_before_it_starts_a_node_anew() -> None:
    assert seen(LAUNCH + node(20), LAUNCH, LAUNCH, LAUNCH + node(21)).respawned == ("talker was started anew 1 time",)


def test_a_launch_of_ros_2_too() -> None:
    launch = "11 10 /usr/bin/python3 /opt/ros/jazzy/bin/ros2 launch robot all.launch.py\n"
    look = launch + "{} 11 /ws/talker --ros-args -r __node:=says\n"
    assert seen(look.format(20), look.format(21)).respawned == ("says was started anew 1 time",)


def test_nodes_that_live_and_new_ones() -> None:
    census = seen(LAUNCH + node(20), LAUNCH + node(20) + node(21), LAUNCH + node(20))
    assert (census.respawned, census.restarted) == ((), ())


def test_a_loop_of_a_shell() -> None:
    loop = "11 10 bash loop.sh\n"
    census = seen(loop + "20 11 python3 node.py\n", loop + "21 11 python3 node.py\n")
    assert census.respawned == ()
    assert census.restarted == ("python3 node.py was started anew 1 time",)


ENTRY_POINT = "11 10 bash /usr/local/bin/roslab-entrypoint ros2 launch robot all.launch.py\n"
BECOME = "11 10 /usr/bin/python3 /opt/ros/jazzy/bin/ros2 launch robot all.launch.py\n"


def setup(number: int) -> str:
    return f"{number} 11 /usr/bin/python3 /usr/bin/register-python-argcomplete rosidl\n"


def test_what_an_entry_point_runs_before_it_becomes_a_launch_is_none_of_the_launch() -> None:
    """Each workspace's setup.bash asks for the completion of the same commands."""
    census = seen(ENTRY_POINT + setup(20), ENTRY_POINT + setup(21), BECOME, BECOME + node(30))
    assert (census.respawned, census.restarted) == ((), ())


def test_a_shell_that_runs_a_launch_is_no_launch() -> None:
    loop = "11 10 bash -c while true; do ros2 launch robot all.launch.py; done\n"
    census = seen(loop + node(20), loop + node(21))
    assert census.respawned == ()
    assert census.restarted == ("talker was started anew 1 time",)


def test_the_nodes_of_a_launch_after_its_entry_point() -> None:
    looks = ENTRY_POINT + setup(20), BECOME + node(30), BECOME + node(31)
    assert seen(*looks).respawned == ("talker was started anew 1 time",)


def test_what_the_engine_started_beside_the_command_is_none_of_it() -> None:
    probe = "90 5 python3 -\n91 5 python3 -\n"
    assert seen(LAUNCH + "90 5 python3 -\n", LAUNCH + probe[len(probe) // 2 :]).restarted == ()


def test_what_is_no_table() -> None:
    assert read("error: no such container") == {}
