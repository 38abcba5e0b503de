#!/usr/bin/env python3
"""boxbeam beside other programs, accuracy against time, on this machine in one go.

    peers.py BUILD_FOLDER [OUTPUT_FOLDER] [TOPIC]...

Topics: rig (Simbody, scipy), linkages (the same), toggle (where they fail), beams (CalculiX); all
where none is named. Writes charts and maps as SVG with their data as CSV, and versions.txt.
peers.sh installs what is missing, builds and runs this.
"""
import os

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[variable] = "1"  # one thread each

import json  # noqa: E402
import platform  # noqa: E402
import subprocess  # noqa: E402
import sys  # noqa: E402
import time  # noqa: E402
from pathlib import Path  # noqa: E402

import beams  # noqa: E402
import linkages  # noqa: E402
import sledge  # noqa: E402
import toggle  # noqa: E402
from measure import Library  # noqa: E402

PACKAGES = ("libsimbody-dev", "python3-scipy", "python3-numpy", "calculix-ccx", "python3-mpmath",
            "libblas3")


def processor():
    for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.processor()


def package_version(package):
    run = subprocess.run(["dpkg-query", "-W", "-f=${Version}", package], capture_output=True,
                         text=True, check=False)
    return run.stdout if run.returncode == 0 and run.stdout else "not installed"


def versions(library):
    own = library.ask("versions")
    date = time.strftime("%Y-%m-%d", time.gmtime(int(os.environ.get("SOURCE_DATE_EPOCH",
                                                                    time.time()))))
    lines = [f"date      {date}", f"machine   {processor()}, {os.cpu_count()} processors",
             f"system    {platform.platform()}", f"python    {platform.python_version()}"]
    lines += [f"{name:<9} {version}" for name, version in own.items()]
    lines += [f"{package:<22} {package_version(package)}" for package in PACKAGES]
    lines += ["", "One thread each; times are processor time of the thread, of CalculiX and of",
              "boxbeam as a process that of the whole process.",
              "Rainflow has no peer here: Debian has no package of rainflow for Python, and scipy "
              "has none."]
    return "\n".join(lines) + "\n"


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    build = Path(sys.argv[1]).resolve()
    root = Path(__file__).resolve().parents[3]
    folder = Path(sys.argv[2]) if len(sys.argv) > 2 else root / "reports/accuracy/peers"
    topics = sys.argv[3:] or ["rig", "linkages", "toggle", "beams"]
    program = build / "tests/benchmarks/boxbeam_peers"
    folder.mkdir(parents=True, exist_ok=True)
    library = Library(program)
    shown = {"charts": [], "maps": []}
    for topic in topics:
        begin = time.monotonic()
        if topic == "rig":
            shown["charts"] += sledge.charts(library)
        elif topic == "linkages":
            shown["charts"] += linkages.charts(library)
        elif topic == "toggle":
            shown["maps"] += toggle.maps(library)
        elif topic == "beams":
            shown["charts"] += beams.charts(library, build / "boxbeam")
        else:
            sys.exit(f"no topic {topic}")
        print(f"{topic}: {time.monotonic() - begin:.0f} s", file=sys.stderr)
    (folder / "versions.txt").write_text(versions(library), encoding="utf-8")
    library.close()
    subprocess.run([program, "draw", folder], input=json.dumps(shown), text=True, check=True)
    for one in shown["charts"] + shown["maps"]:
        print(f"{one['title']}\n  {one['lesson']}")


if __name__ == "__main__":
    main()
