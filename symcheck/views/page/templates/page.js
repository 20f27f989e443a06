"use strict";
const one = (selector, from = document) => from.querySelector(selector);
const all = (selector, from = document) => [...from.querySelectorAll(selector)];
const made = (tag, properties = {}, ...children) => {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
};

// The parts of the id of a relation, "mirer2009:2.13.1b": its paper, its place there, and the id without the link.
function partsOf(id) {
  const [paper, place] = id.split(":");
  return {paper, place, whole: id.replace(/[a-z]+$/, "")};
}

// What is folded into this file: deflated JSON, 13 bits in two characters, the lowest first. A single one at the end
// says that the last byte is none.
const DIGITS = new Uint8Array(128);
for (let code = 33, value = 0; code < 127; code++) if (!"<&\\".includes(String.fromCharCode(code))) DIGITS[code] = value++;
function bytesOf(text) {
  const surplus = text.length % 2, bytes = new Uint8Array(Math.floor(13 * (text.length - surplus) / 16) - surplus);
  let bits = 0, count = 0, place = 0;
  for (let k = 0; k + 1 < text.length; k += 2) {
    bits |= (DIGITS[text.charCodeAt(k)] + 91 * DIGITS[text.charCodeAt(k + 1)]) << count;
    for (count += 13; count >= 8; count -= 8, bits >>>= 8) bytes[place++] = bits;
  }
  return bytes;
}
const unfolded = {};
function unfold(name) {
  return unfolded[name] ??= (async () => {
    const stream = new Blob([bytesOf(one(`#folded-${name}`).textContent)]).stream().pipeThrough(new DecompressionStream("deflate"));
    return JSON.parse(await new Response(stream).text());
  })();
}

let data, entries, byId;
const HEAD = ["id", "state", "kind", "origin", "section", "paper", "coq", "dimension", "math", "words"];
const setFormulas = (from) => all(".m:not(.set)", from).forEach((place) => {
  place.classList.add("set");
  place.innerHTML = data.math[place.dataset.m];
});

// Letters in plain words as they are written: omega_3, I_1 != I_2.
const GREEK = Object.fromEntries([..."alpha α beta β gamma γ delta δ epsilon ε zeta ζ eta η theta θ kappa κ lambda λ mu μ nu ν xi ξ pi π rho ρ sigma σ tau τ phi φ chi χ psi ψ omega ω Delta Δ Omega Ω Gamma Γ Phi Φ Psi Ψ".matchAll(/(\w+) (\S)/g)].map((pair) => [pair[1], pair[2]]));
const LETTER = new RegExp(`\\b([A-Za-z]{1,8})_(\\w{1,5})\\b|\\b(${Object.keys(GREEK).join("|")})\\b(?! function)|!=|<=|>=|\\bsqrt\\((\\w+)\\)|(?<=[\\w)])\\*(?=[\\w(])|\\^(\\d+)`, "g");
const SIGNS = {"!=": "≠", "<=": "≤", ">=": "≥", "*": "·"};
function setProse(from) {
  for (const place of all(".prose:not(.set)", from)) {
    place.classList.add("set");
    const walk = document.createTreeWalker(place, NodeFilter.SHOW_TEXT), texts = [];
    while (walk.nextNode()) texts.push(walk.currentNode);
    for (const text of texts) text.replaceWith(...written(text.data));
  }
}
function written(text) {
  const parts = [];
  let end = 0;
  for (const found of text.matchAll(LETTER)) {
    const [all, stem, index, alone, radicand, power] = found;
    parts.push(text.slice(end, found.index));
    if (/^(sin|cos|tan)$/.test(stem)) parts.push(`${stem} `, made("var", {textContent: GREEK[index] ?? index}));
    else if (stem) parts.push(made("var", {textContent: GREEK[stem] ?? stem}), made("sub", {textContent: index.replace("_", ",")}));
    else if (alone) parts.push(made("var", {textContent: GREEK[alone]}));
    else if (power) parts.push(made("sup", {textContent: power}));
    else parts.push(radicand ? `√${radicand}` : SIGNS[all]);
    end = found.index + all.length;
  }
  return [...parts, text.slice(end)];
}

