// SPDX-License-Identifier: GPL-3.0-or-later
// Figures that can be pointed at: the nearest point of a curve is marked and its numbers are told, by the pointer, a touch
// or the arrow keys; the names of the curves hide and show them. What gnuplot drew stays as it is below.

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

/// A number with five digits, and a power of ten where it is long.
function shortNumber(number) {
  const text = Number(number.toPrecision(5)).toString().replace("e+", "e");
  return text.replace(/^-/, "−").replace(/e(-?\d+)$/, (whole, exponent) => "·10" + raised(exponent));
}

/// «eq. (3): x = 0.01 in, u = −1.2»
function readingOf({panel, curve, x, y}) {
  const name = (axis, letter) => plainLatex(axis.label) || letter;
  return `${curve.title ? plainLatex(curve.title) + ": " : ""}${name(panel.x, "x")}: ${shortNumber(x)}, ` +
    `${name(panel.y, "y")}: ${shortNumber(y)}`;
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

  function mark(i) {
    at = i;
    const {width, height} = box.getBoundingClientRect();
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
    const {left, top, width, height} = box.getBoundingClientRect();
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
  addLegend(box, reading, panels, points);
}

/// Buttons that hide and show the curves of each name, if there are several.
function addLegend(box, reading, panels, points) {
  const names = [...new Set(panels.flatMap(({curves}) => curves.map(({title}) => title)).filter(Boolean))];
  if (names.length < 2) return;
  let parts = null;
  const buttons = names.map((name) => lit.button(plainLatex(name), (event) => {
    parts ??= partsOf(box, panels, points);
    const button = event.currentTarget;
    const isShown = button.getAttribute("aria-pressed") !== "true";
    button.setAttribute("aria-pressed", String(isShown));
    for (const part of parts.get(name) || []) part.style.visibility = isShown ? "" : "hidden";
  }, {"aria-pressed": "true"}));
  reading.after(lit.make("div", {class: "lit-legend", role: "group", "aria-label": "Curves shown"}, buttons));
}

/// The paths of the drawing that belong to each name. The drawing takes the place of its picture, in a shadow so that its ids
/// stay its own; a path belongs to a curve if it is made of the curve's points, or is a mark at one of them.
function partsOf(box, panels, points) {
  const image = box.querySelector("img");
  const comma = image.src.indexOf(",");
  const data = image.src.slice(comma + 1);
  const text = image.src.slice(0, comma).endsWith(";base64")
    ? new TextDecoder().decode(Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0)))
    : decodeURIComponent(data);
  const drawing = new DOMParser().parseFromString(text, "image/svg+xml").documentElement;
  const holder = lit.make("span", {id: image.id || undefined, role: "img", "aria-label": image.alt, class: "lit-drawing"});
  const shadow = holder.attachShadow({mode: "open"});
  const size = image.getBoundingClientRect();
  drawing.setAttribute("width", size.width);
  drawing.setAttribute("height", size.height);
  drawing.style.maxWidth = "100%";
  drawing.style.height = "auto";
  drawing.style.display = "block";
  shadow.append(document.importNode(drawing, true));
  image.replaceWith(holder);

  const root = shadow.querySelector("svg");
  const {width, height} = root.viewBox.baseVal;
  const curves = [...new Set(points.map(({curve}) => curve))].map((curve) => ({
    title: curve.title, places: points.filter((point) => point.curve === curve).map(({across, down}) => [across * width, down * height])}));
  const parts = new Map(curves.map(({title}) => [title, []]));
  const toRoot = root.getScreenCTM().inverse();
  for (const path of shadow.querySelectorAll("path")) {
    if (path.closest("defs, symbol, clipPath")) continue;
    const matrix = toRoot.multiply(path.getScreenCTM());
    const vertices = verticesOf(path.getAttribute("d") || "").map(([x, y]) => [matrix.a * x + matrix.c * y + matrix.e, matrix.b * x + matrix.d * y + matrix.f]);
    const owner = ownerOf(vertices, curves, 0.01 * width);
    if (owner) parts.get(owner.title)?.push(path);
  }
  return parts;
}

/// The ends of a path's segments.
function verticesOf(path) {
  const vertices = [];
  for (const [, command, rest] of path.matchAll(/([MLC])([^MLCZ]*)/gi)) {
    const numbers = rest.match(/-?[\d.]+(?:e-?\d+)?/g)?.map(Number) || [];
    const step = command.toUpperCase() === "C" ? 6 : 2;
    for (let i = step; i <= numbers.length; i += step) vertices.push([numbers[i - 2], numbers[i - 1]]);
  }
  return vertices;
}

/// The curve whose polygon or whose points a path lies on; nothing if there is none.
function ownerOf(vertices, curves, markSize) {
  if (vertices.length === 0) return null;
  const middle = [0, 1].map((k) => vertices.reduce((sum, vertex) => sum + vertex[k], 0) / vertices.length);
  const extent = Math.max(...vertices.map(([x, y]) => Math.hypot(x - middle[0], y - middle[1])));
  let best = null, least = 0.6;
  for (const curve of curves) {
    const isMark = extent < markSize;
    const distance = isMark ? Math.min(...curve.places.map(([x, y]) => Math.hypot(x - middle[0], y - middle[1])))
      : Math.max(...vertices.map((vertex) => distanceToPolygon(vertex, curve.places)));
    if (distance < least) [best, least] = [curve, distance];
  }
  return best;
}

function distanceToPolygon([x, y], places) {
  let least = Infinity;
  for (let i = 0; i < places.length; ++i) {
    const [x1, y1] = places[Math.max(0, i - 1)], [x2, y2] = places[i];
    const length = (x2 - x1) ** 2 + (y2 - y1) ** 2;
    const t = length === 0 ? 0 : Math.min(1, Math.max(0, ((x - x1) * (x2 - x1) + (y - y1) * (y2 - y1)) / length));
    least = Math.min(least, Math.hypot(x - x1 - t * (x2 - x1), y - y1 - t * (y2 - y1)));
  }
  return least;
}

lit.part(function figures() {
  for (const image of document.querySelectorAll("main img[data-drawing]")) {
    const panels = lit.facts.figures[image.dataset.drawing]?.panels || [];
    if (panels.length > 0) makePointable(image, panels);
  }
});
