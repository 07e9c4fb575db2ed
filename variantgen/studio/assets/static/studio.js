// What every page does: edits with the version they were made on, undo, events, keys, notes. Pages import it.

const body = document.body;
export const $ = id => document.getElementById(id);
export const all = (selector, inside = document) => [...inside.querySelectorAll(selector)];
export const words = JSON.parse(body.dataset.words);
export const exam = body.dataset.exam;
export const lang = document.documentElement.lang;
export const state = { version: body.dataset.version, position: body.dataset.position };
export const own = Math.random().toString(36).slice(2);

// A phrase of the words with what it names: fill("{n} of {m}", {n: 1, m: 2}).
export const fill = (text, named) => text.replace(/\{(\w+)\}/g, (_, name) => named[name] ?? "");
export const icon = name => {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg"), use = document.createElementNS("http://www.w3.org/2000/svg", "use");
  svg.setAttribute("class", "i"); svg.setAttribute("aria-hidden", "true"); use.setAttribute("href", `#i-${name}`);
  svg.append(use);
  return svg;
};
// An element with properties and children; texts become text, never markup.
export const el = (tag, properties = {}, ...children) => {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(properties))
    if (name in made && name !== "list") made[name] = value; else made.setAttribute(name, value);
  made.append(...children.filter(child => child !== "" && child != null));
  return made;
};

// ---- requests: what cannot reach the server is tried again each second; answers that refuse are thrown.
export class Refused extends Error {
  constructor(status, data) {
    super(data?.problems?.map(p => [p.message, p.remedy].filter(Boolean).join(": ")).join("; ") ?? (status === 409 ? words.changed_elsewhere : fill(words.unexpected, { status })));
    this.status = status; this.data = data ?? {};
  }
}
const pause = ms => new Promise(done => setTimeout(done, ms));
const connected = (yes, why = "offline") => { $("offline").hidden = yes; if (!yes) $("offline").textContent = words[why]; };

async function request(url, options, again) {
  for (;;) {
    let answer;
    try {
      answer = await fetch(url, options);
    } catch (error) {
      if (error.name !== "AbortError") connected(false);
      if (error.name === "AbortError" || !again) throw error;
      await pause(1000);
      continue;
    }
    connected(answer.status !== 403, "locked");
    if (answer.status === 403 && again) { await pause(1000); continue; }  // until the new address has been opened
    const data = await answer.json().catch(() => null);
    if (!answer.ok || data === null) throw new Refused(answer.status, data);
    return data;
  }
}
export const get = (url, options = {}) => request(url, { headers: { accept: "application/json" }, ...options }, false);
export const post = (url, data, options = {}) =>
  request(url, { method: "POST", headers: { "content-type": "application/json", accept: "application/json" }, body: JSON.stringify(data), ...options }, options.again ?? true);

// ---- edits: one after another, each on the version that the one before it has made; but where others have changed the
// file since, on the version that was seen when the edit was begun.
let others = 0, elsewhere = 0;  // what other windows have done to marks or the class list leaves the version
const seen = () => { const then = state.version, before = others; return () => others === before ? state.version : then; };
let queue = Promise.resolve();
export const inTurn = work => { const next = queue.then(work, work); queue = next.catch(() => {}); return next; };

export const edit = (operations, about = "") => {
  const version = seen();
  return inTurn(async () => {
    saving(true);
    try {
      const data = settled(await post(`/${exam}/edit`, { operations, version: version(), window: own, about }));
      if (data.merged) await outside(data);
      return data;
    } catch (error) {
      if (error.status === 409) return await conflict(error.data, operations, about);
      throw error;
    } finally { saving(false); }
  });
};
// A text is that of a version: whoever writes one has to know which.
export const replaceText = (text, version) => inTurn(async () =>
  settled(await post(`/${exam}/text`, { text, version, window: own })));
