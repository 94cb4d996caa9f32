// Puts the page together.

function startView(garment, body) {
  try {
    return new View(byId("canvas"), garment, body);
  } catch (error) {
    byId("stage").hidden = true;
    byId("keys").hidden = true;
    byId("probe").textContent = `This browser cannot draw in 3-D (WebGL): ${error.message}. All numbers are in the tables.`;
    return null;
  }
}

function start() {
  const garment = new Surface(content.garment), body = content.body ? new Surface(content.body) : null;
  fillHeader();
  fillWarnings();
  fillPressures();
  fillChecks();
  fillConvergence();
  fillMesh(garment, body);
  fillFabrics();
  fillTables();
  fillScene();
  fillContents();
  const controls = new Controls(startView(garment, body), body ? [garment, body] : [garment]);
  for (const button of document.querySelectorAll("input[name=unit]"))
    button.addEventListener("change", () => {
      pressureUnit = button.value;
      controls.changeUnit();
      fillPressures();
    });
  Object.assign(document.documentElement.dataset, { ready: "yes", garmentNodes: garment.position.length / 3,
    bodyNodes: body ? body.position.length / 3 : 0, view: controls.view ? "drawn" : "none" });
}

start();
