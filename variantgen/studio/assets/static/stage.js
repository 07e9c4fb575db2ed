// The stage of Play: the figure, vectors, centres, plans and curves of a motion, for a position by its number.

import { Letters, segments } from "./letters.js";

const SVG = "http://www.w3.org/2000/svg";
const KINDS = { velocities: "vel", accelerations: "acc" };
export function svg(tag, attributes = {}, ...children) {
  const made = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}
const set = (made, attributes) => { for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value); };
const drawn = ({ d = "", weight, fill, dash }) =>
  svg("path", { d, "stroke-width": weight, class: fill, ...(dash ? { "stroke-dasharray": dash === "dashed" ? "3 1.8" : "4 1.2 0.6 1.2" } : {}) });
// Letters are outlines that the server has made, with their middle at the origin.
const lettered = (text, kind) => { const made = svg("g", { class: `name ${kind}` }); made.innerHTML = text; return made; };
const heads = () => svg("defs", {}, ...["vel", "rel", "acc", "cor"].map(kind =>
  svg("marker", { id: `head-${kind}`, viewBox: "0 0 12 10", refX: 11, refY: 5, markerWidth: 4.6, markerHeight: 3.8, orient: "auto" }, svg("path", { class: `head-${kind}`, d: "M0 0 12 5 0 10z" }))));
const arrow = kind => svg("line", { class: `arrow v-${kind}`, "marker-end": `url(#head-${kind})` });
const show = (made, yes) => { made.style.display = yes ? "" : "none"; };
const move = (made, x, y, scale = 1) => made.setAttribute("transform", `translate(${x} ${y})${scale === 1 ? "" : `scale(${scale})`}`);

