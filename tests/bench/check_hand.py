#!/usr/bin/env python3
"""Checks the hand-written axes against the reference's definition, replayed in Python floats, bit for bit; and the
generated ones beside them.

    tests/bench/check_hand.py [SAMPLES [DIR]]     DIR: where, or below which, the generated C of axes.toml stands

Every operation of the reference is repeated here in its order, with the coefficients read from the C file that is checked.
The stimulus passes through all modes, resets, lost position control, wrong cycle times, samples out of range, the limit and
rest.
"""

import ctypes
import math
import pathlib
import random
import re
import struct
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
SAMPLE_LIMIT, ANTI_DENORMAL, FADE_CYCLES, CYCLE_TIME_NS = 1.0e15, 1.0e-30, 100, 1_000_000
OFF, ON, DRYRUN = 0, 1, 2

# Each stage: its input, and its sections by their hand-written and generated names.
AXES = {
    "rack_and_pinion": [
        ("v_motor", {"bp0": "stage0_filter0_bandpass0"}),
        ("v_motor", {"osc1": "stage1_oscillation", "bp1": "stage1_filter0_bandpass0"}),
    ],
    "full": [
        (
            "v_motor",
            {
                "bp0_0": "stage0_filter0_bandpass0",
                "bp0_1": "stage0_filter0_bandpass1",
                "bp0_2": "stage0_filter0_bandpass2",
                "ap0": "stage0_filter1_allpass",
            },
        ),
        (
            "v_motor",
            {
                "osc1": "stage1_oscillation",
                "ap1": "stage1_filter0_allpass",
                "bp1_0": "stage1_filter1_bandpass0",
                "bp1_1": "stage1_filter1_bandpass1",
                "bp1_2": "stage1_filter1_bandpass2",
            },
        ),
        (
            "v_command",
            {
                "osc2": "stage2_oscillation",
                "bp2_0": "stage2_filter0_bandpass0",
                "bp2_1": "stage2_filter0_bandpass1",
                "bp2_2": "stage2_filter0_bandpass2",
                "ap2": "stage2_filter1_allpass",
            },
        ),
    ],
}

KINDS = {
    "mode": ctypes.c_int32,
    "feedforward_active": ctypes.c_bool,
    "feedforward_percentage": ctypes.c_int32,
    "position_controlled": ctypes.c_bool,
    "reset": ctypes.c_bool,
    "task_cycle_ns": ctypes.c_uint32,
    "manipulated_variable": ctypes.c_int32,
    "additive_torque": ctypes.c_int32,
    "additive_velocity": ctypes.c_int32,
    "error_id": ctypes.c_uint32,
    "limited": ctypes.c_bool,
    "fault": ctypes.c_bool,
}
C_KINDS = {"double": ctypes.c_double, "int32_t": ctypes.c_int32, "uint32_t": ctypes.c_uint32, "bool": ctypes.c_bool}


def structure(names):
    """The C struct of these signals. Without slots, a signal that it does not have could be written all the same."""
    fields = [(name, KINDS.get(name, ctypes.c_double)) for name in names.split()]
    return type("Signals", (ctypes.Structure,), {"__slots__": (), "_fields_": fields})


INPUTS = {
    "rack_and_pinion": structure("v_motor mode position_controlled reset task_cycle_ns"),
    "full": structure("v_command v_motor mode position_controlled reset task_cycle_ns"),
}
OUTPUTS = dict.fromkeys(AXES, structure("v_add v_add_calculated limited fault error_id"))


def names(signals):
    return [name for name, _ in signals._fields_]


def reals(signals):
    return [name for name, kind in signals._fields_ if kind is ctypes.c_double]


def declared(header, struct):
    """The names and kinds of a struct's members as the header has them."""
    text = re.sub(r"/\*.*?\*/", "", header.read_text(), flags=re.DOTALL)
    body = re.search(rf"typedef struct {{([^{{}}]*)}} {struct};", text)[1]
    return [(name, C_KINDS[kind]) for kind, name in re.findall(r"(\w+) (\w+);", body)]


def constants(source):
    return {k: float(v) for k, v in re.findall(r"static const double (\w+) = ([-0-9.e+]+);", source.read_text())}


def generated_source(folder, block):
    for source in sorted(pathlib.Path(folder).rglob(f"{block}.c")):
        return source
    sys.exit(f"no {block}.c below {folder}")