// The ledger: rows are made once, filters hide them; the formulas of a row are set when it comes near.
const FIELDS = ["paper", "section", "state", "kind", "origin", "coq", "dimension"];
const plain = (text) => text.toLowerCase().replace(/[\s{}\\]/g, "");
const near = new IntersectionObserver((seen) => seen.forEach((each) => {
  if (each.isIntersecting) { setFormulas(each.target); setProse(each.target); near.unobserve(each.target); }
}), {rootMargin: "900px"});

function makeLedger() {
  const lists = new Map();
  one("#rows").append(made("section", {id: "best"}, made("h2", {textContent: "Best matches"}), made("ol")));
  for (const entry of entries) {
    if (!lists.has(entry.paper)) {
      const list = made("ol");
      lists.set(entry.paper, list);
      one("#rows").append(made("section", {}, made("h2", {textContent: entry.paper}), list));
    }
    const said = made("div", {className: "said"});
    if (entry.math >= 0) {
      said.append(made("span", {className: "m"}));
      said.firstChild.dataset.m = entry.math;
    }
    if (entry.words) said.append(made("span", {className: entry.math >= 0 ? "words prose" : "prose", textContent: entry.words}));
    const badge = made("span", {className: `badge ${entry.role ? "role" : entry.state}`, textContent: entry.state});
    entry.row = made("li", {}, made("a", {href: `#${entry.id}`, textContent: partsOf(entry.id).place}), said,
      made("div", {className: "end"}, badge, entry.kind ? made("div", {textContent: entry.kind}) : ""));
    entry.home = lists.get(entry.paper);
    entry.home.append(entry.row);
  }
  for (const field of FIELDS) {
    for (const value of new Set(entries.map((entry) => entry[field]).filter(Boolean))) {
      one(`#filters [name=${field}]`).append(made("option", {value, textContent: value}));
    }
  }
  entries.forEach((entry) => near.observe(entry.row));
}

// A number as people write it, "(2.12)", "eq. 2.12", "Eqs. (2.1)", without what is around it.
const NUMBER = /^(?:(?:eqs?|equations?|formulas?|no)\b\.?\s*)?\(?((?:[a-z]+\d{4}:)?[a-z]?\.?\d[\w.]*)\)?$/i;
// How well an entry fits what is sought: 0 it is its number, verdict or kind; 1 it holds it as typed; 2 word by word; else null.
function fit(entry, sought) {
  if (entry.names.includes(sought.name)) return 0;
  if (entry.text.includes(sought.phrase)) return 1;
  return sought.words.every((word) => entry.text.includes(word)) ? 2 : null;
}
function soughtIn(text) {
  const typed = text.trim(), bare = NUMBER.exec(typed)?.[1] ?? typed;
  return {name: bare.toLowerCase(), phrase: plain(bare), words: bare.split(/\s+/).filter(Boolean).map(plain)};
}
// Rows that fit best stand before all papers; those of the last search go home, the last first, each before the next.
let best = [];
function setBest(fitting) {
  for (const entry of [...best].reverse()) {
    const next = entries[entry.number + 1];
    entry.home.insertBefore(entry.row, next?.home === entry.home ? next.row : null);
  }
  best = fitting;
  one("#best ol").append(...best.map((entry) => entry.row));
}

