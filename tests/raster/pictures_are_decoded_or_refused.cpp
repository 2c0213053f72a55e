// SPDX-License-Identifier: GPL-3.0-or-later
// BMP, PBM, PGM, PPM and PAM, written here byte by byte; PNG is in tests/render. Truncated and damaged pictures
// are refused.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/base/base64.h"
#include "core/raster/picture_decoder.h"
#include "tests/raster/small_jpeg.h"

using namespace mes;
using mes::test::kJpeg;

namespace {

Expected<Pixels> decoded(const std::string& bytes, int channels = 0) {
  return decode_pixels(std::as_bytes(std::span(bytes)), "a", channels);
}

std::string refusal(const std::string& bytes) {
  const auto pixels = decoded(bytes);
  REQUIRE_FALSE(pixels.has_value());
  return pixels.error().message();
}

std::string number(std::uint32_t value, int bytes) {
  std::string out;
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> (8 * i) & 0xFFU);
  return out;
}

/// The two headers of a BMP, of `colors` in its palette.
std::string bmp(std::uint32_t width, std::uint32_t height, std::uint32_t bits, std::uint32_t colors) {
  return "BM" + number(0, 8) + number(54 + 4 * colors, 4) + number(40, 4) + number(width, 4) + number(height, 4) +
         number(1, 2) + number(bits, 2) + number(0, 24);
}

const std::string kBroken = "a: the picture is broken: ";

/// The picture of kJpeg in as many scans as a progressive picture has. Written by ImageMagick.
constexpr std::string_view kProgressiveJpeg =
    "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDAAoHBwgHBgoICAgLCgoLDhgQDg0NDh0VFhEYIx8lJCIfIiEmKzcvJik0KSEiMEExNDk7Pj4+"
    "JS5ESUM8SDc9Pjv/2wBDAQoLCw4NDhwQEBw7KCIoOzs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7"
    "Ozv/wgARCAAcACgDASIAAhEBAxEB/8QAGAAAAwEBAAAAAAAAAAAAAAAAAAQGBQf/xAAYAQEAAwEAAAAAAAAAAAAAAAACAQMEAP/aAAwD"
    "AQACEAMQAAABs12INmkRl2a9NUIA6qlKsuz833Kwh4htgn//xAAeEAACAgICAwAAAAAAAAAAAAADBAIFAAEREyAxNP/aAAgBAQABBQLC"
    "mGCMLNaUiWRYlTcIwXHy7I3mvVX9OWKU+yAiElqrPwmmRcvj/8QAGxEAAgIDAQAAAAAAAAAAAAAAAQIAEQMEEjH/2gAIAQMBAT8BY1NM"
    "ByepsKFehCLmJji8juXNmf/EABwRAAICAgMAAAAAAAAAAAAAAAABAhEDEgQTMf/aAAgBAgEBPwGEdmclaJUY3cSMtWZX2eiVH//EACEQ"
    "AAICAQQCAwAAAAAAAAAAAAECABESAxAhMSAiYXKR/9oACAEBAAY/AplqNUq2X5IjKoQgHiFWC1jfGz30pobt9NjraYyB7AmKISYPZP2F"
    "mK1jXHl//8QAIhAAAQMDAwUAAAAAAAAAAAAAAQARMRAhUSBhcUGBobHR/9oACAEBAAE/IU3WPTJTq9gkbTUExuH5Q28IByN6OaNhYakH"
    "C8h7FCTeDLgrYAwEK8glod8R28pByNtX/9oADAMBAAIAAwAAABBB/FBLL//EABgRAQEBAQEAAAAAAAAAAAAAAAERADFB/9oACAEDAQE/"
    "EIsHCw0KwmARzyvu9L7/xAAYEQEBAQEBAAAAAAAAAAAAAAABABExIf/aAAgBAgEBPxDxG1D7NoyaEAAcjOF//8QAHxABAAIBBAMBAAAA"
    "AAAAAAAAAREhABAxcYEgQVGh/9oACAEBAAE/EMnUbARU+AW5C0rBBXYsdxiiZa0CBkg1iXlBIyB7VW6WME/YKGOWXvT87UHCbtlNlIFo"
    "78zlhvhWvL53mxhJUpW1YS8oDGVPYqny/9k=";