// Others have changed the file: pages show it before an edit is made on the new version.
const shows = [];
export const onOutside = show => shows.push(show);
async function outside(data) { others += 1; state.version = data.version; for (const show of shows) await show(data); settled(data); }

const saving = yes => { const place = $("saved"); if (place) place.textContent = yes ? words.saving : place.dataset.saved; };
// The buttons of undo and the numbers under the steps; what others than edits of the exam do changes them, too.
export function head(data) {
  state.version = data.version; state.position = data.position;
  for (const [name, at] of [["undo", words.undo], ["redo", words.redo]]) {
    const button = $(name), text = data[name] ? `${at}: ${data[name]}` : at;
    button.disabled = !data[name]; button.title = text;
    if (name === "undo") button.querySelector(".vh").textContent = text; else button.setAttribute("aria-label", text);
  }
  for (const [name, text] of Object.entries(data.under)) all(`[data-under="${name}"]`, body).forEach(place => { place.textContent = text; });
  return data;
}
export const renew = async () => head(await get(`/${exam}/state`));
function settled(data) { head(data); dispatchEvent(new CustomEvent("exam", { detail: data })); return data; }
// The same key was changed elsewhere: both values are shown, and one of them is chosen.
async function conflict(data, operations, about) {
  if (data.moved) {
    await outside(await get(`/${exam}/state`));
    throw new Error(words.moved);
  }
  const shown = value => typeof value === "object" ? JSON.stringify(value) : String(value ?? "—");
  const mine = await choose(fill(words.conflict, { theirs: shown(data.theirs), mine: shown(data.mine) }), words.keep_mine, words.take_that);
  const now = await get(`/${exam}/state`);
  if (!mine) { await outside(now); return now; }
  const kept = settled(await post(`/${exam}/edit`, { operations, version: now.version, window: own, about }));
  await outside(kept);
  return kept;
}
async function step(name, told, at) {
  if ($(name).disabled) return;
  const what = $(name).title.split(": ").slice(1).join(": ");
  const version = seen(), then = state.position, before = others + elsewhere;
  const position = () => at ?? (others + elsewhere === before ? state.position : then);
  try {
    const data = await inTurn(async () => { const found = await post(`/${exam}/${name}`, { window: own, version: version(), position: position() }); await outside(found); return found; });
    go(data.place, fill(told, { what }));
  } catch (error) {
    if (error.status === 409) await inTurn(async () => outside(await get(`/${exam}/state`))); else await renew().catch(() => {});
    complain(error);
  }
}
// A step that is taken back is seen at its place: on this page, or on the one where it was done.
function go({ pages, address } = {}, text) {
  const to = address && new URL(address, location), build = to?.searchParams.get("build");
  if (!to || pages.includes(body.className.replace("page-", "")) && (!build || build === document.querySelector("[data-build]")?.dataset.build)) {
    note(text);
    if (to?.pathname === location.pathname) dispatchEvent(new CustomEvent("place", { detail: decodeURIComponent(to.hash.slice(1)) }));
    return;
  }
  sessionStorage.setItem("note", text);
  location.href = to;
}
export const undo = at => step("undo", words.taken_back, at);  // a note takes back what it tells of, and nothing that came later
export const redo = () => step("redo", words.done_again);
$("undo")?.addEventListener("click", () => undo());
$("redo")?.addEventListener("click", redo);

// ---- notes: ten seconds, with a way back; questions stay until they are answered.
let hiding;
export function note(text, act = "", done = null, seconds = 10) {
  clearTimeout(hiding);
  const toast = $("toast");
  toast.replaceChildren(el("span", {}, text));
  const at = state.position;
  if (act) toast.append(el("button", { type: "button", onclick: () => { toast.hidden = true; done(at); } }, act));
  toast.hidden = false;
  if (seconds) hiding = setTimeout(() => { toast.hidden = true; }, seconds * 1000);
}
function choose(text, yes, no) {
  clearTimeout(hiding);
  return new Promise(chosen => {
    const pick = value => () => { $("toast").hidden = true; chosen(value); };
    $("toast").replaceChildren(el("span", {}, text), el("button", { type: "button", onclick: pick(true) }, yes), el("button", { type: "button", onclick: pick(false) }, no));
    $("toast").hidden = false;
  });
}
export const complain = error => note(error.message || String(error));
if (sessionStorage.getItem("note")) { note(sessionStorage.getItem("note")); sessionStorage.removeItem("note"); }  // of the page before

