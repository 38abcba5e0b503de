#!/usr/bin/env python3
"""HTML reports in a headless Chromium: the slider moves the drawing, tables sort, nothing is fetched.

Usage: reports.py PROGRAM PROJECT_ROOT

Writes the reports of a planar, a spatial and a flexible case into a temporary folder by PROGRAM.
Prints what fails and "N passed, N failed"; exit code 0: all passed, 1: not, 2: wrong usage or no
Chromium. Python's standard library only.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

sys.dont_write_bytecode = True  # the sources stay as they are
import chromium  # noqa: E402

CASES = ["sections/sledge-rig/rig.toml", "sections/landing-gear/gear.toml",
         "sections/landing-gear/retraction.toml", "sections/drill-truck/truck.toml"]

# The situation whose stress governs: of the leg's flight the landing, whose touch-down is the worst of
# its three parts (46 kN at the foot where the others have 1.3 kN).
GOVERNING = {"landing-gear-retraction": "landing", "drill-truck": "start"}

# What is drawn of the mechanism, in the order of the data: the places of points.
JOINTS = """[...document.querySelectorAll("svg.mechanism circle.joint")]
  .map(c => [Number(c.getAttribute("cx")), Number(c.getAttribute("cy"))])"""
CURVES = """[...document.querySelectorAll("svg.diagrams path.curve")].map(p => p.getAttribute("d"))"""
SLIDER = """document.querySelector(".controls input[type=range]")"""

# Texts of a drawing that reach out of it.
CUT_OFF = """[...document.querySelectorAll("figure.cycle svg")].flatMap(svg => {
  const page = svg.getBoundingClientRect();
  return [...svg.querySelectorAll("text")].filter(t => {
    const box = t.getBoundingClientRect();
    return box.width > 0 && (box.left < page.left - 0.5 || box.right > page.right + 0.5 ||
                             box.top < page.top - 0.5 || box.bottom > page.bottom + 0.5);
  }).map(t => t.textContent);
})"""

# Elements that are wider than the page and do not scroll in a box of their own.
WIDE = """[document.documentElement.scrollWidth, innerWidth]"""


class Results:
    """Counts what holds and says what does not."""

    def __init__(self):
        self.passed = self.failed = 0
        self.case = ""

    def check(self, holds, what):
        if holds:
            self.passed += 1
        else:
            self.failed += 1
            print(f"FAILED: {self.case}: {what}")

    def equal(self, found, expected, what):
        self.check(found == expected, f"{what}: {str(found)[:200]} instead of {str(expected)[:200]}")


def walked(frames):
    """Frames of shapes as they are, of the steps that lead from each to the next."""
    def alike(a, b):
        return [(of[0], len(of)) for of in a] == [(of[0], len(of)) for of in b]
    all_frames = frames[:1]
    for frame in frames[1:]:
        before = all_frames[-1]
        all_frames.append([of[:1] + [x if isinstance(x, str) else x + y for x, y in zip(of[1:], old[1:])]
                           for of, old in zip(frame, before)] if alike(frame, before) else frame)
    return all_frames


def joints_in_data(data, number, frame):
    """Points of a frame of a situation that are drawn by circles, in the view that is shown here."""
    view = data["situations"][number]["views"][ABOVE if in_space(data) else 0]
    return [[x / 10 for x in shape[1:]] for shape in view["frames"][frame]
            if data["kinds"][shape[0]][0] == "joint"]


ABOVE = 3  # the number of the view from above


def in_space(data):
    return len(data["situations"][0]["views"]) > 1


def far_off(drawn, places):
    """The largest distance between what is drawn and the data, in the drawing's units."""
    return max(abs(a - b) for d, p in zip(drawn, places) for a, b in zip(d, p))


def move_to(page, frame):
    page.run(f"""(() => {{ const s = {SLIDER}; s.value = {frame};
      s.dispatchEvent(new Event("input", {{bubbles: true}})); }})()""")


def data_of(page):
    data = json.loads(page.run(
        """document.querySelector('script[type="application/json"]').textContent"""))
    for situation in data["situations"]:
        for view in situation["views"]:
            view["frames"] = walked(view["frames"])
        for cut in situation["diagrams"]["cut"]:
            cut["frames"] = [[sum(step) for step in zip(*cut["frames"][:f + 1])]
                             for f in range(len(cut["frames"]))]
    return data


