// Terms and formulas of certificates as MathML. They are written as in symcheck/core/terms.py: ["+", "x", ["^", "y", 2]].
const LEVEL = {"<=>": 0, "=>": 1, or: 2, and: 3, exists: 4, forall: 0, "+": 6, "-": 6, "*": 7, "/": 9, "^": 9};
const JOINED = {and: ",\u2002", or: "\u2002or\u2002", "=>": "⟹", "<=>": "⟺", "=": "=", "!=": "≠", "<": "<", "<=": "≤", ">": ">", ">=": "≥"};
const ACCENTS = {bar: "¯", tilde: "~", hat: "^", dot: "˙"};
const escaped = (text) => String(text).replace(/[&<>]/g, (sign) => `&#${sign.charCodeAt(0)};`);
const mo = (sign) => `<mo>${escaped(sign)}</mo>`;
const infix = (sign) => `<mo form="infix" lspace="0.25em" rspace="0.25em">${escaped(sign)}</mo>`;
const mrow = (...parts) => `<mrow>${parts.join("")}</mrow>`;
const fenced = (text) => mrow(mo("("), text, mo(")"));

// A letter as it is printed: "omega_3", "Kbar_12", "dtheta" for a rate.
function letterMath(name, raised = "") {
  const [stem, ...indices] = name.split("_");
  const index = mrow(indices.map((each) => `<mi>${escaped(GREEK[each] ?? each)}</mi>`).join(mo(",")));
  if (!indices.length) return raised ? `<msup>${stemMath(stem)}${raised}</msup>` : stemMath(stem);
  return raised ? `<msubsup>${stemMath(stem)}${index}${raised}</msubsup>` : `<msub>${stemMath(stem)}${index}</msub>`;
}
function stemMath(stem) {
  const plain = (text) => `<mi>${escaped(GREEK[text] ?? text.replace(/^var/, ""))}</mi>`;
  const accented = /^(.+)(bar|tilde|hat)$/.exec(stem);
  const rate = /^d(.+)$/.exec(stem), varied = /^var(.+)$/.exec(stem);
  if (accented) return `<mover accent="true">${stemMath(accented[1])}${mo(ACCENTS[accented[2]])}</mover>`;
  if (varied && GREEK[varied[1]]) return plain(varied[1]);
  if (rate && (GREEK[rate[1]] || rate[1].length === 1)) return `<mover accent="true">${plain(rate[1])}${mo(ACCENTS.dot)}</mover>`;
  return plain(stem);
}

const negative = (term) => typeof term === "number" ? term < 0 : term[0] === "-" || (["*", "/"].includes(term[0]) && negative(term[1]));
function opposite(term) {
  if (typeof term === "number") return -term;
  if (term[0] === "-") return term[1];
  const first = opposite(term[1]);
  return first === 1 && term[0] === "*" && term.length > 2 ? term.length > 3 ? ["*", ...term.slice(2)] : term[2] : [term[0], first, ...term.slice(2)];
}
// `outer` is the level of what stands around: at a higher one than its own a term needs brackets.
function termMath(term, outer = 0) {
  if (typeof term === "number") return term < 0 ? wrapped(mo("−") + termMath(-term), 6, outer) : `<mn>${term}</mn>`;
  if (typeof term === "string") return letterMath(term);
  const [head, ...parts] = term;
  if (!parts.length) return {"+": "<mn>0</mn>", "*": "<mn>1</mn>", and: "<mtext>true</mtext>", or: "<mtext>false</mtext>",
    pi: "<mi>π</mi>", infinity: "<mi>∞</mi>", "-infinity": `${mo("−")}<mi>∞</mi>`}[head] ?? `<mi>${escaped(head)}</mi>`;
  const made = SHAPES[head];
  if (made) return made(parts, outer);
  return applied(`<mi>${escaped(head)}</mi>`, parts);
}
// A function at its arguments, always in brackets: "sin a b" might be either.
const applied = (name, parts) => mrow(name, mo("\u2061"), fenced(parts.map((part) => termMath(part)).join(mo(","))));
const wrapped = (text, level, outer) => level < outer ? fenced(text) : mrow(text);
const under = (sign, below, above = "") => `<munderover>${mo(sign)}${mrow(below)}${mrow(above)}</munderover>`;
const summed = (sign) => ([term, letter, low, high], outer) =>
  wrapped(under(sign, letterMath(letter) + mo("=") + termMath(low), termMath(high)) + termMath(term, 7), 6, outer);
