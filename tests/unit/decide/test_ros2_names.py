"""Names of ROS 2 and of MoveIt that some distributions do not have rule these out, whatever a page or a date says."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

Tree = Callable[[dict[str, str]], Decision]
PACKAGE = (
    '<package format="3"><name>robot</name><buildtool_depend>ament_cmake</buildtool_depend>'
    "<depend>{}</depend><export><build_type>{}</build_type></export></package>"
)
CMAKE = (
    "cmake_minimum_required(VERSION 3.8)\nproject(demo)\nfind_package(ament_cmake REQUIRED)\n"
    "add_executable(demo src/a.cpp)\nament_package()\n"
)
SERVICE = 'void f() {{\n  s = this->create_service<Pick>(\n    "pick", std::bind(&A::b, this, _1),\n    {});\n}}\n'
PLAN = "void f() {{\n  moveit::planning_interface::MoveGroupInterface::Plan plan;\n  g.plan(plan);\n  {};\n}}\n"


@pytest.mark.parametrize(
    ("code", "page", "distro"),
    [
        ("", "", "humble"),
        (SERVICE.format("rclcpp::ServicesQoS(), group_"), "", "jazzy"),
        (SERVICE.format("rclcpp::ServicesQoS()"), "Tested with ROS 2 Iron\n", "iron"),
        (SERVICE.format("rclcpp::QoS(rclcpp::KeepLast(1)), group_"), "", "jazzy"),
        (SERVICE.format("rclcpp::ServicesQoS().get_rmw_qos_profile(), group_"), "", "humble"),
        (SERVICE.format("// rclcpp::ServicesQoS(), group_\n group_"), "", "humble"),
        ("void f() { p = create_publisher<A>(t, rclcpp::QoS(1)); }\n", "", "humble"),
        ("void f() { s = own::create_client<A>(t, rclcpp::QoS(1)); }\n", "", "humble"),
        (SERVICE.format("rmw_qos_profile_services_default, group_"), "Tested with ROS 2 Kilted\n", "jazzy"),
        (SERVICE.format("rclcpp::QoS(a(b), rmw_qos_profile_default)"), "Tested with ROS 2 Kilted\n", "kilted"),
        ("rclcpp::BestAvailableQoS q;\n", "", "jazzy"),
        ("#include <rclcpp/event_handler.hpp>\n", "", "jazzy"),
        ("#include <rclcpp/scope_exit.hpp>\n", "Tested with ROS 2 Jazzy\n", "humble"),
        ("#include <rclcpp/type_adapter.hpp>\n", "Tested with ROS 2 Foxy\n", "jazzy"),
        ("#include <rclcpp/generic_publisher.hpp>\n", "Tested with ROS 2 Galactic\n", "galactic"),
        (PLAN.format("t = plan.trajectory"), "", "jazzy"),
        (PLAN.format("t = plan.trajectory"), "Tested with ROS 2 Iron\n", "iron"),
        (PLAN.format("t = plan.trajectory_"), "Tested with ROS 2 Jazzy\n", "humble"),
        (PLAN.format("t = solution.plan.trajectory"), "", "humble"),
        (PLAN.format("// t = plan.trajectory"), "", "humble"),
        (PLAN.format("#ifdef NEW\n t = plan.trajectory;\n#endif"), "", "jazzy"),
        ("#include <moveit/move_group_interface/move_group_interface.hpp>\n", "", "jazzy"),
        ("#include <moveit/move_group_interface/move_group_interface.h>\n", "", "humble"),
        ("#include <moveit/trajectory_processing/iterative_time_parameterization.h>\n", "For ROS 2 Jazzy\n", "humble"),
    ],
)
def test_what_cpp_code_calls(tree: Tree, code: str, page: str, distro: str) -> None:
    files = {"package.xml": PACKAGE.format("rclcpp", "ament_cmake"), "CMakeLists.txt": CMAKE, "src/a.cpp": code}
    assert tree({**files, "README.md": page}).ros_distro == distro


@pytest.mark.parametrize(
    ("code", "page", "distro"),
    [
        ("from rclpy.qos import QoSProfile\n", "", "humble"),
        ("from rclpy.qos import QoSProfile, qos_profile_default\n", "", "jazzy"),
        ("from rclpy.qos import qos_profile_default\n", "Tested with ROS 2 Humble\n", "jazzy"),
        ("from rclpy.qos import qos_profile_default\n", "Tested with ROS 2 Iron\n", "iron"),
        ("from rclpy.qos import qos_profile_default\n", "Tested with ROS 2 Dashing\n", "dashing"),
        ("try:\n    from rclpy.qos import qos_profile_default\nexcept ImportError:\n    pass\n", "", "humble"),
        ("# from rclpy.qos import qos_profile_default\n", "", "humble"),
        ("from rclpy.qos import qos_profile_best_available\n", "", "jazzy"),
        ("from rclpy.qos import QoSPresetProfiles as P\nq = QoSPresetProfiles.DEFAULT.value\n", "", "jazzy"),
        ("from rclpy.event_handler import SubscriptionEventCallbacks\n", "", "jazzy"),
        ("from rclpy.lifecycle import Node\n", "Tested with ROS 2 Foxy\n", "jazzy"),
        ("from rclpy.lifecycle import Node\nfrom rclpy.qos import qos_profile_default\n", "", "jazzy"),
    ],
)
def test_what_python_code_imports(tree: Tree, code: str, page: str, distro: str) -> None:
    files = {"package.xml": PACKAGE.format("rclpy", "ament_python"), "robot/__init__.py": "", "README.md": page}
    files["setup.py"] = "from setuptools import setup\nsetup(name='robot', packages=['robot'])\n"
    assert tree({**files, "robot/a.py": f"import rclpy\n{code}"}).ros_distro == distro
