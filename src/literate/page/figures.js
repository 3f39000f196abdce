// SPDX-License-Identifier: GPL-3.0-or-later
// Figures that can be pointed at: the nearest point of a curve is marked and its numbers are told, by the pointer, a touch
// or the arrow keys. What gnuplot drew stays as it is below.

/// The margin around a drawing, for labels beyond its frame: 9 points in figures.tex.
const drawingMargin = 9 * 96 / 72;

/// Where a number stands on an axis, as a share of the frame.
function shareOf(axis, number) {
  const at = axis.log ? Math.log : (x) => x;
  return (at(number) - at(axis.start)) / (at(axis.end) - at(axis.start));
}

/// The points of the panels with their places, as shares of the drawing from the left and from above.
function pointsOf(panels) {
  const points = [];
  for (const panel of panels) {
    const [left, right, bottom, top] = panel.frame;
    panel.curves.forEach((curve, k) => {
      for (let i = 0; i < curve.points.length; i += 2) {
        const x = curve.points[i], y = curve.points[i + 1];
        points.push({panel, curve, k, x, y, across: left + (right - left) * shareOf(panel.x, x),
                     down: 1 - bottom - (top - bottom) * shareOf(panel.y, y)});
      }
    });
  }
  return points.filter(({across, down}) => Number.isFinite(across) && Number.isFinite(down));
}

/// «eq. (3): x: 0.01, u: −1.2 × 10⁻⁷»
function readingOf({panel, curve, x, y}) {
  const told = (label, number) => `${label}: ${lit.number(String(Number(number.toPrecision(5))))}`;
  return `${curve.title ? curve.title + ": " : ""}${told(panel.x.label || "x", x)}, ${told(panel.y.label || "y", y)}`;
}

const svgNames = "http://www.w3.org/2000/svg";
function svg(name, attributes = {}) {
  const made = document.createElementNS(svgNames, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

function makePointable(image, panels) {
  const points = pointsOf(panels);
  if (points.length === 0) return;
  const box = lit.make("span", {class: "lit-pointed", tabindex: "0", role: "slider", "aria-valuemin": "1",
    "aria-valuemax": String(points.length), "aria-valuenow": "1", "aria-valuetext": readingOf(points[0]),
    "aria-label": "Read off the figure: arrow keys go from point to point"});
  const overlay = svg("svg", {"aria-hidden": "true"});
  const cross = [svg("line"), svg("line")];
  const ring = svg("circle", {r: "5"});
  overlay.append(...cross, ring);
  overlay.style.visibility = "hidden";
  const reading = lit.make("p", {class: "lit-reading"}, "\u00a0");
  image.replaceWith(box);
  box.append(image, overlay);
  box.after(reading);
  let at = -1;

  // Lays the overlay upon the drawing's frame, once the image has its size, and says where that is.
  function frame() {
    const across = 100 * drawingMargin / image.naturalWidth, down = 100 * drawingMargin / image.naturalHeight;
    Object.assign(overlay.style, {left: `${across}%`, top: `${down}%`, width: `${100 - 2 * across}%`, height: `${100 - 2 * down}%`});
    return overlay.getBoundingClientRect();
  }

  function mark(i) {
    at = i;
    const {width, height} = frame();
    const {panel, across, down} = points[i];
    const [left, right, bottom, top] = panel.frame;
    const place = (line, x1, y1, x2, y2) => Object.entries({x1: x1 * width, y1: y1 * height, x2: x2 * width, y2: y2 * height})
      .forEach(([key, value]) => line.setAttribute(key, value));
    place(cross[0], across, 1 - top, across, 1 - bottom);
    place(cross[1], left, down, right, down);
    ring.setAttribute("cx", across * width);
    ring.setAttribute("cy", down * height);
    overlay.style.visibility = "visible";
    reading.textContent = readingOf(points[i]);
    box.setAttribute("aria-valuenow", String(i + 1));
    box.setAttribute("aria-valuetext", reading.textContent);
  }
  function leave() {
    overlay.style.visibility = "hidden";
    reading.textContent = "\u00a0";
  }
  // The nearest point to the pointer, if the pointer is near one.
  function point(event) {
    const {left, top, width, height} = frame();
    const x = event.clientX - left, y = event.clientY - top;
    let nearest = -1, least = 60;
    points.forEach(({across, down}, i) => {
      const distance = Math.hypot(across * width - x, down * height - y);
      if (distance < least) [nearest, least] = [i, distance];
    });
    if (nearest >= 0) mark(nearest);
    else leave();
  }
  box.addEventListener("pointermove", point);
  box.addEventListener("pointerdown", point);
  box.addEventListener("pointerleave", (event) => { if (event.pointerType !== "touch") leave(); });
  box.addEventListener("blur", leave);
  box.addEventListener("keydown", (event) => {
    // Left and right go along a curve; up and down go to the next curve, at the nearest abscissa.
    const step = {ArrowRight: 1, ArrowLeft: -1}[event.key], leap = {ArrowUp: -1, ArrowDown: 1}[event.key];
    if (step) mark(Math.min(points.length - 1, Math.max(0, at + step)));
    else if (event.key === "Home" || event.key === "End") mark(event.key === "Home" ? 0 : points.length - 1);
    else if (leap) {
      const here = points[Math.max(at, 0)];
      const curves = [...new Set(points.map(({curve}) => curve))];
      const other = curves[(curves.indexOf(here.curve) + leap + curves.length) % curves.length];
      let nearest = -1;
      points.forEach((candidate, i) => {
        if (candidate.curve !== other) return;
        if (nearest < 0 || Math.abs(candidate.across - here.across) < Math.abs(points[nearest].across - here.across)) nearest = i;
      });
      mark(nearest);
    } else if (event.key === "Escape") leave();
    else return;
    event.preventDefault();
  });
}

lit.part(function figures() {
  for (const image of document.querySelectorAll("main img[data-drawing]")) {
    const panels = lit.facts.figures[image.dataset.drawing]?.panels || [];
    if (panels.length > 0) makePointable(image, panels);
  }
});
