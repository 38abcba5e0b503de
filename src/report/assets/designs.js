"use strict";
// Designs of a study to be looked through: filtered on parallel axes or by numbers, drawn against each other with
// a contour where there is one, counted, and listed. What is drawn is data: columns of numbers, or of words by place.
(() => {
  const element = (tag, attributes, parent, ...content) => {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
    made.append(...content);
    if (parent) parent.append(made);
    return made;
  };
  const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const short = (x) => (x === null || x === undefined ? "" : String(Number(x.toPrecision(4))));

  // 1, 2 or 5 times a power of ten, so that a span has at most so many steps.
  const step_of = (span, most) => {
    const rough = span / most;
    const power = 10 ** Math.floor(Math.log10(rough));
    return power * [1, 2, 5, 10].find((k) => k * power >= rough * 0.999);
  };
  const tics = (low, high, most) => {
    if (!(high > low)) return [low];
    const step = step_of(high - low, most);
    const all = [];
    for (let k = Math.ceil(low / step - 1e-6); k * step <= high + 1e-6 * step; k += 1) all.push(k * step);
    return all;
  };

  // From dark blue to yellow, told apart by eyes blind to red or green.
  const scale = [[0, 34, 78], [53, 69, 108], [102, 105, 112], [148, 142, 119], [200, 182, 103], [254, 232, 56]];
  const shade = (part) => {
    const at = Math.max(0, Math.min(0.9999, part)) * (scale.length - 1);
    const k = Math.floor(at);
    return `rgb(${scale[k].map((c, i) => Math.round(c + (at - k) * (scale[k + 1][i] - c))).join()})`;
  };

  // A canvas as wide as its place, sharp on every screen.
  const paper = (canvas, width, height) => {
    const ratio = devicePixelRatio || 1;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    canvas.style.width = `${width}px`;
    canvas.style.height = `${height}px`;
    const ink = canvas.getContext("2d");
    ink.setTransform(ratio, 0, 0, ratio, 0, 0);
    ink.clearRect(0, 0, width, height);
    ink.font = "12px system-ui, sans-serif";
    ink.textBaseline = "middle";
    return ink;
  };
  const write = (ink, text, x, y, align, style) => {
    ink.textAlign = align;
    ink.fillStyle = style;
    ink.fillText(text, x, y);
  };
  const fitted = (ink, text, room) => {
    let shown = text;
    while (shown.length > 2 && ink.measureText(shown).width > room) shown = `${shown.slice(0, -2)}…`;
    return shown;
  };

  // Values on a grid as lines of one level: pairs of ends in steps of the grid. Source: marching squares.
  const level_lines = (field, nx, ny, level) => {
    const lines = [];
    for (let j = 0; j + 1 < ny; j += 1) for (let i = 0; i + 1 < nx; i += 1) {
      const at = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
      const v = at.map(([a, b]) => field[b * nx + a]);
      if (v.some((x) => x === null)) continue;
      const hits = [];
      for (let k = 0; k < 4; k += 1) {
        const [a, b] = [v[k], v[(k + 1) % 4]];
        if ((a < level) === (b < level)) continue;
        const part = (level - a) / (b - a);
        hits.push(at[k].map((x, c) => x + part * (at[(k + 1) % 4][c] - x)));
      }
      for (let k = 0; k + 1 < hits.length; k += 2) lines.push([hits[k], hits[k + 1]]);
    }
    return lines;
  };

  class Designs {
    constructor(figure) {
      this.data = JSON.parse(figure.querySelector("script").textContent);
      this.columns = this.data.columns;
      this.count = this.columns[0].values.length;
      for (const of of this.columns) {
        const there = of.values.filter((x) => x !== null);
        [of.low, of.high] = of.words ? [0, of.words.length - 1]
          : there.reduce(([a, b], x) => [Math.min(a, x), Math.max(b, x)], [Infinity, -Infinity]);
        of.varies = of.high > of.low;
        of.label = of.unit ? `${of.name} [${of.unit}]` : of.name;
      }
      const named = (name) => this.columns.find((of) => of.name === name);
      this.verdict = named("verdict") || named("status");
      this.use = named("utilisation");
      // Words that are as many as designs are no axis.
      this.axes = this.columns.filter((of) => of.varies && !(of.words && of.words.length > 12)).slice(0, 14);
      this.filters = new Map();
      this.shown = new Array(this.count).fill(true);
      this.sorted = { by: null, up: true };
      this.build(figure);
      this.update();
      new ResizeObserver(() => this.draw()).observe(figure);
      matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.draw());
    }

    number(row) { return this.data.numbers ? this.data.numbers[row] : row + 1; }
    word(of, row) { return of.words ? of.words[of.values[row]] : short(of.values[row]); }
    passes(row) { return !this.verdict || ["pass", "ok"].includes(this.word(this.verdict, row)); }
    tone(row) {
      if (!this.verdict) return "--accent";
      const word = this.word(this.verdict, row);
      if (word === "pass" || word === "ok") return "--passes";
      return word === "fail" ? "--fails" : "--unclear";
    }

    select(parent, words, columns, chosen, changed) {
      const label = element("label", {}, parent, words);
      const made = element("select", {}, label);
      for (const of of columns) element("option", { value: of.name }, made, of.label);
      made.value = (columns.find((of) => of.name === chosen) || columns[0]).name;
      made.addEventListener("change", changed);
      return () => columns.find((of) => of.name === made.value);
    }

    build(figure) {
      const bar = element("div", { class: "bar-of" });
      this.said = element("output", { "aria-live": "polite" }, bar);
      this.clear = element("button", { type: "button" }, bar, "All designs");
      this.clear.addEventListener("click", () => { this.filters.clear(); this.update(); });
      if (this.verdict) {
        const tones = new Set(this.verdict.values.map((_, row) => this.tone(row)));
        const passes = this.verdict.name === "status" ? "verified" : "pass";
        for (const [tone, words] of [["--passes", passes], ["--fails", "fail"], ["--unclear", "not judged"]]) {
          if (!tones.has(tone)) continue;
          const key = element("span", { class: "key" }, bar);
          element("i", { style: `background:var(${tone})` }, key);
          key.append(words);
        }
      }
      const wide = element("div", { class: "wide", tabindex: "0", role: "region", "aria-label": "Parallel axes" });
      this.parallel = element("canvas", { class: "parallel", role: "img" }, wide);
      this.brush();
      const filters = this.filter_table();
      const two = element("div", { class: "two" });
      this.build_scatter(element("div", {}, two));
      this.build_counts(element("div", {}, two));
      this.table = element("div", { class: "scroll rows", role: "region", tabindex: "0", "aria-label": "Designs" });
      figure.prepend(bar, wide, filters, two, this.table);
    }

    numeric() { return this.columns.filter((of) => of.varies && !of.words); }

    build_scatter(place) {
      const { begin } = this.data;
      const numeric = this.numeric();
      const variables = numeric.filter((of) => of.variable);
      const bar = element("div", { class: "bar-of" }, place);
      const draw = () => this.draw_scatter();
      if (!numeric.length) return;
      const results = numeric.filter((of) => !of.variable);
      const first = begin.x || (variables[0] || numeric[0]).name;
      const second = begin.y || (variables[1] || results[0] || numeric[0]).name;
      this.x = this.select(bar, "across", numeric, first, draw);
      this.y = this.select(bar, "up", numeric, second, draw);
      const of_factor = results.find((of) => of.name.includes("safety_factor")) || this.use || results[0];
      this.z = this.select(bar, "colour", [{ name: "", label: "verdict" }, ...numeric],
        begin.colour || (of_factor && variables.length > 1 ? of_factor.name : ""), draw);
      const label = element("label", {}, bar);
      this.lines = element("input", { type: "checkbox" }, label);
      this.lines.checked = true;
      this.lines.addEventListener("change", draw);
      label.append("contour");
      this.scatter = element("canvas", { role: "img" }, place);
      this.scatter_said = element("p", { class: "said" }, place);
    }

    build_counts(place) {
      const numeric = this.numeric();
      if (!numeric.length) return;
      const bar = element("div", { class: "bar-of" }, place);
      const fallback = (this.use && this.use.varies && this.use) || numeric.find((of) => !of.variable) || numeric[0];
      this.counted = this.select(bar, "how many", numeric, this.data.begin.counted || fallback.name,
        () => this.draw_counts());
      this.counts = element("canvas", { role: "img" }, place);
      this.counts_said = element("p", { class: "said" }, place);
    }

    // The same filters as on the axes, by number or word: for keyboards.
    filter_table() {
      const made = element("details", { class: "filters" });
      element("summary", {}, made, "Filters by number");
      const table = element("table", {}, made);
      this.inputs = new Map();
      for (const of of this.axes) {
        const row = element("tr", {}, table);
        element("th", { scope: "row" }, row, of.label);
        const changed = () => {
          const [a, b] = this.inputs.get(of).map((input) => input.value);
          const low = of.words ? Number(a) : a === "" ? -Infinity : Number(a);
          const high = of.words ? Number(a) : b === "" ? Infinity : Number(b);
          if (of.words ? a === "" : a === "" && b === "") this.filters.delete(of);
          else this.filters.set(of, [low, high]);
          this.update(of);
        };
        const inputs = [];
        if (of.words) {
          const input = element("select", { "aria-label": of.name }, element("td", { colspan: "2" }, row));
          element("option", { value: "" }, input, "any");
          of.words.forEach((word, k) => element("option", { value: k }, input, word || "none"));
          inputs.push(input);
        } else {
          for (const [end, says] of [["low", "from"], ["high", "to"]])
            inputs.push(element("input", { type: "number", step: "any", placeholder: short(of[end]),
              "aria-label": `${of.name} ${says}` }, element("td", {}, row)));
        }
        for (const input of inputs) input.addEventListener("change", changed);
        this.inputs.set(of, inputs);
      }
      return made;
    }

    update(typed) {
      for (let row = 0; row < this.count; row += 1)
        this.shown[row] = [...this.filters].every(([of, [low, high]]) => {
          const x = of.values[row];
          return x !== null && x >= low && x <= high;
        });
      for (const [of, inputs] of this.inputs) {
        if (of === typed) continue;
        const range = this.filters.get(of);
        const words = of.words && range && Math.ceil(range[0]) === Math.floor(range[1]) ? Math.ceil(range[0]) : "";
        if (of.words) inputs[0].value = words;
        else inputs.forEach((input, k) => {
          input.value = range && Number.isFinite(range[k]) ? short(range[k]) : "";
        });
      }
      this.clear.disabled = this.filters.size === 0;
      this.draw();
      this.list();
    }

    chosen() {
      const rows = [];
      for (let row = 0; row < this.count; row += 1) if (this.shown[row]) rows.push(row);
      return rows;
    }

    say() {
      const rows = this.chosen();
      const sampled = this.count < this.data.designs ? ` shown, of ${this.data.designs}` : "";
      let text = `${rows.length} of ${this.count} designs${sampled}`;
      if (this.verdict && rows.length) {
        const failing = rows.filter((row) => !this.passes(row)).length;
        const share = `${short(100 * failing / rows.length)} %`;
        text += this.data.scatters && this.filters.size === 0
          ? `; ${failing} do not pass, p_f about ${share}` : `; ${failing} of them do not pass (${share})`;
      }
      this.said.textContent = text;
    }

    draw() {
      this.say();
      this.draw_parallel();
      if (this.scatter) this.draw_scatter();
      if (this.counts) this.draw_counts();
    }

    // ------------------------------------------------------------------------------- parallel axes
    height_at(of, x) { return 46 + (of.high - x) / (of.high - of.low) * 210; }

    draw_parallel() {
      const axes = this.axes;
      const width = Math.max(this.parallel.parentNode.clientWidth, 84 * axes.length);
      const ink = paper(this.parallel, width, 290);
      const apart = (width - 110) / Math.max(1, axes.length - 1);
      this.places = axes.map((_, k) => (axes.length > 1 ? 55 + k * apart : width / 2));
      const line = (row) => {
        ink.beginPath();
        let pen = false;
        axes.forEach((of, k) => {
          const x = of.values[row];
          if (x === null) { pen = false; return; }
          const at = [this.places[k], this.height_at(of, x)];
          if (pen) ink.lineTo(...at); else ink.moveTo(...at);
          pen = true;
        });
        ink.stroke();
      };
      const tones = {};
      for (const name of ["--passes", "--fails", "--unclear", "--accent", "--line", "--ink", "--soft", "--paper"])
        tones[name] = colour(name);
      const chosen = this.chosen();
      ink.lineWidth = 1;
      ink.globalAlpha = 0.35;
      ink.strokeStyle = tones["--line"];
      if (chosen.length < this.count) this.shown.forEach((shown, row) => { if (!shown) line(row); });
      ink.globalAlpha = Math.max(0.06, Math.min(0.8, 90 / chosen.length));
      for (const row of chosen) { ink.strokeStyle = tones[this.tone(row)]; line(row); }
      ink.globalAlpha = 1;
      axes.forEach((of, k) => this.draw_axis(ink, of, this.places[k], Math.min(apart - 8, 150), k, tones));
      this.parallel.setAttribute("aria-label", `${this.said.textContent}, on axes of ${axes.map((of) => of.name).join(", ")}`);
    }

    draw_axis(ink, of, x, room, k, tones) {
      const [top, bottom] = [46, 256];
      ink.strokeStyle = tones["--soft"];
      ink.lineWidth = 1;
      ink.beginPath();
      ink.moveTo(x, top);
      ink.lineTo(x, bottom);
      ink.stroke();
      ink.lineWidth = 3;
      ink.strokeStyle = tones["--paper"];
      const label = (text, at) => {
        ink.textAlign = "left";
        ink.strokeText(text, x + 5, at);
        write(ink, text, x + 5, at, "left", tones["--soft"]);
      };
      if (of.words) of.words.forEach((word, i) => label(fitted(ink, word || "none", room), this.height_at(of, i)));
      else for (const value of tics(of.low, of.high, 5)) label(short(value), this.height_at(of, value));
      const range = this.filters.get(of);
      if (range) {
        const [low, high] = [Math.max(range[0], of.low), Math.min(range[1], of.high)];
        ink.fillStyle = tones["--accent"];
        ink.globalAlpha = 0.3;
        const y = Math.max(top - 4, this.height_at(of, high));
        ink.fillRect(x - 7, y, 14, Math.max(3, Math.min(bottom + 4, this.height_at(of, low)) - y));
        ink.globalAlpha = 1;
      }
      // Names by turns on two heights, so that neighbours have room.
      const name = fitted(ink, of.label, 1.9 * room);
      const half = ink.measureText(name).width / 2 + 4;
      const at = Math.max(half, Math.min(this.parallel.clientWidth - half, x));
      write(ink, name, at, k % 2 ? 28 : 12, "center", tones["--ink"]);
    }

    // A brush is drawn along an axis; a click takes it away.
    brush() {
      const canvas = this.parallel;
      let from = null;
      const place = (event) => {
        const box = canvas.getBoundingClientRect();
        return [event.clientX - box.left, event.clientY - box.top];
      };
      const value = (of, y) => of.high - (y - 46) / 210 * (of.high - of.low);
      canvas.addEventListener("pointerdown", (event) => {
        const [x, y] = place(event);
        const k = this.places.reduce((best, at, i) => (Math.abs(at - x) < Math.abs(this.places[best] - x) ? i : best), 0);
        if (Math.abs(this.places[k] - x) > 24) return;
        from = { of: this.axes[k], y };
        canvas.setPointerCapture(event.pointerId);
      });
      canvas.addEventListener("pointermove", (event) => {
        if (!from) return;
        const [, y] = place(event);
        if (Math.abs(y - from.y) < 4) return;
        const [low, high] = [value(from.of, Math.max(y, from.y)), value(from.of, Math.min(y, from.y))];
        this.filters.set(from.of, [low, high]);
        from.moved = true;
        this.update();
      });
      const end = () => {
        if (from && !from.moved) { this.filters.delete(from.of); this.update(); }
        from = null;
      };
      canvas.addEventListener("pointerup", end);
      canvas.addEventListener("pointercancel", () => { from = null; });
    }

    // ------------------------------------------------------------------- one column over another
    frame(canvas, x, y, words) {
      const width = canvas.parentNode.clientWidth;
      const height = 330;
      const ink = paper(canvas, width, height);
      const [left, right, top, bottom] = [58, width - 14, 26, height - 40];
      const across = (v) => left + (v - x.low) / (x.high - x.low) * (right - left);
      const up = (v) => bottom - (v - y.low) / (y.high - y.low) * (bottom - top);
      ink.strokeStyle = colour("--line");
      ink.lineWidth = 1;
      ink.beginPath();
      for (const v of tics(x.low, x.high, Math.max(2, Math.floor((right - left) / 70)))) {
        ink.moveTo(across(v), top);
        ink.lineTo(across(v), bottom);
        write(ink, short(v), across(v), bottom + 12, "center", colour("--soft"));
      }
      for (const v of tics(y.low, y.high, 7)) {
        ink.moveTo(left, up(v));
        ink.lineTo(right, up(v));
        write(ink, short(v), left - 6, up(v), "right", colour("--soft"));
      }
      ink.stroke();
      write(ink, fitted(ink, words[1], right - 4), 4, 10, "left", colour("--ink"));
      write(ink, fitted(ink, words[0], right - left), (left + right) / 2, height - 10, "center", colour("--ink"));
      return { ink, across, up, left, right, top, bottom };
    }

    draw_scatter() {
      const [x, y, z] = [this.x(), this.y(), this.z()];
      const pad = (of) => ({ low: of.low - 0.03 * (of.high - of.low), high: of.high + 0.03 * (of.high - of.low) });
      const view = this.frame(this.scatter, pad(x), pad(y), [x.label, y.label]);
      const rows = this.chosen().filter((row) => x.values[row] !== null && y.values[row] !== null);
      let says = z.name ? `${z.label} from ${short(z.low)} (dark) to ${short(z.high)} (light)` : "";
      const field = this.lines.checked && x !== y ? this.field(x, y, z, rows) : null;
      const labels = [];
      if (field) says = this.draw_field(view, z, field, labels);
      view.ink.globalAlpha = rows.length > 1500 ? 0.5 : 0.9;
      const radius = rows.length > 1500 ? 1.6 : rows.length > 300 ? 2.4 : 3.4;
      const tones = { "--passes": colour("--passes"), "--fails": colour("--fails"), "--unclear": colour("--unclear"),
        "--accent": colour("--accent") };
      for (const row of rows) {
        view.ink.fillStyle = z.name
          ? z.values[row] === null ? tones["--unclear"] : shade((z.values[row] - z.low) / (z.high - z.low))
          : tones[this.tone(row)];
        const at = [view.across(x.values[row]), view.up(y.values[row])];
        view.ink.beginPath();
        // What does not pass is a square.
        if (this.passes(row)) view.ink.arc(...at, radius, 0, 7);
        else view.ink.rect(at[0] - radius, at[1] - radius, 2 * radius, 2 * radius);
        view.ink.fill();
        if (z.name && rows.length <= 1500) {
          view.ink.strokeStyle = tones[this.tone(row)];
          view.ink.lineWidth = 1.2;
          view.ink.stroke();
        }
      }
      view.ink.globalAlpha = 1;
      view.ink.lineWidth = 4;
      view.ink.strokeStyle = colour("--paper");
      view.ink.textAlign = "center";
      for (const [text, ...at] of labels) {
        view.ink.strokeText(text, ...at);
        write(view.ink, text, ...at, "center", colour("--ink"));
      }
      if (this.verdict) says += `${says ? ". " : ""}Circles pass, squares do not.`;
      this.scatter_said.textContent = says;
      this.scatter.setAttribute("aria-label", `${y.label} over ${x.label}, ${rows.length} designs. ${says}`);
    }

    // What is drawn as a contour: on the grid that the designs are, or between them.
    field(x, y, z, rows) {
      if (!x.variable || !y.variable || rows.length < 9) return null;
      const steps = (of) => [...new Set(rows.map((row) => of.values[row]))].sort((a, b) => a - b);
      const [xs, ys] = [steps(x), steps(y)];
      // Where every design passes there is no use above 1; without a use the verdict stands for it.
      const use = (row) => {
        if (this.use && this.use.values[row] !== null) return this.use.values[row];
        return this.passes(row) ? 0 : 2;
      };
      if (xs.length > 2 && ys.length > 2 && xs.length * ys.length <= rows.length) {
        const place = new Map();
        const key = (a, b) => b * xs.length + a;
        for (const row of rows) {
          const at = key(xs.indexOf(x.values[row]), ys.indexOf(y.values[row]));
          const cell = place.get(at) || { sum: 0, count: 0, use: 0 };
          if (z.name && z.values[row] !== null) { cell.sum += z.values[row]; cell.count += 1; }
          cell.use = Math.max(cell.use, use(row));
          place.set(at, cell);
        }
        if (place.size < xs.length * ys.length) return null;
        const of = (value) => Array.from({ length: xs.length * ys.length }, (_, at) => value(place.get(at)));
        return { xs, ys, grid: true, several: rows.length > place.size, use: of((cell) => cell.use),
          z: of((cell) => (cell.count ? cell.sum / cell.count : null)) };
      }
      const line = (of) => Array.from({ length: 29 }, (_, k) => of.low + k / 28 * (of.high - of.low));
      const places = { xs: line(x), ys: line(y), grid: false };
      const points = rows.map((row) => [(x.values[row] - x.low) / (x.high - x.low),
        (y.values[row] - y.low) / (y.high - y.low), use(row), z.name ? z.values[row] : null]);
      const values = (k) => this.between(points.filter((of) => of[k] !== null), k);
      return { ...places, use: values(2), z: z.name ? values(3) : null };
    }

    // Planes through the designs around each place, the near ones counting most; nothing far from all of them.
    between(points, k) {
      const all = [];
      if (points.length < 9) return new Array(29 * 29).fill(null);
      const reach = Math.max(0.12, 2 / Math.sqrt(points.length));
      for (let j = 0; j < 29; j += 1) for (let i = 0; i < 29; i += 1) {
        const [px, py] = [i / 28, j / 28];
        let [n, sx, sy, sxx, sxy, syy, sv, sxv, syv, near] = [0, 0, 0, 0, 0, 0, 0, 0, 0, Infinity];
        for (const of of points) {
          const [dx, dy, v] = [of[0] - px, of[1] - py, of[k]];
          const far = dx * dx + dy * dy;
          near = Math.min(near, far);
          const w = Math.exp(-far / (2 * reach * reach)) + 1e-9;
          n += w; sx += w * dx; sy += w * dy; sv += w * v;
          sxx += w * dx * dx; sxy += w * dx * dy; syy += w * dy * dy; sxv += w * dx * v; syv += w * dy * v;
        }
        const [a, b, c] = [sxx - sx * sx / n, sxy - sx * sy / n, syy - sy * sy / n];
        const [p, q] = [sxv - sx * sv / n, syv - sy * sv / n];
        const det = a * c - b * b;
        if (near > 2.25 * reach * reach || !(det > 1e-12 * n * n)) { all.push(null); continue; }
        const [gx, gy] = [(p * c - q * b) / det, (q * a - p * b) / det];
        all.push((sv - gx * sx - gy * sy) / n);
      }
      return all;
    }

    draw_field(view, z, field, labels) {
      const { ink } = view;
      const [nx, ny] = [field.xs.length, field.ys.length];
      const across = (i) => {
        const k = Math.min(nx - 2, Math.floor(i));
        return view.across(field.xs[k] + (i - k) * (field.xs[k + 1] - field.xs[k]));
      };
      const up = (j) => {
        const k = Math.min(ny - 2, Math.floor(j));
        return view.up(field.ys[k] + (j - k) * (field.ys[k + 1] - field.ys[k]));
      };
      // Where designs do not pass, in small pieces.
      ink.fillStyle = colour("--fails-shade");
      const fine = field.grid ? 12 : 3;
      for (let j = 0; j + 1 < ny; j += 1) for (let i = 0; i + 1 < nx; i += 1) {
        const v = [field.use[j * nx + i], field.use[j * nx + i + 1], field.use[(j + 1) * nx + i], field.use[(j + 1) * nx + i + 1]];
        if (v.some((u) => u === null)) continue;
        for (let b = 0; b < fine; b += 1) for (let a = 0; a < fine; a += 1) {
          const [s, t] = [(a + 0.5) / fine, (b + 0.5) / fine];
          if ((1 - t) * ((1 - s) * v[0] + s * v[1]) + t * ((1 - s) * v[2] + s * v[3]) <= 1) continue;
          const [l, r] = [across(i + a / fine), across(i + (a + 1) / fine)];
          const [lo, hi] = [up(j + b / fine), up(j + (b + 1) / fine)];
          ink.fillRect(l - 0.3, hi - 0.3, r - l + 0.6, lo - hi + 0.6);
        }
      }
      const draw = (values, level, style, width) => {
        const lines = level_lines(values, nx, ny, level);
        ink.strokeStyle = style;
        ink.lineWidth = width;
        ink.beginPath();
        for (const [a, b] of lines) { ink.moveTo(across(a[0]), up(a[1])); ink.lineTo(across(b[0]), up(b[1])); }
        ink.stroke();
        return lines;
      };
      if (field.z) {
        const there = field.z.filter((v) => v !== null);
        const [low, high] = [Math.min(...there), Math.max(...there)];
        for (const level of tics(low, high, 8)) {
          const lines = draw(field.z, level, colour("--soft"), 1);
          if (!lines.length) continue;
          const [a, b] = lines[Math.floor(lines.length * 0.62)];
          labels.push([short(level), across((a[0] + b[0]) / 2), up((a[1] + b[1]) / 2)]);
        }
      }
      draw(field.use, 1, colour("--fails"), 2);
      const how = field.grid ? field.several ? "at each place the mean of the designs there; it passes where all do"
        : "between the designs in proportion" : "interpolated, other variables averaged";
      const lines = z.name ? `Lines of ${z.label}` : "No lines: choose a colour";
      return `${lines}; shaded: does not pass (${how})`;
    }

    // ------------------------------------------------------------------------------- histogram
    draw_counts() {
      const of = this.counted();
      const rows = this.chosen().filter((row) => of.values[row] !== null);
      const bins = Math.max(8, Math.min(40, Math.ceil(Math.sqrt(this.count))));
      const step = step_of(of.high - of.low, bins);
      const low = Math.floor(of.low / step + 1e-9) * step;
      const count = Math.floor((of.high - low) / step + 1e-9) + 1;
      const [all, pass, fail] = [0, 1, 2].map(() => new Array(count).fill(0));
      const bin = (row) => Math.max(0, Math.min(count - 1, Math.floor((of.values[row] - low) / step + 1e-9)));
      for (let row = 0; row < this.count; row += 1) if (of.values[row] !== null) all[bin(row)] += 1;
      for (const row of rows) (this.passes(row) ? pass : fail)[bin(row)] += 1;
      const most = Math.max(1, ...all);
      const view = this.frame(this.counts, { low, high: low + count * step }, { low: 0, high: 1.05 * most },
        [of.label, "designs"]);
      const { ink } = view;
      const bar = (k, from, to, style) => {
        if (!(to > from)) return;
        ink.fillStyle = style;
        const [l, r] = [view.across(low + k * step), view.across(low + (k + 1) * step)];
        ink.fillRect(l + 0.5, view.up(to), Math.max(1, r - l - 1), view.up(from) - view.up(to));
      };
      const [band, passes, fails] = [colour("--band"), colour(this.verdict ? "--passes" : "--accent"), colour("--fails")];
      for (let k = 0; k < count; k += 1) {
        bar(k, 0, all[k], band);
        bar(k, 0, fail[k], fails);
        bar(k, fail[k], fail[k] + pass[k], passes);
      }
      if (of === this.use && view.across(1) > view.left && view.across(1) < view.right) {
        ink.strokeStyle = colour("--ink");
        ink.setLineDash([4, 3]);
        ink.beginPath();
        ink.moveTo(view.across(1), view.top);
        ink.lineTo(view.across(1), view.bottom);
        ink.stroke();
        ink.setLineDash([]);
      }
      const values = rows.map((row) => of.values[row]).sort((a, b) => a - b);
      const at = (share) => values[Math.max(0, Math.ceil(share * values.length) - 1)];
      const mean = values.reduce((sum, v) => sum + v, 0) / values.length;
      const says = values.length
        ? `Mean ${short(mean)}; 5 % are not above ${short(at(0.05))}, half not above ${short(at(0.5))}, 95 % not above ${short(at(0.95))}.`
        : "No design is left.";
      this.counts_said.textContent = this.verdict ? `${says} Red: do not pass; grey: filtered out.` : says;
      this.counts.setAttribute("aria-label", `How many designs by ${of.label}. ${says}`);
    }

    // ------------------------------------------------------------------------------------- list
    list() {
      const rows = this.chosen();
      const { by, up } = this.sorted;
      if (by) {
        const key = (row) => by.values[row];
        rows.sort((a, b) => {
          if (key(a) === null || key(b) === null) return (key(a) === null) - (key(b) === null);
          return (up ? 1 : -1) * (key(a) - key(b));
        });
      }
      const table = element("table", { class: "data" });
      const head = element("tr", {}, element("thead", {}, table));
      const right = (of) => (of.words ? {} : { class: "right" });
      element("th", { scope: "col", class: "right" }, head, "design");
      for (const of of this.columns) {
        const cell = element("th", { scope: "col", ...right(of) }, head);
        if (of === by) cell.setAttribute("aria-sort", up ? "ascending" : "descending");
        const button = element("button", { type: "button" }, cell, of.label);
        button.addEventListener("click", () => {
          this.sorted = { by: of, up: of === by ? !up : true };
          this.list();
        });
      }
      const body = element("tbody", {}, table);
      const most = 100;
      for (const row of rows.slice(0, most)) {
        const line = element("tr", {}, body);
        element("th", { scope: "row", class: "right" }, line, String(this.number(row)));
        for (const of of this.columns) {
          const cell = element("td", right(of), line);
          const word = this.word(of, row);
          if (of === this.verdict && word)
            element("span", { class: `badge ${this.tone(row).slice(2)}` }, cell, word);
          else cell.append(word);
        }
      }
      this.table.replaceChildren(table);
      if (rows.length > most)
        element("p", { class: "said" }, this.table, `${rows.length - most} more designs: filter or sort to see others.`);
    }
  }

  for (const figure of document.querySelectorAll("figure.designs")) new Designs(figure);
})();
