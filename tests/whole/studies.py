"""Studies as a user runs them: the same bytes by one thread, two, by parts joined, and after having been
killed again and again; rows beside `boxbeam verify`; `boxbeam solve` put back into the case; `boxbeam reliability`
beside a closed form and `solve`.

Usage: studies.py PROGRAM ROOT
"""
import csv
import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

PROGRAM, ROOT = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
RIG = ROOT / "sections/sledge-rig/rig.toml"
failures = []


def check(holds, words):
    if not holds:
        failures.append(words)


def run(*arguments, code=0):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    check(code is None or done.returncode == code,
          f"{' '.join(map(str, arguments))}: exit code {done.returncode}, {done.stderr[-500:]}")
    return done


def study_text(samples, more=""):
    return f"""[study]
case = "{RIG}"
seed = 7
samples = {samples}

[variables.stroke]
key = "drivers.exciter.amplitude"
distribution = "normal"
mean = "0.25 m"
sd = "10 mm"

[variables.frequency]
key = "drivers.exciter.frequency"
values = ["0.6 Hz", "0.7 Hz"]

# The tube no longer fits between thicker flanges: a design that cannot be verified.
[variables.flange]
key = "sections.A1.flange"
values = ["50 mm", "60 mm"]

[results]
columns = ["verdict", "utilisation", "governing.fatigue.safety_factor", "beam.mass"]
{more}"""


def files_of(folder):
    return tuple((folder / name).read_bytes() for name in ("rows.csv", "study.json"))


