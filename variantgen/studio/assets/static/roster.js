// Roster: a table brought as a file, dropped or pasted; its columns named by sight; the class list written from it.
import { $, complain, el, exam, fill, head, inTurn, lang, note, own, post, typing, undo, words as common } from "./studio.js";

const page = document.querySelector(".rosters"), words = JSON.parse(page.dataset.words);
const use = $("use"), shown = $("shown");
let tab = 0, seen = {};  // of the table: its key, its name, the version that every request is made on

async function show() {
  const answer = await fetch(`/${exam}/roster/shown?${new URLSearchParams({ lang, tab })}`);
  if (!answer.ok) return;
  const focused = document.activeElement?.id, at = shown.querySelector(".scroll")?.scrollTop ?? 0, left = shown.querySelector(".scroll")?.scrollLeft ?? 0;
  shown.innerHTML = await answer.text();
  shown.setAttribute("aria-busy", "false");
  const scroll = shown.querySelector(".scroll");
  if (scroll) { scroll.scrollTop = at; scroll.scrollLeft = left; }
  if (focused && document.activeElement === document.body) $(focused)?.focus();
  const found = seen = { ...shown.firstElementChild?.dataset };
  if (found.command) $("command").textContent = found.command;
  use.hidden = !("ready" in found);
  use.disabled = found.ready !== "yes" || found.taken === "yes";
  use.textContent = found.taken === "yes" ? fill(words.is_used, { students: found.students }) : found.ready === "yes" ? fill(words.use_these, { students: found.students }) : found.count === "0" ? words.no_students : fill(words.first_answer, { questions: found.asked });
}
// Requests go one after another, each on the version that was seen or that the one before has made of it.
const made = {};
function ask(what, data) {
  const table = seen;
  return inTurn(async () => {
    let version = table.version;
    while (version in made) version = made[version];
    try {
      const found = await post(`/${exam}/roster/${what}?lang=${lang}`, { ...data, version, window: own });
      if (found.version && found.version !== version) { made[version] = found.version; delete made[found.version]; }  // what is set back has an old one
      return found;
    } catch (error) {
      if (error.status === 409) { await show(); both(table); }
      throw error;
    }
  });
}
// Another window has brought another table: one of both is chosen. It stays until that is done.
function both(mine) {
  if (!mine.key || mine.key === seen.key) return;
  // Pasted tables have one name: who stands in them tells them apart.
  const named = own => own.name === seen.name && own.name === mine.name ? `${own.name} (${[own.students, own.first].filter(Boolean).join(": ")}…)` : own.name;
  const end = () => { $("overtaken").hidden = true; };
  $("overtaken").replaceChildren(fill(words.overtaken, { theirs: named(seen), mine: named(mine) }), " ",
    el("button", { type: "button", onclick: () => take(mine.key).then(end, complain) }, common.keep_mine), " ", el("button", { type: "button", onclick: end }, common.take_that));
  $("overtaken").hidden = false;
}
async function take(key) { await ask("take", { table: key }); tab = 0; await show(); }
async function say(data) {
  try { await ask("say", data); await show(); } catch (error) { complain(error); }
}
async function bring(body, name) {
  shown.setAttribute("aria-busy", "true");
  try {
    const answer = await fetch(`/${exam}/roster/table?${new URLSearchParams({ name, lang })}`, { method: "PUT", body, headers: { accept: "application/json" } });
    const data = await answer.json();
    if (!answer.ok) throw new Error(data.problems.map(p => [p.message, p.remedy].filter(Boolean).join(": ")).join("; "));
    tab = 0;
    await show();
    note(words.is_read, words.take_back, () => take(data.before).catch(complain));
  } catch (error) { complain(error); await show(); }
}
addEventListener("exam", () => show());  // the list may have been taken back

shown.addEventListener("change", event => {
  const { column, used } = event.target.dataset;
  if (column !== undefined) say({ tab, column: Number(column), kind: event.target.value });
  if (used !== undefined) { tab = Number(used); say({ tab, used: event.target.checked }); }
});
shown.addEventListener("click", event => {
  const button = event.target.closest("button");
  if (!button) return;
  const { do: what, tab: other, begin, question, answer } = button.dataset;
  if (what === "file") $("file").click();
  if (what === "paste") { $("pasted").value = ""; $("paste").showModal(); }
  if (other !== undefined) { tab = Number(other); show(); }
  if (begin !== undefined) say({ tab, begin: Number(begin) });
  if (question) say({ question, answer });
});
$("file").addEventListener("change", event => { const [file] = event.target.files; event.target.value = ""; if (file) bring(file, file.name); });
$("read").addEventListener("click", () => { const text = $("pasted").value; $("paste").close(); if (text.trim()) bring(text, ""); });
addEventListener("paste", event => {
  if (typing(event) || $("paste").open) return;
  const [file] = event.clipboardData.files, text = event.clipboardData.getData("text/plain");
  if (file && /\.(xlsx|csv|tsv|txt)$/i.test(file.name)) bring(file, file.name); else if (text.trim()) bring(text, ""); else return;
  event.preventDefault();
});
const files = event => event.dataTransfer?.types.includes("Files");
addEventListener("dragover", event => { if (files(event)) { event.preventDefault(); page.classList.add("over"); } });
addEventListener("dragleave", event => { if (!event.relatedTarget) page.classList.remove("over"); });
addEventListener("drop", event => {
  page.classList.remove("over");
  if (!files(event)) return;
  event.preventDefault();
  const [file] = event.dataTransfer.files;
  if (file) bring(file, file.name);
});
use.addEventListener("click", async () => {
  use.disabled = true;
  try {
    const data = await ask("use", {});
    head(data); await show();
    note(words.written, words.take_back, undo);
  } catch (error) { complain(error); await show(); }
});
await show();
