// SPDX-License-Identifier: GPL-3.0-or-later
// PNG, JPEG, BMP, PBM, PGM, PPM and PAM: samples of the outlines of objects in a picture. A picture of this program
// that carries a session is read as that session (core/io/carried_session.h).
#include <span>
#include <string>
#include <utility>

#include "core/io/curve_samples.h"
#include "core/io/format_spec.h"
#include "core/io/text/text_numbers.h"
#include "core/raster/picture_decoder.h"
#include "core/raster/trace.h"

namespace mes {
namespace {

Match match_picture(std::string_view bytes) {
  return looks_like_picture(bytes) ? Match::surely : Match::no;
}

Expected<LoadedFile> read_traced(std::string_view bytes, const std::string& name, const TraceRequest& request,
                                 ReadJob& job) {
  auto pixels = decode_pixels(std::as_bytes(std::span(bytes)), name, 0, kMostPicturePixels, PictureTurn::upright,
                              job.control());
  if (!pixels) return std::unexpected(std::move(pixels.error()));
  job.checkpoint();
  const bool lacks_end = pixels->lacks_end;
  auto tracing = trace(gray_of(*std::move(pixels)), request, job.control());
  if (!tracing) return std::unexpected(Error{tracing.error().code, tracing.error().text, name});
  std::string remark = name + ": " + remark_of(*tracing);
  const SamplingRequest sampling = sampling_of_tracing(tracing->curves);
  auto file = load_samples(std::move(tracing->curves), sampling, name, job);
  if (file) file->warnings.push_back(std::move(remark));
  if (file && lacks_end)
    file->warnings.push_back(name + ": the marker that ends a JPEG is missing; its pixels are all there");
  return file;
}

Expected<LoadedFile> read_picture(std::string_view bytes, const std::string& name, ReadJob& job) {
  return read_traced(bytes, name, {}, job);
}

}  // namespace

Format picture_format() {
  return {.descriptor = {.id = "picture",
                         .name = "Silhouette or photograph: PNG, JPEG, BMP, PGM",
                         .extensions = {std::begin(kPictureExtensions), std::end(kPictureExtensions)},
                         .can_read = true},
          .match = match_picture,
          .read = read_picture,
          .read_traced = read_traced,
          .may_look_foreign = true};
}

}  // namespace mes