/// A black square from (6, 5) to (14, 13) on white, 24 x 20, with a restart marker after each block of pixels. Written
/// by libjpeg.
constexpr std::string_view kRestartJpeg =
    "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDAAMCAgMCAgMDAwMEAwMEBQgFBQQEBQoHBwYIDAoMDAsKCwsNDhIQDQ4RDgsLEBYQERMUFRUVDA8X"
    "GBYUGBIUFRT/wAALCAAUABgBAREA/8QAFgABAQEAAAAAAAAAAAAAAAAACQcI/8QAJRAAAQIFBAIDAQAAAAAAAAAAAQIDBAUGBxEACBMUCSES"
    "FTEi/90ABAAB/9oACAEBAAA/AETv3euR7drTz24VSQswjZLJ+DsMSttDkQrlfbYT8ErWhJwp1JOVD0D+n0f/0Lpb3y7WeuVX9NUhLKbrhiZT"
    "+Zw0qhXYuAg0sodfdS0hSymLUQkKWCSATjOAfzX/0VT1/9Lae/W1tT3p2nVzRtGyz7mpJl0epBdhpjk44+HdX/bqkoGENrPtQzjA9kDX/9OJ"
    "7evHDuJoa/ttKkndvOlJZPU0smEdE/dy5zhYaim3HF/FEQVKwlJOEgk49AnX/9RU9f/VVPX/1lT1/9dU9f/Z";

/// The same square in magenta and yellow ink, as CMYK and as YCCK, both with the marker of Adobe. Written by libjpeg.
constexpr std::string_view kCmykJpeg =
    "/9j/7gAOQWRvYmUAZAAAAAAA/9sAQwADAgIDAgIDAwMDBAMDBAUIBQUEBAUKBwcGCAwKDAwLCgsLDQ4SEA0OEQ4LCxAWEBETFBUVFQwPFxgW"
    "FBgSFBUU/8AAFAgAFAAYBEMRAE0RAFkRAEsRAP/EABYAAQEBAAAAAAAAAAAAAAAAAAAJCP/EACUQAAECBgEEAwEAAAAAAAAAAAECAwAEBQYH"
    "EQgJExQhEhUxIv/aAA4EQwBNAFkASwAAPwCqcUTz3muh8dsT13IVyStQnaLR+x5DFLbQ5MK7r7bCfgla0JOlOpJ2oegf0+jRPPea6Hx2xPXc"
    "hXJK1CdotH7HkMUttDkwruvtsJ+CVrQk6U6knah6B/T6NU4RmDHvV2w9kq/7atCmW3fDFSr9TlqVKuzchJpZQ6+6lpCllM2ohIUsEkAnW9A/"
    "kZgx71dsPZKv+2rQplt3wxUq/U5alSrs3ISaWUOvupaQpZTNqISFLBJAJ1vQP5CEbfjb8IRn/nri25808Tr5s2zaZ9zclS8HxJLyGmO525+X"
    "dX/bqkoGkNrPtQ3rQ9kCM/8APXFtz5p4nXzZtm0z7m5Kl4PiSXkNMdztz8u6v+3VJQNIbWfahvWh7IEIRMDj104eRNjZ9xpclbx54VFo9zUy"
    "oT0z93TnOyw1NNuOL+KJgqVpKSdJBJ16BMTA49dOHkTY2fcaXJW8eeFRaPc1MqE9M/d05zssNTTbji/iiYKlaSknSQSdegTCEW/i38IQhCEI"
    "QhCEI//Z";
constexpr std::string_view kYcckJpeg =
    "/9j/7gAOQWRvYmUAZAAAAAAC/9sAQwADAgIDAgIDAwMDBAMDBAUIBQUEBAUKBwcGCAwKDAwLCgsLDQ4SEA0OEQ4LCxAWEBETFBUVFQwPFxgW"
    "FBgSFBUU/9sAQwEDBAQFBAUJBQUJFA0LDRQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQU/8AAFAgA"
    "FAAYBAEiAAIRAQMRAQQiAP/EABcAAQEBAQAAAAAAAAAAAAAAAAAJBwj/xAAoEAABAwMDAgYDAAAAAAAAAAABAAIDBAUGBxETCBIJFBUhIkEx"
    "UXH/xAAWAQEBAQAAAAAAAAAAAAAAAAAABgf/xAAhEQACAgICAQUAAAAAAAAAAAABAgAEBREDQQYSISIxcf/aAA4EAQACEQMRBAAAPwCa2lOm"
    "l01gz614jZp6SmuVx5eKWue5kLeOJ8ru4ta4j4sIGwPvt/VuGX+HzqJheJ3rIa684xLRWminr546eqqDI6OKNz3BoMABcQ07bkDf7CzzpTzm"
    "x6a6+YvkeR1vp1movNc9TxPl7O+lmjb8WNc47ue0ewP5/S7g1d6ydH8o0nzWzWzL/M3K42StpKWD0ysZySyQPYxvc6EAbuIG5IA+yqTH1aPN"
    "Wd7DgOCdD1AdDXt+zE/MM55Vjs5Wq4auz12VCzDjZwCXYN8gNDSgHXX33KpoiKYyIim5tkIiIiIkQiIiIiRCIi//2Q==";

}  // namespace

