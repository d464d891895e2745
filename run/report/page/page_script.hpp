// Script that filters and sorts the answers. The page is complete without it.
#pragma once

#include <string_view>

namespace kusabi::run {

inline constexpr std::string_view page_script = R"(
"use strict";
(() => {
  const form = document.getElementById("controls");
  if (!form) return;
  const filter = document.getElementById("filter");
  const order = document.getElementById("order");
  const shown = document.getElementById("shown");
  const answers = [...document.querySelectorAll(".answer")].map(element => ({
    element,
    list: element.closest(".sorted"),
    rank: Number(element.dataset.rank),
    number: Number(element.dataset.number),
    size: Number(element.dataset.size),
    contact: JSON.parse(element.dataset.contact),
  }));
  const names = new Set([...document.querySelectorAll("#candidates option")].map(each => each.value));
  const first = document.querySelector("ul.sorted");
  const orders = {
    groups: (a, b) => a.rank - b.rank,
    rank: (a, b) => a.rank - b.rank,
    number: (a, b) => a.number - b.number,
    size: (a, b) => a.size - b.size || a.number - b.number,
  };
  // A complete name matches that candidate, any other text a part of names.
  const matches = (answer, wanted) => wanted === "" ||
    (names.has(wanted) ? answer.contact.includes(wanted) : answer.contact.some(name => name.includes(wanted)));
  const showCount = count => { shown.textContent = count + " of " + answers.length + " shown"; };
  const show = () => {
    let count = 0;
    for (const answer of answers) {
      answer.element.hidden = !matches(answer, filter.value.trim());
      if (!answer.element.hidden) ++count;
    }
    showCount(count);
  };
  const sort = () => {
    answers.sort(orders[order.value]);
    // In another order than by groups, all pictures are in the first group's list.
    const grouped = order.value === "groups";
    document.getElementById("answers").classList.toggle("ungrouped", !grouped);
    for (const answer of answers)
      (grouped || answer.list.tagName !== "UL" ? answer.list : first).append(answer.element);
  };
  filter.addEventListener("input", show);
  order.addEventListener("change", sort);
  form.addEventListener("submit", event => event.preventDefault());
  form.addEventListener("reset", () => setTimeout(() => { show(); sort(); }));
  form.hidden = false;
  show();

  // The choice puts the picture, the terms and the reactions of a card in the large view.
  const chosen = document.getElementById("chosen");
  const text = document.getElementById("leading-text");
  const figure = document.querySelector("#leading figure");
  if (!chosen || !figure || chosen.options.length < 2) return;
  // Each id is used once in a page.
  const copied = svg => {
    const copy = svg.cloneNode(true);
    for (const each of [copy, ...copy.querySelectorAll("[id]")]) each.id = "large-" + each.id;
    copy.setAttribute("aria-labelledby", copy.getAttribute("aria-labelledby").replace(/\S+/g, "large-$&"));
    return copy;
  };
  chosen.addEventListener("change", () => {
    const card = document.getElementById(chosen.value);
    const title = document.createElement("h2");
    title.textContent = card.querySelector("h3, h4").textContent;
    const parts = [...card.querySelectorAll(":scope > dl, :scope > details")].map(part => part.cloneNode(true));
    text.replaceChildren(title, ...parts, copied(card.querySelector(".legend svg")));
    const view = card.querySelector("[data-view]");
    figure.querySelector("svg.picture").replaceWith(copied(view.querySelector("svg")));
    figure.dispatchEvent(new CustomEvent("view", { detail: view.dataset.view }));
  });
  document.getElementById("choice").hidden = false;
})();
)";

}  // namespace kusabi::run
