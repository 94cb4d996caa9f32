// The controls of the view, pointer and keyboard.

const firstFields = ["pressure", "pressure_error", "stretch_wale", "stretch_course", "wrinkle_state", "cauchy_minor", "gap"];
const toldFields = ["stretch_wale", "stretch_course", "gap"];

/** Every field of garment and body: { name, unit }, the most wanted first. */
function allFields(surfaces) {
  const fields = new Map();
  for (const surface of surfaces) for (const field of surface.fields.values()) if (!fields.has(field.name)) fields.set(field.name, field);
  const place = (name) => (firstFields.includes(name) ? firstFields.indexOf(name) : firstFields.length);
  return [...fields.values()].sort((a, b) => place(a.name) - place(b.name));
}

/** What is said of a place: the chosen field, the pressure with its error, stretches, where it is. */
function placeText(hit, chosen) {
  const { surface } = hit.part, value = (name) => surface.valueAt(name, hit.triangle, hit.weights);
  const lines = [hit.part.name === "body" ? "body" : `panel ${hit.block.name}`];
  const add = (name) => {
    const number = value(name), field = surface.fields.get(name);
    if (Number.isFinite(number)) lines.push(`${labelOf(name)}: ${digits(shownValue(number, field.unit))} ${shownUnit(field.unit)}`.trim());
  };
  if (surface.fields.has("pressure")) lines.push(`pressure: ${pressureText(value("pressure"), value("pressure_error"))}`);
  for (const name of new Set([chosen, ...toldFields])) if (name !== "pressure") add(name);
  lines.push(`at (${hit.point.toArray().map((x) => x.toFixed(1)).join(", ")}) mm`);
  return lines.join("\n");
}

class Controls {
  constructor(view, surfaces) {
    this.view = view; // null: nothing can be drawn here
    this.surfaces = surfaces;
    this.fields = allFields(surfaces);
    this.fillFields();
    byId("field").addEventListener("change", () => this.chooseField());
    for (const id of ["lowest", "largest"]) byId(id).addEventListener("change", () => this.takeRange());
    byId("range").addEventListener("click", () => this.chooseField());
    byId("controls").addEventListener("submit", (event) => event.preventDefault());
    if (view) this.connectView();
    this.chooseField();
  }

  connectView() {
    for (const id of ["garment", "body", "seams", "elements"]) byId(`show-${id}`).addEventListener("change", () => this.show());
    byId("show-body").disabled = this.view.parts.length === 1;
    for (const id of ["axis", "place", "flip"]) byId(`section-${id}`).addEventListener("input", () => this.cut());
    if (this.view.upright) byId("section-z").textContent = "z (height)";
    for (const button of document.querySelectorAll("[data-look]"))
      button.addEventListener("click", () => this.view.look(Number(button.dataset.look)));
    const canvas = byId("canvas");
    canvas.addEventListener("pointermove", (event) => this.hover(event));
    canvas.addEventListener("pointerleave", () => { byId("hover").hidden = true; });
    canvas.addEventListener("keydown", (event) => this.key(event));
  }

  get field() { return this.fields.find((field) => field.name === byId("field").value); }

  fillFields() {
    const select = byId("field"), chosen = select.value;
    select.replaceChildren(...this.fields.map((field) =>
      make("option", { value: field.name }, withUnit(labelOf(field.name), shownUnit(field.unit)))));
    if (chosen) select.value = chosen;
  }

  /** The range of a field that was not looked at yet. */
  chooseField() {
    if (!this.field) return;
    this.range = this.view ? this.view.rangeOf(this.field.name) : [0, 1];
    this.recolour();
  }

  takeRange() {
    const [low, high] = ["lowest", "largest"].map((id) => keptValue(Number(byId(id).value), this.field.unit));
    if (high > low) this.range = [low, high];
    this.recolour();
  }

  /** The unit of pressures has changed. */
  changeUnit() {
    this.fillFields();
    this.recolour();
  }

