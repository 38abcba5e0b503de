#!/usr/bin/env python3
"""Checks that a module includes only itself and modules above it.

Usage: include_order.py PROJECT_ROOT

Exit code 0: in order; 1: offences, one line each; 2: wrong usage.
"""

import pathlib
import re
import sys

# From the top to the bottom; modules of one row never include each other.
ROWS = [
    ["core"],
    ["numerics"],
    ["section"],
    ["beam"],
    ["mechanism/common"],
    ["mechanism/planar", "mechanism/spatial", "mechanism/flexible", "mechanism/frame",
     "mechanism/recorded"],
    ["strength"],
    ["fatigue"],
    ["project"],
    ["verification"],
    ["study"],
    ["report"],
    ["charts"],  # a library of its own
    ["program"],  # the commands; part of the program, not of the library
]
ROW_OF = {module: row for row, modules in enumerate(ROWS) for module in modules}
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')


def module_of(path):
    """The module of a path below include/boxbeam/ or src/, None where there is none."""
    folder = path.parent.as_posix()
    while folder not in ROW_OF and "/" in folder:
        folder = folder.rsplit("/", 1)[0]
    return folder if folder in ROW_OF else None


def included_path(root, file, quote, name):
    """Path below its module root of a file of this project, None for any other header."""
    if name.startswith("boxbeam/"):
        return pathlib.PurePosixPath(name).relative_to("boxbeam")
    if (root / name).is_file() and name.startswith("charts/"):
        return pathlib.PurePosixPath(name)
    if quote == '"':  # a private header, beside the file or from src/
        for folder in (file.parent, root / "src"):
            found = (folder / name).resolve()
            for base in (root / "src", root / "include/boxbeam"):
                if found.is_file() and found.is_relative_to(base):
                    return pathlib.PurePosixPath(found.relative_to(base).as_posix())
    return None


def offence_of(own, other):
    """Why a file of module `own` must not include one of module `other`, or None."""
    if other is None:
        return "which belongs to no module of the list"
    if own == other or ROW_OF[other] < ROW_OF[own]:
        return None
    if ROW_OF[other] == ROW_OF[own]:
        return f"but {own} and {other} never include each other"
    return f"but {other} stands below {own}"


def main(arguments):
    if len(arguments) != 1 or not (pathlib.Path(arguments[0]) / "include/boxbeam").is_dir():
        print(__doc__.strip(), file=sys.stderr)
        return 2
    root = pathlib.Path(arguments[0]).resolve()
    offences = []
    files = includes = 0
    for base in (root / "include/boxbeam", root / "src", root / "charts"):
        for file in sorted(p for p in base.rglob("*") if p.suffix in (".hpp", ".cpp")):
            path = pathlib.PurePosixPath(file.relative_to(root if base.name == "charts" else base).as_posix())
            if base.name == "src" and path.as_posix() == "main.cpp":
                continue  # the program may include all
            shown = file.relative_to(root).as_posix()
            files += 1
            own = module_of(path)
            if own is None:
                offences.append(f"{shown}:1: belongs to no module of the list")
                continue
            lines = file.read_text(encoding="utf-8").splitlines()
            for number, line in enumerate(lines, start=1):
                match = INCLUDE.match(line)
                target = match and included_path(root, file, match[1], match[2])
                if not target:
                    continue
                includes += 1
                reason = offence_of(own, module_of(target))
                if reason:
                    offences.append(f"{shown}:{number}: includes {match[2]}, {reason}")
    for offence in offences:
        print(offence)
    order = ", ".join(" | ".join(row) for row in ROWS)
    print(f"checked {includes} includes of {files} files against: {order}")
    if includes == 0:
        print("nothing to check: this is not the project")
        return 1
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
