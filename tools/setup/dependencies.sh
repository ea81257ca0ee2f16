#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# dependencies.sh main | everything
#
# Installs, on Debian 12, what Geodrome is built from: for the program with the standard plugins, or for everything with
# all tests. Packages that are there already cost nothing.
set -euo pipefail

packages=(
  build-essential cmake ninja-build pkg-config ccache
  libboost-dev libcli11-dev libxxhash-dev nlohmann-json3-dev zlib1g-dev      # engine, program
  libcgal-dev libeigen3-dev libflann-dev liblz4-dev libopenmesh-dev          # standard plugins
)
case "${1-}" in
  main) ;;
  everything)
    packages+=(libmetis-dev libgtest-dev librapidcheck-dev chromium)
    # Node may be here from elsewhere; Debian's packages would then conflict with it.
    command -v npm >/dev/null || packages+=(nodejs npm)
    ;;
  *)
    echo "usage: dependencies.sh main | everything" >&2
    exit 2
    ;;
esac

missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing+=("$package")
done
if [ ${#missing[@]} -gt 0 ]; then
  as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  "${as_root[@]}" apt-get update -qq
  DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}"
fi
