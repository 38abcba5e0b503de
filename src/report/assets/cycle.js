"use strict";
// Moves the drawing of a mechanism over its cycle, with the loads on its beam and the cut forces. What is
// drawn is data: lists of shapes, each the number of its kind with its places in tenths of a pixel, or a place
// and words; a frame that holds the same as the one before is written as the steps from there. Behind the frames
// of the cycle stands that of the critical instant, where it is known. In space scene.js draws the mechanism.
(() => {
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

  const set = (of, attributes) => {
    for (const [name, value] of Object.entries(attributes)) {
      of.setAttribute(name, typeof value === "number" ? Number(value.toFixed(2)) : value);
    }
    return of;
  };

  const { namespaceURI } = document.querySelector("svg.mechanism");
  const make = (tag, attributes, parent, words = "") => {
    const made = set(document.createElementNS(namespaceURI, tag), attributes);
    made.textContent = words;
    if (parent) parent.append(made);
    return made;
  };

  // A kind is a class, and what ends its lines: they are closed, or go on from their one place. A single place
  // without an ending is a circle.
  const shape = (kinds, [kind, ...all]) => {
    const [look, ending] = kinds[kind];
    const of = all.map((at) => (typeof at === "number" ? at / 10 : at));
    const [x, y, words] = of;
    if (typeof words === "string") return make("text", { class: look, x, y }, null, words);
    if (of.length === 2 && !ending) return make("circle", { class: look, cx: x, cy: y, r: 3 });
    return make("path", { class: look, d: `M${of.join(" ")}${ending}` });
  };

  // Numbers between two frames, and those that a step leads to.
  const between = (a, b, part) => (part === 0 ? a
    : a.map((x, i) => (typeof x === "number" ? x + part * (b[i] - x) : x)));
  const after = (a, b) => b.map((x, i) => (typeof x === "number" ? x + a[i] : x));

  // The same of shapes, where two frames hold the same ones; else one of them.
  const alike = (a, b) => a.length === b.length && a.every((of, i) => of[0] === b[i][0] && of.length === b[i].length);
  const shapes_between = (a, b, part) => (alike(a, b) ? a.map((of, i) => between(of, b[i], part)) : a);
  const shapes_after = (a, b) => (alike(a, b)
    ? b.map(([kind, ...of], i) => [kind, ...after(a[i].slice(1), of)]) : b);

  // Frames as they are, of the steps that lead to them.
  const walked = (frames, next) => frames.reduce(
    (all, frame) => [...all, all.length ? next(all[all.length - 1], frame) : frame], []);

  // An <svg> with what stands still in it, and a group for what moves.
  const paper = (svg, kinds, { width, height, back }) => {
    set(svg, { viewBox: `0 0 ${width} ${height}` });
    svg.replaceChildren(...back.map((of) => shape(kinds, of)));
    return make("g", {}, svg);
  };

  class Mechanism {
    constructor(svg, kinds, view, end) {
      Object.assign(this, { kinds, view, end });
      this.moving = paper(svg, kinds, view);
      this.mark = make("circle", { class: "cursor", r: 6 }, svg);
    }

    // At an instant, a frame, the next one, and how far it is on the way; `s` is where the cut forces are read.
    show({ frame, next, part }, s) {
      const { frames } = this.view;
      this.moving.replaceChildren(
        ...shapes_between(frames[frame], frames[next], part).map((of) => shape(this.kinds, of)));
      const axis = this.moving.querySelector(".beam");
      this.mark.style.display = axis ? "" : "none";
      if (!axis) return;
      const { x, y } = axis.getPointAtLength(axis.getTotalLength() * s / this.end);
      set(this.mark, { cx: x, cy: y });
      this.moving.after(this.mark);
    }
  }

  class Diagrams {
    constructor(svg, kinds, data) {
      this.data = data;
      const moving = paper(svg, kinds, data);
      this.cursor = make("line", { class: "cursor-line", y1: 2, y2: data.height - 28 }, moving);
      this.panels = data.cut.map((of) => ({
        of,
        area: make("path", { class: "area" }, moving), curve: make("path", { class: "curve" }, moving),
        dot: make("circle", { class: "cursor", r: 4 }, moving), text: make("text", {}, moving),
      }));
    }

    // The station nearest to a place of the drawing.
    station_at(x) {
      const away = (at) => Math.abs(at / 10 - x);
      return this.data.x.reduce((best, at, i, all) => (away(at) < away(all[best]) ? i : best), 0);
    }

    show({ frame, next, part }, station) {
      const { width } = this.data;
      const x = this.data.x.map((at) => at / 10);
      const at = x[station];
      set(this.cursor, { x1: at, x2: at });
      for (const { of, area, curve, dot, text } of this.panels) {
        const y = (value) => (of.zero - of.scale * value) / 10;
        const numbers = between(of.frames[frame], of.frames[next], part);
        const line = numbers.map((value, i) => `${x[i]} ${y(value).toFixed(1)}`).join("L");
        set(curve, { d: `M${line}` });
        set(area, { d: `M${x[0]} ${y(0)}L${line}L${x[x.length - 1]} ${y(0)}z` });
        const value = numbers[station];
        set(dot, { cx: at, cy: y(value) });
        const before = at > 0.6 * width;
        const top = y(Math.max(0, ...of.high)) + 11;
        set(text, { class: before ? "value end" : "value", x: at + (before ? -8 : 8), y: Math.max(y(value) - 6, top) });
        text.textContent = significant(value * of.digit);
      }
    }
  }

  class Player {
    constructor(figure, number) {
      this.figure = figure;
      this.number = number;
      const { first, kinds, beams, situations } = JSON.parse(figure.querySelector("script").textContent);
      this.kinds = kinds;
      this.situations = situations;
      this.beams = beams;
      this.view = 0;
      for (const { views, diagrams } of situations) {
        for (const view of views) view.frames = walked(view.frames, shapes_after);
        for (const cut of diagrams.cut) cut.frames = walked(cut.frames, after);
      }
      this.take(situations[first]);
      this.build(first);
      this.show();
    }

    // The data of a situation, at the place of the governing check, or of its largest bending moment.
    take(data) {
      this.data = data;
      this.frame = data.critical ? data.critical.at : data.frame;
      this.station = data.station;
      const n = data.times.length;
      this.last = n - (data.repeats ? 0 : 1);  // where the motion ends or begins again, in frames
      this.period = n < 2 ? 0 : ((data.times[n - 1] - data.times[0]) * this.last) / (n - 1);
    }

    choose(number) {
      this.stop();
      this.take(this.situations[number]);
      this.slider.max = this.data.times.length - 1;
      this.mark_critical();
      this.readout();
      this.draw();
    }

    // How a mechanism in space is drawn: by WebGL, or where a browser has none, from four sides.
    enter_space(pane) {
      if (typeof SpaceScene !== "function" || !this.data.scene) return;
      const box = element("div", { class: "space-box" }, pane);
      try {
        this.space = new SpaceScene(box, this.beams);
      } catch {
        box.replaceWith(element("p", { class: "no-space" }, null,
          "This browser has no WebGL, which a view that can be turned needs: the mechanism is drawn from four sides."));
      }
    }

    get in_space() { return Boolean(this.space && this.space_chosen); }

    // A button that leads to the critical instant, and a mark where it is on the slider.
    mark_critical() {
      const { critical } = this.data;
      this.critical_button.hidden = !critical;
      this.tick.hidden = !critical;
      if (critical) this.tick.style.left = `${100 * Math.min(critical.at / (this.data.times.length - 1), 1)}%`;
    }

    draw() {
      const { data, kinds } = this;
      const end = data.stations[data.stations.length - 1];
      if (this.space) {
        this.panes[0].style.display = this.in_space ? "none" : "";
        this.space.box.hidden = !this.in_space;
        this.space.take(data.scene, data.critical, data.loads.names);
      }
      this.mechanism = new Mechanism(this.panes[0], kinds, data.views[this.view], end);
      this.diagrams = new Diagrams(this.panes[1], kinds, data.diagrams);
      this.show();
    }

    build(first) {
      const pane = this.figure.querySelector(".pane");
      this.enter_space(pane);
      this.space_chosen = Boolean(this.space);
      this.controls(pane, first);
      const both = element("div", { class: "panes" });
      pane.before(both);
      const svg = make("svg", {
        class: "diagrams", role: "img",
        "aria-label": "Cut forces along the beam; their values stand in the table below",
      }, element("div", { class: "pane" }, both));
      both.prepend(pane);
      this.panes = [pane.querySelector("svg"), svg];
      this.box = element("div", { class: "readout" });
      both.after(this.box);
      this.readout();
      const pick = (event) => {
        const box = svg.getBoundingClientRect();
        const { width } = this.data.diagrams;
        this.station = this.diagrams.station_at((event.clientX - box.left) * width / box.width);
        this.show();
      };
      svg.addEventListener("pointerdown", pick);
      svg.addEventListener("pointermove", (event) => { if (event.buttons === 1) pick(event); });
      this.draw();
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
      }, element("span", { class: "slider" }, bar));
      this.slider.addEventListener("input", () => this.go(Number(this.slider.value)));
      const way = element("span", { class: "way" }, this.slider.parentNode);
      this.tick = element("span", { class: "tick" }, way);
      this.critical_button = button("Critical", "Go to the critical instant", () => {
        this.stop();
        this.go(this.data.critical.at);
      });
      this.mark_critical();
      this.time = element("output", {}, bar);
      const { views } = this.data;
      if (views.length > 1) {
        const label = element("label", {}, bar, "View ");
        const select = element("select", { class: "view" }, label);
        if (this.space) element("option", {}, select, "3D");
        for (const { name } of views) element("option", {}, select, name);
        select.addEventListener("change", () => {
          const number = select.selectedIndex - (this.space ? 1 : 0);
          this.space_chosen = number < 0;
          this.view = Math.max(number, 0);
          this.draw();
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
      this.cells = data.diagrams.cut.map((of) => row(cut, `${of.name} [${of.unit}]`, 3));
      const turning = data.loads.frames.some((frame) => frame.some(([, , couple]) => couple > 0));
      const loads = table("load on the beam", "now [kN]", ...(turning ? ["couple [kN m]"] : []));
      this.load_cells = data.loads.names.map((name) => row(loads, name, turning ? 2 : 1));
      if (data.loads.names.length === 0) loads.parentNode.remove();
    }

    go(frame) {
      this.frame = frame;
      this.show();
    }

    step(by) {
      this.stop();
      const whole = by > 0 ? Math.floor(this.frame) : Math.ceil(this.frame);  // it may stand between two
      this.go((whole + by + this.data.times.length) % this.data.times.length);
    }

    toggle() {
      if (this.playing) { this.stop(); return; }
      // A cycle takes three to twelve seconds, whatever it takes in truth.
      // Who wants less motion sees it go on from frame to frame, more slowly.
      const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
      const duration = (calm ? 3000 : 1000) * clamp(this.period, 3, 12);
      let begin;
      const tick = (now) => {
        begin ??= now - duration * (this.frame / this.last);
        const frame = (((now - begin) / duration) % 1) * this.last;
        this.go(calm ? Math.floor(frame) : frame);
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
      const is_critical = data.critical && this.frame === data.critical.at;
      const frame = is_critical ? data.times.length : Math.floor(this.frame);
      const next = is_critical ? frame : (frame + 1) % data.times.length;
      const at = { frame, next, part: is_critical ? 0 : this.frame - frame };
      if (this.in_space) {
        const sizes = data.loads.frames[frame].map(([name, size]) => [name, significant(size)]);
        this.space.show(this.now(), frame, sizes, data.stations[station]);
      } else {
        this.mechanism.show(at, data.stations[station]);
      }
      this.diagrams.show(at, station);
      this.show_time();
      const side = { "-": ", just before", "+": ", just behind" }[data.sides[station]] || "";
      this.place.textContent = `s = ${Number(data.stations[station].toPrecision(4))} m${side}`;
      this.places.value = station;
      this.places.setAttribute("aria-valuetext", this.place.textContent);
      data.diagrams.cut.forEach((of, k) => {
        const now = between(of.frames[frame], of.frames[next], at.part);
        [now, of.low, of.high].forEach((numbers, c) => {
          this.cells[k][c].textContent = significant(numbers[station] * of.digit);
        });
      });
      const sizes = new Map(data.loads.frames[frame].map(([name, ...of]) => [name, of]));
      this.load_cells.forEach((row, i) => row.forEach((cell, k) => {
        cell.textContent = sizes.has(i) ? significant(sizes.get(i)[k]) : "-";
      }));
    }

    // The time that is shown [s].
    now() {
      const { critical, times } = this.data;
      if (critical && this.frame === critical.at) return critical.time;
      return times[0] + (this.frame / this.last) * this.period;
    }

    show_time() {
      const part = this.frame / this.last;
      const time = this.now().toFixed(4);
      const phase = this.data.repeats ? `of the cycle (${(360 * part).toFixed(0)}\u00b0)` : "of the motion";
      this.time.textContent = `t = ${time} s, ${(100 * part).toFixed(1)} % ${phase}`;
      if (this.data.critical && this.frame === this.data.critical.at) this.time.textContent += ", critical";
      this.slider.value = this.frame;
      this.slider.setAttribute("aria-valuetext", this.time.textContent);
    }
  }

  document.querySelectorAll("figure.cycle").forEach((figure) => { figure.player = new Player(figure); });
})();
