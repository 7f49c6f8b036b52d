// Beam elements as boxes of the rib's width and thickness, coloured by a section force.
class Ribs {
  constructor(scene, most, width, thickness) {
    this.width = width;
    this.thickness = thickness;
    this.box = new THREE.BoxBufferGeometry(1, 1, 1);
    const material = new THREE.MeshBasicMaterial({vertexColors: THREE.VertexColors}); // unlit, as in the legend
    this.copies = new Copies(scene, material, most * this.box.attributes.position.count, most * this.box.index.count);
    this.mesh = this.copies.mesh;
  }

  // `point(n)` is the place of node n, `value(e)` the force of element e, `limit` where the scale ends.
  update(lines, point, value, limit) {
    const matrix = new THREE.Matrix4();
    const up = new THREE.Vector3(0, 0, 1), along = new THREE.Vector3();
    const across = new THREE.Vector3(), normal = new THREE.Vector3();
    this.copies.begin();
    for (let e = 0; e < lines.length / 2; ++e) {
      const a = new THREE.Vector3(...point(lines[2 * e])), b = new THREE.Vector3(...point(lines[2 * e + 1]));
      along.subVectors(b, a);
      across.crossVectors(up, along);
      if (across.length() < 1e-6 * along.length()) across.set(0, 1, 0);
      across.setLength(this.width);
      normal.crossVectors(along, across).setLength(this.thickness);
      const middle = a.add(b).multiplyScalar(0.5);
      matrix.makeBasis(along, across, normal).setPosition(middle);
      this.copies.add(this.box, matrix, colourAt("signed", signedShare(value(e) / limit)));
    }
    this.copies.end();
  }
}
