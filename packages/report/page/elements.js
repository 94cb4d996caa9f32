// Elements of the document, made so that text is never read as markup.

function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}
const byId = (id) => document.getElementById(id);

/** columns: [{ title, text }], text: to the left; rows: [[value]]; the first column names the row. */
function makeTable(caption, columns, rows) {
  const kind = (column) => (column.text ? { class: "text" } : {});
  const body = rows.map((row) =>
    make("tr", {}, ...row.map((value, i) =>
      i === 0 ? make("th", { scope: "row" }, String(value)) : make("td", kind(columns[i]), String(value)))));
  const head = columns.map((column, i) => make("th", { scope: "col", ...(i === 0 ? { class: "text" } : kind(column)) }, column.title));
  const table = make("table", {}, make("caption", {}, caption), make("thead", {}, make("tr", {}, ...head)), make("tbody", {}, ...body));
  return make("div", { class: "table", tabindex: "0", role: "region", "aria-label": caption }, table);
}

/** A table of the run as it is; numbers with fewer digits. */
function runTable(table) {
  const isText = table.columns.map((_, c) => table.rows.some((row) => row[c] !== "" && !Number.isFinite(Number(row[c]))));
  const rows = table.rows.map((row) => row.map((cell, c) => (isText[c] || cell === "" ? cell : digits(Number(cell)))));
  return makeTable(table.name, table.columns.map((column, c) => ({ title: column.full, text: isText[c] })), rows);
}

function folded(title, ...children) {
  return make("details", {}, make("summary", {}, title), ...children);
}
