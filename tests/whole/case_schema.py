#!/usr/bin/env python3
"""The schema of a case says what the program reads, no more and no less.

All shipped cases and templates are valid by the schema, and those in src/project/every_key/,
which have every kind of table. In every kind of table of these:
- a key that nobody knows is refused by both, and the keys that the program then says it knows are
  those of the schema;
- a key without which the program says that the table "has no" such key is missing for the schema
  too; one that the schema requires, the program does not do without.
Values that contradict each other or that cannot be meant are refused by both.

Usage: case_schema.py PROGRAM PROJECT_ROOT
"""

import copy
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib

import jsonschema

ALIEN = "zzzzzzzzzzzz"

# What only the program can know, because it depends on other tables or on catalogues.
ONLY_THE_PROGRAM = {
    ("bodies", "mass"),  # not of the beam's body
    ("beam-holes", "concentration"),  # not where the row of the hole's detail contains it
    ("links", "length"),  # of the beam's link it is that of the beam
    ("links", "mass"),  # of a rigid link without a profile
    ("links", "EA"), ("links", "GA"), ("links", "EI"), ("links", "mass_per_length"),  # not of the beam's
    ("beam", "body"),  # not where the loads are those of the Newton chain
    ("newton_chain", "axis_of"),  # of a beam without a body
    ("fatigue", "cycles"),  # without situations
    ("deflection", "from"), ("deflection", "to"),  # where the supports do not say it
    ("joints", "angle"),  # of a contact that slides on the ground
    ("members", "to"), ("members", "segments"),  # one of them says how long a member is
    ("joints", "axis"), ("loads", "axis"),  # of frames in space
    ("loads", "direction"),  # with the column of a force in it
    ("situations", "loads"),  # of frames that run in the situation
    ("joints", "restitution"),  # of a joint with clearance
    ("joints", "stiffness_at"), ("forces", "stiffness_at"),  # where exponent is 1.5
}
# What the cases with every key name.
TABLES = {name: f"time [s], {column}\n0, 0\n1, 0.1\n2, 0\n" for name, column in {
    "stroke.csv": "stroke [m]", "angle.csv": "angle [rad]", "force.csv": "force [N]",
    "couple.csv": "moment [N m]", "line.csv": "line force [N/m]"}.items()}
SIX = "Fx [kN], Fy [kN], Fz [kN], Mx [kN m], My [kN m], Mz [kN m]"
SENSOR = ("ax [m/s^2], ay [m/s^2], az [m/s^2], wx [rad/s], wy [rad/s], wz [rad/s], "
          "dwx [rad/s^2], dwy [rad/s^2], dwz [rad/s^2], x [m], z [m], angle [deg]")
TABLES["measured.csv"] = f"{SIX}, pressure [bar], {SENSOR}\n" + "".join(
    ", ".join([str(value)] * 19) + "\n" for value in (0, 1, 3))
TABLES["cuts.csv"] = "time [s], " + SIX + "\n0, 0, 0, 0, 0, 0, 0\n1, 1, 1, 1, 1, 1, 1\n"


