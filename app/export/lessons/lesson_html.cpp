// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/lessons/lesson_html.h"

#include <fmt/core.h>

#include "app/picture/paper/caption_text.h"
#include "app/picture/paper/rich_text.h"
#include "render/figure/writers.h"

namespace mes {
namespace {

// The variables of :root contain everything that differs from lesson to lesson.
constexpr std::string_view kStyle = R"css(
* { box-sizing: border-box; }
html, body { margin: 0; background: var(--paper); color: var(--ink); }
body { font-family: Inter, "Helvetica Neue", Helvetica, Arial, sans-serif; line-height: 1.35; }
.step { display: flex; position: relative; width: 100vw; height: 100vh; overflow: hidden; }
.caption { flex: 0 0 34%; padding: 7vh 2vw 9vh 4vw; font-size: min(3.6vh, 2.1vw); overflow: auto; }
.drawing { flex: 1 1 66%; min-width: 0; }
.drawing svg { display: block; width: 100%; height: 100%; }
h2, h3, h4 { margin: 0 0 .5em; line-height: 1.15; font-weight: 600; }
h2 { font-size: 1.55em; } h3 { font-size: 1.25em; } h4 { font-size: 1.08em; }
* + h2, * + h3, * + h4 { margin-top: .9em; }
p { margin: 0 0 .7em; } ul { margin: 0 0 .7em; padding-left: 1.2em; } li { margin-bottom: .25em; }
strong { font-weight: 600; } .math { white-space: nowrap; } sub, sup { font-size: .7em; line-height: 0; }
footer { position: absolute; left: 4vw; bottom: 3.2vh; font-size: min(2.2vh, 1.3vw); color: var(--quiet); }
footer a { color: inherit; text-decoration: none; padding: .3em .5em; margin-left: -.5em; }
footer span { margin-left: .8em; }
.slides { overflow: hidden; } .slides .step { display: none; } .slides .step.shown { display: flex; }
@media (max-aspect-ratio: 1/1) {
  .step { flex-direction: column-reverse; }
  .caption { flex: 0 0 38%; width: 100%; padding: 2vh 5vw 7vh; font-size: min(2.4vh, 4.4vw); }
}
@media print {
  .step, .slides .step { display: flex; width: 100%; height: 100vh; break-after: page; break-inside: avoid; }
  .step:last-of-type { break-after: auto; }
  footer a { display: none; }
}
)css";

constexpr std::string_view kScript = R"js(
"use strict";
const steps = [...document.querySelectorAll(".step")];
let shown = 0;
const show = (i, note = true) => {
  shown = Math.max(0, Math.min(steps.length - 1, i));
  steps.forEach((step, k) => step.classList.toggle("shown", k === shown));
  if (note) history.replaceState(null, "", "#" + steps[shown].id);
};
const fromAddress = () => {
  const i = steps.findIndex(step => "#" + step.id === location.hash);
  show(i < 0 ? 0 : i, false);
};
const keys = {
  ArrowRight: 1, ArrowDown: 1, PageDown: 1, Enter: 1, " ": 1,
  ArrowLeft: -1, ArrowUp: -1, PageUp: -1, Backspace: -1
};
document.body.classList.add("slides");
fromAddress();
addEventListener("hashchange", fromAddress);
addEventListener("keydown", event => {
  if (event.ctrlKey || event.altKey || event.metaKey || (event.key === "Enter" && event.target.closest("a"))) return;
  if (event.key === "Home") show(0);
  else if (event.key === "End") show(steps.length - 1);
  else if (event.key === "f") document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen();
  else if (event.key in keys) show(shown + (event.shiftKey && event.key === " " ? -1 : keys[event.key]));
  else return;
  event.preventDefault();
});
let from = null;
addEventListener("touchstart", event => { from = event.changedTouches[0].clientX; }, {passive: true});
addEventListener("touchend", event => {
  const way = event.changedTouches[0].clientX - from;
  if (Math.abs(way) > 60) show(shown + (way < 0 ? 1 : -1));
}, {passive: true});
for (const [name, way] of [["back", -1], ["on", 1]])
  for (const link of document.querySelectorAll("." + name))
    link.addEventListener("click", event => { event.preventDefault(); show(shown + way); });
)js";

std::string css(Rgb color) {
  return fmt::format("#{:02x}{:02x}{:02x}", color.r, color.g, color.b);
}

}  // namespace

Expected<void> LessonHtml::add(const LessonPage& page, std::size_t number) {
  const auto drawing = figure::svg_element_of(page.drawing, fmt::format("step-{}-", number));
  if (!drawing) return std::unexpected(drawing.error());
  steps_ += fmt::format("<section class=\"step\" id=\"step-{}\" aria-label=\"{}\">\n<div class=\"caption\">\n",
                        number, escaped_html(page.name));
  steps_ += html_of(page.caption);
  steps_ += "</div>\n<div class=\"drawing\">\n" + *drawing;
  steps_ += fmt::format(
      "</div>\n<footer><a class=\"back\" href=\"#step-{}\" title=\"Back\">&#8249;</a> {} / {} "
      "<a class=\"on\" href=\"#step-{}\" title=\"On\" style=\"margin-left:0\">&#8250;</a><span>{}</span></footer>\n"
      "</section>\n",
      number > 1 ? number - 1 : number, number, look_.steps, number + 1, escaped_html(readable_text(look_.title)));
  return {};
}

std::string LessonHtml::file() && {
  const PaperColors colors = paper_colors(look_.background);
  std::string out =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
      "script-src 'unsafe-inline'; img-src data:\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<meta name=\"generator\" "
      "content=\"Mesecina\">\n<title>";
  out += escaped_html(readable_text(look_.title));
  out += fmt::format(
      "</title>\n<style>\n:root {{ --paper: {}; --ink: {}; --quiet: {}; }}\n@page {{ size: {:.2f}pt {:.2f}pt; "
      "margin: "
      "0; }}",
      look_.background ? css(*look_.background) : "#ffffff", css(colors.ink), css(colors.quiet), look_.width,
      look_.height);
  out += kStyle;
  out += "</style>\n</head>\n<body>\n";
  out += steps_;
  out += "<script>";
  out += kScript;
  out += "</script>\n</body>\n</html>\n";
  return out;
}

}  // namespace mes
