#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# While METIS_PartGraphKway runs, SIGTERM does not end the process: it becomes a return value of METIS.
set -euo pipefail
version=5.1.0.dfsg-7

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download "libmetis-dev=$version" "libmetis5=$version"
for package in ./*.deb; do dpkg -x "$package" root; done
libraries=$folder/root/usr/lib/$(g++ -print-multiarch)

cat >partition.cpp <<'CODE'
#include <metis.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <vector>

// Cuts a grid of 1500 x 1500 vertices into 64 parts, and returns what METIS returns.
static int cut() {
  const idx_t side = 1500;
  std::vector<idx_t> first{0}, neighbours, part(side * side);
  for (idx_t y = 0; y < side; ++y)
    for (idx_t x = 0; x < side; ++x) {
      const idx_t v = y * side + x;
      if (x > 0) neighbours.push_back(v - 1);
      if (x + 1 < side) neighbours.push_back(v + 1);
      if (y > 0) neighbours.push_back(v - side);
      if (y + 1 < side) neighbours.push_back(v + side);
      first.push_back(idx_t(neighbours.size()));
    }
  idx_t vertices = side * side, constraints = 1, parts = 64, edges_cut = 0;
  std::puts("running"), std::fflush(stdout);
  return METIS_PartGraphKway(&vertices, &constraints, first.data(), neighbours.data(), nullptr, nullptr, nullptr,
                             &parts, nullptr, nullptr, nullptr, &edges_cut, part.data());
}

// The child cuts; the parent asks it to end, as a batch system or `kill` does.
int main() {
  int said[2];
  if (pipe(said) != 0) return 2;
  const pid_t child = fork();
  if (child == 0) {
    dup2(said[1], 1);
    _exit(cut() == METIS_OK ? 0 : 10);
  }
  char word[8];
  if (read(said[0], word, sizeof word) <= 0) return 2;
  usleep(300000);
  kill(child, SIGTERM);
  int status = 0;
  waitpid(child, &status, 0);
  WIFSIGNALED(status) ? std::printf("ended by signal %d\n", WTERMSIG(status))
                      : std::printf("exit status %d\n", WEXITSTATUS(status));
}
CODE
g++ -O1 -I root/usr/include partition.cpp -o partition -L "$libraries" -lmetis
seen=$(LD_LIBRARY_PATH=$libraries ./partition)

echo "METIS $version, METIS_PartGraphKway on a grid of 2.25 million vertices; SIGTERM after 0.3 s, no handler installed"
echo "expected   ended by signal 15"
echo "seen       $seen (10: the call returned, and not METIS_OK; the program went on)"
if [ "$seen" != "exit status 10" ]; then
  echo "CHANGED    the signal is no longer taken"
  exit 1
fi
echo "hurts      jobs under a batch system or supervisor: the request to end is lost, and shows as a failed partition"
