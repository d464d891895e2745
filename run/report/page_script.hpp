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
    number: Number(element.dataset.number),
    value: element.dataset.order === "" ? null : Number(element.dataset.order),
    size: Number(element.dataset.size),
    contact: JSON.parse(element.dataset.contact),
  }));
  const names = new Set([...document.querySelectorAll("#candidates option")].map(each => each.value));
  // Answers without a margin or coefficient come last in both orders.
  const byValue = way => (a, b) =>
    (a.value === null) - (b.value === null) || way * (a.value - b.value) || a.number - b.number;
  const orders = {
    number: (a, b) => a.number - b.number,
    margin: byValue(-1),
    friction: byValue(1),
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
    for (const answer of answers) answer.list.append(answer.element);
  };
  filter.addEventListener("input", show);
  order.addEventListener("change", sort);
  form.addEventListener("submit", event => event.preventDefault());
  form.addEventListener("reset", () => setTimeout(() => { show(); sort(); }));
  form.hidden = false;
  show();
})();
)";

}  // namespace kusabi::run
