"""Near the dead point of the upper rod, beyond it, and from rough postures: right, silently wrong,
or refused. Judged by the closed form of sledge.py."""
import math

import numpy as np

import sledge
from measure import Refusal, short, stability_map

ENOUGH = 1e-6  # [m] off and still right; the two branches are 2.5e-5 m apart at the least
INSTANTS = (12, 24, 48, 96, 192, 384)
MARGINS = (1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2)
ACCURACY = 1e-12
OFF = (0.03, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0)
PHASES = 24


def methods(following):
    """Name, whether for comparison only, and the request to the library or the solver in numpy.
    Where the last instant is taken for a start matters only where one is followed."""
    yield "boxbeam", False, {"way": "boxbeam"}
    for name, model in sledge.SIMBODY:
        if following or model["predicted"]:
            yield (name if following else name.removesuffix(", predicted") + ", its assembler", True,
                   {"way": "simbody", "accuracy": ACCURACY, **model})
    for name, way in sledge.SCIPY:
        yield name, True, way(1e-10)


def judge(found, right):
    """Whether B and E are where they should be."""
    return all(abs(complex(x, y) - complex(p)) < ENOUGH
               for (x, y), p in zip(((found[0], found[1]), (found[2], found[3])), right))


def followed(library, data, truth, method, count):
    if isinstance(method, dict):
        return library.ask("sledge", what="followed", instants=count, rod=truth.rod,
                           amplitude=truth.amplitude, **method)
    return sledge.follow(data, truth, method, count)


def outcome_followed(data, truth, answer, count):
    """One period: wrong as soon as one instant is."""
    for i, row in enumerate(answer["rows"], start=1):
        right = truth.places(data["period"] * i / count)
        if right is None:
            return {"outcome": "wrong", "reason": ""}
        if not judge(row, right):
            return {"outcome": "wrong", "reason": ""}
    if "refused" in answer:
        return {"outcome": "refused", "reason": short(answer["refused"])}
    return {"outcome": "solved", "reason": ""}


def limits():
    """The shortest upper rod that reaches at full stroke, the longest stroke that the rod allows."""
    rig = sledge.rig
    arm, height = rig.LENGTH - rig.PIVOT, rig.BLADE_HEIGHT
    shortest = math.hypot(rig.BLADE_MEAN + rig.BLADE_AMPLITUDE, height) - arm
    longest = math.sqrt((arm + rig.UPPER_ROD)**2 - height**2) - rig.BLADE_MEAN
    return shortest, longest


def count_words(panels, outcome):
    return ", ".join(f"{sum(c['outcome'] == outcome for c in panel['cells'])} by {panel['method']}"
                     for panel in panels)


def followed_map(library, data, name, title, truth_at, x_title, lesson):
    panels = []
    truths = {margin: truth_at(margin) for margin in MARGINS}
    for method_name, yardstick, method in methods(following=True):
        cells = []
        for count in INSTANTS:
            for margin in MARGINS:
                truth = truths[margin]
                answer = followed(library, data, truth, method, count)
                cells.append({"x": margin, "y": count,
                              **outcome_followed(data, truth, answer, count)})
        panels.append({"method": method_name, "yardstick": yardstick, "cells": cells})
    return stability_map(
        name, title, scene="sledge-rig over one period, each instant from the one before",
        reference=f"circles in closed form, 30 digits; wrong: B or E off by {ENOUGH:.0e} m at one "
                  "instant or more",
        x=(x_title, True), y=("instants per period", True), panels=panels,
        lesson=lesson(panels, len(MARGINS) * len(INSTANTS)))


def rough_map(library, data):
    panels = []
    truth = sledge.Truth(data)
    times = [data["period"] * k / PHASES for k in range(PHASES)]
    for method_name, yardstick, method in methods(following=False):
        cells = []
        for phase, time in enumerate(times):
            right = truth.places(time)
            for off in OFF:
                try:
                    if isinstance(method, dict):
                        answer = library.ask("sledge", what="rough", time=time, off=off, **method)
                        if "refused" in answer:
                            raise Refusal(answer["refused"])
                        found = answer["places"]
                    else:
                        own = sledge.NumpyRig(data, method)
                        start = own.posture(right, time)
                        start[[2, 5, 11]] += off
                        own.find(time, start)
                        found = own.places()
                    cell = {"outcome": "solved" if judge(found, right) else "wrong"}
                except Refusal as error:
                    cell = {"outcome": "refused", "reason": short(error)}
                cells.append({"x": off, "y": phase / PHASES, **cell})
        panels.append({"method": method_name, "yardstick": yardstick, "cells": cells})
    return stability_map(
        "peers-rough-start", "From a rough posture, in other programs",
        scene="sledge-rig, instants of one period, the angles of beam and rods off",
        reference="circles in closed form, 30 digits; the branch that is drawn",
        x=("error of all angles at the start [rad]", True), y=("instant / period", False),
        panels=panels,
        lesson=f"Silently on another assembly, of {len(times) * len(OFF)} starts: "
               f"{count_words(panels, 'wrong')}. A solver of equations takes whatever assembly it "
               "comes to; which one is wanted must be part of the input, as it is of boxbeam's.")


def maps(library):
    np.seterr(all="ignore")
    data = library.ask("sledge", what="data")
    shortest, longest = limits()

    def near(panels, trials):
        return (f"Silently wrong, of {trials} runs: {count_words(panels, 'wrong')}. A residual "
                "cannot tell the branches apart; the step must be judged by where it leads.")

    def beyond(panels, _):
        return ("There is no position at full stroke, to refuse is right. Silently wrong: "
                f"{count_words(panels, 'wrong')}.")

    return [
        followed_map(library, data, "peers-toggle-rod", "Short rod near its dead point, in other "
                     "programs", lambda m: sledge.Truth(data, rod=shortest + m),
                     "rod longer than just reaches by [m]", near),
        followed_map(library, data, "peers-toggle-stroke", "Long stroke near the dead point, in "
                     "other programs", lambda m: sledge.Truth(data, amplitude=longest - m),
                     "stroke shorter than just reaches by [m]", near),
        followed_map(library, data, "peers-beyond-reach", "Rod too short, in other programs",
                     lambda m: sledge.Truth(data, rod=shortest - m),
                     "rod too short by [m]", beyond),
        rough_map(library, data)]
