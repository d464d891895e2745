// Script of the view that turns: draws the data of a figure (turning_view.hpp) on a canvas in place
// of its picture. Dragging, arrow keys and + - move the eye; without a script, and on paper, the
// picture remains.
#pragma once

#include <string_view>

namespace kusabi::run {

inline constexpr std::string_view turning_script = R"js(
"use strict";
for (const figure of document.querySelectorAll("figure[data-scene]")) {
  const leading = JSON.parse(figure.dataset.scene);
  let data = leading;
  const canvas = document.createElement("canvas");
  const pen = canvas.getContext("2d");
  if (!pen) continue;
  const start = { yaw: 0.7, pitch: 0.5, zoom: 1 };
  const eye = { ...start };
  let motion = data.motions ? 1 : 0;
  canvas.tabIndex = 0;
  canvas.setAttribute("role", "img");
  const name = () => canvas.setAttribute("aria-label", figure.querySelector("svg title").textContent +
    ". Arrow keys turn it, plus and minus change its size, 0 returns to the first view.");
  name();
  figure.prepend(canvas);
  figure.classList.add("turns");

  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const plus = (a, b, s = 1) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
  const times = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
  const unit = a => times(a, 1 / (Math.hypot(...a) || 1));
  const place = i => [0, 1, 2].map(k => (data.places[3 * i + k] + motion * (data.motions ? data.motions[3 * i + k] : 0)) / 1e4);
  let inks = {};
  const color = name => inks[name] ||= getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();

  // Rows: to the right, up, to the eye.
  const axes = () => {
    const [cy, sy, cp, sp] = [Math.cos(eye.yaw), Math.sin(eye.yaw), Math.cos(eye.pitch), Math.sin(eye.pitch)];
    return [[cy, sy, 0], [-sp * sy, sp * cy, cp], [cp * sy, -cp * cy, sp]];
  };
  const hull = points => {
    points.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    const chain = [];
    for (const half of [points, [...points].reverse()]) {
      const first = chain.length;
      for (const p of half) {
        while (chain.length >= first + 2) {
          const [o, a] = [chain[chain.length - 2], chain[chain.length - 1]];
          if ((a[0] - o[0]) * (p[1] - o[1]) - (a[1] - o[1]) * (p[0] - o[0]) > 0) break;
          chain.pop();
        }
        chain.push(p);
      }
      chain.pop();
    }
    return chain;
  };
  const rim = (middle, normal, radius, steps = 20) => {
    const first = unit(cross(normal, Math.abs(normal[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0]));
    const second = cross(normal, first);
    return Array.from({ length: steps }, (_, i) => plus(plus(middle, first, radius * Math.cos(2 * Math.PI * i / steps)),
      second, radius * Math.sin(2 * Math.PI * i / steps)));
  };

  let marks = [];  // drawn candidates: place on the canvas and text
  const draw = () => {
    const ratio = devicePixelRatio || 1;
    const across = canvas.clientWidth, high = canvas.clientHeight;
    if (!across || !high) return;
    if (canvas.width !== Math.round(across * ratio)) canvas.width = Math.round(across * ratio);
    if (canvas.height !== Math.round(high * ratio)) canvas.height = Math.round(high * ratio);
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, across, high);
    const [right, up, to] = axes();
    const scale = 0.44 * Math.min(across, high) * eye.zoom;
    const flat = p => [across / 2 + scale * dot(right, p), high / 2 - scale * dot(up, p)];
    const nodes = Array.from({ length: data.places.length / 3 }, (_, i) => place(i));
    const light = unit(plus(plus(to, right, -0.5), up, 0.6));
    const items = [];
    const add = (depth, paint) => items.push({ depth, paint });
    const path = points => {
      pen.beginPath();
      points.forEach((p, i) => i ? pen.lineTo(...p) : pen.moveTo(...p));
    };
    const fill = (points, ink, edge, width) => {
      path(points);
      pen.closePath();
      pen.fillStyle = ink;
      pen.fill();
      if (!edge) return;
      pen.strokeStyle = edge;
      pen.lineWidth = width;
      pen.stroke();
    };
    const line = (from, end, ink, width) => {
      path([from, end]);
      pen.strokeStyle = ink;
      pen.lineWidth = width;
      pen.stroke();
    };
    const arrow = (from, end, ink) => {
      const [a, b] = [flat(from), flat(end)];
      const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
      if (length < 0.5) return;
      const size = Math.min(10, length / 2), ways = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
      const neck = [b[0] - size * ways[0], b[1] - size * ways[1]];
      line(a, neck, ink, 2);
      fill([b, [neck[0] - 0.42 * size * ways[1], neck[1] + 0.42 * size * ways[0]],
        [neck[0] + 0.42 * size * ways[1], neck[1] - 0.42 * size * ways[0]]], ink);
    };

    const edge = color("edge"), body = color("body").split(",").map(Number);
    for (const face of data.faces) {
      const points = face.map(i => nodes[i]);
      let area = [0, 0, 0];
      for (let i = 1; i + 1 < points.length; ++i)
        area = plus(area, cross(plus(points[i], points[0], -1), plus(points[i + 1], points[0], -1)));
      if (dot(area, to) <= 0) continue;
      const shine = 0.6 + 0.4 * Math.max(0, dot(unit(area), light));
      const depth = points.reduce((sum, p) => sum + dot(to, p), 0) / points.length;
      add(depth, () => fill(points.map(flat), `rgb(${body.map(c => Math.round(c * shine))})`, edge, 0.6));
    }
    const kinds = ["bar", "tension", "compression", "tension"];  // the last one is lost, and thin
    const widths = [1.7, 3.4, 3.4, 0.8];
    for (const [a, b, kind] of data.bars)
      add(dot(to, plus(nodes[a], nodes[b])) / 2, () => line(flat(nodes[a]), flat(nodes[b]), color(kinds[kind]), widths[kind]));
    for (const i of data.supports) {
      const [x, y] = flat(nodes[i]);
      add(dot(to, nodes[i]) + 1e-3, () => fill([[x - 4, y - 4], [x + 4, y - 4], [x + 4, y + 4], [x - 4, y + 4]], color("held")));
    }
    for (const each of data.arrows) {
      const force = times(each.force, 1e-4), node = nodes[each.node];
      const far = plus(node, force, each.to ? -1 : 1);
      add(dot(to, far), () => each.to ? arrow(far, node, color(each.kind)) : arrow(node, far, color(each.kind)));
    }
    marks = [];
    for (const each of data.candidates) {
      const node = nodes[each.node], normal = unit(each.normal), sense = each.sense;
      const at = flat(node);
      const loaded = each.force !== undefined;
      if (loaded && each.mu > 0) {
        const side = each.cone / 1e4, angle = Math.atan(each.mu);
        const middle = plus(node, normal, sense * side * Math.cos(angle));
        const points = rim(middle, normal, side * Math.sin(angle));
        const shade = color("use" + (each.use < 0.5 ? 0 : each.use < 0.75 ? 1 : each.use < 0.95 ? 2 : 3));
        add(dot(to, middle), () => {
          pen.globalAlpha = 0.5;
          fill(hull([node, ...points].map(flat)), shade, shade, 0.8);
          pen.globalAlpha = 1;
        });
      }
      if (loaded) {
        const end = plus(node, each.force, sense * 1e-4);
        add(dot(to, end) + 1e-3, () => sense < 0 ? arrow(end, node, color("reaction")) : arrow(node, end, color("reaction")));
      }
      const hidden = data.faces.length > 0 && dot(normal, to) > 0;
      const size = loaded ? 2.5 + 3.5 * Math.sqrt(Math.min(1, Math.hypot(...each.force) / 3200)) : 3;
      const ink = each.state === "in contact" ? "reaction" : each.state === "separated" ? "paper" : "held";
      // In front of the faces around it, unless it is on the far side.
      add(dot(to, node) + (hidden ? -0.02 : 0.02), () => {
        pen.beginPath();
        pen.arc(...at, size, 0, 2 * Math.PI);
        pen.fillStyle = color(ink);
        pen.fill();
        pen.strokeStyle = color(each.state === "separated" ? "compression" : "paper");
        pen.lineWidth = 1.2;
        pen.stroke();
      });
      const use = loaded && each.mu > 0 ? `, needs ${(100 * each.use).toFixed(0)} % of its friction` : "";
      if (!hidden) marks.push({ at, text: `${each.name}: ${each.state}${use}` });
    }
    items.sort((a, b) => a.depth - b.depth);
    for (const item of items) item.paint();
    ["x", "y", "z"].forEach((name, k) => {
      const corner = [34, high - 34], way = [right[k], -up[k]];
      line(corner, [corner[0] + 22 * way[0], corner[1] + 22 * way[1]], color("faint"), 1.2);
      pen.fillStyle = color("faint");
      pen.font = "12px system-ui, sans-serif";
      pen.fillText(name, corner[0] + 30 * way[0] - 3, corner[1] + 30 * way[1] + 4);
    });
  };
  let asked = false;
  const redraw = () => {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => { asked = false; draw(); });
  };

