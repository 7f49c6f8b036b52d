// The page: texts, curves, replay, and the slider that joins them.
const data = JSON.parse(document.getElementById("data").textContent);

function startReplay() {
  if ("missing" in data.replay) return null;
  try {
    return data.replay.pieces ? new Pieces(data.replay) : new Replay(data.replay);
  } catch (error) {
    data.replay.missing = `The replay needs WebGL, which this browser does not offer (${error.message}).`;
    return null;
  }
}

fillHead(data);
const replay = startReplay();
const about = document.getElementById("about");
if (replay) {
  about.textContent = replay.about ? replay.about() : data.replay.surfaces;
} else {
  document.getElementById("replay").classList.add("empty");
  about.replaceWith(...(data.replay.missing ? [element("p", {class: "warning"}, "No replay: " + data.replay.missing)] : []));
}

// The slider goes through frames where there are any, else through 200 times of the history.
const moments = replay ? data.replay.times : data.times ? Array.from({length: 201}, (_, k) =>
  data.times[0] + (k / 200) * (data.times[data.times.length - 1] - data.times[0])) : [];
const slider = document.getElementById("slider"), output = document.getElementById("now"), play = document.getElementById("play");
let playing = 0;

// What the curves are drawn over, the time, the frame.
function nowText(k) {
  if (data.replay.pieces) return data.replay.pieces[k].name;
  const lead = data.charts.find((chart) => chart.time && chart.x !== "time [s]");
  const unit = lead && lead.x.match(/\[(.*)\]/)[1];
  const place = lead ? `${placeAt(lead, moments[k]).toFixed(1)} ${unit} · ` : "";
  return `${place}${moments[k].toFixed(3)} s${replay ? ` · frame ${k + 1} of ${moments.length}` : ""}`;
}

function show(k) {
  if (!moments.length) return;
  slider.value = Math.min(Math.max(k, 0), moments.length - 1);
  const at = Number(slider.value);
  output.textContent = nowText(at);
  slider.setAttribute("aria-valuetext", output.textContent);
  if (replay) replay.show(at);
  if (window.Chart) markTime(moments[at]);
}

// The frame that belongs to a place on a curve.
function showPlace(chart, x) {
  const ways = moments.map((time) => Math.abs(placeAt(chart, time) - x));
  stop();
  show(ways.indexOf(Math.min(...ways)));
}

function stop() {
  clearInterval(playing);
  playing = 0;
  play.textContent = "▶";
  if (replay) replay.move(false);
}

function playOrStop() {
  if (playing) return stop();
  if (Number(slider.value) >= moments.length - 1) show(0);
  play.textContent = "❚❚";
  if (replay) replay.move(true);
  playing = setInterval(() => (Number(slider.value) < moments.length - 1 ? show(Number(slider.value) + 1) : stop()), 80);
}

const tools = replay && !data.replay.pieces ? stoneTools(replay) : replay ? pieceTools(replay) : {};

function key(event) {
  const isOn = (what) => event.target instanceof Element && event.target.matches(what);
  if (isOn("select, summary, #tools input") || event.ctrlKey || event.metaKey || event.altKey) return;
  const at = Number(slider.value), step = event.shiftKey ? 10 : 1;
  const actions = {ArrowRight: () => show(at + step), ArrowLeft: () => show(at - step), Home: () => show(0),
                   End: () => show(moments.length - 1), " ": playOrStop, ...tools};
  const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
  if (!action || (event.key === " " && isOn("button"))) return;
  action();
  event.preventDefault();
}

document.addEventListener("keydown", key);
slider.max = Math.max(0, moments.length - 1);
slider.addEventListener("input", () => {
  stop();
  if (replay) replay.move(true);
  show(Number(slider.value));
});
slider.addEventListener("change", () => replay && replay.move(false));
play.addEventListener("click", playOrStop);
if (!moments.length) document.getElementById("bar").hidden = true;
window.report = {data, replay, show, moments, measurePictures};
show(replay && !data.replay.pieces ? moments.length - 1 : 0);
if (replay) {
  replay.scene.drawNow();
  replay.scene.finish();
  window.report.firstPicture = performance.now(); // since the page was asked for [ms]
}
// After the first picture: curves take as long as it does.
setTimeout(() => {
  fillTexts(data);
  const drawCharts = () => { fillCharts(data, showPlace); show(Number(slider.value)); };
  drawCharts();
  isDark.addEventListener("change", drawCharts);
  window.isComplete = true;
}, 0);
