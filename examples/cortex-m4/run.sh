#!/usr/bin/env bash
# Generates the block, builds the program for a Cortex-M4F, and runs it in qemu.
#
#   ./run.sh [FOLDER]     FOLDER: for what is built [default: build]
#
# AXGEN names the command axgen, if it is not on the path. Exit code: 3 a program is missing.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
build=${1:-build}
mkdir -p "$build"

for program in arm-none-eabi-gcc:gcc-arm-none-eabi qemu-system-arm:qemu-system-arm; do
    if ! command -v "${program%:*}" >/dev/null; then
        echo "missing: ${program%:*}; install it with: apt-get install ${program#*:}" >&2
        exit 3
    fi
done

"${AXGEN:-axgen}" generate "$here/axes.toml" --out "$build/generated" >/dev/null

arm-none-eabi-gcc -mthumb -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard -O2 -std=c99 -Wall -Wextra -Werror \
    -ffreestanding -nostdlib -static -I"$here" -I"$build/generated" -T "$here/board.ld" \
    "$build"/generated/*.c "$here/main.c" "$here/board.c" -lgcc -o "$build/program.elf"

# Semihosting writes to standard error. -icount: the emulated time is that of the instructions (16 ns each), whatever the host does; its clock goes on while it sleeps
qemu-system-arm -M mps2-an386 -display none -monitor none -serial none -icount shift=4,sleep=off \
    -semihosting-config enable=on,target=native -kernel "$build/program.elf" 2>&1
