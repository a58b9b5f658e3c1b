#!/usr/bin/env python3
"""Prints the coefficients of the two hand-written axes, as they stand in hand_rack_and_pinion.c and hand_full.c.

Plain double arithmetic with Python's math. The generator computes its own coefficients with another tan(): a last
digit may differ, which changes no instruction count.

Sign convention, a0 = 1:  y = b0 x + s1;  s1 = b1 x - a1 y + s2;  s2 = b2 x - a2 y
"""

import math

CYCLE_TIME = 1e-3
CRIT_DAMPING, BUTTERWORTH, BESSEL = "CRIT_DAMPING", "BUTTERWORTH", "BESSEL"

# Low-pass prototypes with |H(j)|^2 = 1/2: real poles sigma, pairs (sigma, omega).
PROTOTYPES = {
    (CRIT_DAMPING, 1): ([1.0], []),
    (BUTTERWORTH, 3): ([1.0], [(0.5, 0.8660254037844386)]),
    (BESSEL, 3): ([1.3226757999104446], [(1.047409161008936, 0.9992644363371022)]),
}


def centre_and_bandwidth(f0, q_factor):
    omega0 = math.tan(math.pi * f0 * CYCLE_TIME)
    return omega0, (1.0 + omega0 * omega0) * math.tan(math.pi * f0 * CYCLE_TIME / q_factor)


def bandpass(f0, q_factor, prototype=CRIT_DAMPING, order=1):
    """Sections of c k g s / (s^2 + k g s + g^2) as (b0, a1, a2), lower centre first among equals, rising section Q."""
    omega0, bandwidth = centre_and_bandwidth(f0, q_factor)
    q = omega0 / bandwidth
    sections = []
    real, pairs = PROTOTYPES[prototype, order]
    for sigma in real:
        sections.append((sigma / q, omega0, 1.0))
    for sigma, omega in pairs:
        e = (sigma * sigma + omega * omega) / (q * q)
        root = math.sqrt((4.0 + e) ** 2 - 16.0 * sigma * sigma / (q * q))
        m = (e * (root + 4.0) + 8.0 * (omega * omega - sigma * sigma) / (q * q) + e * e) / (8.0 * (root + 4.0))
        m = max(m, 0.0)
        w = math.sqrt(1.0 + m) + math.sqrt(m)
        section_q = math.sqrt((4.0 + e + root) / 2.0) / (2.0 * sigma / q)
        c = math.sqrt(1.0 + 4.0 * section_q * section_q * m)
        sections += [(1.0 / section_q, omega0 / w, c), (1.0 / section_q, omega0 * w, c)]
    sections.sort(key=lambda section: (-section[0], section[1]))
    result = []
    for k, g, c in sections:
        d = 1.0 + k * g + g * g
        result.append({"b0": c * k * g / d, "a1": 2.0 * (g * g - 1.0) / d, "a2": (1.0 - k * g + g * g) / d})
    return result


def allpass(f0, q_factor):
    """(s^2 - B s + Omega0^2) / (s^2 + B s + Omega0^2): b0 = a2, b1 = a1, b2 = 1."""
    omega0, bandwidth = centre_and_bandwidth(f0, q_factor)
    d = 1.0 + bandwidth + omega0 * omega0
    a1, a2 = 2.0 * (omega0 * omega0 - 1.0) / d, (1.0 - bandwidth + omega0 * omega0) / d
    return {"a1": a1, "a2": a2, "preset": 1.0 - a2}


def oscillation(f0, damping):
    """(2 D w0 s + w0^2) / (s^2 + 2 D w0 s + w0^2), bilinear, prewarped at f0."""
    g = math.tan(math.pi * f0 * CYCLE_TIME)
    k = 2.0 * damping
    d = 1.0 + k * g + g * g
    b0, b1, b2 = (k * g + g * g) / d, 2.0 * g * g / d, (g * g - k * g) / d
    a1, a2 = 2.0 * (g * g - 1.0) / d, (1.0 - k * g + g * g) / d
    return {"b0": b0, "b1": b1, "b2": b2, "a1": a1, "a2": a2, "preset_s1": 1.0 - b0, "preset_s2": b2 - a2}


def rack_and_pinion():
    return [
        ("stage 0: BANDPASS order 1, 53 Hz, Q 10", bandpass(53.0, 10.0)),
        ("stage 1: oscillation 11 Hz, damping 0.8", [oscillation(11.0, 0.8)]),
        ("stage 1: BANDPASS order 1, 11 Hz, Q 2", bandpass(11.0, 2.0)),
    ]


def full():
    return [
        ("stage 0: BANDPASS BUTTERWORTH order 3, 53 Hz, Q 10", bandpass(53.0, 10.0, BUTTERWORTH, 3)),
        ("stage 0: ALLPASS 55 Hz, Q 2", [allpass(55.0, 2.0)]),
        ("stage 1: oscillation 11 Hz, damping 0.8", [oscillation(11.0, 0.8)]),
        ("stage 1: ALLPASS 12 Hz, Q 2", [allpass(12.0, 2.0)]),
        ("stage 1: BANDPASS BUTTERWORTH order 3, 11 Hz, Q 2", bandpass(11.0, 2.0, BUTTERWORTH, 3)),
        ("stage 2: oscillation 90 Hz, damping 0.8", [oscillation(90.0, 0.8)]),
        ("stage 2: BANDPASS BESSEL order 3, 90 Hz, Q 5", bandpass(90.0, 5.0, BESSEL, 3)),
        ("stage 2: ALLPASS 95 Hz, Q 3", [allpass(95.0, 3.0)]),
    ]


def main():
    for name, axis in (("rack_and_pinion", rack_and_pinion()), ("full", full())):
        print(name)
        for title, sections in axis:
            print(f"  {title}")
            for i, section in enumerate(sections):
                for key, value in section.items():
                    print(f"    {i} {key:10} {value!r}")
        print()
    print(f"rest {530000.0 * 2.0**-60!r}")


if __name__ == "__main__":
    main()
