MathJax.Hub.Config({
  messageStyle: "none",
  showMathMenu: false,
  SVG: { font: "TeX", scale: 90, linebreaks: { automatic: false } }
});