const chosen = () => Object.fromEntries([...new FormData(one("#filters"))].filter(([, value]) => value));
let shown = [];
function filter() {
  const {text = "", ...fields} = chosen();
  const sought = soughtIn(text), fits = new Map();
  for (const entry of entries) {
    if (!Object.entries(fields).every(([name, value]) => entry[name] === value)) continue;
    const how = text.trim() ? fit(entry, sought) : 2;
    if (how !== null) fits.set(entry, how);
  }
  const first = Math.min(...fits.values());
  const fitting = first < 2 ? [...fits.keys()].filter((entry) => fits.get(entry) === first) : [];
  setBest(fitting.length < fits.size ? fitting : []);
  shown = [...fits.keys()].sort((a, b) => (fits.get(a) > first) - (fits.get(b) > first));
  const kept = new Set(shown);
  entries.forEach((entry) => { entry.row.hidden = !kept.has(entry); });
  all("#rows section").forEach((section) => { section.hidden = !one("li:not([hidden])", section); });
  one("#count").textContent = `${shown.length.toLocaleString("en")} of ${entries.length.toLocaleString("en")} items`;
}
function filtered() {
  filter();
  const query = new URLSearchParams(chosen()).toString();
  history.replaceState(null, "", query ? `#ledger?${query}` : "#ledger");
}

// One claim in full.
function neighbour(id, step) {
  const list = shown.some((entry) => entry.id === id) ? shown : entries;
  return list[list.findIndex((entry) => entry.id === id) + step];
}
function showClaim(id) {
  const link = (entry, text) => entry ? made("a", {href: `#${entry.id}`, textContent: text}) : "";
  const query = new URLSearchParams(chosen()).toString();
  const back = made("a", {href: query ? `#ledger?${query}` : "#ledger", textContent: "Ledger"});
  const pager = made("nav", {className: "pager", ariaLabel: "Claims"}, back,
    made("span", {}, link(neighbour(id, -1), "← previous"), link(neighbour(id, 1), "next →")));
  const body = made("div", {innerHTML: data.claims[byId.get(id).number]});
  one("#view-claim").replaceChildren(pager, body);
  const parts = entries.filter((entry) => entry.whole === byId.get(id).whole);
  one(".siblings", body).append(...parts.length < 2 ? [] : ["Parts: ", ...parts.map((entry) =>
    made("a", {href: `#${entry.id}`, textContent: partsOf(entry.id).place, ariaCurrent: entry.id === id ? "page" : null}))]);
  if (byId.get(id).coq) one(".facts", body).append(" ", made("span", {textContent: `confirmed by Coq: ${byId.get(id).coq}`}));
  one("#claim-title", body).prepend(id, " ");
  all("[data-h]", body).forEach((place) => { place.innerHTML = data.strings[place.dataset.h]; });
  setFormulas(body);
  all("[data-s]", body).forEach((place) => { place.textContent = data.strings[place.dataset.s]; });
  setProse(body);
  all("details.excerpt", body).forEach((fold) => fold.append(made("pre", {textContent: data.excerpts[fold.dataset.n], tabIndex: 0})));
  all("details.proof", body).forEach((fold, n) => fold.addEventListener("toggle", () => showProof(fold, id, n), {once: true}));
  one("button.download", body)?.addEventListener("click", () => download(id));
  document.title = `${id} · symcheck`;
}
// The certificates of a paper, put together again from their fields, and what they say: [{steps, certificate}].
async function proofsOf(paper) {
  const {steps, fields, texts} = await unfold(paper);
  const field = (name, value) => name === "definitions" ? value?.map((n) => JSON.parse(texts[n])) : value;
  return steps.map((numbers, k) => ({steps: numbers.map((n) => texts[n]).join("\n"),
    certificate: Object.fromEntries(Object.entries(fields).map(([name, values]) => [name, field(name, values[k])]).filter(([, value]) => value != null))}));
}
async function showProof(fold, id, n) {
  const {steps, certificate} = (await proofsOf(partsOf(id).paper)).filter((proof) => proof.certificate.id === id)[n];
  const shown = (title, text) => text ? [made("h3", {textContent: title}), made("pre", {textContent: text, tabIndex: 0})] : [];
  const lines = Object.entries(certificate).map(([name, value]) => ` ${JSON.stringify(name)}: ${JSON.stringify(value)}`);
  fold.append(...shown("Derivation", steps), ...shown("Certificate", `{\n${lines.join(",\n")}\n}`));
}
async function download(id) {
  const {paper} = partsOf(id), proofs = await proofsOf(paper);
  const own = proofs.filter((proof) => proof.certificate.id === id).map((proof) => proof.certificate);
  const wanted = new Set(own.flatMap((certificate) => (certificate.lemmas ?? []).map(([name]) => name)));
  const lemmas = proofs.map((proof) => proof.certificate).filter((each) => wanted.has(each.id) && !own.includes(each));
  const url = URL.createObjectURL(new Blob([JSON.stringify({schema: 3, paper, certificates: [...own, ...lemmas]})], {type: "application/json"}));
  made("a", {href: url, download: `${id.replace(":", "-")}.json`}).click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}

