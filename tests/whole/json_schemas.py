"""Every JSON document of the shipped cases validates against its schema; a document in which a key
is missing or has another name does not.

    python3 json_schemas.py BOXBEAM PROJECT_FOLDER
"""

import copy
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import jsonschema

PROGRAM, PROJECT = sys.argv[1], pathlib.Path(sys.argv[2])
# Keys of these are names that the user gives.
NAMED_BY_USER = {"bodies", "points", "joints", "reactions", "steps", "branch", "alpha"}
# Keys that a document may lack.
OPTIONAL = {"sensitivities", "I_T", "shear_centre", "harmonic", "class", "effective", "shear", "interaction", "reduced_stress", "plates",
            "form", "sorm", "monte-carlo", "importance", "subset"}
NO_PICTURES = ("--no-plots", "--no-html", "--no-pdf")
failures = []


def schema_of(document):
    text = subprocess.run([PROGRAM, "schema", document], capture_output=True, check=True).stdout
    schema = json.loads(text)
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


VALIDATORS = {
    name: schema_of(name) for name in ("results", "motion", "fatigue", "section", "comparison", "solution", "optimum", "study", "reliability")
}


def run(*arguments):
    done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=PROJECT, capture_output=True)
    if done.returncode not in (0, 1):
        raise SystemExit(f"boxbeam {' '.join(map(str, arguments))}: {done.stderr.decode()}")
    return json.loads(done.stdout)


def check(name, document, what):
    for error in VALIDATORS[name].iter_errors(document):
        where = "/".join(map(str, error.absolute_path))
        failures.append(f"{what}: {name} schema at {where}: {error.message[:200]}")


def objects_in(node, path=()):
    """Every kind of object with fixed keys, once: its place and the object."""
    if isinstance(node, list):
        for i, entry in enumerate(node):
            yield from objects_in(entry, (*path, i))
    elif isinstance(node, dict):
        if not path or path[-1] not in NAMED_BY_USER:
            yield path, node
        for key, member in node.items():
            yield from objects_in(member, (*path, key))


def kind_of(path):
    kind = []
    for i, part in enumerate(path):
        by_user = i > 0 and path[i - 1] in NAMED_BY_USER
        kind.append("*" if isinstance(part, int) or by_user else part)
    return tuple(kind)


def shortened(node):
    """The same with two entries of each list of objects, for speed."""
    if isinstance(node, dict):
        return {key: shortened(member) for key, member in node.items()}
    if isinstance(node, list) and node and isinstance(node[0], dict):
        return [shortened(entry) for entry in node[:2]]
    return node


def check_refuses_changes(name, document, what):
    document = shortened(document)
    check(name, document, f"{what}, shortened")
    seen = set()
    changes = 0
    for path, found in objects_in(document):
        if kind_of(path) in seen:
            continue
        seen.add(kind_of(path))
        for key in found:
            # What is refused where a key is missing is refused where it has another name.
            for rename in (True,) if key in OPTIONAL else (False,):
                changed = copy.deepcopy(document)
                at = changed
                for part in path:
                    at = at[part]
                value = at.pop(key)
                if rename:
                    at[key + "_"] = value
                changes += 1
                if VALIDATORS[name].is_valid(changed):
                    failures.append(f"{what}: {'renamed' if rename else 'missing'} "
                                    f"{'/'.join(map(str, (*path, key)))} is not noticed")
    if changes < 10:
        failures.append(f"{what}: only {changes} changes were tried")


def check_units(node, path):
    """Every number of a schema says its unit, where it is not one of several."""
    if isinstance(node, dict):
        kind = node.get("type")
        if kind == "number" or kind == ["number", "null"]:
            if not {"x-unit", "x-unit-in", "description"} & node.keys() and "hand" not in path:
                failures.append(f"schema {path}: a number without unit")
        for key, member in node.items():
            check_units(member, f"{path}/{key}")
    elif isinstance(node, list):
        for member in node:
            check_units(member, path)


for name, validator in VALIDATORS.items():
    check_units(validator.schema, name)

