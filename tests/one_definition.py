#!/usr/bin/env python3
"""Checks that no two files define a type of the same name in the same namespace.

Usage: one_definition.py PROJECT_ROOT

Two types of one name link without a word, and functions made for one of them then work on the other
(the one-definition rule, ISO C++ [basic.def.odr]). Names in unnamed namespaces are a file's own.

Exit code 0: each is defined once; 1: offences, one line each; 2: wrong usage.
"""

import collections
import pathlib
import re
import sys

FOLDERS = ["include", "src", "charts", "python"]
OPENS = re.compile(r"(?:inline )?namespace\s*([\w:]*)\s*\{")
CLOSES = re.compile(r"\}\s*// namespace")
# At the margin, where clang-format leaves what stands in a namespace; `struct Outer::Inner` is not a
# name of the namespace's own.
TYPE = re.compile(r"(?:struct|class|enum class|enum|union)\s+(\w+)(?:\s+final)?\s*(?::[^:].*)?\{")


def types_in(text):
    """Names of the types that a file defines, each behind its namespaces; none of unnamed ones."""
    spaces = []
    for line in text.splitlines():
        if opened := OPENS.match(line):
            spaces.append(opened[1])
        elif CLOSES.match(line):
            spaces.pop()
        elif (found := TYPE.match(line)) and "" not in spaces:
            yield "::".join(spaces + [found[1]])


def main():
    if len(sys.argv) != 2 or not (root := pathlib.Path(sys.argv[1])).is_dir():
        print(__doc__, file=sys.stderr)
        return 2
    where = collections.defaultdict(set)
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*.[ch]pp")):
            for name in types_in(path.read_text(encoding="utf-8")):
                where[name].add(path.relative_to(root).as_posix())
    if not where:
        print(f"{root} defines no types", file=sys.stderr)
        return 2
    twice = {name: files for name, files in where.items() if len(files) > 1}
    for name, files in sorted(twice.items()):
        print(f"{name} is defined in {' and in '.join(sorted(files))}: give one another name")
    return 1 if twice else 0


if __name__ == "__main__":
    sys.exit(main())