// ---- events of the server; pages listen with on("build", data => ...).
const listeners = {};
export const on = (name, listener) => { (listeners[name] ??= []).push(listener); source.addEventListener(name, event => listener(JSON.parse(event.data))); };
let source;
function listen() {
  source = new EventSource("/events");
  source.onopen = () => connected(true);
  source.onerror = () => {
    if (source.readyState !== EventSource.CLOSED) return connected(false);
    setTimeout(async () => {  // refused: until the new address has been opened
      listen();
      if (exam) await inTurn(async () => outside(await get(`/${exam}/state`))).catch(() => {});
    }, 1000);
  };
  source.addEventListener("reload", () => location.reload());
  for (const [name, known] of Object.entries(listeners)) for (const listener of known) source.addEventListener(name, event => listener(JSON.parse(event.data)));
}
listen();
on("doc", async data => {
  if (data.exam !== exam || data.window === own) return;
  elsewhere += 1;
  await inTurn(async () => (data.version === state.version ? settled : outside)(await get(`/${exam}/state`)));
});
// What stands under the steps follows a build, from its beginning to its end.
let phase;
on("build", async data => {
  if (data.exam !== exam || data.phase === phase) return;
  phase = data.phase;
  await inTurn(async () => { const now = await get(`/${exam}/state`); return now.version === state.version ? head(now) : outside(now); }).catch(() => {});
});
addEventListener("pagehide", () => source.close());
addEventListener("pageshow", event => { if (event.persisted) location.reload(); });

// ---- copying, help, keys (by position, so that they work with every layout).
all("[data-copy]").forEach(button => button.addEventListener("click", async () => {
  await navigator.clipboard?.writeText($(button.dataset.copy).textContent);
  note(words.copied, "", null, 2);
}));
$("help").addEventListener("click", () => $("keys").showModal());
// Keys of a single letter or digit can be switched off: who speaks to the computer would press them unawares.
const SINGLE = "variantgen-single-keys";
export const single = () => localStorage.getItem(SINGLE) !== "off";
$("single").checked = single();
$("single").addEventListener("change", event => localStorage.setItem(SINGLE, event.target.checked ? "on" : "off"));
export const typing = event => /^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName) && event.target.type !== "checkbox" || event.target.isContentEditable;
addEventListener("keydown", event => {
  if (event.defaultPrevented) return;
  const control = event.ctrlKey || event.metaKey;
  const digit = /^(?:Digit|Numpad)(\d)$/.exec(event.code)?.[1];
  if (event.key === "F1" || event.key === "?" && !typing(event) && single()) $("keys").showModal();
  else if (event.altKey && event.shiftKey && digit) all(".steps a, .tools a")[digit - 1]?.click();
  else if (control && event.code === "KeyZ" && !typing(event)) event.shiftKey ? redo() : undo();
  else if (control && event.code === "KeyS") note(words.already_saved, "", null, 2);
  else if (control && event.code === "Enter") all(".primary").find(button => button.offsetParent && !button.closest("dialog"))?.click();
  else if (control && event.code === "KeyK" && document.querySelector("input[type=search]")) document.querySelector("input[type=search]").focus();
  else return;
  event.preventDefault();
});
addEventListener("click", event => all("details.exam[open]").forEach(menu => { if (!menu.contains(event.target)) menu.open = false; }));
addEventListener("keydown", event => { if (event.key === "Escape") all("details.exam[open]").forEach(menu => { menu.open = false; menu.querySelector("summary").focus(); }); });
