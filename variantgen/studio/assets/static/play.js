// Play: the position by slider, keys or time; another variant, another mechanism; layers; full screen.
import { $, all, complain, fill, get, lang, single, typing } from "./studio.js";
import { Stage } from "./stage.js";

const page = $("play"), words = JSON.parse(page.dataset.words), slider = $("drive"), run = $("run");
const calm = matchMedia("(prefers-reduced-motion: reduce)");
let data, stage, values = [], position = 0, timer = 0;

const written = (value, digits = 4) => value === null || !Number.isFinite(value) ? "—"
  : value.toLocaleString(lang, { minimumSignificantDigits: value ? digits : 1, maximumSignificantDigits: digits, useGrouping: false }).replace("-", "−");
const along = value => data.way.unit === "°" ? `${(Math.round(value) || 0).toLocaleString(lang).replace("-", "−")}°` : `${written(value, 3)} `;
// Positions are counted in the sense of the given motion; the slider goes as the numbers of the way do.
const falling = () => values.at(-1) < values[0];
const number = place => falling() ? values.length - 1 - place : place;

function go(index) {
  position = Math.max(0, Math.min(values.length - 1, Math.round(index)));
  stage.at(position);
  slider.value = number(position);
  const said = `${along(values[position])}${data.way.unit === "°" ? "" : data.way.unit.replace(/<[^>]*>/g, "")}`;
  $("now").innerHTML = `<span class="sy">${data.way.symbol}</span> = ${said}`;
  slider.setAttribute("aria-valuetext", said);
}
// ---- running: the driver goes on evenly; after its end it begins anew.
const nearest = value => { let low = 0, high = values.length - 1; const up = values[high] > values[0]; while (high - low > 1) { const middle = (low + high) >> 1; if (values[middle] <= value === up) low = middle; else high = middle; } return Math.abs(values[low] - value) < Math.abs(values[high] - value) ? low : high; };
const seconds = () => $("speed").value === "real" ? Math.max(0.5, data.way.seconds ?? 8) : Number($("speed").value);
const running = () => timer !== 0;
function stop() { cancelAnimationFrame(timer); clearTimeout(timer); timer = 0; label(); }
function start() {
  const span = values.at(-1) - values[0];
  let share = position >= values.length - 1 ? 0 : (values[position] - values[0]) / span, last = performance.now();
  const step = now => {
    // Who wants little motion sees one position a second.
    share += calm.matches ? 1 / 12 : (now - last) / 1000 / seconds();
    last = now;
    if (share > 1) share = data.way.closed ? share % 1 : share > 1.06 || calm.matches ? 0 : share;
    go(nearest(values[0] + Math.min(share, 1) * span));
    timer = calm.matches ? setTimeout(() => step(performance.now()), 1000) : requestAnimationFrame(step);
  };
  timer = calm.matches ? setTimeout(() => step(performance.now()), 300) : requestAnimationFrame(step);
  label();
}
function label() {
  run.querySelector("span").textContent = running() ? words.stop : words.run;
  run.querySelector("use").setAttribute("href", running() ? "#i-pause" : "#i-play");
}
const toggle = () => running() ? stop() : start();
run.addEventListener("click", toggle);
slider.addEventListener("input", () => { stop(); go(number(Number(slider.value))); });

