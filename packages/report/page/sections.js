// The sections below the view. Each fills its element; what changes with the unit of pressures is filled again.

const record = content.run || {};

/** Removes what a section held, but its title. */
function refill(id, ...children) {
  const section = byId(id), shown = children.filter(Boolean);
  section.replaceChildren(section.querySelector("h2"), ...shown);
  section.hidden = shown.length === 0;
}

function fillHeader() {
  const title = record.title || content.results;
  document.title = `${title} - Toile`;
  byId("title").textContent = title;
  const ends = { reached: "The run reached its end.", failed: "The run failed; shown is its last converged state.", "not yet": "The run had not ended." };
  byId("state").textContent = `${content.results}, step ${content.steps}. ${ends[record.end] || ""}`;
}

function fillWarnings() {
  const alerts = [...content.problems];
  if (record.failure) alerts.push(`The run failed: ${record.failure}`);
  for (const check of record.checks || []) if (!check.holds) alerts.push(check.message);
  alerts.push(...(record.warnings || []));
  if (content.leftOut.length > 0)
    alerts.push(`Left out of this page for its size, and in ${content.results}: ${content.leftOut.map(labelOf).join(", ")}.`);
  const list = alerts.length > 0 ? make("ul", {}, ...alerts.map((text) => make("li", { class: "alert" }, text)))
    : make("p", { class: "good" }, "No warnings.");
  const notes = (record.notes || []).map((text) => make("li", { class: "hint" }, text));
  refill("warnings", list, notes.length > 0 && make("h3", {}, "Notes"), notes.length > 0 && make("ul", {}, ...notes));
}

/** A pressure column of a table in the shown unit. */
const pressuresOf = (table, pattern) => {
  const column = columnOf(table, pattern);
  return (row) => shownValue(numberIn(row, column), "kPa");
};

/** Levels or points, a row each: how they are drawn depends on the columns that the table has. */
function namedPressures(table, title) {
  if (!table || table.rows.length === 0) return null;
  const y = pressuresOf(table, /^(mean )?pressure \[kPa\]$/), error = pressuresOf(table, /^(its error|error of the mean pressure) \[kPa\]$/);
  const low = pressuresOf(table, /^smallest pressure \[kPa\]$/), high = pressuresOf(table, /^largest pressure \[kPa\]$/);
  const laplace = pressuresOf(table, /^Laplace T\/r \[kPa\]$/);
  const rows = table.rows.map((row) => ({ name: row[0], y: y(row), error: error(row), low: low(row), high: high(row), beside: laplace(row) }));
  const parts = table.columns.map((column, c) => ({ c, cause: (/^its part by (.*) \[kPa\]$/.exec(column.full) || [])[1] })).filter((part) => part.cause);
  const has = (key) => rows.some((row) => Number.isFinite(row[key]));
  const columns = [{ title: table.columns[0].full }, { title: `pressure (${pressureUnit})` }, { title: "error" },
    ...(has("low") ? [{ title: "smallest" }, { title: "largest" }] : []),
    ...(has("beside") ? [{ title: "Laplace T/r" }] : []), ...parts.map((part) => ({ title: `error by ${part.cause}` }))];
  const cells = rows.map((row, r) => [row.name, digits(row.y, 3) || "not reached", digits(row.error, 2),
    ...(has("low") ? [digits(row.low, 3), digits(row.high, 3)] : []),
    ...(has("beside") ? [digits(row.beside, 3)] : []),
    ...parts.map((part) => digits(shownValue(numberIn(table.rows[r], part.c), "kPa"), 2))]);
  return make("div", {}, bars(title, rows, `pressure (${pressureUnit})`, "Laplace T/r"), makeTable(`${title}, ${pressureUnit}`, columns, cells),
    folded(`All columns of ${table.name}`, runTable(table)));
}

