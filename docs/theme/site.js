// What the course's pages do in the browser: sliders, and formulas that are wider than a phone.
"use strict";

// A slider's border stands where its range says; the range takes mouse, finger and keys.
function initSliders() {
  for (const slider of document.querySelectorAll("figure.slider")) {
    const range = slider.querySelector("input");
    const move = () => slider.style.setProperty("--at", range.value + "%");
    range.addEventListener("input", move);
    move();
  }
}

// A formula within a line that is wider than its column becomes a box of its own, which scrolls.
function markWideFormulas() {
  for (const formula of document.querySelectorAll(".MathJax_SVG")) {
    if (formula.closest(".MathJax_SVG_Display")) continue;
    const drawn = formula.querySelector("svg");
    const column = formula.closest("p, li, td, dd, .contents");
    if (drawn && column) formula.classList.toggle("wide", drawn.getBoundingClientRect().width > column.clientWidth);
  }
  // What scrolls has to be reached by keys as well.
  for (const box of document.querySelectorAll(".MathJax_SVG_Display, .MathJax_SVG.wide")) {
    if (box.scrollWidth > box.clientWidth) box.tabIndex = 0;
  }
}

document.addEventListener("DOMContentLoaded", () => {
  initSliders();
  if (typeof MathJax !== "undefined") MathJax.Hub.Queue(markWideFormulas);
});
window.addEventListener("resize", () => markWideFormulas());
