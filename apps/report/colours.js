// Colours from the style sheet, and scales that colour-blind readers can tell apart.
const style = (name) => getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();

const SCALES = {
  // Cividis: Nunez, Anderton and Renslow, PLOS ONE 13 (2018) e0199239.
  way: ["#00224e", "#123570", "#3b496c", "#575d6d", "#707173", "#8a8678", "#a59c74", "#c3b369", "#e1cc55", "#fee838"],
  // Plasma of Matplotlib, without its dark end; what is strong stands out from light and from dark paper.
  force: ["#7e03a8", "#a82296", "#cb4679", "#e56b5d", "#f89441", "#fdc328", "#f0f921"],
  // Blue and orange, light where there is nothing.
  signed: ["#1446a0", "#3f7fd0", "#96b9e0", "#d3cfc7", "#f3b26b", "#e8761c", "#a83c00"],
};

function channels(hex) {
  return [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255);
}

const isDark = matchMedia("(prefers-color-scheme: dark)");
const stopsOf = (scale) => (scale === "force" && !isDark.matches ? [...SCALES.force].reverse() : SCALES[scale]);

// Between 0 and 1: red, green, blue.
function colourAt(scale, t) {
  const stops = stopsOf(scale), at = Math.min(Math.max(t, 0), 1) * (stops.length - 1);
  const k = Math.min(Math.floor(at), stops.length - 2);
  const [a, b] = [channels(stops[k]), channels(stops[k + 1])];
  return a.map((value, c) => value + (b[c] - value) * (at - k));
}

const gradient = (scale) => `linear-gradient(to right, ${stopsOf(scale).join(", ")})`;

// A number with three digits, without an exponent where one can read it.
function threeDigits(value) {
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-3) return value.toExponential(1);
  return String(Number(value.toPrecision(3)));
}

// The value below which this share of the sizes of numbers lies; of many, a part is looked at.
function quantile(values, share) {
  const step = Math.ceil(values.length / 20000), sizes = [];
  for (let i = 0; i < values.length; i += step) sizes.push(Math.abs(values[i]));
  sizes.sort((a, b) => a - b);
  return sizes[Math.min(sizes.length - 1, Math.floor(share * sizes.length))] || 0;
}

// From -1 to 1 to a place on the signed scale: by the root, since few ribs bear most of the force.
const signedShare = (share) => 0.5 + 0.5 * Math.sign(share) * Math.sqrt(Math.min(Math.abs(share), 1));
const signedNumbers = (limit) => [-limit, -limit / 4, 0, limit / 4, limit].map(threeDigits);
