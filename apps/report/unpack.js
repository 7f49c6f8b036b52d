// Numbers as apps/report_replay.py packs them: base64 of little-endian bytes, with their kind.
const KINDS = {u1: Uint8Array, u2: Uint16Array, u4: Uint32Array, i2: Int16Array, f4: Float32Array};

function unpack(packed) {
  const text = atob(packed.data), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return new KINDS[packed.kind](bytes.buffer);
}

// Places as whole steps (replay.low, replay.step) to metres.
function place(replay, steps, i) {
  return [0, 1, 2].map((c) => replay.low[c] + replay.step * steps[3 * i + c]);
}
