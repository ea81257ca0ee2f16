#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs what Geodrome is built from, on Debian 12. Packages that are there already cost nothing.
set -euo pipefail

packages=(
  build-essential cmake ninja-build pkg-config ccache
  libboost-dev libcgal-dev libeigen3-dev libflann-dev liblz4-dev libmetis-dev libopenmesh-dev libxxhash-dev
  libcli11-dev nlohmann-json3-dev libgtest-dev librapidcheck-dev chromium
)
# Node may be here from elsewhere; Debian's packages would then conflict with it.
command -v npm >/dev/null || packages+=(nodejs npm)

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
