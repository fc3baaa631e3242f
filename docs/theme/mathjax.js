MathJax.Hub.Config({
  messageStyle: "none",
  showMathMenu: false,
  SVG: { font: "TeX", scale: 95, linebreaks: { automatic: false } }
});
