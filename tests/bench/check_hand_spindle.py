#!/usr/bin/env python3
"""Checks the hand-written spindles against the generated ones, bit for bit, in a run as it is measured and in a disturbed one.

    tests/bench/check_hand_spindle.py CYCLES DIR     DIR: where, or below which, the generated C of spindles.toml stands

spindle_driver.c prints a digest of all outputs of all cycles; every 1000 cycles it must be the same with all compilers and
levels. Every error that such a spindle can have must come up. `axgen verify` checks the generated ones against the reference.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

from check_hand import HERE, declared, generated_source

ERRORS = {1, 14, 17, 18, 23, 31, 32, 33, 34, 35, 36, 42, 46}
SPINDLES = {
    "s": (["-DIN_DRIVE"], ERRORS | {41, 43, 44, 45}),
    "c": ([], ERRORS | {2, 12, 48}),
}
# With 200000 cycles, every error comes up with one of these seeds.
RUNS = [["30000"], ["CYCLES", "2", "disturb"], ["CYCLES", "3", "disturb"]]


def build(axis, control, source, compiler, level, flags, program):
    header = source.with_name(f"{axis}_spindle_axis.h")
    driver = [
        f"-DAXIS={axis}",
        f"-DAXIS_HEADER=\"{header.name}\"",
        f"-DCONTROL={control}",
        *flags,
        HERE / "spindle_driver.c",
    ]
    command = [compiler, "-std=c99", level, f"-I{source.parent}", *driver, source, "-lm", "-o", program]
    subprocess.run(command, check=True)


def outputs_of(program, run, cycles):
    arguments = [cycles if argument == "CYCLES" else argument for argument in run]
    done = subprocess.run([program, *arguments], check=True, capture_output=True, text=True)
    return done.stdout.splitlines()


def first_difference(lines, expected):
    for line, other in zip(lines, expected):
        if line != other:
            return line
    return None if len(lines) == len(expected) else "another number of lines"


def main():
    cycles, folder = sys.argv[1:3]
    failed = False
    for name, (flags, errors) in SPINDLES.items():
        sources = {
            "hand": (f"axis_hand_{name}", "spindle.control", HERE / f"hand_{name}.c"),
            "generated": (f"axis_{name}", "spindle_control", generated_source(folder, f"axis_{name}_spindle_axis")),
        }
        for signals in ("inputs", "outputs"):
            kinds = [
                declared(source.with_name(f"{axis}_spindle_axis.h"), f"{axis}_spindle_axis_{signals}")
                for axis, _, source in sources.values()
            ]
            if kinds[0] != kinds[1]:
                sys.exit(f"spindle {name}: other {signals} by hand than generated")
        expected = None
        with tempfile.TemporaryDirectory() as work:
            for title, (axis, control, source) in sources.items():
                for compiler in ("gcc", "clang"):
                    for level in ("-O0", "-O2", "-O3"):
                        program = pathlib.Path(work) / f"{title}_{compiler}{level}"
                        build(axis, control, source, compiler, level, flags, program)
                        results = [outputs_of(program, run, cycles) for run in RUNS]
                        if expected is None:
                            expected = results
                            seen = {int(k) for lines in results for line in lines for k in re.findall(r" (\d+) x", line)}
                            missing = errors - seen
                            print(f"spindle {name}, {cycles} cycles twice: errors {sorted(seen - {0, 63})}")
                            if missing:
                                print(f"  these did not come up: {sorted(missing)}")
                                failed = True
                        found = [first_difference(*pair) for pair in zip(results, expected)]
                        differs = next((line for line in found if line is not None), None)
                        print(f"  {title}, {compiler} {level}: {'same' if differs is None else f'differs: {differs}'}")
                        failed |= differs is not None
    sys.exit(failed)


if __name__ == "__main__":
    main()
