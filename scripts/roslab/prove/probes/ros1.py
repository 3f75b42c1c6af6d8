"""Watches a ROS 1 graph from inside a container and prints what it saw so far, a JSON object a line.

It speaks the protocol itself, with the standard library alone: it works in an image without rospy, on Python 2 and 3,
starts within a fraction of a second, and registers nothing, so that the graph stays what it was.
https://wiki.ros.org/ROS/Master_API, https://wiki.ros.org/ROS/Slave_API, https://wiki.ros.org/ROS/TCPROS
"""

import glob
import json
import os
import socket
import struct
import subprocess
import sys
import threading
import time

try:
    from xmlrpc.client import ServerProxy
except ImportError:  # Python 2
    from xmlrpclib import ServerProxy

NAME = "/roslab_proof"
PAUSE = 0.2
LONGEST = 3.0
"""Seconds that one answer may take."""


def environment():
    """Return the variables of the first process of the container that knows ROS, else this process's own."""
    for path in sorted(glob.glob("/proc/[0-9]*/environ"), key=lambda path: -int(path.split("/")[2])):
        try:
            with open(path, "rb") as stream:
                text = stream.read().decode("utf-8", "replace")
        except (IOError, OSError):
            continue
        found = dict(pair.split("=", 1) for pair in text.split("\0") if "=" in pair)
        if "ROS_MASTER_URI" in found:
            return found
    return dict(os.environ)


def fields(pairs):
    """Return a header of TCPROS."""
    said = [(name + "=" + value).encode() for name, value in pairs]
    body = b"".join(struct.pack("<I", len(field)) + field for field in said)
    return struct.pack("<I", len(body)) + body


def received(stream, length):
    """Return so many bytes; raise ``IOError`` where the other side ends first."""
    parts = []
    while length:
        part = stream.recv(min(length, 1 << 20))
        if not part:
            raise IOError("closed")
        parts.append(part)
        length -= len(part)
    return b"".join(parts)


def block(stream):
    """Return what follows its own length, as headers and messages do."""
    return received(stream, struct.unpack("<I", received(stream, 4))[0])


def connected(host, port, header):
    """Return a connection after both sides said their headers."""
    try:
        stream = socket.create_connection((host, port), LONGEST)
    except (IOError, OSError):
        stream = socket.create_connection(("127.0.0.1", port), LONGEST)  # a host name that only the node knows
    stream.sendall(fields(header))
    if b"error=" in block(stream):
        raise IOError("refused")
    return stream


class Topic(object):
    """Counts the messages of one topic, of each of its publishers."""

    def __init__(self, name):
        self.name = name
        self.messages = {}
        self.listening = set()

    def listen(self, publisher, address):
        """Count in the background, once for each publisher."""
        if publisher not in self.listening:
            self.listening.add(publisher)
            self.messages.setdefault(publisher, 0)
            thread = threading.Thread(target=self._count, args=(publisher, address))
            thread.daemon = True
            thread.start()

    def _count(self, publisher, address):
        try:
            answer = ServerProxy(address).requestTopic(NAME, self.name, [["TCPROS"]])
            _, host, port = answer[2]
            header = [("callerid", NAME), ("topic", self.name), ("md5sum", "*"), ("type", "*")]
            stream = connected(host, port, header)
            stream.settimeout(None)
            while True:
                block(stream)
                self.messages[publisher] += 1
        except Exception:  # the node has ended, or is not ready: the next look tries again
            self.listening.discard(publisher)


def answers(master, node):
    """Tell whether a node answers as it answers ``rosnode ping``.

    No service is called: asking for the levels of loggers ended nodes of roscpp where this was tried on Debian 12.
    """
    try:
        return ServerProxy(master.lookupNode(NAME, node)[2]).getPid(NAME)[0] == 1
    except Exception:
        return False


def look(master, topics, answered):
    """Return what the master says now, with the messages that came so far."""
    state = master.getSystemState(NAME)[2]
    types = dict(master.getTopicTypes(NAME)[2])
    publishers, subscribers, services = (dict(part) for part in state)
    nodes = sorted({node for part in (publishers, subscribers, services) for names in part.values() for node in names})
    for name, names in publishers.items():
        topic = topics.setdefault(name, Topic(name))
        for node in names:
            if node not in topic.listening:
                topic.listen(node, master.lookupNode(NAME, node)[2])
    for node in nodes:
        if node not in answered and answers(master, node):
            answered.add(node)
    return {
        "nodes": nodes,
        "services": sorted(services),
        "answered": sorted(answered),
        "topics": [
            {"name": name, "type": types.get(name, "*"), "messages": dict(topics[name].messages)}
            for name in sorted(topics)
        ],
    }


def merged(before, now):
    """Return all that was ever seen: a program that ends takes its nodes out of the graph."""
    for part in ("nodes", "services", "answered"):
        now[part] = sorted(set(before.get(part, ())) | set(now[part]))
    return now


def main(play):
    """Look until the container ends; play a bag as soon as there is a node."""
    socket.setdefaulttimeout(LONGEST)
    start = time.time()
    topics, answered, seen, player = {}, set(), {}, None
    while True:
        found = environment()
        try:
            master = ServerProxy(found.get("ROS_MASTER_URI", "http://localhost:11311"))
            seen = merged(seen, look(master, topics, answered))
            if play and player is None and set(seen["nodes"]) - {"/rosout"}:
                player = subprocess.Popen(["rosbag", "play", play], env=found, stdout=2)
        except Exception as error:
            seen["problem"] = "no ROS master answered" if isinstance(error, (IOError, OSError)) else repr(error)
        seen["seconds"] = round(time.time() - start, 1)
        sys.stdout.write(json.dumps(seen) + "\n")
        sys.stdout.flush()
        time.sleep(PAUSE)


main(sys.argv[1])