class Compiled:
    """The step of a compiled block."""

    def __init__(self, title, block, source, compiler, level, library, inputs, outputs):
        self.title, self.differing = f"{title}, {compiler} {level}", 0
        header = source.with_name(f"{block}.h")
        for struct, signals in (("inputs", inputs), ("outputs", outputs)):
            if declared(header, f"{block}_{struct}") != signals._fields_:
                sys.exit(f"{header}: {block}_{struct} has other signals than {names(signals)}")
        command = [compiler, "-std=c99", level, "-fPIC", "-shared", f"-I{source.parent}", source, "-o", library]
        subprocess.run(command, check=True)
        dll = ctypes.CDLL(library)
        self.state, self.outputs = ctypes.create_string_buffer(4096), outputs()
        self.function = getattr(dll, f"{block}_step")
        getattr(dll, f"{block}_init")(self.state)

    def step(self, i, expected):
        ctypes.memset(ctypes.byref(self.outputs), 0xA5, ctypes.sizeof(self.outputs))
        self.function(self.state, ctypes.byref(i), ctypes.byref(self.outputs))
        for name, kind in self.outputs._fields_:
            got, value = getattr(self.outputs, name), expected[name]
            if bits(got) != bits(value) if kind is ctypes.c_double else got != value:
                self.differing += 1
                return


def compile_all(title, block, source, work, inputs, outputs):
    """The block with each compiler and level."""
    return [
        Compiled(title, block, source, compiler, level, f"{work}/{block}_{compiler}{level}.so", inputs, outputs)
        for compiler in ("gcc", "clang")
        for level in ("-O0", "-O2", "-O3")
    ]


class Axis:
    """The reference's definition, for the sections that an axis has."""

    def __init__(self, name, source):
        self.stages = AXES[name]
        self.c = self.by_hand(constants(source))
        self.s = {p: [0.0, 0.0] for _, sections in self.stages for p in sections}
        self.preset, self.fade = False, 0

    def by_hand(self, c):
        """The coefficients by their hand-written names."""
        for n, (_, sections) in enumerate(self.stages):
            for p, generated in [*sections.items(), (f"gain{n}", f"stage{n}_gain")]:
                for name in [name for name in c if name.startswith(generated)]:
                    ending = name.removeprefix(generated)
                    if p.startswith("bp") and ending == "_b2":
                        ending = "_minus_b0"
                    c[p + ending] = c.pop(name)
        return c

    def section_step(self, p, x):
        c, s = self.c, self.s[p]
        if p.startswith("bp"):
            b0 = -c[p + "_minus_b0"]
            t = b0 * x
            y = t + s[0]
            s[0] = s[1] - c[p + "_a1"] * y
            s[1] = ANTI_DENORMAL - t - c[p + "_a2"] * y
        elif p.startswith("ap"):
            y = c[p + "_a2"] * x + s[0]
            s[0] = c[p + "_a1"] * (x - y) + s[1]
            s[1] = x + ANTI_DENORMAL - c[p + "_a2"] * y
        else:
            y = c[p + "_b0"] * x + s[0]
            s[0] = c[p + "_b1"] * x - c[p + "_a1"] * y + s[1]
            s[1] = c[p + "_b2"] * x + ANTI_DENORMAL - c[p + "_a2"] * y
        return y

    def section_preset(self, p, x):
        c, s = self.c, self.s[p]
        if p.startswith("bp"):
            s[0] = s[1] = -(-c[p + "_minus_b0"] * x)
            return 0.0
        if p.startswith("ap"):
            preset = c.get(p + "_preset", 1.0 - c[p + "_a2"])
            s[0] = s[1] = preset * x
            return x
        s[0], s[1] = c[p + "_preset_s1"] * x, c[p + "_preset_s2"] * x
        return x

    def error_of(self, i):
        for name, error_id in (("v_command", 11), ("v_motor", 12), ("v_direct", 13)):
            read = any(name == source for source, _ in self.stages)
            if read and not -SAMPLE_LIMIT <= getattr(i, name) <= SAMPLE_LIMIT:
                return error_id
        if i.task_cycle_ns not in (0, CYCLE_TIME_NS):
            return 1
        return 0 if i.mode in (OFF, ON, DRYRUN) else 2

    def step(self, i):
        c, error_id = self.c, self.error_of(i)
        v_add = v_add_calculated = 0.0
        limited = False
        if error_id or not i.position_controlled or i.reset:
            self.preset, self.fade = False, 0
        elif not self.preset:
            if i.mode != OFF:
                for source, sections in self.stages:
                    x = getattr(i, source)
                    for p in sections:
                        x = self.section_preset(p, x)
                self.preset = True
        else:
            if i.mode == ON:
                if self.fade < FADE_CYCLES:
                    self.fade += 1
            else:
                if self.fade > 0:
                    self.fade -= 1
                if i.mode == OFF and self.fade == 0:
                    self.preset = False
            v_sum = None
            for n, (source, sections) in enumerate(self.stages):
                x = getattr(i, source)
                for p in sections:
                    x = self.section_step(p, x)
                v_stage = c[f"gain{n}"] * x
                v_sum = v_stage if v_sum is None else v_sum + v_stage
            v_limited = v_sum
            if v_sum > c["limit"]:
                v_limited, limited = c["limit"], True
            elif v_sum < c["lower_limit"]:
                v_limited, limited = c["lower_limit"], True
            elif -c["rest"] <= v_sum <= c["rest"]:
                v_limited = 0.0
            if i.mode != OFF:
                v_add_calculated = v_limited
            if self.fade == FADE_CYCLES:
                v_add = v_limited
            elif self.fade > 0:
                v_add = v_limited * (float(self.fade) * c["fade_step"])
            # The cycle that ends the fade in OFF runs no stage.
            limited = limited and self.preset
        return {
            "v_add": v_add,
            "v_add_calculated": v_add_calculated,
            "limited": limited,
            "fault": error_id != 0,
            "error_id": error_id,
        }


