"""Designs of all filters by scipy, by its own methods: the numbers that unit/design/scipy.rs compares with.

Made with (in this folder)
    python3 -m venv /tmp/venv && /tmp/venv/bin/pip install scipy==1.17.1 numpy==2.4.6
    /tmp/venv/bin/python scipy_designs.py > scipy_designs.csv

BUTTERWORTH   scipy.signal.butter(n, [f1, f2], 'bandpass', fs=1/Ts)
BESSEL        scipy.signal.bessel(n, [f1, f2], 'bandpass', norm='mag', fs=1/Ts)
CRIT_DAMPING  n real poles at -(2^(1/n) - 1)^(-1/2), lp2bp_zpk and bilinear_zpk
ALLPASS       zeros and poles at the roots of s^2 -+ Bw s + w0^2, bilinear_zpk
OSCILLATION   (2 D w0 s + w0^2) / (s^2 + 2 D w0 s + w0^2), prewarped at f0, bilinear_zpk

f1 and f2 are the edges: the roots of t^2 - Omega0^2 +- B t, f = atan(t) / (pi Ts).

A row: kind, order, cycle time in ns, f0 in Hz, Q or D, gain; the poles; five frequencies in Hz; the response there.
Complex numbers are `re im`, the members of a list are parted by `;`.
"""

import math

import numpy as np
from scipy import signal

CYCLES = [62500, 125000, 250000, 500000, 1000000, 2000000, 4000000]


def edges(f0, q, ts):
    omega0 = math.tan(math.pi * f0 * ts)
    b = (1 + omega0**2) * math.tan(math.pi * f0 * ts / q)
    upper = b / 2 + math.sqrt(b * b / 4 + omega0**2)
    return [math.atan(t) / (math.pi * ts) for t in (omega0**2 / upper, upper)]


def prewarped(f, ts):
    return 2 / ts * math.tan(math.pi * f * ts)


def bandpass(kind, n, f0, q, ts):
    f1, f2 = edges(f0, q, ts)
    if kind == "BUTTERWORTH":
        return signal.butter(n, [f1, f2], "bandpass", fs=1 / ts, output="zpk")
    if kind == "BESSEL":
        return signal.bessel(n, [f1, f2], "bandpass", norm="mag", fs=1 / ts, output="zpk")
    sigma = (2 ** (1 / n) - 1) ** -0.5
    w1, w2 = prewarped(f1, ts), prewarped(f2, ts)
    analogue = signal.lp2bp_zpk([], np.full(n, -sigma), sigma**n, wo=math.sqrt(w1 * w2), bw=w2 - w1)
    return signal.bilinear_zpk(*analogue, fs=1 / ts)


def allpass(f0, q, ts):
    w1, w2 = (prewarped(f, ts) for f in edges(f0, q, ts))
    p = np.roots([1, w2 - w1, w1 * w2])
    return signal.bilinear_zpk(-p, p, 1.0, fs=1 / ts)


def oscillation(f0, d, ts):
    w0 = prewarped(f0, ts)
    p = np.roots([1, 2 * d * w0, w0 * w0])
    return signal.bilinear_zpk([-w0 / (2 * d)], p, 2 * d * w0, fs=1 / ts)


def row(kind, n, ns, f0, q, zpk, probes):
    ts = ns / 1e9
    z, p, k = zpk
    _, h = signal.freqz_zpk(z, p, k, worN=np.array(probes), fs=1 / ts)
    pair = lambda c: f"{c.real!r} {c.imag!r}"
    several = lambda values: ";".join(pair(complex(v)) for v in values)
    print(kind, n, ns, repr(f0), repr(q), repr(float(np.real(k))), several(p), ";".join(map(repr, probes)), several(h), sep=",")


def sets(count, salt):
    """f0 * Ts from 6e-6 to 0.45, evenly in the logarithm; Q from 1 to 10, in no order."""
    for i in range(count):
        ns = CYCLES[(i * 3 + salt) % len(CYCLES)]
        product = 6e-6 * (0.45 / 6e-6) ** (i / (count - 1))
        f0 = min(float(f"{product / ns * 1e9:.6g}"), 0.45e9 / ns)
        q = 1.0 + 9.0 * ((i * 7 + salt * 5) % count) / (count - 1)
        yield ns, f0, round(q, 3)


def main():
    print("kind,order,cycle_time_ns,f0,q_or_d,gain,poles,frequencies,response")
    salt = 0
    for kind in ("CRIT_DAMPING", "BUTTERWORTH", "BESSEL"):
        for n in (1, 2, 3):
            salt += 1
            for ns, f0, q in sets(24, salt):
                ts = ns / 1e9
                f1, f2 = edges(f0, q, ts)
                probes = [f1 / 3, f1, f0, f2, (f2 + 0.5 / ts) / 2]
                row(kind, n, ns, f0, q, bandpass(kind, n, f0, q, ts), probes)
    for ns, f0, q in sets(24, 10):
        ts = ns / 1e9
        f1, f2 = edges(f0, q, ts)
        row("ALLPASS", 2, ns, f0, q, allpass(f0, q, ts), [f1 / 3, f1, f0, f2, (f2 + 0.5 / ts) / 2])
    for ns, f0, q in sets(24, 11):
        ts = ns / 1e9
        d = round(q / 10.5, 3)
        row("OSCILLATION", 2, ns, f0, d, oscillation(f0, d, ts), [f0 / 10, f0 / 2, f0, (f0 + 0.5 / ts) / 2, 0.49 / ts])


main()