with tempfile.TemporaryDirectory() as folder:
    cases = sorted(PROJECT.glob("sections/*/*.toml"))
    changed = set()
    counted = 0
    for case in cases:
        if case.parent.name in ("catalogue", "templates"):
            continue
        counted += 1
        relative = case.relative_to(PROJECT)
        results = run("verify", relative, "--out", folder, *NO_PICTURES, "--json", "-")
        check("results", results, relative)
        documents = []
        if re.search('kind = "(static|loads)"', case.read_text(encoding="utf-8")):  # no motion
            documents.append(("results", results, ("results", "other")))
        else:
            motion = run("motion", relative, "--json", "-")
            check("motion", motion, relative)
            kind = motion["kind"]
            documents.append(
                ("results", results, ("results", "planar" if kind == "planar" else "other")))
            documents.append(("motion", motion, ("motion", kind)))
        for name, document, kind in documents:
            if kind not in changed:
                changed.add(kind)
                check_refuses_changes(name, document, f"{relative} ({name})")
    if counted < 8:
        failures.append(f"only {counted} shipped cases were found")

    profiles = ("RHS 200x100x8", "CHS 168.3x8", "box 400x600 flange 50 web 50")
    for arguments in [(profile,) for profile in profiles] + [profiles]:
        section = run("section", *arguments, "--json", "-")
        check("section", section, arguments)
        if len(arguments) == 1:
            check_refuses_changes("section", section, arguments)

    history = pathlib.Path(folder) / "history.csv"
    for header, row in (("sigma [MPa]", "{0}"), ("sigma [MPa], tau [MPa]", "{0}, {0}")):
        lines = [row.format(value) for value in (0, 120, 10, 90, 0, 200, 0)]
        history.write_text("\n".join([header, *lines]) + "\n")
        shear = ("--shear-detail", "100") if "tau" in header else ()
        fatigue = run("fatigue", history, "--detail", "100", *shear, "--json", "-")
        check("fatigue", fatigue, header)
        check_refuses_changes("fatigue", fatigue, header)

    for case, table in (
        ("sledge-rig/published.toml", "sledge-rig/thesis.csv"),
        ("landing-gear/gear.toml", "landing-gear/published.csv"),
    ):
        comparison = run("compare", f"sections/{case}", f"sections/{table}", "--json", "-")
        check("comparison", comparison, table)
        check_refuses_changes("comparison", comparison, table)

    solved = ("solve", "sections/four-bar-rocker/rocker.toml", "--for", "fatigue.cycles", "--such-that")
    for wanted in ("fatigue.safety_factor = 1.3", "fatigue.safety_factor = 1e6"):
        solution = run(*solved, wanted, "--json", "-")
        check("solution", solution, wanted)
        check_refuses_changes("solution", solution, wanted)
    study = run("sweep", "sections/sledge-rig/studies/stroke-and-frequency.toml", "--out", folder, "--json", "-")
    check("study", study, "study")
    check_refuses_changes("study", study, "study")
    formula = pathlib.Path(folder) / "formula.toml"
    formula.write_text(
        '[study]\n[variables.r]\ndistribution = "normal"\nmean = 4\nsd = 1\n'
        '[limit_state]\nexpression = "r"\n[reliability]\nyears = 2\n'
        'methods = ["form", "sorm", "monte-carlo", "importance", "subset"]\n')
    indices = pathlib.Path(folder) / "indices.toml"
    indices.write_text(
        '[study]\nsamples = 32\n[variables.r]\ndistribution = "normal"\nmean = 4\nsd = 1\n'
        '[results]\ncolumns = ["f = r^2"]\n[indices]\n')
    with_indices = run("sweep", indices, "--out", f"{folder}/indices", "--json", "-")
    check("study", with_indices, "study with indices")  # they may be missing
    reliability = run("reliability", formula, "--out", folder, "--json", "-")
    check("reliability", reliability, "reliability")
    check_refuses_changes("reliability", reliability, "reliability")

for failure in failures[:50]:
    print(failure)
print(f"{counted} cases, {len(failures)} failures")
sys.exit(1 if failures else 0)
