#include "coupling/measured/placed_json.hpp"

#include "coupling/quote.hpp"
#include "coupling/watched_byte.hpp"
#include "dem/expect.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace coupling::measured {
namespace {

using Kind = PlacedJson::Kind;

/// Builds the tree from the parser's events; nlohmann's own document keeps neither lines nor the
/// first of two equal keys.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
public:
  TreeBuilder(std::string_view text, std::string const& file) : file_(file), text_(text) {
    root_.file = file;
  }

  WatchedText& text() { return text_; }
  PlacedJson finish() { return std::move(root_); }

  bool null() override { return leaf(Kind::null, "null"); }
  bool boolean(bool truth) override { return leaf(Kind::truth, truth ? "true" : "false"); }
  bool number_integer(number_integer_t n) override {
    return leaf(Kind::number, fmt::format("{}", n));
  }
  bool number_unsigned(number_unsigned_t n) override {
    return leaf(Kind::number, fmt::format("{}", n));
  }
  bool number_float(number_float_t, string_t const& text) override {
    return leaf(Kind::number, text);
  }
  bool string(string_t& text) override { return leaf(Kind::text, text); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Kind::object); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(Kind::list); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    if (auto const* const first = open_.back()->find(name))
      throw dem::InvalidInput(
          fmt::format("{}:{}: '{}' is set twice (first on line {}). Remove one?", file_,
                      text_.line(), quote(first->path), first->line));
    key_ = name;
    return true;
  }

  bool parse_error(std::size_t, std::string const&, nlohmann::detail::exception const&) override {
    throw dem::InvalidInput(
        fmt::format("{}:{}: is no JSON. Is a comma, quote or bracket missing or left over?", file_,
                    text_.line()));
  }

private:
  PlacedJson& add(Kind kind, std::string text) {
    PlacedJson node{.kind = kind, .file = file_, .line = text_.line(), .text = std::move(text)};
    if (open_.empty())
      return root_ = std::move(node);
    PlacedJson& parent = *open_.back();
    if (parent.is(Kind::list)) {
      node.path = fmt::format("{}[{}]", parent.path, parent.items.size());
      return parent.items.emplace_back(std::move(node));
    }
    node.path = parent.path.empty() ? key_ : fmt::format("{}/{}", parent.path, key_);
    return parent.members.emplace_back(key_, std::move(node)).second;
  }
  bool leaf(Kind kind, std::string text) {
    add(kind, std::move(text));
    return true;
  }
  bool open(Kind kind) {
    // Measured data nest five deep; without a limit a hostile file would exhaust the stack.
    constexpr std::size_t deepest = 16;
    PlacedJson& node = add(kind, kind == Kind::list ? "[...]" : "{...}");
    if (open_.size() >= deepest)
      node.refuse("is nested too deeply (no entry lies so deep). Is it the right file?");
    open_.push_back(&node); // stays where it is: its parent grows only after it is closed
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  std::string file_;
  PlacedJson root_;
  std::vector<PlacedJson*> open_;
  std::string key_;
  WatchedText text_;
};

} // namespace

PlacedJson const* PlacedJson::find(std::string_view name) const {
  auto const found =
      std::ranges::find_if(members, [&](auto const& member) { return member.first == name; });
  return found == members.end() ? nullptr : &found->second;
}

void PlacedJson::refuse(std::string_view problem) const {
  auto const entry = path.empty() ? "" : fmt::format(" {} = {}:", quote(path), quote(text));
  throw dem::InvalidInput(fmt::format("{}:{}:{} {}", file, line, entry, problem));
}

PlacedJson parse_placed_json(std::string_view text, std::string const& file) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text.starts_with(byte_order_mark))
    text.remove_prefix(byte_order_mark.size());
  TreeBuilder builder(text, file);
  nlohmann::json::sax_parse(builder.text().begin(), builder.text().end(), &builder);
  return builder.finish();
}

} // namespace coupling::measured
