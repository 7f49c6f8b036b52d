// The replay: what is shown in which frame, how it is looked at, which stone was clicked.
class Replay {
  constructor(replay) {
    this.data = replay;
    this.frame = 0;
    this.selected = -1;
    const {low, high} = this.box();
    this.scene = new Scene(document.getElementById("view"), low, high);
    this.low = low;
    this.high = high;
    this.stones = new Stones(this.scene.scene, replay);
    this.longestWay = this.stones.longestWay();
    if (replay.contacts) this.contacts = new Contacts(this.scene.scene, replay);
    if (replay.geogrid) this.addRibs(replay.geogrid);
    this.stoneColours = Array.from({length: this.stones.count}, (_, i) => this.plain(i));
    this.stones.look("solid");
    this.byWay = false;
    this.cut = {axis: replay.walls.length > 1 ? "y" : "off", at: 0.5};
    this.listen();
    this.scene.resize();
    this.scene.view("angle");
  }

  // Of the stones and the ribs; of a heap 99 of 100 stones where they end, so that one that rolled away, or that falls
  // from far above, does not make all others small.
  box() {
    const places = unpack(this.data.stones.places), n = this.data.stones.ids.length, frames = this.data.times.length;
    const attitudes = unpack(this.data.stones.attitudes);
    const isHeap = this.data.walls.length <= 1, points = [], begin = isHeap ? n * (frames - 1) : 0;
    for (let i = begin; i < n * frames; i += Math.max(1, Math.floor((n * frames - begin) / 20000)))
      if (attitudes.subarray(4 * i, 4 * i + 4).some((q) => q !== 0)) points.push(place(this.data, places, i));
    const ends = [0, 1, 2].map((c) => points.map((p) => p[c]).sort((a, b) => a - b));
    const share = isHeap ? 0.01 : 0, margin = 0.35 * Math.max(...this.data.stones.mean_size);
    const low = ends.map((e) => e[Math.floor(share * e.length)] - margin);
    const high = ends.map((e) => e[Math.ceil((1 - share) * e.length) - 1] + margin);
    if (this.data.geogrid) {
      const ribs = unpack(this.data.geogrid.points);
      for (let i = 0; i < ribs.length / 3; ++i)
        place(this.data, ribs, i).forEach((x, c) => { low[c] = Math.min(low[c], x); high[c] = Math.max(high[c], x); });
    }
    this.reachWalls(low, high);
    return {low, high};
  }

  // Up to walls that are just outside.
  reachWalls(low, high) {
    const near = 0.05; // [m]
    for (const wall of this.data.walls)
      wall.corners[0].forEach((x, k) => {
        const c = k % 3;
        if (x < low[c] && x > low[c] - near) low[c] = x;
        if (x > high[c] && x < high[c] + near) high[c] = x;
      });
  }

  addRibs(geogrid) {
    this.lines = unpack(geogrid.lines);
    this.ribPlaces = unpack(geogrid.points);
    this.axial = unpack(geogrid.force);
    this.limit = quantile(this.axial, 0.998) || 1;
    this.ribs = new Ribs(this.scene.scene, this.lines.length / 2, geogrid.width, geogrid.thickness);
  }

  // Stones differ a little, so that one can tell them apart.
  plain(i) {
    const shade = 0.86 + 0.14 * (((this.data.stones.ids[i] * 2654435761) >>> 8) % 997) / 997;
    return channels(style("stone")).map((c, k) => c * shade * [1.03, 1, 0.96][k]);
  }

  isCut() {
    const {axis, at} = this.cut, c = "xyz".indexOf(axis);
    if (c < 0) return () => false;
    const level = this.low[c] + at * (this.high[c] - this.low[c]);
    return axis === "z" ? (x, y, z) => z > level : (x, y, z) => [x, y, z][c] < level;
  }

