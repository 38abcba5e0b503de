"use strict";
// Draws a mechanism in space with WebGL, as it stands at a time, seen from where the reader wants it: orthographic,
// z upwards. Places are in metres. What moves is told by keys: between two of them places lie on a straight line,
// turns on that of their quaternions.
const SpaceScene = (() => {
  const add = (a, b, times = 1) => a.map((x, i) => x + times * b[i]);
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const scaled = (a, by) => a.map((x) => x * by);
  const unit = (a) => scaled(a, 1 / Math.hypot(...a));
  const clamp = (x, low, high) => Math.max(low, Math.min(high, x));

  // A turn is a matrix by columns.
  const no_turn = [1, 0, 0, 0, 1, 0, 0, 0, 1];
  const turned = (m, v) => [0, 1, 2].map((i) => m[i] * v[0] + m[3 + i] * v[1] + m[6 + i] * v[2]);
  const product = (a, b) => [0, 3, 6].flatMap((k) => turned(a, b.slice(k, k + 3)));
  const turn_of = ([x, y, z, w]) => [
    1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w),
    2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w),
    2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)];
  const turn_along = (direction) => {
    const x = unit(direction);
    const y = unit(cross(Math.abs(x[2]) < 0.9 ? [0, 0, 1] : [0, 1, 0], x));
    return [...x, ...y, ...cross(x, y)];
  };

  // Numbers of which each is written as the step from the one so many places before.
  const walked = (steps, apart) => {
    const numbers = [...steps];
    for (let i = apart; i < numbers.length; i += 1) numbers[i] += numbers[i - apart];
    return numbers;
  };
  const rows = (numbers, count, by = 1) => Array.from(
    { length: numbers.length / count }, (_, i) => numbers.slice(i * count, (i + 1) * count).map((x) => x * by));

  // 1, 2 or 5 times a power of ten, not above a length.
  const round_length = (length) => {
    const power = 10 ** Math.floor(Math.log10(length));
    return power * ([5, 2].find((step) => step * power <= length) || 1);
  };

  // Shapes of unit size as lists of triangles, each three places.
  const strip = (a, b) => a.flatMap((p, i) => {
    const j = (i + 1) % a.length;
    return [[p, a[j], b[j]], [p, b[j], b[i]]];
  });
  const circle = (count, x, radius) => Array.from({ length: count }, (_, i) => {
    const angle = (2 * Math.PI * i) / count;
    return [x, radius * Math.cos(angle), radius * Math.sin(angle)];
  });
  const cap = (ring, middle) => ring.map((p, i) => [middle, p, ring[(i + 1) % ring.length]]);
  const rod = [...strip(circle(10, 0, 1), circle(10, 1, 1)), ...cap([...circle(10, 0, 1)].reverse(), [0, 0, 0]),
    ...cap(circle(10, 1, 1), [1, 0, 0])];
  const cone = [...cap(circle(14, 0, 1), [1, 0, 0]), ...cap([...circle(14, 0, 1)].reverse(), [0, 0, 0])];
  const ball = Array.from({ length: 8 }, (_, i) => i).flatMap((i) => {
    const ring = (k) => circle(12, -Math.cos((Math.PI * k) / 8), Math.max(Math.sin((Math.PI * k) / 8), 1e-6));
    return strip(ring(i), ring(i + 1));
  });
  const hoop = Array.from({ length: 6 }, (_, i) => i).flatMap((i) => {
    const ring = (k) => circle(40, 0.08 * Math.sin((Math.PI * k) / 3), 1 + 0.08 * Math.cos((Math.PI * k) / 3));
    return strip(ring(i), ring(i + 1));
  });
  const face = (x) => [[x, -1, -1], [x, 1, -1], [x, 1, 1], [x, -1, 1]];
  const cube = [...strip(face(-1), face(1)), ...cap([...face(-1)].reverse(), [-1, 0, 0]), ...cap(face(1), [1, 0, 0])];

  const vertex_shader = `
    attribute vec3 position, normal;
    uniform mat3 turn, view;
    uniform vec3 place, stretch, target, zoom;
    varying vec3 towards;
    void main() {
      towards = view * (turn * (normal / stretch));
      gl_Position = vec4(view * (turn * (position * stretch) + place - target) * zoom, 1.0);
    }`;
  const fragment_shader = `
    precision mediump float;
    uniform vec3 colour;
    uniform float shaded;
    varying vec3 towards;
    void main() {
      float light = 0.62 + 0.38 * max(dot(normalize(towards), vec3(0.30, 0.50, 0.81)), 0.0);
      gl_FragColor = vec4(colour * mix(1.0, light, shaded), 1.0);
    }`;

  // The edges of a surface, each two places: where its triangles meet at more than 25 degrees.
  const edges_of = (places, triangles) => {
    const known = new Map();
    for (const of of triangles) {
      const [a, b, c] = of.map((i) => places[i]);
      const normal = cross(add(b, a, -1), add(c, a, -1));
      if (Math.hypot(...normal) === 0) continue;
      of.forEach((i, k) => {
        const ends = [i, of[(k + 1) % 3]].sort((x, y) => x - y);
        const edge = known.get(ends.join()) || { ends, normals: [] };
        edge.normals.push(unit(normal));
        known.set(ends.join(), edge);
      });
    }
    return [...known.values()].filter(({ normals: [m, n] }) => !n || dot(m, n) < 0.906)
      .flatMap(({ ends }) => ends.map((i) => places[i]));
  };

  // What the graphics card keeps: the program, and shapes by their triangles or lines.
  class Painter {
    constructor(gl) {
      this.gl = gl;
      this.program = gl.createProgram();
      for (const [kind, source] of [[gl.VERTEX_SHADER, vertex_shader], [gl.FRAGMENT_SHADER, fragment_shader]]) {
        const shader = gl.createShader(kind);
        gl.shaderSource(shader, source);
        gl.compileShader(shader);
        gl.attachShader(this.program, shader);
      }
      gl.linkProgram(this.program);
      if (!gl.getProgramParameter(this.program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(this.program));
      gl.useProgram(this.program);
      this.at = {};
      for (const name of ["turn", "view", "place", "stretch", "target", "zoom", "colour", "shaded"]) {
        this.at[name] = gl.getUniformLocation(this.program, name);
      }
      this.places = [gl.getAttribLocation(this.program, "position"), gl.getAttribLocation(this.program, "normal")];
      for (const place of this.places) gl.enableVertexAttribArray(place);
      gl.enable(gl.DEPTH_TEST);
      gl.enable(gl.POLYGON_OFFSET_FILL);  // lines on a surface are in front of it
      gl.polygonOffset(1, 2);
    }

    // What is drawn from here on is in front of all before.
    to_the_front() { this.gl.clear(this.gl.DEPTH_BUFFER_BIT); }

    shape(numbers, kind) {
      const { gl } = this;
      const buffer = gl.createBuffer();
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(numbers), gl.STATIC_DRAW);
      return { buffer, kind, count: numbers.length / 6 };
    }

    triangles(all) {
      return this.shape(all.flatMap(([a, b, c]) => {
        const across = cross(add(b, a, -1), add(c, a, -1));
        const normal = Math.hypot(...across) > 0 ? unit(across) : [1, 0, 0];
        return [a, b, c].flatMap((p) => [...p, ...normal]);
      }), this.gl.TRIANGLES);
    }

    lines(all) {
      return this.shape(all.flatMap((p) => [...p, 0, 0, 1]), this.gl.LINES);
    }

    // What is seen: the rows of `view` are to the right, upwards and towards the reader; `zoom` leads from metres to
    // halves of the canvas.
    begin({ right, up, towards }, target, zoom) {
      const { gl, at } = this;
      gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
      gl.clearColor(0, 0, 0, 0);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      gl.uniformMatrix3fv(at.view, false, [0, 1, 2].flatMap((i) => [right[i], up[i], towards[i]]));
      gl.uniform3fv(at.target, target);
      gl.uniform3fv(at.zoom, zoom);
    }

    draw({ buffer, kind, count }, colour, place, turn = no_turn, stretch = [1, 1, 1]) {
      const { gl, at } = this;
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      this.places.forEach((of, i) => gl.vertexAttribPointer(of, 3, gl.FLOAT, false, 24, 12 * i));
      gl.uniform3fv(at.colour, colour);
      gl.uniform1f(at.shaded, kind === gl.LINES ? 0 : 1);
      gl.uniform3fv(at.place, place);
      gl.uniform3fv(at.stretch, stretch);
      gl.uniformMatrix3fv(at.turn, false, turn);
      gl.drawArrays(kind, 0, count);
    }
  }

  // Directions from which it is seen: how far around z from the front (-y) and how far above, in degrees.
  const directions = { Iso: [45, 35.26], Front: [0, 0], Side: [90, 0], Top: [0, 90] };

  class Scene {
    // In an element of the page, with the shapes of beams. Throws where there is no WebGL.
    constructor(box, beams) {
      this.box = box;
      const make = (tag, name, parent) => {
        const made = document.createElement(tag);
        made.className = name;
        parent.append(made);
        return made;
      };
      const frame = make("div", "space-view", box);
      this.canvas = make("canvas", "space", frame);
      const gl = this.canvas.getContext("webgl", { antialias: true, preserveDrawingBuffer: true });
      if (!gl) {
        frame.remove();
        throw new Error("no WebGL");
      }
      this.painter = new Painter(gl);
      this.canvas.tabIndex = 0;
      this.canvas.setAttribute("role", "img");
      this.canvas.setAttribute("aria-label", "Mechanism in space. Arrow keys turn it, with Shift they move it; "
        + "plus and minus zoom; Home resets the view");
      this.words = make("canvas", "space-words", frame);
      const bar = make("div", "controls views", box);
      for (const name of ["Reset", ...Object.keys(directions)]) {
        const button = make("button", "", bar);
        button.type = "button";
        button.textContent = name;
        button.setAttribute("aria-label", name === "Reset" ? "Reset the view" : `View: ${name.toLowerCase()}`);
        button.addEventListener("click", () => {
          this.look_from(["Reset", "Iso"].includes(name) ? this.iso : directions[name]);
          this.fit();
          this.paint();
        });
      }
      make("span", "small", bar).textContent = "drag: turn; Shift or right button: move; wheel: zoom";
      this.note = make("p", "small", box);
      this.shapes = Object.fromEntries(Object.entries({ rod, cone, ball, hoop, cube })
        .map(([name, triangles]) => [name, this.painter.triangles(triangles)]));
      this.beams = beams.map(({ unit: step, corners, triangles }) => {
        const places = rows(walked(corners, 3), 3, step);
        const all = rows(walked(triangles, 1), 3);
        return {
          faces: this.painter.triangles(all.map((of) => of.map((i) => places[i]))),
          edges: this.painter.lines(edges_of(places, all)),
        };
      });
      this.iso = directions.Iso;
      this.look_from(this.iso);
      this.listen();
    }

    // The scene of a situation, the instant and place of its governing check, and names of loads.
    take(data, critical, names) {
      const { unit: step } = data;
      const place = (of) => scaled(of, step);
      this.data = data;
      this.critical = critical;
      this.names = names;
      this.bodies = data.bodies.map((body, i) => body && {
        keys: walked(body.keys, 1).map((k) => data.times[k]),
        poses: rows(walked(body.poses, 7), 7).map((of) => [place(of.slice(0, 3)), scaled(of.slice(3), data.turn)]),
        strokes: rows(body.strokes, 6).map((of) => [place(of.slice(0, 3)), place(of.slice(3))]),
        block: body.block && place(body.block),
        ends: body.ends && rows(body.ends, 3).map(place),
        beam: i === data.beam.body,
        shape: this.beams[body.shape],
      });
      const attached = ([body, ...p]) => ({ body, p: place(p) });
      this.joints = data.joints.map(({ at }) => attached(at));
      this.rods = data.rods.map(({ a, b }) => [attached(a), attached(b)]);
      this.start = place(data.beam.start);
      this.room = data.room.map(place);
      const [low, high] = this.room;
      const spacing = round_length(data.size / 4);
      const lines = [];
      const from = [0, 1].map((i) => Math.floor(low[i] / spacing) - 1);
      const to = [0, 1].map((i) => Math.ceil(high[i] / spacing) + 1);
      for (let i = from[0]; i <= to[0]; i += 1) lines.push([i, from[1]], [i, to[1]]);
      for (let i = from[1]; i <= to[1]; i += 1) lines.push([from[0], i], [to[0], i]);
      this.grid = this.painter.lines(lines.map(([x, y]) => [x * spacing, y * spacing, low[2] - 0.01 * data.size]));
      this.note.textContent = [
        data.follows ? "It travels: seen from the joint that carries the beam." : "",
        data.resolved ? "" : "It moves faster than the instants that are drawn can show.",
      ].join(" ").trim();
      this.reached = this.all_reached();
      this.choose_iso();
      this.fit();
    }

    // Where bodies are at their keys: the ends of their strokes, and of the beam.
    all_reached() {
      const { axes, radius } = this.data.beam;
      const all = [];
      this.bodies.forEach((body, i) => {
        if (!body) return;
        const of = [...body.strokes.flat(), ...(body.block ? [body.block] : []), ...(body.ends || []),
          ...this.joints.filter((joint) => joint.body === i).map(({ p }) => p)];
        for (const time of body.keys) {
          const [place, turn] = this.pose(i, time);
          all.push(...of.map((p) => add(place, turned(turn, p))));
        }
      });
      all.push(...this.joints.filter(({ body }) => body < 0).map(({ p }) => p));
      return { all, margin: radius, axis: axes.slice(0, 3) };
    }

    // From one of four sides, from which the beam is not seen along its axis at the instant that comes first.
    choose_iso() {
      const time = this.critical ? this.critical.time : this.data.times[0];
      const axis = turned(this.pose(this.data.beam.body, time)[1], this.reached.axis);
      const along = (side) => Math.abs(dot(axis, this.axes(side).towards));
      const sides = [45, -45, 135, -135].map((around) => [around, directions.Iso[1]]);
      const iso = sides.find((side) => along(side) < 0.6) || sides[0];
      if (this.iso.join() === iso.join()) return;
      this.iso = iso;
      this.look_from(iso);
    }

    look_from([around, above]) {
      this.around = around;
      this.above = above;
    }

    axes([around, above] = [this.around, this.above]) {
      const [a, b] = [around, above].map((angle) => (angle * Math.PI) / 180);
      const right = [Math.cos(a), Math.sin(a), 0];
      const towards = [Math.sin(a) * Math.cos(b), -Math.cos(a) * Math.cos(b), Math.sin(b)];
      return { right, up: cross(towards, right), towards };
    }

    // All that is ever drawn, in the middle of the canvas, with room for words around it.
    fit() {
      const { right, up } = this.axes();
      const { all, margin } = this.reached;
      const range = (direction) => all.map((p) => dot(p, direction))
        .reduce(([low, high], x) => [Math.min(low, x - margin), Math.max(high, x + margin)], [Infinity, -Infinity]);
      const [left, end] = range(right);
      const [bottom, top] = range(up);
      const [low, high] = this.room;
      const middle = scaled(add(low, high), 0.5);
      this.target = add(add(middle, right, (left + end) / 2 - dot(middle, right)), up, (bottom + top) / 2 - dot(middle, up));
      const [width, height] = this.room_on_page();
      this.fitted = true;
      this.metres = Math.max((end - left) / (0.8 * width), (top - bottom) / (0.72 * height), 1e-4 * this.data.size);
    }

    room_on_page() {
      return [this.canvas.clientWidth || 460, this.canvas.clientHeight || 380];
    }

    pose(body, time) {
      if (body < 0) return [[0, 0, 0], no_turn];
      const { keys, poses } = this.bodies[body];
      let next = keys.findIndex((key) => key > time);
      if (next < 0) next = keys.length - 1;
      const before = Math.max(next - 1, 0);
      const span = keys[next] - keys[before];
      const part = span > 0 ? clamp((time - keys[before]) / span, 0, 1) : 0;
      const [place, turn] = poses[before];
      const [place_next, turn_next] = poses[next];
      const side = turn.reduce((sum, x, i) => sum + x * turn_next[i], 0) < 0 ? -1 : 1;
      const between = turn.map((x, i) => (1 - part) * x + part * side * turn_next[i]);
      return [place.map((x, i) => (1 - part) * x + part * place_next[i]), turn_of(unit(between))];
    }

    // At a time; `frame` is that of the loads, with the sizes to be written; `s` where cut forces are read [m].
    show(time, frame, sizes, s) {
      Object.assign(this, { time, frame, sizes, s });
      this.paint();
    }

    colours() {
      const style = getComputedStyle(this.box);
      const colour = (name) => {
        const hex = style.getPropertyValue(name).trim();
        return [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255);
      };
      return { accent: colour("--accent"), soft: colour("--soft"), line: colour("--line"), ink: colour("--ink"),
        load: colour("--load"), fails: colour("--fails"), paper: colour("--paper"), band: colour("--band") };
    }

    paint() {
      if (this.time === undefined || this.box.hidden) return;
      const dense = window.devicePixelRatio || 1;
      const [width, height] = this.room_on_page();
      for (const canvas of [this.canvas, this.words]) {
        if (canvas.width === Math.round(width * dense) && canvas.height === Math.round(height * dense)) continue;
        canvas.width = Math.round(width * dense);
        canvas.height = Math.round(height * dense);
      }
      const { painter, data, shapes } = this;
      const ink = this.colours();
      const view = this.axes();
      const deep = 2 * Math.hypot(...add(this.room[1], this.room[0], -1)) + 8 * data.beam.radius;
      painter.begin(view, this.target, [2 / (width * this.metres), 2 / (height * this.metres), -1 / deep]);
      painter.draw(this.grid, ink.line, [0, 0, 0]);
      const poses = this.bodies.map((body, i) => body && this.pose(i, this.time));
      const world = ({ body, p }) => (body < 0 ? p : add(poses[body][0], turned(poses[body][1], p)));
      const thick = data.size / 200;
      const bar = (from, to, colour, radius) => {
        const way = add(to, from, -1);
        const length = Math.hypot(...way);
        if (length > 1e-9 * data.size) painter.draw(shapes.rod, colour, from, turn_along(way), [length, radius, radius]);
      };
      this.bodies.forEach((body, i) => {
        if (!body) return;
        const [place, turn] = poses[i];
        if (body.shape && body.beam) {
          const beam_turn = product(turn, data.beam.axes);
          const start = world({ body: i, p: this.start });
          painter.draw(body.shape.faces, ink.accent, start, beam_turn);
          painter.draw(body.shape.edges, scaled(ink.accent, 0.5), start, beam_turn);
        } else if (body.shape) {
          painter.draw(body.shape.faces, ink.soft, place, turn);
          painter.draw(body.shape.edges, scaled(ink.soft, 0.5), place, turn);
        }
        for (const [from, to] of body.strokes) {
          bar(world({ body: i, p: from }), world({ body: i, p: to }), ink.soft, thick);
        }
        if (body.block) {
          const half = data.size / 60;
          painter.draw(shapes.cube, ink.soft, world({ body: i, p: body.block }), turn, [half, half, half]);
        }
      });
      for (const [a, b] of this.rods) bar(world(a), world(b), add(scaled(ink.soft, 0.6), scaled(ink.line, 0.4)), 0.8 * thick);
      for (const joint of this.joints) {
        if (joint.body >= 0 && !this.bodies[joint.body]) continue;
        const ground = joint.body < 0;
        const half = ground ? data.size / 60 : 1.8 * thick;
        painter.draw(ground ? shapes.cube : shapes.ball, ground ? ink.ink : add(scaled(ink.soft, 0.4), scaled(ink.paper, 0.6)),
          world(joint), no_turn, [half, half, half]);
      }
      const labels = [];
      this.paint_marks(labels, ink, poses);
      painter.to_the_front();
      this.paint_loads(labels, ink, bar, poses);
      this.write(labels, view, width, height, dense, ink);
    }

    // A place of the beam's axis, world.
    on_beam(s, poses) {
      const { body, axes } = this.data.beam;
      const [place, turn] = poses[body];
      return add(place, turned(turn, add(this.start, axes.slice(0, 3), s)));
    }

    paint_loads(labels, ink, bar, poses) {
      const { data, painter, shapes } = this;
      data.forces[this.frame].forEach(([s, ...force], i) => {
        const length = (Math.hypot(...force) / 1000) * 0.25 * data.size;
        if (length < 0.01 * data.size) return;
        const direction = unit(force);
        const head = Math.min(0.05 * data.size, 0.5 * length);
        const tip = this.on_beam(s, poses);
        const tail = add(tip, direction, -length);
        const neck = add(tip, direction, -head);
        bar(tail, neck, ink.load, data.size / 250);
        painter.draw(shapes.cone, ink.load, neck, turn_along(direction), [head, 0.35 * head, 0.35 * head]);
        const [name, size] = this.sizes[i];
        labels.push([tail, `${this.names[name]} ${size} kN`, "load"]);
      });
    }

    // Where cut forces are read, and the place of the governing check.
    paint_marks(labels, ink, poses) {
      const { painter, shapes, data } = this;
      const { body, axes, radius } = data.beam;
      const turn = product(poses[body][1], axes);
      const hoop_at = (s, colour, size) => painter.draw(shapes.hoop, colour, this.on_beam(s, poses), turn,
        [size, size, size]);
      const around = Math.max(radius, data.size / 100);
      hoop_at(this.s, ink.load, 1.2 * around);
      if (!this.critical) return;
      hoop_at(this.critical.s, ink.fails, 1.5 * around);
      labels.push([this.on_beam(this.critical.s, poses), "governing place", "fails"]);
    }

    // Words beside what they name, none over another; axes and a length to measure by.
    write(labels, { right, up }, width, height, dense, ink) {
      const paper = this.words.getContext("2d");
      paper.setTransform(dense, 0, 0, dense, 0, 0);
      paper.clearRect(0, 0, width, height);
      paper.font = `12px ${getComputedStyle(this.box).fontFamily}`;
      paper.lineJoin = "round";
      const css = (colour) => `rgb(${colour.map((x) => Math.round(255 * x)).join(" ")})`;
      const taken = [];
      const word = (text, x, y, colour, force = false) => {
        const wide = paper.measureText(text).width;
        const left = clamp(x, 2, width - wide - 2);
        const box = [left, y - 11, left + wide, y + 4];
        const free = taken.every((of) => box[0] > of[2] || box[2] < of[0] || box[1] > of[3] || box[3] < of[1]);
        if (!free && !force) return false;
        taken.push(box);
        paper.strokeStyle = css(ink.paper);
        paper.lineWidth = 3;
        paper.strokeText(text, left, y);
        paper.fillStyle = css(colour);
        paper.fillText(text, left, y);
        return true;
      };
      const line = (...places) => {
        paper.strokeStyle = css(ink.soft);
        paper.lineWidth = 1.2;
        paper.beginPath();
        places.forEach(([x, y], i) => (i ? paper.lineTo(x, y) : paper.moveTo(x, y)));
        paper.stroke();
      };
      ["x", "y", "z"].forEach((name, i) => {
        const [x, y] = [38 + 26 * right[i], height - 58 - 26 * up[i]];
        line([38, height - 58], [x, y]);
        if (Math.hypot(right[i], up[i]) > 0.1) word(name, x + 7 * right[i] - 3, y - 7 * up[i] + 4, ink.soft, true);
      });
      const length = round_length(0.22 * width * this.metres);
      const end = 10 + length / this.metres;
      line([10, height - 12], [10, height - 7], [end, height - 7], [end, height - 12]);
      word(`${Number(length.toPrecision(1))} m`, 14, height - 14, ink.soft, true);
      for (const [place, text, colour] of labels) {
        const away = add(place, this.target, -1);
        const x = width / 2 + dot(away, right) / this.metres;
        const y = height / 2 - dot(away, up) / this.metres;
        [-6, 14, -22, 30, -38].some((below) => word(text, x + 8, y + below, ink[colour]));
      }
    }

    turn_by(x, y) {
      this.fitted = false;
      this.around -= x;
      this.above = clamp(this.above + y, -90, 90);
    }

    move_by(x, y) {
      this.fitted = false;
      const { right, up } = this.axes();
      this.target = add(add(this.target, right, -x * this.metres), up, y * this.metres);
    }

    // About a place of the canvas, from its middle.
    zoom_by(factor, x = 0, y = 0) {
      this.fitted = false;
      const before = this.metres;
      this.metres = clamp(before / factor, 1e-5 * this.data.size, 0.1 * this.data.size);
      const { right, up } = this.axes();
      this.target = add(add(this.target, right, x * (before - this.metres)), up, -y * (before - this.metres));
    }

    listen() {
      const { canvas } = this;
      const fingers = new Map();
      const from_middle = (event) => {
        const box = canvas.getBoundingClientRect();
        return [event.clientX - box.left - box.width / 2, event.clientY - box.top - box.height / 2];
      };
      canvas.addEventListener("pointerdown", (event) => {
        canvas.setPointerCapture(event.pointerId);
        fingers.set(event.pointerId, from_middle(event));
      });
      for (const end of ["pointerup", "pointercancel"]) {
        canvas.addEventListener(end, (event) => fingers.delete(event.pointerId));
      }
      canvas.addEventListener("pointermove", (event) => {
        const before = fingers.get(event.pointerId);
        if (!before) return;
        const now = from_middle(event);
        const [x, y] = [now[0] - before[0], now[1] - before[1]];
        const other = [...fingers].find(([id]) => id !== event.pointerId);
        if (other) {
          const apart = (place) => Math.hypot(place[0] - other[1][0], place[1] - other[1][1]);
          this.zoom_by(apart(now) / Math.max(apart(before), 1), ...other[1]);
          this.move_by(x / 2, y / 2);
        } else if (event.shiftKey || event.buttons > 1) {
          this.move_by(x, y);
        } else {
          this.turn_by(0.5 * x, 0.5 * y);
        }
        fingers.set(event.pointerId, now);
        this.paint();
      });
      canvas.addEventListener("contextmenu", (event) => event.preventDefault());
      canvas.addEventListener("wheel", (event) => {
        event.preventDefault();
        this.zoom_by(1.0015 ** -event.deltaY, ...from_middle(event));
        this.paint();
      }, { passive: false });
      canvas.addEventListener("keydown", (event) => {
        const arrow = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
        if (arrow && event.shiftKey) {
          this.move_by(...scaled(arrow, 20));
        } else if (arrow) {
          this.turn_by(...scaled(arrow, 5));
        } else if (event.key === "+" || event.key === "-") {
          this.zoom_by(event.key === "+" ? 1.2 : 1 / 1.2);
        } else if (event.key === "Home") {
          this.look_from(this.iso);
          this.fit();
        } else {
          return;
        }
        event.preventDefault();
        event.stopPropagation();
        this.paint();
      });
      new ResizeObserver(() => {
        if (this.fitted && !this.box.hidden) this.fit();
        this.paint();
      }).observe(canvas);
      matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.paint());
    }
  }

  return Scene;
})();
