// Mark: answers typed by keyboard alone, doubtful readings decided, one student or one question at a time, the rules.
import { $, all, complain, el, exam, fill, get, lang, note, on, own, post, renew, typing, undo } from "./studio.js";

const page = document.querySelector(".marking"), words = JSON.parse(page.dataset.words), build = page.dataset.build;
const asked = more => new URLSearchParams({ build, lang, window: own, ...more });
const state = { view: page.dataset.view, code: "", problem: "", quantity: "", only: "all", kind: "sheet" };
const shown = $("shown") ?? el("div"), list = $("list") ?? el("div");  // there is nothing to mark without a build

// ---- pieces of the page: the newest one wins, what is being typed stays
let showing;
async function piece(place, address, signal) {
  const answer = await fetch(address, { signal, headers: { accept: "text/html" } });
  if (!answer.ok) { const data = await answer.json().catch(() => null); throw new Error(data?.problems?.map(p => p.message).join("; ") ?? fill(words.failed, { status: answer.status })); }
  const text = await answer.text(), old = document.activeElement, id = place.contains(old) ? old.id : "";
  const typed = id && old.tagName === "INPUT" ? [old.value, old.dataset.was, old.selectionStart, old.selectionEnd] : null;
  const sent = all("input[data-sent]", place).map(box => [box.id, box.value]);  // on their way: the page may be older
  const at = all(".sheetwork, .people, .beside", place).map(part => part.scrollTop);
  const pages = $("pages"), kept = pages && place.contains(pages) ? [pages.dataset.code, pages.dataset.kind, [...pages.children]] : null;
  place.innerHTML = text;
  place.setAttribute("aria-busy", "false");
  all(".sheetwork, .people, .beside", place).forEach((part, i) => { part.scrollTop = at[i] ?? 0; });
  for (const [name, value] of sent) { const box = document.getElementById(name); if (box) box.value = box.dataset.was = value; }
  const again = id && document.getElementById(id);
  if (again) { again.focus({ preventScroll: true }); if (typed && typed[0] !== typed[1]) { again.value = typed[0]; again.setSelectionRange?.(typed[2], typed[3]); } }
  if (kept && $("pages")?.dataset.code === kept[0]) { $("pages").dataset.kind = kept[1]; $("pages").replaceChildren(...kept[2]); }
}
async function showList() {
  await piece(list, `/${exam}/mark/list?${asked()}`);
  const marked = list.querySelector("[data-marked]").dataset.marked;
  if (!$("which")?.selectedIndex) all("[data-under=mark]", document.body).forEach(place => { place.textContent = marked; });  // of the last build
  mark();
}
function mark() {
  all(".people", list).forEach(people => { people.hidden = people.dataset.of !== (state.view === "questions" ? "questions" : "students"); people.classList.toggle("few", state.only === "doubts"); });
  all("[data-only]", list).forEach(button => button.setAttribute("aria-pressed", button.dataset.only === state.only));
  all(".people a", list).forEach(link => {
    const now = state.view === "questions" ? link.dataset.problem === state.problem && link.dataset.quantity === state.quantity : link.dataset.code === state.code;
    if (now) { link.setAttribute("aria-current", "true"); link.scrollIntoView({ block: "nearest" }); } else link.removeAttribute("aria-current");
  });
  all(".head [data-view]").forEach(button => button.setAttribute("aria-pressed", button.dataset.view === state.view));
  $("mark").classList.toggle("alone", state.view === "class");
}
async function show(focus = false) {
  showing?.abort();
  showing = new AbortController();
  shown.setAttribute("aria-busy", "true");
  mark();
  try {
    await piece(shown, `/${exam}/mark/shown?${asked({ view: state.view, code: state.code, problem: state.problem, quantity: state.quantity })}`, showing.signal);
  } catch (error) { if (error.name !== "AbortError") { shown.setAttribute("aria-busy", "false"); complain(error); } return; }
  if (focus) (all("[data-pick] button", shown)[0] ?? all("[data-answer] input", shown).find(box => !box.value) ?? all("[data-answer] input", shown)[0])?.focus();
  sheet();
}
let later;
function refresh() { clearTimeout(later); later = setTimeout(async () => { await show(); await Promise.all([renew(), showList()]).catch(complain); }, 400); }
const beside = () => all("button[data-kind]", shown).some(button => button.dataset.kind === state.kind) ? state.kind : "sheet";  // not every exam has scans
async function sheet() {
  const pages = $("pages");
  if (!pages) return;
  all("[data-kind]", shown).forEach(button => button.tagName === "BUTTON" && button.setAttribute("aria-pressed", button.dataset.kind === beside()));
  const code = pages.dataset.code, kind = beside();
  if (kind === "scan") return scan(pages, code).catch(complain);
  if (pages.dataset.kind === kind && pages.children.length) return;
  try {
    const found = await get(`/${exam}/mark/sheet?${asked({ code, kind })}`);
    if ($("pages")?.dataset.code !== code || beside() !== kind) return;
    $("pages").dataset.kind = kind;
    $("pages").replaceChildren(...Array.from({ length: found.pages }, (_, i) => el("img", { className: "sheet", src: `/${exam}/page/${found.name}/${i + 1}.svg`, alt: fill(words.page_of, { number: i + 1, code }), width: 595, height: 842 })));
  } catch (error) { complain(error); }
}
// The pages of the scan; what was decided meanwhile has other boxes, the pictures stay.
async function scan(pages, code) {
  const answer = await fetch(`/${exam}/mark/scan?${asked({ code })}`, { headers: { accept: "text/html" } });
  if (!answer.ok) throw new Error(fill(words.failed, { status: answer.status }));
  const text = await answer.text();
  pages = $("pages");
  if (pages?.dataset.code !== code || beside() !== "scan") return;
  const made = el("div");
  made.innerHTML = text;
  const old = pages.dataset.kind === "scan" ? all("img", pages) : [];
  all("img", made).forEach(image => {
    const same = old.find(one => one.getAttribute("src") === image.getAttribute("src"));
    if (same) image.replaceWith(same);
    else image.addEventListener("error", () => image.closest("a").replaceWith(el("p", { className: "error" }, words.scan_gone)));
  });
  pages.dataset.kind = "scan";
  pages.replaceChildren(...made.childNodes);
  point();
}
// The box of the answer that is being looked at.
function point() {
  const id = document.activeElement?.closest("[data-answer] input")?.id ?? document.activeElement?.closest("[data-pick]")?.dataset.pick;
  all("[data-box]", shown).forEach(box => box.classList.toggle("now", box.dataset.box === id));
  if (id) shown.querySelector("[data-box].now")?.scrollIntoView({ block: "nearest" });
}
shown.addEventListener("focusin", point);
const links = () => all(`.people[data-of=${state.view === "questions" ? "questions" : "students"}] a`, list).filter(link => link.offsetParent);
function open(link) {
  if (!link) return;
  leave();
  if (link.dataset.code) { state.view = "students"; state.code = link.dataset.code; } else { state.view = "questions"; state.problem = link.dataset.problem; state.quantity = link.dataset.quantity; }
  return show(true);
}
function go(by) {
  const all_ = links(), at = all_.findIndex(link => link.hasAttribute("aria-current"));
  return open(all_[at + by] ?? (by > 0 && state.only === "doubts" ? all_[0] : undefined));
}
function see(view) {
  leave();
  state.view = view;
  if (view === "questions" && !state.problem) { const first = list.querySelector("[data-problem]"); state.problem = first?.dataset.problem ?? ""; state.quantity = first?.dataset.quantity ?? ""; }
  return show(true);
}

