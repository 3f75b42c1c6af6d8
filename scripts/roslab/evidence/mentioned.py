"""The readers of a tree that each find mentions by themselves."""

from __future__ import annotations

from collections.abc import Iterator

from roslab.evidence import git_folder, matlab, started_programs, submodules
from roslab.evidence.facts import Mention
from roslab.evidence.native import (
    asked_definitions,
    cloned_heads,
    cuda_paths,
    generators,
    made_elsewhere,
    modules_aside,
    onnx_on_gpu,
    root_variables,
    shared_objects,
    templates,
)
from roslab.evidence.prose import (
    asked_options,
    branch_tables,
    container_scripts,
    container_starts,
    copied_headers,
    copied_settings,
    for_reference,
    laid_as_sources,
    libtorch,
    makefile_options,
    named_ports,
    of_other_indexes,
    optional_ros,
    simulator_folders,
    speakers,
    system_libraries,
    unbounded_jobs,
)
from roslab.evidence.python import (
    from_above,
    from_root,
    given_as_data,
    opened,
    own_spelling,
    python2_nodes,
    python3_modules,
    ros_tools,
    said_in_code,
    sibling_folders,
    typestores,
    usetex,
)
from roslab.evidence.ros import (
    copied_scripts,
    handed_lists,
    in_bin,
    on_machines,
    own_setup,
    program_endings,
    robot_models,
    started_by_scripts,
)
from roslab.repository.checkout import Repository

MENTIONED = (
    *(
        branch_tables.read,
        cloned_heads.read,
        cloned_heads.archives,
        for_reference.read,
        git_folder.read,
        named_ports.read,
        opened.read,
    ),
    *(asked_options.read, matlab.mentions, of_other_indexes.read, said_in_code.read, shared_objects.made_on),
    *(optional_ros.read, own_spelling.read, started_by_scripts.calls, started_programs.read, templates.read),
    *(
        cuda_paths.read,
        container_scripts.read,
        copied_headers.read,
        copied_settings.read,
        libtorch.in_scripts,
        simulator_folders.read,
    ),
    *(asked_definitions.read, makefile_options.read, modules_aside.read, onnx_on_gpu.read, root_variables.read),
    *(ros_tools.read, system_libraries.read, usetex.read),
)
"""What pages, code and files of a project tell by themselves."""
BESIDE_PROSE = (
    *(from_root.read, sibling_folders.read, from_above.read, generators.read, speakers.read, program_endings.read),
)
"""What code and files tell beside what pages say."""
OF_DOCKERFILES = (container_starts.read, unbounded_jobs.read)
"""What the authors' Dockerfiles start and run."""
_OF_ROS = (
    *(on_machines.read, own_setup.read, handed_lists.read, laid_as_sources.read, typestores.read),
    *(copied_scripts.read, given_as_data.read, in_bin.read),
    *(python2_nodes.read, python3_modules.read, robot_models.read),
)


def of_ros(repository: Repository, whole: Repository) -> Iterator[Mention]:
    """Yield what launch files, scripts and lists tell of a workspace of ROS, and what builds left in the ``whole``."""
    for reader in _OF_ROS:
        yield from reader(repository)
    yield from on_machines.built(own := submodules.without(whole))
    yield from made_elsewhere.tools(own)