// What changes with the position is a list of functions of its number.
export class Stage {
  constructor(place, data) {
    this.data = data; this.layers = {}; this.changes = []; this.letters = new Letters(data.box); this.now = 0;
    const at = (layer, ...parts) => { (this.layers[layer] ??= []).push(...parts); return parts; };
    place.setAttribute("viewBox", data.box.join(" "));
    const pens = data.pens.map(drawn), driver = svg("path", { class: "driver" }), front = data.pens.findIndex(pen => pen.layer > 3);
    const body = data.driver.length ? [...pens.slice(0, front < 0 ? pens.length : front), driver, ...(front < 0 ? [] : pens.slice(front))] : pens;
    const names = data.names.map(one => lettered(one.text, "")), faces = data.ground.filter(pen => pen.weight > 0.7).flatMap(pen => segments(pen.d));
    this.changes.push(i => {
      pens.forEach((pen, k) => pen.setAttribute("d", data.frames[i][k]));
      if (data.driver.length) driver.setAttribute("d", data.driver[i]);
      this.letters.clear([...faces, ...data.frames[i].flatMap(segments)]);
    });
    const vectors = kind => data[kind].vectors.map(one => this.vector(one, KINDS[kind]));
    place.replaceChildren(heads(), ...data.ground.map(drawn),
      ...at("paths", ...data.paths.map(d => svg("path", { class: "path", d }))),
      ...at("centres", ...data.centres.map(one => svg("path", { class: "centrode", d: one.path }))),
      ...body, ...data.bases.map(drawn), ...names,
      ...at("accelerations", ...vectors("accelerations")), ...at("velocities", ...vectors("velocities")),
      ...at("centres", ...data.centres.map(one => this.centre(one))));
    this.changes.push(i => {
      names.forEach((name, k) => this.letters.about(name, data.names[k].point[i], data.names[k].at[i]));
      this.letters.place();
    });
  }
  vector(one, usual) {
    const kind = one.kind || usual, line = arrow(kind), name = lettered(one.text, `v-${kind}`), made = svg("g", {}, line, name);
    this.changes.push(i => {
      const from = one.at[i], by = one.by[i], length = by ? Math.hypot(...by) : 0;
      show(made, length > 0.6);
      if (length <= 0.6) return;
      const x = from[0] + by[0], y = from[1] + by[1];
      set(line, { x1: from[0], y1: from[1], x2: x, y2: y });
      if (!made.hasAttribute("hidden")) this.letters.along(name, [...from, x, y]);
    });
    return made;
  }
  centre(one) {
    const mark = svg("path", { class: "mark", d: "M-1.4-1.4 1.4 1.4M-1.4 1.4 1.4-1.4" }), name = lettered(one.text, ""), made = svg("g", { class: "centre" }, mark, name);
    this.changes.push(i => {
      const place = one.at[i];
      show(made, Boolean(place));
      if (!place) return;
      move(mark, ...place);
      if (!made.hasAttribute("hidden")) this.letters.about(name, place, [place[0] + 4.5, place[1] - 3]);
    });
    return made;
  }
  // A plan: all vectors from one pole, the parts of a motion along a moving body one behind the other, the ends of points
  // of one body joined; in each position to a scale that fills it.
  plan(kind, title, label) {
    const { vectors, edges, pole: letter } = this.data[kind], whole = vectors.filter(one => one.end), parts = vectors.filter(one => one.start), short = KINDS[kind];
    const joined = edges.map(() => svg("line")), lines = vectors.map(one => arrow(one.kind || short)), carried = parts.map(() => arrow(short));
    const ends = whole.map(one => lettered(one.end, "")), pole = svg("circle", { r: 1.5 }), begin = lettered(letter, ""), letters = new Letters([-58, -58, 116, 116], 2.4);
    const arrows = [...vectors.map((one, k) => [lines[k], i => one.start?.[i] ?? [0, 0], i => one.by[i]]), ...parts.map((one, k) => [carried[k], () => [0, 0], i => one.start[i]])];
    this.changes.push(i => {
      const seen = arrows.map(([line, from, by]) => ({ line, from: from(i), by: by(i) })).filter(one => { const yes = Boolean(one.by && one.from); show(one.line, yes); return yes; });
      const x = [0, ...seen.map(one => one.from[0] + one.by[0])], y = [0, ...seen.map(one => one.from[1] + one.by[1])];
      const [left, right, top, low] = [Math.min(...x), Math.max(...x), Math.min(...y), Math.max(...y)], most = Math.max(right - left, low - top), scale = most > 0.3 ? 82 / most : 0;
      const at = place => [scale * (place[0] - (left + right) / 2), scale * (place[1] - (top + low) / 2)];
      letters.clear([]);
      set(pole, { cx: at([0, 0])[0], cy: at([0, 0])[1] });
      for (const { line, from, by } of seen) {
        const length = scale * Math.hypot(...by), [[x1, y1], [x2, y2]] = [at(from), at([from[0] + by[0], from[1] + by[1]])];
        show(line, length > 1);
        set(line, { x1, y1, x2, y2 });
        if (length > 1) letters.avoid([x1, y1, x2, y2]);
      }
      edges.forEach(([a, b], k) => {
        const two = [whole[a].by[i], whole[b].by[i]];
        show(joined[k], two[0] && two[1]);
        if (!two[0] || !two[1]) return;
        const [[x1, y1], [x2, y2]] = two.map(at);
        set(joined[k], { x1, y1, x2, y2 });
        letters.avoid([x1, y1, x2, y2]);
      });
      const from = at([0, 0]), far = Math.hypot(...from) || 1;
      letters.about(begin, from, from.map(value => value + 8 * value / far));
      whole.forEach((one, k) => {
        const yes = Boolean(one.by[i]) && scale * Math.hypot(...one.by[i]) > 1;
        show(ends[k], yes);
        if (yes) { const end = at(one.by[i]), from = at([0, 0]), length = Math.hypot(end[0] - from[0], end[1] - from[1]) || 1; letters.about(ends[k], end, [end[0] + 8 * (end[0] - from[0]) / length, end[1] + 8 * (end[1] - from[1]) / length]); }
      });
      letters.place();
    });
    const heading = document.createElement("h2"), made = document.createElement("div");
    heading.textContent = title; made.className = "plan";
    made.append(heading, svg("svg", { viewBox: "-58 -58 116 116", role: "img", "aria-label": label }, heads(), ...joined, ...carried, ...lines, pole, begin, ...ends));
    (this.layers[kind] ??= []).push(made);
    return made;
  }
  // A curve over the way of the driver with the value of the position.
  curve(one, along, written) {
    const [low, high] = one.range, y = value => (100 * (high - value) / (high - low || 1)).toFixed(1);
    let d = "", begun = false;
    one.values.forEach((value, i) => { if (value !== null) d += `${begun ? "L" : "M"}${along[i].toFixed(1)} ${y(Math.max(low - 9 * (high - low), Math.min(high + 9 * (high - low), value)))}`; begun = value !== null; });
    const cursor = svg("line", { class: "cursor", y1: 0, y2: 100 }), output = document.createElement("output"), heading = document.createElement("h2"), made = document.createElement("div");
    heading.innerHTML = `<span class="sy">${one.symbol}</span>`;
    const unit = document.createElement("small"); unit.innerHTML = one.unit;
    heading.append(output, unit); made.className = "curve";
    const frame = svg("svg", { viewBox: "0 0 1000 100", preserveAspectRatio: "none", "aria-hidden": "true" });
    if (low < 0 && high > 0) frame.append(svg("line", { class: "zero", x1: 0, x2: 1000, y1: y(0), y2: y(0) }));
    frame.append(svg("path", { class: one.kind, d }), cursor);
    made.append(heading, frame);
    this.changes.push(i => { set(cursor, { x1: along[i], x2: along[i] }); output.textContent = written(one.values[i]); });
    return made;
  }
  show(name, yes) { for (const part of this.layers[name] ?? []) part.toggleAttribute("hidden", !yes); }
  at(i) { this.now = i; for (const change of this.changes) change(i); }
}
