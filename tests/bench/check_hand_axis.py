#!/usr/bin/env python3
"""Checks the hand-written whole axes against the reference's definition, replayed in Python floats, bit for bit; and the
generated ones beside them.

    tests/bench/check_hand_axis.py [SAMPLES [DIR]]     DIR: where, or below which, the generated C of the axes X, V, T stands

Every operation of the reference is repeated here in its order, with the coefficients read from the hand-written C file. The
stimulus passes through all modes, resets, lost position control, wrong cycle times, samples out of range, the limit, rest,
all weights of G136, halves of increments and their neighbours, both ends of the process data and what is beyond them.
"""

import math
import random
import sys
import tempfile

from check_hand import ANTI_DENORMAL, CYCLE_TIME_NS, DRYRUN, FADE_CYCLES, HERE, OFF, ON, SAMPLE_LIMIT
from check_hand import compile_all, constants, generated_source, names, reals, structure

INTEGERS = {"x": (-(2**31), 2**31 - 1), "v": (-(2**31), 2**31 - 1), "t": (-(2**15), 2**15 - 1)}


INPUTS = {
    "x": structure(
        "x_command x_actual v_interpolator a_interpolator v_motor mode"
        " feedforward_active feedforward_percentage position_controlled reset task_cycle_ns"
    ),
    "v": structure(
        "x_command v_interpolator feedforward_active feedforward_percentage position_controlled reset task_cycle_ns"
    ),
    "t": structure(
        "x_command a_interpolator feedforward_active feedforward_percentage position_controlled reset task_cycle_ns"
    ),
}
OUTPUTS = {
    "x": structure("v_command v_feedforward v_add v_add_calculated manipulated_variable error_id limited fault"),
    "v": structure("x_drive additive_velocity error_id limited fault"),
    "t": structure("x_drive additive_torque error_id limited fault"),
}


def in_range(x):
    return -SAMPLE_LIMIT <= x <= SAMPLE_LIMIT