def check_situations(page, results, governing):
    """The page begins with the governing situation and offers every one, each with its own data."""
    data = data_of(page)
    names = [of["situation"] for of in data["situations"]]
    select = """document.querySelector(".controls select.situation")"""
    if len(names) == 1:
        results.equal(page.run(f"{select} === null"), True, "no choice among one situation")
        return
    results.equal(page.run(f"[...{select}.options].map(o => o.textContent)"), names, "situations offered")
    results.equal(page.run(f"{select}.selectedIndex"), data["first"], "the situation chosen at first")
    results.equal(names[data["first"]], governing, "the situation that it begins with")
    if in_space(data):
        page.run("""(() => { const s = document.querySelector(".controls select.view");
          s.value = "from above, x-y"; s.dispatchEvent(new Event("change")); })()""")
    # The one that it began with comes last, as it was.
    order = [i for i in range(len(names)) if i != data["first"]] + [data["first"]]
    for number in order:
        page.run(f"""(() => {{ const s = {select}; s.value = {number};
          s.dispatchEvent(new Event("change")); }})()""")
        of = data["situations"][number]
        results.equal(page.run(SLIDER + ".valueAsNumber"), of["frame"], f"{names[number]}: first place")
        results.equal(page.run(SLIDER + ".max * 1"), len(of["times"]) - 1, f"{names[number]}: steps")
        for frame in (0, len(of["times"]) // 2, of["frame"]):
            move_to(page, frame)
            drawn, places = page.run(JOINTS), joints_in_data(data, number, frame)
            results.equal(len(drawn), len(places), f"{names[number]}: joints drawn")
            worst = far_off(drawn, places)
            results.check(worst < 0.02, f"{names[number]}: joints are drawn {worst:.3f} px off")
            results.equal(page.run(CUT_OFF), [], f"{names[number]}: texts outside the drawing")
        shown = page.run("""Number(document.querySelectorAll(".readout table")[0].tBodies[0]
          .rows[0].cells[1].textContent)""")
        cut = of["diagrams"]["cut"][0]
        expected = cut["frames"][of["frame"]][of["station"]] * cut["digit"]
        results.check(abs(shown - expected) <= 6e-4 * abs(expected) + 1e-9,
                      f"{names[number]}: {cut['name']} is {shown} instead of {expected}")
    results.equal(page.run("""document.querySelectorAll(".readout table").length"""), 2, "tables")
    if in_space(data):
        page.run("""(() => { const s = document.querySelector(".controls select.view");
          s.value = "oblique"; s.dispatchEvent(new Event("change")); })()""")
    move_to(page, data["situations"][data["first"]]["frame"])


def check_slider(page, results):
    """Every instant is drawn as the data say, on one scale."""
    all_data = data_of(page)
    data = all_data["situations"][all_data["first"]]
    count = len(data["times"])
    results.equal(page.run(SLIDER + ".valueAsNumber"), data["frame"], "the slider's first place")
    first = page.run(JOINTS)
    curves = set()
    times = set()
    worst = 0.0
    if in_space(all_data):
        page.run("""(() => { const s = document.querySelector(".controls select.view");
          s.value = "from above, x-y"; s.dispatchEvent(new Event("change")); })()""")
        results.check(page.run(JOINTS) != first, "another view draws the same")
    postures = set()
    for frame in range(count):
        move_to(page, frame)
        drawn = page.run(JOINTS)
        places = joints_in_data(all_data, all_data["first"], frame)
        if len(drawn) != len(places):
            results.equal(len(drawn), len(places), "joints drawn")
            return
        worst = max(worst, far_off(drawn, places))
        postures.add(json.dumps(drawn))
        curves.add(json.dumps(page.run(CURVES)))
        times.add(page.run("""document.querySelector(".controls output").textContent"""))
        cut_off = page.run(CUT_OFF)
        if cut_off:
            results.equal(cut_off, [], f"texts outside the drawing at frame {frame}")
    results.check(worst < 0.02, f"joints are drawn {worst:.3f} px off their places")
    # Where the drivers hold it, only loads change.
    different = len({json.dumps(joints_in_data(all_data, all_data["first"], frame))
                     for frame in range(count)})
    results.equal(len(postures), different, "postures over the slider")
    results.check(different == 1 or different > 5, f"the mechanism has {different} postures only")
    results.check(len(curves) > count // 3, "the slider does not move the cut forces")
    results.equal(len(times), count, "different times shown")
    check_values(page, data, results)


def check_values(page, data, results):
    """What stands in the table is what the data say, at every tenth station."""
    move_to(page, data["frame"])
    for station in range(0, len(data["stations"]), 10):
        shown = page.run(f"""(() => {{
          const s = document.querySelector(".readout input"); s.value = {station};
          s.dispatchEvent(new Event("input"));
          return [...document.querySelectorAll(".readout table")[0].tBodies[0].rows]
            .map(row => Number(row.cells[1].textContent)); }})()""")
        for cut, value in zip(data["diagrams"]["cut"], shown):
            expected = cut["frames"][data["frame"]][station] * cut["digit"]
            if abs(value - expected) > 6e-4 * abs(expected) + 1e-9:
                results.equal(value, expected, f"{cut['name']} at station {station}")
                return
    results.passed += 1


def check_keys_and_play(page, results):
    frame = page.run(SLIDER + ".valueAsNumber")
    page.run("""document.querySelector(".controls button").focus()""")
    page.key("ArrowRight")
    count = page.run(SLIDER + ".max * 1 + 1")
    results.equal(page.run(SLIDER + ".valueAsNumber"), (frame + 1) % count, "a step by the right arrow")
    page.key("ArrowLeft")
    page.key("ArrowLeft")
    results.equal(page.run(SLIDER + ".valueAsNumber"), (frame - 1) % count, "a step by the left arrow")
    before = page.run(JOINTS), page.run(CURVES)
    page.run("""document.querySelectorAll(".controls button")[1].click()""")
    frames = page.run("""new Promise(done => {
      const seen = new Set();
      const begin = performance.now();
      const look = (now) => {
        seen.add(document.querySelector(".controls output").textContent);
        if (seen.size > 20 || now - begin > 20000) done(seen.size); else requestAnimationFrame(look);
      };
      requestAnimationFrame(look);
    })""")
    results.check(frames > 20, "playing does not move the drawing")
    results.check((page.run(JOINTS), page.run(CURVES)) != before, "playing draws the same")
    page.run("""document.querySelectorAll(".controls button")[1].click()""")
    stopped = page.run(JOINTS)
    page.run("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
    results.equal(page.run(JOINTS), stopped, "after a pause")


COLUMN = """((column) => [...TABLE.tBodies[0].rows].map(row => {
  const cell = row.cells[column];
  return cell.dataset.value === undefined ? cell.textContent : Number(cell.dataset.value);
}))"""


def check_sorting(page, results):
    """The longest table with numbers: by each column, up, down, and back."""
    index = page.run("""(() => {
      const tables = [...document.querySelectorAll("table.data")].filter(
        t => t.tHead.rows[0].cells[0].querySelector("button"));
      const most = Math.max(...tables.map(t => t.tBodies[0].rows.length));
      const table = tables.find(t => t.tBodies[0].rows.length === most);
      const folded = table.closest("details");
      if (folded) folded.open = true;
      return [...document.querySelectorAll("table.data")].indexOf(table);
    })()""")
    table = f"""document.querySelectorAll("table.data")[{index}]"""
    column_of = COLUMN.replace("TABLE", table)
    head = f"{table}.tHead.rows[0].cells"
    numbers = 0
    for column in range(page.run(head + ".length")):
        values = page.run(f"{column_of}({column})")
        page.run(f"""{head}[{column}].querySelector("button").focus()""")
        page.key("Enter")
        upwards = page.run(f"{column_of}({column})")
        results.equal(page.run(f"""{head}[{column}].getAttribute("aria-sort")"""), "ascending",
                      "aria-sort")
        results.equal(sorted(map(str, upwards)), sorted(map(str, values)), "the same rows")
        if all(isinstance(value, (int, float)) for value in values):
            numbers += 1
            results.equal(upwards, sorted(values), f"column {column} upwards")
            page.run(f"""{head}[{column}].querySelector("button").click()""")
            results.equal(page.run(f"{column_of}({column})"), sorted(values, reverse=True),
                          f"column {column} downwards")
    results.check(numbers > 0, "no column of numbers has been sorted")
    results.equal(page.run(f"""{table}.querySelectorAll("[aria-sort]").length"""), 1,
                  "one column is marked as sorted")


def check_links(page, results):
    """A row of the verdict leads to its calculation sheet."""
    titles = page.run("""[...document.querySelectorAll(".verdict a")].map(a =>
      [a.textContent, (document.getElementById(a.hash.slice(1)) || {textContent: ""}).textContent])""")
    results.check(titles != [], "no row of the verdict leads to its sheet")
    for criterion, sheet in titles:
        results.check(criterion in sheet, f"the link of {criterion} leads elsewhere")


def check_without_scripts(browser, url, verdict, results):
    page = browser.open(url, scripts=False)
    text = page.run("document.body.innerText")
    results.check(verdict in text, "the verdict is not seen without scripts")
    results.check(page.run("""[...document.querySelectorAll(".verdict td")].every(
      td => td.getBoundingClientRect().width > 0)"""), "the table of the verdict is not seen")
    results.check(page.run("""document.querySelector("svg.mechanism").getBoundingClientRect().height > 100
      && document.querySelectorAll("svg.mechanism .beam").length > 0"""), "the mechanism is not drawn")
    results.check(page.run("""document.querySelector("noscript p").getBoundingClientRect().height > 0"""),
                  "what is missing is not said")
    results.equal(page.run("""document.querySelectorAll("button").length"""), 0, "dead buttons")
    results.equal(page.run(CUT_OFF), [], "texts outside the drawing without scripts")
    page.close()


def check_print(page, results):
    """A4 pages, as many as the text needs and none that is empty."""
    pdf = page.pdf()
    results.check(pdf.startswith(b"%PDF"), "it does not print")
    pages = len(re.findall(rb"/Type\s*/Page\b", pdf))
    results.check(3 <= pages <= 60, f"it prints on {pages} pages")
    for box in re.findall(rb"/MediaBox\s*\[\s*0 0 ([\d.]+) ([\d.]+)", pdf):
        width, height = map(float, box)
        results.check(abs(width - 595) < 2 and abs(height - 842) < 2, f"page of {width} x {height}")
        break


def check_report(browser, path, results):
    url = path.as_uri()
    document = json.loads((path.parent / "results.json").read_text())
    verdict = document["verdict"].upper()
    xml.etree.ElementTree.parse(path)  # raises where it is not well-formed
    page = browser.open(url)
    results.check(verdict in page.run("""document.querySelector(".verdict h2").textContent"""),
                  "the verdict is not that of results.json")
    check_situations(page, results, GOVERNING.get(document["case"]))
    check_slider(page, results)
    check_keys_and_play(page, results)
    check_sorting(page, results)
    check_links(page, results)
    for width in (1280, 400):
        page.resize(width, 900)
        page.run("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
        across, room = page.run(WIDE)
        results.check(across <= room, f"{across} px wide in a window of {room} px")
        results.equal(page.run(CUT_OFF), [], f"texts outside the drawing at {width} px")
    check_print(page, results)
    results.equal(page.complaints(), [], "complaints")
    results.equal(page.requests(), [url], "what has been requested")
    page.close()
    check_without_scripts(browser, url, verdict, results)


def check_hostile_page(browser, folder, results):
    """The page's own policy keeps foreign scripts and addresses from running and being fetched."""
    text = (folder / "report.html").read_text()
    attack = """<script>document.title = "taken"</script><img src="http://127.0.0.1:9/x.png"/>
      <img src="x" onerror="document.title = 'taken'"/>"""
    path = folder / "attacked.html"
    path.write_text(text.replace("</main>", attack + "</main>"))
    page = browser.open(path.as_uri())
    results.check(page.run("document.title") != "taken", "a foreign script has run")
    results.check(page.run("""document.querySelectorAll(".controls").length""") == 1,
                  "the page's own script has not run")
    blocked = [text for text in page.complaints() if "Content Security Policy" in text]
    results.check(len(blocked) >= 3, f"blocked only {len(blocked)} attacks")
    page.close()


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    program, root = sys.argv[1], pathlib.Path(sys.argv[2])
    path = chromium.find()
    if path is None:
        print("no Chromium: install the package chromium", file=sys.stderr)
        return 2
    results = Results()
    with tempfile.TemporaryDirectory(prefix="boxbeam-reports-") as temporary, \
            chromium.Browser(path) as browser:
        for case in CASES:
            results.case = case
            folder = pathlib.Path(temporary) / pathlib.Path(case).stem
            run = subprocess.run([program, "verify", root / case, "--out", folder, "--no-pdf", "--quiet"],
                                 capture_output=True, text=True, check=False)
            if run.returncode > 1:
                results.check(False, f"boxbeam verify: {run.stderr}")
                continue
            check_report(browser, folder / "report.html", results)
        check_hostile_page(browser, folder, results)
    print(f"{results.passed} passed, {results.failed} failed")
    return 1 if results.failed else 0


if __name__ == "__main__":
    sys.exit(main())
