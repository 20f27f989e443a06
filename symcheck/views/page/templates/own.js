// What is the reader's own: verdicts and notes, kept by this browser; the text of a paper and an older ledger, kept by
// this page while it is open. Nothing of it is sent anywhere.
const KEPT = "symcheck review";
const OPINIONS = {"": "none yet", agree: "I agree", disagree: "I do not agree", unclear: "I cannot tell"};
let own = {}, isKept = true;
try { own = JSON.parse(localStorage.getItem(KEPT) ?? "{}"); } catch (error) { isKept = error instanceof SyntaxError; }
function keep(id, opinion, note) {
  if (opinion || note.trim()) own[id] = {opinion, note, audit: byId.get(id)?.state ?? "", date: new Date().toISOString().slice(0, 10)};
  else delete own[id];
  store();
}
function store() {
  try { localStorage.setItem(KEPT, JSON.stringify(own)); isKept = true; } catch { isKept = false; }
  sayKept();
}
const sayKept = () => all(".kept").forEach((place) => {
  place.textContent = isKept ? "Kept by this browser alone." : "This browser keeps nothing of this page: save your notes, under Review, before you close it.";
  place.classList.toggle("notice", !isKept);
});

// Below a claim: where it stands in the text, and what the reader makes of it.
function showOwn(entry, body) {
  const {opinion = "", note = ""} = own[entry.id] ?? {}, {line} = one(".crumbs", body).dataset;
  const choice = made("select", {}, ...Object.entries(OPINIONS).map(([value, textContent]) => made("option", {value, textContent, selected: value === opinion})));
  const text = made("textarea", {value: note, rows: 3, placeholder: " "});
  for (const field of [choice, text]) field.addEventListener("input", () => keep(entry.id, choice.value, text.value));
  const source = sources[entry.paper], {source: file} = index.papers.find((each) => each.key === entry.paper);
  body.append(made("section", {className: "context"}, made("h2", {textContent: "Source text"}),
    ...source ? contextOf(source, Number(line)) : [made("p", {className: "quiet needs-script"}, "Drop the file ", made("code", {textContent: file}), " anywhere on this page, or choose it under ", made("a", {href: "#review", textContent: "Review"}), ": the lines around it are shown here. The file stays with you.")]),
  made("section", {className: "own"}, made("h2", {textContent: "Your verdict"}), made("p", {}, made("label", {}, "Verdict ", choice)),
    made("label", {}, "Notes ", text), made("p", {className: "kept quiet"})));
  sayKept();
}

const sources = {};
const BEFORE = 3, AFTER = 6; // lines of context
function contextOf({name, lines, same}, line) {
  const items = lines.slice(Math.max(0, line - 1 - BEFORE), line + AFTER).map((text, k) => {
    const number = Math.max(1, line - BEFORE) + k;
    return made("li", {value: number, className: number === line ? "here" : "", textContent: text || "\u00a0"});
  });
  return [made("p", {className: same ? "quiet" : "notice", textContent: `${name}: ${SAME[same]}`}), made("ol", {className: "lines", tabIndex: 0}, ...items)];
}
const SAME = {true: "the very text that was audited", false: "not the text that was audited, its digest is another; the lines may have moved", null: "this browser cannot compare its digest with that of the text that was audited"};

async function digestOf(data) {
  if (!globalThis.crypto?.subtle) return null;
  return [...new Uint8Array(await crypto.subtle.digest("SHA-256", data))].map((byte) => byte.toString(16).padStart(2, "0")).join("");
}
// A file is an older ledger, notes that were saved here, or else the text of a paper.
async function take(file) {
  const data = await file.arrayBuffer(), text = new TextDecoder().decode(data);
  let parsed;
  try { parsed = JSON.parse(text); } catch { return takeText(file.name, data, text); }
  if (parsed?.items) return compareWith(file.name, parsed);
  if (!parsed?.review) return say(`${file.name} is neither a ledger (symcheck check --json) nor notes that were saved here.`);
  own = {...own, ...parsed.review};
  store();
  return say(`${numberOf(Object.keys(parsed.review).length, "note")} of ${file.name} added to yours.`);
}
async function takeText(name, data, text) {
  const digest = await digestOf(data), shownPaper = known(placeOf(location.hash)[0])?.paper;
  const found = index.papers.find((each) => digest && each.digest && digest.startsWith(each.digest))
    ?? index.papers.find((each) => each.source === name) ?? index.papers.find((each) => each.key === shownPaper || index.papers.length === 1);
  if (!found) return say(`${name} is the text of none of these papers, by name and by digest. If it is one nevertheless, drop it on a claim of that paper.`);
  const same = digest && found.digest ? digest.startsWith(found.digest) : null;
  sources[found.key] = {name, lines: text.split(/\r?\n/), same};
  return say(`${name} is the text of ${found.key}: ${SAME[same]}. Each claim of it now shows its lines.`);
}
function say(text) {
  one("#taken").textContent = text;
  one("#taken").hidden = false;
  go();
}
function listenForFiles() {
  const takeAll = async (files) => { for (const file of files) await take(file); };
  addEventListener("dragover", (event) => event.preventDefault());
  addEventListener("drop", (event) => { event.preventDefault(); takeAll(event.dataTransfer.files); });
  one("#file").addEventListener("change", (event) => takeAll(event.target.files));
  one("#save-notes").addEventListener("click", () => save("symcheck-review.json", JSON.stringify({review: own}, null, 1)));
  one("#save-letter").addEventListener("click", async () => save("symcheck-review.md", await letter(), "text/markdown"));
}

