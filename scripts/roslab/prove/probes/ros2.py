"""Watches a ROS 2 graph from inside a container and prints what it saw so far, a JSON object a line.

It needs the image's own rclpy and the messages' Python modules, and hides its node, as ros2cli hides its daemon.
https://docs.ros.org/en/jazzy/p/rclpy/
"""

import glob
import json
import os
import subprocess
import sys
import time

NAME = "_roslab_proof"
MARK = "ROSLAB_PROBE"
"""A variable that only this program has, once it has those of the repository's processes."""
PAUSE = 0.3
ASKED = "/list_parameters"
"""A service that every node of rclcpp and rclpy has, and that has no effect."""


def environment():
    """Return the variables of the newest process of the container that knows ROS 2, ``None`` if there is none yet."""
    for path in sorted(glob.glob("/proc/[0-9]*/environ"), key=lambda path: -int(path.split("/")[2])):
        try:
            with open(path, "rb") as stream:
                text = stream.read().decode("utf-8", "replace")
        except OSError:
            continue
        found = dict(pair.split("=", 1) for pair in text.split("\0") if "=" in pair)
        if "AMENT_PREFIX_PATH" in found and MARK not in found:
            return found
    return None


def say(seen, start):
    """Print what was seen so far."""
    seen["seconds"] = round(time.time() - start, 1)
    sys.stdout.write(json.dumps(seen) + "\n")
    sys.stdout.flush()


def begin():
    """Become this same program with the variables of the repository's processes, as soon as there are any."""
    start = time.time()
    found = environment()
    while found is None:
        say({"problem": "no process of the command knows ROS 2"}, start)
        time.sleep(PAUSE)
        found = environment()
    with open("/proc/self/cmdline") as stream:
        words = stream.read().split("\0")[:-1]
    os.execvpe(words[0], words, dict(found, **{MARK: "1"}))


class Watcher:
    """Subscribes to every topic as soon as it is there, with what its publishers offer."""

    def __init__(self):
        import rclpy

        self.rclpy = rclpy
        rclpy.init(args=[])
        self.node = rclpy.create_node(NAME, start_parameter_services=False, enable_rosout=False)
        self.messages = {}
        self.types = {}
        self.subscriptions = {}
        self.publishers = {}
        self.asked = {}
        self.clients = {}
        self.answered = set()
        self.seen = {"nodes": [], "services": []}

    def look(self):
        """Return all that was ever seen."""
        nodes = {(space.rstrip("/") + "/" + name) for name, space in self.node.get_node_names_and_namespaces()}
        services = dict(self.node.get_service_names_and_types())
        self.seen["nodes"] = sorted(set(self.seen["nodes"]) | nodes)
        self.seen["services"] = sorted(set(self.seen["services"]) | set(services))
        for topic, types in self.node.get_topic_names_and_types():
            self.listen(topic, types[0])
        for name in nodes:
            if name + ASKED in services and name not in self.asked:
                self.ask(name)
        self.answered |= {name for name, future in self.asked.items() if future.done()}
        topics = [self.told(topic) for topic in sorted(self.types)]
        return dict(self.seen, answered=sorted(self.answered), topics=topics)

    def told(self, topic):
        """Return a topic; ROS 2 does not say which publisher a message came from: where a bag is played, from it."""
        names = sorted(self.publishers.get(topic, ()), key=lambda name: name != "/rosbag2_player")
        first = names[0] if names else ""
        messages = dict.fromkeys(names, 0)
        if first:
            messages[first] = self.messages.get(topic, 0)
        return {"name": topic, "type": self.types[topic].replace("/msg/", "/"), "messages": messages}

    def listen(self, topic, kind):
        """Count the messages of a topic, unserialised; one without a publisher is not of interest."""
        from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

        offers = self.node.get_publishers_info_by_topic(topic)
        if not offers:
            return
        self.types[topic] = kind
        found = {offer.node_namespace.rstrip("/") + "/" + offer.node_name for offer in offers}
        self.publishers[topic] = self.publishers.get(topic, set()) | found
        if topic in self.subscriptions:
            return
        lasting = all(offer.qos_profile.durability == DurabilityPolicy.TRANSIENT_LOCAL for offer in offers)
        profile = QoSProfile(
            depth=1000,
            reliability=ReliabilityPolicy.BEST_EFFORT if not lasting else ReliabilityPolicy.RELIABLE,
            durability=DurabilityPolicy.TRANSIENT_LOCAL if lasting else DurabilityPolicy.VOLATILE,
        )

        def count(_):
            self.messages[topic] = self.messages.get(topic, 0) + 1

        try:
            from rosidl_runtime_py.utilities import get_message

            self.subscriptions[topic] = self.node.create_subscription(
                get_message(kind), topic, count, profile, raw=True
            )
        except Exception as error:
            self.subscriptions[topic] = None
            self.seen["problem"] = "messages of %s cannot be counted: %s" % (topic, type(error).__name__)

    def ask(self, name):
        """Ask a node for the names of its parameters, as soon as it can be asked."""
        from rcl_interfaces.srv import ListParameters

        if name not in self.clients:
            self.clients[name] = self.node.create_client(ListParameters, name + ASKED)
        if self.clients[name].service_is_ready():
            self.asked[name] = self.clients[name].call_async(ListParameters.Request())


def main(play):
    """Look until the container ends; play a bag as soon as there is a node."""
    start = time.time()
    try:
        watcher = Watcher()
    except Exception as error:
        while True:  # a process that ends would be started again and again
            say({"problem": "the image has no rclpy to look at the graph with: %s" % error}, start)
            time.sleep(PAUSE)
    last, player = 0.0, None
    while True:
        watcher.rclpy.spin_once(watcher.node, timeout_sec=0.05)
        if time.time() - last >= PAUSE:
            last = time.time()
            seen = watcher.look()
            say(seen, start)
            if play and player is None and any("/_" not in name for name in seen["nodes"]):
                player = subprocess.Popen(["ros2", "bag", "play", play], stdout=2)


if MARK in os.environ:
    main(sys.argv[1])
else:
    begin()
