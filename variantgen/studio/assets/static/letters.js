// Where letters stand in a moving picture: off lines and off each other, and as long as it goes where they stood before.

const CROSSED = 2, COVERED = 8, OUTSIDE = 6, MOVED = 1.2, TURNS = 16;

// The straight parts of a path: curves count as chords.
export function segments(d) {
  const found = [];
  let at = null, first = null;
  for (const [, kind, numbers] of d.matchAll(/([MLCZ])([^MLCZ]*)/g)) {
    const values = numbers.match(/-?[\d.]+/g)?.map(Number) ?? [], to = kind === "Z" ? first : values.slice(-2);
    if (kind === "M") first = to; else if (at && to) found.push([...at, ...to]);
    at = to;
  }
  return found;
}
// Whether a line comes into a box about (x, y).
function crosses([x1, y1, x2, y2], x, y, w, h) {
  let low = 0, high = 1;
  for (const [from, by, near, far] of [[x1, x2 - x1, x - w, x + w], [y1, y2 - y1, y - h, y + h]]) {
    if (Math.abs(by) < 1e-9) { if (from < near || from > far) return false; continue; }
    const a = (near - from) / by, b = (far - from) / by;
    low = Math.max(low, Math.min(a, b)); high = Math.min(high, Math.max(a, b));
  }
  return low < high;
}

export class Letters {
  constructor([left, top, width, height], scale = 1) { this.box = [left, top, left + width, top + height]; this.scale = scale; this.sizes = new Map(); this.before = new Map(); this.clear([]); }
  clear(lines) { this.lines = lines; this.wanted = []; }
  avoid(line) { this.lines.push(line); }
  // The name of a point stands about it, best where the server has it.
  about(name, point, best) {
    const away = Math.hypot(best[0] - point[0], best[1] - point[1]) || 4.6, angle = Math.atan2(best[1] - point[1], best[0] - point[0]);
    this.wanted.push([name, Array.from({ length: 2 * TURNS }, (_, k) => {
      const turn = 2 * Math.PI * (k % TURNS) / TURNS, far = k < TURNS ? away : 1.5 * away;
      return [point[0] + far * Math.cos(angle + turn), point[1] + far * Math.sin(angle + turn), 0.4 * Math.min(k % TURNS, TURNS - k % TURNS) / TURNS + (k < TURNS ? 0 : 0.6)];
    })]);
  }
  // The name of a vector stands before its tip or beside it.
  along(name, line) {
    const [x1, y1, x2, y2] = line, length = Math.hypot(x2 - x1, y2 - y1), [ex, ey] = [(x2 - x1) / length, (y2 - y1) / length];
    this.avoid(line);
    const from = (part, ahead, aside) => [x1 + part * (x2 - x1) + ahead * ex - aside * ey, y1 + part * (y2 - y1) + ahead * ey + aside * ex];
    this.wanted.unshift([name, [[1, 4.4, 0, 0], [1, 2.5, 4, 0.3], [1, 2.5, -4, 0.3], [1, -1, 4.8, 0.5], [1, -1, -4.8, 0.5], [0.6, 0, 4.8, 0.8], [0.6, 0, -4.8, 0.8], [1, 8, 0, 0.9]]
      .map(([part, ahead, aside, cost]) => [...from(part, ahead, aside), cost])]);
  }
  size(name) {
    if (!this.sizes.has(name)) { const box = name.getBBox(); this.sizes.set(name, [this.scale * box.width / 2 || 2, this.scale * box.height / 2 || 2]); }
    return this.sizes.get(name);
  }
  place() {
    const taken = [];
    for (const [name, places] of this.wanted) {
      const [w, h] = this.size(name), before = this.before.get(name);
      let best = null, least = Infinity;
      places.forEach(([x, y, own], k) => {
        let cost = own + (before === undefined || before === k ? 0 : MOVED);
        for (const line of this.lines) if (cost < least && crosses(line, x, y, w, h)) cost += CROSSED;
        for (const [a, b, c, d] of taken) if (Math.abs(a - x) < c + w && Math.abs(b - y) < d + h) cost += COVERED;
        if (x - w < this.box[0] || x + w > this.box[2] || y - h < this.box[1] || y + h > this.box[3]) cost += OUTSIDE;
        if (cost < least) { least = cost; best = [x, y, k]; }
      });
      taken.push([best[0], best[1], w, h]);
      this.before.set(name, best[2]);
      name.setAttribute("transform", `translate(${best[0]} ${best[1]})${this.scale === 1 ? "" : `scale(${this.scale})`}`);
    }
  }
}
