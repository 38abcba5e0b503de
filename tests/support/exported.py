"""Reads what `boxbeam verify --export` writes, sharing no code with the program."""
import csv
import json
import pathlib
import subprocess


def run(program, *arguments, **options):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, **options)
    return done.returncode, done.stdout, done.stderr


def verify(program, case, folder, *more):
    """Exit code, what is said and results.json of a verification exported into a folder."""
    folder = pathlib.Path(folder)
    code, said, error = run(program, "verify", case, "--out", folder / "report", "--no-plots", "--no-pdf",
                            "--no-html", "--export", folder / "export", *more)
    if code not in (0, 1):
        raise SystemExit(f"{case}: exit code {code}\n{said}{error}")
    results = json.loads((folder / "report" / "results.json").read_text())
    return code, " ".join(said.split()), results


def table(path):
    """The rows of a table by their heads; numbers as numbers, what is empty as None."""
    def value(text):
        if text == "":
            return None
        try:
            return float(text)
        except ValueError:
            return text
    with open(path, newline="", encoding="utf-8") as file:
        return [{key: text if key == "side" else value(text) for key, text in row.items()}
                for row in csv.DictReader(file)]


class Grid:
    """An unstructured grid of VTK's legacy format."""

    def __init__(self, path):
        words = pathlib.Path(path).read_text().split("\n", 2)
        assert words[0] == "# vtk DataFile Version 3.0", words[0]
        tokens = words[2].split()
        assert tokens[:3] == ["ASCII", "DATASET", "UNSTRUCTURED_GRID"], tokens[:3]
        self.at = 3
        self.tokens = tokens
        count = int(self.take("POINTS")[0])
        assert self.next() == "double"
        self.points = [tuple(float(self.next()) for _ in range(3)) for _ in range(count)]
        cells, size = map(int, self.take("CELLS", 2))
        begin = self.at
        self.cells = []
        for _ in range(cells):
            self.cells.append([int(self.next()) for _ in range(int(self.next()))])
        assert self.at - begin == size, "the size of CELLS"
        assert all(0 <= node < count for cell in self.cells for node in cell)
        assert int(self.take("CELL_TYPES")[0]) == cells
        self.types = [int(self.next()) for _ in range(cells)]
        self.point_data, self.cell_data = {}, {}
        while self.at < len(tokens):
            kind, number = self.next(), int(self.next())
            assert number == {"POINT_DATA": count, "CELL_DATA": cells}[kind]
            into = self.point_data if kind == "POINT_DATA" else self.cell_data
            while self.at < len(tokens) and tokens[self.at] == "SCALARS":
                name, _, one = self.take("SCALARS", 3)
                assert one == "1" and self.take("LOOKUP_TABLE") == ["default"]
                into[name] = [float(self.next()) for _ in range(number)]

    def next(self):
        self.at += 1
        return self.tokens[self.at - 1]

    def take(self, word, count=1):
        assert self.next() == word, (word, self.tokens[self.at - 1])
        return [self.next() for _ in range(count)]