// Where we are: #errata, #ledger?state=refuted, #pictures, #mirer2009:2.12.
const places = {};
let here = "";
function go() {
  places[here] = scrollY;
  const [name, query = ""] = decoded(location.hash.slice(1)).split("?");
  const claim = byId.get(name) ?? byId.get(`${name}a`);
  const view = claim ? "claim" : VIEWS.includes(name) ? name : "errata";
  one("#unknown").hidden = Boolean(claim) || name === "" || name === "main" || VIEWS.includes(name);
  if (!one("#unknown").hidden) tellNearest(name);
  if (view === "ledger") {
    const asked = new URLSearchParams(query);
    all("#filters [name]").forEach((field) => { field.value = asked.get(field.name) ?? ""; });
    filter();
  }
  if (claim) showClaim(claim.id); else document.title = "symcheck: audit report";
  all(".view").forEach((each) => { each.hidden = each.id !== `view-${view}`; });
  all(".top nav a").forEach((a) => { a.ariaCurrent = a.hash === `#${view}` ? "page" : null; });
  dispatchEvent(new CustomEvent("view", {detail: view}));
  const moved = here !== "" && here !== location.hash;
  here = location.hash;
  scrollTo(0, claim ? 0 : places[here] ?? 0);
  if (claim && moved) one("#claim-title").focus({preventScroll: true});
}

function decoded(text) {
  try { return decodeURIComponent(text); } catch { return text; }
}
const VIEWS = ["errata", "ledger", "pictures", "checks"];
const NEAREST = 3;
function tellNearest(name) {
  const known = [...VIEWS, ...entries.map((entry) => entry.id)].map((each) => [distance(name.toLowerCase(), each.toLowerCase()), each]);
  const near = known.sort((a, b) => a[0] - b[0]).slice(0, NEAREST).flatMap(([, id]) => [made("a", {href: `#${id}`, textContent: id}), " "]);
  one("#unknown").replaceChildren("There is no ", made("code", {textContent: name}), " in this audit; the nearest are ", ...near);
}
// How many letters are to be put in, left out or changed to make one word of the other.
function distance(a, b) {
  let before = Array.from({length: b.length + 1}, (_, k) => k);
  for (let n = 1; n <= a.length; n++) {
    const row = [n];
    for (let k = 1; k <= b.length; k++) row.push(Math.min(before[k] + 1, row[k - 1] + 1, before[k - 1] + (a[n - 1] !== b[k - 1])));
    before = row;
  }
  return before[b.length];
}

