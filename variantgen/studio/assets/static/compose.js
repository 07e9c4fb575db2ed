// Compose: the list of problems, one problem with its sliders, the sheet of a student, the text of the file.
import { $, all, complain, edit, el, exam, fill, get, icon, lang, note, onOutside, post, replaceText, typing, undo } from "./studio.js";

const page = document.querySelector(".compose"), words = JSON.parse(page.dataset.words);
const outline = $("outline"), inspect = $("inspect");
const asked = new URLSearchParams({ lang });
let drafting = false, begun = "";  // whether the text is a draft, and the version at which that was begun
let current = Math.max(1, Number(location.hash.slice(1)) || 1), family = "", form = "", count = 0, source = { text: "", lines: [], mistakes: [] };
const late = (work, ms) => { let timer; return (...given) => { clearTimeout(timer); timer = setTimeout(() => work(...given), ms); }; };
const html = async url => { const answer = await fetch(url); if (!answer.ok) throw new Error((await answer.json()).problems[0].message); return answer.text(); };
const idle = () => !document.activeElement || document.activeElement === document.body;  // nobody has gone on elsewhere
const undoWord = document.querySelector("#undo .lbl").textContent;

// ---- the list
async function list() {
  const data = await get(`/${exam}/outline?${asked}`);
  const at = document.activeElement, row = outline.contains(at) ? at.closest("li") : null, typed = at.value;
  outline.innerHTML = data.html; outline.setAttribute("aria-busy", "false");
  if (row) {  // whoever is in the list stays there
    const same = all("li", outline).find(one => one.dataset.number === row.dataset.number)?.querySelector(at.className ? `.${at.className}` : at.tagName);
    const kept = same?.closest("li").dataset.key === row.dataset.key;  // what was typed for another problem is dropped
    if (same?.matches("input") && typed !== at.defaultValue && kept) same.value = typed;
    same?.focus();
  }
  count = data.count; $("line").textContent = data.line; $("empty").hidden = count > 0;
  current = Math.min(current, Math.max(1, count));
  mark(); showSource(data);
}
const mark = () => all("li", outline).forEach(row => { if (Number(row.dataset.number) === current) row.setAttribute("aria-current", "true"); else row.removeAttribute("aria-current"); });
async function show(number, focus = false) {
  if (number !== current) { family = form = ""; }
  current = number; history.replaceState(null, "", `#${number}`); mark(); if (!drafting) mistakes(source.mistakes); scrollSource();
  if (!count) { inspect.replaceChildren(); return; }
  try {
    inspect.innerHTML = await html(`/${exam}/problem/${number}?${asked}&family=${encodeURIComponent(family)}&form=${encodeURIComponent(form)}`);
    ({ family, form } = inspect.querySelector(".scroll").dataset);
    if (focus) inspect.querySelector("h2").focus({ preventScroll: true });
    prepare(); attempt({}); room();
  } catch (error) { inspect.replaceChildren(el("p", { className: "notice wrong" }, error.message)); }
}
const change = async (operations, about = "") => { const data = await edit(operations, about); await list(); page_(); return data; };
async function move(from, to) {
  if (to < 1 || to > count || from === to) return;
  try { await change([{ op: "move", path: `problem[${from}]`, to }]); await show(to); if (idle()) outline.children[to - 1].querySelector(".grip").focus(); } catch (error) { complain(error); }
}
async function remove(number) {
  try {
    const data = await change([{ op: "remove", path: `problem[${number}]` }]);
    await show(Math.min(number, Math.max(1, count)));
    note(data.undo, undoWord, undo);
  } catch (error) { complain(error); }
}
$("empty").addEventListener("click", async event => {
  const { family: name, form: own } = event.target.closest("button")?.dataset ?? {};
  if (!name) return;
  try { await change([{ op: "insert", path: "problem", at: 1, value: own ? { family: name, form: own, points: 10 } : { family: name, points: 10 } }]); await show(1, true); } catch (error) { complain(error); }
});
outline.addEventListener("click", event => {
  const row = event.target.closest("li");
  if (event.target.closest("a")) { event.preventDefault(); show(Number(row.dataset.number)); }
});
outline.addEventListener("keydown", event => {
  const row = event.target.closest("li"), number = Number(row?.dataset.number), grip = event.target.closest(".grip");
  if (!row || typing(event) && !(event.altKey && /Arrow/.test(event.code))) return;
  const way = { ArrowUp: -1, ArrowDown: 1 }[event.code];
  if (way && (event.altKey || grip)) move(number, number + way);
  else if (way) outline.children[number - 1 + way]?.querySelector("a").focus();
  else if (event.code === "Delete") remove(number);
  else return;
  event.preventDefault();
});
let dragged = 0;
outline.addEventListener("dragstart", event => { dragged = Number(event.target.closest("li").dataset.number); event.dataTransfer.effectAllowed = "move"; });
outline.addEventListener("dragover", event => { event.preventDefault(); all("li", outline).forEach(row => row.classList.toggle("over", row === event.target.closest("li"))); });
outline.addEventListener("drop", event => { event.preventDefault(); const row = event.target.closest("li"); if (row) move(dragged, Number(row.dataset.number)); });
outline.addEventListener("dragend", () => all("li", outline).forEach(row => row.classList.remove("over")));

