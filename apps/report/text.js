// The words and tables of the page.
function element(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes))
    name.startsWith("on") ? node.addEventListener(name.slice(2), value) : node.setAttribute(name, value);
  node.append(...children);
  return node;
}

// Columns whose name is in `numbers` stand to the right.
function table(head, rows, numbers = []) {
  const cell = (tag, content, c) => element(tag, numbers.includes(c) ? {class: "number"} : {}, content);
  const body = rows.map((row) => element("tr", {}, ...row.map((content, c) => cell("td", content, c))));
  const top = head ? [element("tr", {}, ...head.map((name, c) => cell("th", name, c)))] : [];
  return element("table", {}, ...top, ...body);
}

function card(title, ...content) {
  return element("div", {class: "card"}, element("h2", {}, title), ...content);
}

const folded = (title, text) => element("details", {class: "card wide"}, element("summary", {}, title), element("pre", {}, text));

const withUnit = ([name, value, unit]) => [name, `${value} ${unit}`];

function fillHead(data) {
  const count = data.warnings.length;
  const numbers = data.main.map(([name, value, unit]) =>
    element("div", {}, element("b", {}, `${value} ${unit}`), element("span", {}, name)));
  document.getElementById("head").append(
    element("h1", {}, data.title), element("p", {}, data.state),
    ...(data.not_usable ? [element("p", {class: "warning"}, data.not_usable)] : []),
    ...(count ? [element("p", {}, element("a", {href: "#warnings"}, `${count} warning${count > 1 ? "s" : ""}, below`))] : []),
    element("div", {class: "numbers"}, ...numbers));
}

function fillTexts(data) {
  const cards = [...(data.cards || []).map((each) => {
    const node = card(each.title, tableOf(each));
    if (each.wide) node.classList.add("wide");
    return node;
  })];
  if (data.warnings.length)
    cards.push(card(element("span", {id: "warnings"}, "Warnings"), ...data.warnings.map((text) => element("p", {class: "warning"}, text))));
  if (data.results.length) cards.push(card("Results", element("div", {class: "scroll"}, table(null, data.results.map(withUnit), [1]))));
  if (data.energy.length)
    cards.push(card("Energy ledger at the end", element("div", {class: "scroll"}, table(null, data.energy.map(withUnit), [1]))));
  if (data.stages.length)
    cards.push(card("Stages", table(["stage", "simulated time", "steps", "took"], data.stages, [1, 2, 3])));
  if (data.identity.length) cards.push(card("This run", table(null, data.identity)));
  if (data.cite) cards.push(card("How to cite", element("p", {}, data.cite)));
  if (!("missing" in data.replay)) cards.push(card("Keys", keyHelp(data.replay.pieces ? KEYS.slice(0, 4) : KEYS)));
  if (data.inputs) cards.push(folded("Inputs (used.prm)", data.inputs));
  if (data.log) cards.push(folded("Log (run.log)", data.log));
  if (data.citation_file) cards.push(folded("CITATION.cff", data.citation_file));
  document.getElementById("texts").append(...cards);
}

// A table of a study; a cell {text, link} leads to the page of a run.
function tableOf(each) {
  const cell = (content) => (content !== null && typeof content === "object" ? element("a", {href: content.link}, content.text) : content);
  const box = element("div", {class: "scroll"}, table(each.head, each.rows.map((row) => row.map(cell)), each.numbers));
  if (each.note) box.prepend(element("p", {class: "note"}, each.note));
  return box;
}

const KEYS = [
  ["← →", "one frame back or on; with Shift ten"], ["Home End", "first, last frame"], ["Space", "play or stop"],
  ["1 2 3 0", "from the side, the front, the top; at an angle"], ["S", "stones solid, faint, hidden"],
  ["W", "stones by the way they went"], ["C", "contact forces"], ["K", "cut on or off"], ["[ ]", "move the cut"],
  ["Esc", "let go of the stone"]];

function keyHelp(keys) {
  return table(null, keys.map(([keys, what]) =>
    [element("span", {}, ...keys.split(" ").flatMap((key) => [element("kbd", {}, key), " "])), what]));
}