TEST_CASE("PGM and PPM are read with comments between their numbers") {
  const auto gray =
      decoded("P5 # a comment\n3\t2\n# and another\n255\n" + std::string("\x00\x01\x02\x7f\x80\xff", 6));
  REQUIRE(gray.has_value());
  CHECK(gray->width == 3);
  CHECK(gray->height == 2);
  CHECK(gray->channels == 1);
  CHECK(gray->values == std::vector<std::uint8_t>{0, 1, 2, 127, 128, 255});
  const auto color = decoded("P6 1 1 255 abc");
  REQUIRE(color.has_value());
  CHECK(color->values == std::vector<std::uint8_t>{'a', 'b', 'c'});
  CHECK(looks_like_picture("P5\n1 1 255 x"));
  CHECK_FALSE(looks_like_picture("P5x"));
  CHECK_FALSE(looks_like_picture("POFF\n1 0 0\n"));
}

TEST_CASE("a JPEG that is cut within its pixels is refused") {
  using namespace std::string_literals;
  const std::string whole = from_base64(kJpeg);
  const auto picture = decoded(whole);
  REQUIRE(picture.has_value());
  const std::string cut = whole.substr(0, whole.size() - 40);
  CHECK(refusal(cut) == kBroken + "the file ends at byte " + std::to_string(cut.size()) + ", before its last pixels");
  // Bytes after the end are ignored.
  const auto longer = decoded(whole + " and more"s);
  REQUIRE(longer.has_value());
  CHECK(longer->values == picture->values);
  CHECK_FALSE(longer->lacks_end);
  // The end of a thumbnail in another segment is not that of the picture.
  const std::string thumbnail = "\xFF\xE1\x00\x06\xFF\xDA\xFF\xD9"s;
  CHECK(decoded(whole.substr(0, 2) + thumbnail + whole.substr(2))->values == picture->values);
  CHECK(refusal(cut.substr(0, 2) + thumbnail + cut.substr(2)).starts_with(kBroken + "the file ends at byte "));
  // A scan without a frame.
  CHECK(refusal("\xFF\xD8\xFF\xDA\x00\x03\x01\x12\xFF\x00\x34\xFF\xD0\x56"s).starts_with(kBroken));
}

TEST_CASE("a JPEG with damaged pixels is refused, with the byte up to which it was read") {
  const std::string whole = from_base64(kJpeg);
  std::size_t refused = 0;
  for (std::size_t i = whole.size() - 60; i < whole.size() - 10; ++i) {
    std::string damaged = whole;
    damaged[i] = '\xFF';
    damaged[i + 1] = '\xD9';  // the end, too early
    INFO(i);
    const auto pixels = decoded(damaged);
    if (pixels) continue;
    CHECK(pixels.error().message().starts_with(kBroken + "before byte "));
    ++refused;
  }
  CHECK(refused >= 49);
}

TEST_CASE("a JPEG of many scans is refused") {
  const std::string whole = from_base64(kProgressiveJpeg);
  const std::size_t scan = whole.rfind("\xFF\xDA");
  const std::string last = whole.substr(scan, whole.size() - scan - 2);
  std::string many = whole.substr(0, scan);
  for (int i = 0; i < 70; ++i) many += last;
  CHECK(refusal(many + "\xFF\xD9").contains("it has more than 64 scans"));
}

TEST_CASE("a JPEG in inks becomes RGB") {
  for (const std::string_view text : {kCmykJpeg, kYcckJpeg}) {
    const auto pixels = decoded(from_base64(text));
    REQUIRE(pixels.has_value());
    CHECK(pixels->channels == 3);
    REQUIRE(pixels->values.size() == 24 * 20 * 3);
    const auto color = [&](std::size_t x, std::size_t y) { return &pixels->values[3 * (24 * y + x)]; };
    for (int k = 0; k < 3; ++k) CHECK(std::abs(color(1, 1)[k] - 255) <= 12);
    CHECK(std::abs(color(10, 9)[0] - 255) <= 12);
    CHECK(color(10, 9)[1] <= 12);
    CHECK(color(10, 9)[2] <= 12);
  }
}