// ---- fields that are keys of the file
const number_ = text => { const found = text.trim().replace(",", ".").replace("−", "-"); return /^-?\d+(\.\d+)?$/.test(found) ? Number(found) : null; };
const kinds = {
  text: field => field.value.trim(),
  word: field => /^\d{1,15}$/.test(field.value.trim()) ? Number(field.value) : field.value.trim(),
  flag: field => field.checked,
  number: field => number_(field.value),
  percent: field => { const found = number_(field.value); return found === null ? null : Number((found / 100).toFixed(8)); },
};
page.addEventListener("change", async event => {
  const field = event.target, path = field.dataset?.path;
  if (!path) return;
  const value = kinds[field.dataset.kind](field), empty = field.type !== "checkbox" && !field.value.trim();
  if (value === null && !empty) return refused(field, words.no_number);
  if (field.dataset.kind === "percent" && !empty && !(value > 0 && value < 0.2)) return refused(field, words.no_percent);
  refused(field, "");
  const about = field.labels?.[0]?.textContent.trim() ?? "";
  const whole = path === "tolerance.ceiling" && !source.text.match(/^tolerance\.|^\[tolerance\]/m) && value !== null;
  try {
    if (empty) await change([{ op: "unset", path }], about);
    else if (whole) await change([{ op: "set", path: "tolerance", value: { floor: kinds.percent(document.querySelector("[data-path^=tolerance]")) ?? 0.01, ceiling: value } }], about);
    else await change([{ op: "set", path, value }], about);
    if (path.endsWith(".nice") || path.startsWith("tolerance")) show(current);
    field.dataset.was = field.value;
  } catch (error) { refused(field, error.message); }
});
// What is wrong with a field stands below it, with a way back to what the file has.
const wrongs = new WeakMap();
function refused(field, text) {
  wrongs.get(field)?.remove();
  field.setAttribute("aria-invalid", String(Boolean(text)));
  if (!text) return;
  const back = () => { field.value = field.dataset.was ?? field.defaultValue; refused(field, ""); field.focus(); };
  const told = el("p", { className: "error", role: "alert" }, text, " ", el("button", { type: "button", onclick: back }, words.reset));
  wrongs.set(field, told);
  const row = field.closest("li");
  if (row) row.append(told); else (field.closest("label") ?? field).after(told);
}