def stimulus(inputs, samples):
    """Phases of 1 to 400 cycles, each with a mode and an amplitude; now and then a cycle that must not act."""
    rng = random.Random(1)
    mode, amplitude, left = ON, 1.0e5, 300
    for n in range(samples):
        if left == 0:
            mode = rng.choice([OFF, ON, ON, ON, DRYRUN, DRYRUN, 3, -1, 2**31 - 1]) if rng.random() < 0.6 else ON
            # Twice the largest velocity leads to no sum that is a fault: tests/tests/blocks/disturbed_states.rs has those.
            amplitude = rng.choice([0.0, 0.0, 1.0e-9, 1.0, 1.0e5, 1.0e5, 5.0e5, 1.0e6])
            left = rng.randint(1, 3 if mode not in (OFF, ON, DRYRUN) else 4000 if amplitude == 0.0 else 400)
        left -= 1
        i = inputs(mode=mode, position_controlled=True)
        v_command = amplitude * rng.uniform(-1.0, 1.0)
        if "v_command" in names(inputs):
            i.v_command = v_command
        i.v_motor = amplitude * math.cos(0.33 * n) * rng.uniform(0.5, 1.0)
        i.task_cycle_ns = rng.choice([0, CYCLE_TIME_NS])
        if rng.random() < 0.003:
            bad = rng.choice([math.nan, math.inf, -math.inf, 1.1e15, -1.0000000000000002e15])
            setattr(i, rng.choice(reals(inputs)), bad)
        event = rng.random()
        if event < 0.001:
            i.reset = True
        elif event < 0.002:
            i.position_controlled = False
        elif event < 0.003:
            i.task_cycle_ns = rng.choice([1, 999_999, 2_000_000])
        yield i


def bits(v):
    return struct.pack("<d", v).hex()


def main():
    samples = int(sys.argv[1]) if len(sys.argv) > 1 else 100_000
    folder = sys.argv[2] if len(sys.argv) > 2 else None
    failed = False
    for name in AXES:
        sources = [("hand", f"axis_hand_{name}_ipc", HERE / f"hand_{name}.c")]
        if folder is not None:
            block = f"axis_{name}_ipc"
            sources.append(("generated", block, generated_source(folder, block)))
        for title, block, source in sources:
            seen = dict.fromkeys("limited fault faded open rest preset".split(), 0)
            axis = Axis(name, source)
            with tempfile.TemporaryDirectory() as work:
                built = compile_all(title, block, source, work, INPUTS[name], OUTPUTS[name])
                for i in stimulus(INPUTS[name], samples):
                    before = axis.preset
                    expected = axis.step(i)
                    for one in built:
                        one.step(i, expected)
                    seen["limited"] += expected["limited"]
                    seen["fault"] += expected["fault"]
                    seen["faded"] += 0 < axis.fade < FADE_CYCLES
                    seen["open"] += axis.fade == FADE_CYCLES
                    seen["rest"] += before and axis.preset and expected["v_add_calculated"] == 0.0 and i.mode != OFF
                    seen["preset"] += axis.preset and not before
            print(f"{name}, {samples} samples: {seen}")
            for one in built:
                print(f"  {one.title}: {one.differing} differ")
                failed |= one.differing != 0
    sys.exit(failed)


if __name__ == "__main__":
    main()