TEST_CASE("a JPEG that lacks only its last marker is a picture, and one that lacks more is refused") {
  for (const std::string_view text : {kJpeg, kProgressiveJpeg}) {
    const std::string whole = from_base64(text);
    const auto picture = decoded(whole);
    REQUIRE(picture.has_value());
    CHECK(picture->width == 40);
    CHECK_FALSE(picture->lacks_end);
    std::size_t refused = 0;
    std::size_t accepted = 0;
    for (std::size_t size = 0; size + 2 < whole.size(); ++size) {
      INFO(size);
      const auto cut = decoded(whole.substr(0, size));
      // The last bits may be of no effect.
      if (cut) REQUIRE(cut->values == picture->values);
      ++(cut ? accepted : refused);
    }
    CHECK(accepted <= 1);
    CHECK(refused + 4 > whole.size() - 2);
    for (const std::string& end : {std::string(), std::string("\xFF"), std::string("\n"), std::string(100, '\0')}) {
      const auto cut = decoded(whole.substr(0, whole.size() - 2) + end);
      REQUIRE(cut.has_value());
      CHECK(cut->values == picture->values);
      CHECK(cut->lacks_end);
    }
  }
}

TEST_CASE("a JPEG with restart markers lacks nothing but its last marker, or is refused") {
  const std::string whole = from_base64(kRestartJpeg);
  const auto picture = decoded(whole);
  REQUIRE(picture.has_value());
  CHECK(picture->values[24 * 9 + 10] <= 12);
  CHECK(picture->values[0] >= 243);
  const auto without_end = decoded(whole.substr(0, whole.size() - 2));
  REQUIRE(without_end.has_value());
  CHECK(without_end->values == picture->values);
  CHECK(without_end->lacks_end);
  std::size_t accepted = 0;
  for (std::size_t size = 2; size + 2 < whole.size(); ++size) accepted += decoded(whole.substr(0, size)) ? 1U : 0U;
  CHECK(accepted <= 1);  // the last bits may be of no effect
}

TEST_CASE("PGM and PPM that lack what they announce are refused") {
  CHECK(refusal("P5 2 2 255 abc") == kBroken + "the file ends in row 2 of 2");
  CHECK(refusal("P5 2 2 255 a") == kBroken + "the file ends in row 1 of 2");
  CHECK(refusal("P5 2 2 255") == kBroken + "the file ends in row 1 of 2");
  CHECK(refusal("P6 1 1 255 ab") == kBroken + "the file ends in row 1 of 1");
  CHECK(refusal("P5 30000 30000 255 a") == kBroken + "the file ends in row 1 of 30000");
  for (const char* header : {"P5", "P5 ", "P5 a", "P5 1 1", "P5 1 1 0 a", "P5 99999999999 1 255 a", "P5 -1 1 255 a"})
    CHECK(refusal(header) == "a: the picture is broken: its header is not that of a PGM or PPM");
  CHECK(refusal("P5 0 0 255 ").starts_with("a: "));
}

TEST_CASE("BMP is read from below and from above") {
  const std::string rows = std::string("\x01\x02\x03\x00", 4) + std::string("\xff\xff\xff\x00", 4);
  const auto from_below = decoded(bmp(1, 2, 24, 0) + rows);
  REQUIRE(from_below.has_value());
  CHECK(from_below->values == std::vector<std::uint8_t>{255, 255, 255, 3, 2, 1});
  const auto from_above = decoded(bmp(1, static_cast<std::uint32_t>(-2), 24, 0) + rows);
  REQUIRE(from_above.has_value());
  CHECK(from_above->height == 2);
  CHECK(from_above->values == std::vector<std::uint8_t>{3, 2, 1, 255, 255, 255});
  // Two colours, a bit a pixel.
  const auto bits = decoded(bmp(3, 1, 1, 2) + std::string("\x00\x00\x00\x00\xff\xff\xff\x00", 8) +
                            std::string("\xa0\x00\x00\x00", 4));
  REQUIRE(bits.has_value());
  CHECK(gray_of(*bits).values == std::vector<std::uint8_t>{255, 0, 255});
}

