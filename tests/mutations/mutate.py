#!/usr/bin/env python3
"""Makes one change after the other and runs the tests: which of them are noticed?

Usage: mutate.py --check TREE
       mutate.py --list
       mutate.py TREE RESULTS [--only NAME[,NAME...]] [--jobs N] [--first]

TREE is a copy of the source tree that has been built in TREE/build; its files are changed and put
back. RESULTS is a file of one JSON line a mutation; what stands in it is not done again.
--first runs only the tests named with a mutation, not the whole suite behind them.
--check: every old text is in its file exactly once.

Exit code 0: at most three are not noticed (--check: all old texts are there); 1: more; 2: wrong
usage; 4: the tree cannot be built as it is.
"""

import argparse
import json
import pathlib
import signal
import subprocess
import sys
import time

from mutations import MUTATIONS

MAY_SURVIVE = 0
# A change may make a loop endless.
TEST_SECONDS = 1800


def check(tree):
    """Faults of the list."""
    faults = []
    names = [mutation.name for mutation in MUTATIONS]
    faults += [f"{name}: the name stands twice" for name in set(names) if names.count(name) > 1]
    for mutation in MUTATIONS:
        path = tree / mutation.file
        count = path.read_text(encoding="utf-8").count(mutation.old) if path.exists() else 0
        if count != 1:
            faults.append(f"{mutation.name}: its old text stands {count} times in {mutation.file}")
        if mutation.old == mutation.new:
            faults.append(f"{mutation.name}: changes nothing")
        for stem in mutation.tests.split():
            if not list((tree / "tests").rglob(stem + ".cpp")):
                faults.append(f"{mutation.name}: there is no tests/**/{stem}.cpp")
    return faults


def run(command, seconds, **more):
    """Return code, and whether it ran out of time; takes its children along."""
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                               errors="replace", start_new_session=True, **more)
    try:
        output, _ = process.communicate(timeout=seconds)
        return process.returncode, output
    except subprocess.TimeoutExpired:
        import os
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        return None, "out of time"


def build(tree, jobs):
    code, output = run(["ninja", "-C", str(tree / "build"), "-j", str(jobs), "boxbeam",
                        "boxbeam_tests"], 7200)
    return code == 0, output


def first_failure(output):
    """The name of the test that failed, or how it ended."""
    lines = output.splitlines()
    for i, line in enumerate(lines):
        if line.startswith("/") and line.rstrip().endswith("FAILED:"):
            return pathlib.Path(line.split(":")[0]).stem
        if "(Failed)" in line or "(Timeout)" in line or "(SEGFAULT)" in line:
            return line.split("-", 1)[-1].strip()
    return lines[-1][:100] if lines else ""


def notice(tree, mutation, jobs, only_first):
    """Which stage notices a change that has been made and built, and by which test."""
    tests = str(tree / "build/tests/boxbeam_tests")
    tags = ",".join(f"[#{stem}]" for stem in mutation.tests.split())
    code, output = run([tests, "-#", "-a", tags], TEST_SECONDS, cwd=tree)
    if code is None or code != 0:
        return "first", first_failure(output)
    if only_first:
        return "", ""
    code, output = run(["ctest", "--test-dir", str(tree / "build"), "--stop-on-failure", "-j",
                        str(jobs), "-E", "package|mutations"], 4 * TEST_SECONDS)
    if code is None or code != 0:
        return "suite", first_failure(output)
    return "", ""


def try_one(tree, mutation, jobs, only_first):
    path = tree / mutation.file
    whole = path.read_text(encoding="utf-8")
    begin = time.monotonic()
    path.write_text(whole.replace(mutation.old, mutation.new), encoding="utf-8")
    try:
        built, output = build(tree, jobs)
        if not built:
            return {"name": mutation.name, "result": "does not compile", "by": output[-400:]}
        stage, by = notice(tree, mutation, jobs, only_first)
    finally:
        path.write_text(whole, encoding="utf-8")
    return {"name": mutation.name, "result": "noticed" if stage else "not noticed", "stage": stage,
            "by": by, "seconds": round(time.monotonic() - begin)}


def report(results):
    """The table, and how many were not noticed."""
    print(f"{'mutation':24s} {'result':16s} {'stage':6s} noticed by")
    for mutation in MUTATIONS:
        of = results.get(mutation.name)
        if of is None:
            print(f"{mutation.name:24s} not run")
            continue
        by = of["by"] if of["result"] == "noticed" else mutation.breaks
        print(f"{mutation.name:24s} {of['result']:16s} {of.get('stage', ''):6s} {by}")
    noticed = sum(of["result"] == "noticed" for of in results.values())
    print(f"{noticed} of {len(results)} noticed, {len(MUTATIONS)} in the list")
    return len(results) - noticed


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("Usage: ")[1].split("\n\n")[0])
    parser.add_argument("tree", nargs="?", type=pathlib.Path)
    parser.add_argument("results", nargs="?", type=pathlib.Path)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--first", action="store_true")
    parser.add_argument("--only", default="")
    parser.add_argument("--jobs", type=int, default=2)
    arguments = parser.parse_args()
    if arguments.list:
        for mutation in MUTATIONS:
            print(f"{mutation.name:24s} {mutation.file:48s} {mutation.breaks}")
        return 0
    if arguments.tree is None or (arguments.results is None and not arguments.check):
        parser.error("a tree and a file of results are wanted")
    faults = check(arguments.tree)
    for fault in faults:
        print(fault, file=sys.stderr)
    if arguments.check:
        print(f"{len(MUTATIONS)} mutations, {len(faults)} faults")
        return 1 if faults else 0
    wanted = [name for name in arguments.only.split(",") if name]
    unknown = set(wanted) - {mutation.name for mutation in MUTATIONS}
    if unknown or faults:
        parser.error(f"unknown: {', '.join(unknown)}" if unknown else "the list has faults")

    results = {}
    if arguments.results.exists():
        for line in arguments.results.read_text(encoding="utf-8").splitlines():
            of = json.loads(line)
            results[of["name"]] = of
    built, output = build(arguments.tree, arguments.jobs)
    if not built:
        print(output[-2000:], file=sys.stderr)
        return 4
    for mutation in MUTATIONS:
        if mutation.name in results or (wanted and mutation.name not in wanted):
            continue
        of = try_one(arguments.tree, mutation, arguments.jobs, arguments.first)
        results[mutation.name] = of
        print(f"{of['name']}: {of['result']} {of.get('stage', '')} {of['by']}", file=sys.stderr,
              flush=True)
        with arguments.results.open("a", encoding="utf-8") as file:
            file.write(json.dumps(of) + "\n")
    build(arguments.tree, arguments.jobs)  # as it was
    return 0 if report(results) <= MAY_SURVIVE else 1


if __name__ == "__main__":
    sys.exit(main())