const relation = (head) => ([left, right]) => mrow(termMath(left, 5), infix(JOINED[head]), termMath(right, 5));
const between = (head) => /\u2002/.test(JOINED[head]) ? `<mtext>${JOINED[head]}</mtext>` : infix(JOINED[head]);
const joined = (head) => (parts, outer) => wrapped(parts.map((part) => termMath(part, LEVEL[head] + 1)).join(between(head)), LEVEL[head], outer);
// A formula in pieces between which a line may break.
function pieces(term) {
  const [head, ...parts] = Array.isArray(term) ? term : [];
  if (head === "+" && parts.length) return parts.map((part, n) => addend(part, n).join(""));
  if (!JOINED[head] || parts.length < 2) return [termMath(term)];
  if (head === "and" && parts.length === 2 && parts.every((part) => part[0] === "<=") && JSON.stringify(parts[0][2]) === JSON.stringify(parts[1][1]))
    return [termMath(parts[0][1], 5) + infix("≤"), termMath(parts[0][2], 5) + infix("≤"), termMath(parts[1][2], 5)];
  const level = LEVEL[head] ?? 5, found = [];
  parts.forEach((part, n) => {
    if (n > 0) found.push(found.pop() + between(head));
    found.push(...(LEVEL[part[0]] ?? 10) > level ? pieces(part) : [termMath(part, level + 1)]);
  });
  return found;
}
const quantified = (sign) => ([letters, formula], outer) => wrapped(mo(sign) + letters.map(letterMath).join(mo(",")) + mo(":") + termMath(formula, 4), 0, outer);
function times(parts, outer) {
  if (negative(parts[0]) && parts[0] !== -1) return wrapped(mo("−") + termMath(opposite(["*", ...parts]), 7), 6, outer);
  if (parts[0] === -1 && parts.length > 1) return wrapped(mo("−") + termMath(parts.length > 2 ? ["*", ...parts.slice(1)] : parts[1], 7), 6, outer);
  const digit = (part) => typeof part === "number" || (part[0] === "^" && typeof part[1] === "number") || part[0] === "/";
  return wrapped(parts.map((part, n) => (n > 0 ? digit(part) ? mo("·") : mo("\u2062") : "") + termMath(part, n > 0 ? 8 : 7)).join(""), 7, outer);
}
const plus = (parts, outer) => wrapped(parts.map((part, n) => mrow(...addend(part, n))).join(""), 6, outer);
const addend = (part, n) => negative(part) ? [n > 0 ? infix("−") : mo("−"), termMath(opposite(part), 7)] : [n > 0 ? infix("+") : "", termMath(part, n > 0 ? 7 : 6)];
function power(base, exponent) {
  const raised = mrow(termMath(exponent)), [head, ...parts] = Array.isArray(base) ? base : [];
  if (typeof base === "string") return letterMath(base, raised);
  if (parts.length && !SHAPES[head] && exponent > 0) return applied(`<msup><mi>${escaped(head)}</mi>${raised}</msup>`, parts);
  return `<msup>${parts.length && !SHAPES[head] ? fenced(termMath(base)) : mrow(termMath(base, 10))}${raised}</msup>`;
}
// A fraction with a high power of ten below, as numbers are enclosed.
function decimal(top, bottom) {
  const digits = String(bottom).length - 1;
  if (!Number.isSafeInteger(top) || top < 0 || digits < 6 || bottom !== 10 ** digits) return "";
  const text = String(top).padStart(digits + 1, "0");
  return `<mn>${text.slice(0, -digits)}.${text.slice(-digits)}</mn>`;
}
const SHAPES = {
  "+": plus, "*": times,
  "-": ([part], outer) => wrapped(mo("−") + termMath(part, 7), 6, outer),
  "/": ([top, bottom], outer) => negative(top) ? wrapped(mo("−") + termMath(["/", opposite(top), bottom]), 6, outer) : decimal(top, bottom) || wrapped(`<mfrac>${mrow(termMath(top))}${mrow(termMath(bottom))}</mfrac>`, 9, outer),
  "^": ([base, exponent], outer) => wrapped(power(base, exponent), 9, outer),
  pow: ([base, exponent], outer) => wrapped(power(base, exponent), 9, outer),
  sqrt: ([part]) => `<msqrt>${termMath(part)}</msqrt>`,
  exp: ([part], outer) => wrapped(`<msup><mi>e</mi>${mrow(termMath(part))}</msup>`, 9, outer),
  call: ([name, orders, ...parts]) => mrow(orders.some(Boolean) ? `<msup>${letterMath(name)}${mrow(mo("("), orders.map((n) => `<mn>${n}</mn>`).join(mo(",")), mo(")"))}</msup>` : letterMath(name), fenced(parts.map((part) => termMath(part)).join(mo(",")))),
  mean: ([part, letter]) => `<msub>${mrow(mo("⟨"), termMath(part), mo("⟩"))}${letterMath(letter)}</msub>`,
  integral: ([part, letter, low, high], outer) => wrapped(`<msubsup>${mo("∫")}${mrow(termMath(low))}${mrow(termMath(high))}</msubsup>${termMath(part, 7)}<mspace width="0.17em"/>${mo("d")}${letterMath(letter)}`, 6, outer),
  diverges: (parts) => mrow("<mtext>[1 if this diverges, else 0:\u2002</mtext>", SHAPES.integral(parts, 0), "<mtext>]</mtext>"),
  sum: summed("∑"), product: summed("∏"),
  diff: ([part, letter, order, at], outer) => {
    const raised = (text) => order === 1 ? text : `<msup>${text}<mn>${order}</mn></msup>`;
    const taken = `<mfrac>${mrow(raised(mo("d")))}${mrow(mo("d"), raised(letterMath(letter)))}</mfrac>${termMath(part, 8)}`;
    return wrapped(at === letter ? taken : `<msub>${mrow(taken, mo("|"))}${mrow(letterMath(letter), mo("="), termMath(at))}</msub>`, 7, outer);
  },
  and: joined("and"), or: joined("or"), "=>": joined("=>"), "<=>": joined("<=>"), exists: quantified("∃"), forall: quantified("∀"),
  ...Object.fromEntries(["=", "!=", "<", "<=", ">", ">="].map((head) => [head, relation(head)])),
};