// Single keys: from claim to claim, or from row to row of what is shown.
function pressed(event) {
  const typing = event.target.closest("input,select,textarea,dialog");
  if (typing || event.ctrlKey || event.metaKey || event.altKey || !one("#keys").checked) return;
  const does = {"/": search, "?": () => one("#help").showModal(), j: () => move(1), k: () => move(-1),
    n: () => toErratum(1), p: () => toErratum(-1)}[event.key];
  if (!does) return;
  event.preventDefault();
  does();
}
function search() {
  if (one("#view-ledger").hidden) { history.pushState(null, "", "#ledger"); go(); }
  one("#filters [name=text]").focus();
}
// The claim that is shown, or whose link has the focus.
function current() {
  const row = document.activeElement.closest("#rows li,.fault");
  const id = decoded((one("#view-claim").hidden ? row ? one("a", row).hash : "" : location.hash).slice(1));
  return byId.get(id) ?? byId.get(`${id}a`);
}
function move(step) {
  if (!one("#view-claim").hidden) {
    const next = neighbour(current().id, step);
    if (next) location.hash = `#${next.id}`;
    return;
  }
  const links = all(one("#view-ledger").hidden ? ".view:not([hidden]) .fault h3 a" : "#rows li:not([hidden]) > a");
  const place = links.indexOf(document.activeElement);
  links[place < 0 ? 0 : Math.min(Math.max(place + step, 0), links.length - 1)]?.focus();
}
function toErratum(step) {
  const wrong = entries.filter((entry) => entry.kind), number = current()?.number ?? (step > 0 ? -1 : entries.length);
  const next = step > 0 ? wrong.find((entry) => entry.number > number) : wrong.findLast((entry) => entry.number < number);
  if (next) location.hash = `#${next.id}`;
}

// Light, dark, or as the system has it.
function theme(step) {
  const names = ["", "light", "dark"], says = ["as the system has them", "light", "dark"];
  let number = names.indexOf(document.documentElement.style.colorScheme);
  number = (number + step) % 3;
  document.documentElement.style.colorScheme = names[number];
  one("#theme").ariaLabel = `Colours: ${says[number]}`;
  dispatchEvent(new Event("recolour"));
}

// Arcs: those of a claim stand out when it is pointed at or has the focus.
function light(event) {
  const svg = event.currentTarget, number = (event.target.closest("a") ?? one("a:focus", svg))?.dataset.n;
  all(".on", svg).forEach((each) => each.classList.remove("on", "used"));
  if (number === undefined) return;
  for (const path of all(`path[data-a="${number}"],path[data-b="${number}"]`, svg)) {
    path.classList.add("on", ...path.dataset.b === number ? ["used"] : []);
    for (const end of [path.dataset.a, path.dataset.b]) one(`a[data-n="${end}"]`, svg).classList.add("on");
  }
}

(async () => {
  data = await unfold("ledger");
  entries = data.rows.map((row, number) => {
    const entry = Object.fromEntries(HEAD.map((name, k) => [name, row[k]]));
    const {place, whole} = partsOf(entry.id), error = entry.kind && `${entry.kind} error`;
    const names = [entry.id, whole, place, whole.split(":")[1], entry.state, entry.kind, error].map((name) => name.toLowerCase());
    return {...entry, names, words: data.strings[entry.words], coq: data.strings[entry.coq], dimension: data.strings[entry.dimension], number, whole, role: data.roles.includes(entry.state),
      text: plain([entry.id, entry.state, error, data.strings[entry.words], ...row[HEAD.length].map((k) => data.strings[k])].join("\n"))};
  });
  byId = new Map(entries.map((entry) => [entry.id, entry]));
  makeLedger();
  filter();
  all("[data-t]").forEach((place) => { place.innerHTML = data.tables[place.dataset.t]; });
  setFormulas(one("#view-errata"));
  setProse(one("#view-errata"));
  setProse(one("#view-checks"));
  one("#filters").addEventListener("input", filtered);
  one("#filters").addEventListener("reset", () => setTimeout(filtered));
  one("#filters").addEventListener("submit", (event) => event.preventDefault());
  one("#theme").addEventListener("click", () => theme(1));
  one("#ask").addEventListener("click", () => one("#help").showModal());
  addEventListener("keydown", pressed);
  const graphs = await unfold("graphs");
  all(".arcs").forEach((place, k) => {
    place.innerHTML = graphs[k];
    ["pointerover", "focusin"].forEach((name) => place.addEventListener(name, light));
  });
  addEventListener("hashchange", go);
  addEventListener("beforeprint", () => { setFormulas(document); setProse(document); });
  go();
  document.documentElement.dataset.ready = "yes";
})();