/** Measured pressures beside computed ones (toile compare). */
function comparedPressures(table) {
  if (!table || table.rows.length === 0) return null;
  const title = "Measured and computed pressure", within = columnOf(table, /^within both$/);
  const [y, error, measured, scatter, deviation] = [/^computed \[kPa\]$/, /^its error \[kPa\]$/, /^measured \[kPa\]$/, /^its scatter \[kPa\]$/,
    /^deviation \[kPa\]$/].map((pattern) => pressuresOf(table, pattern));
  const rows = table.rows.map((row) => ({ name: row[0], y: y(row), error: error(row), beside: measured(row), besideError: scatter(row) }));
  const bar = (value, its) => `${digits(value, 3)} ± ${digits(its, 2)}`;
  const cells = table.rows.map((row, r) => [row[0], bar(rows[r].beside, rows[r].besideError), bar(rows[r].y, rows[r].error), digits(deviation(row), 2), row[within]]);
  return make("div", {}, bars(title, rows, `pressure (${pressureUnit})`, "measured, with its scatter"),
    makeTable(`${title}, ${pressureUnit}`, ["place", "measured", "computed", "deviation", "within both"].map((text) => ({ title: text })), cells));
}

/** Of the measured places those that lie within 10 mm of a line, at the arc length of its closest station. */
function measuredOnLines(table) {
  const compared = tableNamed("pressure-compared.csv");
  if (table.name !== "pressure-lines.csv" || !compared || columnOf(compared, /^x \[mm\]$/) < 0) return [];
  const placeIn = (one) => { const columns = ["x", "y", "z"].map((c) => columnOf(one, new RegExp(`^${c} \\[mm\\]$`))); return (row) => columns.map((c) => numberIn(row, c)); };
  const stationAt = placeIn(table), measuredAt = placeIn(compared), x = columnOf(table, /^arc length \[mm\]$/);
  const y = pressuresOf(compared, /^measured \[kPa\]$/), error = pressuresOf(compared, /^its scatter \[kPa\]$/);
  return compared.rows.flatMap((row) => {
    const distance = (station) => Math.hypot(...stationAt(station).map((value, c) => value - measuredAt(row)[c]));
    const station = table.rows.reduce((best, other) => (distance(other) < distance(best) ? other : best));
    return distance(station) <= 10 ? [{ x: numberIn(station, x), y: y(row), error: error(row), name: row[0], series: `measured on ${station[0]}` }] : [];
  });
}

/** Pressure over a length, with its error as a band: any table whose name begins with "pressure" and that has both. */
function pressureLine(table) {
  const x = columnOf(table, /^(height|distance|length|arc length|position) \[mm\]$/);
  const y = pressuresOf(table, /^(mean )?pressure \[kPa\]$/), error = pressuresOf(table, /error.*pressure \[kPa\]$|^its error \[kPa\]$/);
  const low = pressuresOf(table, /^smallest pressure \[kPa\]$/), high = pressuresOf(table, /^largest pressure \[kPa\]$/);
  const laplace = pressuresOf(table, /^Laplace T\/r \[kPa\]$/), support = columnOf(table, /^at a support$/), line = columnOf(table, /^line$/);
  const rows = table.rows.filter((row) => row[support] !== "1");
  const points = rows.map((row) => ({ x: numberIn(row, x), y: y(row), error: error(row), low: low(row), high: high(row), series: line < 0 ? "pressure" : row[line] }));
  for (const row of rows) if (Number.isFinite(laplace(row))) points.push({ x: numberIn(row, x), y: laplace(row), series: "Laplace T/r" });
  const measured = measuredOnLines(table), bounds = { x: "x", y1: (p) => p.y - p.error, y2: (p) => p.y + p.error };
  const marks = [...levelMarks(table), libraries.ruleX(measured, { ...bounds, stroke: "#1c1b1a", strokeWidth: 1.5 }),
    libraries.dot(measured, { x: "x", y: "y", r: 4.5, symbol: "diamond", fill: "#1c1b1a" }), libraries.text(measured, { x: "x", y: "y", text: "name", dy: -12 })];
  const figure = chart(line < 0 ? `Pressure along ${table.columns[x].title}` : "Pressure along lines on the body", points,
    { x: withUnit(table.columns[x].title, "mm"), y: `pressure (${pressureUnit})`, zero: true, marks });
  const meaning = ["Dark band: error of the pressure", points.some((p) => Number.isFinite(p.low)) ? "light band: smallest to largest value there" : "",
    measured.length > 0 ? "diamonds: measured within 10 mm of the line, with their scatter" : ""].filter(Boolean).join("; ");
  return make("div", {}, figure, make("p", { class: "hint" }, `${meaning}.`),
    folded(`All columns of ${table.name}`, runTable(table)));
}

