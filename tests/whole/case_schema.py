#!/usr/bin/env python3
"""The schema of a case says what the program reads, no more and no less.

All shipped cases and templates are valid by the schema. In every kind of table of these, and of
tables written here for the kinds that they lack:
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
    ("planar_body", "mass"),  # not of the beam's body
    ("hole", "concentration"),  # not where the row of the hole's detail contains it
    ("link", "length"),  # of the beam's link it is that of the beam
    ("link", "mass"),  # of a rigid link without a profile
    ("planar_beam", "body"),  # not where the loads are those of the Newton chain
    ("newton_chain", "axis_of"),  # of a beam without a body
}
KINDS = ("planar", "spatial", "flexible")


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
            (folder / "table.csv").write_text("time [s],stroke [m]\n0,0\n1,1\n2,0\n")
            for table in beside.glob("*.csv"):
                (folder / table.name).symlink_to(table)
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

    def is_valid(self, instance):
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
        """All tables of fixed keys in a case, with their places."""
        node = self.tree if node is None else node
        if isinstance(instance, dict):
            keys, required, others, name, closed = self.of_table(node, instance)
            if closed or not path:
                yield path, name or ".".join(map(str, path)), set(keys), required
            for key, value in instance.items():
                below = keys.get(key, others)
                if below is not None:
                    yield from self.tables(value, below, (*path, key))
        elif isinstance(instance, list):
            while "$ref" in node:
                node = self.tree["$defs"][node["$ref"].rsplit("/", 1)[1]]
            for index, value in enumerate(instance):
                if "items" in node and isinstance(node["items"], dict):
                    yield from self.tables(value, node["items"], (*path, index))


def at(tree, path):
    for key in path:
        tree = tree[key]
    return tree


def kinds_of_planar(case):
    """Every kind of joint, driver, force and section of a planar case. Together they cannot move;
    they can be read."""
    between = ["rod.A", "ground"]
    at_place = {"connect": between, "at": ["0 m", "0 m"]}
    line = {"point": "ground", "at": ["0 m", "0 m"], "guide": "rod.A", "direction": "0 deg"}
    case["joints"] |= {
        "j1": {"kind": "slider", "angle": "0 deg", "friction": {
            "coefficient": 0.1, "viscous": "1 N s/m", "creep": "1 mm/s", "guide_length": "0.1 m"},
            **line},
        "j2": {"kind": "pin in slot", **line},
        "j3": {"kind": "slider", "point": "rod.A", "through": ["0 m", "0 m"], "direction": "0 deg"},
        "j4": {"kind": "rigid", "angle": "0 deg", **at_place},
        "j5": {"kind": "distance", "length": "1 m", **at_place},
        "j6": {"kind": "angle coupling", "points": ["rod.A", "ground"], "ratio": -2, "offset": "0 deg"},
        "j7": {"kind": "gear", "radii": ["1 m", "2 m"], "offset": "0 m", **at_place},
        "j8": {"kind": "rack", "pinion": "rod.A", "rack": "ground", "at": ["0 m", "0 m"],
               "direction": "0 deg", "radius": "1 m", "offset": "0 m"},
    }
    functions = [
        {"kind": "harmonic", "mean": "0 m", "amplitude": "1 m", "phase": "0 deg", "frequency": "1 Hz",
         "further": [{"amplitude": "1 m", "phase": "0 deg", "angular_frequency": "6 rad/s"},
                     {"amplitude": "1 m", "frequency": "2 Hz"}]},
        {"kind": "harmonic", "mean": "0 m", "amplitude": "1 m", "angular_frequency": "6 rad/s"},
        {"kind": "constant rate", "start": "0 m", "rate": "1 m/s"},
        {"kind": "polynomial", "coefficients": ["0 m", "1 m/s"]},
        {"kind": "smooth step", "from": "0 m", "to": "1 m", "begin": "0 s", "end": "1 s"},
        {"kind": "table", "file": "table.csv", "periodic": False},
        {"kind": "hold", "value": "0 m"},
    ]
    for i, function in enumerate(functions):
        case["drivers"][f"d{i}"] = {"coordinate": "x", "point": "rod.A"} | function
        case["drivers"][f"l{i}"] = {"coordinate": "length", "points": ["rod.A", "ground"],
                                    "at": ["0 m", "0 m"]} | function
    case["drivers"]["angle"] = {"coordinate": "relative angle", "points": ["rod.A", "lever.B"],
                                "kind": "hold", "value": "0 deg"}
    case["forces"] = {
        "f1": {"kind": "spring", "stiffness": "1 N/m", "free_length": "1 m", "damping": "1 N s/m",
               **at_place},
        "f2": {"kind": "torsion spring", "points": ["rod.A", "ground"], "stiffness": "1 N m/rad",
               "free_angle": "0 deg", "damping": "1 N m s/rad"},
        "f3": {"kind": "force", "point": "rod.A", "direction": "0 deg", "turns_with_body": True,
               "size": "1 N"},
        "f4": {"kind": "couple", "points": ["rod.A"],
               "law": {"kind": "harmonic", "mean": "0 N m", "amplitude": "1 N m", "frequency": "1 Hz"}},
    }
    case["bodies"]["crank"] |= {"centre": ["0 m", "0 m"]}
    case["bodies"]["load"]["sketch"] |= {"velocity": ["0 m/s", "0 m/s"], "angular_velocity": "0 rpm"}
    case["loops"]["along"] = {"along": ["rod.A", "lever.B"], "direction": "0 deg", "sign": "+"}
    case["motion"] = {"duration": "1 s", "settle": "0 s"}
    case["model"] = {"demand": "rigid", "tolerance": 0.01, "youngs_modulus": "210 GPa",
                     "shear_modulus": "81 GPa", "damping": {"ratio": 0.01, "at": "1 Hz"},
                     "loads": "measured"}
    box = {"kind": "box", "width": "100 mm", "height": "200 mm"}
    case["sections"] |= {
        "s1": box | {"top_flange": "8 mm", "bottom_flange": "8 mm", "left_web": "8 mm",
                     "right_web": "8 mm", "seam_throat": "3 mm", "stiffeners": [
                         {"on": "top flange", "at": "0 mm", "depth": "20 mm", "thickness": "5 mm"}]},
        "s2": {"kind": "rectangular tube", "width": "100 mm", "height": "200 mm", "wall": "8 mm",
               "outer_radius": "12 mm", "inner_radius": "8 mm"},
        "s3": {"kind": "round tube", "diameter": "100 mm", "wall": "5 mm"},
        "s4": {"kind": "plate", "width": "10 mm", "height": "100 mm"},
        "s5": {"kind": "polygon", "outer": [["0 mm", "0 mm"], ["50 mm", "0 mm"], ["0 mm", "50 mm"]],
               "holes": [[["10 mm", "10 mm"], ["20 mm", "10 mm"], ["10 mm", "20 mm"]]]},
        "s6": {"kind": "thin-walled", "nodes": {"a": ["0 mm", "0 mm"], "b": ["0 mm", "90 mm"]},
               "walls": [{"from": "a", "to": "b", "thickness": "5 mm", "trim_from": "0 mm",
                          "trim_to": "0 mm"}]},
        "s7": {"kind": "standard", "profile": "RHS 200x100x8"},
        "s8": {"kind": "nested", "outer": "s2", "inner": "s4"},
    }
    case["beam"]["places"] = {"lug": "1.4 m"}
    case["beam"]["holes"] = [
        {"name": "a", "diameter": "10 mm", "station": "0.5 m", "through": "webs", "levels": ["0 mm"],
         "concentration": "in-plane bending", "detail": {"category": 90, "name": "a", "assumed": ""}},
        {"name": "b", "diameter": "10 mm", "station": "0.7 m", "through": "flanges",
         "offsets": ["0 mm"], "concentration": "membrane tension"}]
    case["points"] = [{"name": "mine", "station": "1 m", "z": "0 mm"}]
    case["given_stresses"] = [{"name": "g", "station": "1 m", "peak": "10 MPa", "opposite": "1 MPa",
                               "thickness": "8 mm", "time": "0 s", "note": ""}]
    case["equivalent_mass"] = {"joint": "B", "on": "lever", "adjust": "load", "wanted": "1 t"}
    case["pins"] = [{"name": "p", "joint": "B", "diameter": "50 mm", "hole": "50 mm",
                     "inner_plate": "20 mm", "outer_plate": "10 mm", "gap": "1 mm", "steel": "S355",
                     "plate_steel": "S355", "gamma_M0": 1.0, "gamma_M2": 1.25, "required": 1.0}]
    case["rods"] = [{"name": "r", "from": "rod.A", "to": "rod.B", "section": "s3", "curve": "c",
                     "buckling_length": "2 m", "net_area": "1000 mm^2", "gamma_M0": 1.0,
                     "gamma_M1": 1.0, "gamma_M2": 1.25, "required": 1.0, "steel": "S355"}]
    case["deflection"] = {"limit": "5 mm", "against": "chord", "from": "0 m", "to": "2.5 m",
                          "load_factor": True, "youngs_modulus": "210 GPa",
                          "shear_modulus": "81 GPa"}
    fatigue = case["fatigue"]
    del fatigue["category"], fatigue["gamma_Mf"], fatigue["cycles"]
    fatigue |= {"facts": {"part": "seam"}, "assessment": "safe life", "consequence": "high",
                "shear": {"kind": "shear", "category": 80}, "codes": ["IIW"], "name": "weld"}
    case["situations"] = [
        {"name": "slow", "cycles": 1e5, "load_factor": 1.1, "set": {"drivers.motor.rate": "20 rpm"}},
        {"name": "still"}, {"name": "start", "cycles": 1e4, "between": ["still", "slow"]},
        {"name": "day", "cycles": 1e4, "sequence": ["still", "slow"]}]
    return case


def kinds_of_spatial(case):
    def carried(body, **more):
        case["bodies"][body] = {"points": {"P": ["0 m", "0 m", "0 m"]}}
        case["joints"][body] = {"connect": ["ground", f"{body}.P"], "at": ["0 m", "0 m", "0 m"],
                                "turn": [["x", "0 deg"]]} | more

    carried("fixed", kind="fixed")
    carried("slide", kind="prismatic", axis=[1, 0, 0])
    carried("ball", kind="spherical", axes=["x", "y", "z"])
    for joint in ("slide", "ball.1", "ball.2", "ball.3"):
        unit = "m" if joint == "slide" else "deg"
        case["drivers"][joint] = {"joint": joint, "kind": "hold", "value": f"0 {unit}"}
    case["bodies"]["bar"] = {"mass": "1 kg", "uniform_rod": ["P", "Q"],
                             "points": {"P": ["0 m", "0 m", "0 m"], "Q": ["1 m", "0 m", "0 m"]}}
    case["joints"]["bar"] = {"kind": "fixed", "connect": ["ground", "bar.P"]}
    case["bodies"]["load"]["inertia"] = [["15 kg m^2", "0 kg m^2", "0 kg m^2"],
                                         ["0 kg m^2", "15 kg m^2", "0 kg m^2"],
                                         ["0 kg m^2", "0 kg m^2", "10 kg m^2"]]
    case["forces"] |= {
        "line": {"kind": "line force", "from": "jib.B", "to": "jib.D", "axes": "world",
                 "direction": "y", "size": "1 N/m"},
        "couple": {"kind": "couple", "point": "load.D", "on": "load", "axes": "jib", "direction": "x",
                   "law": {"kind": "hold", "value": "1 N m"}}}
    case["motion"] = {"duration": "1 s", "settle": "0 s"}
    case["hand_symbols"] = {"w": 1.0, "a": "0.1 rad"}
    case["hand_formulas"] = [{"name": "speed", "note": "", "time": "0 s", "quantity": "omega",
                              "of": "jib", "formula": ["0", "0", "w*sin(a)"]}]
    return case


def kinds_of_flexible(case):
    case["links"] |= {
        "bar": {"kind": "full", "place": {"point": "start", "at": "boom.end"}, "angle": "0 deg",
                "length": "1 m", "EA": "1 MN", "GA": "1 MN", "EI": "1 MN m^2",
                "mass_per_length": "1 kg/m", "damping": "0.1 ms", "parts": 2},
        "taper": {"kind": "bending", "origin": ["5 m", "0 m"], "angle": "0 deg", "length": "1 m",
                  "sections": ["foot", "tip"], "density": "7850 kg/m^3", "rotary_inertia": True,
                  "youngs_modulus": "210 GPa", "shear_modulus": "81 GPa", "extra_mass": "1 kg/m"},
        "steps": {"kind": "bending", "origin": ["7 m", "0 m"], "segments": [
            {"length": "1 m", "section": "foot"}, {"length": "1 m", "from": "foot", "to": "tip"}]},
        "plain": {"kind": "axial", "origin": ["9 m", "0 m"], "length": "1 m", "section": "tip"},
    }
    case["joints"] |= {
        "slide": {"kind": "sliding", "connect": ["ground", "bar.start"], "at": ["3.3 m", "1.2 m"],
                  "angle": "0 deg", "along": "0 N/m", "normal": "rigid", "along_damping": "1 N s/m",
                  "normal_damping": "1 N s/m", "turning_stiffness": "1 N m/rad",
                  "turning_damping": "1 N m s/rad"},
        "general": {"kind": "general", "connect": ["taper.start", "ground"], "angle": "0 deg",
                    "stiffness": ["1 N/m", "rigid"], "damping": ["1 N s/m", "0 N s/m"]}}
    case["loads"]["shaking"] |= {"force": ["0 N", "1 N"], "moment": "1 N m",
                                 "amplitude_moment": "1 N m"}
    case["model"] |= {"demand": "flexible", "tolerance": 0.01, "element": "corrected",
                      "division": "equal"}
    return case


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
            ("fatigue", {"category": 71, "kind": "shear"}),
            ("fatigue", {"category": 80, "raise_asterisk": True}),
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
        more = {"planar": kinds_of_planar, "spatial": kinds_of_spatial, "flexible": kinds_of_flexible}
        if file.parent.name == "templates":
            templates[file.stem] = cases[-1]
            cases.append((file.parent, more[file.stem](copy.deepcopy(case))))
            errors = [f"{list(e.absolute_path)}: {e.message}"
                      for e in schema.validator.iter_errors(cases[-1][1])]
            assert not errors, f"kinds of {file}: {errors[:5]}"

    of_schema, known, looked_at, taken_away, offences = {}, {}, set(), set(), []
    with tempfile.TemporaryDirectory(prefix="boxbeam-schema-") as folder:
        reader = Reader(program, folder)
        offences += both_refuse(schema, reader, templates)
        for beside, case in cases:
            for path, name, keys, required in schema.tables(case):
                table = at(case, path)
                of_schema.setdefault(name, set()).update(keys)
                known.setdefault(name, set())
                signature = (name, *sorted(table))
                if signature not in looked_at:
                    looked_at.add(signature)
                    changed = copy.deepcopy(case)
                    at(changed, path)[ALIEN] = "1 m"
                    if schema.is_valid(changed):
                        offences.append(f"{name} at {path}: the schema takes an unknown key")
                    words = known_in(reader.complaints(changed, beside))
                    if words is None:
                        offences.append(f"{name} at {path}: the program takes an unknown key")
                    else:
                        known[name] |= words
                for key in table:
                    if (name, key) in taken_away or (name, key) in ONLY_THE_PROGRAM:
                        continue
                    taken_away.add((name, key))
                    changed = copy.deepcopy(case)
                    del at(changed, path)[key]
                    said = reader.complaints(changed, beside)
                    valid = schema.is_valid(changed)
                    if f'has no "{key}"' in said and valid:
                        offences.append(f"{name} at {path}: the schema does without {key}")
                    if key in required and not said:
                        offences.append(f"{name} at {path}: the program does without {key}")
    # What belongs to another kind of case the program knows as well, to refuse it with a reason.
    for name in KINDS:
        known[name] -= {key for other in KINDS for key in of_schema[other]} - of_schema[name]
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
