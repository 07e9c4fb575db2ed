// Build: formats, progress that survives a closed page, what was built, a lost sheet, next year's exam.
import { $, all, complain, edit, el, exam, fill, get, icon, lang, note, on, post } from "./studio.js";

const page = document.querySelector(".builds"), words = JSON.parse(page.dataset.words);
const begin = $("start"), label = begin?.querySelector("span");
const asked = new URLSearchParams({ lang });
const clock = seconds => `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, "0")}`;

// ---- progress
const order = ["drawing", "typesetting", "built"];
function show(state) {
  const phase = state.phase ?? "", ended = ["built", "stopped", "failed", ""].includes(phase);
  $("run").hidden = !phase;
  if (begin) { begin.disabled = !ended; label.textContent = ended ? phase === "stopped" ? words.go_on : words.start : state.rest == null || phase !== "typesetting" ? words.building : fill(words.ready_in, { rest: clock(state.rest) }); }
  if (!phase) return;
  $("done").textContent = phase === "failed" ? words.failed : phase === "stopped" ? words.stopped : state.total ? fill(words.of, { done: state.done, total: state.total }) : "…";
  $("rest").textContent = ended ? state.name ?? "" : [words[phase] ?? "", state.each ? fill(words.each, { each: state.each.toLocaleString(lang) }) : "", state.rest != null ? fill(words.left, { rest: clock(state.rest) }) : ""].filter(Boolean).join(" · ");
  $("bar").max = state.total || 1; $("bar").value = state.done || 0; $("bar").className = phase === "built" ? "full" : "";
  $("stop").hidden = ended;
  $("failed").hidden = phase !== "failed"; $("failed").textContent = state.text ?? "";
  const at = order.indexOf(phase);
  all("[data-phase]").forEach((row, i) => {
    const ok = at > i || phase === "built", now = at === i && !ok;
    row.className = ok ? "ok" : now ? "now" : "";
    row.firstElementChild.replaceWith(icon(ok ? "check" : now ? "clock" : "blank"));
  });
}
on("build", data => {
  if (data.exam !== exam) return;
  show(data);
  if (data.phase === "built") archive();
  if (data.phase === "built" || data.phase === "failed") ended().catch(complain);
});
// The command of the next build, which has another folder than the last one; why it failed, in the language of the page.
async function ended() {
  const now = await get(`/${exam}/progress?${asked}`);
  show(now.state);
  $("command").textContent = now.command;
  if ($("variants")) numbered();
}
const numbered = () => { const command = $("command"); command.textContent = command.textContent.replace(/--variants \S+/, `--variants ${$("variants").value.trim() || "1"}`); };
begin?.addEventListener("click", async () => {
  begin.disabled = true;
  try { show(await post(`/${exam}/start`, { variants: $("variants")?.value ?? "" })); } catch (error) { begin.disabled = false; complain(error); }
});
$("stop").addEventListener("click", () => post(`/${exam}/stop`, {}).catch(complain));

// ---- formats are a key of the exam
page.addEventListener("change", async event => {
  const groups = $("by-groups");
  if (event.target.name !== "format" && event.target !== groups) return;
  const boxes = all("input[name=format]"), chosen = boxes.filter(box => box.checked).map(box => box.value);
  if (!chosen.length) { event.target.checked = true; return note(words.one_format); }
  const files = boxes.filter(box => "grouped" in box.dataset && groups && (groups.checked ? box.checked : event.target === groups));
  const operations = files.map(box => groups.checked ? { op: "set", path: `${box.value}.files`, value: "groups" } : { op: "unset", path: `${box.value}.files` });
  if (event.target !== groups) operations.unshift({ op: "set", path: "formats", value: chosen });
  try { await edit(operations, event.target === groups ? words.by_groups : words.formats); } catch (error) { event.target.checked = !event.target.checked; complain(error); }
});
$("variants")?.addEventListener("input", numbered);

// ---- what was built
async function archive() {
  const answer = await fetch(`/${exam}/archive?${asked}`);
  if (answer.ok) $("archive").innerHTML = await answer.text();
  $("archive").setAttribute("aria-busy", "false");
}
$("archive").addEventListener("click", async event => {
  const button = event.target.closest("[data-do=verify]");
  if (!button) return;
  const row = button.closest("[data-build]"), said = row.querySelector(".said"), verdict = row.querySelector(".verdict");
  button.disabled = true; said.textContent = words.verifying;
  try {
    const found = await post(`/builds/${row.dataset.build}/verify`, {});
    said.textContent = found.right ? fill(words.verified_text, { answers: found.answers }) : found.faults.join("; ");
    verdict.className = `verdict pill ${found.right ? "right" : "wrong"}`;
    verdict.replaceChildren(icon(found.right ? "check" : "warn"), found.right ? words.verified : words.faulty);
  } catch (error) { said.textContent = error.message; }
  button.disabled = false;
});

// ---- afterwards
$("search").addEventListener("submit", async event => {
  event.preventDefault();
  const who = event.currentTarget.who.value.trim(), build = document.querySelector("[data-build]")?.dataset.build;
  if (!who || !build) { $("hit").replaceChildren(el("p", { className: "small" }, words.none)); return; }
  try {
    const found = await get(`/builds/${build}/search?${asked}&who=${encodeURIComponent(who)}`);
    $("hit").replaceChildren(el("div", { className: "hit" }, el("h3", {}, found.name), el("p", { className: "small" }, [found.title, found.day, found.group, fill(words.code, { code: found.code })].filter(Boolean).join(" · ")),
      el("a", { className: "button", href: `/builds/${build}/sheet.pdf?who=${encodeURIComponent(found.code)}`, download: "" }, icon("print"), words.open_sheet)));
  } catch (error) { $("hit").replaceChildren(el("p", { className: "error" }, error.message)); }
});
$("next").addEventListener("submit", async event => {
  event.preventDefault();
  try { location.href = (await post(`/${exam}/next`, { seed: event.currentTarget.seed.value })).address; } catch (error) { complain(error); }
});
$("compare").addEventListener("click", async event => {
  const button = event.currentTarget, said = $("overlap");
  button.disabled = true; said.textContent = words.comparing;
  try { said.textContent = fill(words.overlap, await get(`/${exam}/overlap?${asked}&seed=${encodeURIComponent($("next").seed.value)}`)); } catch (error) { said.textContent = error.message; }
  button.disabled = false;
});
$("rekey").addEventListener("submit", async event => {
  event.preventDefault();
  const build = document.querySelector("[data-build]")?.dataset.build, said = $("rekeyed"), button = event.currentTarget.querySelector("button");
  if (!build) { said.textContent = words.none; return; }
  button.disabled = true; said.textContent = words.key_making;
  try {
    const found = await post(`/builds/${build}/rekey?${asked}`, { tolerance: event.target.tolerance.value });
    said.textContent = words.key_made; $("command").textContent = found.command;
    await archive();
  } catch (error) { said.textContent = error.message; }
  button.disabled = false;
});

show(JSON.parse(page.dataset.running));
await archive();
const now = await get(`/${exam}/progress?${asked}`);
show(now.state);
if (now.mistakes && begin) begin.replaceWith(el("a", { className: "button primary", href: `/${exam}/compose` }, words.mistakes_first, icon("right")));
