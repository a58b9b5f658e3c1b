#!/usr/bin/env python3
"""Runs Frama-C's Eva over emitted C: check_frama_c.py [--verbose] FOLDER. Each folder inside holds the files of one axis.

Assumed: a bool is 0 or 1 (C makes it so of any value that is assigned); the three structs and the set do not overlap; any real, NaN and
the infinities among them, is allowed everywhere but as the operand of a conversion.

Eva does not conclude from a comparison that a value is a number, nor from |x| <= limit what x is. So these questions are written for it
in a way that says the same: x == x and -limit <= x and x <= limit; x == x and x >= 0 and x <= limit.
"""

import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

OPTIONS = ("-c11 -machdep x86_64 -cpp-extra-args=-U__GNUC__ -warn-special-float none -no-warn-invalid-bool "
           "-eva -eva-precision 1 -eva-slevel 8 -eva-msg-key=-final-states,-initial-state").split()
FROM_ZERO = re.compile(r"([\w.>-]+) >= 0\.0f? && \1 <= ")
LIMIT = re.compile(r"\s*<= (-?[\w.]+(?:->[\w.]+)?(?:\[\d+\])?(?:e-?\d+f?)?)")
DRIVER = """#include "{file}"
volatile {name}_state any_state;
volatile {name}_inputs any_inputs;
volatile {name}_outputs any_outputs;
{params}
int main(void)
{{
    {name}_state state = any_state;
    {name}_inputs inputs = any_inputs;
    {name}_outputs outputs = any_outputs;
    {offer}
    {name}_step(&state, &inputs, &outputs);
    return 0;
}}
"""


def asked_apart(text: str, call: str) -> str:
    """The text with `magnitude(x) <= limit` asked in three questions."""
    start = 0
    while (start := text.find(call, start)) >= 0:
        end, depth = start + len(call), 1
        while depth:
            depth += {"(": 1, ")": -1}.get(text[end], 0)
            end += 1
        x, limit = text[start + len(call):end - 1], LIMIT.match(text, end)
        if limit is None:
            start = end  # its definition
            continue
        asked = f"(({x}) == ({x}) && -({limit[1]}) <= ({x}) && ({x}) <= {limit[1]})"
        text = text[:start] + asked + text[limit.end():]
    return text


def driver(source: Path) -> Path:
    """A program that calls the block once, from anything."""
    name, text = source.stem, source.read_text()
    header = source.with_suffix(".h").read_text()
    has_set = re.search(rf"{name}_params\s*\*\s*(?:\w+\s+)?params;", header) is not None
    params = f"volatile {name}_params any_params;" if has_set else ""
    offer = f"inputs.params = (void *)&any_params;" if has_set else ""
    model = source.with_name(name + "_model.c")
    model.write_text(asked_apart(FROM_ZERO.sub(r"\1 == \1 && \g<0>", text), name + "_magnitude("))
    program = source.with_name(name + "_eva.c")
    program.write_text(DRIVER.format(file=model.name, name=name, params=params, offer=offer))
    return program


def alarms(program: Path) -> tuple[str, list[str]]:
    """The alarms of a program; the first is what Frama-C itself refuses."""
    name = program.name.removesuffix("_eva.c")
    call = ["frama-c", *OPTIONS, str(program)]
    run = subprocess.run(call, cwd=program.parent, capture_output=True, text=True, check=False)
    output = run.stdout + run.stderr
    found = re.findall(r"\[eva:alarm\].*(?:\n  .*)*", output)
    if run.returncode or "ANALYSIS SUMMARY" not in output:
        found.insert(0, "Frama-C fails:\n" + output[-2000:])
    return f"{program.parent.name} {name}", found


def main() -> int:
    verbose, folder = "--verbose" in sys.argv, Path(sys.argv[-1])
    sources = [c for c in sorted(folder.glob("*/*.c")) if not c.stem.endswith(("_self_test", "_model", "_eva", "_runner"))]
    # Some cases differ in their stimulus alone.
    different = {source.read_text() + source.with_suffix(".h").read_text(): source for source in reversed(sources)}
    programs = [driver(source) for source in sorted(different.values())]
    with ThreadPoolExecutor(2) as pool:
        results = list(pool.map(alarms, programs))
    count = sum(len(found) for _, found in results)
    for name, found in results:
        if found:
            print(f"{name}: {len(found)}")
            if verbose:
                print("\n".join("  " + line for alarm in found for line in alarm.splitlines()))
    print(f"check-frama-c: {len(results)} blocks, {count} alarms in {sum(1 for _, found in results if found)}")
    return 1 if count or not results else 0


if __name__ == "__main__":
    sys.exit(main())
