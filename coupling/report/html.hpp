#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>

/// Text for HTML pages. Whatever a person wrote goes through one of the escapes before it meets a
/// page.
namespace coupling {

/// For element content and quoted attributes: & < > " ' become entities.
std::string escape_html(std::string_view text);

/// For JSON inside a script element: '<', '>' and '&' become \u00xx, so no "</script>" and no
/// comment can arise.
std::string escape_json_in_script(std::string_view json);

/// For code inside a script element: "</script" and "<!--" keep their meaning in string literals
/// but no longer end or open anything in HTML.
std::string escape_inline_script(std::string_view code);

/// A number with its unit in the size people say it: 1471 N -> "1.471 kN", 8e-3 m -> "8.000 mm",
/// 0.41 "1" -> "0.4100". Not a number -> "not reached".
std::string format_quantity(double value, std::string_view unit, int digits = 4);

/// Replaces each {{name}} once, in one pass: a value that contains "{{...}}" is not looked at
/// again.
/// @throws std::out_of_range if the template asks for a name that `values` lacks
std::string fill_template(std::string_view page,
                          std::map<std::string, std::string, std::less<>> const& values);

/// RFC 4648, with padding.
std::string encode_base64(std::span<std::byte const> bytes);

} // namespace coupling
