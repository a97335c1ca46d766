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

# The cases, counted by Catch2's own summary. A crash leaves a failing status even without one.
log=build/tests/log.txt
status=0
build/tests/topobag_tests '~[long]' | tee "$log" || status=$?
summary=$(grep -E '^(All tests passed|test cases:)' "$log" | tail -n 1 || true)
passed=0
failed=0
if [[ $summary =~ ([0-9]+)\ test\ case || $summary =~ ([0-9]+)\ passed ]]; then passed=${BASH_REMATCH[1]}; fi
if [[ $summary =~ ([0-9]+)\ failed\ *($|\|) ]]; then failed=${BASH_REMATCH[1]}; fi
if [ "$status" -ne 0 ] && [ "$failed" -eq 0 ]; then failed=1; fi

# Whatever else ctest knows of.
ctest --test-dir build --exclude-regex '^topobag_tests$' --output-on-failure --parallel "$(nproc)" \
  --no-tests=ignore | tee "$log" || true
if [[ $(<"$log") =~ ,\ ([0-9]+)\ tests?\ failed\ out\ of\ ([0-9]+) ]]; then
  failed=$((failed + BASH_REMATCH[1]))
  passed=$((passed + BASH_REMATCH[2] - BASH_REMATCH[1]))
fi

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
