// Choose: cards that are filtered, searched, drawn again, starred, put into the exam.
import { $, all, complain, edit, el, exam, fill, get, icon, lang, note, onOutside, post, single, typing, undo } from "./studio.js";

const page = document.querySelector(".choose"), words = JSON.parse(page.dataset.words);
const shelf = $("cards"), filters = $("filters");
let chosen = JSON.parse(page.dataset.chosen), cards = [];
const LAST = 10000;  // behind all problems, also behind one whose edit is under way
const plain = text => text.toLowerCase().replaceAll("ё", "е");

// ---- the exam: which problems have a card
const places = card => chosen.flatMap((problem, i) =>
  problem.families.includes(card.dataset.family) && (!problem.forms.length || problem.forms.includes(card.dataset.form)) ? [i + 1] : []);
function show() {
  for (const card of cards) {
    const at = places(card), button = card.querySelector("[data-do=add]");
    card.classList.toggle("in", at.length > 0);
    card.querySelector(".badge")?.remove();
    if (at.length) card.append(el("span", { className: "badge" }, icon("check"), fill(words.badge, { number: at.join(", ") })));
    if (!button) continue;
    const word = at.length ? words.remove : words.add, name = card.querySelector("h2").textContent;
    button.replaceChildren(...(at.length ? [] : [icon("plus")]), word);
    button.setAttribute("aria-label", `${word}: ${name}`);
  }
  const shown = chosen.map(problem => cards.find(card => problem.families.includes(card.dataset.family) && (!problem.forms.length || problem.forms.includes(card.dataset.form))));
  $("strip").replaceChildren(...shown.slice(0, 6).map((card, i) => el("li", {}, card ? el("img", { src: card.querySelector("img").src, alt: card.querySelector("h2").textContent, width: 74, height: 52 }) : "", el("b", {}, String(i + 1)))));
  const go = $("go");
  go.firstChild.textContent = chosen.length ? fill(words.compose_of, { problems: document.querySelector('[data-under="choose"]').textContent }) : words.start;
  go.setAttribute("aria-disabled", String(!chosen.length));
}
async function toggle(card) {
  const at = places(card), { family, form, forms } = card.dataset;
  try {
    if (at.length) {
      await edit([{ op: "remove", path: `problem[${at.at(-1)}]` }]);
      chosen.splice(at.at(-1) - 1, 1);
      note(fill(words.removed, { number: at.at(-1) }), document.querySelector("#undo .lbl").textContent, undo);
    } else {
      const value = Number(forms) > 1 ? { family, form, points: 10 } : { family, points: 10 };
      await edit([{ op: "insert", path: "problem", at: LAST, value }]);
      chosen.push({ families: [family], forms: value.form ? [form] : [] });
      note(fill(words.added, { number: chosen.length }), document.querySelector("#undo .lbl").textContent, undo);
    }
    show();
  } catch (error) { complain(error); }
}
onOutside(async () => { chosen = (await get(`/${exam}/chosen`)).chosen; show(); });
$("go").addEventListener("click", event => { if (!chosen.length) { event.preventDefault(); filters.q.focus(); } });

