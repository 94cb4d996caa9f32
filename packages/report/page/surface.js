// Garment or body as triangles with corners of their own, so that a field of elements has one colour an element.

const cornersOf = { 3: [0, 1, 2], 4: [0, 1, 2, 0, 2, 3] };

class Surface {
  constructor(data) {
    this.position = reals(data.position);
    this.blocks = data.blocks.map((block) => ({ ...block, nodes: indices(block.nodes) }));
    const nodes = [], elements = [];
    let first = 0;
    for (const block of this.blocks) {
      const n = block.perElement, count = block.nodes.length / n;
      block.first = first;
      block.size = count;
      for (let e = 0; e < count; ++e)
        cornersOf[n].forEach((corner, i) => {
          nodes.push(block.nodes[n * e + corner]);
          if (i % 3 === 0) elements.push(first + e);
        });
      first += count;
    }
    /** [corner of a triangle] node; [triangle] element, counted over all blocks */
    this.nodes = Uint32Array.from(nodes);
    this.elements = Uint32Array.from(elements);
    this.fields = new Map();
    for (const field of data.fields) this.fields.set(field.name, { ...field, place: "node", values: reals(field.values) });
    for (const block of this.blocks)
      for (const field of block.fields) this.addElementField(block, field, first);
  }

  addElementField(block, field, elements) {
    if (!this.fields.has(field.name))
      this.fields.set(field.name, { name: field.name, unit: field.unit, place: "element", values: new Float32Array(elements).fill(NaN) });
    this.fields.get(field.name).values.set(reals(field.values), block.first);
  }

  blockOf(element) {
    return this.blocks.find((block) => element >= block.first && element < block.first + block.size);
  }

  /** [corner of a triangle] value of a field that is there */
  cornerValues(field) {
    return field.place === "node" ? Float32Array.from(this.nodes, (node) => field.values[node])
      : Float32Array.from(this.nodes, (_, corner) => field.values[this.elements[Math.floor(corner / 3)]]);
  }

  /** In a triangle, at weights of its three corners. */
  valueAt(name, triangle, weights) {
    const field = this.fields.get(name);
    if (!field) return NaN;
    if (field.place === "element") return field.values[this.elements[triangle]];
    return weights.reduce((sum, weight, i) => sum + weight * field.values[this.nodes[3 * triangle + i]], 0);
  }

  geometry() {
    const { BufferAttribute, BufferGeometry } = libraries, geometry = new BufferGeometry(), normals = this.nodeNormals();
    const spread = (values) => Float32Array.from({ length: 3 * this.nodes.length }, (_, i) => values[3 * this.nodes[Math.floor(i / 3)] + (i % 3)]);
    geometry.setAttribute("position", new BufferAttribute(spread(this.position), 3));
    geometry.setAttribute("normal", new BufferAttribute(spread(normals), 3));
    geometry.setAttribute("color", new BufferAttribute(new Float32Array(3 * this.nodes.length), 3));
    return geometry;
  }

  /** Sums of the triangles' normals; where they cancel (folded fabric) the light is flat. */
  nodeNormals() {
    const x = this.position, n = new Float32Array(x.length);
    for (let t = 0; t < this.nodes.length; t += 3) {
      const [a, b, c] = [0, 1, 2].map((i) => 3 * this.nodes[t + i]);
      const u = [0, 1, 2].map((k) => x[b + k] - x[a + k]), v = [0, 1, 2].map((k) => x[c + k] - x[a + k]);
      const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      for (const node of [a, b, c]) for (let k = 0; k < 3; ++k) n[node + k] += normal[k];
    }
    for (let i = 0; i < n.length; i += 3) {
      const size = Math.hypot(n[i], n[i + 1], n[i + 2]) || 1;
      for (let k = 0; k < 3; ++k) n[i + k] /= size;
    }
    return n;
  }

  /** Lines between nodes: every side of an element, or those that one element of a block alone has. */
  lines(ofElements) {
    const places = [];
    for (const block of this.blocks) {
      const n = block.perElement, sides = new Map();
      for (let i = 0; i < block.nodes.length; ++i) {
        const a = block.nodes[i], b = block.nodes[i % n === n - 1 ? i - n + 1 : i + 1];
        const key = a < b ? `${a} ${b}` : `${b} ${a}`;
        sides.set(key, { a, b, count: (sides.get(key)?.count || 0) + 1 });
      }
      for (const { a, b, count } of sides.values())
        if (ofElements || count === 1)
          for (const node of [a, b]) places.push(...this.position.subarray(3 * node, 3 * node + 3));
    }
    const geometry = new libraries.BufferGeometry();
    geometry.setAttribute("position", new libraries.BufferAttribute(Float32Array.from(places), 3));
    return geometry;
  }
}

/** Smallest and largest number, and the value below which a share of them lies. */
function spreadOf(values, share) {
  const sorted = Float32Array.from(values.filter(Number.isFinite)).sort();
  if (sorted.length === 0) return null;
  const at = (part) => sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))];
  return { lowest: sorted[0], largest: sorted[sorted.length - 1], low: at(1 - share), high: at(share),
    middle: at(0.5) };
}
