// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/pages/parameters_panel.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "app/layers/changed_parameters.h"
#include "app/layers/words/parameter_words.h"
#include "app/playing/evolution_layers.h"
#include "app/ui/screen/theme.h"
#include "app/ui/widgets/icons.h"
#include "app/ui/widgets/number_field.h"
#include "app/ui/widgets/slider.h"
#include "app/ui/widgets/widgets.h"
#include "core/base/color.h"
#include "core/base/lower_case.h"
#include "imgui_stdlib.h"

namespace mes {
namespace {

bool matches(const Parameter& descriptor, const std::string& search) {
  return lower_case(title_of(descriptor) + ' ' + std::string(descriptor.id) + ' ' + spoken_explanation(descriptor))
             .find(lower_case(search)) != std::string::npos;
}

std::string parameter_explanation(const Parameter& descriptor) {
  if (descriptor.is_length)
    return fmt::format(
        "{}\n\nA length in units of the samples, {:.6g} by default. On the command line: --set {}=VALUE",
        spoken_explanation(descriptor), descriptor.default_value, descriptor.id);
  return fmt::format("{}\n\n{:.6g} to {:.6g}{}{}, {:.6g} by default. On the command line: --set {}=VALUE",
                     spoken_explanation(descriptor), descriptor.low, descriptor.high,
                     descriptor.unit.empty() ? "" : " ", descriptor.unit, descriptor.default_value, descriptor.id);
}

}  // namespace

void ParametersPanel::draw_animation(const Parameter& parameter) {
  ParameterAnimation& animation = computation_.animation();
  const float unit = gui_.unit();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {12 * unit, 10 * unit});
  if (begin_popup(gui_, "animate")) {
    if (ImGui::IsWindowAppearing() && !animation.is_running() && animation.parameter != parameter) {
      animation.aim(parameter, computation_.settings()[parameter]);
      if (parameter.is_length) animation.to = 0.5 * longest();
    }
    ImGui::PushFont(gui_.bold());
    ImGui::TextUnformatted(("Animate: " + title_of(parameter)).c_str());
    ImGui::PopFont();
    ImGui::BeginDisabled(animation.is_running());
    const auto bound = [&](const char* label, double& value, const char* meaning) {
      ImGui::SetNextItemWidth(130 * unit);
      if (number_field(label, value, "%.6g")) take_within(parameter, value);
      tooltip(gui_, meaning);
    };
    bound("From", animation.from, "Value of the first picture");
    bound("To", animation.to, "Value of the last picture");
    ImGui::SetNextItemWidth(130 * unit);
    number_field("Steps", animation.steps, 1, ParameterAnimation::kMostSteps);
    tooltip(gui_, "From the first picture to the last");
    ImGui::EndDisabled();
    slider(gui_, "Speed", animation.steps_per_second, 0.5, 60.0,
           {.format = "%.3g steps/s", .is_logarithmic = true, .width = 210 * unit});
    tooltip(gui_, "Highest speed; each step waits until its picture is complete");
    if (animation.is_running()) {
      if (ImGui::Button("Stop here")) animation.stop();
      tooltip(gui_, "Keep the value that is shown now");
      ImGui::SameLine();
      if (ImGui::Button("Stop and go back")) computation_.give_back();
      tooltip(gui_, "Restore the value that the parameter had before");
      ImGui::SameLine();
      ImGui::TextDisabled("%d of %d", animation.position(), animation.steps);
    } else if (default_button(gui_, "Play", {130 * unit, 0}, true) || is_default_pressed()) {
      animation.parameter = parameter;
      computation_.start_animation();
    }
    draw_sweep(parameter);
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

void ParametersPanel::draw_sweep(const Parameter& parameter) {
  const float unit = gui_.unit();
  if (sweep_.is_under_way()) {
    if (ImGui::Button("Stop the table", {130 * unit, 0})) sweep_.give_up();
    ImGui::SameLine();
    ImGui::TextDisabled("%.0f %%", 100.0 * sweep_.progress());
    return;
  }
  ImGui::BeginDisabled(computation_.animation().is_running());
  if (ImGui::Button("Table as CSV...", {130 * unit, 0})) {
    ParameterSweep sweep{data_of(editor_.document()), computation_.settings(), computation_.animation(), {}};
    sweep.range.parameter = parameter;
    const auto visible = layers_.visible_layers();
    sweep.layers.assign(visible.begin(), visible.end());
    sweep_.begin(std::move(sweep));
  }
  ImGui::EndDisabled();
  tooltip(gui_,
          "Compute the shown layers for each of these values, and write their counts and measures to a file, as "
          "mesecina sweep does");
}

void ParametersPanel::take_within(const Parameter& descriptor, double& value) const {
  const double within = std::clamp(value, descriptor.low, descriptor.high);
  if (within == value) return;
  messages_.remark(beyond_words(title_of(descriptor), value, descriptor.low, descriptor.high));
  value = within;
}

double ParametersPanel::longest() const {
  return 2.0 / picture_.scene().frame().scale;
}

void ParametersPanel::draw_value(const Parameter& descriptor, double& value) {
  if (const auto choices = descriptor.choices; !choices.empty()) {
    const auto chosen = static_cast<std::size_t>(value);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (ImGui::BeginCombo("##choice", std::string(choices[chosen]).c_str())) {
      for (std::size_t i = 0; i < choices.size(); ++i)
        if (ImGui::Selectable(std::string(choices[i]).c_str(), i == chosen))
          value = descriptor.low + static_cast<double>(i);
      ImGui::EndCombo();
    }
  } else {
    const std::string unit_text = descriptor.unit == "%"         ? std::string(" %%")
                                  : descriptor.unit == "degrees" ? std::string("\u00b0")
                                  : descriptor.is_length         ? std::string()
                                                                 : ' ' + std::string(descriptor.unit);
    const std::string format = (descriptor.is_whole ? "%.0f" : "%.5g") + unit_text;
    std::optional<double> beyond;
    // The palette has the keyboard until it is closed.
    const bool takes_keyboard = !gui_.has_popup() && std::exchange(gives_keyboard_, false);
    slider(gui_, "##value", value, descriptor.low, descriptor.high,
           {.format = format.c_str(),
            .is_logarithmic = is_wide(descriptor),
            .is_whole = descriptor.is_whole,
            .end = descriptor.is_length ? longest() : 0.0,
            .beyond = &beyond,
            .takes_keyboard = takes_keyboard});
    if (beyond) take_within(descriptor, *beyond);
  }
  tooltip(gui_, parameter_explanation(descriptor));
}

// The band is as wide as the slider above it without its number.
MarkBand ParametersPanel::band(const char* id) const {
  return {gui_, id, slider_rail(gui_, ImGui::GetContentRegionAvail().x), 12 * gui_.unit()};
}

void ParametersPanel::draw_scale_events(double& factor) {
  const bool is_shown = std::ranges::any_of(layers_.visible_layers(), [this](LayerIndex layer) {
    return layers_.descriptor(layer).group == LayerGroup::scale_axis;
  });
  if (!is_shown) return;
  const Document& document = editor_.document();
  scale_events_.follow(document.revision(), computation_.settings(), [&document] { return data_of(document); });
  const std::vector<ScaleEvent>* const events = scale_events_.events();
  MarkBand marks = band("events");
  const Parameter& range = Parameter::scale_axis_factor;
  const auto x_of = [&](double value) { return marks.track().at((value - range.low) / (range.high - range.low)); };
  const std::string problem = scale_events_.problem();
  std::string words =
      !problem.empty()    ? "Factors at which components merge cannot be found: " + problem
      : events == nullptr ? "Looking for factors at which components merge or split, or holes open or close"
      : events->empty()   ? "No components merge or split and no holes open or close at any factor"
                          : "Factors at which components merge or split, or holes open or close; a click goes there";
  if (events != nullptr) {
    const ScaleEvent* nearest = nullptr;
    for (const ScaleEvent& event : *events) {
      const bool merges = event.components_before != event.components_after;
      if (marks.mark(x_of(event.factor), merges ? palette::green : palette::purple, 2.0F)) nearest = &event;
    }
    if (nearest != nullptr) {
      words = fmt::format("{:.4g}: {}", nearest->factor, nearest->words());
      if (nearest->within > 1e-3)
        words += fmt::format(" (to within {:.2g}: there is too much to examine)", nearest->within);
      if (marks.is_clicked()) factor = nearest->factor;
    }
  }
  marks.show_value(x_of(factor));
  marks.explain(words);
}

void ParametersPanel::draw_critical_values(double& limit) {
  const bool is_shown = std::ranges::any_of(layers_.visible_layers(), [this](LayerIndex layer) {
    const LayerDescriptor& descriptor = layers_.descriptor(layer);
    return descriptor.scalar == "lambda" ||
           std::ranges::find(descriptor.parameters, Parameter::lambda_limit.id) != descriptor.parameters.end();
  });
  if (!is_shown) return;
  const Document& document = editor_.document();
  critical_values_.follow(document.revision(), [&document] { return data_of(document); });
  const std::vector<double>* const values = critical_values_.values();
  MarkBand marks = band("critical");
  const double end = longest();
  const auto x_of = [&](double value) { return marks.track().at(std::sqrt(std::clamp(value / end, 0.0, 1.0))); };
  const std::string problem = critical_values_.problem();
  std::string words = !problem.empty()    ? "Critical values cannot be found: " + problem
                      : values == nullptr ? "Looking for critical values of the distance to the samples"
                      : values->empty()   ? "The distance to the samples has no critical value on the axis"
                                          : "Critical values of the distance to the samples; the first, in green, is "
                                            "the estimate of the weak feature size, below which the lambda axis has "
                                            "the topology of the shape. A click goes to the nearest";
  if (values != nullptr) {
    float drawn = x_of(0.0) - 1.0F;
    const double* nearest = nullptr;
    for (const double& value : *values) {
      const float x = x_of(value);
      if (value > end) break;
      const bool is_first = &value == &values->front();
      // One line per pixel is enough.
      if (!is_first && x - drawn < 1.0F) continue;
      drawn = x;
      if (marks.mark(x, is_first ? palette::green : palette::purple, is_first ? 3.0F : 1.0F)) nearest = &value;
    }
    if (nearest != nullptr) {
      words =
          fmt::format("{:.4g}: {}", *nearest,
                      nearest == &values->front() ? "estimate of the weak feature size"
                                                  : "at this radius, disks around the samples change their topology");
      if (marks.is_clicked()) limit = *nearest;
    }
  }
  marks.show_value(x_of(limit));
  marks.explain(words);
}

void ParametersPanel::draw_alpha_events(double& radius) {
  const auto shown = shown_growth(layers_, persistence_.growth());
  if (!shown) return;
  persistence_.choose_growth(*shown);
  const Document& document = editor_.document();
  persistence_.follow(document, computation_.settings());
  MarkBand marks = band("births");
  const double end = longest();
  const auto x_of = [&](double value) { return marks.track().at(std::sqrt(std::clamp(value / end, 0.0, 1.0))); };
  const auto value_at = [&](float x) {
    const double part = marks.track().part_at(x);
    return part * part * end;
  };
  std::string words =
      !persistence_.problem().empty() ? "Births and deaths cannot be found: " + persistence_.problem()
      : !persistence_.is_current()
          ? "Looking for births and deaths"
          : "Radii at which components are joined (green), holes are closed (purple) and filled (blue); "
            "a click goes to the nearest";
  if (persistence_.is_current()) {
    const PersistenceTable& table = *persistence_.table();
    std::optional<double> nearest;
    const char* what = "";
    const auto draw_all = [&](const std::vector<GrowthEvent>& events, Rgb color, const char* happens) {
      // Events that unscaled balls have already passed lie before the beginning of the slider.
      const auto last = std::ranges::upper_bound(events, end, {}, &GrowthEvent::radius);
      // One line per pixel is enough.
      for (auto i = std::ranges::lower_bound(events, 0.0, {}, &GrowthEvent::radius); i < last;) {
        const float x = x_of(i->radius);
        if (marks.mark(x, color)) {
          nearest = i->radius;
          what = happens;
        }
        i = std::ranges::upper_bound(std::next(i), last, value_at(x + 1.0F), {}, &GrowthEvent::radius);
      }
    };
    draw_all(table.joins, palette::green, "components are joined");
    draw_all(table.fills, palette::blue, "a hole is filled");
    draw_all(table.closes, palette::purple, "a hole is closed");
    if (nearest) {
      words = fmt::format("{:.4g}: {}", *nearest, what);
      if (marks.is_clicked()) radius = *nearest;
    }
  }
  marks.show_value(x_of(radius));
  marks.explain(words);
}

void ParametersPanel::draw_parameter(const Parameter& parameter) {
  const float unit = gui_.unit();
  ComputationSettings settings = computation_.settings();
  double& value = settings[parameter];
  ImGui::PushID(parameter.id.c_str());
  const std::string title = title_of(parameter);
  const float button = ImGui::GetFrameHeight();
  const float buttons_at = ImGui::GetContentRegionMax().x - 2 * button - 2 * unit;
  if (is_switch(parameter)) {
    bool on = value != 0.0;
    if (checkbox(title.c_str(), &on)) value = on ? 1.0 : 0.0;
    tooltip(gui_, parameter_explanation(parameter));
  } else {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(title.c_str());
    tooltip(gui_, parameter_explanation(parameter));
  }
  ImGui::SameLine(buttons_at);
  const bool runs = computation_.animation().is_running() && computation_.animation().parameter == parameter;
  if (is_switch(parameter) || !parameter.choices.empty()) {
    ImGui::Dummy({button, button});
  } else {
    if (icon_button("run", Icon::play, button, runs ? ButtonLook::on : ButtonLook::plain))
      ImGui::OpenPopup("animate");
    tooltip(gui_, "Animate it from one value to another");
  }
  ImGui::SameLine(0, 2 * unit);
  if (icon_button("reset", Icon::undo, button, ButtonLook::plain, value != parameter.default_value))
    value = parameter.default_value;
  tooltip(gui_, "Back to the default");
  draw_animation(parameter);
  if (!is_switch(parameter)) draw_value(parameter, value);
  if (parameter == Parameter::scale_axis_factor) draw_scale_events(value);
  if (parameter == Parameter::lambda_limit) draw_critical_values(value);
  if (parameter == Parameter::alpha_radius) draw_alpha_events(value);
  ImGui::PopID();
  if (settings != computation_.settings()) {
    if (runs) computation_.animation().stop();
    computation_.set(settings);
  }
}

void ParametersPanel::draw() {
  const float unit = gui_.unit();
  const float reset = ImGui::CalcTextSize("Reset all").x + 16 * unit;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - reset - 6 * unit);
  ImGui::InputTextWithHint("##search", "Search", &search_);
  ImGui::SameLine(0, 6 * unit);
  ImGui::BeginDisabled(changed_parameters(computation_.parameters(), computation_.settings()).empty());
  if (ImGui::Button("Reset all", {reset, 0})) {
    ComputationSettings settings = computation_.settings();
    for (const Parameter& parameter : computation_.parameters()) settings[parameter] = parameter.default_value;
    computation_.animation().stop();
    computation_.set(settings);
  }
  ImGui::EndDisabled();
  tooltip(gui_, "Reset every parameter to its default");
  ImGui::BeginChild("list");
  bool any = false;
  const auto draw_those = [&](std::span<const Parameter> parameters) {
    for (const Parameter& parameter : parameters) {
      if (!matches(parameter, search_)) continue;
      any = true;
      draw_parameter(parameter);
    }
  };
  // Parameters of experiments follow the program's in the registry. They come first here, because the user works on
  // them.
  const std::size_t own = std::min(computation_parameters().size(), computation_.parameters().size());
  draw_those(computation_.parameters().subspan(own));
  draw_those(computation_.parameters().first(own));
  if (!any) ImGui::TextDisabled("No parameter matches");
  ImGui::EndChild();
}

}  // namespace mes