/** The levels on the curve along the axis. */
function levelMarks(table) {
  const levels = tableNamed("pressure-levels.csv");
  if (table.name !== "pressure-curve.csv" || !levels) return [];
  const height = columnOf(levels, /^height \[mm\]$/), pressure = pressuresOf(levels, /^mean pressure \[kPa\]$/);
  const points = levels.rows.map((row) => ({ x: numberIn(row, height), y: pressure(row), name: row[0] })).filter((p) => Number.isFinite(p.y));
  return [libraries.dot(points, { x: "x", y: "y", r: 4.5, fill: "#1c1b1a" }), libraries.text(points, { x: "x", y: "y", text: "name", dy: -12, fontWeight: 600 })];
}

const isLine = (table) => /^pressure/.test(table.name) && !/-(levels|points)\.csv$/.test(table.name) &&
  columnOf(table, /^(height|distance|length|arc length|position) \[mm\]$/) >= 0 && columnOf(table, /^(mean )?pressure \[kPa\]$/) >= 0;

function fillPressures() {
  refill("levels", namedPressures(tableNamed("pressure-levels.csv"), "Mean pressure at the levels"),
    namedPressures(tableNamed("pressure-points.csv"), "Pressure at the points"),
    comparedPressures(tableNamed("pressure-compared.csv")));
  refill("lines", ...tables.filter((table) => isLine(table) && table.rows.length > 0).map(pressureLine));
}

function fillChecks() {
  const checks = record.checks || [];
  refill("checks", checks.length > 0 && makeTable("Checks", [{ title: "check" }, { title: "holds" }, { title: "quantity", text: true }, { title: "value" },
    { title: "allowed" }], checks.map((c) => [c.name, c.holds ? "yes" : "no", c.quantity, withUnit(digits(c.value) || "none", c.unit), c.allowed])));
}

function fillConvergence() {
  const field = (name) => content.history.find((one) => one.name === name);
  const series = (names) => names.filter(field).flatMap((name) =>
    field(name).values.map((y, i) => ({ x: i + 1, y: y === null ? NaN : y, series: labelOf(name) })));
  const plot = (title, names, y, more) => chart(title, series(names), { x: "step", y, ...more });
  const energies = ["strain_energy", "dissipated_energy", "stabilisation_energy"].filter((name) => field(name)?.values.some((v) => v > 0));
  const plots = make("div", { class: "plots" }, plot("Residual over the forces that meet in it", ["residual", "undamped_residual"], "residual", { log: true }),
    plot("Energy", energies, "energy (N mm)", { zero: true }), plot("Iterations of each step", ["iterations", "cut_backs"], "number", { zero: true, dots: true }),
    plot("Seams and load", ["seam_closing", "load"], "share", { zero: true }), plot("Time since the start", ["wall_time"], "time (s)", { zero: true }));
  const columns = [{ title: "step" }, ...content.history.map((one) => ({ title: withUnit(labelOf(one.name), one.unit) }))];
  const rows = Array.from({ length: content.steps }, (_, i) => [i + 1, ...content.history.map((one) => digits(one.values[i]))]);
  const table = makeTable("Steps", columns, rows);
  // One step makes no curve.
  refill("convergence", ...(content.steps > 1 ? [plots, folded("Every step in numbers", table)] : [table]));
}

