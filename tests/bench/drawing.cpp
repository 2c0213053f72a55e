// SPDX-License-Identifier: GPL-3.0-or-later
// What reaches the graphics card and how long it takes there: bytes of one edit, frame time against the number of
// primitives, and the way from samples to the first picture. Without OpenGL the last two are left out.
#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include <cmath>
#include <optional>
#include <tuple>

#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/draw/layer_mirror.h"
#include "render/device/egl_context.h"
#include "render/device/gl_device.h"
#include "render/device/recording_device.h"
#include "render/offscreen.h"
#include "render/scene.h"
#include "tests/bench/ratios.h"
#include "tests/bench/setup.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/shapes/shapes_benchmark.h"

namespace mes::bench {
namespace {

constexpr int kWidth = 1600;
constexpr int kHeight = 1000;

std::vector<LayerIndex> six_layers() {
  return layers_named({"points", "delaunay", "voronoi", "curve", "medial-axis", "interior-voronoi-disks"});
}

std::vector<render::LayerView> views_of(const std::vector<LayerIndex>& layers) {
  std::vector<render::LayerView> views;
  for (const LayerIndex layer : layers) views.push_back({layer, layer_descriptors()[layer].style});
  return views;
}

void upload(benchmark::State& state, RatioTable& table, std::size_t n) {
  render::RecordingDevice device;
  render::Scene scene(device);
  Document document;
  Graph graph{builtins()};
  graph.set_demand(six_layers());
  FramePatch patch;
  JobControl job;
  const auto step = [&](const std::shared_ptr<const DocumentDelta>& delta) {
    document.apply(*delta);
    graph.post(delta);
    graph.run(patch, job);
    const std::uint64_t before = device.counters().bytes_uploaded;
    scene.apply(patch);
    return static_cast<double>(device.counters().bytes_uploaded - before);
  };
  step(replace_with(document, test::benchmark_curve(n)));
  Rng rng(3);
  std::vector<double> bytes;
  for (auto _ : state) {
    const SampleSlot slot(rng.below(n));
    const Vec2 to = document.position(slot) + Vec2{1e-3 * rng.uniform(), 1e-3 * rng.uniform()};
    const auto delta = move_samples(document, std::vector{std::pair{document.id(slot), to}});
    bytes.push_back(step(std::make_shared<const DocumentDelta>(*delta)));
  }
  const double most = *std::ranges::max_element(bytes);
  table.add_note("bytes uploaded for one move at " + std::to_string(n) + ", six layers: median " +
                 std::to_string(static_cast<int>(median(bytes))) + ", most " +
                 std::to_string(static_cast<int>(most)) + " of " + std::to_string(bytes.size()) + " (goal 16384)");
}

void frame(benchmark::State& state, RatioTable& table, std::size_t n) {
  const auto context = render::EglContext::create();
  if (!context) {
    state.SkipWithError(context.error().text.c_str());
    return;
  }
  render::GlDevice device;
  const auto layers = layers_named({"delaunay"});
  Graph graph{builtins()};
  graph.set_demand(layers);
  const auto points = test::benchmark_curve(n);
  FramePatch patch;
  JobControl job;
  graph.post(replace_with(Document(), points));
  graph.run(patch, job);
  render::Scene scene(device);
  scene.apply(patch);
  render::Camera camera;
  camera.set_viewport(kWidth, kHeight);
  camera.fit(graph.structures().get<Samples>().extent(), 20.0);
  const auto views = views_of(layers);
  std::vector<double> times;
  for (auto _ : state) {
    const double start = now_us();
    const auto image = render::draw_image(device, scene, camera, views, {.background = Rgb{255, 255, 255}});
    benchmark::DoNotOptimize(image);
    times.push_back(1e-3 * (now_us() - start));
  }
  table.add_note("frame of " + std::to_string(scene.instances(layers[0], PrimitiveKind::segment)) +
                 " segments, 1600 x 1000, read back: median " + std::to_string(median(times)) + " ms (" +
                 context->description() + ")");
}

/// The least that draws the same strokes: positions as single floats, one program, no culling, no deep zoom.
class MinimalLoop {
 public:
  MinimalLoop(std::span<const double> segments, const render::Camera& camera) {
    constexpr const char* kVertex = R"(#version 330 core
layout(location = 0) in vec4 a_ends;
uniform vec4 u_view;
out vec2 v_place;
flat out float v_length;
void main() {
  vec2 p = (a_ends.xy - u_view.xy) * u_view.z;
  vec2 q = (a_ends.zw - u_view.xy) * u_view.z;
  float size = length(q - p);
  vec2 along = size > 0.0 ? (q - p) / size : vec2(1.0, 0.0);
  vec2 corner = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1);
  float h = u_view.w + 1.0;
  v_place = vec2(corner.x < 0.0 ? -h : size + h, corner.y * h);
  v_length = size;
  vec2 px = p + v_place.x * along + v_place.y * vec2(-along.y, along.x);
  gl_Position = vec4(px / vec2(800.0, 500.0), 0.0, 1.0);
})";
    constexpr const char* kFragment = R"(#version 330 core
in vec2 v_place;
flat in float v_length;
uniform vec4 u_color;
uniform float u_half_width;
out vec4 color;
void main() {
  float beyond = max(max(-v_place.x, v_place.x - v_length), 0.0);
  float sd = length(vec2(beyond, v_place.y)) - u_half_width;
  color = u_color * clamp(0.5 - sd, 0.0, 1.0);
})";
    program_ = glCreateProgram();
    for (const auto& [kind, text] :
         {std::pair{GL_VERTEX_SHADER, kVertex}, std::pair{GL_FRAGMENT_SHADER, kFragment}}) {
      const GLuint shader = glCreateShader(static_cast<GLenum>(kind));
      glShaderSource(shader, 1, &text, nullptr);
      glCompileShader(shader);
      glAttachShader(program_, shader);
    }
    glLinkProgram(program_);
    std::vector<float> data;
    data.reserve(segments.size() / kStride * 4);
    for (std::size_t at = 0; at < segments.size(); at += kStride)
      for (std::size_t i = 0; i < 4; ++i) data.push_back(static_cast<float>(segments[at + i]));
    count_ = static_cast<GLsizei>(data.size() / 4);
    glGenBuffers(1, &buffer_);
    glGenVertexArrays(1, &array_);
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size() * sizeof(float)), data.data(), GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
    glVertexAttribDivisor(0, 1);
    glGenRenderbuffers(1, &pixels_);
    glBindRenderbuffer(GL_RENDERBUFFER, pixels_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, kWidth, kHeight);
    glGenFramebuffers(1, &target_);
    glBindFramebuffer(GL_FRAMEBUFFER, target_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, pixels_);
    glUseProgram(program_);
    glUniform4f(glGetUniformLocation(program_, "u_view"), static_cast<float>(camera.center().x),
                static_cast<float>(camera.center().y), static_cast<float>(1.0 / camera.units_per_pixel()), 0.5F);
    glUniform1f(glGetUniformLocation(program_, "u_half_width"), 0.5F);
    glUniform4f(glGetUniformLocation(program_, "u_color"), 0.3F, 0.3F, 0.3F, 0.6F);
  }
  ~MinimalLoop() {
    glDeleteFramebuffers(1, &target_);
    glDeleteRenderbuffers(1, &pixels_);
    glDeleteVertexArrays(1, &array_);
    glDeleteBuffers(1, &buffer_);
    glDeleteProgram(program_);
  }
  MinimalLoop(const MinimalLoop&) = delete;
  MinimalLoop& operator=(const MinimalLoop&) = delete;

  void draw() const {
    glBindFramebuffer(GL_FRAMEBUFFER, target_);
    glViewport(0, 0, kWidth, kHeight);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glUseProgram(program_);
    glBindVertexArray(array_);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
    glFinish();
  }

 private:
  static constexpr std::size_t kStride = stride_of(PrimitiveKind::segment);
  GLuint program_ = 0;
  GLuint buffer_ = 0;
  GLuint array_ = 0;
  GLuint pixels_ = 0;
  GLuint target_ = 0;
  GLsizei count_ = 0;
};

