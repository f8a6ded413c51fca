#!/usr/bin/env bash
# Usage: memcheck.sh PROGRAM [ARGUMENT...]
# Runs a test program under valgrind's memcheck and judges memory alone: a comparison that fails is
# reported by the program, but softpipe, on which Mesa runs here, draws points, quads and the last
# bits otherwise than llvmpipe, for which the comparisons are written.
directory=$(dirname "${BASH_SOURCE[0]}")
valgrind --quiet --error-exitcode=99 --leak-check=full \
  --suppressions="$directory/valgrind.supp" "$@"
status=$?
((status == 1)) && echo "memcheck: comparisons failed on softpipe; memory is judged"
((status <= 1)) || exit "$status"
