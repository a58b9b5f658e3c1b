// Elements of the page. Text from a file is only ever a text node here: no file can make an element.
"use strict";

const $ = (id) => document.getElementById(id);

/** An element with properties and children; a child that is text becomes a text node. */
function make(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name in element) element[name] = value;
    else element.setAttribute(name, value);
  }
  element.append(...children.filter((child) => child !== null));
  return element;
}

/** A button; what fails is said. */
function button(text, act, properties = {}) {
  const onclick = () => Promise.resolve(act()).catch((error) => say(error.message));
  return make("button", { type: "button", onclick, ...properties }, text);
}

function fill(element, ...children) {
  element.replaceChildren(...children);
}

const shownParts = new Map();

/** Whether a part of the page shows this already; from then on it does. Elements that need not change keep the focus. */
function isShown(part, what) {
  const text = JSON.stringify(what);
  const is = shownParts.get(part) === text;
  shownParts.set(part, text);
  return is;
}

/** A table: a head, and rows of cells. */
function table(head, rows) {
  const cells = (tag, row) => make("tr", {}, ...row.map((cell) => make(tag, {}, cell ?? "")));
  return make("table", {}, make("thead", {}, cells("th", head)), make("tbody", {}, ...rows.map((row) => cells("td", row))));
}

/** Options of a select; keeps the choice where it still exists. */
function options(select, names, chosen = select.value) {
  fill(select, ...names.map((name) => make("option", { value: name }, name)));
  if (names.includes(chosen)) select.value = chosen;
}

/** A picture as an image: what is in it cannot act. */
function picture(svg, alt) {
  const image = make("img", { alt, src: URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" })) });
  image.onload = () => URL.revokeObjectURL(image.src);
  return image;
}

function pre(text, label) {
  return make("pre", { tabIndex: 0, role: "region", "aria-label": label }, text);
}

/** Saves bytes as a file of the user. */
function download(name, bytes, type = "application/octet-stream") {
  const link = make("a", { download: name, href: URL.createObjectURL(new Blob([bytes], { type })) });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/** A number with as many digits as a person sets. */
function shown(value) {
  return value === null || value === undefined ? "" : String(Number(value.toPrecision(4)));
}
