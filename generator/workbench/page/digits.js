// Bytes as text: two digits of base 91 for 13 bits, a thirteenth less than base64. No digit begins an element. The number of
// bytes stands in front. Also read by assemble.mjs, and by tests/workbench.
"use strict";

const DIGITS = Array.from({ length: 94 }, (_, n) => String.fromCharCode(33 + n)).filter((letter) => letter !== "<").slice(0, 91);

function bytesOf(text) {
  const digits = new Uint8Array(128);
  DIGITS.forEach((letter, n) => (digits[letter.charCodeAt(0)] = n));
  const from = text.indexOf(" ") + 1;
  const bytes = new Uint8Array(Number(text.slice(0, from)));
  let [at, bits, count] = [0, 0, 0];
  for (let n = from; n < text.length; n += 2) {
    bits |= (digits[text.charCodeAt(n)] + 91 * digits[text.charCodeAt(n + 1)]) << count;
    for (count += 13; count >= 8 && at < bytes.length; count -= 8) {
      bytes[at++] = bits & 255;
      bits >>>= 8;
    }
  }
  return bytes;
}

function textOf(bytes) {
  const text = [`${bytes.length} `];
  const put = (value) => text.push(DIGITS[value % 91], DIGITS[Math.floor(value / 91)]);
  let [bits, count] = [0, 0];
  for (const byte of bytes) {
    bits |= byte << count;
    count += 8;
    if (count < 13) continue;
    put(bits & 8191);
    bits >>>= 13;
    count -= 13;
  }
  put(bits);
  return text.join("");
}
