#!/bin/bash
# usage: compile-on-import PYTHON MODULE
# Imports a module that compiles itself when it is first imported, and gives its folder to the image's user: it writes
# there at each import. Where the module is not installed there is nothing to do; where it cannot be compiled, that is
# told, and programs that import it stop.
set -euo pipefail

python="$1" module="$2"
cd / # where no file of the repository is taken for a module
find='
import importlib.util, sys
found = importlib.util.find_spec(sys.argv[1])
print(next(iter(found.submodule_search_locations or []), "") if found else "")'
folder="$("${python}" -c "${find}" "${module}")" || exit 0 # Python 2 has no such module
if [ -z "${folder}" ]; then exit 0; fi

# As the user will: it may look for its library in the home directory
if HOME="/home/${NB_USER}" "${python}" -c "import ${module}"; then
  echo "roslab: ${module} is compiled"
else
  echo "roslab: left out: ${module} cannot be compiled or imported, the lines above say why: programs that import it stop"
fi
find "${folder}" -name '*.o' -delete
chown --recursive "${NB_UID}:${NB_UID}" "${folder}"
