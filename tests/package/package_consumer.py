#!/usr/bin/env python3
"""Installs boxbeam into a temporary prefix, builds the C++ front page against it and compares what
that prints with results.json. Also: the example stands in docs/library.md as it is here.

Usage: package_consumer.py CMAKE BUILD_FOLDER SOURCE_FOLDER [FLAGS]
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

CASE = "sections/sledge-rig/rig.toml"


def run(*words, wanted=(0,), **more):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, **more)
    if done.returncode not in wanted:
        sys.exit(f"{' '.join(map(str, words))}\n{done.stdout}{done.stderr}exit {done.returncode}")
    return done.stdout


def main(cmake, build, source, flags=""):
    build, source = pathlib.Path(build), pathlib.Path(source)
    front_page = (source / "tests/package/front_page.cpp").read_text(encoding="utf-8")
    assert len(front_page.splitlines()) < 20, "the front page has 20 lines or more"
    readme = (source / "docs/library.md").read_text(encoding="utf-8")
    assert front_page in readme, "docs/library.md does not show tests/package/front_page.cpp as it is"

    with tempfile.TemporaryDirectory(prefix="boxbeam-package-") as folder:
        prefix, user = pathlib.Path(folder, "prefix"), pathlib.Path(folder, "user")
        run(cmake, "--install", build, "--prefix", prefix)
        for name in ("bin/boxbeam", "share/man/man1/boxbeam.1.gz",
                     "share/bash-completion/completions/boxbeam",
                     "share/boxbeam/" + CASE):
            assert (prefix / name).is_file(), f"{name} is not installed"
        run(cmake, "-S", source / "tests/package", "-B", user, f"-DCMAKE_PREFIX_PATH={prefix}",
            "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_CXX_FLAGS={flags}",
            f"-DBOXBEAM_INCLUDE_DIR={prefix}/include")
        run(cmake, "--build", user)
        # The installed program and the user's own agree on the installed case.
        case = prefix / "share/boxbeam" / CASE
        printed = run(user / "front_page", case, wanted=(1,))
        results = json.loads(run(prefix / "bin/boxbeam", "verify", case, "--no-plots", "--no-pdf", "--out",
                                 user / "report", "--json", "-", wanted=(1,)))
        worst = max(results["checks"], key=lambda check: check["utilisation"])
        found = re.fullmatch(r"(.*): (\S+) has factor ([\d.]+), required ([\d.]+) \((.*)\)\n", printed)
        assert found, printed
        assert found[1] == results["verdict"], printed
        assert found[2] == worst["id"], printed
        assert abs(float(found[3]) - worst["safety_factor"]) < 1e-4, printed
        assert float(found[4]) == worst["required"], printed
        assert found[5] == worst["source"], printed
    print(printed, end="")


if __name__ == "__main__":
    main(*sys.argv[1:])
