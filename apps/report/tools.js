// Buttons above the slider, and what keys do to the replay.
function button(text, title, action) {
  return element("button", {title, onclick: action}, text);
}

const VIEWS = [["1", "side"], ["2", "front"], ["3", "top"], ["0", "angle"]];

function viewButtons(replay) {
  return element("span", {}, ...VIEWS.map(([key, name]) => button(name, `key ${key}`, () => replay.scene.view(name))));
}

const viewKeys = (replay) => Object.fromEntries(VIEWS.map(([key, name]) => [key, () => replay.scene.view(name)]));

function tellKeys(text) {
  document.getElementById("help").textContent = text;
}

function stoneTools(replay) {
  tellKeys("Click a stone for its numbers. Keys: ← → frames, Space plays, 1 2 3 0 views, S stones, W way, C forces, " +
           "K cut; all of them below.");
  const modes = ["solid", "faint", "hidden"];
  const press = (node, on) => node.setAttribute("aria-pressed", on);
  const refresh = () => { replay.legends(); replay.update(); };
  const stones = button("", "key S", () => {
    replay.stones.look(modes[(modes.indexOf(replay.stones.mode) + 1) % 3]);
    tell();
  });
  const way = button("way of stones", "key W", () => { replay.byWay = !replay.byWay; tell(); });
  const forces = button("contact forces", "key C", () => {
    const {mesh} = replay.contacts;
    mesh.visible = !mesh.visible;
    if (mesh.visible === (replay.stones.mode === "solid")) replay.stones.look(mesh.visible ? "faint" : "solid");
    tell();
  });
  const axis = element("select", {"aria-label": "cut across", onchange: () => { replay.cut.axis = axis.value; refresh(); }},
    ...[["off", "no cut"], ["x", "cut across x"], ["y", "cut across y"], ["z", "cut across z"]].map(([value, text]) =>
      element("option", {value}, text)));
  const at = element("input", {type: "range", min: 0, max: 1, step: 0.02, value: replay.cut.at, "aria-label": "place of the cut",
                               oninput: () => { replay.cut.at = Number(at.value); refresh(); }});
  const move = (by) => { at.value = Number(at.value) + by; replay.cut.at = Number(at.value); refresh(); };
  let last = "y";
  const cut = () => {
    if (replay.cut.axis !== "off") last = replay.cut.axis;
    axis.value = replay.cut.axis = replay.cut.axis === "off" ? last : "off";
    refresh();
  };

  function tell() {
    stones.textContent = `stones: ${replay.stones.mode}`;
    press(way, replay.byWay);
    if (replay.contacts) press(forces, replay.contacts.mesh.visible);
    refresh();
  }

  axis.value = replay.cut.axis;
  document.getElementById("tools").append(viewButtons(replay), element("span", {}, stones, way, ...(replay.contacts ? [forces] : [])),
                                          element("span", {}, axis, at));
  tell();
  return {...viewKeys(replay), s: () => stones.click(), w: () => way.click(), c: () => replay.contacts && forces.click(),
          k: cut, "[": () => move(-0.02), "]": () => move(0.02),
          Escape: () => { replay.selected = -1; replay.update(); }};
}