// ---- answers
const saying = new Set();  // answers on their way: marks are written after them
async function say(row, text) {
  const { code, problem, quantity } = row.dataset;
  const sent = post(`/${exam}/mark/say?${asked()}`, { code, problem, quantity, text }, { keepalive: true });  // a window that is closed loses none
  saying.add(sent);
  const data = await sent.finally(() => saying.delete(sent));
  $("command").textContent = data.command;
  const verdict = row.querySelector(".v"), kind = { right: "right", wrong: "wrong", blank: "blank" }[data.verdict] ?? "doubt";
  verdict.className = `v ${kind}`; verdict.lastChild.textContent = words[`verdict_${data.verdict}`];
  if (data.before !== data.typed) await renew().catch(complain);
  if (data.of_file) note(fill(words.stands, data), data.before ? words.take_back : "", undo);
  else if (data.before && data.before !== text) note(fill(words.changed, { before: data.before, text: data.text || "–" }), words.take_back, undo);
  refresh();
}
async function commit(box) {
  const text = box.value.trim(), was = box.dataset.was;
  if (text === was) return;
  box.dataset.was = text; box.dataset.sent = "yes";
  try { await say(box.closest("[data-answer]"), text); } catch (error) { box.dataset.was = was; complain(error); }
  delete box.dataset.sent;
}
// What is being typed is kept before anything else is shown, and when the window is closed.
const leave = () => { const box = document.activeElement; return box?.matches("[data-answer] input") ? commit(box) : undefined; };
addEventListener("pagehide", leave);
const boxes = () => all("[data-answer] input", shown);
shown.addEventListener("change", event => { if (event.target.closest("[data-answer]")) commit(event.target); if (event.target.closest("#policy")) effect(false); });
shown.addEventListener("keydown", event => {
  const box = event.target.closest("[data-answer] input"), pick = event.target.closest("[data-pick]");
  const step = event.code === "Enter" || event.code === "NumpadEnter" || event.code === "ArrowDown" ? 1 : event.code === "ArrowUp" ? -1 : 0;
  if (box && step && !event.ctrlKey && !event.altKey) {
    commit(box);
    const next = boxes()[boxes().indexOf(box) + step];
    if (next) { next.focus(); next.select(); } else if (event.code.endsWith("Enter")) go(1);
  } else if (pick && /^(Digit|Numpad)\d$/.test(event.code)) pick.querySelector(`[data-key="${event.code.slice(-1)}"]`)?.click();
  else return;
  event.preventDefault();
});
addEventListener("keydown", event => {
  if (event.defaultPrevented || event.ctrlKey || event.altKey || event.metaKey || document.querySelector("dialog[open]") || state.view === "class") return;
  if (event.code === "PageDown" || event.code === "PageUp") { go(event.code === "PageDown" ? 1 : -1); event.preventDefault(); }
});
shown.addEventListener("click", async event => {
  const button = event.target.closest("button");
  if (!button) return;
  if (button.dataset.go) go(Number(button.dataset.go));
  if (button.dataset.kind) { state.kind = button.dataset.kind; sheet(); }
  if (button.dataset.reading) {
    const doubt = button.closest(".doubtrow"), row = doubt.previousElementSibling, nexts = all("[data-pick]", shown), next = nexts[nexts.indexOf(button.closest("[data-pick]")) + 1];
    try { await say(row, button.dataset.reading); row.querySelector("input").value = row.querySelector("input").dataset.was = button.dataset.reading; doubt.remove(); (next?.querySelector("button") ?? row.querySelector("input")).focus(); } catch (error) { complain(error); }
  }
});

