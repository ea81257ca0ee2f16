#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# METIS_PartGraphKway calls srand() with its own seed, so that the host's rand() starts anew at each call.
set -euo pipefail
version=5.1.0.dfsg-7

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download "libmetis-dev=$version" "libmetis5=$version"
for package in ./*.deb; do dpkg -x "$package" root; done
libraries=$folder/root/usr/lib/$(g++ -print-multiarch)

cat >draw.cpp <<'CODE'
#include <metis.h>

#include <cstdio>
#include <cstdlib>

// Cuts a ring of four vertices in two.
static void cut() {
  idx_t vertices = 4, constraints = 1, parts = 2, edges_cut = 0, part[4];
  idx_t first[] = {0, 2, 4, 6, 8}, neighbours[] = {1, 3, 0, 2, 1, 3, 0, 2};
  if (METIS_PartGraphKway(&vertices, &constraints, first, neighbours, nullptr, nullptr, nullptr, &parts, nullptr,
                          nullptr, nullptr, &edges_cut, part) != METIS_OK)
    std::exit(2);
}

// Prints three numbers that the host draws after srand(seed), with a cut before each or without.
int main(int, char** arguments) {
  const bool cuts = arguments[2][0] == 'c';
  std::srand(std::atoi(arguments[1]));
  for (int i = 0; i < 3; ++i) {
    if (cuts) cut();
    std::printf("%d ", std::rand());
  }
}
CODE
g++ -I root/usr/include draw.cpp -o draw -L "$libraries" -lmetis
draw() { LD_LIBRARY_PATH=$libraries ./draw "$@"; }

alone_7=$(draw 7 alone) alone_8=$(draw 8 alone) cut_7=$(draw 7 cut) cut_8=$(draw 8 cut)
echo "METIS $version, METIS_PartGraphKway with default options; the host draws three numbers with rand()"
echo "expected   a library that takes a seed as an option leaves the host's generator alone:"
echo "           srand(7): $alone_7 srand(8): $alone_8"
echo "seen       with a cut before each number:"
echo "           srand(7): $cut_7 srand(8): $cut_8"
read -r first second third <<<"$cut_7"
if [ "$cut_7" != "$cut_8" ] || [ "$first" != "$second" ] || [ "$second" != "$third" ]; then
  echo "CHANGED    the host's numbers no longer start anew at each cut"
  exit 1
fi
echo "hurts      simulations that use rand() and METIS in one process: the seed they set has no effect, and what they"
echo "           draw after each cut is one and the same number"
