"""Libraries that come with another one, which is built from its source."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from roslab.decide.decision import Decision

_MANIFEST = (
    "<package format='3'><name>mpc</name><buildtool_depend>ament_cmake</buildtool_depend>"
    "<depend>rclcpp</depend><export><build_type>ament_cmake</build_type></export></package>"
)


@pytest.mark.parametrize("with_acados", [True, False])
def test_what_acados_installs_with_itself(tree: Callable[[dict[str, str]], Decision], with_acados: bool) -> None:
    acados = "find_package(acados REQUIRED)\n" if with_acados else ""
    cmake = (
        f"project(mpc)\nfind_package(ament_cmake REQUIRED)\n{acados}find_library(HPIPM_LIB hpipm)\n"
        "add_executable(mpc mpc.cpp)\ntarget_link_libraries(mpc ${HPIPM_LIB})\nament_package()\n"
    )
    decision = tree({"package.xml": _MANIFEST, "CMakeLists.txt": cmake, "mpc.cpp": "int main() {}\n"})
    assert any("CMake links hpipm" in each.message for each in decision.warnings) != with_acados
