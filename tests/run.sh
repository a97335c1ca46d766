#!/usr/bin/env bash
# Builds and runs all tests but the [long] ones; ends with "N passed, M failed".
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source .ci/packages.sh

need_build_tools
need_packages libeigen3-dev libcgal-dev catch2 libcli11-dev nlohmann-json3-dev libsqlite3-dev \
  libvalijson-dev
# In a shell of its own: need_packages may end it.
(need_packages libpq-dev postgresql) || echo "skipped: the fleet's tests, which need a PostgreSQL server"

cmake -S . -B build
cmake --build build --parallel "$(nproc)" --target topobag_tests

passed=0
failed=0
# count_cases LOG STATUS: by Catch2's own summary. A crash leaves a failing status even without one.
count_cases() {
  local summary failures=0
  summary=$(grep -E '^(All tests passed|test cases:)' "$1" | tail -n 1 || true)
  if [[ $summary =~ ([0-9]+)\ test\ case || $summary =~ ([0-9]+)\ passed ]]; then
    passed=$((passed + BASH_REMATCH[1]))
  fi
  if [[ $summary =~ ([0-9]+)\ failed\ *($|\|) ]]; then failures=${BASH_REMATCH[1]}; fi
  if [ "$2" -ne 0 ] && [ "$failures" -eq 0 ]; then failures=1; fi
  failed=$((failed + failures))
}

# Most of those of the program beside all others: about half of the time each.
halves=('[examples]~[fleet]~[regression]~[long]' '~[examples]~[long],[fleet]~[long],[examples][regression]~[long]')
log=build/tests/log
runs=()
for half in 0 1; do
  build/tests/topobag_tests "${halves[half]}" >"$log$half.txt" 2>&1 &
  runs+=($!)
done
for half in 0 1; do
  status=0
  wait "${runs[half]}" || status=$?
  cat "$log$half.txt"
  count_cases "$log$half.txt" "$status"
done

# Whatever else ctest knows of.
ctest --test-dir build --exclude-regex '^topobag_tests$' --output-on-failure --parallel "$(nproc)" \
  --no-tests=ignore | tee "$log.txt" || true
if [[ $(<"$log.txt") =~ ,\ ([0-9]+)\ tests?\ failed\ out\ of\ ([0-9]+) ]]; then
  failed=$((failed + BASH_REMATCH[1]))
  passed=$((passed + BASH_REMATCH[2] - BASH_REMATCH[1]))
fi

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