TEST_CASE("BMP with less than it announces is refused") {
  const std::string palette("\x00\x00\x00\x00\xff\xff\xff\x00", 8);
  CHECK(refusal(bmp(3, 2, 8, 2) + palette + std::string(7, '\0')) == kBroken + "the file ends in row 2 of 2");
  CHECK(decoded(bmp(3, 2, 8, 2) + palette + std::string(8, '\0')).has_value());
  CHECK(refusal(bmp(3, 2, 8, 2) + palette + std::string(8, '\2')) ==
        kBroken + "at byte 62: there is a colour that its palette lacks");
  CHECK(refusal(bmp(3, 2, 8, 2) + palette + std::string(5, '\1') + std::string(3, '\2')) ==
        kBroken + "at byte 67: there is a colour that its palette lacks");
  std::string moved = bmp(3, 2, 8, 2) + palette + std::string(8, '\0');
  moved[11] = '\1';
  CHECK(refusal(moved) == kBroken + "at byte 10: its pixels cannot begin at byte 318");
  CHECK(refusal(bmp(1, 1, 24, 0).substr(0, 30)).starts_with("a: "));
  CHECK(refusal(bmp(30000, 30000, 24, 0)) == kBroken + "the file ends in row 1 of 30000");
  CHECK(refusal(bmp(1, 0x80000000U, 24, 0) + std::string(8, '\0')).starts_with("a: "));
  CHECK(refusal(bmp(8, 0, 24, 0)) == kBroken + "it has 8x0 pixels");
}

TEST_CASE("a picture becomes grey by its alpha where that is a silhouette, and by its lightness on white elsewhere") {
  Pixels pixels{2, 1, 4, {255, 0, 0, 255, 0, 0, 0, 0}};
  CHECK(gray_of(pixels).values == std::vector<std::uint8_t>{255, 0});
  pixels.values[7] = 128;
  CHECK(gray_of(pixels).values == std::vector<std::uint8_t>{54, 127});
  CHECK(gray_of({2, 1, 3, {255, 255, 255, 0, 255, 0}}).values == std::vector<std::uint8_t>{255, 182});
  CHECK(gray_of({2, 1, 2, {9, 255, 9, 10}}).values == std::vector<std::uint8_t>{255, 10});
  CHECK(gray_of({2, 1, 1, {9, 200}}).values == std::vector<std::uint8_t>{9, 200});
}

TEST_CASE("a picture is halved by the means of four pixels") {
  const GrayImage image{3, 3, {0, 4, 8, 4, 8, 12, 100, 102, 7}};
  CHECK(halved(image) == GrayImage{2, 2, {4, 10, 101, 7}});
}

TEST_CASE("plain pictures of Netpbm are the binary ones") {
  using namespace std::string_literals;
  using Values = std::vector<std::uint8_t>;
  const Values gray{0, 100, 255, 255, 100, 0};
  for (const std::string& bytes :
       {"P5\n3 2\n255\n\0\x64\xff\xff\x64\0"s, "P2\n# one\n3 2 # two\n255\n0 100 255\n255\t100\n\n0"s,
        "P2 3 2 255 0 100 255 # three\n 255 100 0 and more"s, "P5 3 2 65535 \0\xff\x64\0\xff\xff\xff\0\x64\xff\0\0"s,
        "P7\nWIDTH 3\nHEIGHT 2\n# PAM\nDEPTH 1\nMAXVAL 255\nTUPLTYPE GRAYSCALE\nENDHDR\n\0\x64\xff\xff\x64\0"s}) {
    INFO(bytes);
    CHECK(looks_like_picture(bytes));
    const auto pixels = decoded(bytes);
    REQUIRE(pixels.has_value());
    CHECK(pixels->width == 3);
    CHECK(pixels->height == 2);
    CHECK(pixels->channels == 1);
    CHECK(pixels->values == gray);
  }
  // One is black; bits need no blanks between them, and rows of bytes are filled up.
  const Values bits{255, 0, 255, 255, 0, 255, 255, 0, 255, 0, 255, 0, 255, 0, 255, 0, 255, 0, 0, 0};
  for (const std::string& bytes : {"P1\n10 2\n0 1 0 0 1 0 0 1 0 1\n0 1 0 1 0 1 0 1 1 1\n"s,
                                   "P1 #c\n10 2\n01001001010101\n010111"s, "P4\n10 2\n\x49\x40\x55\xc0"s}) {
    INFO(bytes);
    CHECK(looks_like_picture(bytes));
    const auto pixels = decoded(bytes);
    REQUIRE(pixels.has_value());
    CHECK(pixels->values == bits);
  }
  const Values color{255, 0, 128, 1, 2, 3};
  for (const std::string& bytes : {"P3 2 1 255 255 0 128 1 2 3"s, "P6 2 1 255 \xff\0\x80\1\2\3"s}) {
    const auto pixels = decoded(bytes);
    REQUIRE(pixels.has_value());
    CHECK(pixels->channels == 3);
    CHECK(pixels->values == color);
    CHECK(decoded(bytes, 4)->values == Values{255, 0, 128, 255, 1, 2, 3, 255});
  }
  // Values are scaled to the largest that there can be.
  CHECK(decoded("P2 4 1 15 0 5 15 20")->values == Values{0, 85, 255, 255});
  CHECK(decoded("P2 2 1 65535 65535 256")->values == Values{255, 1});
  CHECK(decoded("P5 2 1 1 \0\1"s)->values == Values{0, 255});
  CHECK(decoded("P7\nWIDTH 1\nHEIGHT 1\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\nabcd")->values ==
        Values{'a', 'b', 'c', 'd'});
}

