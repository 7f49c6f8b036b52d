// Curves with Chart.js, each with a line where the slider is.
const allCharts = [];

// The time of the slider as a place on x, between the records around it.
function placeAt(chart, time) {
  const times = chart.time;
  if (!times) return null;
  let low = 0, high = times.length - 1;
  if (time <= times[low]) return chart.place[low];
  if (time >= times[high]) return chart.place[high];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    times[middle] <= time ? (low = middle) : (high = middle);
  }
  const share = (time - times[low]) / (times[high] - times[low]);
  return chart.place[low] + share * (chart.place[high] - chart.place[low]);
}

const colourOf = (name) => (name === "ink" ? style("ink") : name);

// Lines in the legend are dashed as in the chart.
function labels(chart) {
  return Chart.defaults.plugins.legend.labels.generateLabels(chart)
    .filter((label) => !chart.data.datasets[label.datasetIndex].isQuiet)
    .map((label) => {
      const {borderDash, borderWidth} = chart.data.datasets[label.datasetIndex];
      return {...label, lineDash: borderDash, lineWidth: borderWidth};
    });
}

function dataset(series) {
  return {
    label: series.label, isQuiet: series.quiet, borderColor: colourOf(series.colour), backgroundColor: colourOf(series.colour),
    borderWidth: series.width, borderDash: series.dash, pointRadius: series.points ? 5 : 0, pointHitRadius: 6,
    pointStyle: series.points ? "rectRot" : "line", showLine: !series.points,
    data: series.x.map((x, i) => ({x, y: series.y[i]})),
  };
}

// Grey and hatched from where on a result is not to be used; the slider's line.
const marks = {
  id: "marks",
  beforeDatasetsDraw({ctx, chartArea: area, scales, unusableFrom: from}) {
    if (from === undefined || from > scales.x.max) return;
    const left = Math.max(area.left, scales.x.getPixelForValue(from));
    ctx.save();
    ctx.beginPath();
    ctx.rect(left, area.top, area.right - left, area.bottom - area.top);
    ctx.clip();
    ctx.globalAlpha = 0.08;
    ctx.fillStyle = ctx.strokeStyle = style("ink");
    ctx.fillRect(left, area.top, area.right - left, area.bottom - area.top);
    ctx.globalAlpha = 0.25;
    for (let x = left - area.bottom; x < area.right; x += 10) {
      ctx.beginPath();
      ctx.moveTo(x, area.bottom);
      ctx.lineTo(x + area.bottom - area.top, area.top);
      ctx.stroke();
    }
    ctx.restore();
  },
  afterDatasetsDraw({ctx, chartArea: area, scales, sliderAt: at}) {
    if (at === null || at === undefined) return;
    const x = scales.x.getPixelForValue(at);
    ctx.save();
    ctx.strokeStyle = style("accent");
    ctx.lineWidth = 1.5;
    ctx.beginPath();
    ctx.moveTo(x, area.top);
    ctx.lineTo(x, area.bottom);
    ctx.stroke();
    ctx.restore();
  },
};

function axis(text) {
  const faint = style("faint");
  return {type: "linear", title: {display: true, text, color: faint}, ticks: {color: faint, maxRotation: 0, autoSkipPadding: 12},
          grid: {color: style("grid")}};
}

// `goTo(chart, x)` is called where a curve is clicked.
function drawChart(chart, parent, goTo) {
  const canvas = element("canvas", {role: "img", "aria-label": `${chart.title}: ${chart.y} over ${chart.x}`});
  const note = chart.note ? [element("p", {class: "note"}, chart.note)] : [];
  const hatched = () => `Hatched from ${threeDigits(chart.from)} on, not to be used: ${chart.why}`;
  const why = chart.from === undefined ? note : [element("p", {class: "note"}, hatched())];
  parent.append(element("div", {class: "chart"}, element("h2", {}, chart.title), element("div", {}, canvas), ...why));
  const options = {
    onClick: (event, _, drawn) => chart.time && goTo(chart, drawn.scales.x.getValueForPixel(event.x)),
    animation: false, maintainAspectRatio: false, parsing: false, normalized: true,
    interaction: {mode: "nearest", axis: "x", intersect: false},
    scales: {x: axis(chart.x), y: axis(chart.y)},
    plugins: {
      legend: {display: chart.series.length > 1, labels: {generateLabels: labels,
        color: style("ink"), usePointStyle: true, pointStyleWidth: 36, boxHeight: 6, font: {size: 11}}},
      tooltip: {callbacks: {title: (items) => `${chart.x}: ${threeDigits(items[0].parsed.x)}`,
                            label: (item) => `${item.dataset.label}: ${threeDigits(item.parsed.y)}`}},
    },
  };
  chart.drawn = new Chart(canvas, {type: "line", data: {datasets: chart.series.map(dataset)}, options, plugins: [marks]});
  chart.drawn.unusableFrom = chart.from;
  chart.drawn.draw();
  allCharts.push(chart);
}

// Anew where they are there already: in other colours.
function fillCharts(data, goTo) {
  const parent = document.getElementById("charts");
  if (data.no_charts) return parent.replaceChildren(element("p", {class: "warning"}, data.no_charts));
  for (const chart of allCharts.splice(0)) chart.drawn.destroy();
  parent.replaceChildren();
  Chart.defaults.font.family = getComputedStyle(document.body).fontFamily;
  for (const chart of data.charts) drawChart(chart, parent, goTo);
}

function markTime(time) {
  for (const chart of allCharts) {
    chart.drawn.sliderAt = placeAt(chart, time);
    chart.drawn.draw();
  }
}
