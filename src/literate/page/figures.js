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
    for (const curve of panel.curves) {
      for (let i = 0; i < curve.points.length; i += 2) {
        const x = curve.points[i], y = curve.points[i + 1];
        points.push({panel, curve, x, y, across: left + (right - left) * shareOf(panel.x, x),
                     down: 1 - bottom - (top - bottom) * shareOf(panel.y, y)});
      }
    }
  }
  return points.filter(({across, down}) => Number.isFinite(across) && Number.isFinite(down));
}

/// «eq. (3): x: 0.01, u: −1.2 × 10⁻⁷»
function readingOf({panel, curve, x, y}) {
  const told = (label, number) => `${label}: ${lit.number(String(Number(number.toPrecision(5))))}`;
  return `${curve.title ? curve.title + ": " : ""}${told(panel.x.label || "x", x)}, ${told(panel.y.label || "y", y)}`;
}

function makePointable(image, panels) {
  const points = pointsOf(panels);
  if (points.length === 0) return;
  const box = lit.make("span", {class: "lit-pointed", tabindex: "0", role: "slider", "aria-valuemin": "1",
    "aria-valuemax": String(points.length), "aria-valuenow": "1", "aria-valuetext": readingOf(points[0]),
    "aria-label": "Read off the figure: arrow keys go from point to point"});
  const reading = lit.make("p", {class: "lit-reading"});
  image.replaceWith(box);
  box.append(image);
  box.insertAdjacentHTML("beforeend", '<svg aria-hidden="true"><line /><line /><circle r="5" /></svg>');
  box.after(reading);
  const overlay = box.lastChild;
  const [upright, level, ring] = overlay.children;
  let at = -1;

  // Lays the overlay upon the drawing's frame, once the image has its size, and says where that is.
  function frame() {
    const across = 100 * drawingMargin / image.naturalWidth, down = 100 * drawingMargin / image.naturalHeight;
    Object.assign(overlay.style, {left: `${across}%`, top: `${down}%`, width: `${100 - 2 * across}%`, height: `${100 - 2 * down}%`});
    return overlay.getBoundingClientRect();
  }

  function mark(i) {
    at = i;
    const {panel, across, down} = points[i];
    const [left, right, bottom, top] = panel.frame;
    function place(part, shares) {
      for (const [key, share] of Object.entries(shares)) part.setAttribute(key, `${100 * share}%`);
    }
    frame();
    place(upright, {x1: across, y1: 1 - top, x2: across, y2: 1 - bottom});
    place(level, {x1: left, y1: down, x2: right, y2: down});
    place(ring, {cx: across, cy: down});
    overlay.style.visibility = "visible";
    reading.textContent = readingOf(points[i]);
    box.setAttribute("aria-valuenow", String(i + 1));
    box.setAttribute("aria-valuetext", reading.textContent);
  }
  function leave() {
    overlay.style.visibility = "hidden";
    reading.textContent = "\u00a0";
  }
  // The point of the least distance; none if all are as far as `limit`.
  function nearest(distance, limit = Infinity) {
    let found = -1, least = limit;
    points.forEach((point, i) => {
      const far = distance(point);
      if (far < least) [found, least] = [i, far];
    });
    return found;
  }
  function point(event) {
    const {left, top, width, height} = frame();
    const x = event.clientX - left, y = event.clientY - top;
    const i = nearest(({across, down}) => Math.hypot(across * width - x, down * height - y), 60);
    if (i >= 0) mark(i);
    else leave();
  }
  leave();
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
      mark(nearest(({curve, across}) => curve === other ? Math.abs(across - here.across) : Infinity));
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