// A polynomial as a certificate writes it, "-2*a_12^2*I_1 + 1/2", as a term; null where it is written otherwise.
function polynomial(text) {
  const signs = text.match(/[A-Za-z_]\w*|\d+|[-+*/^()]/g) ?? [];
  if (signs.join("") !== text.replace(/\s/g, "")) return null;
  let place = 0;
  const taken = (...wanted) => wanted.includes(signs[place]) ? signs[place++] : null;
  function sum() {
    const parts = [taken("-") ? negated(product()) : product()];
    for (let sign; (sign = taken("+", "-"));) parts.push(sign === "-" ? negated(product()) : product());
    return parts.length > 1 ? ["+", ...parts] : parts[0];
  }
  const negated = (term) => typeof term === "number" ? -term : ["-", term];
  function product() {
    const parts = [raised()];
    for (let sign; (sign = taken("*", "/"));) sign === "*" ? parts.push(raised()) : parts.push(["/", parts.pop(), raised()]);
    return parts.length > 1 ? ["*", ...parts] : parts[0];
  }
  function raised() {
    const base = taken("(") ? closed(sum()) : atom();
    return taken("^") ? ["^", base, atom()] : base;
  }
  function closed(term) { if (!taken(")")) throw new SyntaxError(text); return term; }
  function atom() {
    const sign = signs[place++];
    if (!sign || !/\w/.test(sign)) throw new SyntaxError(text);
    return /^\d/.test(sign) ? Number(sign) : sign;
  }
  try {
    const term = sum();
    return place === signs.length ? term : null;
  } catch { return null; }
}

const LARGEST = 50_000; // signs of a formula that is still set: beyond, it would not be read, and takes long
function formula(term) {
  const text = JSON.stringify(term);
  if (text.length > LARGEST) return made("code", {textContent: text.slice(0, 200) + "…"});
  const place = made("span", {className: "formula"});
  place.innerHTML = `<math>${pieces(term).map((piece) => mrow(piece)).join("")}</math>`;
  return place;
}
function multiplier(text) {
  const term = typeof text === "string" ? polynomial(text) : text;
  return term === null ? made("code", {textContent: text}) : formula(term);
}