  update() {
    const frame = this.frame, isCut = this.isCut();
    const colour = this.byWay ? (i) => colourAt("way", this.stones.way(frame, i) / this.longestWay) : (i) => this.stoneColours[i];
    this.stones.update(frame, isCut, colour, this.scene.isSlow && this.isMoving);
    this.stones.select(this.selected, frame);
    if (this.contacts) this.contacts.update(frame, isCut);
    if (this.ribs) this.updateRibs(frame);
    if (this.data.walls.length) this.scene.setWalls(this.data.walls, frame);
    this.tellStone();
    this.scene.draw();
  }

  updateRibs(frame) {
    const nodes = this.ribPlaces.length / 3 / this.data.times.length, elements = this.lines.length / 2;
    this.ribs.update(this.lines, (n) => place(this.data, this.ribPlaces, frame * nodes + n),
                     (e) => this.axial[frame * elements + e], this.limit);
  }

  // Where pictures take long, stones are coarser as long as something moves.
  move(isMoving) {
    if (this.isMoving === isMoving) return;
    this.isMoving = isMoving;
    if (this.scene.isSlow) this.update();
  }

  show(frame) {
    this.frame = frame;
    this.update();
  }

  legends() {
    const list = [];
    if (this.ribs)
      list.push(legend("axial force in ribs [N], tension positive", "signed", signedNumbers(this.limit)));
    if (this.byWay && this.stones.mode !== "hidden")
      list.push(legend("way of the stone [mm]", "way", [0, 500 * this.longestWay, 1000 * this.longestWay].map(threeDigits)));
    if (this.contacts && this.contacts.mesh.visible)
      list.push(legend("contact force [N], by colour and thickness", "force",
                       [threeDigits(0), threeDigits(0.5 * this.contacts.reference), threeDigits(this.contacts.reference) + " and more"]));
    fillLegends(list);
  }

  // A click, not the end of a turn.
  listen() {
    const {canvas} = this.scene;
    let down = null;
    canvas.addEventListener("pointerdown", (event) => (down = [event.clientX, event.clientY]));
    canvas.addEventListener("pointerup", (event) => {
      if (!down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 5) return;
      const box = canvas.getBoundingClientRect();
      this.pick(event.clientX - box.left, event.clientY - box.top);
    });
    this.scene.controls.addEventListener("start", () => this.move(true));
    this.scene.controls.addEventListener("end", () => this.move(false));
    isDark.addEventListener("change", () => {
      this.stoneColours = this.stoneColours.map((_, i) => this.plain(i));
      this.legends();
      this.update();
    });
  }

  pick(x, y) {
    this.selected = this.stones.mode === "hidden" ? -1 : this.stones.hit(this.scene.ray(x, y), this.frame);
    this.update();
  }

  tellStone() {
    const box = document.getElementById("stone"), i = this.selected, {stones} = this.data;
    box.hidden = i < 0;
    if (i < 0) return;
    const shape = stones.shape[i], rows = [
      ["longest extent", `${threeDigits(1e3 * stones.longest[shape])} mm`],
      ["ball of its volume", `${threeDigits(1e3 * stones.mean_size[shape])} mm`],
      ["mass", `${threeDigits(1e3 * stones.mass[i])} g`]];
    if (this.contacts) {
      const [stone, wall, rib] = this.contacts.count(this.frame, i);
      rows.push(["contacts", `${stone + wall + rib}: ${stone} stones, ${wall} walls, ${rib} ribs`]);
    }
    rows.push(["way", `${threeDigits(1e3 * this.stones.way(this.frame, i))} mm`]);
    const what = stones.is_load[i] ? "Load" : "Stone";
    box.replaceChildren(element("b", {}, `${what} ${stones.ids[i]}`), ` (${stones.names[shape]})`, table(null, rows));
  }
}

// Milliseconds a picture, through all frames in even steps, waiting for the last pixel of each.
function measurePictures(replay, count) {
  const present = replay.frame, begin = performance.now();
  for (let k = 0; k < count; ++k) {
    replay.show(Math.floor((k * replay.data.times.length) / count));
    replay.scene.drawNow();
    replay.scene.finish();
  }
  const time = (performance.now() - begin) / count;
  replay.show(present);
  return time;
}