  recolour() {
    const { name, unit } = this.field, [low, high] = this.range.map((value) => digits(shownValue(value, unit)));
    const title = withUnit(labelOf(name), shownUnit(unit));
    byId("lowest").value = low;
    byId("largest").value = high;
    const [bottom, top] = this.range, mark = (value) => (isPressure(unit) ? pressureText(value) : digits(value, 3));
    byId("legend-low").textContent = mark(bottom);
    byId("legend-middle").textContent = mark((bottom + top) / 2);
    byId("legend-high").textContent = mark(top);
    byId("legend-title").textContent = isPressure(unit) ? labelOf(name) : title;
    byId("legend-bar").style.background = `linear-gradient(to top, ${Array.from({ length: 11 }, (_, i) => libraries.interpolateViridis(i / 10)).join()})`;
    byId("legend-text").textContent = `Colours: ${title} from ${low} (dark violet) to ${high} (yellow); values beyond have the colour of the end. ` +
      "Grey: no value, or the body beside the garment; without the garment the body has its colours. At first the range is that of 99 of 100 values.";
    byId("canvas").setAttribute("aria-label", `Garment and body in 3-D, coloured by ${title}`);
    this.tell();
    if (this.view) this.view.colour(name, this.range);
  }

  /** The chosen field in numbers. */
  tell() {
    const { name, unit } = this.field, rows = [];
    for (const [index, surface] of this.surfaces.entries()) {
      const field = surface.fields.get(name);
      if (!field) continue;
      for (const block of surface.blocks) {
        const values = field.place === "element" ? field.values.subarray(block.first, block.first + block.size)
          : Float32Array.from(new Set(block.nodes), (node) => field.values[node]);
        const spread = spreadOf(values, 0.95);
        if (spread) rows.push([index === 1 ? "body" : block.name, ...["lowest", "low", "middle", "high", "largest"].map((key) => digits(shownValue(spread[key], unit)))]);
      }
    }
    const columns = ["panel", "smallest", "5 % below", "half below", "95 % below", "largest"].map((title) => ({ title }));
    const summary = byId("field-table").querySelector("summary");
    byId("field-table").replaceChildren(summary, makeTable(withUnit(labelOf(name), shownUnit(unit)), columns, rows));
  }

  show() {
    const what = {};
    for (const id of ["garment", "body", "seams", "elements"]) what[id] = byId(`show-${id}`).checked;
    this.view.show(what);
    this.view.colour(this.field.name, this.range);
  }

  cut() {
    const axis = byId("section-axis").value, off = axis === "";
    for (const id of ["section-place", "section-flip"]) byId(id).disabled = off;
    byId("section-value").textContent = "";
    if (off) return this.view.cut(null);
    const [low, high] = this.view.box[Number(axis)], place = low + (high - low) * byId("section-place").value / 1000;
    const text = `${"xyz"[axis]} = ${place.toFixed(0)} mm`;
    byId("section-value").textContent = text;
    byId("section-place").setAttribute("aria-valuetext", text);
    this.view.cut(Number(axis), place, byId("section-flip").checked);
  }

  hover(event) {
    if (event.buttons !== 0) return;
    const frame = byId("canvas").getBoundingClientRect(), x = event.clientX - frame.left, y = event.clientY - frame.top;
    cancelAnimationFrame(this.looking);
    this.looking = requestAnimationFrame(() => {
      const hit = this.view.at(2 * x / frame.width - 1, 1 - 2 * y / frame.height), box = byId("hover");
      box.hidden = !hit;
      if (!hit) return;
      box.textContent = placeText(hit, this.field.name);
      box.style.left = `${Math.max(0, Math.min(x + 14, frame.width - box.offsetWidth - 4))}px`;
      box.style.top = `${Math.max(0, Math.min(y + 14, frame.height - box.offsetHeight - 4))}px`;
      // Spoken once the pointer rests.
      clearTimeout(this.resting);
      this.resting = setTimeout(() => { byId("probe").textContent = box.textContent; }, 400);
    });
  }

  key(event) {
    const turn = Math.PI / 24, view = this.view;
    const read = () => {
      const hit = view.at(0, 0);
      byId("probe").textContent = hit ? `In the middle of the view: ${placeText(hit, this.field.name)}` : "Nothing is in the middle of the view.";
    };
    const keys = { ArrowLeft: () => view.turn(-turn, 0), ArrowRight: () => view.turn(turn, 0), ArrowUp: () => view.turn(0, -turn),
      ArrowDown: () => view.turn(0, turn), "+": () => view.approach(0.85), "=": () => view.approach(0.85), "-": () => view.approach(1 / 0.85),
      Home: () => view.look(view.upright ? 30 : 0), Enter: read, " ": read };
    if (!keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  }
}
