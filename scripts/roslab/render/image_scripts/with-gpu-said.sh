#!/bin/bash
# usage: with-gpu-said [COMMAND...]
# Runs a command in which torch says that there is a GPU: no build of an image sees one, and a setup.py that only asks
# for it compiles for CUDA all the same, for the architectures of TORCH_CUDA_ARCH_LIST.
# Without a command it prints the folder for PYTHONPATH that does this, for what the shell calls by a function of its own.
set -euo pipefail

shared=/dev/shm # no layer has what lies there
if [ ! -w "${shared}" ]; then shared=/tmp; fi
folder="$(mktemp --directory "${shared}/gpu-said.XXXXXX")"
cat >"${folder}/sitecustomize.py" <<'PYTHON'
import sys
from importlib.machinery import PathFinder


class Saying:
    """Finds torch.cuda as Python does, and changes one answer of it."""

    @staticmethod
    def find_spec(name, path=None, target=None):
        spec = PathFinder.find_spec(name, path, target) if name == "torch.cuda" else None
        if spec is not None:
            load = spec.loader.exec_module

            def exec_module(module):
                load(module)
                module.is_available = lambda: True

            spec.loader.exec_module = exec_module
        return spec


sys.meta_path.insert(0, Saying)
PYTHON
if [ "$#" -eq 0 ]; then
  echo "${folder}"
  exit
fi
status=0
PYTHONPATH="${folder}${PYTHONPATH:+:${PYTHONPATH}}" "$@" || status=$?
rm -rf "${folder}"
exit "${status}"
