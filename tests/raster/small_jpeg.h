// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace mes::test {

/// A disk and a rectangle in colour, 40 x 28, as base64. Written by ImageMagick.
constexpr std::string_view kJpeg =
    "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDAAoHBwgHBgoICAgLCgoLDhgQDg0NDh0VFhEYIx8lJCIfIiEmKzcvJik0KSEiMEExNDk7Pj4+"
    "JS5ESUM8SDc9Pjv/2wBDAQoLCw4NDhwQEBw7KCIoOzs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7Ozs7"
    "Ozv/wAARCAAcACgDASIAAhEBAxEB/8QAGQAAAgMBAAAAAAAAAAAAAAAAAAcEBQYI/8QAKhAAAQMDAgQFBQAAAAAAAAAAAQIDBAAFEQYh"
    "BxMxgRIUQVFxMzZydLL/xAAZAQEAAgMAAAAAAAAAAAAAAAADAAUBAgT/xAAdEQACAgIDAQAAAAAAAAAAAAABAgADBBEFEjET/9oADAMB"
    "AAIRAxEAPwBzVAu97ttii+ZuUpLCCcJBBKlH2AG5qfSH15dHrnq2dzFK5cZwsNIPRIScHHycnvTU1fRtGHY/URkQ+J+m5cnkrckRgTgO"
    "PNYSe4Jx3xVJcuJN2i3SXHjsQHGWnlobWUKPiSFEA5CsHalfVk19JH4ig5JPiqlD7LPh1S92Fg3oRqaN1lcdRXd2JLZiobRHLgLSVA5C"
    "kj1UdtzRVBwv+5JH6av7RRQYzFq9mTkK0rv6oNDUalKriJoqcq5u3q2MLkNP4LzTacqQrpkAbkHr85pq0V2V2GttiVzKGGjOb4druFwk"
    "+Whwn33c4KUIJKfn271uWeF995DfikQUK8IykuLyNumyaa9FYymGQAGHkbEtfFJKH2YrRujbjp27uy5b0Vba45bAaUonJUk+qRtsaK2t"
    "FCiBBoTa657n7v7P/9k=";

}  // namespace mes::test
