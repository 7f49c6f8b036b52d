// The deformed pieces of a geogrid's laboratory, one a step of the slider, over their unloaded outlines.
class Pieces {
  constructor(replay) {
    this.data = replay;
    this.pieces = replay.pieces.map((piece) => ({...piece, lines: unpack(piece.lines), points: unpack(piece.points),
      unloaded: unpack(piece.unloaded), values: piece.values ? unpack(piece.values) : null}));
    this.factor = 1;
    const all = this.pieces.map((piece) => this.box([...piece.points, ...piece.unloaded]));
    const low = [0, 1, 2].map((c) => Math.min(...all.map((box) => box.low[c])));
    const high = [0, 1, 2].map((c) => Math.max(...all.map((box) => box.high[c])));
    this.scene = new Scene(document.getElementById("view"), low, high);
    const most = Math.max(...this.pieces.map((piece) => piece.lines.length / 2));
    this.ribs = new Ribs(this.scene.scene, most, 0.002, 0.001);
    this.outline = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({color: style("wall")}));
    this.outline.frustumCulled = false;
    this.scene.scene.add(this.outline);
    this.index = 0;
    this.scene.resize();
  }

  box(points) {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    points.forEach((x, i) => { low[i % 3] = Math.min(low[i % 3], x); high[i % 3] = Math.max(high[i % 3], x); });
    return {low, high};
  }

  show(k) {
    const piece = this.pieces[k], {points, unloaded} = piece;
    const changed = this.index !== k || !this.scene.viewName;
    this.index = k;
    const at = (n, c) => unloaded[3 * n + c] + this.factor * (points[3 * n + c] - unloaded[3 * n + c]);
    const {low, high} = this.box([...points, ...unloaded]);
    const largest = Math.max(...[0, 1, 2].map((c) => high[c] - low[c]));
    this.ribs.width = 0.008 * largest;
    this.ribs.thickness = 0.004 * largest;
    this.limit = piece.values ? Math.max(quantile(piece.values, 0.998), 1e-12) : 1;
    this.ribs.update(piece.lines, (n) => [0, 1, 2].map((c) => at(n, c)), (e) => (piece.values ? piece.values[e] : 0), this.limit);
    const corners = new Float32Array(3 * piece.lines.length);
    piece.lines.forEach((n, i) => corners.set(unloaded.subarray(3 * n, 3 * n + 3), 3 * i));
    this.outline.geometry.setAttribute("position", new THREE.BufferAttribute(corners, 3));
    this.scene.middle.set(...[0, 1, 2].map((c) => 0.5 * (low[c] + high[c])));
    this.scene.half.set(...[0, 1, 2].map((c) => Math.max(0.5 * (high[c] - low[c]), 0.02 * largest)));
    if (changed) this.scene.view(this.scene.viewName || "angle");
    const scale = () => legend(`${piece.field}, ${piece.name}`, "signed", signedNumbers(this.limit));
    fillLegends(piece.values ? [scale()] : []);
    this.scene.draw();
  }

  move() {} // a piece is small

  about() {
    return "Each step of the slider is a test in its last state, or a mode; the thin outline is the unloaded piece. Ribs are drawn with one width.";
  }
}

function pieceTools(replay) {
  const factor = element("select", {"aria-label": "displacements", onchange: () => {
    replay.factor = Number(factor.value);
    replay.show(replay.index);
  }}, ...[1, 3, 10, 30].map((times) => element("option", {value: times}, times === 1 ? "true displacements" : `displacements x ${times}`)));
  document.getElementById("tools").append(viewButtons(replay), element("span", {}, factor));
  tellKeys("Keys: ← → tests, Space plays, 1 2 3 0 views.");
  return viewKeys(replay);
}
