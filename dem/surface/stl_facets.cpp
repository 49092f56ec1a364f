#include "dem/surface/stl_facets.hpp"

#include "dem/expect.hpp"

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace dem {

namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");
constexpr std::size_t header_size = 84; // 80 bytes of anything, then the count
constexpr std::size_t record_size = 50; // normal, three corners, two bytes of anything

std::uint64_t stated_count(std::span<std::byte const> bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + header_size - sizeof count, sizeof count);
  return count;
}

/// Words of a text with the line that each stands on.
class Words {
public:
  explicit Words(std::string_view text) : text_(text) {}

  /// The next word, empty at the end of the text.
  std::string_view next() {
    while (at_ < text_.size() && is_space(text_[at_]))
      line_ += text_[at_++] == '\n';
    auto const begin = at_;
    while (at_ < text_.size() && !is_space(text_[at_]))
      ++at_;
    return text_.substr(begin, at_ - begin);
  }
  void skip_line() {
    while (at_ < text_.size() && text_[at_] != '\n')
      ++at_;
  }
  std::size_t line() const { return line_; }

private:
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

bool same_word(std::string_view word, std::string_view lower_case) {
  return std::ranges::equal(word, lower_case, {}, [](unsigned char c) { return std::tolower(c); });
}

/// A word as a message may quote it: short, and printable.
std::string quoted(std::string_view word) {
  constexpr std::size_t longest = 32;
  std::string result(word.substr(0, longest));
  std::ranges::replace_if(
      result, [](unsigned char c) { return std::isprint(c) == 0; }, '?');
  return "'" + result + (word.size() > longest ? "...'" : "'");
}

class AsciiParser {
public:
  AsciiParser(std::string_view text, std::string const& name) : words_(text), name_(name) {}

  std::vector<StlFacet> parse() {
    expect("solid");
    words_.skip_line();
    while (true) {
      auto const word = words_.next();
      if (same_word(word, "facet")) {
        facets_.push_back(facet());
      } else if (same_word(word, "endsolid")) {
        words_.skip_line();
        auto const after = words_.next();
        if (after.empty())
          return std::move(facets_);
        VALIDATE(same_word(after, "solid"), unexpected(after, "solid"));
        words_.skip_line();
      } else {
        refuse(word, "facet");
      }
    }
  }

private:
  StlFacet facet() {
    expect("normal");
    for (int k = 0; k < 3; ++k)
      number("facet normal", Finite::no); // 0 0 0 and nan are common here
    expect("outer");
    expect("loop");
    StlFacet corners;
    for (auto& corner : corners) {
      expect("vertex");
      for (double& x : corner)
        x = number("vertex", Finite::yes);
    }
    expect("endloop");
    expect("endfacet");
    return corners;
  }

  void expect(std::string_view keyword) {
    auto const word = words_.next();
    if (!same_word(word, keyword))
      refuse(word, keyword);
  }

  enum class Finite { no, yes };

  double number(std::string const& entry, Finite finite) {
    auto const word = words_.next();
    if (word.empty())
      refuse(word, "a number");
    auto const digits = word.starts_with('+') ? word.substr(1) : word; // from_chars knows no plus
    double value = 0.0;
    auto const [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    VALIDATE(error == std::errc{} && end == digits.data() + digits.size(),
             here() + ": " + entry + " = " + quoted(word) +
                 ": not a number. Was the file edited by hand?");
    VALIDATE(finite == Finite::no || std::isfinite(value),
             here() + ": " + entry + " = " + quoted(word) +
                 ": not a finite number (a tool needs a place). Export the file again?");
    return value;
  }

  std::string here() const { return name_ + ":" + std::to_string(words_.line()); }

  std::string unexpected(std::string_view word, std::string_view wanted) const {
    return here() + ": " + quoted(word) + " where '" + std::string(wanted) +
           "' should stand (the file is not a valid ASCII STL). Export it again?";
  }

  [[noreturn]] void refuse(std::string_view word, std::string_view wanted) const {
    if (word.empty())
      throw InvalidInput(here() + ": the file ends where '" + std::string(wanted) +
                         "' should stand (truncated). Export or copy it again?");
    throw InvalidInput(unexpected(word, wanted));
  }

  Words words_;
  std::string const& name_;
  std::vector<StlFacet> facets_;
};

} // namespace

bool is_binary_stl(std::span<std::byte const> bytes) {
  if (bytes.size() >= header_size &&
      bytes.size() == header_size + record_size * stated_count(bytes))
    return true;
  auto const start = bytes.first(std::min<std::size_t>(bytes.size(), 1024));
  return std::ranges::any_of(start, [](std::byte byte) {
    auto const c = std::to_integer<unsigned char>(byte);
    return c < 32 && !(c >= '\t' && c <= '\r');
  });
}

std::vector<StlFacet> parse_binary_stl(std::span<std::byte const> bytes, std::string const& name) {
  VALIDATE(bytes.size() >= header_size,
           name + ": " + std::to_string(bytes.size()) +
               " bytes are less than the 84 of a binary STL's header (truncated). "
               "Export or copy it again?");
  auto const count = stated_count(bytes);
  auto const needed = header_size + record_size * count;
  VALIDATE(needed == bytes.size(),
           name + ": triangle count = " + std::to_string(count) + " needs " +
               std::to_string(needed) + " bytes, the file has " + std::to_string(bytes.size()) +
               (bytes.size() < needed ? " (truncated, or the count is wrong)"
                                      : " (the count is wrong)") +
               ". Export or copy it again?");
  std::vector<StlFacet> facets(count);
  for (std::size_t t = 0; t < count; ++t) {
    std::array<float, 12> record; // the normal first
    std::memcpy(record.data(), bytes.data() + header_size + record_size * t, sizeof record);
    for (std::size_t k = 0; k < 9; ++k)
      facets[t][k / 3][static_cast<Eigen::Index>(k % 3)] = record[3 + k];
    for (auto const& corner : facets[t])
      VALIDATE(corner.allFinite(),
               name + ": triangle " + std::to_string(t + 1) +
                   ": a coordinate is not a finite number (a tool needs a place). "
                   "Export the file again?");
  }
  return facets;
}

std::vector<StlFacet> parse_ascii_stl(std::string_view text, std::string const& name) {
  return AsciiParser(text, name).parse();
}

} // namespace dem
