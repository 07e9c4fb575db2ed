// Author: every text is kept a moment after it was typed, then the figure, the statements and what is wrong are shown anew.
import { $, all, complain, edit, el, exam, fill, get, icon, inTurn, lang, note, post } from "./studio.js";

if ($("new")) begin(); else work();

function begin() {
  $("new").elements.other.addEventListener("change", event => { event.target.closest("label").querySelector("input").checked = true; });
  $("new").addEventListener("submit", async event => {
    event.preventDefault();
    const given = new FormData(event.target);
    try { location.search = (await post(`/author/new?lang=${lang}`, { name: given.get("name"), start: given.get(given.get("start") === "other" ? "other" : "start") })).address; } catch (error) { $("refused").textContent = error.message; $("refused").hidden = false; }
  });
}

function work() {
  const page = $("author"), words = JSON.parse(page.dataset.words), base = `/author/${page.dataset.family}`;
  const areas = all("textarea[data-file]"), area = Object.fromEntries(areas.map(one => [one.dataset.file, one])), known = {}, saved = {};
  let seed = 11, mistakes = [], at = -1, last = areas[2], asked = 0;

  // ---- texts: kept one after another on the version that was seen; where another program was faster, both are there
  // until one of them is chosen. Saves go on meanwhile: what they are refused is a draft, which the next window shows.
  const timers = new Map(), conflicts = {};
  const waiting = file => file in saved && (file in conflicts || timers.has(file) || area[file].value !== saved[file]);
  function take(file, text, version) { area[file].value = text; saved[file] = area[file].value; known[file] = version; number(area[file]); }
  async function keep(file) {
    clearTimeout(timers.get(file)); timers.delete(file);
    if (await inTurn(() => kept(file))) await show();
  }
  async function kept(file) {
    const text = area[file].value;
    if (!(file in saved) || text === saved[file] && !(file in conflicts)) return false;
    $("kept").textContent = words.keeping;
    try {
      known[file] = (await post(`${base}/save?lang=${lang}`, { file, text, version: known[file], settles: file in conflicts })).version;
      saved[file] = text; delete conflicts[file]; choices();
      return true;
    } catch (error) {
      if (error.status === 409) try { const now = await get(`${base}/state?lang=${lang}`); both(file, now); } catch (other) { complain(other); }
      else { $("kept").textContent = words.not_kept; complain(error); }
      return false;
    }
  }
  function both(file, now) { conflicts[file] = { text: now.texts[file], version: now.versions[file] }; choices(); }
  function choices() {
    $("kept").textContent = Object.keys(conflicts).length ? words.not_kept : words.kept;
    $("both").hidden = !Object.keys(conflicts).length;
    $("both").replaceChildren(...Object.entries(conflicts).map(([file, theirs]) => el("li", {}, fill(words.both, { file }), " ",
      el("button", { type: "button", onclick: () => { known[file] = theirs.version; keep(file); } }, words.mine), " ",
      el("button", { type: "button", onclick: () => theirs_of(file, theirs) }, words.theirs), el("pre", {}, theirs.text))));
  }
  // The text of the file in place of one's own, which can be put back; that the server writes it ends the draft.
  async function theirs_of(file, { text, version }) {
    const mine = area[file].value;
    area[file].value = text; known[file] = version; saved[file] = null;
    await keep(file);
    note(words.taken, words.take_back, () => { area[file].value = mine; number(area[file]); keep(file); });
  }
  for (const one of areas) {
    one.addEventListener("input", () => { number(one); clearTimeout(timers.get(one.dataset.file)); timers.set(one.dataset.file, setTimeout(() => keep(one.dataset.file), 500)); });
    one.addEventListener("blur", () => keep(one.dataset.file));
    one.addEventListener("scroll", () => { if (gutter(one)) gutter(one).scrollTop = one.scrollTop; });
    if (one.lang) one.addEventListener("focus", () => { last = one; });
  }
  addEventListener("pagehide", () => { for (const one of areas) if (waiting(one.dataset.file)) fetch(`${base}/save`, { method: "POST", keepalive: true, headers: { "content-type": "application/json" }, body: JSON.stringify({ file: one.dataset.file, text: one.value, version: known[one.dataset.file] }) }); });
  // What another program has written is taken where nothing waits to be kept.
  const refresh = () => inTurn(async () => {
    const now = await get(`${base}/state?lang=${lang}`);
    for (const file of Object.keys(area)) if (known[file] !== now.versions[file] && !waiting(file)) take(file, now.texts[file], now.versions[file]);
    return now;
  });
  addEventListener("focus", () => refresh().then(show).catch(() => {}));

  // ---- lines
  const gutter = one => one.previousElementSibling?.tagName === "PRE" ? one.previousElementSibling : null;
  function number(one) {
    const place = gutter(one);
    if (!place) return;
    const bad = new Set(mistakes.filter(each => each.file === one.dataset.file).map(each => each.line));
    place.replaceChildren(...one.value.split("\n").map((_, i) => el("b", { className: bad.has(i + 1) ? "bad" : "" }, String(i + 1))));
    place.scrollTop = one.scrollTop;
  }
  function go({ file, line }) {
    const one = area[file], start = one.value.split("\n").slice(0, line - 1).join("\n").length + (line > 1 ? 1 : 0);
    open(file); one.focus(); one.setSelectionRange(start, start + (one.value.slice(start).split("\n")[0].length));
    if (gutter(one)) one.scrollTop = Math.max(0, (line - 3) * parseFloat(getComputedStyle(one).lineHeight));
  }
  const tabs = all("[role=tab]");
  function open(file) {
    if (!tabs.some(tab => tab.textContent === file)) return;
    for (const tab of tabs) { const on = tab.textContent === file; tab.setAttribute("aria-selected", String(on)); tab.tabIndex = on ? 0 : -1; $(tab.getAttribute("aria-controls")).hidden = !on; }
    number(area[file]);
  }
  for (const tab of tabs) {
    tab.addEventListener("click", () => open(tab.textContent));
    tab.addEventListener("keydown", event => { if (event.code === "ArrowRight" || event.code === "ArrowLeft") { const other = tabs[1 - tabs.indexOf(tab)]; open(other.textContent); other.focus(); } });
  }

  // ---- what the files show
  const listed = texts => texts.map(text => { const made = el("li"); made.innerHTML = text; return made; });
  async function show() {
    const n = ++asked;
    let data;
    try { data = await get(`${base}/look?form=${encodeURIComponent($("form").value)}&seed=${seed}&lang=${lang}`); } catch (error) { return complain(error); }
    if (n !== asked) return;
    mistakes = data.mistakes; at = -1;
    for (const one of areas) number(one);
    $("oops").hidden = !mistakes.length;
    $("oops").replaceChildren(...mistakes.map(one => el("li", {}, el("button", { type: "button", onclick: () => go(one) }, fill(words.line, { file: one.file, number: one.line })), [one.key, one.message].filter(Boolean).join(": "), one.remedy ? ` — ${one.remedy} ` : "", mend(one))));
    $("figure").classList.toggle("old", !data.figure);
    if (data.title) $("title").textContent = data.title;
    if (data.figure) {
      $("figure").innerHTML = data.figure; $("given").innerHTML = data.given.join(", "); $("answers").replaceChildren(...listed(data.answers));
      $("form").replaceChildren(...data.forms.map(name => el("option", { value: name, selected: name === data.form }, name || "—"))); $("forms").hidden = data.forms.length < 2;
      $("names").replaceChildren(...data.names.map(name => el("button", { type: "button", onclick: () => insert(name) }, name)));
    }
    $("variant").textContent = fill(words.variant, { number: seed });
    $("before").disabled = seed === 0;
    for (const place of all("[data-read]")) {
      const code = place.dataset.read, told = data.statements?.[code], own = mistakes.filter(one => one.file === `statement.${code}.j2`), pill = document.querySelector(`[data-state=${code}]`);
      if (told !== undefined) place.innerHTML = told; else if (own.length) place.replaceChildren(...own.map(one => el("p", { className: "error" }, [one.message, one.remedy].filter(Boolean).join("\n"), " ", mend(one))));
      pill.className = `pill ${told !== undefined ? "right" : own.length ? "wrong" : "blank"}`;
      pill.replaceChildren(icon(told !== undefined ? "check" : own.length ? "warn" : "blank"), told !== undefined ? words.complete : own.length ? words.faulty : words.waits);
    }
    page.setAttribute("aria-busy", "false");
  }
  // A name that there is not becomes the nearest one that there is.
  const mend = ({ file, word, nearest }) => nearest ? el("button", { type: "button", onclick: () => {
    const place = area[file], at = place.value.search(new RegExp(`(?<![A-Za-z0-9_])${word.replace(/\W/g, "\\$&")}(?![A-Za-z0-9_])`));
    if (at < 0) return;
    place.setRangeText(nearest, at, at + word.length); keep(file);
  } }, fill(words.change, { word: nearest })) : "";
  // A name of the family goes where the cursor was in a statement.
  function insert(name) {
    last.setRangeText(`{{ ${name} }}`, last.selectionStart, last.selectionEnd, "end");
    last.focus(); last.dispatchEvent(new Event("input"));
  }
  // From a statement to the names and back.
  const name = by => { const all_ = all("button", $("names")), at = all_.indexOf(document.activeElement); all_[(at + by + all_.length) % all_.length]?.focus(); };
  $("names").addEventListener("keydown", event => {
    const by = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.code];
    if (by) name(by); else if (event.code === "Escape") last.focus(); else return;
    event.preventDefault();
  });
  const other = by => { seed = Math.max(0, seed + by); show(); };
  $("before").addEventListener("click", () => other(-1));
  $("after").addEventListener("click", () => other(1));
  $("form").addEventListener("change", show);
  $("solve").addEventListener("click", () => {
    const image = el("img", { src: `${base}/solution/${$("form").value || "-"}/${seed}.svg?lang=${lang}&n=${asked}`, alt: words.solution });
    $("setting").hidden = false; $("setting").textContent = words.setting;
    image.addEventListener("load", () => { $("setting").hidden = true; });
    image.addEventListener("error", async () => { $("setting").textContent = await get(image.getAttribute("src")).then(() => words.setting, error => error.message); });
    $("paper").replaceChildren(image); $("solution").showModal();
  });
  const all_kept = () => Promise.all(Object.keys(area).map(keep));
  $("check").addEventListener("click", async () => {
    $("check").disabled = true; $("report").hidden = false; $("report").replaceChildren(el("h2", {}, words.checking));
    try {
      await all_kept();
      const found = await post(`${base}/check?lang=${lang}`, {}, { again: false });
      const kinds = { true: ["ok", "check"], false: ["no", "warn"], null: ["look", "eye"] };
      $("report").replaceChildren(el("h2", {}, found.ok ? words.well : words.not_well), el("ul", {}, ...found.rows.map(row => el("li", { className: kinds[row.ok][0] }, icon(kinds[row.ok][1]), el("span", {}, row.text)))));
    } catch (error) { $("report").hidden = true; complain(error); }
    $("check").disabled = false;
  });
  $("into")?.addEventListener("click", async () => {
    try { await edit([{ op: "insert", path: "problem", at: 100, value: { family: page.dataset.family, points: 10 } }]); note(words.added); } catch (error) { complain(error); }
  });
  addEventListener("keydown", event => {
    if (event.altKey && (event.code === "PageUp" || event.code === "PageDown")) other(event.code === "PageUp" ? -1 : 1);
    else if (event.ctrlKey && event.code === "Space") name(1);
    else if (event.code === "F8" && mistakes.length) { at = (at + 1) % mistakes.length; go(mistakes[at]); }
    else return;
    event.preventDefault();
  });
  (async () => {
    try {
      const now = await refresh();
      for (const [file, text] of Object.entries(now.drafts)) { area[file].value = text; known[file] = ""; number(area[file]); both(file, now); }
      await show();
    } catch (error) { complain(error); }
  })();
}