// ---- filters
const ticked = name => all(`input[name=${name}]:checked`, filters).map(box => box.value);
function filter() {
  const [topics, kinds, methods, levels, only] = ["topic", "kind", "method", "level", "only"].map(ticked);
  const searched = plain(filters.q.value).split(/\s+/).filter(Boolean);
  let count = 0;
  for (const card of cards) {
    const own = card.dataset, has = (list, text) => !list.length || list.some(one => text.split(" ").includes(one)), every = (list, text) => list.every(one => text.split(" ").includes(one));
    const fits = has(topics, own.topics) && every(kinds, own.kinds) && every(methods, own.methods) && has(levels, own.level)
      && (!only.includes("star") || card.querySelector("[aria-pressed=true]")) && (!only.includes("in") || places(card).length)
      && searched.every(word => own.text.includes(word) || word.length > 5 && own.text.includes(word.slice(0, -2)));
    card.hidden = !fits; count += Boolean(fits);
  }
  const narrowed = topics.length + kinds.length + methods.length + levels.length + only.length + searched.length > 0;
  $("clear").hidden = !narrowed; $("empty").hidden = count > 0 || !cards.length; shelf.hidden = !count && cards.length > 0;
  $("searched").textContent = fill(words.searched, { what: filters.q.value || "…" });
  if (!count && cards.length) suggest(searched);
}
// How many letters have to be changed, added or left out to get from one word to another.
function distance(a, b) {
  let before = Array.from({ length: b.length + 1 }, (_, i) => i);
  for (let i = 1; i <= a.length; i++) {
    const now = [i];
    for (let j = 1; j <= b.length; j++) now.push(Math.min(before[j] + 1, now[j - 1] + 1, before[j - 1] + (a[i - 1] !== b[j - 1])));
    before = now;
  }
  return before.at(-1);
}
// Where nothing fits: the nearest words of the cards, in both languages; for a word that is like none of them the topics.
function suggest(searched) {
  const known = new Set(cards.flatMap(card => card.dataset.text.split(/[^a-zа-я]+/)).filter(word => word.length > 3));
  const strange = searched.find(word => !cards.some(card => card.dataset.text.includes(word))) ?? "";
  const near = [...known].map(word => [distance(strange, word), word]).filter(([far]) => far <= Math.max(1, Math.floor(strange.length / 3))).sort(([a], [b]) => a - b);
  const chip = (word, act) => el("li", {}, el("button", { type: "button", className: "chip", onclick: () => { act(); filter(); filters.q.focus(); } }, word));
  const take = word => () => { filters.q.value = plain(filters.q.value).replace(strange, word); };
  const topic = name => () => { filters.reset(); all(`input[value=${name}]`, filters)[0].checked = true; };
  $("nearest").replaceChildren(...strange && near.length ? near.slice(0, 6).map(([, word]) => chip(word, take(word)))
    : ["linkages", "rolling", "gears", "ropes", "slots", "compound"].map(name => chip(words[name], topic(name))));
}
filters.addEventListener("input", filter);
filters.addEventListener("submit", event => event.preventDefault());
$("clear").addEventListener("click", () => { filters.reset(); filter(); filters.q.focus(); });
$("sort").addEventListener("change", () => {
  const by = { catalogue: () => 0, level: card => Number(card.dataset.level), star: card => card.querySelector("[aria-pressed=true]") ? 0 : 1 }[$("sort").value];
  shelf.append(...[...cards].sort((a, b) => by(a) - by(b)));
});

// ---- one card
function again(card) {
  const image = card.querySelector("img"), link = card.querySelector("a"), next = Math.floor(Math.random() * 9000) + 12;
  image.src = `${card.dataset.figure}/${next}.svg?lang=${lang}&v=${card.dataset.version}`;
  link.href = link.getAttribute("href").replace(/seed=\d+/, `seed=${next}`);
}
async function star(card) {
  const button = card.querySelector("[data-do=star]"), wish = button.getAttribute("aria-pressed") !== "true";
  button.setAttribute("aria-pressed", String(wish));
  try { await post("/stars", { card: card.dataset.card, on: wish }); } catch (error) { complain(error); }
}
async function open(card) {
  const answer = await fetch(card.querySelector("a").href);
  $("example-body").innerHTML = await answer.text();
  $("example").showModal();
}
const doing = { again, star, add: toggle };
shelf.addEventListener("click", event => {
  const card = event.target.closest(".card"), button = event.target.closest("[data-do]");
  if (button) doing[button.dataset.do](card);
  else if (event.target.closest("a") && !event.ctrlKey && !event.metaKey) { event.preventDefault(); open(card); }
});
shelf.addEventListener("keydown", event => {
  const card = event.target.closest(".card");
  if (!card || typing(event) || event.ctrlKey || event.altKey || event.metaKey) return;
  const shown = cards.filter(one => !one.hidden).sort((a, b) => a.compareDocumentPosition(b) & 2 ? 1 : -1), i = shown.indexOf(card);
  const across = Math.max(1, Math.round(shelf.clientWidth / (card.offsetWidth + 16)));
  const step = { ArrowLeft: -1, ArrowRight: 1, ArrowUp: -across, ArrowDown: across }[event.code];
  const act = { KeyR: single() && again, KeyS: single() && star, Space: event.target.tagName === "A" ? toggle : null }[event.code];
  if (step) shown[Math.min(shown.length - 1, Math.max(0, i + step))].querySelector("a")?.focus();
  else if (act) act(card);
  else return;
  event.preventDefault();
});

// ---- the cards themselves come after the page
try {
  const data = await get(`/${exam}/cards?lang=${lang}`);
  shelf.innerHTML = data.html;
  cards = all(".card", shelf);
  $("told").textContent = data.counted;
  all("[data-count]").forEach(place => { place.textContent = data.counts[place.dataset.count] ?? ""; });
  show(); filter();
} catch (error) { complain(error); }
shelf.setAttribute("aria-busy", "false");