/// Median microseconds of a frame; each is of another view, so that nothing is drawn from what was counted before.
double moving_frame(const FramePatch& patch, const render::LayerView& view, const render::Camera& start,
                    const render::GlDeviceOptions& options, int frames) {
  render::GlDevice device(options);
  render::Scene scene(device);
  scene.apply(patch);
  const render::FramebufferId target = device.create_framebuffer({kWidth, kHeight});
  render::Camera camera = start;
  std::vector<double> times;
  for (int i = 0; i <= frames; ++i) {
    camera.pan({1.0, 0.0});
    const double begin = now_us();
    device.clear(target, {0, 0, kWidth, kHeight}, {1, 1, 1, 1});
    scene.draw(camera, std::span(&view, 1),
               {.target = target, .overlays = false, .preview = render::Preview::coarse});
    device.finish();
    if (i > 0) times.push_back(now_us() - begin);  // the first one compiles programs
  }
  device.destroy_framebuffer(target);
  return median(times);
}

/// Disks of 150 to 400 pixels across, counted as they would be, against painting them.
void large_disks(benchmark::State& state, RatioTable& table, std::size_t n) {
  const auto context = render::EglContext::create();
  if (!context) {
    state.SkipWithError(context.error().text.c_str());
    return;
  }
  Rng rng(5);
  FramePatch patch;
  patch.layers.resize(1);
  patch.layer_count = 1;
  KindPatch& disks = patch.layers[0][PrimitiveKind::disk];
  disks.reset = true;
  disks.count = static_cast<std::uint32_t>(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double x = rng.uniform(0.0, kWidth);
    const double y = rng.uniform(0.0, kHeight);
    disks.data.insert(disks.data.end(), {x, y, rng.uniform(75.0, 200.0), 0.0});
  }
  const render::LayerView view{.layer = 0, .style = {.color = {70, 130, 180}, .opacity = 0.1}};
  render::Camera camera;
  camera.set_viewport(kWidth, kHeight);
  camera.look_at({0.5 * kWidth, 0.5 * kHeight}, 1.0);
  for (auto _ : state) {
    const double ours = moving_frame(patch, view, camera, {}, 15);
    table.add({"frame of large disks", n, ours,
               moving_frame(patch, view, camera, {.pixel_cost_ns = 0.0, .instance_cost_ns = 0.0}, 3), 0.02,
               "painting them"});
    table.add_note("frame of " + std::to_string(n) + " disks of 150 to 400 pixels, 1600 x 1000: median " +
                   std::to_string(1e-3 * ours) + " ms (" + context->description() + ")");
  }
}