// ---- one problem
const at = name => `problem[${current}].${name}`;
inspect.addEventListener("click", async event => {
  const button = event.target.closest("button");
  if (!button) return;
  try {
    if (button.dataset.showFamily) { family = button.dataset.showFamily; form = ""; await show(current); }
    else if (button.dataset.chip) await chip(button);
    else if (button.dataset.do === "remove") await remove(current);
    else if (button.dataset.do === "copy") await copy();
    else if (button.dataset.do === "less") await pool(name => name !== button.value);
    else return;
  } catch (error) { complain(error); }
});
async function chip(button) {
  const group = button.dataset.chip, same = all(`[data-chip=${group}]`, inspect), chosen = same.filter(one => (one.getAttribute("aria-pressed") === "true") !== (one === button)).map(one => one.value);
  if (!chosen.length) return note(group === "ask" ? words.ask_one : words.form_one);
  const byForm = group === "ask" && source.text.split("\n").slice(source.lines[current - 1], source.lines[current] - 1 || undefined).some(line => /^\s*ask\s*(\.|=\s*\{)/.test(line));
  const path = at(byForm ? `ask.${form}` : group);
  if (group === "form" && chosen.length === same.length) await change([{ op: "unset", path }]);
  else await change([{ op: "set", path, value: group === "form" && chosen.length === 1 ? chosen[0] : chosen }], inspect.querySelector(group === "ask" ? "#findh" : "#formh").textContent);
  await show(current);
  if (idle()) inspect.querySelector(`[data-chip=${group}][value="${CSS.escape(button.value)}"]`)?.focus();
}
async function copy() {
  const found = (await get(`/${exam}/table/${current}`)).table;
  await change([{ op: "insert", path: "problem", at: current + 1, value: found }]);
  await show(current + 1, true);
}
async function pool(keep, added = "") {
  const names = all("[data-show-family]", inspect).map(one => one.dataset.showFamily), now = (names.length ? names : [family]).filter(keep).concat(added ? [added] : []);
  const operations = now.length > 1 ? [{ op: "unset", path: at("family") }, { op: "set", path: at("families"), value: now }] : [{ op: "unset", path: at("families") }, { op: "set", path: at("family"), value: now[0] }];
  if (added) for (const key of ["form", "ask", "range", "set"]) operations.unshift({ op: "unset", path: at(key) });
  await change(operations, words.pool); family = added; form = ""; await show(current);
}
inspect.addEventListener("focusin", async event => {   // the families come when they are asked for
  const select = event.target.closest("[data-do=more]");
  if (!select || select.length > 1) return;
  const data = await get(`/families?${asked}`);
  select.append(...data.families.map(one => el("option", { value: one.name }, one.title)));
});
inspect.addEventListener("change", event => { if (event.target.dataset.do === "more" && event.target.value) pool(() => true, event.target.value).catch(complain); });

// ---- sliders: the figure follows the handle, the file what is let go
const rows = () => all(".range", inspect);
const values = row => row.dataset.values.split(" ");
function prepare() { rows().forEach(row => draw(row)); }
function draw(row) {
  const [low, high] = all("input[type=range]", row), grid = values(row), last = Math.max(1, grid.length - 1), unit = row.querySelector(".unit").textContent;
  const [a, b] = [Number(low.value), Number(high.value)];
  const span = row.querySelector(".span");
  span.setAttribute("x", `${100 * a / last}%`); span.setAttribute("width", `${100 * Math.max(0, b - a) / last}%`);
  low.setAttribute("aria-valuetext", `${grid[a]} ${unit}`); high.setAttribute("aria-valuetext", `${grid[b]} ${unit}`);
  const [from, to] = all(".num", row);
  for (const [field, place] of [[from, a], [to, b]]) if (field !== document.activeElement || field.value === field.dataset.put) field.value = field.dataset.put = grid[place];
  all(".bars rect", row).forEach(bar => bar.setAttribute("class", Number(bar.dataset.to) < a || Number(bar.dataset.from) > b ? "out" : ""));
}
function bars(row, accepted) {
  const grid = values(row), size = Math.ceil(grid.length / 20), last = Math.max(1, grid.length - 1), sums = [];
  for (let i = 0; i < grid.length; i += size) sums.push([i, Math.min(i + size, grid.length) - 1, accepted.slice(i, i + size).reduce((x, y) => x + y, 0)]);
  const most = Math.max(1, ...sums.map(one => one[2])), wide = 80 / sums.length;
  row.querySelector(".bars").replaceChildren(...sums.map(([from, to, sum]) => {
    const bar = document.createElementNS("http://www.w3.org/2000/svg", "rect"), high = Math.max(1, 22 * sum / most);
    for (const [name, value] of Object.entries({ x: `${100 * (from + to) / 2 / last - wide / 2}%`, y: 22 - high, width: `${wide}%`, height: high, "data-from": from, "data-to": to })) bar.setAttribute(name, value);
    return bar;
  }));
  draw(row);
}
async function keep(row) {
  const [low, high] = all("input[type=range]", row).map(input => Number(input.value)), grid = values(row), name = row.dataset.name, last = grid.length - 1;
  if (low === Number(row.dataset.low) && high === Number(row.dataset.high)) return;
  const operations = [{ op: "unset", path: at(`set.${name}`) }];
  if (low === 0 && high === last) operations.push({ op: "unset", path: at(`range.${name}`) });
  else if (low === high) operations.push({ op: "unset", path: at(`range.${name}`) }, { op: "set", path: at(`set.${name}`), value: Number(grid[low]) });
  else operations.push({ op: "set", path: at(`range.${name}`), value: [Number(grid[low]), Number(grid[high])] });
  try {
    await change(operations, row.firstElementChild.textContent);
    row.dataset.low = low; row.dataset.high = high; wrong(row, ""); room();
  } catch (error) { wrong(row, error.message, [words.reset, () => { all("input[type=range]", row).forEach((input, i) => { input.value = i ? row.dataset.high : row.dataset.low; }); wrong(row, ""); draw(row); }]); }
}
function wrong(row, text, act) {
  const place = row.querySelector(".error");
  place.hidden = !text; place.replaceChildren(text);
  if (act) place.append(el("button", { type: "button", onclick: act[1] }, act[0]));
}
inspect.addEventListener("input", event => {
  const row = event.target.closest(".range");
  if (!row || event.target.type !== "range") return;
  const [low, high] = all("input[type=range]", row);
  if (Number(low.value) > Number(high.value)) (event.target === low ? high : low).value = event.target.value;
  draw(row); attempt({ [row.dataset.name]: values(row)[event.target.value] });
});
inspect.addEventListener("change", event => {
  const row = event.target.closest(".range");
  if (!row) return;
  if (event.target.classList.contains("num")) {
    const grid = values(row).map(Number), [from, to] = all(".num", row).map(input => number_(input.value)), [low, high] = all("input[type=range]", row);
    if (from === null || to === null) return wrong(row, words.no_number, [words.reset, () => { wrong(row, ""); draw(row); }]);
    if (from > to) return wrong(row, words.reversed, [words.swap, () => { const [x, y] = all(".num", row); [x.value, y.value] = [y.value, x.value]; x.dispatchEvent(new Event("change", { bubbles: true })); }]);
    const inside = grid.map((value, i) => [value, i]).filter(([value]) => value >= from && value <= to);
    if (!inside.length) return wrong(row, fill(words.outside, { low: grid[0], high: grid.at(-1) }), [words.reset, () => { wrong(row, ""); draw(row); }]);
    low.value = inside[0][1]; high.value = inside.at(-1)[1]; event.target.dataset.put = event.target.value; draw(row); attempt({ [row.dataset.name]: values(row)[event.target === all(".num", row)[0] ? low.value : high.value] });
  }
  keep(row);
});
inspect.addEventListener("keydown", event => {
  const input = event.target.closest(".track input"), five = { PageUp: 5, PageDown: -5 }[event.code];
  if (!input || !five || event.altKey) return;
  event.preventDefault();
  input.value = Number(input.value) + five;
  input.dispatchEvent(new Event("input", { bubbles: true })); input.dispatchEvent(new Event("change", { bubbles: true }));
});
// One request under way, the newest value next; answers that come late are dropped.
let asking = false, next = null, n = 0;
async function attempt(values) {
  next = values;
  if (asking) return;
  asking = true;
  while (next) {
    const given = next, own = ++n; next = null;
    try {
      const found = await post(`/${exam}/try?${asked}`, { problem: current, family, form, at: given, n: own }, { again: false });
      if (found.n === n) figure(found, given);
    } catch (error) { $("caption") && ($("caption").textContent = error.message); }
  }
  asking = false;
}
function figure(found, given) {
  const live = $("live");
  if (!live) return;
  if (found.svg) live.innerHTML = found.svg;
  live.classList.toggle("pale", !found.svg); live.setAttribute("aria-busy", "false");
  const told = Object.entries(given).map(([name, value]) => { const row = rows().find(one => one.dataset.name === name); return `${row.firstElementChild.textContent} = ${value} ${row.querySelector(".unit").textContent}`; });
  $("caption").textContent = [...told, found.reason].filter(Boolean).join(" · ") || "\u00a0";
  $("caption").classList.toggle("bad", Boolean(found.reason));
}
const percent = share => `${(100 * share).toFixed(share && share < 0.01 ? 1 : 0).replace(".", lang === "ru" ? "," : ".")} %`;
const room = late(async () => {
  const number = current, place = $("room");
  try {
    const data = await get(`/${exam}/room/${number}?${asked}&family=${encodeURIComponent(family)}&form=${encodeURIComponent(form)}`);
    if (number !== current || place !== $("room")) return;
    $("count").textContent = data.share ? data.count : words.none_fits; $("count").classList.toggle("few", data.few);
    $("needed").textContent = [data.needed, data.few && data.share ? words.too_few : ""].filter(Boolean).join(" · ");
    place.querySelector(".keep").setAttribute("width", `${100 * data.share}%`);
    let x = data.share;
    const ns = "http://www.w3.org/2000/svg", pieces = [];
    for (const { share } of data.screens) {
      const piece = document.createElementNS(ns, "rect"), line = document.createElementNS(ns, "line");
      for (const [name, value] of Object.entries({ class: "cut", x: `${100 * x}%`, y: 0, width: `${100 * share}%`, height: 16 })) piece.setAttribute(name, value);
      for (const [name, value] of Object.entries({ x1: `${100 * x}%`, x2: `${100 * x}%`, y1: 0, y2: 16 })) line.setAttribute(name, value);
      pieces.push(piece, line); x += share;
    }
    place.querySelector(".stack g").replaceChildren(...pieces);
    const most = data.screens.slice(0, 4), rest = data.screens.slice(4).reduce((sum, one) => sum + one.share, 0);
    const shown = rest >= 0.005 ? [...most, { share: rest, word: words.other }] : most;
    $("why").replaceChildren(el("li", { className: "keep" }, el("b", {}, percent(data.share)), ` ${words.passes}`), ...shown.map(one => el("li", {}, el("b", {}, percent(one.share)), ` ${one.word}`)));
    rows().forEach(row => { if (data.accepted[row.dataset.name]) bars(row, data.accepted[row.dataset.name]); });
  } catch (error) { $("count").textContent = "—"; $("needed").textContent = error.message; }
  place.setAttribute("aria-busy", "false");
}, 300);

// ---- the sheet of a student
const student = $("student"), pages = $("pages");
let kind = "sheet";
const page_ = late(async () => {
  if (!count) { pages.replaceChildren(); return; }
  pages.setAttribute("aria-busy", "true");
  if (!pages.firstChild) pages.append(el("p", { className: "small" }, words.setting));
  const who = student.selectedIndex + 1, wanted = kind;
  try {
    const data = await get(`/${exam}/sheet/${who}?kind=${kind}`);
    if (who !== student.selectedIndex + 1 || wanted !== kind) return;
    const shown = Array.from({ length: data.pages }, (_, i) => el("div", { className: "sheet" }, el("img", { src: `/${exam}/page/${data.name}/${i + 1}.svg`, alt: fill(words.page_of, { number: i + 1, student: student.value }), width: 595, height: 842, loading: i ? "lazy" : "eager" })));
    await Promise.all(shown.slice(0, 1).map(one => one.firstChild.decode().catch(() => {})));
    pages.replaceChildren(...shown);
  } catch (error) { pages.replaceChildren(el("p", { className: "error" }, error.message)); }
  pages.setAttribute("aria-busy", "false");
}, 400);
all(".tabs [data-kind]").forEach(button => button.addEventListener("click", () => {
  kind = button.dataset.kind;
  all(".tabs [data-kind]").forEach(one => one.setAttribute("aria-pressed", String(one === button)));
  page_();
}));
const other = by => { student.selectedIndex = Math.min(student.length - 1, Math.max(0, student.selectedIndex + by)); page_(); };
student.addEventListener("change", () => page_());
$("before").addEventListener("click", () => other(-1));
$("after").addEventListener("click", () => other(1));
addEventListener("keydown", event => {
  const by = { PageUp: -1, PageDown: 1 }[event.code];
  if (by && event.altKey && !event.ctrlKey) { event.preventDefault(); other(by); }
});

// ---- the text of the file: what is wrong stays a draft, what is right is saved
const text = $("source"), gutter = $("gutter");
function showSource(data) {
  source = data;
  if (!drafting) { const top = text.scrollTop; text.value = data.text; text.scrollTop = top; }
  if (drafting) check();  // of the draft it is said what is wrong, and that the file is another one by now
  else { mistakes(data.mistakes); scrollSource(); }
}
function mistakes(found) {
  const from = source.lines[current - 1] ?? 0, to = source.lines[current] ?? Infinity, bad = new Set(found.map(one => one.line));
  gutter.replaceChildren(...text.value.split("\n").map((_, i) => el("b", { className: bad.has(i + 1) ? "bad" : i + 1 >= from && i + 1 < to && from ? "on" : "" }, String(i + 1))));
  gutter.scrollTop = text.scrollTop;
  $("oops").hidden = !found.length;
  $("oops").replaceChildren(...found.map(one => el("li", {}, el("button", { type: "button", onclick: () => goTo(one.line) }, fill(words.line, { number: one.line })), [one.key, one.message].filter(Boolean).join(": "), one.remedy ? ` — ${one.remedy}` : "")));
}
const height = () => parseFloat(getComputedStyle(text).lineHeight);
function scrollSource() { if (document.activeElement !== text) { text.scrollTop = Math.max(0, ((source.lines[current - 1] ?? 1) - 2) * height()); gutter.scrollTop = text.scrollTop; } }
function goTo(line) {
  const start = text.value.split("\n").slice(0, line - 1).join("\n").length + (line > 1 ? 1 : 0);
  text.focus(); text.setSelectionRange(start, start); text.scrollTop = Math.max(0, (line - 3) * height());
}
text.addEventListener("scroll", () => { gutter.scrollTop = text.scrollTop; });
text.addEventListener("input", () => {
  if (!drafting) begun = source.version;
  drafting = begun !== source.version || text.value !== source.text;
  mistakes([]); check();
});
// The file has another text than when the draft was begun: both are shown, and one is chosen.
function bothTexts(mine, now) {
  const keep = async () => { try { await save(mine, now.version); } catch (error) { complain(error); } };
  const take = async () => { drafting = false; $("texted").textContent = ""; await list(); await show(current); page_(); };
  $("texted").textContent = words.draft;
  $("oops").hidden = false;
  $("oops").replaceChildren(el("li", {}, words.both_texts, " ", el("button", { type: "button", onclick: keep }, words.keep_draft), " ", el("button", { type: "button", onclick: take }, words.take_file), el("pre", { tabIndex: 0 }, now.text)));
}
async function save(typed, version) {
  try {
    await replaceText(typed, version);
  } catch (error) {
    if (error.status !== 409) throw error;
    const now = await get(`/${exam}/outline?${asked}`);
    if (now.text !== typed) return bothTexts(typed, now);
  }
  drafting = text.value !== typed; $("texted").textContent = words.saved;
  await list(); await show(current); page_();
  if (drafting) { begun = source.version; check(); }
}
const check = late(async () => {
  const typed = text.value;
  try {
    const found = (await post(`/${exam}/check`, { text: typed, version: begun })).mistakes;
    if (typed !== text.value) return;
    mistakes(found);
    $("texted").textContent = found.length ? words.draft : "";
    if (found.length || !drafting) return;
    await save(typed, begun);
  } catch (error) { error.data?.problems ? mistakes(error.data.problems) : complain(error); }
}, 500);
// A draft that was left is offered again, on the version that it was begun on.
async function offer() {
  const draft = await get(`/${exam}/draft`);
  if (!draft.text || drafting) return;
  const go = () => { drafting = true; begun = draft.version; text.value = draft.text; mistakes([]); check(); };
  const drop = async () => { try { await post(`/${exam}/check`, { text: source.text, version: source.version }); mistakes(source.mistakes); } catch (error) { complain(error); } };
  $("oops").hidden = false;
  $("oops").append(el("li", {}, words.draft_left, " ", el("button", { type: "button", onclick: go }, words.draft_go_on), " ", el("button", { type: "button", onclick: drop }, words.draft_drop)));
}
$("larger").addEventListener("click", event => { const on = document.querySelector(".toml").classList.toggle("large"); event.currentTarget.setAttribute("aria-pressed", String(on)); });

onOutside(async () => { await list(); await show(current); page_(); });
addEventListener("place", event => { if (Number(event.detail)) show(Number(event.detail)); });
addEventListener("hashchange", () => show(Number(location.hash.slice(1)) || 1));

try {
  const data = await get(`/${exam}/students`);
  student.append(...data.names.map((name, i) => el("option", {}, data.roster ? name : fill(words.variant, { number: i + 1 }))));
} catch (error) { complain(error); }
await list(); await show(current); page_(); await offer().catch(complain);
