// Scales with their numbers, one box each.
function legend(title, scale, values) {
  return element("div", {class: "legend"}, title, element("i", {style: `background: ${gradient(scale)}`}),
                 element("div", {}, ...values.map((value) => element("span", {}, value))));
}

function fillLegends(list) {
  document.getElementById("legends").replaceChildren(...list);
}