FramePatch patch_of(PrimitiveKind kind, std::span<const double> data) {
  FramePatch patch;
  patch.layers.resize(1);
  patch.layer_count = 1;
  KindPatch& changes = patch.layers[0][kind];
  changes.reset = true;
  changes.data.assign(data.begin(), data.end());
  changes.count = static_cast<std::uint32_t>(data.size() / stride_of(kind));
  return patch;
}

/// Delaunay edges and samples, counted as they would be, against painting them; and zoomed to a hundredth of them,
/// against a frame of these alone.
void many_strokes(benchmark::State& state, RatioTable& table, std::size_t n, bool is_random) {
  const auto context = render::EglContext::create();
  if (!context) {
    state.SkipWithError(context.error().text.c_str());
    return;
  }
  const auto layers = layers_named({"points", "delaunay"});
  Graph graph{builtins()};
  graph.set_demand(layers);
  FramePatch patch;
  JobControl job;
  std::vector<Vec2> points = test::benchmark_curve(n);
  if (is_random) {
    Rng rng(8);
    for (Vec2& p : points) p = {1000.0 * rng.uniform(), 1000.0 * rng.uniform()};
  }
  graph.post(replace_with(Document(), points));
  graph.run(patch, job);
  LayerMirror mirror;
  mirror.apply(patch);
  const Box2 box = graph.structures().get<Samples>().extent();
  render::Camera whole;
  whole.set_viewport(kWidth, kHeight);
  whole.fit(box, 20.0);
  // About the first sample, as it is on the curve.
  render::Camera part = whole;
  part.look_at(points.front(), 0.1 * whole.units_per_pixel());
  const std::string what = is_random ? " at random" : " on a curve";
  for (auto _ : state) {
    for (const auto& [layer, kind, name] : {std::tuple(layers[1], PrimitiveKind::segment, "segments"),
                                            std::tuple(layers[0], PrimitiveKind::point, "points")}) {
      const std::span<const double> all = mirror.instances(layer, kind);
      const std::size_t stride = stride_of(kind);
      const std::size_t count = all.size() / stride;
      LayerStyle style = layer_descriptors()[layer].style;
      style.point_size_px = 2.0;
      const render::LayerView view{.layer = 0, .style = style};
      const FramePatch of_all = patch_of(kind, all);
      const double ours = moving_frame(of_all, view, whole, {}, 15);
      const double painted = moving_frame(of_all, view, whole, {.instance_cost_ns = 0.0}, 3);
      table.add({std::string("frame of ") + name + what, count, ours, painted, 0.1, "painting them"});
      std::vector<double> seen;
      const Vec2 half = 0.5 * part.units_per_pixel() * Vec2{1.2 * kWidth, 1.2 * kHeight};
      const auto is_near = [&](const double* p) {
        return std::abs(p[0] - part.center().x) < half.x && std::abs(p[1] - part.center().y) < half.y;
      };
      for (std::size_t at = 0; at < all.size(); at += stride)
        if (is_near(&all[at]) || (kind == PrimitiveKind::segment && is_near(&all[at + 2])))
          seen.insert(seen.end(), &all[at], &all[at] + stride);
      const double zoomed = moving_frame(of_all, view, part, {}, 15);
      table.add({std::string("frame zoomed to ") + std::to_string(seen.size() / stride) + " of the " + name + what,
                 count, zoomed, moving_frame(patch_of(kind, seen), view, part, {}, 15), 1.5,
                 "a frame of these alone"});
    }
  }
}