def check_rows(folder):
    rows = list(csv.DictReader(open(folder / "rows.csv", newline="")))
    check(list(rows[0]) == ["design", "stroke", "frequency", "flange", "verdict", "utilisation",
                            "governing.fatigue.safety_factor", "beam.mass", "status"], f"header {list(rows[0])}")
    check([row["design"] for row in rows] == [str(i + 1) for i in range(len(rows))], "numbers of designs")
    failed = [row for row in rows if row["status"] != "ok"]
    check({row["flange"] for row in failed} == {"60"}, "others failed than those that cannot be built")
    check(len(failed) == len(rows) // 2, f"{len(failed)} of {len(rows)} failed")
    check(all("does not fit" in row["status"] and row["verdict"] == "" for row in failed), "why they failed")
    summary = json.loads((folder / "study.json").read_text())
    check(summary["designs"] == len(rows) and summary["failed"] == len(failed), "designs in study.json")
    good = [row for row in rows if row["status"] == "ok"]
    factors = [float(row["governing.fatigue.safety_factor"]) for row in good]
    of = next(of for of in summary["statistics"] if of["column"] == "governing.fatigue.safety_factor")
    mean = sum(factors) / len(factors)
    sd = (sum((x - mean) ** 2 for x in factors) / (len(factors) - 1)) ** 0.5
    check(abs(of["mean"] - mean) < 1e-12 * mean and abs(of["sd"] - sd) < 1e-9 * sd, "mean and sd of the factor")
    check(of["min"] == min(factors) and of["max"] == max(factors), "least and largest factor")
    check(sorted(factors)[(len(factors) + 1) // 2 - 1] == of["p50"], "the median")
    # A row is what verify says of it.
    row = good[3]
    with tempfile.TemporaryDirectory() as out:
        text = run("verify", RIG, "--set", f"drivers.exciter.amplitude={row['stroke']} m",
                   "--set", f"drivers.exciter.frequency={row['frequency']} Hz",
                   "--out", out, "--no-plots", "--no-pdf", "--no-html", "--json", "-", code=None).stdout
    results = json.loads(text)
    check(results["verdict"] == row["verdict"], "verdict of a row")
    check(results["governing"]["fatigue"]["safety_factor"] == float(row["governing.fatigue.safety_factor"]),
          "factor of a row")


def check_same_bytes(folder, study):
    whole = folder / "whole"
    said = run("sweep", study, "--out", whole, "--threads", 1, "--quiet").stdout
    expected = files_of(whole)
    check_rows(whole)
    written = " ".join(said[said.index("Written to"):].split()).split(": ")[1].split(", ")
    check(sorted(of.name for of in whole.iterdir()) == sorted(written), f"other files than it says: {written}")
    check({"rows.csv", "study.json", "study.html"} <= set(written), f"files: {written}")
    run("sweep", study, "--out", folder / "two", "--threads", 2, "--quiet")
    check(files_of(folder / "two") == expected, "two threads write other bytes than one")
    parts = [folder / f"part{i}" for i in (1, 2, 3)]
    for i, part in enumerate(parts):
        run("sweep", study, "--out", part, "--shard", f"{i + 1}/3", "--quiet")
    missing = run("merge", *parts[:2], code=2)
    check("designs are missing" in missing.stderr, f"a missing part: {missing.stderr}")
    run("merge", *parts, "--out", folder / "joined")
    check(files_of(folder / "joined") == expected, "joined parts are other bytes")
    check(not (parts[0] / "chunks").exists(), "chunks stay behind")
    return expected


def check_kills(folder, study, expected):
    out = folder / "killed"
    kills = 0
    resume = []

    def chunks_done():
        return len(list((out / "chunks").glob("0*.csv")))

    for attempt in range(30):
        before = chunks_done()
        process = subprocess.Popen([PROGRAM, "sweep", study, "--out", out, "--threads", "2", "--quiet", *resume],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        # As soon as there is a chunk more, or, one in three, before that: however fast the machine is.
        while process.poll() is None and attempt % 3 and chunks_done() <= before:
            time.sleep(0.001)
        if process.poll() is not None:
            break
        process.send_signal(signal.SIGKILL if attempt % 2 else signal.SIGINT)
        process.wait()
        kills += 1
        if (out / "chunks/manifest.json").exists():
            if not resume:
                refused = run("sweep", study, "--out", out, code=2)
                check("--resume" in refused.stderr, "nothing is said of --resume")
                check_other_chunks(out, study)
            resume = ["--resume"]
            # A chunk that is not whole is done again.
            chunks = sorted((out / "chunks").glob("0*.csv"))
            if chunks and attempt % 5 == 3:
                chunks[0].write_bytes(chunks[0].read_bytes()[:-9])
            if attempt == 4:
                changed = folder / "changed.toml"
                changed.write_text(study.read_text().replace("seed = 7", "seed = 8"))
                other = run("sweep", changed, "--out", out, "--resume", code=2)
                check("another study" in other.stderr, "a changed study goes on")
    check(kills >= 20, f"only {kills} kills")
    run("sweep", study, "--out", out, "--quiet", *(resume if (out / "chunks").exists() else []))
    check(files_of(out) == expected, "what was killed and gone on with is other bytes")
    print(f"  {kills} kills")


def check_other_chunks(out, study):
    """Chunks of another size are of another study: they are neither gone on with nor joined."""
    manifest = out / "chunks/manifest.json"
    text = manifest.read_text()
    size = json.loads(text)["chunk"]
    manifest.write_text(text.replace(f'"chunk": {size}', f'"chunk": {size + 1}'))
    other = run("sweep", study, "--out", out, "--resume", code=2)
    check("another study" in other.stderr, f"chunks of another size: {other.stderr}")
    manifest.write_text(text)


def check_ended(out, study, expected):
    """A study that has ended is not done again; one whose rows have changed is."""
    start = time.monotonic()
    again = run("sweep", study, "--out", out, "--quiet", "--resume")
    check("none is verified again" in again.stdout and "beam.mass" in again.stdout, f"an ended study: {again.stdout}")
    check(files_of(out) == expected, "an ended study has changed")
    took = time.monotonic() - start
    summary = json.loads(run("sweep", study, "--out", out, "--quiet", "--resume", "--json", "-").stdout)
    check(summary == json.loads(expected[1]), "the summary of an ended study")
    rows = out / "rows.csv"
    rows.write_bytes(rows.read_bytes().replace(b"ok\n", b"OK\n", 1))
    start = time.monotonic()
    anew = run("sweep", study, "--out", out, "--quiet", "--resume")
    check("none is verified again" not in anew.stdout and files_of(out) == expected, "changed rows are believed")
    print(f"  ended: {took:.1f} s, anew: {time.monotonic() - start:.1f} s")


INDICES = """[study]
seed = 5
samples = 1024
sampling = "sobol"
[variables.x1]
distribution = "uniform"
min = -3.141592653589793
max = 3.141592653589793
[variables.x2]
distribution = "uniform"
min = -3.141592653589793
max = 3.141592653589793
[variables.x3]
distribution = "uniform"
min = -3.141592653589793
max = 3.141592653589793
[results]
columns = ["f = sin(x1) + 7*sin(x2)^2 + 0.1*x3^4*sin(x1)"]
[indices]
"""


def check_indices(folder):
    """Ishigami's function, whose indices are known, as a study without a case."""
    study = folder / "ishigami.toml"
    study.write_text(INDICES)
    run("sweep", study, "--out", folder / "indices1", "--threads", 1, "--quiet")
    run("sweep", study, "--out", folder / "indices3", "--threads", 3, "--quiet")
    parts = [folder / f"indices{i}of2" for i in (1, 2)]
    for i, part in enumerate(parts):
        run("sweep", study, "--out", part, "--shard", f"{i + 1}/2", "--quiet")
    run("merge", *parts, "--out", folder / "indices")
    expected = files_of(folder / "indices1")
    for name in ("indices3", "indices"):
        check(files_of(folder / name) == expected, f"{name}: other bytes than one thread")
    check((folder / "indices/indices.svg").exists(), "the figure of indices")
    summary = json.loads(expected[1])
    check(summary["designs"] == 1024 * 5, f"{summary['designs']} designs")
    of = summary["indices"][0]
    exact = {"x1": (0.3139052, 0.5575889), "x2": (0.4424111, 0.4424111), "x3": (0.0, 0.2436837)}
    for at in of["variables"]:
        for name, value in zip(("S1", "ST"), exact[at["variable"]]):
            check(at[f"{name}_low"] <= value <= at[f"{name}_high"], f"{name} of {at}")
            check(abs(at[name] - value) < 0.05, f"{name} of {at}")
    correlated = folder / "correlated.toml"
    correlated.write_text(INDICES + '[correlation]\n"x1,x2" = 0.3\n')
    done = run("sweep", correlated, "--out", folder / "none", code=2)
    check("independent variables" in done.stderr, f"correlated: {done.stderr}")


def check_solve(folder):
    for key, unit, wanted in (("drivers.exciter.amplitude", "m", 2.0), ("drivers.exciter.frequency", "Hz", 1.5),
                              ("fatigue.cycles", "", 1.4)):
        text = run("solve", RIG, "--for", key, "--such-that", f"fatigue.safety_factor = {wanted}", "--json",
                   "-").stdout
        solution = json.loads(text)
        check(len(solution["roots"]) == 1 and solution["reason"] == "", f"{key}: {len(solution['roots'])} values")
        for root in solution["roots"]:
            check(root["unit"] == unit, f"{key}: unit {root['unit']}")
            value = f"{root['value']!r} {unit}".strip()
            again = json.loads(run("verify", RIG, "--set", f"{key}={value}", "--out", folder / "solved", "--no-plots",
                                   "--no-pdf", "--no-html", "--json", "-", code=None).stdout)
            apart = abs(again["governing"]["fatigue"]["safety_factor"] / wanted - 1)
            print(f"  {key} = {value}: the wanted factor within {apart:.1g}")
            check(apart <= 1e-9, f"{key}: apart by {apart}")
    none = run("solve", RIG, "--for", "sections.A1.flange", "--such-that", "fatigue.safety_factor = 20", code=1)
    check("no value" in none.stdout and "does not fit" in none.stdout, f"why there is none: {none.stdout}")
    for arguments, says in (
            (("--for", "driver.exciter.amplitude", "--such-that", "beam.mass = 2 t"), "drivers.exciter.amplitude"),
            (("--for", "drivers.exciter.amplitude", "--such-that", "fatige.safety_factor = 2"), "fatigue"),
            (("--for", "drivers.exciter.amplitude", "--such-that", "beam.mass = 2 m"), "a mass"),
            (("--for", "drivers.exciter.amplitude", "--such-that", "beam.mass"), "not a result"),
            (("--for", "drivers.exciter.amplitude", "--such-that", "beam.mass = 2 t", "--between", "1 s", "2 s"),
             "dimension"),
            (("--for", "case.name", "--such-that", "beam.mass = 2 t"), "no number")):
        done = run("solve", RIG, *arguments, code=2)
        check(says in done.stderr, f"{arguments}: {done.stderr}")


def check_sensitivities(folder):
    def verified(*more):
        text = run("verify", RIG, "--out", folder / "slopes", "--no-plots", "--no-pdf", "--no-html", "--json", "-", *more,
                   code=None).stdout
        return json.loads(text)

    by_input = {of["input"]: {at["criterion"]: at for at in of["slopes"]}
                for of in verified("--sensitivities")["sensitivities"]}
    # Factors are in inverse proportion to partial factors, whatever the rest.
    for name in ("fatigue.gamma_Ff", "fatigue.gamma_Mf"):
        check(abs(by_input[name]["fatigue"]["slope"] + 1) < 1e-6, f"{name}: {by_input[name]['fatigue']}")
        check(by_input[name]["yield"]["slope"] == 0, f"{name} and yielding")
    # Inertia forces are in proportion to the square of the frequency, weight is not: close to -2.
    frequency = by_input["drivers.exciter.frequency"]["fatigue"]["slope"]
    check(-2.1 < frequency < -1.9, f"frequency: {frequency}")
    # The others by the case verified at other values.
    for name, value, unit in (("bodies.sledge.mass", 18627, "kg"), ("sections.A1.height", 600, "mm")):
        factors = [verified("--set", f"{name}={value * of} {unit}")["governing"]["fatigue"]["safety_factor"]
                   for of in (0.99, 1.01)]
        slope = (factors[1] - factors[0]) / 0.02 / (0.5 * sum(factors))
        found = by_input[name]["fatigue"]["slope"]
        check(abs(found - slope) < 0.02 * abs(slope), f"{name}: {found} and {slope}")
    check("case.name" not in by_input, "a name has a slope")


FORMULAS = """[study]
seed = 7
samples = 700
[variables.a]
distribution = "normal"
mean = 10
sd = 1
[variables.b]
values = [1, 2, 3, 4]
[results]
columns = ["f = a*b", "g = sqrt(a - 9)"]
"""


def check_filter(folder):
    """Rows that a condition keeps are those of the whole table, and statistics are those of all designs."""
    whole, kept = folder / "whole.toml", folder / "kept.toml"
    whole.write_text(FORMULAS)
    kept.write_text(FORMULAS + 'keep = "f > 35 || b == 1 && f < 9"\n')
    run("sweep", whole, "--out", folder / "all", "--threads", 1, "--quiet")
    run("sweep", kept, "--out", folder / "kept1", "--threads", 1, "--quiet", "--netcdf")
    run("sweep", kept, "--out", folder / "kept2", "--threads", 2, "--quiet", "--netcdf")
    parts = [folder / f"kept{i}of3" for i in (1, 2, 3)]
    for i, part in enumerate(parts):
        run("sweep", kept, "--out", part, "--shard", f"{i + 1}/3", "--quiet")
    run("merge", *parts, "--out", folder / "kept3", "--netcdf")
    names = sorted(of.name for of in (folder / "kept1").iterdir())
    check("statistics.json" in names and "rows.nc" in names, f"files: {names}")
    for other in ("kept2", "kept3"):
        for name in ("rows.csv", "study.json", "statistics.json", "rows.nc"):
            check((folder / other / name).read_bytes() == (folder / "kept1" / name).read_bytes(), f"{other}: {name}")
    rows = list(csv.DictReader(open(folder / "all/rows.csv", newline="")))
    # Below 9 the root of g is no number: such a design failed, and has its row with the reason.
    wanted = [row for row in rows if row["status"] != "ok" or float(row["f"]) > 35 or
              row["b"] == "1" and float(row["f"]) < 9]
    found = list(csv.DictReader(open(folder / "kept1/rows.csv", newline="")))
    check(found == wanted and 50 < len(found) < 2000, f"{len(found)} rows kept, {len(wanted)} wanted")
    of_all, of_kept = (json.loads((folder / name / "study.json").read_text()) for name in ("all", "kept1"))
    check(of_kept["kept"] == len(found) and of_kept["designs"] == 2800, "counts of a filtered study")
    for key in ("failed", "reasons", "verdicts", "designs"):
        check(of_kept[key] == of_all[key], f"{key} of a filtered study")
    check(of_kept["failed"] > 300, f"{of_kept['failed']} failed")
    for mine, other in zip(of_kept["statistics"], of_all["statistics"]):
        for key in ("count", "mean", "sd", "min", "max"):
            check(mine[key] == other[key], f"{key} of {mine['column']}: {mine[key]} and {other[key]}")
        for key in ("p5", "p50", "p95"):
            check(abs(mine[key] / other[key] - 1) <= mine["quantile_error"] + other["quantile_error"], f"{key} of {mine}")
        check(sum(mine["histogram"]) == mine["count"] and len(mine["histogram"]) == 20, f"histogram of {mine['column']}")
    # Ended, it says the same again; with statistics changed it is done anew.
    before = {name: (folder / "kept1" / name).read_bytes() for name in names}
    again = run("sweep", kept, "--out", folder / "kept1", "--quiet", "--resume")
    check("none is verified again" in again.stdout, f"an ended study: {again.stdout}")
    check({of.name: of.read_bytes() for of in (folder / "kept1").iterdir()} == before, "an ended study has changed")
    (folder / "kept1/statistics.json").write_text("{}\n")
    anew = run("sweep", kept, "--out", folder / "kept1", "--quiet", "--resume")
    check("none is verified again" not in anew.stdout, "changed statistics are believed")
    check((folder / "kept1/statistics.json").read_bytes() == before["statistics.json"], "statistics anew")


def check_table(folder):
    """Designs of a table, beside those of a list."""
    (folder / "designs.csv").write_text("# stock\nflange [mm], steel\n45,S235\n50,S355\n60,S355\n")
    study = folder / "table.toml"
    study.write_text(f'[study]\ncase = "{RIG}"\ntable = "designs.csv"\n'
                     '[variables.flange]\nkey = "sections.A1.flange"\ncolumn = "flange"\n'
                     '[variables.steel]\nkey = "material.steel"\ncolumn = "steel"\n'
                     '[variables.frequency]\nkey = "drivers.exciter.frequency"\nvalues = ["0.6 Hz", "0.7 Hz"]\n'
                     '[results]\ncolumns = ["verdict", "beam.mass"]\n')
    run("sweep", study, "--out", folder / "table", "--quiet")
    rows = list(csv.DictReader(open(folder / "table/rows.csv", newline="")))
    check([(row["flange"], row["steel"], row["frequency"]) for row in rows] ==
          [(flange, steel, frequency) for flange, steel in (("45", "S235"), ("50", "S355"), ("60", "S355"))
           for frequency in ("0.6", "0.7")], f"designs of a table: {rows}")
    check([row["status"] == "ok" for row in rows] == [True] * 4 + [False] * 2, "designs of a table")
    # Another table is another study.
    part = folder / "table-part"
    run("sweep", study, "--out", part, "--shard", "1/2", "--quiet")
    (folder / "designs.csv").write_text("flange [mm], steel\n46,S235\n50,S355\n60,S355\n")
    other = run("sweep", study, "--out", part, "--shard", "1/2", "--quiet", code=2)
    check("another study" in other.stderr, f"another table: {other.stderr}")


BROKEN = """[study]
seed = 7
samples = 20
sampling = "sobol"

[variables.a]
distribution = "normal"
mean = "10 mm"
sd = "1 mm"

[variables.b]
values = [1, 2]

[variables.c]
expression = "2*a + b"
unit = "mm"

[variables.d]
grid = { from = 0, to = 1, count = 3 }

[variables.e]
distribution = "uniform"
min = 1
max = 2

[correlation]
"a,e" = 0.3

[results]
columns = ["f = a*c", "g = b + d"]
keep = "f > 100"
"""


def check_wrong_studies(folder):
    broken = folder / "broken.toml"
    broken.write_text(BROKEN)
    run("sweep", broken, "--out", folder / "not-broken", "--quiet")
    (folder / "short.csv").write_text("t [mm]\n1\n2, 3\n")
    (folder / "good.csv").write_text("t [mm]\n1\n2\n")
    plain = (
        ("seed = 7", "sede = 7", "sede"),
        ("samples = 20", "", "how many designs"),
        ("samples = 20", "samples = 2.5", "whole number"),
        ('"sobol"', '"halton"', "latin hypercube"),
        ("[study]", "[study", "broken.toml:"),
        ('"normal"', '"norml"', "normal"),
        ('mean = "10 mm"', 'mean = "ten"', "no number or quantity"),
        ('sd = "1 mm"', 'sd = "1 s"', "dimension"),
        ('sd = "1 mm"', 'sd = "0 mm"', "not above zero"),
        ('sd = "1 mm"\n', "", "sd"),
        ('"normal"\nmean = "10 mm"', '"weibull"\nmean = "0 mm"', "above zero"),
        ('"normal"\nmean = "10 mm"\nsd = "1 mm"', '"normal"\nmin = 1\nmax = 2', "uniform"),
        ("values = [1, 2]", "values = []", "no list"),
        ("values = [1, 2]", 'values = [1, "2 mm"]', "dimension"),
        ("values = [1, 2]", 'values = [1, "two"]', "no number or quantity"),
        ("values = [1, 2]", "values = [1, 2]\ngrid = { from = 0, to = 1, count = 3 }", "one of"),
        ("values = [1, 2]", "", "which values it takes"),
        ("values = [1, 2]", 'values = [1, 2]\nkey = "beam.density"', "the study has none"),
        ("values = [1, 2]", 'column = "t"', "no table of designs"),
        ('"2*a + b"', '"2*a + q"', "no number of a variable above"),
        ('"2*a + b"', '"2*a + d"', "no number of a variable above"),
        ('"2*a + b"', '"2*a + "', "expression"),
        ('unit = "mm"', 'unit = "millimetre"', "no unit"),
        ("count = 3", "count = 1", "two or more"),
        ("to = 1, ", "", '"to" is missing'),
        ("max = 2", "max = 1", "not below"),
        ('"a,e" = 0.3', '"a,b" = 0.3', "not two variables that scatter"),
        ('"a,e" = 0.3', '"a,e" = 1.5', "between -1 and 1"),
        ('"f = a*c"', '"f = a*q"', "no number of a variable"),
        ('"f = a*c"', '"f"', "no formula"),
        ('"f = a*c"', '"g = a*c"', "twice"),
        ('"f = a*c"', '"b = a*c"', "a variable and a column"),
        ('keep = "f > 100"', 'keep = "f >"', "keep"),
        ('keep = "f > 100"', 'keep = "h > 100"', "no number of a row"),
        ('keep = "f > 100"', 'keep = "verdict > 1"', "utilisation > 1"),
        ('keep = "f > 100"', 'keep = "f > 100"\n[indices]', "leaves some without a row"),
        ("[variables.d]", "[variables.status]", "cannot be the name"),
        ("seed = 7", 'seed = 7\ntable = "missing.csv"', "missing.csv cannot be read"),
        ("seed = 7", 'seed = 7\ntable = "short.csv"', "short.csv:3"),
    )
    for old, new, says in plain:
        check(BROKEN.count(old) >= 1, f"{old} is not in the study")
        broken.write_text(BROKEN.replace(old, new, 1))
        done = run("sweep", broken, "--out", folder / "broken", "--quiet", code=2)
        check(says in done.stderr, f"{new}: {done.stderr}")
        check(not (folder / "broken").exists(), f"{new}: something was written")
    good = study_text(2)
    for change, says in (
            (("drivers.exciter.amplitude", "driver.exciter.amplitude"), "drivers.exciter.amplitude"),
            (('"beam.mass"', '"beam.mas"'), "beam.mass"),
            ((str(RIG), "missing.toml"), "missing.toml"),
            (('sd = "10 mm"', 'sd = "10 s"'), "dimension"),
            (('key = "sections.A1.flange"', 'key = "drivers.exciter.frequency"'), "set by two variables")):
        broken.write_text(good.replace(*change))
        done = run("sweep", broken, "--out", folder / "broken", code=2)
        check(says in done.stderr, f"{change}: {done.stderr}")
    for shard in ("0/3", "4/3", "1", "a/b", "1/0"):
        done = run("sweep", folder / "broken.toml", "--shard", shard, code=2)
        check("--shard" in done.stderr, f"{shard}: {done.stderr}")
    print(f"  {len(plain) + 5 + 5} broken studies")


PAIR = """[study]
seed = 1
samples = 100000
[variables.r]
distribution = "normal"
mean = 4
sd = 1
[variables.s]
distribution = "normal"
mean = 2
sd = 1
[limit_state]
expression = "r - s"
[reliability]
methods = ["form", "sorm", "monte-carlo", "importance", "subset"]
years = 2
"""

# Of the rig's fatigue factor: a stroke that scatters alone, so that a root of the factor is beta.
STROKE = f"""[study]
case = "{RIG}"
[variables.stroke]
key = "drivers.exciter.amplitude"
distribution = "normal"
mean = "0.14 m"
sd = "5 mm"
[limit_state]
check = "fatigue"
[reliability]
methods = ["form"]
starts = 1
"""


def check_reliability(folder):
    study = folder / "pair.toml"
    study.write_text(PAIR)
    run("reliability", study, "--out", folder / "pair1", "--threads", 1, "--quiet")
    text = (folder / "pair1/reliability.json").read_bytes()
    run("reliability", study, "--out", folder / "pair4", "--threads", 4, "--quiet")
    check(text == (folder / "pair4/reliability.json").read_bytes(), "four threads find other numbers than one")
    check((folder / "pair1/importance.svg").exists() and (folder / "pair1/convergence.svg").exists(), "figures")
    methods = json.loads(text)["methods"]
    exact = 0.0786496035  # of N(4, 1) below N(2, 1)
    check(abs(methods["form"]["beta"] - 2 ** 0.5) < 1e-9 and methods["form"]["converged"], f"beta {methods['form']}")
    check(abs(methods["form"]["alpha"]["s"] - 0.5 ** 0.5) < 1e-6, "alpha of a load")
    for name, of in methods.items():
        margin = 4 * of["cov"] * exact if "cov" in of else 1e-6
        check(abs(of["p_f"] - exact) < margin, f"{name}: {of['p_f']}")
        check(abs((1 - of["p_f_per_year"]) ** 2 - (1 - of["p_f"])) < 1e-12, f"{name}: of a year")
    study.write_text(PAIR.replace("seed = 1", "seed = 2"))
    other = json.loads(run("reliability", study, "--out", folder / "pair5", "--quiet", "--json", "-").stdout)
    check(other["methods"]["subset"]["p_f"] != methods["subset"]["p_f"], "another seed, the same samples")

    # One variable of a case: beta is how many standard deviations the stroke of a factor of 1 is away.
    study = folder / "stroke.toml"
    study.write_text(STROKE)
    form = json.loads(run("reliability", study, "--out", folder / "stroke", "--quiet", "--json", "-").stdout)["methods"]["form"]
    required = 2.0  # by the rig
    limit = json.loads(run("solve", RIG, "--for", "drivers.exciter.amplitude", "--such-that",
                           f"fatigue.safety_factor = {required}", "--json", "-").stdout)["roots"][0]["value"]
    beta = (limit - 0.14) / 0.005
    print(f"  beta {form['beta']}, by solve {beta}")
    check(form["converged"] and abs(form["beta"] - beta) < 1e-3, f"beta {form['beta']}, by solve {beta}")
    check(abs(form["design_points"][0]["variables"][0]["value"] - limit) < 1e-5, "stroke at the design point")
    check(form["alpha"]["stroke"] > 0, "a stroke that resists")


def check_wrong_reliability(folder):
    broken = folder / "broken.toml"
    for text, (old, new), says in (
            (PAIR, ('"r - s"', '"r - t"'), "no number of the study"),
            (PAIR, ('"r - s"', '"r - "'), "write a formula"),
            (PAIR, ("expression", "check"), "the study has none"),
            (PAIR, ("expression", "expresion"), "expression"),
            (PAIR, ('"sorm"', '"fosm"'), "one of form, sorm"),
            (PAIR, ("years = 2", "years = 0"), "years"),
            (PAIR, ("years = 2", "per_level = 1"), "below 20"),
            (PAIR, ("years = 2", "variation = 1.5"), "says nothing"),
            (PAIR, ("years = 2", "level = 3"), "level"),
            (PAIR, ('distribution = "normal"\nmean = 4\nsd = 1', "values = [3, 4]"), "several values"),
            (PAIR, ('[limit_state]\nexpression = "r - s"', ""), "where a design fails"),
            (STROKE, ('"fatigue"', '"fatige"'), "fatigue"),
            (STROKE, ('"fatigue"', '"deflection"'), "has no check"),
            (STROKE, ('check = "fatigue"', 'expression = "2 - beam.mass"\n[results]\ncolumns = ["beam.mas"]'),
             "no number of the study"),
            (STROKE, ('check = "fatigue"', 'expression = "2 - beam.mas"\n[results]\ncolumns = ["beam.mas"]'), "beam.mass"),
            (STROKE, ("drivers.exciter", "driver.exciter"), "driver"),
            (STROKE, (str(RIG), "missing.toml"), "missing.toml")):
        check(old in text, f"{old} is not in the study")
        broken.write_text(text.replace(old, new, 1))
        done = run("reliability", broken, "--out", folder / "none", "--quiet", code=2)
        check(says in done.stderr, f"{new}: {done.stderr}")
        check(not (folder / "none").exists(), f"{new}: something was written")
    broken.write_text(PAIR)
    check("no case" in run("sweep", broken, "--out", folder / "none", code=2).stderr, "a sweep without a case")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        study = folder / "study.toml"
        study.write_text(study_text(12))
        start = time.monotonic()
        expected = check_same_bytes(folder, study)
        check_ended(folder / "whole", study, expected)
        # Long enough to be killed again and again.
        long = folder / "long.toml"
        long.write_text(study_text(32))
        run("sweep", long, "--out", folder / "long", "--threads", 1, "--quiet")
        check_kills(folder, long, files_of(folder / "long"))
        check_filter(folder)
        check_table(folder)
        check_indices(folder)
        check_solve(folder)
        check_sensitivities(folder)
        check_wrong_studies(folder)
        check_reliability(folder)
        check_wrong_reliability(folder)
        print(f"  {time.monotonic() - start:.0f} s")
    for words in failures[:30]:
        print("FAILED", words)
    print(f"{len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
