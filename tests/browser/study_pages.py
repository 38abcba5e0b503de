#!/usr/bin/env python3
"""Pages of studies in a headless Chromium: designs are filtered by keys and pointer, diagrams say what they show,
nothing is fetched, ten thousand designs stay quick.

Usage: study_pages.py PROGRAM PROJECT_ROOT

Prints what fails and "N passed, N failed"; exit code 0: all passed, 1: not, 2: wrong usage or no Chromium.
Python's standard library only.
"""

import csv
import pathlib
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True  # the sources stay as they are
import chromium  # noqa: E402

GRID = """[study]
[variables.a]
grid = { from = 0, to = 2, count = 21 }
[variables.b]
grid = { from = 0, to = 1, count = 11 }
[results]
columns = ["f = a*a + b", "root = sqrt(a - 0.25)"]
"""
MANY = """[study]
samples = 40000
[variables.a]
distribution = "normal"
mean = 10
sd = 2
[variables.b]
distribution = "uniform"
min = 0
max = 1
[results]
columns = ["f = a - 8*b"]
[indices]
"""

SAID = """document.querySelector(".designs output").textContent"""
ROWS = """[...document.querySelectorAll(".designs .rows tbody tr")].map(r => [...r.cells].map(c => c.textContent))"""


class Results:
    """Counts what holds and says what does not."""

    def __init__(self):
        self.passed = self.failed = 0

    def check(self, holds, what):
        if holds:
            self.passed += 1
        else:
            self.failed += 1
            print(f"FAILED: {what}")


def type_into(page, label, value):
    page.run(f"""(() => {{ const i = document.querySelector('[aria-label="{label}"]'); i.value = "{value}";
      i.dispatchEvent(new Event("change")); }})()""")


def drag(page, axis, axes, high, low):
    """Along one of so many axes, between parts of its height."""
    page.run(f"""(() => {{
      const canvas = document.querySelector(".parallel"), box = canvas.getBoundingClientRect();
      canvas.setPointerCapture = () => {{}};
      const x = box.left + 55 + {axis} * (box.width - 110) / {axes - 1};
      const at = (type, part) => canvas.dispatchEvent(new PointerEvent(type,
        {{ clientX: x, clientY: box.top + 46 + (1 - part) * 210, pointerId: 1 }}));
      at("pointerdown", {high}); at("pointermove", {low}); at("pointerup", {low});
    }})()""")


def check_grid(browser, folder, results):
    rows = list(csv.DictReader(open(folder / "rows.csv", newline="", encoding="utf-8")))
    url = (folder / "study.html").as_uri()
    page = browser.open(url)
    failed = [row for row in rows if row["status"] != "ok"]
    results.check(page.run(SAID) == f"{len(rows)} of {len(rows)} designs; {len(failed)} of them do not pass "
                  f"({float(f'{100 * len(failed) / len(rows):.4g}'):g} %)", f"first words: {page.run(SAID)}")
    type_into(page, "a from", "1")
    type_into(page, "f to", "2.2")
    kept = [row for row in rows if float(row["a"]) >= 1 and row["f"] and float(row["f"]) <= 2.2]
    results.check(page.run(SAID).startswith(f"{len(kept)} of {len(rows)} designs;"), f"filtered: {page.run(SAID)}")
    shown = page.run(ROWS)
    results.check([row[0] for row in shown] == [row["design"] for row in kept][:100], "rows that are kept")
    page.run("""document.querySelectorAll(".designs .rows thead button")[2].focus()""")
    page.key("Enter")
    shown = [float(row[3]) for row in page.run(ROWS)]
    results.check(shown == sorted(shown) and len(shown) == len(kept), "rows in the order of f")
    page.run("""document.querySelector(".designs .bar-of button").click()""")
    results.check(page.run(SAID).startswith(f"{len(rows)} of"), "all designs again")
    # The upper half of the first of five axes (the status has one, too).
    drag(page, 0, 5, 1.02, 0.5)
    kept = [row for row in rows if float(row["a"]) >= 1]
    results.check(page.run(SAID).startswith(f"{len(kept)} of"), f"brushed: {page.run(SAID)}")
    drag(page, 0, 5, 0.7, 0.7)
    results.check(page.run(SAID).startswith(f"{len(rows)} of"), "a click takes a brush away")
    says = page.run("""[...document.querySelectorAll(".designs canvas")].map(c => c.getAttribute("aria-label"))""")
    results.check(len(says) == 3 and all(says), f"what diagrams say: {says}")
    results.check("b over a" in says[1] and "Lines of" in says[1], f"the contour: {says[1]}")
    results.check(page.complaints() == [], f"complaints: {page.complaints()}")
    for width in (1280, 390):
        page.resize(width, 900)
        wide = page.run("[document.documentElement.scrollWidth, innerWidth]")
        results.check(wide[0] <= wide[1], f"wider than {width}: {wide}")
    page.close()
    plain = browser.open(url, scripts=False)
    text = plain.run("document.body.innerText")
    results.check("Statistics" in text and "With scripts allowed" in text, "without scripts")
    plain.close()


def check_many(browser, folder, results):
    start = time.monotonic()
    page = browser.open((folder / "study.html").as_uri())
    said = page.run(SAID)
    results.check("10000 of 10000 designs shown, of 160000" in said, f"of many: {said}")
    type_into(page, "a to", "9")
    page.run("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
    results.check(time.monotonic() - start < 20, f"{time.monotonic() - start:.1f} s")
    results.check("Sobol indices" in page.run("document.body.innerText"), "the figure of indices")
    results.check(page.complaints() == [], f"complaints: {page.complaints()}")
    page.close()


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    path = chromium.find()
    if path is None:
        print("no Chromium: install the package chromium", file=sys.stderr)
        return 2
    results = Results()
    with tempfile.TemporaryDirectory(prefix="boxbeam-studies-") as temporary, chromium.Browser(path) as browser:
        for name, text, check in (("grid", GRID, check_grid), ("many", MANY, check_many)):
            study = pathlib.Path(temporary) / f"{name}.toml"
            study.write_text(text, encoding="utf-8")
            folder = pathlib.Path(temporary) / name
            run = subprocess.run([sys.argv[1], "sweep", study, "--out", folder, "--quiet"], capture_output=True,
                                 text=True, check=False)
            results.check(run.returncode == 0, f"boxbeam sweep: {run.stderr}")
            check(browser, folder, results)
    print(f"{results.passed} passed, {results.failed} failed")
    return 1 if results.failed else 0


if __name__ == "__main__":
    sys.exit(main())