function fillMesh(garment, body) {
  const kinds = { 3: "triangles", 4: "quadrilaterals" }, told = (name) => (record.panels || []).find((panel) => panel.name === name) || {};
  const rows = garment.blocks.map((block) => [block.name, block.size, kinds[block.perElement], told(block.name).fabric || "",
    told(block.name).shell === undefined ? "" : told(block.name).shell ? "shell" : "membrane"]);
  const figures = [`${garment.position.length / 3} nodes and ${rows.reduce((sum, row) => sum + row[1], 0)} elements in the garment`];
  if (record.unknowns) figures.push(`${record.unknowns} unknowns`);
  if (body) figures.push(`body: ${record.body || ""} shown with ${body.blocks[0].size} triangles`);
  refill("mesh", make("p", {}, `${figures.join("; ")}.`), makeTable("Panels", [{ title: "panel" }, { title: "elements" }, { title: "kind", text: true },
    { title: "fabric", text: true }, { title: "element", text: true }], rows),
  record.used && make("p", { class: "hint" }, `Used: ${record.used.join(", ")}. Left out: ${record["left out"].join(", ") || "nothing"}.`));
}

function fillFabrics() {
  const figures = (record.fabrics || []).map((fabric) => {
    const points = fabric.curves.flatMap((curve) => curve.stretch.map((x, i) => ({ x, y: curve.tension[i], series: curve.title })));
    const text = `Thickness ${digits(fabric.thickness)} mm; compression: ${fabric.compression}.${fabric.graduated ? " Graduated: the curves are those at the middle of its panel." : ""}`;
    return make("div", {}, chart(`${fabric.name}: tension of a strip that may contract`, points, { x: "stretch", y: "force per undeformed width (N/mm)", zero: true }),
      make("p", { class: "hint" }, text));
  });
  refill("fabrics", figures.length > 0 && make("div", { class: "plots" }, ...figures));
}

/** Force over stretch of each pulled support. */
function forceCurves(table) {
  const points = table.columns.flatMap((column, c) => {
    const force = table.columns.findIndex((other) => other.full === column.title.replace(/: stretch$/, ": force [N]"));
    if (!/: stretch$/.test(column.title) || force < 0) return [];
    return table.rows.map((row) => ({ x: numberIn(row, c), y: numberIn(row, force), series: column.title.replace(/: stretch$/, "") }));
  });
  return chart("Force over stretch", points, { x: "stretch", y: "force (N)", zero: true });
}

function fillTables() {
  const others = tables.filter((table) => !isLine(table) && !/^pressure-(levels|points|compared)\.csv$/.test(table.name));
  const forces = tableNamed("force-curves.csv");
  refill("tables", forces && forceCurves(forces), ...others.map((table) =>
    (table.rows.length > 0 ? folded(table.name, runTable(table)) : make("p", { class: "hint" }, `${table.name}: no rows.`))));
}

function fillScene() {
  const lists = new Map();
  for (const [path, value] of Object.entries(record.scene || {})) {
    const parts = path.split(" > ").slice(1), list = parts.length > 1 ? parts[0] : "general";
    if (!lists.has(list)) lists.set(list, []);
    lists.get(list).push([(parts.length > 1 ? parts.slice(1) : parts).join(" > "), value]);
  }
  const columns = [{ title: "parameter" }, { title: "value", text: true }];
  refill("scene", lists.size > 0 && make("p", { class: "hint" }, "Every parameter with its value, defaults included."),
    ...[...lists].map(([list, rows]) => folded(list, makeTable(list, columns, rows))));
}

function fillContents() {
  const sections = [...document.querySelectorAll("main > section")].filter((section) => !section.hidden);
  byId("contents").replaceChildren(...sections.map((section) =>
    make("li", {}, make("a", { href: `#${section.id}` }, section.querySelector("h2").textContent))));
}