// ---- a motion
async function load(address, noted = true) {
  stop();
  page.setAttribute("aria-busy", "true");
  try {
    data = await get(`${address}?lang=${lang}`);
    fresh();
    if (noted) history.replaceState(null, "", data.address);
  } catch (error) {
    $("wrong").textContent = error.message; $("wrong").hidden = false;
  }
  page.setAttribute("aria-busy", "false");
}
function fresh() {
  $("wrong").hidden = true; run.disabled = slider.disabled = false;
  values = data.way.values;
  const low = Math.min(values[0], values.at(-1)), high = Math.max(values[0], values.at(-1)), span = high - low || 1;
  stage = new Stage($("scene"), data);
  $("curves").replaceChildren(...data.curves.map(one => stage.curve(one, values.map(value => 1000 * (value - low) / span), written)));
  $("plans").replaceChildren(...["velocities", "accelerations"].filter(kind => data[kind].vectors.length).map(kind => stage.plan(kind, words[`plan_${kind}`], words[`plan_${kind}`])));
  $("title").textContent = data.title; $("label").textContent = data.label; $("command").textContent = data.command;
  $("constant").innerHTML = data.constant.length ? `${words.constant} ${data.constant.join(", ")}` : "";
  $("why").textContent = data.way.why;
  const ends = falling() ? [...data.way.ends].reverse() : data.way.ends;
  ["end-left", "end-right"].forEach((name, i) => { $(name).hidden = !ends[i]; $(name).title = data.way.why; });
  slider.max = values.length - 1;
  $("ticks").replaceChildren(...[0, 0.25, 0.5, 0.75, 1].map(share => { const mark = document.createElement("span"); mark.textContent = along(values[number(Math.round(share * (values.length - 1)))]); return mark; }));
  $("speed").querySelector("[value=real]").textContent = data.way.seconds ? fill(words.real_seconds, { seconds: written(data.way.seconds, 2) }) : words.real;
  $("speed").querySelector("[value=real]").disabled = !data.way.seconds;
  for (const [name, id] of [["before", "before"], ["after", "after"]]) $(id).disabled = !data[name];
  all("[data-layer]").forEach(button => { button.disabled = !stage.layers[button.dataset.layer]?.length; stage.show(button.dataset.layer, button.getAttribute("aria-pressed") === "true"); });
  document.title = [data.title, words.title, "variantgen"].join(" · ");
  go(data.way.instant);
}
const other = name => { if (data?.[name]) load(data[name]); };
$("before").addEventListener("click", () => other("before"));
$("after").addEventListener("click", () => other("after"));

// ---- layers, full screen, other mechanisms
function layer(button) {
  if (!button || button.disabled) return;
  const yes = button.getAttribute("aria-pressed") !== "true";
  button.setAttribute("aria-pressed", String(yes));
  stage.show(button.dataset.layer, yes);
  stage.at(position);
}
all("[data-layer]").forEach(button => button.addEventListener("click", () => layer(button)));
const full = () => document.fullscreenElement ? document.exitFullscreen() : page.requestFullscreen?.().catch(complain);
$("full").addEventListener("click", full);
$("other").addEventListener("click", async () => {
  $("mechanisms").showModal();
  if ($("list").children.length) return;
  try {
    const answer = await fetch(`${location.pathname}/mechanisms?lang=${lang}`);
    $("list").innerHTML = await answer.text();
    filter();
  } catch (error) { complain(error); }
});
$("search").addEventListener("input", filter);
function filter() {
  const searched = $("search").value.toLowerCase().replaceAll("ё", "е").split(/\s+/).filter(Boolean);
  for (const tile of all(".tiles li")) tile.hidden = !searched.every(word => tile.dataset.text.includes(word));
}

// ---- keys
addEventListener("keydown", event => {
  if (!data || $("mechanisms").open || $("keys").open || event.ctrlKey || event.metaKey || event.defaultPrevented) return;
  const { code, target } = event, far = event.shiftKey ? 10 : 1;
  if (event.altKey) {
    if (code === "PageUp") other("before"); else if (code === "PageDown") other("after"); else return;
  } else if (typing(event) && target !== slider) return;
  else if (code === "Space" && (target === slider || !target.closest("button, a, summary, select"))) toggle();
  else if (code === "ArrowRight" || code === "ArrowLeft") { stop(); go(position + (code === "ArrowRight" === !falling() ? far : -far)); }
  else if (code === "Home" || code === "End") { stop(); go(number(code === "Home" ? 0 : values.length - 1)); }
  else if (/^Digit[1-4]$/.test(code) && !event.shiftKey && single()) layer(all("[data-layer]")[Number(code.at(-1)) - 1]);
  else if (code === "KeyF" && single()) full();
  else return;
  event.preventDefault();
});
run.disabled = slider.disabled = true;
load(page.dataset.motion, false);