class Axis:
    """The reference's definition, for what the axes X, V and T have of it."""

    def __init__(self, name):
        self.name = name
        self.c = constants(HERE / f"hand_{name}.c")
        self.s = {p: [0.0, 0.0] for p in ("bp0", "osc1", "bp1")}
        self.preset, self.fade = False, 0
        self.before = self.x_held = 0.0
        self.seen = dict.fromkeys(
            "open faded rest preset limit half below_half at_an_end rounded_to_an_end beyond_an_end".split(), 0
        )
        self.seen["errors"] = set()

    def gain(self, i):
        if not i.feedforward_active:
            return 0.0
        if i.feedforward_percentage >= 100:
            return 1.0
        return 0.01 * float(i.feedforward_percentage) if i.feedforward_percentage > 0 else 0.0

    def rounded(self, x):
        lowest, highest = INTEGERS[self.name]
        self.seen["at_an_end"] += x in (float(lowest), float(highest))
        self.seen["rounded_to_an_end"] += lowest - 0.5 < x < lowest or highest < x < highest + 0.5
        if x <= lowest - 0.5:
            self.seen["beyond_an_end"] += 1
            return lowest, True
        if x >= highest + 0.5:
            self.seen["beyond_an_end"] += 1
            return highest, True
        value = int(x)
        fraction = x - float(value)
        self.seen["half"] += abs(fraction) == 0.5
        self.seen["below_half"] += 0.5 - 1e-8 < abs(fraction) < 0.5
        if fraction >= 0.5:
            value += 1
        elif fraction <= -0.5:
            value -= 1
        return value, False

    def bandpass(self, p, x):
        c, s = self.c, self.s[p]
        t = c[p + "_minus_b0"] * x
        y = s[0] - t
        s[0] = s[1] - c[p + "_a1"] * y
        s[1] = t + ANTI_DENORMAL - c[p + "_a2"] * y
        return y

    def stages(self, x):
        c, s = self.c, self.s["osc1"]
        y0 = self.bandpass("bp0", x)
        y = c["osc1_b0"] * x + s[0]
        s[0] = c["osc1_b1"] * x - c["osc1_a1"] * y + s[1]
        s[1] = c["osc1_b2"] * x + ANTI_DENORMAL - c["osc1_a2"] * y
        return c["gain0"] * y0 + c["gain1"] * self.bandpass("bp1", y)

    def preset_sections(self, x):
        c = self.c
        self.s["bp0"] = [c["bp0_minus_b0"] * x] * 2
        self.s["osc1"] = [c["osc1_preset_s1"] * x, c["osc1_preset_s2"] * x]
        self.s["bp1"] = [c["bp1_minus_b0"] * x] * 2

    def ipc(self, i, out):
        """Gives the error."""
        c = self.c
        if not in_range(i.v_motor):
            self.preset, self.fade = False, 0
            return 12
        if i.mode not in (OFF, ON, DRYRUN):
            self.preset, self.fade = False, 0
            return 2
        if not self.preset:
            if i.mode == OFF:
                self.fade = 0
            else:
                self.preset_sections(i.v_motor)
                self.preset = True
                self.seen["preset"] += 1
            return 0
        if i.mode == ON:
            if self.fade < FADE_CYCLES:
                self.fade += 1
        else:
            if self.fade > 0:
                self.fade -= 1
            if i.mode == OFF and self.fade == 0:
                self.preset = False
                return 0
        v = self.stages(i.v_motor)
        if abs(v) <= c["limit"]:
            if abs(v) <= c["rest"]:
                v = 0.0
                self.seen["rest"] += 1
        else:
            v = math.copysign(c["limit"], v)
            out["limited"] = True
            self.seen["limit"] += 1
        if self.fade >= FADE_CYCLES:
            self.seen["open"] += 1
            out["v_add"] = out["v_add_calculated"] = v
        else:
            self.seen["faded"] += self.fade > 0
            out["v_add"] = v * (float(self.fade) * c["fade_step"]) if self.fade > 0 else 0.0
            out["v_add_calculated"] = v if i.mode != OFF else 0.0
        return 0

    def in_the_cnc(self, i, out):
        c, error_id, v_feedforward = self.c, 0, 0.0
        if not in_range(i.a_interpolator):
            error_id = 15
        elif not in_range(i.v_interpolator):
            error_id = 14
        else:
            v_feedforward = self.gain(i) * (i.v_interpolator + c["t_a"] * i.a_interpolator)
        v_command = c["kv"] * (i.x_command - i.x_actual) + v_feedforward
        out["v_feedforward"], out["v_command"] = v_feedforward, v_command
        ipc_error_id = self.ipc(i, out)
        error_id = ipc_error_id or error_id  # of several parts the last one stands
        increments = c["increments_per_velocity"] * (v_command + out["v_add"])
        out["manipulated_variable"], limited = self.rounded(increments)
        out["limited"] = out["limited"] or limited
        return error_id

    def in_the_drive(self, i, out):
        c = self.c
        out["x_drive"] = self.x_held = i.x_command
        if self.name == "v":
            x, error_id, output, scale = i.v_interpolator, 14, "additive_velocity", c["increments_per_input"]
        else:
            x, error_id, output, scale = i.a_interpolator, 15, "additive_torque", c["increments_per_input"]
        if not in_range(x):
            self.preset = False
            return error_id
        x = self.gain(i) * x
        if not self.preset:
            self.before = x
            self.seen["preset"] += 1
        delayed = c["now"] * x + c["earlier"] * self.before
        self.before, self.preset = x, True
        out[output], out["limited"] = self.rounded(scale * delayed)
        return 0

    def step(self, i):
        outputs = OUTPUTS[self.name]
        out = {name: 0.0 if name in reals(outputs) else 0 for name in names(outputs)}
        acts = False
        if not in_range(i.x_command):
            error_id = 17
        elif i.task_cycle_ns not in (0, CYCLE_TIME_NS):
            error_id = 1
        elif self.name == "x" and not in_range(i.x_actual):
            error_id = 18
        elif not i.position_controlled or i.reset:
            error_id = 0
        else:
            acts = True
            error_id = self.in_the_cnc(i, out) if self.name == "x" else self.in_the_drive(i, out)
        if not acts:
            self.preset, self.fade = False, 0
            if self.name != "x":
                if error_id != 17:
                    self.x_held = i.x_command
                out["x_drive"] = self.x_held
        out["fault"], out["error_id"] = error_id != 0, error_id
        assert list(out) == names(outputs)
        self.seen["errors"].add(error_id)
        return out

    def for_increments(self, i, increments):
        """Sets the inputs so that the drive gets about so many increments of what it gets."""
        c = self.c
        if self.name == "x":
            i.x_actual = i.v_interpolator = i.a_interpolator = 0.0
            i.x_command = increments / (c["kv"] * c["increments_per_velocity"])
        elif self.name == "v":
            i.v_interpolator = increments / c["increments_per_input"]
        else:
            i.a_interpolator = increments / c["increments_per_input"]


