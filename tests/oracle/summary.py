#!/usr/bin/env python3
"""Adds up what boxbeam_oracle wrote for every hundred cases.

Usage: summary.py SEED CASES DENSITY FOLDER

Exit code 0: all cases agree; 1: some do not; 2: wrong usage; 3: some were not looked at.
"""

import collections
import pathlib
import re
import sys

COUNTS = re.compile(
    r"^cases (\d+), compared (\d+), not analysed (\d+), not covered (\d+), refused (\d+); "
    r"disagreeing (\d+), verdicts that differ (\d+); (\d+) evaluations; ([\d.]+) s$")
MISSES = re.compile(r"^  (.+): (\d+) misses, at most ([\d.]+) %$")
FAULTS = re.compile(r"^  (.+) would show in (\d+) cases$")
NAMES = ["cases", "compared", "not analysed", "not covered", "refused", "disagreeing",
         "verdicts that differ", "evaluations", "seconds of a core"]


def main(arguments):
    if len(arguments) != 4:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    seed, cases = int(arguments[0]), int(arguments[1])
    density, folder = arguments[2], pathlib.Path(arguments[3])
    sums = [0.0] * len(NAMES)
    misses = collections.Counter()
    most = collections.defaultdict(float)
    faults = collections.Counter()
    missing = 0
    for start in range(seed, seed + cases, 100):
        count = min(100, seed + cases - start)
        log = folder / f"{density}-{start}-{count}.txt"
        if not log.exists():
            missing += count
            continue
        for line in log.read_text(encoding="utf-8").splitlines():
            if found := COUNTS.match(line):
                sums = [a + float(b) for a, b in zip(sums, found.groups())]
            elif found := MISSES.match(line):
                misses[found[1]] += int(found[2])
                most[found[1]] = max(most[found[1]], float(found[3]))
            elif found := FAULTS.match(line):
                faults[found[1]] += int(found[2])
    for name, value in zip(NAMES, sums):
        print(f"{name:24s} {value:.0f}")
    for name, count in misses.most_common():
        print(f"missed: {name:24s} {count} cases, at most {most[name]:.3f} %")
    for name, count in faults.most_common():
        print(f"planted: {name:24s} would show in {count} cases")
    if missing:
        print(f"not looked at: {missing} cases")
        return 3
    return 0 if sums[5] == 0 else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