TEST_CASE("pictures of Netpbm that are broken are refused where they are") {
  CHECK(refusal("P1 3 2 01001") == kBroken + "the file ends in row 2 of 2");
  CHECK(refusal("P1 3 2 010021") == kBroken + "there is no 0 or 1 in row 2 of 2");
  CHECK(refusal("P2 2 2 255 1 2 3") == kBroken + "the file ends in row 2 of 2");
  CHECK(refusal("P2 2 2 255 1 x 3") == kBroken + "there is no grey value or colour in row 1 of 2");
  CHECK(refusal("P3 1 1 255 1 2") == kBroken + "the file ends in row 1 of 1");
  CHECK(refusal("P4 9 2 abc") == kBroken + "the file ends in row 2 of 2");
  CHECK(refusal("P5 2 1 65535 abc") == kBroken + "the file ends in row 1 of 1");
  CHECK(refusal("P2 30000 30000 255 1") == kBroken + "the file ends in row 1 of 30000");
  CHECK(refusal("P1 40000 1 " + std::string(40000, '1')) == "a: a picture of 40000x1 pixels is too large to trace");
  CHECK(refusal("P2 9000 9000 255 1") == kBroken + "the file ends in row 1 of 9000");
  CHECK(refusal("P7\nWIDTH 1\nENDHDR\na") == kBroken + "its header is not that of a PAM");
  CHECK(refusal("P7\nWIDTH 1\nHEIGHT 1\nDEPTH 7\nMAXVAL 255\nENDHDR\na") ==
        kBroken + "its header is not that of a PAM");
  CHECK(refusal("P4 x") == kBroken + "its header is not that of a PBM");
  // Text that begins like them is none.
  for (const char* text : {"P1 P2\n1 2\n", "P1", "P2,P3\n1,2\n", "P1 1\n", "P3 \n", "P8 1 1 1", "P77"})
    CHECK_FALSE(looks_like_picture(text));
}

TEST_CASE("decoding is stopped at any row") {
  // Three black pixels on white, 5 x 4. Written by Pillow.
  constexpr std::string_view kPng =
      "iVBORw0KGgoAAAANSUhEUgAAAAUAAAAECAAAAABjWKqcAAAAGUlEQVR42gXBAQEAAAABoPj/"
      "mcqgImqZMg4scwQH85emFwAAAABJRU5ErkJggg==";
  for (const std::string_view text : {kPng, kJpeg, kProgressiveJpeg}) {
    const std::string bytes = from_base64(text);
    const auto expected = decoded(bytes);
    REQUIRE(expected);
    std::int64_t stopped = 0;
    for (std::int64_t look = 1;; ++look) {
      JobControl job;
      job.stop_at_look(look);
      try {
        const auto pixels =
            decode_pixels(std::as_bytes(std::span(bytes)), "a", 0, kMostPicturePixels, PictureTurn::upright, &job);
        REQUIRE(pixels);
        CHECK(pixels->values == expected->values);
        break;
      } catch (const Cancelled&) {
        ++stopped;
      }
    }
    CHECK(stopped >= expected->height / 2);
  }
}