// A proof step by step; each hypothesis that is used stands with its formula beside what it is multiplied with.
function proofSteps(certificate, words) {
  const place = made("div", {className: "steps"});
  const line = (label, ...what) => made("p", {}, made("span", {className: "quiet", textContent: `${label} `}), ...what);
  const {point} = certificate;
  place.append(line(point ? "It is shown that this fails:" : "It is shown that", formula(certificate.claim)));
  for (const [name, meant] of certificate.definitions ?? []) place.append(line("where", formula(["=", name, meant])));
  for (const [id, meant] of certificate.lemmas ?? []) place.append(line("given the relation", made("a", {href: `#${id}`, textContent: id}), " ", formula(meant)));
  for (const each of certificate.nonzero ?? []) place.append(line("wherever", formula(["!=", each, 0])));
  if (point) place.append(line("at", ...Object.entries(point.values).flatMap(([name, value]) => [formula(["=", name, value]), " \u2003"])));
  for (const each of point?.shown ?? []) place.append(line("and there", formula(each)));
  if (point?.proof) place.append(stepOf(point.proof, certificate, words));
  if (certificate.proof) place.append(stepOf(certificate.proof, certificate, words));
  return place;
}
// What a reference of a proof means: in words, and as a formula where it has one that stands in the certificate.
function factOf([kind, name, number], certificate, words) {
  switch (kind) {
    case "hyp": return {formula: certificate.hypotheses?.[name]?.[number], words: words.hypotheses[name] || name};
    case "here": return {words: `assumption ${name + 1} of this proof`};
    case "nonzero": return {formula: ["!=", certificate.nonzero[name], 0], words: "a denominator"};
    case "positive": return {formula: [">", name, 0], words: "known to be positive"};
    case "point": return {words: `value ${name + 1} at the point`};
    default: return {words: JSON.stringify([kind, name, number])};
  }
}
const shownFact = (fact) => fact.formula ? formula(fact.formula) : made("span", {className: "quiet", textContent: fact.words});
const BRANCHES = {premises: "premise", proof: "proof", parts: "part", cases: "case", then: "then"};
const DETAILS = {form: "the form", formula: "", atoms: "where", numbers: "where", point: "with", letters: "with the new letters",
  or: "of", index: "alternative", times: "multiplied with", positive: "denominators of one sign", values: "from"};
function stepOf(step, certificate, words) {
  const place = made("div", {className: "step"}), {rule} = step;
  const said = rule === "theorem" ? `theorem ${step.of.replaceAll("_", " ")}: ${words.theorems[step.of]}` : rule === "have" ? "first:" : `${rule}: ${words.rules[rule]}`;
  const head = made("p", {className: "rule"}, said);
  if (rule === "have") head.append(" ", formula(step.formula));
  place.append(head);
  if (rule === "theorem") for (const [name, value] of Object.entries(step.with ?? {})) place.append(detail("applied with", name, value));
  if (step.cofactors?.length) {
    const rows = [];
    let said = "";
    for (const [reference, ...factors] of step.cofactors) {
      const fact = factOf(reference, certificate, words);
      if (fact.formula && fact.words !== said) rows.push(made("tr", {}, made("th", {colSpan: 2, scope: "rowgroup", className: "quiet", textContent: said = fact.words})));
      rows.push(made("tr", {}, made("td", {}, ...factors.flatMap((each, n) => n ? [" · ", multiplier(each)] : [multiplier(each)])), made("td", {}, shownFact(fact))));
    }
    const heads = ["multiplier", "of the left side less the right side of"].map((textContent) => made("th", {textContent, scope: "col"}));
    place.append(made("div", {className: "scroll", tabIndex: 0, role: "region", ariaLabel: "Multipliers"}, made("table", {className: "multipliers"}, made("thead", {}, made("tr", {}, ...heads)), made("tbody", {}, ...rows))));
  }
  for (const [key, value] of Object.entries(step)) if (DETAILS[key] !== undefined && key !== "formula") place.append(...detailsOf(key, value, certificate, words));
  for (const [key, label] of Object.entries(BRANCHES)) {
    const one = !Array.isArray(step[key]), branches = one ? [step[key]].filter(Boolean) : step[key];
    branches.forEach((branch, n) => {
      const inner = stepOf(branch, certificate, words);
      if (key === "then" && ["theorem", "have"].includes(rule)) place.append(inner);
      else place.append(made("details", {open: true, className: "branch"}, made("summary", {textContent: one ? label : `${label} ${n + 1}`}), inner));
    });
  }
  return place;
}
function detail(label, name, value) {
  const meant = value && !Array.isArray(value) && typeof value === "object" ? value.term : value;
  return made("p", {}, made("span", {className: "quiet", textContent: `${label} `}), formula(["=", name, meant]));
}
function detailsOf(key, value, certificate, words) {
  const line = (...what) => what.length ? [made("p", {}, made("span", {className: "quiet", textContent: `${DETAILS[key]} `}), ...what.flatMap((each, n) => n ? [", ", each] : [each]))] : [];
  const fact = (reference) => shownFact(factOf(reference, certificate, words));
  if (key === "form") return value === 1 ? [] : line(formula(value));
  if (key === "index") return line(String(value + 1));
  if (key === "letters") return line(...value.map((each) => formula(each)));
  if (key === "or") return line(fact(value));
  if (key === "values") return line(...value.map(fact));
  if (key === "positive") return line(...value.map((each) => formula(each)));
  if (key === "times") return line(...value.map((each) => typeof each === "string" ? multiplier(each) : fact(each)));
  return line(...Object.entries(value).filter(([name, meant]) => name !== meant).map(([name, meant]) => formula(["=", name, meant])));
}
