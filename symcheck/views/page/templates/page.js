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
const HEAD = ["id", "state", "kind", "origin", "section", "paper", "coq", "math", "words"];
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
const FIELDS = ["paper", "section", "state", "kind", "origin", "coq"];
const plain = (text) => text.toLowerCase().replace(/[\s{}\\]/g, "");
const near = new IntersectionObserver((seen) => seen.forEach((each) => {
  if (each.isIntersecting) { setFormulas(each.target); setProse(each.target); near.unobserve(each.target); }
}), {rootMargin: "900px"});

function makeLedger() {
  const lists = new Map();
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
    lists.get(entry.paper).append(entry.row);
  }
  for (const field of FIELDS) {
    for (const value of new Set(entries.map((entry) => entry[field]).filter(Boolean))) {
      one(`#filters [name=${field}]`).append(made("option", {value, textContent: value}));
    }
  }
  entries.forEach((entry) => near.observe(entry.row));
}

const chosen = () => Object.fromEntries([...new FormData(one("#filters"))].filter(([, value]) => value));
let shown = [];
function filter() {
  const {text = "", ...fields} = chosen();
  const words = text.trim().split(/\s+/).filter(Boolean).map(plain);
  shown = entries.filter((entry) => Object.entries(fields).every(([name, value]) => entry[name] === value)
    && words.every((word) => entry.text.includes(word)));
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
  const shown = (title, text) => text ? [made("h4", {textContent: title}), made("pre", {textContent: text, tabIndex: 0})] : [];
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
  const [name, query = ""] = decodeURIComponent(location.hash.slice(1)).split("?");
  const claim = byId.get(name) ?? byId.get(`${name}a`);
  const view = claim ? "claim" : one(`#view-${name}`) && name !== "claim" ? name : "errata";
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
    return {...entry, words: data.strings[entry.words], coq: data.strings[entry.coq], number, whole: partsOf(entry.id).whole, role: data.roles.includes(entry.state),
      text: plain([entry.id, data.strings[entry.words], ...row[HEAD.length].map((k) => data.strings[k])].join("\n"))};
  });
  byId = new Map(entries.map((entry) => [entry.id, entry]));
  makeLedger();
  filter();
  setFormulas(one("#view-errata"));
  setProse(one("#view-errata"));
  setProse(one("#view-checks"));
  one("#filters").addEventListener("input", filtered);
  one("#filters").addEventListener("reset", () => setTimeout(filtered));
  one("#filters").addEventListener("submit", (event) => event.preventDefault());
  one("#theme").addEventListener("click", () => theme(1));
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
