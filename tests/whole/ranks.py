"""`boxbeam sweep` by several processes under mpirun and its typed columns: the same bytes as by one, read back by
libnetcdf; and what is said where the program is built without MPI.

Usage: ranks.py PROGRAM ROOT
"""
import csv
import ctypes
import ctypes.util
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

PROGRAM, ROOT = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
STUDY = f"""[study]
case = "{ROOT}/sections/sledge-rig/rig.toml"
seed = 7
samples = 10

[variables.stroke]
key = "drivers.exciter.amplitude"
distribution = "normal"
mean = "0.25 m"
sd = "10 mm"

# The tube no longer fits between thicker flanges: a design that cannot be verified.
[variables.flange]
key = "sections.A1.flange"
values = ["50 mm", "60 mm"]

[results]
columns = ["verdict", "governing", "fatigue.safety_factor", "beam.mass"]
"""
failures = []


def check(holds, words):
    if not holds:
        failures.append(words)


def run(*arguments, before=(), code=0, **environment):
    done = subprocess.run([*before, *map(str, arguments)], capture_output=True, text=True,
                          env={**os.environ, **environment})
    check(done.returncode == code, f"{arguments}: exit code {done.returncode}, {done.stderr[-500:]}")
    return done


def files_of(folder):
    return {of.name: of.read_bytes() for of in folder.iterdir()}


class Columns:
    """A file of columns by libnetcdf itself."""

    def __init__(self, path):
        self.library = ctypes.CDLL("libnetcdf.so.19")
        self.id = ctypes.c_int()
        self.ask("nc_open", str(path).encode(), 0, ctypes.byref(self.id))

    def ask(self, function, *arguments):
        code = getattr(self.library, function)(*arguments)
        check(code == 0, f"{function}: {code}")

    def variable(self, name):
        variable = ctypes.c_int()
        self.ask("nc_inq_varid", self.id, name.encode(), ctypes.byref(variable))
        return variable

    def doubles(self, name, count):
        values = (ctypes.c_double * count)()
        self.ask("nc_get_var_double", self.id, self.variable(name), values)
        return list(values)

    def texts(self, name, count):
        values = (ctypes.c_char_p * count)()
        self.ask("nc_get_var_string", self.id, self.variable(name), values)
        return [value.decode() for value in values]

    def units(self, name):
        text = ctypes.create_string_buffer(64)
        self.ask("nc_get_att_text", self.id, self.variable(name), b"units", text)
        return text.value.decode()


def check_columns(folder):
    rows = list(csv.DictReader(open(folder / "rows.csv", newline="")))
    columns = Columns(folder / "rows.nc")
    for name in rows[0]:
        written = [row[name] for row in rows]
        if name in ("verdict", "governing", "status"):
            check(columns.texts(name, len(rows)) == written, f"texts of {name}")
            continue
        for number, cell in zip(columns.doubles(name, len(rows)), written):
            check(number != number if cell == "" else number == float(cell), f"{name}: {number} and {cell}")
    check(columns.units("stroke") == "m" and columns.units("flange") == "mm" and columns.units("beam.mass") == "kg",
          "units of columns")


def check_ranks(folder, study, expected):
    ranks = ("mpirun", "--oversubscribe", "--allow-run-as-root", "-n")
    # Rows that a condition keeps, statistics of all.
    kept = folder / "kept.toml"
    kept.write_text(STUDY + 'keep = "fatigue.safety_factor < 1.2"\n')
    run(PROGRAM, "sweep", kept, "--out", folder / "kept1", "--threads", 1, "--netcdf")
    run(PROGRAM, "sweep", kept, "--out", folder / "kept2", "--threads", 1, "--netcdf", before=(*ranks, "2"))
    check(files_of(folder / "kept1") == files_of(folder / "kept2"), "two processes keep other rows than one")
    rows = list(csv.DictReader(open(folder / "kept1/rows.csv", newline="")))
    check(10 < len(rows) < 20, f"{len(rows)} rows kept of 20, of which 10 failed")
    for count in (2, 3):
        out = folder / f"ranks{count}"
        run(PROGRAM, "sweep", study, "--out", out, "--threads", 1, "--netcdf", before=(*ranks, str(count)))
        check(files_of(out) == expected, f"{count} processes write other bytes than one")
    # Started by another MPI's launcher, each would be alone.
    alone = run(PROGRAM, "sweep", study, "--out", folder / "others", code=2, PMI_SIZE="4")
    check("4 processes" in alone.stderr and "MPI knows 1" in alone.stderr, alone.stderr)
    check(not (folder / "others/rows.csv").exists(), "one of four did all the work")
    # What stands there is of somebody else: one says so, and all end.
    other = folder / "other/chunks"
    other.mkdir(parents=True)
    (other / "manifest.json").write_text("{}\n")
    refused = run(PROGRAM, "sweep", study, "--out", folder / "other", before=(*ranks, "2"), code=2)
    check(refused.stderr.count("has not ended") == 1, refused.stderr)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        study = folder / "study.toml"
        study.write_text(STUDY)
        one = folder / "one"
        run(PROGRAM, "sweep", study, "--out", one, "--threads", 1, "--netcdf")
        check_columns(one)
        if (PROGRAM.parent / "libboxbeam_mpi.so").exists() and shutil.which("mpirun"):
            check_ranks(folder, study, files_of(one))
        else:
            print("  built without MPI: ranks are not tested")
        alone = folder / "boxbeam"
        shutil.copy(PROGRAM, alone)
        refused = run(alone, "sweep", study, "--out", folder / "alone", code=2, OMPI_COMM_WORLD_SIZE="4")
        check("4 processes" in refused.stderr and "--shard" in refused.stderr, refused.stderr)
    for words in failures[:30]:
        print("FAILED", words)
    print(f"{len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