def stimulus(axis, samples):
    """Phases of 1 to 400 cycles, each with a mode and an amplitude, or about a number of increments."""
    rng = random.Random(1)
    inputs = INPUTS[axis.name]
    lowest, highest = INTEGERS[axis.name]
    left = 0
    for n in range(samples):
        if left == 0:
            mode = rng.choice([OFF, ON, ON, ON, DRYRUN, DRYRUN, 3, -1, 2**31 - 1]) if rng.random() < 0.6 else ON
            amplitude = rng.choice([0.0, 0.0, 1.0e-9, 1.0, 1.0e5, 1.0e5, 1.0e5, 5.0e6, 1.0e9, 1.0e15])
            left = rng.randint(1, 3 if mode not in (OFF, ON, DRYRUN) else 4000 if amplitude == 0.0 else 400)
            percentage = rng.choice([100, 100, 87, rng.randint(-5, 120), -(2**31), 2**31 - 1])
            active = rng.random() < 0.8
            target = None
            if rng.random() < 0.3:
                target = float(rng.choice([lowest, highest, 0, rng.randint(lowest, highest), rng.randint(-1000, 1000)]))
                target += rng.choice([0.0, 0.5, -0.5, 1.0, -1.0])
                mode, left, active, percentage = OFF, rng.randint(20, 60), True, 100
        left -= 1
        x_command = amplitude * rng.uniform(-1.0, 1.0)
        values = {
            "x_command": x_command,
            "x_actual": x_command + 0.01 * amplitude * rng.uniform(-1.0, 1.0),
            "v_interpolator": amplitude * rng.uniform(-1.0, 1.0),
            "a_interpolator": 0.1 * amplitude * rng.uniform(-1.0, 1.0),
            # Twice the largest velocity leads to no sum that is a fault: tests/tests/blocks/disturbed_states.rs has those.
            "v_motor": min(amplitude, 1.0e6) * math.cos(0.33 * n) * rng.uniform(0.5, 1.0),
            "mode": mode,
            "feedforward_active": active,
            "feedforward_percentage": percentage,
            "position_controlled": True,
            "reset": False,
            "task_cycle_ns": rng.choice([0, CYCLE_TIME_NS]),
        }
        i = inputs(**{name: values[name] for name in names(inputs)})
        if target is not None:
            number = target
            for _ in range(rng.randint(0, 4)):
                number = math.nextafter(number, rng.choice([math.inf, -math.inf]))
            axis.for_increments(i, number)
        for _ in range(rng.choice([1, 1, 2]) if rng.random() < 0.006 else 0):
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


def main():
    samples = int(sys.argv[1]) if len(sys.argv) > 1 else 100_000
    folder = sys.argv[2] if len(sys.argv) > 2 else None
    failed = False
    for name in INTEGERS:
        axis = Axis(name)
        with tempfile.TemporaryDirectory() as work:
            signals = INPUTS[name], OUTPUTS[name]
            built = compile_all("hand", f"axis_hand_{name}_axis", HERE / f"hand_{name}.c", work, *signals)
            if folder is not None:
                block = f"axis_{name}_axis"
                built += compile_all("generated", block, generated_source(folder, block), work, *signals)
            for i in stimulus(axis, samples):
                expected = axis.step(i)
                for one in built:
                    one.step(i, expected)
        print(f"axis {name}, {samples} samples: {axis.seen}")
        for one in built:
            print(f"  {one.title}: {one.differing} differ")
            failed |= one.differing != 0
    sys.exit(failed)


if __name__ == "__main__":
    main()
