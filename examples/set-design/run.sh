#!/usr/bin/env bash
# Generates the blocks, builds the program for this computer, and runs it.
#
#   ./run.sh [FOLDER]     FOLDER: for what is built [default: build]
#
# AXGEN names the command axgen, if it is not on the path; CC the C compiler.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
build=${1:-build}
mkdir -p "$build"

"${AXGEN:-axgen}" generate "$here/axes.toml" --out "$build/generated" >/dev/null
"${CC:-gcc}" -O2 -std=c99 -Wall -Wextra -Werror -I"$here" -I"$build/generated" \
    "$build"/generated/*.c "$here/main.c" "$here/tuning.c" -lm -o "$build/program"
"$build/program"