def toml_of(value):
    """A value in TOML; tables within tables stand in one line."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, list):
        return "[" + ", ".join(toml_of(item) for item in value) + "]"
    rows = (f"{json.dumps(key, ensure_ascii=False)} = {toml_of(each)}" for key, each in value.items())
    return "{ " + ", ".join(rows) + " }"


def plain(name):
    """The name of a kind of table without its kind, and without the number of its definition."""
    return re.sub(r"-\d+$", "", name.split(" ")[0])


def is_closed(schema):
    """Whether a table by this schema has no other keys."""
    return False in (schema.get("additionalProperties"), schema.get("unevaluatedProperties"))


class Reader:
    """The program, asked what it says about a case."""

    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def complaints(self, case, beside):
        """What it says is wrong; "" where nothing is. Tables of numbers are looked for beside."""
        folder = pathlib.Path(self.folder, beside.name)
        if not folder.exists():
            folder.mkdir()
            for table in [*beside.glob("*.csv"), *beside.glob("*.out*")]:
                (folder / table.name).symlink_to(table)
            for table, text in TABLES.items():
                if not (folder / table).exists():
                    (folder / table).write_text(text)
        file = folder / "case.toml"
        file.write_text("".join(f"{key} = {toml_of(value)}\n" for key, value in case.items()),
                        encoding="utf-8")
        done = subprocess.run([self.program, "validate", str(file)], capture_output=True, text=True)
        if done.returncode not in (0, 2):
            sys.exit(f"exit {done.returncode}: {done.stderr}")
        return done.stderr if done.returncode else ""


class Schema:
    def __init__(self, text):
        self.tree = json.loads(text)
        jsonschema.Draft202012Validator.check_schema(self.tree)
        self.validator = jsonschema.Draft202012Validator(self.tree)

    def is_valid(self, instance, node=None, path=()):
        """Whether a case is valid; what its table at `path`, described by `node`, is refused for
        refuses the case, and is looked at first because it is small."""
        if node is not None and path and not self.fits(node, at(instance, path)):
            return False
        return self.validator.is_valid(instance)

    def fits(self, node, instance):
        return self.validator.evolve(schema={**node, "$defs": self.tree["$defs"]}).is_valid(instance)

    def of_table(self, node, instance):
        """The keys that a table may have with their schemas, those that it must have, what its
        other keys are (None: there are no others), and its name."""
        keys, required, others, name, closed, tagged = {}, set(), None, "", False, False

        def add(part):
            nonlocal others, name, closed, tagged
            if "$ref" in part:
                own = part["$ref"].rsplit("/", 1)[1]
                if is_closed(self.tree["$defs"][own]):
                    name = own
                add(self.tree["$defs"][own])
            keys.update(part.get("properties", {}))
            required.update(part.get("required", ()))
            if isinstance(part.get("additionalProperties"), dict):
                others = part["additionalProperties"]
            closed = closed or is_closed(part)
            tagged = tagged or part.get("unevaluatedProperties") is False
            for each in part.get("allOf", ()):
                add(each)
            if "if" in part and self.fits(part["if"], instance):
                add(part["then"])
            for each in part.get("oneOf", ()):
                if ("$ref" in each or "properties" in each) and self.fits(each, instance):
                    add(each)

        add(node)
        kinds = [str(instance[key]) for key in ("kind", "coordinate") if tagged and key in keys and
                 "enum" in keys[key] and key in instance]
        return keys, required, others, " ".join([name, *kinds]), closed

    def tables(self, instance, node=None, path=()):
        """All tables of fixed keys in a case, with their places and what describes them."""
        node = self.tree if node is None else node
        if isinstance(instance, dict):
            keys, required, others, name, closed = self.of_table(node, instance)
            if closed or not path:
                yield path, name or ".".join(map(str, path)), set(keys), required, node
            for key, value in instance.items():
                below = keys.get(key, others)
                if below is not None:
                    yield from self.tables(value, below, (*path, key))
        elif isinstance(instance, list):
            while "$ref" in node:
                node = self.tree["$defs"][node["$ref"].rsplit("/", 1)[1]]
            for each in node.get("oneOf", ()):
                node = each if "items" in each else node
            for index, value in enumerate(instance):
                if "items" in node and isinstance(node["items"], dict):
                    yield from self.tables(value, node["items"], (*path, index))


def at(tree, path):
    for key in path:
        tree = tree[key]
    return tree


def both_refuse(schema, reader, templates):
    """What is wrong with contradictions and with values out of range: nothing, if both refuse them."""
    changes = {
        "planar": [
            ("bodies.crank", {"inertia": "0.3 kg m^2"}),  # beside its uniform_rod
            ("bodies.crank", {"mass": "-40 kg"}),
            ("sections.ends", {"left_web": "8 mm"}),  # beside its web
            ("sections.ends", {"left_web": "8 mm", "right_web": "8 mm"}),
            ("sections.ends", {"bottom_flange": "8 mm"}),
            ("fatigue", {"consequence": "high"}),  # beside its gamma_Mf
            ("fatigue", {"assessment": "safe life", "consequence": "high"}),
            ("fatigue", {"category": 81}),
            ("fatigue", {"cycles": 0}),
            ("fatigue", {"cycles": -1e7}),
            ("fatigue", {"cycles": float("inf")}),
            ("fatigue", {"cycles": 1e21}),
            ("", {"equivalent_mass": {"joint": "B", "on": "lever", "adjust": "load",
                                      "wanted": "0.0 kg"}}),
        ],
        "spatial": [
            ("bodies.load", {"uniform_rod": ["D", "D"]}),  # beside its inertia
            ("bodies.load", {"mass": "-1 kg"}),
        ],
    }
    for name, cases in changes.items():
        for place, change in cases:
            case = copy.deepcopy(templates[name][1])
            at(case, place.split(".") if place else []).update(change)
            if schema.is_valid(case):
                yield f"{name} {place}: the schema takes {change}"
            if not reader.complaints(case, templates[name][0]):
                yield f"{name} {place}: the program takes {change}"


def known_in(complaints):
    """The keys that the program knows where it found the alien one."""
    found = re.search(rf'unknown key "{ALIEN}".*?hint: known here: ([^\n]*)', complaints, re.S)
    return set(found[1].split(", ")) if found else None


def main(program, root):
    root = pathlib.Path(root).resolve()
    text = subprocess.run([program, "schema", "case"], capture_output=True, text=True, check=True).stdout
    schema = Schema(text)
    cases, templates = [], {}
    for file in sorted(root.glob("sections/*/*.toml")):
        if file.parent.name == "catalogue":
            continue
        case = tomllib.loads(file.read_text(encoding="utf-8"))
        errors = [f"{list(e.absolute_path)}: {e.message}" for e in schema.validator.iter_errors(case)]
        assert not errors, f"{file}: {errors[:5]}"
        cases.append((file.parent, case))
        if file.parent.name == "templates":
            templates[file.stem] = cases[-1]
    for file in sorted(root.glob("src/project/every_key/*.toml")):
        case = tomllib.loads(file.read_text(encoding="utf-8"))
        errors = [f"{list(e.absolute_path)}: {e.message}" for e in schema.validator.iter_errors(case)]
        assert not errors, f"{file}: {errors[:5]}"
        cases.append((file.parent, case))

    of_schema, known, looked_at, taken_away, offences = {}, {}, set(), set(), []
    kinds = set()  # what whole cases are called
    with tempfile.TemporaryDirectory(prefix="boxbeam-schema-") as folder:
        reader = Reader(program, folder)
        offences += both_refuse(schema, reader, templates)
        for beside, case in cases:
            for path, name, keys, required, node in schema.tables(case):
                table = at(case, path)
                if not path:
                    kinds.add(name)
                of_schema.setdefault(name, set()).update(keys)
                known.setdefault(name, set())
                signature = (name, *sorted(table))
                if signature not in looked_at:
                    looked_at.add(signature)
                    changed = copy.deepcopy(case)
                    at(changed, path)[ALIEN] = "1 m"
                    if schema.is_valid(changed, node, path):
                        offences.append(f"{name} at {path}: the schema takes an unknown key")
                    words = known_in(reader.complaints(changed, beside))
                    if words is None:
                        offences.append(f"{name} at {path}: the program takes an unknown key")
                    else:
                        known[name] |= words
                for key in table:
                    if (name, key) in taken_away or (plain(name), key) in ONLY_THE_PROGRAM:
                        continue
                    taken_away.add((name, key))
                    changed = copy.deepcopy(case)
                    del at(changed, path)[key]
                    said = reader.complaints(changed, beside)
                    if f'has no "{key}"' in said and schema.is_valid(changed, node, path):
                        offences.append(f"{name} at {path}: the schema does without {key}")
                    if key in required and not said:
                        offences.append(f"{name} at {path}: the program does without {key}")
    # What belongs to another kind of case the program knows as well, to refuse it with a reason.
    for name in kinds:
        known[name] -= {key for other in kinds for key in of_schema[other]} - of_schema[name]
    for name in ("links bending", "links full"):
        known[name] -= {"mass", "inertia", "centre"}  # refused in the beam's link
    for name, keys in of_schema.items():
        if known[name] != keys:
            offences.append(f"{name or 'the case'}: only the program knows {sorted(known[name] - keys)}, "
                            f"only the schema {sorted(keys - known[name])}")
    definitions = {name for name, each in schema.tree["$defs"].items() if is_closed(each)}
    missing = definitions - {word for name in of_schema for word in name.split()}
    if missing:
        offences.append(f"no case here has {sorted(missing)}")
    for offence in offences:
        print(offence)
    print(f"{len(cases)} cases, {len(of_schema)} kinds of table, {len(looked_at)} tables with an "
          f"unknown key, {len(taken_away)} keys taken away")
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
