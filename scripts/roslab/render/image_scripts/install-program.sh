#!/bin/bash
# usage: install-program FOLDER
# Installs what CMake compiled in a folder, as a page does: linkers find its libraries, and Python the modules that lie in
# its own folder below /usr/local, where a distribution's Python does not look. What cannot be installed is still compiled.
set -euo pipefail

if ! (cd "$1" && cmake -P cmake_install.cmake); then
  echo "roslab: left out: what CMake compiled in $1 cannot be installed" >&2
  exit 0
fi
ldconfig
if command -v python3 >/dev/null; then
  python3 -c '
import os, site, sys
modules = "/usr/local/lib/python%d.%d/site-packages" % sys.version_info[:2]
read = [folder for folder in site.getsitepackages() if os.path.isdir(folder)]
if os.path.isdir(modules) and modules not in sys.path and read:
    with open(os.path.join(read[0], "installed-by-cmake.pth"), "w") as file:
        file.write(modules + "\n")
' || echo "roslab: Python does not find the modules that CMake installed" >&2
fi
