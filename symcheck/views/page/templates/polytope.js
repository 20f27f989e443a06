"use strict";
// Momentum envelopes, drawn on a canvas: convex, so that a face is seen if its normal points at the viewer.
(() => {
  const canvas = document.querySelector("#canvas");
  if (!canvas) return;
  const START = {turn: 0.45, tilt: 0.42, zoom: 1}, STEP = 0.12;
  const SUBSCRIPT = "₀₁₂₃₄₅₆₇₈₉";
  const written = (name) => name.replace("_", "").replace(/\d/g, (digit) => SUBSCRIPT[digit]).replace("'", "′");
  const colour = (name) => getComputedStyle(probe[name]).color;
  const probe = Object.fromEntries(["ink", "quiet", "bad", "slip", "edge", "far", "face", "card"].map((name) => {
    const span = document.createElement("i");
    span.style.color = `var(--${name})`;
    canvas.parentElement.append(span);
    return [name, span];
  }));
  let envelopes, shape, view = {...START}, lit = "";

  const sub = (a, b) => a.map((x, k) => x - b[k]);
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  function turned([x, y, z]) {
    const c = Math.cos(view.turn), s = Math.sin(view.turn), ct = Math.cos(view.tilt), st = Math.sin(view.tilt);
    const across = c * y - s * x, deep = c * x + s * y;
    return [across, ct * z - st * deep, ct * deep + st * z]; // right, up, towards the viewer
  }
  const wanted = () => shape.marks.filter((mark) => document.querySelector("#slips").checked || !mark.slip);
  function worst(cell) {
    const found = wanted().filter((mark) => mark.cell === cell);
    return found.length ? (found.some((mark) => !mark.slip) ? "bad" : "slip") : "";
  }

  function draw() {
    if (!shape || !canvas.clientWidth) return;
    const ratio = devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
    canvas.width = width * ratio;
    canvas.height = height * ratio;
    const pen = canvas.getContext("2d");
    pen.scale(ratio, ratio);
    const size = Math.max(...shape.vertices.map((v) => Math.hypot(...v)));
    const scale = Math.min(0.49 * width - 30, 0.58 * height) / size * view.zoom;
    const place = (p) => { const far = 1 / (1 - p[2] / (7 * size)); return [width / 2 + p[0] * scale * far, height / 2 - p[1] * scale * far]; };
    const space = shape.vertices.map(turned), flat = space.map(place);
    const front = shape.faces.map((face) => cross(sub(flat[face[1]], flat[face[0]]).concat(0), sub(flat[face[2]], flat[face[1]]).concat(0))[2] < 0);
    const seenEdges = new Set(), seen = new Set();
    shape.faces.forEach((face, k) => front[k] && face.forEach((v, n) => {
      const next = face[(n + 1) % face.length];
      seen.add(v);
      seenEdges.add(`${Math.min(v, next)},${Math.max(v, next)}`);
    }));
    const line = (a, b, style, thick, dashes = []) => {
      pen.strokeStyle = style; pen.lineWidth = thick; pen.setLineDash(dashes);
      pen.beginPath(); pen.moveTo(...a); pen.lineTo(...b); pen.stroke(); pen.setLineDash([]);
    };
    const fill = (face, style, strength) => {
      pen.globalAlpha = strength; pen.fillStyle = style;
      pen.beginPath(); face.forEach((v, n) => pen[n ? "lineTo" : "moveTo"](...flat[v])); pen.fill(); pen.globalAlpha = 1;
    };
    const light = (face) => { // how much a face looks at the viewer
      const n = cross(sub(space[face[1]], space[face[0]]), sub(space[face[2]], space[face[1]]));
      return Math.abs(n[2]) / Math.hypot(...n);
    };
    const edges = (inFront) => shape.edges.forEach(([a, b], k) => {
      if (seenEdges.has(`${Math.min(a, b)},${Math.max(a, b)}`) !== inFront) return;
      const mark = worst(`e${k}`), on = lit === `e${k}`;
      line(flat[a], flat[b], colour(mark || (inFront ? "edge" : "far")), on ? 6 : mark === "bad" ? 3.5 : mark ? 2.2 : inFront ? 1.5 : 1, inFront ? [] : [4, 4]);
    });
    const reach = [0, 1, 2].map((k) => Math.max(...shape.vertices.map((v) => v[k])) + 0.22 * size);
    pen.font = "italic 14px serif"; pen.textAlign = "center"; pen.textBaseline = "middle";
    edges(false);
    ["X", "Y", "Z"].forEach((name, k) => {
      const end = place(turned([0, 1, 2].map((n) => n === k ? reach[k] : 0)));
      line(place([0, 0, 0]), end, colour("quiet"), 0.8, [1, 3]);
      pen.fillStyle = colour("quiet"); pen.fillText(name, ...end);
    });
    shape.faces.forEach((face, k) => {
      const mark = worst(`f${k}`), on = lit === `f${k}`;
      if (front[k]) fill(face, colour("face"), 0.35 + 0.65 * light(face));
      if (mark || on) fill(face, colour(mark || "bad"), on ? 0.6 : front[k] ? (mark === "bad" ? 0.32 : 0.16) : 0.07);
    });
    edges(true);
    const order = space.map((_, k) => k).sort((a, b) => space[a][2] - space[b][2]);
    for (const k of order) {
      const mark = worst(`v${k}`), on = lit === `v${k}`, inFront = seen.has(k);
      pen.fillStyle = colour(mark || "edge");
      pen.beginPath(); pen.arc(...flat[k], on ? 8 : mark === "bad" ? 5.5 : mark ? 4 : 2.5, 0, 7); pen.fill();
      const away = Math.hypot(flat[k][0] - width / 2, flat[k][1] - height / 2) || 1;
      const at = [0, 1].map((n) => flat[k][n] + 15 * (flat[k][n] - (n ? height : width) / 2) / away);
      pen.font = `${inFront ? 15 : 13}px "STIX Two Math", serif`;
      pen.globalAlpha = 0.8; pen.lineWidth = 4; pen.strokeStyle = colour("card"); pen.strokeText(written(shape.names[k]), ...at);
      pen.globalAlpha = inFront || on || mark ? 1 : 0.7;
      pen.fillStyle = colour(mark || (inFront ? "ink" : "quiet")); pen.fillText(written(shape.names[k]), ...at);
      pen.globalAlpha = 1;
    }
  }

  function cellName(cell) {
    const number = Number(cell.slice(1)), names = (list) => list.map((v) => written(shape.names[v])).join(" ");
    return {v: () => `vertex ${names([number])}`, e: () => `edge ${names(shape.edges[number])}`, f: () => `face ${names(shape.faces[number])}`}[cell[0]]();
  }
  function choose() {
    shape = envelopes[document.querySelector("#envelope").value];
    const found = wanted(), serious = found.filter((mark) => !mark.slip).length;
    const says = `${shape.title}: ${shape.vertices.length} vertices, ${shape.edges.length} edges, ${shape.faces.length} faces; `
      + `${serious} misprints that mislead, ${found.length - serious} slips are marked.`;
    canvas.setAttribute("aria-label", `${says} Arrow keys turn it.`);
    document.querySelector("#envelope-says").textContent = says;
    document.querySelector("#marks").replaceChildren(...found.map((mark) => {
      const item = document.createElement("li"), link = document.createElement("a"), dot = document.createElement("span");
      item.className = mark.slip ? "slip" : "";
      dot.className = "dot";
      link.href = `#${mark.id}`;
      link.textContent = partsOf(mark.id).place;
      item.append(dot, `${cellName(mark.cell)}: ${mark.kind}, `, link);
      for (const name of ["pointerenter", "focusin"]) item.addEventListener(name, () => { lit = mark.cell; draw(); });
      for (const name of ["pointerleave", "focusout"]) item.addEventListener(name, () => { lit = ""; draw(); });
      return item;
    }));
    draw();
  }
  const keys = {
    ArrowLeft: () => { view.turn -= STEP; }, ArrowRight: () => { view.turn += STEP; },
    ArrowUp: () => { view.tilt += STEP; }, ArrowDown: () => { view.tilt -= STEP; },
    "+": () => { view.zoom = Math.min(3, view.zoom * 1.15); }, "-": () => { view.zoom = Math.max(0.5, view.zoom / 1.15); },
    Home: () => { view = {...START}; },
  };
  function press(key) {
    if (!keys[key]) return false;
    keys[key]();
    canvas.dataset.view = [view.turn, view.tilt, view.zoom].map((x) => x.toFixed(2)).join(" ");
    draw();
    return true;
  }
  canvas.addEventListener("keydown", (event) => { if (press(event.key)) event.preventDefault(); });
  document.querySelectorAll(".turn button").forEach((button) => button.addEventListener("click", () => press(button.dataset.key)));
  canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
  canvas.addEventListener("pointermove", (event) => {
    if (!event.buttons) return;
    view.turn -= event.movementX * 0.008;
    view.tilt += event.movementY * 0.008;
    press("");
    canvas.dataset.view = [view.turn, view.tilt, view.zoom].map((x) => x.toFixed(2)).join(" ");
    draw();
  });
  document.querySelector("#envelope").addEventListener("change", choose);
  document.querySelector("#slips").addEventListener("change", choose);
  new ResizeObserver(draw).observe(canvas);
  addEventListener("recolour", draw);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
  document.fonts.load('16px "STIX Two Math"').then(draw);
  unfold("envelopes").then((found) => { envelopes = found; choose(); });
})();
