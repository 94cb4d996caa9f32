// Plots over tables: each is a figure with its numbers in a table behind it.

/**
 * points: [{ x, y, error, low, high, series, name }]. error: of y, a bar or a band; low, high: range of the values.
 * options: x, y: labels; dots: no lines; log: of y; zero: y begins at 0.
 */
function chart(title, points, options) {
  const drawn = points.filter((p) => Number.isFinite(p.x) && Number.isFinite(p.y) && (!options.log || p.y > 0));
  if (drawn.length === 0) return make("p", { class: "hint" }, `${title}: no values.`);
  const several = new Set(drawn.map((p) => p.series)).size > 1;
  const wrong = drawn.filter((p) => p.error > 0), ranged = drawn.filter((p) => Number.isFinite(p.low));
  const P = libraries, colour = (p) => p.series, marks = [P.ruleY(options.zero ? [0] : [])];
  const bounds = { x: "x", y1: (p) => p.y - p.error, y2: (p) => p.y + p.error };
  if (ranged.length > 0) marks.push(P.areaY(ranged, { x: "x", y1: "low", y2: "high", fill: colour, fillOpacity: 0.12 }));
  if (options.dots) {
    marks.push(P.ruleX(wrong, { ...bounds, stroke: colour, strokeWidth: 2 }));
  } else {
    marks.push(P.areaY(wrong, { ...bounds, fill: colour, fillOpacity: 0.35 }));
    marks.push(P.lineY(drawn, { x: "x", y: "y", stroke: colour, strokeWidth: 2 }));
  }
  if (options.dots || drawn.length < 40) marks.push(P.dot(drawn, { x: "x", y: "y", fill: colour, r: 3.5 }));
  for (const mark of options.marks || []) marks.push(mark);
  marks.push(P.tip(drawn, P.pointer({ x: "x", y: "y", title: (p) =>
    `${p.name || p.series}\n${options.x}: ${digits(p.x)}\n${options.y}: ${digits(p.y)}${p.error > 0 ? ` ± ${digits(p.error, 2)}` : ""}` })));
  const picture = P.plot({ width: 640, height: 350, marginTop: 32, marginLeft: 60, marginBottom: 44, style: { fontSize: "13px", fontFamily: "inherit" },
    ariaLabel: title, ariaDescription: `${options.y} over ${options.x}; the table below holds the numbers`,
    x: { label: options.x, labelOffset: 40, nice: true }, y: { label: options.y, grid: true, type: options.log ? "log" : "linear", nice: !options.log,
      tickFormat: options.log ? "~e" : undefined },
    color: { legend: several, scheme: "observable10", domain: [...new Set(drawn.map((p) => p.series))] }, marks });
  return make("figure", {}, make("figcaption", {}, title), picture, folded("Numbers", pointTable(title, points, options)));
}

function pointTable(title, points, options) {
  const hasError = points.some((p) => p.error > 0);
  const columns = [{ title: "series" }, { title: options.x }, { title: options.y }, ...(hasError ? [{ title: "error" }] : [])];
  return makeTable(title, columns, points.map((p) => [p.name || p.series, digits(p.x), digits(p.y),
    ...(hasError ? [digits(p.error, 2)] : [])]));
}

/** Values by name with error bars, one a row: rows: [{ name, y, error, low, high, beside, besideError }] in the shown unit. */
function bars(title, rows, label, besideLabel) {
  const P = libraries, shown = rows.filter((row) => Number.isFinite(row.y));
  if (shown.length === 0) return make("p", { class: "hint" }, `${title}: no values.`);
  const blue = "#1f5f8b", marks = [P.ruleX([0])];
  marks.push(P.ruleY(shown.filter((r) => Number.isFinite(r.low)), { y: "name", x1: "low", x2: "high", stroke: "#b9c9d6", strokeWidth: 8 }));
  marks.push(P.ruleY(shown.filter((r) => r.error > 0), { y: "name", x1: (r) => r.y - r.error, x2: (r) => r.y + r.error,
    stroke: blue, strokeWidth: 2.5 }));
  marks.push(P.dot(shown, { y: "name", x: "y", fill: blue, r: 4.5 }));
  marks.push(P.ruleY(shown.filter((r) => r.besideError > 0), { y: "name", x1: (r) => r.beside - r.besideError, x2: (r) => r.beside + r.besideError,
    stroke: "#a04b00", strokeWidth: 1.5 }));
  marks.push(P.dot(shown.filter((r) => Number.isFinite(r.beside)), { y: "name", x: "beside", stroke: "#a04b00", symbol: "diamond", r: 4.5 }));
  const longest = Math.max(...shown.map((r) => r.name.length));
  const picture = P.plot({ width: 640, height: 80 + 28 * shown.length, marginBottom: 44, marginLeft: Math.min(240, 20 + 7.5 * longest), ariaLabel: title,
    ariaDescription: "The table below holds the numbers", style: { fontSize: "13px", fontFamily: "inherit" },
    x: { label, labelOffset: 40, grid: true, nice: true }, y: { label: null, domain: rows.map((r) => r.name) }, marks });
  const meaning = ["Dot: value; dark bar: its error", shown.some((r) => Number.isFinite(r.low)) ? "light bar: smallest to largest" : "",
    shown.some((r) => Number.isFinite(r.beside)) ? `diamond: ${besideLabel}` : ""].filter(Boolean).join("; ");
  return make("figure", {}, make("figcaption", {}, title), picture, make("p", { class: "hint" }, meaning + "."));
}
