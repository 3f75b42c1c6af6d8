#!/bin/bash
# usage: packages.sh FOLDER
# Makes a source of small Debian packages in a folder: each holds the one file that a broken repository asks for.
set -euo pipefail

folder="$1"
mkdir -p "${folder}"
cd "$(mktemp -d)"

# The file of the package NAME comes from standard input, or is a shared library where the path ends with .so
package() {
  local name="$1" version="$2" path="$3" root
  root="$(mktemp -d)"
  chmod 755 "${root}"
  mkdir -p "${root}/DEBIAN" "${root}$(dirname "${path}")"
  case "${path}" in
    *.so | *.so.*) echo 'int stand_in(void) { return 0; }' | gcc -shared -x c -o "${root}${path}" - ;;
    *) cat >"${root}${path}" ;;
  esac
  case "${path}" in */bin/*) chmod 755 "${root}${path}" ;; esac
  printf 'Package: %s\nVersion: %s\nArchitecture: all\nMaintainer: lab <lab@example.org>\nDescription: stand-in\n' \
    "${name}" "${version}" >"${root}/DEBIAN/control"
  dpkg-deb --build --root-owner-group "${root}" "${folder}/${name}.deb"
}

package libgoogle-glog-dev 0.6.0-1 /usr/include/glog/logging.h <<<'inline int logged() { return 0; }'
package libeigen3-dev 3.4.0-1 /usr/share/eigen3/cmake/Eigen3Config.cmake <<<'set(Eigen3_FOUND TRUE)'
package libjsoncpp-dev 1.9.5-1 /usr/share/pkgconfig/jsoncpp.pc <<<$'Name: jsoncpp\nDescription: stand-in\nVersion: 1.9.5'
package libmodbus-dev 3.1.6-1 /usr/lib/libmodbus.so
package libusb-1.0-0 1.0.26-1 /usr/lib/libusb-1.0.so.0
package ros-jazzy-angles 1.16.0-1 /usr/share/angles/cmake/anglesConfig.cmake <<<'set(angles_FOUND TRUE)'
package ros-jazzy-tf-transformations 1.1.0-1 /usr/lib/python3/dist-packages/tf_transformations.py <<<'print("here")'
package bc 1.07.1-1 /usr/bin/bc <<<$'#!/bin/sh\necho 2'
cd "${folder}"
dpkg-scanpackages . /dev/null >Packages
