"use strict";
// Moves the drawing of a mechanism over its cycle, with the loads on its beam and the cut forces.
(() => {
  const VIEWS = {
    "oblique": [[0.866, 0.5, 0], [-0.2113, 0.366, 0.9063]],
    "from the front, x-z": [[1, 0, 0], [0, 0, 1]],
    "from the side, y-z": [[0, 1, 0], [0, 0, 1]],
    "from above, x-y": [[1, 0, 0], [0, 1, 0]],
  };
  const PLANE = [[1, 0, 0], [0, 1, 0]];

  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const plus = (a, b, factor = 1) => a.map((x, i) => x + factor * b[i]);
  const length = (a) => Math.sqrt(dot(a, a));
  const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
  const clamp = (x, low, high) => Math.max(low, Math.min(high, x));

  // Four significant digits, never as a power of ten.
  const significant = (value) => {
    if (Math.abs(value) < 1e-12) return "0";
    const decimals = 3 - Math.floor(Math.log10(Math.abs(value)));
    return value.toFixed(clamp(decimals, 0, 9));
  };

  const element = (tag, attributes, parent, ...content) => {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
    made.append(...content);
    if (parent) parent.append(made);
    return made;
  };

  // 1, 2 or 5 times a power of ten, not above a size.
  const round_size = (size) => {
    const power = 10 ** Math.floor(Math.log10(size));
    return power * [5, 2, 1].find((step) => step * power <= size * (1 + 1e-9));
  };

  class Svg {
    constructor(svg) { this.svg = svg; }
    clear() { this.svg.replaceChildren(); }
    size(width, height) {
      this.width = width;
      this.height = height;
      this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    }
    make(tag, style, attributes = {}, text = "") {
      const made = document.createElementNS(this.svg.namespaceURI, tag);
      if (style) made.setAttribute("class", style);
      Svg.set(made, attributes);
      if (text) made.textContent = text;
      this.svg.append(made);
      return made;
    }
    static set(of, attributes) {
      for (const [name, value] of Object.entries(attributes)) {
        of.setAttribute(name, typeof value === "number" ? value.toFixed(2) : value);
      }
    }
    static line(of, a, b) { Svg.set(of, { x1: a[0], y1: a[1], x2: b[0], y2: b[1] }); }
  }

  // Numbers between two frames.
  const between = (a, b, part) => (part === 0 ? a : a.map((x, i) => x + part * (b[i] - x)));

  // The coordinates of a frame, read in the order in which they were written.
  const posture = (data, numbers) => {
    let at = 0;
    const vector = (digit) => {
      const x = numbers[at++] * digit, y = numbers[at++] * digit;
      return [x, y, data.space ? numbers[at++] * digit : 0];
    };
    const list = (count, read) => Array.from({ length: count }, read);
    const point = () => vector(data.digit);
    const stroke = () => [point(), point()];
    return {
      bodies: data.bodies.map((body) => ({
        points: list(body.points, point), strokes: list(body.strokes, stroke),
      })),
      rods: list(data.rods, stroke),
      guides: list(data.guides, () => [point(), vector(data.guideDigit)]),
      grounds: list(data.grounds, point),
    };
  };

  // Loads of a frame: name, place [m], force [kN], couple [kN m].
  const loads_of = (data, rows) => rows.map((row) => {
    const { space, digit } = data.mechanism;
    const n = space ? 3 : 2;
    const vector = (from, unit) => [0, 1, 2].map((i) => (i < n ? row[from + i] * unit : 0));
    return {
      name: data.loads.names[row[0]], place: vector(1, digit), force: vector(1 + n, data.loads.digit),
      couple: space ? vector(1 + 2 * n, data.loads.coupleDigit)
        : [0, 0, row[1 + 2 * n] * data.loads.coupleDigit],
    };
  });

  class Mechanism {
    constructor(svg, data) {
      this.ink = new Svg(svg);
      this.data = data;
      this.postures = data.mechanism.frames.map((numbers) => posture(data.mechanism, numbers));
      this.loads = data.loads.frames.map((rows) => loads_of(data, rows));
      this.view = data.mechanism.space ? VIEWS.oblique : PLANE;
    }

    // Fits the whole cycle, with its arrows, into a width.
    layout(width) {
      const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
      const take = (place) => this.view.forEach((axis, i) => {
        low[i] = Math.min(low[i], dot(axis, place));
        high[i] = Math.max(high[i], dot(axis, place));
      });
      for (const of of this.postures) {
        for (const body of of.bodies) [...body.points, ...body.strokes.flat()].forEach(take);
        [...of.rods.flat(), ...of.grounds].forEach(take);
      }
      const size = Math.max(high[0] - low[0], high[1] - low[1], 1e-9);
      const all = this.loads.flat();
      const largest = Math.max(...all.map((load) => length(load.force)), 1e-30);
      this.reach = 0.28 * size / largest;
      const couple = Math.max(...all.map((load) => length(load.couple)), 0);
      // What rounding leaves of lever arms is no couple.
      this.least_couple = Math.max(0.02 * couple, 1e-6 * largest * size, 1e-30);
      this.normal = cross(this.view[0], this.view[1]);
      this.guide = 0.12 * size;
      for (const load of all) take(this.tail(load));
      const margin = 30;
      const extent = [0, 1].map((i) => Math.max(high[i] - low[i], 1e-3 * size));
      const height = clamp((width - 2 * margin) * extent[1] / extent[0] + 2 * margin, 220,
        Math.min(460, 1.15 * width));
      this.scale = Math.min((width - 2 * margin) / extent[0], (height - 2 * margin) / extent[1]);
      this.middle = [0, 1].map((i) => 0.5 * (low[i] + high[i]));
      this.ink.size(width, height);
      this.build();
    }

    tail(load) { return plus(load.place, load.force, -this.reach); }

    at(place) {
      const [x, y] = this.view.map((axis, i) => dot(axis, place) - this.middle[i]);
      return [0.5 * this.ink.width + this.scale * x, 0.5 * this.ink.height - this.scale * y];
    }

    build() {
      const { ink, data } = this;
      const of = this.postures[0];
      ink.clear();
      const many = (list, tag, style) => list.map(() => ink.make(tag, style));
      this.guides = many(of.guides, "line", "guide");
      this.grounds = many(of.grounds, "path", "ground");
      this.rods = many(of.rods, "line", "rod");
      const made = (body, i) => {
        const style = data.mechanism.bodies[i].beam ? "beam" : "body";
        const single = body.points.length === 1;
        const chain = body.strokes.length === 0 ? body.points.slice(1) : body.strokes;
        return {
          lines: many(chain, "line", style),
          block: single ? ink.make("rect", "block", { width: 14, height: 14 }) : null,
          points: single ? [] : body.points.map(() => ink.make("circle", "joint", { r: 3.5 })),
        };
      };
      // The beam in front of the others.
      this.bodies = [];
      for (const front of [false, true]) {
        of.bodies.forEach((body, i) => {
          if (data.mechanism.bodies[i].beam === front) this.bodies[i] = made(body, i);
        });
      }
      this.mark = ink.make("circle", "cursor", { r: 6 });
      const most = Math.max(0, ...this.loads.map((list) => list.length));
      this.arrows = Array.from({ length: most }, () => ({
        line: ink.make("line", "load"), head: ink.make("path", "head"),
        ring: ink.make("path", "couple"), end: ink.make("path", "head"),
      }));
      this.names = this.arrows.map(() => ink.make("text"));
      this.rule();
    }

    // A length to measure by, how displacements are drawn, and in space the axes.
    rule() {
      const { ink } = this;
      const y = ink.height - 6;
      const { magnified } = this.data.mechanism;
      if (magnified > 0) {
        ink.make("text", "small", { x: ink.width - 6, y, "text-anchor": "end" },
          `displacements ${Number(significant(magnified))} times as large`);
      }
      const size = round_size(0.2 * ink.width / this.scale);
      ink.make("path", "rule", { d: `M8 ${y - 4}v4h${(size * this.scale).toFixed(2)}v-4` });
      ink.make("text", "small", { x: 12, y: y - 6 }, `${Number(size.toPrecision(1))} m`);
      if (!this.data.mechanism.space) return;
      const from = [34, 46];
      ["x", "y", "z"].forEach((name, i) => {
        const [a, b] = [this.view[0][i], this.view[1][i]];
        if (Math.hypot(a, b) < 0.1) return;
        const to = [from[0] + 26 * a, from[1] - 26 * b];
        Svg.line(ink.make("line", "rule"), from, to);
        ink.make("text", "small", { "text-anchor": "middle", x: to[0] + 8 * a, y: to[1] - 8 * b + 4 }, name);
      });
    }

    // An instant is a frame, the next one, and how far it is on the way.
    show({ frame, next, part }, station) {
      const { mechanism, loads } = this.data;
      const of = posture(mechanism, between(mechanism.frames[frame], mechanism.frames[next], part));
      of.guides.forEach(([place, along], i) => Svg.line(this.guides[i],
        this.at(plus(place, along, -this.guide)), this.at(plus(place, along, this.guide))));
      of.rods.forEach(([a, b], i) => Svg.line(this.rods[i], this.at(a), this.at(b)));
      of.grounds.forEach((place, i) => {
        const [x, y] = this.at(place);
        Svg.set(this.grounds[i], { d: `M${x.toFixed(2)} ${y.toFixed(2)}l-8 13h16z` });
      });
      of.bodies.forEach((body, i) => this.show_body(body, this.bodies[i]));
      this.show_mark(of, station);
      const [here, there] = [loads.frames[frame], loads.frames[next]];
      const alike = here.length === there.length && here.every((row, i) => row[0] === there[i][0]);
      this.show_loads(loads_of(this.data, alike ? here.map((row, i) => between(row, there[i], part)) : here));
    }

    show_body(body, drawn) {
      const strokes = body.strokes.length > 0 ? body.strokes
        : body.points.slice(1).map((point, k) => [body.points[k], point]);
      strokes.forEach(([a, b], k) => Svg.line(drawn.lines[k], this.at(a), this.at(b)));
      drawn.points.forEach((circle, k) => {
        const [x, y] = this.at(body.points[k]);
        Svg.set(circle, { cx: x, cy: y });
      });
      if (drawn.block) {
        const [x, y] = this.at(body.points[0]);
        Svg.set(drawn.block, { x: x - 7, y: y - 7 });
      }
    }

    // Where on the beam the cut forces are read.
    show_mark(of, station) {
      const { mechanism, stations } = this.data;
      const beam = mechanism.bodies.findIndex((body) => body.beam && body.strokes > 0);
      this.mark.style.display = beam < 0 ? "none" : "";
      if (beam < 0) return;
      // Along its axis, which its first strokes are.
      let rest = stations[station];
      let place = null;
      for (const [from, to] of of.bodies[beam].strokes) {
        if (place && length(plus(from, place, -1)) > 1e-6) break;
        const way = plus(to, from, -1);
        const part = Math.min(1, rest / (length(way) || 1));
        place = plus(from, way, part);
        rest -= length(way);
        if (rest <= 0) break;
      }
      const [x, y] = this.at(place);
      Svg.set(this.mark, { cx: x, cy: y });
    }

    show_loads(loads) {
      this.taken = [];
      this.arrows.forEach((arrow, i) => {
        const load = loads[i];
        const tip = load && this.at(load.place), tail = load && this.at(this.tail(load));
        const long = load ? Math.hypot(tip[0] - tail[0], tip[1] - tail[1]) : 0;
        const couple = load ? dot(this.normal, load.couple) : 0;
        const pushes = long >= 3, turns = Math.abs(couple) > this.least_couple;
        const shown = (parts, seen) => parts.forEach((part) => { part.style.display = seen ? "" : "none"; });
        shown([arrow.line, arrow.head], pushes);
        shown([arrow.ring, arrow.end], turns);
        shown([this.names[i]], pushes || turns);
        if (!pushes && !turns) return;
        let words = `${load.name}  `;
        let along = [0, 1];
        let beside = plus(tip, [0, -20]);
        if (pushes) {
          along = [(tip[0] - tail[0]) / long, (tip[1] - tail[1]) / long];
          const size = Math.min(10, long);
          Svg.line(arrow.line, tail, plus(tip, along, -0.8 * size));
          Mechanism.point(arrow.head, tip, along, size);
          beside = tail;
          words += `${significant(length(load.force))} kN`;
        }
        if (turns) {
          this.turn(arrow, tip, couple > 0);
          words += `${pushes ? ", " : ""}${significant(Math.abs(couple))} kN m`;
        }
        this.write(this.names[i], words, beside, along);
      });
    }

    // An arrow's head at a tip.
    static point(head, tip, along, size) {
      const back = plus(tip, along, -size);
      const side = [-0.35 * size * along[1], 0.35 * size * along[0]];
      const corners = [tip, plus(back, side), plus(back, side, -1)];
      Svg.set(head, { d: `M${corners.map((p) => p.map((x) => x.toFixed(2)).join(" ")).join("L")}z` });
    }

    // Three quarters of a circle about a place with a head at its end, open below.
    turn(arrow, at, counter_clockwise) {
      const ring = 15, half = 0.70711, side = counter_clockwise ? -1 : 1;
      const begin = plus(at, [-side * half, half], ring), end = plus(at, [side * half, half], ring);
      const along = [-side * half, half];
      const text = (p) => p.map((x) => x.toFixed(2)).join(" ");
      Svg.set(arrow.ring, {
        d: `M${text(begin)}A${ring} ${ring} 0 1 ${counter_clockwise ? 0 : 1} ${text(end)}`,
      });
      Mechanism.point(arrow.end, plus(end, along, 5), along, 10);
    }

    // Beyond an arrow's tail, beside the arrow where that is not upright, never over another name.
    write(label, words, tail, along) {
      const { width, height } = this.ink;
      const wide = Math.min(7.2 * words.length, width - 8);
      const part = along[0] > 0.4 ? 1 : along[0] < -0.4 ? 0 : 0.5;
      const x = clamp(tail[0] - 6 * along[0] - part * wide, 4, width - wide - 4);
      let y = clamp(tail[1] - 12 * along[1] + 4, 15, height - 32);
      const crowded = () => this.taken.some(([a, b, w]) => x < a + w && a < x + wide && Math.abs(b - y) < 15);
      while (crowded() && y > 30) y -= 15;
      while (crowded() && y < height - 47) y += 15;
      this.taken.push([x, y, wide]);
      label.textContent = words;
      Svg.set(label, { x, y });
    }
  }

  class Diagrams {
    constructor(svg, data) {
      this.ink = new Svg(svg);
      this.data = data;
      this.panels = data.cut.map((of) => ({ of, value: (numbers, i) => numbers[i] * of.digit }));
    }

    layout(width) {
      const { ink, data } = this;
      const [left, right, title, high, bottom] = [58, 16, 26, this.panels.length > 3 ? 70 : 92, 36];
      const end = data.stations[data.stations.length - 1];
      this.left = left;
      this.per_metre = (width - left - right) / end;
      ink.size(width, this.panels.length * (high + title) + bottom);
      ink.clear();
      this.panels.forEach((panel, p) => {
        const top = p * (high + title) + title;
        const { of, value } = panel;
        const low = Math.min(0, ...of.low.map((_, i) => value(of.low, i)));
        const up = Math.max(0, ...of.high.map((_, i) => value(of.high, i)));
        const span = up - low || 1;
        panel.y = (v) => top + high * (1 - (v - low) / span);
        panel.top = top;
        ink.make("text", "name", { x: left, y: top - 7 }, `${of.name} [${of.unit}]`);
        const there = data.stations.map((_, i) => [this.x(i), panel.y(value(of.high, i))]);
        const back = data.stations.map((_, i) => [this.x(i), panel.y(value(of.low, i))]).reverse();
        ink.make("path", "band", { d: `${Diagrams.path([...there, ...back])}z` });
        const zero = panel.y(0);
        Svg.line(ink.make("line", "axis"), [left, zero], [width - right, zero]);
        for (const v of [low, 0, up]) {
          if (v !== 0 && Math.abs(panel.y(v) - zero) < 13) continue;
          ink.make("text", "small", { x: left - 6, y: panel.y(v) + 4, "text-anchor": "end" }, significant(v));
        }
        panel.area = ink.make("path", "area");
        panel.curve = ink.make("path", "curve");
      });
      this.base = this.panels.length * (high + title);
      this.ruler(end, width - right);
      this.cursor = ink.make("line", "cursor-line", { y1: 2, y2: this.base + 8 });
      for (const panel of this.panels) {
        panel.dot = ink.make("circle", "cursor", { r: 4 });
        panel.text = ink.make("text", "value");
      }
    }

    ruler(end, right) {
      const { ink, base } = this;
      const step = round_size(end / 4);
      Svg.line(ink.make("line", "axis"), [this.left, base + 8], [right, base + 8]);
      const count = Math.floor(end / step + 1e-6);
      for (let k = 0; k <= count; ++k) {
        const x = this.left + k * step * this.per_metre;
        Svg.line(ink.make("line", "axis"), [x, base + 8], [x, base + 12]);
        ink.make("text", "small", { x, y: base + 25, "text-anchor": "middle" },
          String(Number((k * step).toPrecision(6))));
      }
      ink.make("text", "name", { x: this.left - 12, y: base + 25, "text-anchor": "end" }, "s [m]");
    }

    x(station) { return this.left + this.data.stations[station] * this.per_metre; }

    // The station nearest to a place of the drawing.
    station_at(x) {
      const s = (x - this.left) / this.per_metre;
      let best = 0;
      this.data.stations.forEach((at, i) => {
        if (Math.abs(at - s) < Math.abs(this.data.stations[best] - s)) best = i;
      });
      return best;
    }

    static path(points) { return `M${points.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}`; }

    show({ frame, next, part }, station) {
      const { data } = this;
      const x = this.x(station);
      Svg.set(this.cursor, { x1: x, x2: x });
      const last = data.stations.length - 1;
      for (const { of, value, y, area, curve, dot, text, top } of this.panels) {
        const numbers = between(of.frames[frame], of.frames[next], part);
        const line = Diagrams.path(numbers.map((_, i) => [this.x(i), y(value(numbers, i))]));
        Svg.set(curve, { d: line });
        Svg.set(area, { d: `M${this.x(0).toFixed(1)} ${y(0).toFixed(1)}L${line.slice(1)}L${this.x(last).toFixed(1)} ${y(0).toFixed(1)}z` });
        const v = value(numbers, station);
        Svg.set(dot, { cx: x, cy: y(v) });
        const before = x > 0.6 * this.ink.width;
        text.textContent = significant(v);
        Svg.set(text, {
          x: x + (before ? -8 : 8), y: Math.max(y(v) - 6, top + 11), "text-anchor": before ? "end" : "start",
        });
      }
    }
  }

  class Player {
    constructor(figure, number) {
      this.figure = figure;
      this.number = number;
      const { first, situations } = JSON.parse(figure.querySelector("script").textContent);
      this.situations = situations;
      this.take(situations[first]);
      this.build(first);
      this.show();
    }

    // The data of a situation, at its place of the largest bending moment.
    take(data) {
      this.data = data;
      this.frame = data.frame;
      this.station = data.station;
      const n = data.times.length;
      this.last = n - (data.repeats ? 0 : 1);  // where the motion ends or begins again, in frames
      this.period = n < 2 ? 0 : ((data.times[n - 1] - data.times[0]) * this.last) / (n - 1);
    }

    choose(number) {
      this.stop();
      this.take(this.situations[number]);
      const { data } = this;
      this.slider.max = data.times.length - 1;
      const { view } = this.mechanism;
      this.mechanism = new Mechanism(this.mechanism.ink.svg, data);
      if (data.mechanism.space) this.mechanism.view = view;
      this.diagrams = new Diagrams(this.diagrams.ink.svg, data);
      this.readout();
      this.layout(true);
    }

    build(first) {
      const { figure, data } = this;
      const pane = figure.querySelector(".pane");
      this.controls(pane, first);
      const panes = element("div", { class: "panes" });
      pane.before(panes);
      panes.append(pane);
      this.mechanism = new Mechanism(pane.querySelector("svg"), data);
      const second = element("div", { class: "pane" }, panes);
      const svg = document.createElementNS(this.mechanism.ink.svg.namespaceURI, "svg");
      svg.setAttribute("class", "diagrams");
      svg.setAttribute("role", "img");
      svg.setAttribute("aria-label", "Cut forces along the beam; their values stand in the table below");
      second.append(svg);
      this.diagrams = new Diagrams(svg, data);
      this.box = element("div", { class: "readout" });
      panes.after(this.box);
      this.readout();
      const pick = (event) => {
        const box = svg.getBoundingClientRect();
        this.station = this.diagrams.station_at((event.clientX - box.left) * this.diagrams.ink.width / box.width);
        this.show();
      };
      svg.addEventListener("pointerdown", pick);
      svg.addEventListener("pointermove", (event) => { if (event.buttons === 1) pick(event); });
      new ResizeObserver(() => this.layout()).observe(panes);
      this.layout();
    }

    controls(before, first) {
      const bar = element("div", { class: "controls" });
      before.before(bar);
      if (this.situations.length > 1) {
        const label = element("label", {}, bar, "Situation ");
        const select = element("select", { class: "situation" }, label);
        this.situations.forEach((of, i) => element("option", { value: i }, select, of.situation));
        select.value = first;
        select.addEventListener("change", () => this.choose(Number(select.value)));
      }
      const button = (words, label, work) => {
        const made = element("button", { type: "button", "aria-label": label }, bar, words);
        made.addEventListener("click", work);
        return made;
      };
      button("\u2039", "One step back", () => this.step(-1));
      this.play = button("Play", "Play the cycle", () => this.toggle());
      button("\u203a", "One step on", () => this.step(1));
      this.slider = element("input", {
        type: "range", min: 0, max: this.data.times.length - 1, step: 1, "aria-label": "Instant of the cycle",
      }, bar);
      this.slider.addEventListener("input", () => this.go(Number(this.slider.value)));
      this.time = element("output", {}, bar);
      if (this.data.mechanism.space) {
        const label = element("label", {}, bar, "View ");
        const select = element("select", { class: "view" }, label);
        for (const name of Object.keys(VIEWS)) element("option", { value: name }, select, name);
        select.addEventListener("change", () => {
          this.mechanism.view = VIEWS[select.value];
          this.layout(true);
        });
      }
      this.figure.addEventListener("keydown", (event) => {
        const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
        if (!by || ["INPUT", "SELECT"].includes(event.target.tagName)) return;
        event.preventDefault();
        this.step(by);
      });
    }

    readout() {
      const { data, box } = this;
      box.replaceChildren();
      const label = element("label", {}, box, "Place on the beam ");
      this.places = element("input", { type: "range", min: 0, max: data.stations.length - 1, step: 1 }, label);
      this.places.addEventListener("input", () => {
        this.station = Number(this.places.value);
        this.show();
      });
      this.place = element("output", {}, label);
      const tables = element("div", { class: "tables" }, box);
      const table = (...head) => {
        const made = element("table", { class: "data" }, tables);
        const row = element("tr", {}, element("thead", {}, made));
        head.forEach((words, i) => element("th", { scope: "col", class: i ? "right" : "" }, row, words));
        return element("tbody", {}, made);
      };
      const row = (body, name, count) => {
        const made = element("tr", {}, body);
        element("th", { scope: "row" }, made, name);
        return Array.from({ length: count }, () => element("td", { class: "right" }, made));
      };
      const cut = table("cut force there", "now", "smallest", "largest");
      this.cells = data.cut.map((of) => row(cut, `${of.name} [${of.unit}]`, 3));
      const turning = data.loads.frames.some((frame) => loads_of(data, frame).some((load) => length(load.couple) > 0));
      const loads = table("load on the beam", "now [kN]", ...(turning ? ["couple [kN m]"] : []));
      this.load_cells = data.loads.names.map((name) => row(loads, name, turning ? 2 : 1));
      if (data.loads.names.length === 0) loads.parentNode.remove();
    }

    layout(force = false) {
      const widths = [this.mechanism, this.diagrams].map((of) => Math.max(240, of.ink.svg.parentNode.clientWidth));
      if (!force && String(widths) === this.widths) return;
      this.widths = String(widths);
      this.mechanism.layout(widths[0]);
      this.diagrams.layout(widths[1]);
      this.show();
    }

    go(frame) {
      this.frame = frame;
      this.show();
    }

    step(by) {
      this.stop();
      this.go((this.frame + by + this.data.times.length) % this.data.times.length);
    }

    toggle() {
      if (this.playing) { this.stop(); return; }
      // A cycle takes three to twelve seconds, whatever it takes in truth.
      const duration = 1000 * clamp(this.period, 3, 12);
      let begin;
      const tick = (now) => {
        begin ??= now - duration * (this.frame / this.last);
        this.go((((now - begin) / duration) % 1) * this.last);
        this.playing = requestAnimationFrame(tick);
      };
      this.playing = requestAnimationFrame(tick);
      this.play.textContent = "Pause";
      this.play.setAttribute("aria-label", "Pause");
    }

    stop() {
      if (!this.playing) return;
      cancelAnimationFrame(this.playing);
      this.playing = 0;
      this.play.textContent = "Play";
      this.play.setAttribute("aria-label", "Play the cycle");
      this.go(Math.round(this.frame) % this.data.times.length);
    }

    // The frame may be between two while the cycle is played.
    show() {
      const { data, station } = this;
      const frame = Math.floor(this.frame);
      const next = (frame + 1) % data.times.length;
      const at = { frame, next, part: this.frame - frame };
      this.mechanism.show(at, station);
      this.diagrams.show(at, station);
      this.show_time();
      const side = { "-": ", just before", "+": ", just behind" }[data.sides[station]] || "";
      this.place.textContent = `s = ${Number(data.stations[station].toPrecision(4))} m${side}`;
      this.places.value = station;
      this.places.setAttribute("aria-valuetext", this.place.textContent);
      data.cut.forEach((of, k) => {
        const now = between(of.frames[frame], of.frames[next], at.part);
        [now, of.low, of.high].forEach((numbers, c) => {
          this.cells[k][c].textContent = significant(numbers[station] * of.digit);
        });
      });
      const sizes = new Map(this.mechanism.loads[frame].map(
        (load) => [load.name, [length(load.force), length(load.couple)]]));
      data.loads.names.forEach((name, i) => this.load_cells[i].forEach((cell, k) => {
        cell.textContent = sizes.has(name) ? significant(sizes.get(name)[k]) : "-";
      }));
    }

    show_time() {
      const part = this.frame / this.last;
      const time = (this.data.times[0] + part * this.period).toFixed(4);
      const phase = this.data.repeats ? `of the cycle (${(360 * part).toFixed(0)}\u00b0)` : "of the motion";
      this.time.textContent = `t = ${time} s, ${(100 * part).toFixed(1)} % ${phase}`;
      this.slider.value = this.frame;
      this.slider.setAttribute("aria-valuetext", this.time.textContent);
    }
  }

  document.querySelectorAll("figure.cycle").forEach((figure) => new Player(figure));
})();
