// The stage of Play: the figure, vectors, centres, plans and curves of a motion, for a position by its number.

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
    this.data = data; this.layers = {}; this.changes = [];
    const at = (layer, ...parts) => { (this.layers[layer] ??= []).push(...parts); return parts; };
    place.setAttribute("viewBox", data.box.join(" "));
    const pens = data.pens.map(drawn), driver = svg("path", { class: "driver" }), front = data.pens.findIndex(pen => pen.layer > 3);
    const body = data.driver.length ? [...pens.slice(0, front < 0 ? pens.length : front), driver, ...(front < 0 ? [] : pens.slice(front))] : pens;
    const names = data.names.map(one => lettered(one.text, ""));
    this.changes.push(i => {
      pens.forEach((pen, k) => pen.setAttribute("d", data.frames[i][k]));
      if (data.driver.length) driver.setAttribute("d", data.driver[i]);
      names.forEach((name, k) => move(name, ...data.names[k].at[i]));
    });
    place.replaceChildren(heads(), ...data.ground.map(drawn),
      ...at("paths", ...data.paths.map(d => svg("path", { class: "path", d }))),
      ...at("centres", ...data.centres.map(one => svg("path", { class: "centrode", d: one.path }))),
      ...body, ...data.bases.map(drawn), ...names,
      ...at("accelerations", ...data.accelerations.vectors.map(one => this.vector(one, "acc"))),
      ...at("velocities", ...data.velocities.vectors.map(one => this.vector(one, "vel"))),
      ...at("centres", ...data.centres.map(one => this.centre(one))));
  }
  vector(one, usual) {
    const kind = one.kind || usual, line = arrow(kind), name = lettered(one.text, `v-${kind}`), made = svg("g", {}, line, name);
    this.changes.push(i => {
      const from = one.at[i], by = one.by[i], length = by ? Math.hypot(...by) : 0;
      show(made, length > 0.6);
      if (length <= 0.6) return;
      const x = from[0] + by[0], y = from[1] + by[1], off = 4.4 / length;
      set(line, { x1: from[0], y1: from[1], x2: x, y2: y });
      move(name, x + by[0] * off, y + by[1] * off);
    });
    return made;
  }
  centre(one) {
    const name = lettered(one.text, ""), made = svg("g", { class: "centre" }, svg("path", { class: "mark", d: "M-1.4-1.4 1.4 1.4M-1.4 1.4 1.4-1.4" }), name);
    move(name, 4.5, -3);
    this.changes.push(i => { const place = one.at[i]; show(made, Boolean(place)); if (place) move(made, ...place); });
    return made;
  }
  // A plan: all vectors from one pole, the ends of points of one body joined; in each position to a scale that fills it.
  plan(kind, title, label) {
    const { vectors, edges } = this.data[kind], whole = vectors.filter(one => one.end), short = KINDS[kind];
    const joined = edges.map(() => svg("line")), lines = whole.map(() => arrow(short)), ends = whole.map(one => lettered(one.end, ""));
    this.changes.push(i => {
      const most = Math.max(...whole.map(one => one.by[i] ? Math.hypot(...one.by[i]) : 0));
      const tips = whole.map(one => one.by[i] && most > 0.3 ? one.by[i].map(value => value * 44 / most) : null);
      whole.forEach((_, k) => {
        const tip = tips[k], length = tip ? Math.hypot(...tip) : 0;
        for (const part of [lines[k], ends[k]]) show(part, length > 1);
        if (length <= 1) return;
        set(lines[k], { x1: 0, y1: 0, x2: tip[0], y2: tip[1] });
        move(ends[k], tip[0] * (1 + 8 / length), tip[1] * (1 + 8 / length), 2.1);
      });
      edges.forEach(([a, b], k) => {
        show(joined[k], tips[a] && tips[b]);
        if (tips[a] && tips[b]) set(joined[k], { x1: tips[a][0], y1: tips[a][1], x2: tips[b][0], y2: tips[b][1] });
      });
    });
    const heading = document.createElement("h2"), made = document.createElement("div");
    heading.textContent = title; made.className = "plan";
    made.append(heading, svg("svg", { viewBox: "-58 -58 116 116", role: "img", "aria-label": label }, heads(), ...joined, ...lines, svg("circle", { r: 1.5 }), ...ends));
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
  at(i) { for (const change of this.changes) change(i); }
}
