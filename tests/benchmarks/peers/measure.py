"""Asking the library, timing by turns, and charts and maps as plain data.

The data mirror charts/chart.hpp, where their fields are explained.
"""
import json
import re
import statistics
import subprocess
import time


class Refusal(Exception):
    """A program says that it has no result, and why."""


class Library:
    """boxbeam and Simbody: a process that answers a line of JSON with one."""

    def __init__(self, program):
        self.process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        text=True)

    def ask(self, about, **request):
        self.process.stdin.write(json.dumps({"about": about, **request}) + "\n")
        self.process.stdin.flush()
        line = self.process.stdout.readline()
        if not line:
            raise RuntimeError("boxbeam_peers ended, asked for " + json.dumps(request))
        return json.loads(line)

    def close(self):
        self.process.stdin.close()
        self.process.wait()


def short(reason, limit=90):
    """The first sentence or so of a program's message, without the line of its source."""
    line = re.sub(r"^SimTK Exception thrown at \S+ ", "Simbody: ", " ".join(str(reason).split()))
    return line if len(line) <= limit else line[:limit - 3].rstrip() + "..."


def timed(work, least=0.02):
    """Processor time of this thread per call, of as many calls as take `least` seconds."""
    count = 1
    while True:
        begin = time.thread_time()
        for _ in range(count):
            work()
        spent = time.thread_time() - begin
        if spent >= least:
            return spent / count
        count = max(2 * count, int(1.2 * count * least / max(spent, 1e-9)))


def by_turns(alternatives, repetitions):
    """Median, shortest and longest of what each alternative returns [s]. Each begins a round in its
    turn, so that whatever else the machine does falls on all of them."""
    times = [[] for _ in alternatives]
    for repetition in range(repetitions):
        for turn in range(len(alternatives)):
            index = (turn + repetition) % len(alternatives)
            times[index].append(alternatives[index]())
    return [(statistics.median(own), min(own), max(own)) for own in times]


def point(setting, parameter, *, error=None, failure="", operations=None, default=False):
    """One setting of a method; `time` is added by `take_times`."""
    data = {"setting": setting, "parameter": float(parameter), "failure": short(failure),
            "default": default}
    if error is not None:
        data["error"] = float(error)
    if operations is not None:
        data["operations"] = float(operations)
    return data


def series(method, points, yardstick=True):
    return {"method": method, "yardstick": yardstick, "points": points}


def take_times(timers, repetitions):
    """`timers`: pairs of a point, or of several that the same work gave, and what times it."""
    for (points, _), time_of in zip(timers, by_turns([timer for _, timer in timers], repetitions)):
        for one in points:
            one["time"] = time_of


def chart(name, title, *, scene, error, reference, unit, series, lesson, operations="", guides=(),
          floor=None):
    data = {"name": name, "title": title, "scene": scene, "error": error, "reference": reference,
            "operations": operations, "unit": unit, "series": series, "guides": list(guides),
            "lesson": lesson}
    if floor:
        data["floor"] = floor
    return data


def stability_map(name, title, *, scene, reference, x, y, panels, lesson):
    return {"name": name, "title": title, "scene": scene, "reference": reference,
            "x": {"title": x[0], "log": x[1]}, "y": {"title": y[0], "log": y[1]},
            "panels": panels, "lesson": lesson}


def smallest_error(of_series):
    return min((p["error"] for p in of_series["points"] if not p["failure"]), default=float("nan"))
