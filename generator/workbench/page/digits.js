// Bytes as text: five digits of base 85 for four bytes, a sixteenth less than base64. No digit means anything in HTML. The first
// character is the number of bytes at the end that are none. Also read by assemble.mjs, and by tests/workbench.
"use strict";

const DIGITS = Array.from({ length: 92 }, (_, n) => String.fromCharCode(35 + n)).filter((letter) => !"&'<\\`".includes(letter)).slice(0, 85);

function bytesOf(text) {
  const digits = new Uint8Array(128);
  DIGITS.forEach((letter, n) => (digits[letter.charCodeAt(0)] = n));
  const bytes = new DataView(new ArrayBuffer(((text.length - 1) / 5) * 4));
  for (let at = 0; at < bytes.byteLength; at += 4) {
    let value = 0;
    for (let n = 1; n <= 5; n += 1) value = value * 85 + digits[text.charCodeAt((at / 4) * 5 + n)];
    bytes.setUint32(at, value);
  }
  return new Uint8Array(bytes.buffer, 0, bytes.byteLength - Number(text[0]));
}

function textOf(bytes) {
  const none = (4 - (bytes.length % 4)) % 4;
  const view = new DataView(new ArrayBuffer(bytes.length + none));
  new Uint8Array(view.buffer).set(bytes);
  let text = String(none);
  for (let at = 0; at < view.byteLength; at += 4) {
    let value = view.getUint32(at);
    let group = "";
    for (let n = 0; n < 5; n += 1) {
      group = DIGITS[value % 85] + group;
      value = Math.floor(value / 85);
    }
    text += group;
  }
  return text;
}
