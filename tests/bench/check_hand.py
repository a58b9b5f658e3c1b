#!/usr/bin/env python3
"""Checks the hand-written axes against the reference's definition, replayed in Python floats, bit for bit.

Every operation of the reference is repeated here in its order, with the coefficients read from the C file. The stimulus
passes through all modes, resets, lost position control, wrong cycle times, samples out of range, the limit and rest.
"""

import ctypes
import itertools
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

AXES = {
    "hand_rack_and_pinion": [("v_motor", ["bp0"]), ("v_motor", ["osc1", "bp1"])],
    "hand_full": [
        ("v_motor", ["bp0_0", "bp0_1", "bp0_2", "ap0"]),
        ("v_motor", ["osc1", "ap1", "bp1_0", "bp1_1", "bp1_2"]),
        ("v_command", ["osc2", "bp2_0", "bp2_1", "bp2_2", "ap2"]),
    ],
}


class Inputs(ctypes.Structure):
    _fields_ = [
        ("v_command", ctypes.c_double),
        ("v_motor", ctypes.c_double),
        ("v_direct", ctypes.c_double),
        ("mode", ctypes.c_int32),
        ("position_controlled", ctypes.c_bool),
        ("reset", ctypes.c_bool),
        ("task_cycle_ns", ctypes.c_uint32),
    ]


class Outputs(ctypes.Structure):
    _fields_ = [
        ("v_add", ctypes.c_double),
        ("v_add_calculated", ctypes.c_double),
        ("limited", ctypes.c_bool),
        ("fault", ctypes.c_bool),
        ("error_id", ctypes.c_uint32),
    ]


class Axis:
    """The reference's definition, for the sections that an axis has."""

    def __init__(self, name):
        self.stages = AXES[name]
        text = (HERE / f"{name}.c").read_text()
        self.c = {k: float(v) for k, v in re.findall(r"static const double (\w+) = ([-0-9.e+]+);", text)}
        self.s = {p: [0.0, 0.0] for _, sections in self.stages for p in sections}
        self.preset, self.fade = False, 0

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
        if i.task_cycle_ns not in (0, CYCLE_TIME_NS):
            return 1
        if i.mode not in (OFF, ON, DRYRUN):
            return 2
        for name, error_id in (("v_command", 11), ("v_motor", 12), ("v_direct", 13)):
            used = any(name == source for source, _ in self.stages)
            if used and not -SAMPLE_LIMIT <= getattr(i, name) <= SAMPLE_LIMIT:
                return error_id
        return 0

    def step(self, i):
        c, error_id = self.c, self.error_of(i)
        v_add = v_add_calculated = 0.0
        limited = False
        if error_id or not i.position_controlled or i.reset or i.mode == OFF and self.fade == 0:
            self.preset, self.fade = False, 0
        else:
            if self.preset:
                if i.mode == ON:
                    if self.fade < FADE_CYCLES:
                        self.fade += 1
                elif self.fade > 0:
                    self.fade -= 1
            else:
                for source, sections in self.stages:
                    x = getattr(i, source)
                    for p in sections:
                        x = self.section_preset(p, x)
                self.preset = True
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
            elif -c["rest"] < v_sum < c["rest"]:
                v_limited = 0.0
            if i.mode != OFF:
                v_add_calculated = v_limited
            if self.fade == FADE_CYCLES:
                v_add = v_limited
            elif self.fade > 0:
                v_add = v_limited * (float(self.fade) * c["fade_step"])
        return v_add, v_add_calculated, limited, error_id != 0, error_id


def stimulus(samples):
    """Phases of 1 to 400 cycles, each with a mode and an amplitude; now and then a cycle that must not act."""
    rng = random.Random(1)
    mode, amplitude, left = ON, 1.0e5, 300
    for n in range(samples):
        if left == 0:
            mode = rng.choice([OFF, ON, ON, ON, DRYRUN, DRYRUN, 3, -1, 2**31 - 1]) if rng.random() < 0.6 else ON
            amplitude = rng.choice([0.0, 0.0, 1.0e-9, 1.0, 1.0e5, 1.0e5, 5.0e6, 1.0e15])
            left = rng.randint(1, 3 if mode not in (OFF, ON, DRYRUN) else 4000 if amplitude == 0.0 else 400)
        left -= 1
        i = Inputs(mode=mode, position_controlled=True)
        i.v_command = amplitude * rng.uniform(-1.0, 1.0)
        i.v_motor = amplitude * math.cos(0.33 * n) * rng.uniform(0.5, 1.0)
        i.v_direct = math.nan
        i.task_cycle_ns = rng.choice([0, CYCLE_TIME_NS])
        if rng.random() < 0.003:
            bad = rng.choice([math.nan, math.inf, -math.inf, 1.1e15, -1.0000000000000002e15])
            setattr(i, rng.choice(["v_command", "v_motor"]), bad)
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
    failed = False
    for name, compiler, level in itertools.product(AXES, ("gcc", "clang"), ("-O0", "-O2", "-O3")):
        with tempfile.TemporaryDirectory() as folder:
            library = f"{folder}/axis.so"
            subprocess.run(
                [compiler, "-std=c99", level, "-fPIC", "-shared", HERE / f"{name}.c", "-o", library], check=True
            )
            dll = ctypes.CDLL(library)
            state, outputs, axis = ctypes.create_string_buffer(4096), Outputs(), Axis(name)
            step = getattr(dll, f"axis_{name}_ipc_step")
            getattr(dll, f"axis_{name}_ipc_init")(state)
            differing, seen = 0, {"limited": 0, "fault": 0, "faded": 0, "open": 0, "rest": 0}
            for i in stimulus(samples):
                step(state, ctypes.byref(i), ctypes.byref(outputs))
                v_add, v_add_calculated, limited, fault, error_id = axis.step(i)
                same = (
                    bits(outputs.v_add) == bits(v_add)
                    and bits(outputs.v_add_calculated) == bits(v_add_calculated)
                    and (outputs.limited, outputs.fault, outputs.error_id) == (limited, fault, error_id)
                )
                differing += not same
                seen["limited"] += limited
                seen["fault"] += fault
                seen["faded"] += 0 < axis.fade < FADE_CYCLES
                seen["open"] += axis.fade == FADE_CYCLES
                seen["rest"] += axis.preset and v_add_calculated == 0.0 and i.mode != OFF
            print(f"{name} {compiler} {level}: {differing} of {samples} samples differ; {seen}")
            failed |= differing != 0
    sys.exit(failed)


if __name__ == "__main__":
    main()
