"use strict";
const one = (selector, from = document) => from.querySelector(selector);
const all = (selector, from = document) => [...from.querySelectorAll(selector)];
const made = (tag, properties = {}, ...children) => {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
};

const numberOf = (count, noun) => `${count.toLocaleString("en")} ${noun}${count === 1 ? "" : "s"}`;

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

let index, entries, byId;
const HEAD = ["state", "kind", "origin", "section", "coq", "dimension"], SAID = ["math", "words", "printed", "texts"];
const setFormulas = (from, {math}) => all(".m:not(.set)", from).forEach((place) => {
  place.classList.add("set");
  place.innerHTML = math[place.dataset.m];
});

// The claims of a paper are unfolded when one of them is shown or searched. What is there already is there at once.
const papers = {};
async function paperOf(key) {
  if (papers[key]) return papers[key];
  const part = await unfold(`claims-${key}`);
  if (papers[key]) return papers[key];
  entries.filter((entry) => entry.paper === key).forEach((entry, k) => {
    SAID.forEach((name, n) => { entry[name] = part.said[k][n]; });
    entry.claim = part.claims[k];
    entry.words = part.strings[entry.words];
    entry.text = plain([entry.id, entry.state, entry.error, entry.words, ...entry.texts.map((n) => part.strings[n])].join("\n"));
  });
  return papers[key] = part;
}
const wholePapers = () => Promise.all(index.papers.map((each) => paperOf(each.key)));

