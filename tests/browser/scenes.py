#!/usr/bin/env python3
"""Mechanisms and frames in space, as HTML reports draw them by WebGL, in a headless Chromium.

Usage: scenes.py PROGRAM PROJECT_ROOT [PICTURES]

Writes the reports of cases in space into a temporary folder by PROGRAM. What the page shows of bodies is
compared with what `boxbeam motion` says at the same instants; pixels are counted, and must change with the
slider, the views, the mouse and the keyboard. PICTURES: a folder for what is seen. Prints what fails and
"N passed, N failed"; exit code 0: all passed, 1: not, 2: wrong usage or no Chromium. Python's standard
library only.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # the sources stay as they are
import chromium  # noqa: E402
from reports import SLIDER, Results, move_to  # noqa: E402

CASES = ["sections/landing-gear/gear.toml", "sections/landing-gear/retraction.toml",
         "sections/stewart-rig/rig.toml", "sections/luffing-crane/crane.toml"]
# With one situation, which `boxbeam motion` moves.
MOVED_ALIKE = {"gear.toml", "rig.toml", "crane.toml"}

# A jib on a mast, held by a strut beside its plane, that lifts a load.
FRAME = """[case]
name = "mast-jib"
kind = "static"
[frame]
space = true
[sections.root]
kind = "box"
width = "160 mm"
height = "320 mm"
flange = "12 mm"
web = "8 mm"
[sections.tip]
kind = "box"
width = "160 mm"
height = "160 mm"
flange = "12 mm"
web = "8 mm"
[sections.tube]
kind = "round tube"
diameter = "219.1 mm"
wall = "10 mm"
[beam]
from = ["0 m", "0 m", "3 m"]
to = ["5 m", "0 m", "3 m"]
density = "7850 kg/m^3"
points = { hook = ["5 m", "0 m", "-0.2 m"], lug = ["3 m", "0 m", "0 m"] }
[[beam.segments]]
length = "2 m"
section = "root"
[[beam.segments]]
length = "3 m"
from = "root"
to = "tip"
[members.mast]
from = ["0 m", "0 m", "0 m"]
to = ["0 m", "0 m", "3 m"]
section = "tube"
[members.strut]
from = ["0 m", "-2 m", "0 m"]
to = ["3 m", "0 m", "3 m"]
section = "tube"
[supports.foot]
kind = "fixed"
at = "mast.start"
[supports.side]
kind = "pinned"
at = "strut.start"
[joints.head]
kind = "rigid"
connect = ["mast.end", "beam.start"]
[joints.lug]
kind = "rigid"
connect = ["strut.end", "beam.lug"]
[loads.lift]
kind = "force"
at = "beam.hook"
force = ["2 kN", "3 kN", "-22 kN"]
[[situations]]
name = "empty"
loads = { weight = 1.0 }
[[situations]]
name = "lifting"
loads = { weight = 1.0, lift = 1.0 }
[material]
steel = "S355"
[strength]
required = 1.5
"""

# How many pixels are drawn, in how many colours, and how many there are; kept under a name.
KEEP = """((name) => {
  const gl = document.querySelector("canvas.space").getContext("webgl");
  const all = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
  gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, all);
  (window.kept ||= {})[name] = all;
  let drawn = 0;
  const colours = new Set();
  for (let i = 0; i < all.length; i += 4) {
    if (all[i + 3] === 0) continue;
    drawn += 1;
    colours.add(65536 * all[i] + 256 * all[i + 1] + all[i + 2]);
  }
  return [drawn, colours.size, all.length / 4];
})"""

# Pixels that differ between two that are kept, by more than edges do that the processor smooths now so, now so.
APART = """((a, b) => {
  const [one, other] = [kept[a], kept[b]];
  if (one.length !== other.length) return one.length;
  let apart = 0;
  for (let i = 0; i < one.length; i += 4) {
    if ([0, 1, 2, 3].some((k) => Math.abs(one[i + k] - other[i + k]) > 40)) apart += 1;
  }
  return apart;
})"""
PLAYER = """document.querySelector("figure.cycle").player"""


def keep(page, name):
    return page.run(f"{KEEP}({json.dumps(name)})")


def apart(page, one, other):
    return page.run(f"{APART}({json.dumps(one)}, {json.dumps(other)})")


def is_as(page, name):
    """Whether what is seen is what has been kept, but for a few pixels on edges."""
    keep(page, "now")
    return apart(page, "now", name) <= 400


def press(page, words):
    page.run(f"""[...document.querySelectorAll(".controls button")].find(
      b => b.textContent === {json.dumps(words)}).click()""")


def middle(page):
    return page.run("""(() => { const c = document.querySelector("canvas.space");
      c.scrollIntoView({block: "center"}); const r = c.getBoundingClientRect();
      return [r.left + r.width / 2, r.top + r.height / 2]; })()""")


def mouse(page, kind, x, y, **more):
    page.send("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)


def drag(page, by, modifiers=0):
    x, y = middle(page)
    mouse(page, "mousePressed", x, y, button="left", buttons=1, clickCount=1, modifiers=modifiers)
    mouse(page, "mouseMoved", x + by[0], y + by[1], button="left", buttons=1, modifiers=modifiers)
    mouse(page, "mouseReleased", x + by[0], y + by[1], button="left", modifiers=modifiers)


def check_drawn(page, results, still):
    drawn, colours, room = keep(page, "first")
    results.check(0.01 * room < drawn < 0.9 * room, f"{drawn} of {room} pixels are drawn")
    results.check(colours > 8, f"{colours} colours only: nothing is shaded")
    results.equal(page.run("""getComputedStyle(document.querySelector("svg.mechanism")).display"""), "none",
                  "the flat drawing is not beside it")
    frames = page.run(SLIDER + ".max * 1")
    seen = []
    for part in (0.1, 0.4, 0.7):
        move_to(page, round(part * frames))
        seen.append(is_as(page, "first"))
    results.equal(all(seen), still, "the same all the time")
    critical = """document.querySelector("[aria-label='Go to the critical instant']")"""
    results.check(page.run(f"{critical} !== null && !{critical}.hidden"), "the critical instant is not offered")
    page.run(critical + ".click()")
    results.check(is_as(page, "first"), "the critical instant is not that by which it begins")
    results.check("critical" in page.run("""document.querySelector(".controls output").textContent"""),
                  "the critical instant is not named")
    results.equal(page.run("""document.querySelector(".tick").getBoundingClientRect().height > 3"""), True,
                  "the critical instant is marked on the slider")


def check_views(page, results):
    views = ("Iso", "Front", "Side", "Top")
    for view in views:
        press(page, view)
        keep(page, view)
    for i, view in enumerate(views):
        for other in views[:i]:
            results.check(apart(page, view, other) > 400, f"{view} is as {other}")
    press(page, "Reset")
    results.check(is_as(page, "first"), "a reset does not lead back")
    x, y = middle(page)
    for what, work in {
            "drag": lambda: drag(page, (40, 25)),
            "Shift and drag": lambda: drag(page, (40, 25), modifiers=8),
            "wheel": lambda: mouse(page, "mouseWheel", x + 30, y, deltaX=0, deltaY=-240),
            "key ArrowRight": lambda: page.key("ArrowRight"),
            "key +": lambda: page.send("Input.dispatchKeyEvent", type="keyDown", key="+", text="+")}.items():
        page.run("""document.querySelector("canvas.space").focus()""")
        work()
        page.run("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
        results.check(not is_as(page, "first"), f"{what}: the picture stays")
        press(page, "Reset")
        results.check(is_as(page, "first"), f"after {what} a reset does not lead back")


def check_places(page, results, program, case):
    """Where the page shows bodies is where `boxbeam motion` has them."""
    data = json.loads(page.run("""document.querySelector('script[type="application/json"]').textContent"""))
    of = data["situations"][data["first"]]
    scene = of["scene"]
    times = [of["critical"]["time"]] + [of["times"][k] for k in (0, len(of["times"]) // 3, -1)]
    at = [word for time in times for word in ("--at", repr(time))]
    run = subprocess.run([program, "motion", case, *at, "--json", "-"], capture_output=True, text=True,
                         check=True)
    states = {state["time"]: state["bodies"] for state in json.loads(run.stdout)["states"]}
    worst = 0.0
    for time in times:
        origin = None
        for i, body in enumerate(scene["bodies"]):
            if body is None:
                continue
            place, turn = page.run(f"{PLAYER}.space.pose({i}, {time!r})")
            truth = states[time][body["name"]]
            numbers = [scene["unit"] * x for x in body["strokes"] + body.get("ends", []) + body.get("block", [])]
            for p in zip(*[iter(numbers)] * 3):
                shown = [place[i] + sum(turn[3 * j + i] * p[j] for j in range(3)) for i in range(3)]
                true = [truth["position"][i] + sum(truth["rotation"][i][j] * p[j] for j in range(3)) for i in range(3)]
                # A scene that is followed is shifted as a whole.
                shift = [a - b for a, b in zip(true, shown)]
                origin = origin or (shift if scene["follows"] else [0.0, 0.0, 0.0])
                worst = max([worst] + [abs(a - b) / scene["size"] for a, b in zip(shift, origin)])
    results.check(worst < 1.5e-3, f"bodies are drawn {worst:.2e} of the size astray")


def check_flat_views(page, results):
    """The drawings from four sides can be had, and the scene again."""
    choose = """((name) => { const s = document.querySelector(".controls select.view");
      s.value = name; s.dispatchEvent(new Event("change")); })"""
    names = page.run("""[...document.querySelector(".controls select.view").options].map(o => o.textContent)""")
    results.equal(names[0], "3D", "the first view")
    results.equal(len(names), 5, "views")
    keep(page, "scene")
    page.run(f"{choose}('from above, x-y')")
    results.check(page.run("""document.querySelector("svg.mechanism").getBoundingClientRect().height > 100 &&
      document.querySelector(".space-box").getBoundingClientRect().height === 0"""), "no flat drawing")
    page.run(f"{choose}('3D')")
    results.check(is_as(page, "scene"), "not the scene again")


def check_play(page, results):
    press(page, "Play")
    seen = page.run("""new Promise(done => {
      const seen = new Set();
      const begin = performance.now();
      const look = (now) => {
        seen.add(document.querySelector(".controls output").textContent);
        if (seen.size > 4 || now - begin > 20000) done(seen.size); else requestAnimationFrame(look);
      };
      requestAnimationFrame(look);
    })""")
    results.check(seen > 4, "playing does not move it")
    press(page, "Pause")


def check_scene(browser, report, results, program, case, still, pictures):
    url = report.as_uri()
    page = browser.open(url)
    page.run("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
    results.equal(page.run("""document.querySelectorAll("canvas.space").length"""), 1, "scenes")
    check_drawn(page, results, still)
    check_views(page, results)
    if case is not None:
        check_places(page, results, program, case)
    check_flat_views(page, results)
    check_play(page, results)
    results.equal(page.complaints(), [], "complaints")
    results.equal(page.requests(), [url], "what has been requested")
    for width in (1280, 400):
        page.resize(width, 900)
        page.run("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
        results.check(page.run("""(f => f.scrollWidth <= f.clientWidth && f.getBoundingClientRect().right <= innerWidth)(
          document.querySelector("figure.cycle"))"""), f"too wide at {width} px")
        results.check(keep(page, "narrow")[0] > 500, f"nothing is drawn at {width} px")
    page.close()
    dark = browser.open(url, dark=True)
    results.check(keep(dark, "dark")[0] > 500, "nothing is drawn in the dark")
    dark.close()
    if pictures:
        take_pictures(browser, url, pictures, results.case)


def take_pictures(browser, url, folder, name):
    for dark in (False, True):
        page = browser.open(url, dark=dark)
        last = page.run(SLIDER + ".max * 1")
        for view, part in (("Iso", None), ("Front", 0.3), ("Side", 0.6), ("Top", 0.9)):
            if part is not None:
                move_to(page, round(part * last))
            press(page, view)
            box = page.run("""(() => { const r = document.querySelector("figure.cycle").getBoundingClientRect();
              return [r.left + scrollX, r.top + scrollY, r.width, r.height]; })()""")
            page.picture(pathlib.Path(folder) / f"{name}-{view}{'-dark' if dark else ''}.png", box)
        page.close()


def check_calm(browser, report, results):
    """Who wants less motion sees whole frames only."""
    page = browser.open(report.as_uri(), calm=True)
    press(page, "Play")
    whole = page.run("""new Promise(done => {
      const all = [];
      const look = () => {
        all.push(document.querySelector("figure.cycle").player.frame);
        if (all.length > 30) done(all.slice(1).every(Number.isInteger)); else requestAnimationFrame(look);
      };
      requestAnimationFrame(look);
    })""")
    results.check(whole, "between frames where less motion is wanted")
    page.close()


def check_without_webgl(path, report, results):
    with chromium.Browser(path, webgl=False) as browser:
        page = browser.open(report.as_uri())
        results.equal(page.run("""document.querySelectorAll("canvas").length"""), 0, "canvases without WebGL")
        results.check("WebGL" in page.run("""document.querySelector(".no-space").textContent"""),
                      "what is missing is not said")
        results.check(page.run("""document.querySelector("svg.mechanism").getBoundingClientRect().height > 100"""),
                      "no drawing without WebGL")
        before = page.run("""document.querySelector("svg.mechanism").innerHTML""")
        move_to(page, 7)
        results.check(page.run("""document.querySelector("svg.mechanism").innerHTML""") != before,
                      "the slider does not move the drawing")
        names = page.run("""[...document.querySelector("select.view").options].map(o => o.textContent)""")
        results.check("3D" not in names, "a view that is not there is offered")
        results.equal(page.complaints(), [], "complaints without WebGL")
        page.close()


def main():
    if len(sys.argv) not in (3, 4):
        print(__doc__, file=sys.stderr)
        return 2
    program, root = sys.argv[1], pathlib.Path(sys.argv[2])
    pictures = sys.argv[3] if len(sys.argv) > 3 else None
    path = chromium.find()
    if path is None:
        print("no Chromium: install the package chromium", file=sys.stderr)
        return 2
    results = Results()
    with tempfile.TemporaryDirectory(prefix="boxbeam-scenes-") as temporary, \
            chromium.Browser(path) as browser:
        frame = pathlib.Path(temporary) / "frame.toml"
        frame.write_text(FRAME)
        reports = []
        for case in [root / of for of in CASES] + [frame]:
            results.case = f"{case.parent.name}-{case.stem}" if case != frame else "frame"
            folder = pathlib.Path(temporary) / results.case
            run = subprocess.run([program, "verify", case, "--out", folder, "--no-pdf", "--quiet"],
                                 capture_output=True, text=True, check=False)
            if run.returncode > 1:
                results.check(False, f"boxbeam verify: {run.stderr}")
                continue
            reports.append(folder / "report.html")
            alike = case if case.name in MOVED_ALIKE else None
            check_scene(browser, reports[-1], results, program, alike, case == frame, pictures)
        check_calm(browser, reports[0], results)
        results.case = "without WebGL"
        check_without_webgl(path, reports[0], results)
    print(f"{results.passed} passed, {results.failed} failed")
    return 1 if results.failed else 0


if __name__ == "__main__":
    sys.exit(main())