  const note = document.createElement("p");
  note.className = "remark";
  const help = "Drag, or use the arrow keys, to turn; + and − change the size; 0 returns.";
  note.textContent = help;
  canvas.after(note);
  if (data.motions) {
    const label = document.createElement("label"), slider = document.createElement("input");
    Object.assign(slider, { type: "range", min: 0, max: 1, step: 0.01, value: 1 });
    slider.addEventListener("input", () => { motion = Number(slider.value); redraw(); });
    label.append("Displacements ", slider);
    note.after(label);
  }
  // The detail of another answer has the members that differ from those of the leading one.
  figure.addEventListener("view", event => {
    if (!event.detail) return;
    data = { ...leading, ...JSON.parse(event.detail) };
    name();
    redraw();
  });
  let opening = !matchMedia("(prefers-reduced-motion: reduce)").matches;
  const turn = (yaw, pitch) => {
    opening = false;
    eye.yaw += yaw;
    eye.pitch = Math.max(-1.57, Math.min(1.57, eye.pitch + pitch));
    redraw();
  };
  let held = null;
  canvas.addEventListener("pointerdown", event => {
    held = [event.clientX, event.clientY];
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", event => {
    if (held) {
      turn((held[0] - event.clientX) / 150, (event.clientY - held[1]) / 150);
      held = [event.clientX, event.clientY];
      return;
    }
    const near = marks.find(mark => Math.hypot(mark.at[0] - event.offsetX, mark.at[1] - event.offsetY) < 9);
    note.textContent = near ? near.text : help;
  });
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => { held = null; });
  const keys = { ArrowLeft: [0.13, 0], ArrowRight: [-0.13, 0], ArrowUp: [0, 0.13], ArrowDown: [0, -0.13] };
  canvas.addEventListener("keydown", event => {
    if (event.key in keys) {
      turn(...keys[event.key]);
    } else if (event.key === "+" || event.key === "-") {
      eye.zoom *= event.key === "+" ? 1.15 : 1 / 1.15;
      redraw();
    } else if (event.key === "0") {
      opening = false;
      Object.assign(eye, start);
      redraw();
    } else {
      return;
    }
    event.preventDefault();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { inks = {}; redraw(); });
  new ResizeObserver(redraw).observe(canvas);
  draw();
  // It turns a little at first, so that it is seen to turn.
  const begin = performance.now();
  const step = now => {
    if (!opening) return;
    const rest = Math.max(0, 1 - (now - begin) / 1400);
    eye.yaw = start.yaw - 0.5 * rest * rest;
    opening = rest > 0;
    draw();
    requestAnimationFrame(step);
  };
  if (opening) requestAnimationFrame(step);
}
)js";

}  // namespace kusabi::run
