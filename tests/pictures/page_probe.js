// Probe of a page inside the browser, which reports its findings to the enclosing window.
"use strict";
const faults = [];
addEventListener("error", event => faults.push(event.message));
addEventListener("securitypolicyviolation", event => faults.push("refused: " + event.violatedDirective));

const shown = element => element.checkVisibility({ visibilityProperty: true });
const who = element => element.tagName.toLowerCase() + (element.id ? "#" + element.id : "") +
  (element.getAttribute("class") ? "." + element.getAttribute("class") : "");

// WCAG 2.1: relative luminance and contrast ratio of two colours in sRGB.
const parts = colour => {
  const [r, g, b, a = 1] = colour.match(/[\d.]+/g).map(Number);
  return { light: [r, g, b].map(c => c / 255).map(c => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4), a };
};
const luminance = ({ light: [r, g, b] }) => 0.2126 * r + 0.7152 * g + 0.0722 * b;
const background = element => {
  for (let each = element; each; each = each.parentElement) {
    const colour = parts(getComputedStyle(each).backgroundColor);
    if (colour.a > 0) return colour;
  }
  return parts("rgb(255, 255, 255)");
};
const contrast = element => {
  const style = getComputedStyle(element);
  const ink = luminance(parts(element.namespaceURI.endsWith("svg") ? style.fill : style.color));
  const paper = luminance(background(element));
  return (Math.max(ink, paper) + 0.05) / (Math.min(ink, paper) + 0.05);
};
const worst_contrast = () => {
  let worst = { ratio: 21, of: "" };
  for (const element of document.body.querySelectorAll("*")) {
    const words = [...element.childNodes].some(node => node.nodeType === 3 && node.data.trim() !== "");
    if (!words || ["SCRIPT", "title", "desc", "OPTION"].includes(element.tagName) || !shown(element)) continue;
    const ratio = contrast(element);
    if (ratio < worst.ratio) worst = { ratio, of: who(element) };
  }
  return worst;
};

// Height of the smallest letters of pictures, in pixels of the screen.
const smallest_letters = () => {
  let smallest = { height: Infinity, of: "" };
  for (const text of document.querySelectorAll("svg.picture text")) {
    const height = shown(text) ? parseFloat(getComputedStyle(text).fontSize) * text.getScreenCTM().a : Infinity;
    if (height < smallest.height) smallest = { height, of: who(text.closest("svg")) + " " + text.textContent };
  }
  return smallest;
};

// Interactive elements: each has a name and can have the keyboard focus.
const controls = () => [...document.querySelectorAll("input, select, button, summary, a[href], [tabindex]")].filter(shown);
const name_of = element => (element.getAttribute("aria-label") || [...(element.labels || [])].map(each => each.textContent).join() ||
  (["BUTTON", "SUMMARY", "A"].includes(element.tagName) ? element.textContent : "")).trim();
const out_of_reach = () => {
  const wrong = controls().filter(each => name_of(each) === "").map(each => who(each) + " has no name");
  const scrolled = [...document.querySelectorAll(".scroll")].filter(shown).filter(each => each.scrollWidth > each.clientWidth + 1);
  for (const element of [...controls(), ...scrolled]) {
    element.focus();
    if (document.activeElement !== element || element.tabIndex < 0) wrong.push(who(element) + " takes no focus");
  }
  return wrong;
};

// Types the name of the first candidate; then chooses the last order, by the size of contact.
const work_with_the_gallery = () => {
  const form = document.getElementById("controls");
  if (!form) return null;
  const answers = () => [...document.querySelectorAll(".answer")];
  const [filter, order, count] = ["filter", "order", "shown"].map(id => document.getElementById(id));
  const said = [count.textContent];
  filter.value = document.querySelector("#candidates option").value;
  filter.dispatchEvent(new Event("input"));
  const found = answers().filter(shown);
  said.push(count.textContent);
  const right = found.every(each => JSON.parse(each.dataset.contact).includes(filter.value));
  order.selectedIndex = order.options.length - 1;
  order.dispatchEvent(new Event("change"));
  const sizes = [...document.querySelectorAll(".gallery .answer")].map(each => Number(each.dataset.size));
  const sorted = sizes.every((size, i) => i === 0 || sizes[i - 1] <= size);
  return { said, found: found.length, right, sorted };
};

// Share of the canvas that is drawn on, and whether an arrow key has turned the view since.
let first_view = null;
addEventListener("load", () => {
  const canvas = document.querySelector("figure canvas");
  if (!canvas) return;
  first_view = canvas.toDataURL();
  canvas.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft" }));
});
const turned_view = () => {
  const canvas = document.querySelector("figure canvas");
  if (!canvas) return null;
  const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  const drawn = data.reduce((sum, value, i) => sum + (i % 4 === 3 && value > 0 ? 1 : 0), 0) / (data.length / 4);
  return { drawn, turned: canvas.toDataURL() !== first_view, picture: shown(document.querySelector("figure svg")) };
};

const look = () => {
  const width = () => document.documentElement.scrollWidth;
  const seen = { title: document.title, faults, inner: innerWidth, closed: width(), elements: document.getElementsByTagName("*").length,
    dark: matchMedia("(prefers-color-scheme: dark)").matches, paper: getComputedStyle(document.body).backgroundColor,
    controls: !!document.getElementById("controls") && shown(document.getElementById("controls")),
    folded: [...document.querySelectorAll("details:not([open])")].filter(shown).length };
  if (document.documentElement.dataset.look === "briefly") return { ...seen, gallery: work_with_the_gallery() };
  for (const each of document.querySelectorAll("details")) each.open = true;
  return { ...seen, open: width(), turning: turned_view(), contrast: worst_contrast(), letters: smallest_letters(), reach: out_of_reach(), gallery: work_with_the_gallery() };
};
addEventListener("load", () => setTimeout(() => {
  let found;
  try {
    found = look();
  } catch (error) {
    found = { title: document.title, faults: [...faults, String(error)] };
  }
  parent.postMessage(found, "*");
}, 100));
