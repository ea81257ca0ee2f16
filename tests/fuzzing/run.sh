#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh [-r RUNS] [-s SECONDS] [-d FILES] [TARGET...]
#
# Builds the preset `fuzz` (clang and its sanitizers) and runs every reader, or those named, under libFuzzer until it
# has been called RUNS times (10 million) or for SECONDS (1800), whichever comes first: some hours of one core for all
# targets. Broken files in FILES become seeds too. Prints a row a target; status 1 if a promise was broken. Inputs that
# broke one are in build/fuzz/found; the corpus of each target, cut down to what reaches most, is in build/fuzz/corpus,
# where later runs go on.
set -euo pipefail

runs=10000000 seconds=1800 files=
while getopts r:s:d: option; do
  case $option in
    r) runs=$OPTARG ;;
    s) seconds=$OPTARG ;;
    d) files=$OPTARG ;;
    *) sed -n '3,9s/^# \{0,1\}//p' "$0" >&2 && exit 2 ;;
  esac
done
shift $((OPTIND - 1))

cd "$(dirname "$0")/../.."
[ -f build/fuzz/build.ninja ] || cmake --preset fuzz
cmake --build --preset fuzz
work=$PWD/build/fuzz bin=$PWD/build/fuzz/bin
mkdir -p "$work/found"
"$bin/fuzz_seeds" "$work/seeds" ${files:+"$files"}
[ -w /dev/shm ] && export TMPDIR=/dev/shm # the target `partial` writes files
export ASAN_OPTIONS=malloc_context_size=0:quarantine_size_mb=16

stat() { awk -v name="stat::$1:" '$1 == name { print $2 }' "$2"; }

status=0
printf '%-12s %12s %10s %8s %8s  %s\n' target executions per_second corpus edges found
[ $# -gt 0 ] || set -- $(ls "$work/seeds")
for target; do
  corpus=$work/corpus/$target log=$work/found/$target.log
  mkdir -p "$corpus" "$corpus.new"
  # Files of 1,000 bytes take four times as long; a pair index is longer.
  longest=$([ "$target" = pair_index ] && echo 4608 || echo 640)
  verdict=nothing
  "$bin/fuzz_reader" --target="$target" -runs="$runs" -max_total_time="$seconds" -seed=1 -entropic=0 -timeout=5 \
    -max_len="$longest" -malloc_limit_mb=64 -rss_limit_mb=1024 -print_final_stats=1 \
    -artifact_prefix="$work/found/$target-" \
    "$corpus" "$work/seeds/$target" >"$log" 2>&1 || { verdict="see $log" status=1; }
  edges=$(grep -ao 'cov: [0-9]*' "$log" | tail -1 | cut -d' ' -f2)
  "$bin/fuzz_reader" --target="$target" -merge=1 -timeout=5 "$corpus.new" "$corpus" "$work/seeds/$target" \
    >"$log.merge" 2>&1 && rm -r "$corpus" && mv "$corpus.new" "$corpus"
  printf '%-12s %12s %10s %8s %8s  %s\n' "$target" "$(stat number_of_executed_units "$log")" \
    "$(stat average_exec_per_sec "$log")" "$(ls "$corpus" | wc -l)" "$edges" "$verdict"
done
exit $status
