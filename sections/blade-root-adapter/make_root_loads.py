#!/usr/bin/env python3
"""Writes root-loads.outb: synthetic loads at the root of a blade of a small turbine, as OpenFAST has them.

    python3 -m venv /tmp/venv && /tmp/venv/bin/pip install weio==2.0.0
    /tmp/venv/bin/python sections/blade-root-adapter/make_root_loads.py

No turbine was simulated. What is in it is made of what a blade of 9 m and 180 kg does at 60 rpm: its weight goes
round once a turn (edgewise), its centre of mass is pulled outwards, the wind bends it flapwise, more above than
below (shear of the wind and the tower once and twice a turn), with slow turbulence and its own first frequency.
The file is written by weio, the reader and writer of OpenFAST's files, in OpenFAST's names, units and axes:
x_c downwind, y_c towards the trailing edge, z_c towards the tip; the loads of the blade on what carries it.
"""

import pathlib

import numpy as np
import pandas as pd
from weio.fast_output_file import FASTOutputFile

RATE, SPAN = 20.0, 180.0            # samples a second, seconds
TURN = 2 * np.pi * 1.0              # rad/s
MASS, CENTRE, GRAVITY = 180.0, 3.2, 9.81
RADIUS = 9.0


def coloured(random, times, corner, deviation):
    """Noise with a spectrum that falls beyond a corner [Hz], of a deviation, without mean, that closes in itself."""
    frequencies = np.fft.rfftfreq(times.size, 1.0 / RATE)
    size = 1.0 / (1.0 + (frequencies / corner) ** (5.0 / 3.0))
    size[0] = 0.0
    phases = random.uniform(0.0, 2 * np.pi, frequencies.size)
    noise = np.fft.irfft(size * np.exp(1j * phases), times.size)
    return deviation * noise / noise.std()


def loads():
    random = np.random.default_rng(20261124)
    times = np.arange(int(SPAN * RATE) + 1) / RATE
    inner = times[:-1]
    azimuth = TURN * inner              # 0: the blade points upwards
    wind = coloured(random, inner, 0.05, 3.6)
    # Its own first frequency, 2.7 Hz, answers the turbulence with a narrow band.
    own = coloured(random, inner, 0.4, 1.0) * np.sin(2 * np.pi * 2.7 * inner + 0.7)
    flap = 24.0 + wind + 4.5 * np.cos(azimuth) + 1.4 * np.cos(2 * azimuth + 0.4) + own
    edge = 3.1 + 0.12 * wind + MASS * GRAVITY * CENTRE * 1e-3 * np.sin(azimuth)
    edge = edge + 0.35 * coloured(random, inner, 0.4, 1.0) * np.sin(2 * np.pi * 4.3 * inner)
    pull = MASS * (TURN**2 * CENTRE - GRAVITY * np.cos(azimuth)) * 1e-3
    thrust = flap / (0.62 * RADIUS)
    across = -(MASS * GRAVITY * np.sin(azimuth) * 1e-3 + (edge - 5.65 * np.sin(azimuth)) / (0.6 * RADIUS))
    twist = -0.02 * flap + 0.12 * np.sin(azimuth) + 0.05 * coloured(random, inner, 0.4, 1.0)
    channels = {
        "RootFxc1_[kN]": thrust, "RootFyc1_[kN]": across, "RootFzc1_[kN]": pull,
        "RootMxc1_[kN-m]": edge, "RootMyc1_[kN-m]": flap, "RootMzc1_[kN-m]": twist,
    }
    table = {"Time_[s]": times}
    # The record is a whole number of turns: its last row is its first.
    table.update({name: np.append(values, values[0]) for name, values in channels.items()})
    return pd.DataFrame(table)


if __name__ == "__main__":
    output = FASTOutputFile()
    output.data = loads()
    output.description = "Synthetic blade root loads by make_root_loads.py; not of OpenFAST."
    output.write(str(pathlib.Path(__file__).with_name("root-loads.outb")), binary=True)