// Letters in plain words as they are written: omega_3, I_1 != I_2.
const GREEK = Object.fromEntries([..."alpha α beta β gamma γ delta δ epsilon ε zeta ζ eta η theta θ kappa κ lambda λ mu μ nu ν xi ξ pi π rho ρ sigma σ tau τ phi φ chi χ psi ψ omega ω Delta Δ Omega Ω Gamma Γ Phi Φ Psi Ψ".matchAll(/(\w+) (\S)/g)].map((pair) => [pair[1], pair[2]]));
const REFERENCE = /\b[a-z]+\d{4}:[A-Z]?[\w.]*\w|\((\d+(?:\.\d+)+[a-z]?)\)/g;
const LETTER = new RegExp(`\\b([A-Za-z]{1,8})_(\\w{1,5})\\b|\\b(${Object.keys(GREEK).join("|")})\\b(?! function)|!=|<=|>=|(?<=[=,(] ?)-(?=[\\w(])|\\bsqrt\\((\\w+)\\)|(?<=[\\w)])\\*(?=[\\w(])|\\^(\\d+)`, "g");
const SIGNS = {"!=": "≠", "<=": "≤", ">=": "≥", "*": "·", "-": "−"};
function setProse(from, paper = "") {
  for (const place of all(".prose:not(.set)", from)) {
    place.classList.add("set");
    const walk = document.createTreeWalker(place, NodeFilter.SHOW_TEXT), texts = [];
    while (walk.nextNode()) texts.push(walk.currentNode);
    for (const text of texts) text.replaceWith(...referred(text, paper));
  }
}
// Words in which relations that are named, "(2.12)" or "mirer2009:2.12", lead to them.
function referred({data, parentNode}, paper) {
  const parts = [];
  let end = 0;
  for (const found of parentNode.closest("a") ? [] : data.matchAll(REFERENCE)) {
    const entry = known(found[1] ? `${paper}:${found[1]}` : found[0]);
    if (!entry || `#${entry.id}` === decoded(location.hash)) continue;
    const [start, text] = found[1] ? [found.index + 1, found[1]] : [found.index, found[0]];
    parts.push(...written(data.slice(end, start)), made("a", {href: `#${entry.id}`, textContent: text}));
    end = start + text.length;
  }
  return [...parts, ...written(data.slice(end))];
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

// The ledger: rows are made when it is first seen, filters hide them; a row is filled when it comes near.
const FIELDS = ["paper", "section", "state", "kind", "origin", "coq", "dimension"];
const plain = (text) => text.toLowerCase().replace(/[\s{}\\]/g, "");
const whenNear = (does) => {
  const seen = new IntersectionObserver((all) => all.forEach((each) => {
    if (each.isIntersecting) { seen.unobserve(each.target); does(each.target); }
  }), {rootMargin: "900px"});
  return seen;
};
const filling = whenNear(async (row) => {
  const entry = entries[row.dataset.n];
  fillRow(entry, await paperOf(entry.paper));
});
function fillRow(entry, part) {
  const said = one(".said", entry.row);
  if (said.firstChild) return;
  if (entry.math >= 0) {
    said.append(made("span", {className: "m"}));
    said.firstChild.dataset.m = entry.math;
  }
  if (entry.words) said.append(made("span", {className: entry.math >= 0 ? "words prose" : "prose", textContent: entry.words}));
  setFormulas(said, part);
  setProse(said, entry.paper);
}

// Many rows take their time: whoever looks at the first ones need not wait for the last.
const SLICE = 40; // milliseconds
let ledger = null, kept = new Set();
const makeLedger = () => ledger ??= (async () => {
  const lists = new Map();
  for (const entry of entries) lists.get(entry.paper)?.push(entry) ?? lists.set(entry.paper, [entry]);
  let start = performance.now();
  for (const [paper, members] of lists) {
    const home = made("ol"), section = made("section", {className: "paper"}, made("h2", {textContent: paper}), home);
    section.dataset.paper = paper;
    section.style.containIntrinsicSize = `auto ${4 * members.length}rem`;
    section.hidden = !members.some((entry) => kept.has(entry));
    one("#rows").append(section);
    for (const entry of members) {
      home.append(makeRow(entry, home));
      if (performance.now() - start < SLICE) continue;
      await new Promise((done) => setTimeout(done));
      start = performance.now();
    }
  }
})();
function makeRow(entry, home) {
  const badge = made("span", {className: `badge ${entry.role ? "role" : entry.state}`, textContent: entry.state});
  entry.row = made("li", {hidden: !kept.has(entry)}, made("a", {href: `#${entry.id}`, textContent: partsOf(entry.id).place}), made("div", {className: "said"}),
    made("div", {className: "end"}, badge, entry.kind ? made("div", {textContent: entry.kind}) : ""));
  entry.row.dataset.n = entry.number;
  one("a", entry.row).dataset.paper = entry.paper;
  entry.home = home;
  if (!entry.row.hidden) home.parentElement.hidden = false;
  filling.observe(entry.row);
  return entry.row;
}
function makeFilters() {
  for (const field of FIELDS) {
    for (const value of new Set(entries.map((entry) => entry[field]).filter(Boolean))) {
      one(`#filters [name=${field}]`).append(made("option", {value, textContent: value}));
    }
  }
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
let shown = [], asked = 0;
async function filter() {
  const turn = ++asked, {text = "", ...fields} = chosen();
  one("#rows").ariaBusy = "true";
  if (text.trim()) await Promise.all([wholePapers(), makeLedger()]);
  if (turn !== asked) return;
  const sought = soughtIn(text), fits = new Map();
  for (const entry of entries) {
    if (!Object.entries(fields).every(([name, value]) => entry[name] === value)) continue;
    const how = text.trim() ? fit(entry, sought) : 2;
    if (how !== null) fits.set(entry, how);
  }
  let first = 2;
  for (const how of fits.values()) first = Math.min(first, how);
  const fitting = first < 2 ? [...fits.keys()].filter((entry) => fits.get(entry) === first) : [];
  setBest(fitting.length < fits.size ? fitting : []);
  shown = [...fits.keys()].sort((a, b) => (fits.get(a) > first) - (fits.get(b) > first));
  kept = new Set(shown);
  entries.forEach((entry) => { if (entry.row) entry.row.hidden = !kept.has(entry); });
  all("#rows section").forEach((section) => { section.hidden = !one("li:not([hidden])", section); });
  one("#count").textContent = `${shown.length.toLocaleString("en")} of ${numberOf(entries.length, "item")}`;
  await makeLedger();
  if (turn === asked) one("#rows").ariaBusy = null;
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
async function showClaim(id) {
  const entry = byId.get(id), part = await paperOf(entry.paper);
  if (known(placeOf(location.hash)[0]) !== entry) return false;
  const link = (entry, text) => entry ? made("a", {href: `#${entry.id}`, textContent: text}) : "";
  const query = new URLSearchParams(chosen()).toString();
  const back = made("a", {href: query ? `#ledger?${query}` : "#ledger", textContent: "Ledger"});
  const pager = made("nav", {className: "pager", ariaLabel: "Claims"}, back,
    made("span", {}, link(neighbour(id, -1), "← previous"), link(neighbour(id, 1), "next →")));
  const body = made("div", {innerHTML: entry.claim});
  one("#view-claim").replaceChildren(pager, body);
  const parts = entries.filter((each) => each.whole === entry.whole);
  one(".siblings", body).append(...parts.length < 2 ? [] : ["Parts: ", ...parts.map((each) =>
    made("a", {href: `#${each.id}`, textContent: partsOf(each.id).place, ariaCurrent: each === entry ? "page" : null}))]);
  const {title, published} = index.papers.find((each) => each.key === entry.paper);
  one(".crumbs", body).prepend(title, published ? ` (${published})` : "", " · ");
  all("[data-g]", body).forEach((place) => { place.append(formula(JSON.parse(part.strings[place.dataset.g]))); });
  all("[data-f]", body).forEach((place) => { place.append(formula(JSON.parse(place.dataset.f))); });
  one("#claim-title", body).prepend(id, " ");
  all("[data-h]", body).forEach((place) => { place.innerHTML = part.strings[place.dataset.h]; });
  setFormulas(body, part);
  all("[data-s]", body).forEach((place) => { place.textContent = part.strings[place.dataset.s]; });
  setProse(body, entry.paper);
  setMeanings(body);
  showOwn(entry, body);
  all("details.excerpt", body).forEach((fold) => fold.append(made("pre", {textContent: part.excerpts[fold.dataset.n], tabIndex: 0})));
  all("details.proof", body).forEach((fold, n) => fold.addEventListener("toggle", () => showProof(fold, id, n), {once: true}));
  one("button.download", body)?.addEventListener("click", () => download(id));
  document.title = `${id} · symcheck`;
  return true;
}
// What the words beside a verdict mean.
function setMeanings(body) {
  const words = [...new Set(all(".facts [data-word]", body).map((each) => each.dataset.word))].filter((word) => index.meanings[word]);
  one(".meanings", body)?.append(made("dl", {}, ...words.flatMap((word) => [made("dt", {textContent: word}), made("dd", {textContent: index.meanings[word]})])));
}
// The certificates of a paper, put together again from their fields, with what its rules and theorems say.
async function proofsOf(paper) {
  const {lines, fields, texts, ...words} = await unfold(`proofs-${paper}`);
  const field = (name, value) => name === "definitions" ? value?.map((n) => JSON.parse(texts[n])) : value;
  const proofs = lines.map((line, k) => ({line,
    certificate: Object.fromEntries(Object.entries(fields).map(([name, values]) => [name, field(name, values[k])]).filter(([, value]) => value != null))}));
  return {proofs, words};
}
async function showProof(fold, id, n) {
  const {proofs, words} = await proofsOf(partsOf(id).paper);
  const {line, certificate} = proofs.filter((proof) => proof.certificate.id === id)[n];
  const written = Object.entries(certificate).map(([name, value]) => ` ${JSON.stringify(name)}: ${JSON.stringify(value)}`);
  fold.append(line ? made("pre", {textContent: line, tabIndex: 0}) : proofSteps(certificate, words),
    made("details", {}, made("summary", {textContent: "Certificate as JSON"}), made("pre", {textContent: `{\n${written.join(",\n")}\n}`, tabIndex: 0})));
}
async function download(id) {
  const {paper} = partsOf(id), {proofs} = await proofsOf(paper);
  const own = proofs.filter((proof) => proof.certificate.id === id).map((proof) => proof.certificate);
  const wanted = new Set(own.flatMap((certificate) => (certificate.lemmas ?? []).map(([name]) => name)));
  const lemmas = proofs.map((proof) => proof.certificate).filter((each) => wanted.has(each.id) && !own.includes(each));
  save(`${id.replace(":", "-")}.json`, JSON.stringify({schema: 3, paper, certificates: [...own, ...lemmas]}));
}
function save(name, text, type = "application/json") {
  const url = URL.createObjectURL(new Blob([text], {type}));
  made("a", {href: url, download: name}).click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}

// Where we are: #errata, #ledger?state=refuted, #pictures, #mirer2009:2.12.
const places = {};
let here = "";
const placeOf = (hash) => decoded(hash.slice(1)).split("?");
const known = (id) => byId.get(id) ?? byId.get(`${id}a`);
async function go() {
  places[here] = scrollY;
  const [name, query = ""] = placeOf(location.hash);
  const claim = known(name);
  const view = claim ? "claim" : VIEWS.includes(name) ? name : "errata";
  one("#unknown").hidden = Boolean(claim) || name === "" || name === "main" || VIEWS.includes(name);
  if (!one("#unknown").hidden) tellNearest(name);
  if (view === "ledger") {
    const asked = new URLSearchParams(query);
    all("#filters [name]").forEach((field) => { field.value = asked.get(field.name) ?? ""; });
  }
  if (view === "pictures") await Promise.all([drawGraphs(), document.fonts.load('16px "STIX Two Math"')]);
  if (view === "review") showReview();
  if (claim) { if (!await showClaim(claim.id)) return; } else document.title = "symcheck: audit report";
  all(".view").forEach((each) => { each.hidden = each.id !== `view-${view}`; });
  all(".top nav a").forEach((a) => { a.ariaCurrent = a.hash === `#${view}` ? "page" : null; });
  dispatchEvent(new CustomEvent("view", {detail: view}));
  const filtering = view === "ledger" && filter();
  const moved = here !== "" && here !== location.hash;
  here = location.hash;
  scrollTo(0, claim ? 0 : places[here] ?? 0);
  if (claim && moved) one("#claim-title").focus({preventScroll: true});
  if (filtering) { await filtering; wholePapers(); }
}

function decoded(text) {
  try { return decodeURIComponent(text); } catch { return text; }
}
const VIEWS = ["errata", "ledger", "pictures", "checks", "review"];
const NEAREST = 3;
function tellNearest(name) {
  // Who gives a number alone, "2.12", means it in any of the papers.
  const bare = NUMBER.exec(name)?.[1] ?? name, away = (each) => distance(bare.toLowerCase(), each.toLowerCase());
  const of = (id) => Math.min(away(id), bare.includes(":") || !NUMBER.test(name) ? Infinity : away(partsOf(id).place));
  const known = [...VIEWS.map((each) => [away(each), each]), ...entries.map(({id}) => [of(id), id])];
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
  return known(id);
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

// Arcs: those of a claim stand out when it is pointed at or has the focus, and what it states is told beside it.
async function drawGraphs() {
  const graphs = await unfold("graphs");
  all(".arcs:empty").forEach((place, k) => {
    place.innerHTML = graphs[k];
    ["pointerover", "focusin"].forEach((name) => place.addEventListener(name, light));
    ["pointerleave", "focusout"].forEach((name) => place.addEventListener(name, () => { one("#hint").hidden = true; }));
  });
}
function light(event) {
  const svg = event.currentTarget, node = event.target.closest("a") ?? one("a:focus", svg), number = node?.dataset.n;
  all(".on", svg).forEach((each) => each.classList.remove("on", "used"));
  one("#hint").hidden = true;
  if (number === undefined) return;
  for (const path of all(`path[data-a="${number}"],path[data-b="${number}"]`, svg)) {
    path.classList.add("on", ...path.dataset.b === number ? ["used"] : []);
    for (const end of [path.dataset.a, path.dataset.b]) one(`a[data-n="${end}"]`, svg).classList.add("on");
  }
  tell(node);
}
async function tell(node) {
  const entry = known(placeOf(node.hash ?? node.href.baseVal)[0]), part = await paperOf(entry.paper), hint = one("#hint");
  hint.replaceChildren(made("b", {textContent: `${entry.id} ${entry.state}`}), made("div", {className: "prose", textContent: entry.words}));
  if (entry.math >= 0) one("b", hint).after(made("div", {innerHTML: part.math[entry.math]}));
  setProse(hint, entry.paper);
  const {left, bottom} = node.getBoundingClientRect();
  hint.hidden = false;
  hint.style.left = `${Math.max(8, Math.min(left, innerWidth - hint.offsetWidth - 8))}px`;
  hint.style.top = `${bottom + hint.offsetHeight + 12 > innerHeight ? bottom - 24 - hint.offsetHeight : bottom + 6}px`;
}

(async () => {
  index = await unfold("index");
  entries = index.rows.map(([id, ...numbers], number) => {
    const entry = {id, ...Object.fromEntries(HEAD.map((name, k) => [name, index.names[numbers[k]]]))};
    const {paper, place, whole} = partsOf(id), error = entry.kind && `${entry.kind} error`;
    const names = [id, whole, place, whole.split(":")[1], entry.state, entry.kind, error].map((name) => name.toLowerCase());
    return {...entry, paper, error, names, number, whole, role: index.roles.includes(entry.state)};
  });
  byId = new Map(entries.map((entry) => [entry.id, entry]));
  makeFilters();
  const errata = await unfold("errata");
  const set = (place) => {
    all("[data-t]:empty", place).forEach((each) => { each.innerHTML = errata.tables[each.dataset.t]; });
    setFormulas(place, errata);
    setProse(place, place.dataset.paper);
  };
  const setting = whenNear(set);
  all("#view-errata .fault,#view-errata .alike[open]").forEach((place) => setting.observe(place));
  all("#view-errata .alike").forEach((fold) => fold.addEventListener("toggle", () => set(fold)));
  setProse(one("#view-checks"));
  one("#filters").addEventListener("input", filtered);
  one("#filters").addEventListener("reset", () => setTimeout(filtered));
  one("#filters").addEventListener("submit", (event) => event.preventDefault());
  one("#theme").addEventListener("click", () => theme(1));
  one("#ask").addEventListener("click", () => one("#help").showModal());
  addEventListener("keydown", pressed);
  addEventListener("hashchange", go);
  addEventListener("beforeprint", () => {
    set(one("#view-errata"));
    entries.forEach((entry) => { if (entry.row && papers[entry.paper]) fillRow(entry, papers[entry.paper]); });
  });
  listenForFiles();
  await go();
  document.documentElement.dataset.ready = "yes";
})();
