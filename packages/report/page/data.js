// What the program has put into the page, decoded.
const content = JSON.parse(document.getElementById("content").textContent);
const mmhgPerKpa = 7.50062;
let pressureUnit = "kPa";

const bytesOf = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer;
// The page is little-endian, as every processor with a browser is.
const reals = (text) => new Float32Array(bytesOf(text));
const indices = (text) => new Uint32Array(bytesOf(text));

/** Pressures are in kPa in the page; everything else keeps its unit. */
const isPressure = (unit) => unit === "kPa";
const shownUnit = (unit) => (isPressure(unit) ? pressureUnit : unit);
const shownValue = (value, unit) => (isPressure(unit) && pressureUnit === "mmHg" ? value * mmhgPerKpa : value);
const keptValue = (value, unit) => (isPressure(unit) && pressureUnit === "mmHg" ? value / mmhgPerKpa : value);

const labels = { pressure: "pressure", pressure_error: "error of the pressure (estimate)", stretch_wale: "stretch along the wale",
  stretch_course: "stretch along the course", wrinkle_state: "wrinkles (0 taut, 1 wrinkled, 2 slack)",
  cauchy_minor: "smaller principal stress (below 0: would wrinkle)", gap: "gap to the body",
  body_error: "surface of the body against its file", stabilisation_energy: "hourglass energy" };
const labelOf = (name) => labels[name] || name.replace(/_/g, " ");
const withUnit = (text, unit) => (unit ? `${text} (${unit})` : text);

/** Four digits, as a reader wants them; nothing for what is not a number. */
function digits(value, count = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "";
  if (value === 0) return "0";
  const size = Math.abs(value);
  return size >= 1e6 || size < 1e-3 ? value.toExponential(count - 2) : String(Number(value.toPrecision(count)));
}

/** "0.862 kPa (6.47 mmHg)", the chosen unit first; with its error if there is one. */
function pressureText(kpa, error) {
  const one = (unit) => {
    const factor = unit === "kPa" ? 1 : mmhgPerKpa;
    return `${digits(kpa * factor, 3)}${error > 0 ? ` ± ${digits(error * factor, 2)}` : ""} ${unit}`;
  };
  return pressureUnit === "kPa" ? `${one("kPa")} (${one("mmHg")})` : `${one("mmHg")} (${one("kPa")})`;
}

/** A table of the run: { name, columns: [{ title, unit, full }], rows: [[text]] }. */
function readTable({ name, text }) {
  const [head = [], ...rows] = libraries.csvParseRows(text);
  const columns = head.map((full) => {
    const parts = /^(.*) \[([^\]]*)\]$/.exec(full);
    return parts ? { title: parts[1], unit: parts[2], full } : { title: full, unit: "", full };
  });
  return { name, columns, rows };
}
const tables = content.tables.map(readTable);
const tableNamed = (name) => tables.find((table) => table.name === name);
/** Index of the first column whose whole title matches; -1. */
const columnOf = (table, pattern) => table.columns.findIndex((column) => pattern.test(column.full));
const numberIn = (row, column) => (column < 0 || row[column] === "" ? NaN : Number(row[column]));
