// The contact network: rods from centre to centre, or to the point at a wall or rib, as thick as their force.
class Contacts {
  constructor(scene, replay) {
    const {contacts} = replay;
    this.replay = replay;
    this.starts = contacts.starts;
    this.ends = unpack(contacts.ends);
    this.force = unpack(contacts.force);
    this.of = unpack(contacts.of);
    this.stones = unpack(contacts.stones);
    // One outlier must not thin all the others.
    this.reference = quantile(this.force, 0.995) || 1;
    const most = Math.max(1, ...this.starts.slice(1).map((start, k) => start - this.starts[k]));
    this.rod = new THREE.CylinderBufferGeometry(1, 1, 1, 6, 1, true).rotateX(Math.PI / 2);
    const material = new THREE.MeshBasicMaterial({vertexColors: THREE.VertexColors});
    this.copies = new Copies(scene, material, most * this.rod.attributes.position.count, most * this.rod.index.count);
    this.mesh = this.copies.mesh;
    this.mesh.visible = false;
  }

  // Contacts below a hundredth of the reference are too thin to be seen.
  update(frame, isCut) {
    if (!this.mesh.visible) return;
    const thickest = 0.0022; // [m]
    const matrix = new THREE.Matrix4(), turn = new THREE.Quaternion(), axis = new THREE.Vector3();
    const ahead = new THREE.Vector3(0, 0, 1);
    this.copies.begin();
    for (let k = this.starts[frame]; k < this.starts[frame + 1]; ++k) {
      const share = this.force[k] / this.reference;
      if (share < 0.01) continue;
      const a = new THREE.Vector3(...place(this.replay, this.ends, 2 * k));
      const b = new THREE.Vector3(...place(this.replay, this.ends, 2 * k + 1));
      axis.subVectors(b, a);
      const length = axis.length(), middle = a.add(b).multiplyScalar(0.5);
      if (length === 0 || isCut(middle.x, middle.y, middle.z)) continue;
      const radius = thickest * Math.min(Math.max(share, 0.06), 1.5);
      turn.setFromUnitVectors(ahead, axis.divideScalar(length));
      matrix.compose(middle, turn, new THREE.Vector3(radius, radius, length));
      this.copies.add(this.rod, matrix, colourAt("force", share));
    }
    this.copies.end();
  }

  // With how many stones, walls and ribs the stone is in touch.
  count(frame, stone) {
    const counts = [0, 0, 0];
    for (let k = this.starts[frame]; k < this.starts[frame + 1]; ++k)
      if (this.stones[2 * k] === stone || this.stones[2 * k + 1] === stone) ++counts[this.of[k]];
    return counts;
  }
}
