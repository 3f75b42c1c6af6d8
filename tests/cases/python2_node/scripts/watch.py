#!/usr/bin/env python
import rospy
import serial
from sensor_msgs.msg import BatteryState


def told(message):
    print "charge: %.2f" % message.percentage


if __name__ == "__main__":
    rospy.init_node("watch")
    rospy.Subscriber("battery", BatteryState, told)
    print "pyserial", serial.VERSION
    rospy.spin()
