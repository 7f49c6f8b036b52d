// Beam elements as boxes of the rib's width and thickness, coloured by a section force.
class Ribs {
  constructor(scene, most, width, thickness) {
    this.width = width;
    this.thickness = thickness;
    const geometry = new THREE.BoxBufferGeometry(1, 1, 1);
    geometry.setAttribute("color", new THREE.InstancedBufferAttribute(new Float32Array(3 * most), 3));
    // Unlit, so that a colour is that of the legend.
    const material = new THREE.MeshBasicMaterial({vertexColors: THREE.VertexColors});
    this.mesh = new THREE.InstancedMesh(geometry, material, most);
    this.mesh.frustumCulled = false;
    scene.add(this.mesh);
  }

  // `point(n)` is the place of node n, `value(e)` the force of element e, `limit` where the scale ends.
  update(lines, point, value, limit) {
    const matrix = new THREE.Matrix4(), colours = this.mesh.geometry.attributes.color;
    const up = new THREE.Vector3(0, 0, 1), along = new THREE.Vector3();
    const across = new THREE.Vector3(), normal = new THREE.Vector3();
    this.mesh.count = lines.length / 2;
    for (let e = 0; e < this.mesh.count; ++e) {
      const a = new THREE.Vector3(...point(lines[2 * e])), b = new THREE.Vector3(...point(lines[2 * e + 1]));
      along.subVectors(b, a);
      across.crossVectors(up, along);
      if (across.length() < 1e-6 * along.length()) across.set(0, 1, 0);
      across.setLength(this.width);
      normal.crossVectors(along, across).setLength(this.thickness);
      const middle = a.add(b).multiplyScalar(0.5);
      matrix.makeBasis(along, across, normal).setPosition(middle);
      this.mesh.setMatrixAt(e, matrix);
      colours.array.set(colourAt("signed", signedShare(value(e) / limit)), 3 * e);
    }
    this.mesh.instanceMatrix.needsUpdate = true;
    colours.needsUpdate = true;
  }
}