// ---- rules
let trying = 0;
const fields = () => Object.fromEntries(all("#policy input", shown).filter(box => box.value.trim() !== box.dataset.was).map(box => [box.name, box.value]));
async function effect(use) {
  const own = fields(), n = ++trying;
  $("use").disabled = !Object.keys(own).length;
  if (!Object.keys(own).length) { $("effect").replaceChildren(); return; }
  try {
    const found = await post(`/${exam}/mark/policy?${asked()}`, { fields: own, use });
    if (n !== trying) return;
    if (use) { $("command").textContent = found.command; await all_(); note(words.rules_used, words.take_back, undo); return; }
    const who = found.who.length ? el("details", {}, el("summary", {}, words.who), el("ul", {}, ...found.who.map(one => el("li", {}, `${one.name}: ${one.before} → ${one.now}`)))) : "";
    $("effect").replaceChildren(found.who.length ? fill(words.effect, found) : words.no_effect, who);
  } catch (error) { $("use").disabled = true; $("effect").textContent = error.message; }
}
shown.addEventListener("submit", event => { event.preventDefault(); effect(true); });

// ---- the list, files, codes
list.addEventListener("click", async event => {
  const link = event.target.closest(".people a"), button = event.target.closest("button");
  if (link) { event.preventDefault(); open(link); }
  if (button?.dataset.only) { state.only = button.dataset.only; mark(); if (state.only === "doubts") open(links()[0]); }
  if (button?.dataset.view) see(button.dataset.view);
  if (button?.dataset.back) back(button.dataset.back);
  if (button?.dataset.drop) try {
    const found = await post(`/${exam}/mark/drop?${asked()}`, { file: button.dataset.drop });
    $("command").textContent = found.command;
    await all_();
    note(fill(words.removed, { file: button.dataset.name }), words.take_back, undo);
  } catch (error) { complain(error); }
});
list.addEventListener("keydown", event => {
  const link = event.target.closest(".people a"), by = { ArrowDown: 1, ArrowUp: -1 }[event.code];
  if (!link || !by) return;
  links()[links().indexOf(link) + by]?.focus();
  event.preventDefault();
});
list.addEventListener("submit", async event => {
  event.preventDefault();
  const box = event.target.who;
  try {
    state.code = (await get(`/${exam}/mark/find?${asked({ who: box.value })}`)).code;
    box.value = ""; state.view = "students";
    await show(true);
  } catch (error) { note(error.message); box.select(); }
});
// A file comes back out of the bin.
async function back(kept) {
  try {
    $("command").textContent = (await post(`/${exam}/mark/restore?${asked()}`, { kept })).command;
    await all_();
  } catch (error) { complain(error); }
}
// What was taken back or done again is seen at its place: an answer of a sheet.
async function place(at) {
  const [code] = at.split(".");
  if (!code || !list.querySelector(`[data-code="${CSS.escape(code)}"]`)) return;
  state.view = "students"; state.code = code;
  await show();
  document.getElementById(at)?.focus();
}
addEventListener("place", event => place(event.detail));
async function all_() { await Promise.all([renew(), showList()]); await show(); }
addEventListener("exam", () => all_().catch(complain));  // an answer, a file or the rules may have been taken back
async function bring(files) {
  list.setAttribute("aria-busy", "true");
  for (const file of files) {
    note(fill(words.reading, { file: file.name }), "", null, 0);
    try {
      const answer = await fetch(`/${exam}/mark/answers?${asked({ name: file.name })}`, { method: "PUT", body: file, headers: { accept: "application/json" } });
      const data = await answer.json();
      if (!answer.ok) throw new Error(data.problems.map(p => [p.message, p.remedy].filter(Boolean).join(": ")).join("; "));
      $("command").textContent = data.command;
    } catch (error) { complain(error); continue; }
    try { await all_(); note(fill(words.brought, { file: file.name })); } catch (error) { complain(error); }  // scans are read now
  }
  list.setAttribute("aria-busy", "false");
}
// What was not read to the end is put away.
async function stop() {
  try {
    const found = await post(`/${exam}/mark/stop?${asked()}`, {});
    $("command").textContent = found.command;
    await all_();
    if (found.files) note(words.stopped, words.take_back, undo);
  } catch (error) { complain(error); }
}
// The pages of scans, one by one, whichever window has brought them.
on("scan", data => {
  if (data.build !== build) return;
  note(fill(words.reading_page, data), "", null, data.done < data.total ? 0 : 2);
  $("toast").append(el("progress", { max: data.total || 1, value: data.done, "aria-label": fill(words.reading_page, data) }));
  if (data.done < data.total) $("toast").append(el("button", { type: "button", id: "stop", onclick: stop }, words.stop));
});
$("bring")?.addEventListener("click", () => $("file").click());
$("file").addEventListener("change", event => { const files = [...event.target.files]; event.target.value = ""; if (files.length) bring(files); });
const carries = event => build && event.dataTransfer?.types.includes("Files");
addEventListener("dragover", event => { if (carries(event)) { event.preventDefault(); page.classList.add("over"); } });
addEventListener("dragleave", event => { if (!event.relatedTarget) page.classList.remove("over"); });
addEventListener("drop", event => { page.classList.remove("over"); if (carries(event)) { event.preventDefault(); bring([...event.dataTransfer.files]); } });
addEventListener("paste", event => { const files = [...event.clipboardData.files]; if (build && !typing(event) && files.length) { event.preventDefault(); bring(files); } });
all(".head [data-view]").forEach(button => button.addEventListener("click", () => see(button.dataset.view)));
$("which")?.addEventListener("change", event => { location.search = new URLSearchParams({ build: event.target.value, lang }); });
$("write")?.addEventListener("click", async event => {
  const button = event.currentTarget;
  button.disabled = true; note(words.writing, "", null, 0);
  leave();
  await Promise.allSettled(saying);
  try { $("command").textContent = (await post(`/${exam}/mark/write?${asked()}`, {})).command; note(words.is_written); await showList(); const results = list.querySelector(".results"); if (results) { results.open = true; results.scrollIntoView(); } } catch (error) { complain(error); }
  button.disabled = false;
});
if (build) {
  try {
    await showList();
    state.code = (list.querySelector(".people[data-of=students] li:not(.sure) a") ?? list.querySelector(".people[data-of=students] a"))?.dataset.code ?? "";
    await (state.view === "questions" ? see("questions") : show());
    await place(decodeURIComponent(location.hash.slice(1)));
  } catch (error) { list.setAttribute("aria-busy", "false"); shown.setAttribute("aria-busy", "false"); complain(error); }
}