/// The first picture of the window, while it is panned and zoomed.
void moving_picture(benchmark::State& state, RatioTable& table, std::size_t n) {
  const auto context = render::EglContext::create();
  if (!context) {
    state.SkipWithError(context.error().text.c_str());
    return;
  }
  render::GlDevice device;
  render::Scene scene(device);
  const auto layers = layers_named({"interior-voronoi-disks", "curve", "medial-axis", "points"});
  Graph graph{builtins()};
  graph.set_demand(layers);
  FramePatch patch;
  JobControl job;
  graph.post(replace_with(Document(), test::benchmark_curve(n)));
  graph.run(patch, job);
  scene.apply(patch);
  auto views = views_of(layers);
  // As the window thins them where samples stand closer than pixels.
  for (render::LayerView& view : views) {
    view.style.point_size_px = 2.0;
    view.style.line_width_px = 1.0;
  }
  render::Camera camera;
  camera.set_viewport(kWidth, kHeight);
  camera.fit(graph.structures().get<Samples>().extent(), 20.0);
  const render::FramebufferId target = device.create_framebuffer({kWidth, kHeight});
  std::vector<double> times;
  int frame = 0;
  for (auto _ : state) {
    camera.pan({1.0, 0.5});
    camera.zoom_at({0.5 * kWidth, 0.5 * kHeight}, ++frame % 20 < 10 ? 1.02 : 1.0 / 1.02);
    const double start = now_us();
    device.clear(target, {0, 0, kWidth, kHeight}, {1, 1, 1, 1});
    scene.draw(camera, views, {.target = target, .preview = render::Preview::coarse});
    device.finish();
    times.push_back(1e-3 * (now_us() - start));
  }
  device.destroy_framebuffer(target);
  table.add_note("frame of the first picture at " + std::to_string(n) + " samples, panned and zoomed: median " +
                 std::to_string(median(times)) + " ms (goal 66)");
}

