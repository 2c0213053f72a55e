// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/internal/pictures/jpeg_reader.h"

#include <jpeglib.h>
#include <cstdio>  // jpeglib.h needs it

#include <jerror.h>

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdint>
#include <new>
#include <utility>

namespace mes {
namespace {

constexpr int kMostScans = 64;

/// A call of libjpeg may jump out of `run`, which therefore owns nothing.
struct JpegRun {
  jpeg_decompress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg_progress_mgr progress{};
  std::jmp_buf jump{};
  std::array<char, JMSG_LENGTH_MAX> message{};
  bool lacks_memory = false;
  bool has_ended = false;   // before the marker that ends a picture
  bool is_damaged = false;  // pixels were made up
  Bytes bytes;
  const JobControl* job = nullptr;
  bool is_stopped = false;
  std::uint8_t* row = nullptr;
};

JpegRun& run_of(j_common_ptr jpeg) {
  return *static_cast<JpegRun*>(jpeg->client_data);
}

void keep_message(JpegRun& run) {
  if (run.message[0] == '\0')
    run.errors.format_message(reinterpret_cast<j_common_ptr>(&run.jpeg), run.message.data());
}

void fail_jpeg(j_common_ptr jpeg) {
  JpegRun& run = run_of(jpeg);
  run.lacks_memory = jpeg->err->msg_code == JERR_OUT_OF_MEMORY;
  keep_message(run);
  std::longjmp(run.jump, 1);
}

/// Warnings have a negative level. Bytes that belong to nothing, odd versions and profiles do no harm.
void hear(j_common_ptr jpeg, int level) {
  JpegRun& run = run_of(jpeg);
  if (level >= 0) return;
  switch (jpeg->err->msg_code) {
    case JWRN_JPEG_EOF: run.has_ended = true; break;
    case JWRN_HIT_MARKER:
    case JWRN_HUFF_BAD_CODE:
    case JWRN_ARITH_BAD_CODE:
    case JWRN_MUST_RESYNC:
    case JWRN_NOT_SEQUENTIAL:
      run.is_damaged = true;
      keep_message(run);
      break;
    default: break;
  }
}

void watch(j_common_ptr jpeg) {
  JpegRun& run = run_of(jpeg);
  run.is_stopped = run.job != nullptr && run.job->stop_requested();
  if (run.is_stopped) std::longjmp(run.jump, 1);
  if (run.jpeg.input_scan_number <= kMostScans) return;
  constexpr const char* kWhy = "it has more than 64 scans";
  std::copy_n(kWhy, std::char_traits<char>::length(kWhy) + 1, run.message.data());
  std::longjmp(run.jump, 1);
}

template <class Step>
bool succeeds(JpegRun& run, Step step) {
  if (setjmp(run.jump) != 0) return false;
  step(run);
  return true;
}

void read_jpeg_header(JpegRun& run) {
  run.jpeg.err = jpeg_std_error(&run.errors);
  run.jpeg.client_data = &run;
  run.errors.error_exit = fail_jpeg;
  run.errors.emit_message = hear;
  jpeg_create_decompress(&run.jpeg);
  run.progress.progress_monitor = watch;
  run.jpeg.progress = &run.progress;
  jpeg_mem_src(&run.jpeg, reinterpret_cast<const unsigned char*>(run.bytes.data()),
               static_cast<unsigned long>(run.bytes.size()));
  jpeg_read_header(&run.jpeg, TRUE);
  if (run.jpeg.num_components == 4) run.jpeg.out_color_space = JCS_CMYK;
}

void read_jpeg_rows(JpegRun& run) {
  while (run.jpeg.output_scanline < run.jpeg.output_height) {
    JSAMPROW row = run.row;
    jpeg_read_scanlines(&run.jpeg, &row, 1);
    run.row += static_cast<std::size_t>(run.jpeg.output_width) * static_cast<std::size_t>(run.jpeg.output_components);
  }
}

/// Every coefficient of every component was there, to its last bit.
bool has_all_scans(const jpeg_decompress_struct& jpeg) {
  for (int i = 0; i < jpeg.num_components; ++i) {
    if (jpeg.comp_info[i].quant_table == nullptr) return false;
    if (jpeg.progressive_mode != FALSE)
      for (int k = 0; k < DCTSIZE2; ++k)
        if (jpeg.coef_bits[i][k] != 0) return false;
  }
  return true;
}

/// Programs of Adobe write the complements of inks, and say who they are.
Pixels rgb_of_cmyk(Pixels pixels, bool is_complement) {
  std::size_t to = 0;
  for (std::size_t from = 0; from < pixels.values.size(); from += 4) {
    const auto lightness = [&](std::size_t i) {
      const unsigned value = pixels.values[from + i];
      return is_complement ? value : 255U - value;
    };
    const unsigned key = lightness(3);
    const std::array<unsigned, 3> rgb{lightness(0), lightness(1), lightness(2)};
    for (const unsigned value : rgb) pixels.values[to++] = static_cast<std::uint8_t>((value * key + 127U) / 255U);
  }
  pixels.values.resize(to);
  pixels.channels = 3;
  return pixels;
}

struct DestroyJpeg {
  JpegRun& run;
  ~DestroyJpeg() { jpeg_destroy_decompress(&run.jpeg); }
};

}  // namespace

Expected<Pixels> read_jpeg(Bytes bytes, const std::string& name, std::size_t most_pixels, const JobControl* job) {
  JpegRun run;
  run.bytes = bytes;
  run.job = job;
  const DestroyJpeg destroy{run};
  const auto broken = [&] {
    if (run.is_stopped) throw Cancelled{};
    if (run.lacks_memory) throw std::bad_alloc();
    const std::size_t left = run.jpeg.src != nullptr ? run.jpeg.src->bytes_in_buffer : 0;
    const std::string why =
        run.has_ended
            ? fmt::format("the file ends at byte {}, before its last pixels", bytes.size())
            : fmt::format("before byte {}: {}", bytes.size() - std::min(left, bytes.size()), run.message.data());
    return std::unexpected(broken_picture(why, name));
  };
  if (!succeeds(run, read_jpeg_header)) return broken();
  if (auto refused = refused_size(run.jpeg.image_width, run.jpeg.image_height, most_pixels, name))
    return std::unexpected(*std::move(refused));
  if (!succeeds(run, [](JpegRun& in) { jpeg_start_decompress(&in.jpeg); })) return broken();
  Pixels out{.width = static_cast<int>(run.jpeg.output_width),
             .height = static_cast<int>(run.jpeg.output_height),
             .channels = run.jpeg.output_components};
  out.values.resize(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height) *
                    static_cast<std::size_t>(out.channels));
  run.row = out.values.data();
  if (!succeeds(run, read_jpeg_rows)) return broken();
  const bool has_all = has_all_scans(run.jpeg);
  const bool is_complement = run.jpeg.saw_Adobe_marker != FALSE;
  if (!succeeds(run, [](JpegRun& in) { jpeg_finish_decompress(&in.jpeg); })) return broken();
  if (run.is_damaged || (run.has_ended && !has_all)) return broken();
  out.lacks_end = run.has_ended;
  return out.channels == 4 ? rgb_of_cmyk(std::move(out), is_complement) : out;
}

}  // namespace mes