// What changed since an older ledger: `symcheck check --json`, or generated/expected/PAPER.json.
const FIELDS_OF_TEXT = ["printed", "words", "read", "corrected"];
async function compareWith(name, {items}) {
  await wholePapers();
  const old = new Map(Array.isArray(items) ? items.map((each) => [each.id, each])
    : Object.entries(items).map(([id, [verdict, reading]]) => [id, {id, verdict, reading, role: null}]));
  const compared = new Set([...old.keys()].map((id) => partsOf(id).paper)), changes = [];
  for (const entry of entries.filter((each) => compared.has(each.paper))) {
    const before = old.get(entry.id), texts = new Set(entry.texts.map((n) => papers[entry.paper].strings[n]));
    old.delete(entry.id);
    if (!before) { changes.push([entry.id, "new"]); continue; }
    const was = before.verdict ?? before.role ?? (entry.role ? entry.state : "no verdict");
    if (was !== entry.state) changes.push([entry.id, `${was}, now ${entry.state}`]);
    if ((before.kind ?? entry.kind) !== entry.kind) changes.push([entry.id, `kind: ${before.kind || "none"}, now ${entry.kind || "none"}`]);
    for (const field of FIELDS_OF_TEXT) if (before[field] && !texts.has(before[field])) changes.push([entry.id, `${field} otherwise; before: ${before[field]}`]);
  }
  for (const id of old.keys()) changes.push([id, "gone"]);
  one("#changes").replaceChildren(made("h2", {textContent: `Against ${name}`}), made("p", {textContent: `${changes.length ? numberOf(changes.length, "change") : "No changes"}.`}),
    made("ul", {}, ...changes.map(([id, what]) => made("li", {}, byId.has(id) ? made("a", {href: `#${id}`, textContent: id}) : id, `: ${what}`))));
  location.hash = "#review";
  say(`${name} is compared with this audit; what changed stands under Review.`);
}

function showReview() {
  sayKept();
  const rows = Object.entries(own).map(([id, {opinion, note, audit}]) => made("tr", {}, made("th", {scope: "row"}, byId.has(id) ? made("a", {href: `#${id}`, textContent: id}) : id),
    made("td", {textContent: byId.get(id)?.state ?? `${audit} (not in this audit)`}), made("td", {textContent: OPINIONS[opinion]}), made("td", {textContent: note})));
  const heads = ["relation", "this audit", "you", "notes"].map((textContent) => made("th", {textContent, scope: "col"}));
  one("#notes").replaceChildren(rows.length ? made("div", {className: "scroll", tabIndex: 0, role: "region", ariaLabel: "Your notes"}, made("table", {}, made("thead", {}, made("tr", {}, ...heads)), made("tbody", {}, ...rows)))
    : made("p", {className: "quiet", textContent: "None yet. Below each relation is a place for your verdict and notes."}));
}
// The same as a letter in Markdown: what is printed, what the audit says, what the reader says.
async function letter() {
  const parts = [];
  for (const id of Object.keys(own)) {
    const entry = byId.get(id), {opinion, note, audit} = own[id];
    const part = entry && await paperOf(entry.paper), printed = entry && entry.printed >= 0 ? part.strings[entry.printed] : "";
    parts.push(`## ${id}\n`, printed ? `As printed: $${printed.replace(/\s+/g, " ").trim()}$\n` : entry?.words ? `${entry.words}\n` : "",
      `The audit says: ${[entry?.state ?? audit, entry?.kind].filter(Boolean).join(", ")}. ${opinion ? `${OPINIONS[opinion]}.` : ""}\n`, note ? `${note}\n` : "");
  }
  return ["# Remarks on an audit of printed relations\n", ...parts.filter(Boolean)].join("\n");
}