void against_minimal(benchmark::State& state, RatioTable& table, std::size_t n, double goal) {
  const auto context = render::EglContext::create();
  if (!context) {
    state.SkipWithError(context.error().text.c_str());
    return;
  }
  render::GlDevice device;
  const auto layers = layers_named({"delaunay"});
  Graph graph{builtins()};
  graph.set_demand(layers);
  FramePatch patch;
  JobControl job;
  graph.post(replace_with(Document(), test::benchmark_curve(n)));
  graph.run(patch, job);
  render::Scene scene(device);
  scene.apply(patch);
  LayerMirror mirror;
  mirror.apply(patch);
  render::Camera camera;
  camera.set_viewport(kWidth, kHeight);
  camera.fit(graph.structures().get<Samples>().extent(), 20.0);
  const auto views = views_of(layers);
  const render::FramebufferId target = device.create_framebuffer({kWidth, kHeight});
  const MinimalLoop minimal(mirror.instances(layers[0], PrimitiveKind::segment), camera);
  std::vector<double> ours;
  std::vector<double> raw;
  for (auto _ : state) {
    camera.pan({1.0, 0.0});  // nothing is drawn from what was counted before
    double start = now_us();
    device.clear(target, {0, 0, kWidth, kHeight}, {1, 1, 1, 1});
    scene.draw(camera, views, {.target = target, .overlays = false});
    device.finish();
    ours.push_back(now_us() - start);
    start = now_us();
    minimal.draw();
    raw.push_back(now_us() - start);
  }
  device.destroy_framebuffer(target);
  table.add({"frame of segments", scene.instances(layers[0], PrimitiveKind::segment), median(ours), median(raw), goal,
             "a minimal instanced draw loop"});
}

void first_picture(benchmark::State& state, RatioTable& table, std::size_t n) {
  const auto points = test::benchmark_curve(n);
  std::vector<double> times;
  for (auto _ : state) {
    const double start = now_us();
    const auto context = render::EglContext::create();
    if (!context) {
      state.SkipWithError(context.error().text.c_str());
      return;
    }
    render::GlDevice device;
    const auto layers = layers_named({"interior-voronoi-disks", "curve", "medial-axis", "points"});
    Graph graph{builtins()};
    graph.set_demand(layers);
    FramePatch patch;
    JobControl job;
    graph.post(replace_with(Document(), points));
    graph.run(patch, job);
    render::Scene scene(device);
    scene.apply(patch);
    render::Camera camera;
    camera.set_viewport(kWidth, kHeight);
    camera.fit(graph.structures().get<Samples>().extent(), 20.0);
    const auto image =
        render::draw_image(device, scene, camera, views_of(layers), {.background = Rgb{255, 255, 255}});
    benchmark::DoNotOptimize(image);
    times.push_back(1e-3 * (now_us() - start));
  }
  table.add_note("from samples to the first picture, context included, " + std::to_string(n) + " samples: median " +
                 std::to_string(median(times)) + " ms");
}

}  // namespace

void register_drawing(RatioTable& table) {
  benchmark::RegisterBenchmark("upload/move/100000",
                               [&table](benchmark::State& state) { upload(state, table, 100000); })
      ->Iterations(2000)
      ->Unit(benchmark::kMicrosecond);
  for (const std::size_t n : {std::size_t{3000}, std::size_t{30000}, std::size_t{300000}}) {
    benchmark::RegisterBenchmark(("frame/delaunay/" + std::to_string(n)).c_str(),
                                 [&table, n](benchmark::State& state) { frame(state, table, n); })
        ->Iterations(n >= 300000 ? 5 : 20)
        ->Unit(benchmark::kMillisecond);
  }
  for (const std::size_t n : {std::size_t{30000}, std::size_t{335000}}) {
    benchmark::RegisterBenchmark(
        ("against_minimal/" + std::to_string(n)).c_str(),
        [&table, n](benchmark::State& state) { against_minimal(state, table, n, n > 100000 ? 1.15 : 0.0); })
        ->Iterations(n > 100000 ? 7 : 15)
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::RegisterBenchmark("large_disks/20000",
                               [&table](benchmark::State& state) { large_disks(state, table, 20000); })
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
  for (const std::size_t n : {std::size_t{100000}, std::size_t{1000000}}) {
    benchmark::RegisterBenchmark(("moving_picture/" + std::to_string(n)).c_str(),
                                 [&table, n](benchmark::State& state) { moving_picture(state, table, n); })
        ->Iterations(20)
        ->Unit(benchmark::kMillisecond);
  }
  for (const bool is_random : {false, true}) {
    benchmark::RegisterBenchmark(
        is_random ? "many_strokes/random" : "many_strokes/curve",
        [&table, is_random](benchmark::State& state) { many_strokes(state, table, 335000, is_random); })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
  for (const std::size_t n : {std::size_t{1000}, std::size_t{100000}}) {
    benchmark::RegisterBenchmark(("first_picture/" + std::to_string(n)).c_str(),
                                 [&table, n](benchmark::State& state) { first_picture(state, table, n); })
        ->Iterations(5)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace mes::bench
