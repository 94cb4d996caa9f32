// What the page uses of the libraries: everything else is left out of libraries.min.js.
export {
  AmbientLight, BufferAttribute, BufferGeometry, Color, DirectionalLight, DoubleSide, LineBasicMaterial, LineSegments, Mesh,
  MeshLambertMaterial, PerspectiveCamera, Plane, Raycaster, Scene, Triangle, Vector2, Vector3, WebGLRenderer,
} from "three";
export { OrbitControls } from "three/addons/controls/OrbitControls.js";
export { areaY, dot, lineY, plot, pointer, ruleX, ruleY, text, tip } from "@observablehq/plot";
export { csvParseRows } from "d3-dsv";
export { interpolateViridis } from "d3-scale-chromatic";
