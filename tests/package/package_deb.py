#!/usr/bin/env python3
"""Makes the Debian packages, looks at what they say and hold, and runs the packaged program.

Usage: package_deb.py CPACK BUILD_FOLDER
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile


def run(*words, wanted=(0,), **more):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, **more)
    if done.returncode not in wanted:
        sys.exit(f"{' '.join(map(str, words))}\n{done.stdout}{done.stderr}exit {done.returncode}")
    return done.stdout


def main(cpack, build):
    with tempfile.TemporaryDirectory(prefix="boxbeam-deb-") as folder:
        folder = pathlib.Path(folder)
        run(cpack, "--config", pathlib.Path(build, "CPackConfig.cmake"), "-B", folder)
        packages = {path.name.split("_")[0]: path for path in folder.glob("*.deb")}
        assert set(packages) == {"boxbeam", "libboxbeam-dev"}, packages
        package = packages["boxbeam"]
        assert re.fullmatch(r"boxbeam_[\d.]+_[a-z0-9]+\.deb", package.name), package.name

        def field(name, of=package):
            return run("dpkg-deb", "--field", of, name).strip()

        assert field("Section") == "science"
        assert "libc6" in field("Depends") and "gnuplot" not in field("Depends")
        for wanted in ("gnuplot-nox", "texlive-latex-base", "texlive-latex-recommended", "lmodern"):
            assert wanted in field("Recommends"), wanted
        description = field("Description").splitlines()
        assert len(description) > 1 and len(description[0]) < 80, description
        assert "libeigen3-dev" in field("Depends", packages["libboxbeam-dev"])

        # Everything belongs to root, nothing may be written by all.
        for of in packages.values():
            for line in run("dpkg-deb", "--contents", of).splitlines():
                assert "root/root" in line and line[8] != "w", line
            listing = run("dpkg-deb", "--contents", of)
            for name in ("copyright", "changelog.gz"):
                assert f"doc/{field('Package', of)}/{name}" in listing, name

        # The packaged program verifies a packaged case.
        root = folder / "root"
        run("dpkg-deb", "-x", package, root)
        program = root / "usr/bin/boxbeam"
        assert run(program, "--version").startswith("boxbeam " + field("Version"))
        out = folder / "report"
        run(program, "verify", root / "usr/share/boxbeam/sections/sledge-rig/rig.toml", "--no-plots",
            "--out", out, wanted=(1,), env={**os.environ, "SOURCE_DATE_EPOCH": "0"})
        results = json.loads((out / "results.json").read_text(encoding="utf-8"))
        # tests/validation/independent_sledge_rig.py
        assert abs(results["governing"]["fatigue"]["safety_factor"] - 1.21259437284) < 1e-9
    print(", ".join(path.name for path in packages.values()))


if __name__ == "__main__":
    main(*sys.argv[1:])
