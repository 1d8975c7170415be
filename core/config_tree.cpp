#include "core/config_tree.hpp"

#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <sstream>

#include "core/printable.hpp"

namespace cogslam {
namespace {

constexpr std::size_t kMaxDepth = 32;
constexpr std::size_t kMaxKeys = 1000;
constexpr const char* kTooDeep = "nested too deep, expected at most 32 levels";

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

bool is_key(const std::string& text) {
  return !text.empty() && is_letter(text[0]) && text != "true" && text != "false" &&
         std::all_of(text.begin(), text.end(),
                     [](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '-'; });
}

/// Builds the tree from the parser's events. The node interface of yaml-cpp would silently resolve aliases and keep
/// both values of a duplicate key; the events show everything that the file says.
class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(const std::string& text, std::string name, bool with_lines)
      : text_(text), name_(std::move(name)), with_lines_(with_lines) {}

  ConfigTreePtr root = std::make_shared<ConfigTree>();

  [[nodiscard]] SourcePlace place(const YAML::Mark& mark) const {
    if (!with_lines_ || mark.is_null()) return {name_};
    return {name_, mark.line + 1, mark.column + 1};
  }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (started_) fail(mark, "a second document begins; expected one document");
    started_ = true;
  }
  void OnDocumentEnd() override {}
  void OnAnchor(const YAML::Mark& mark, const std::string& name) override {
    reject_anchor(mark, "anchor " + in_quotes("&" + name));
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { fail(mark, "alias; expected the value itself"); }

  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override {
    reject_key(mark, "nothing");
    put(ConfigTree{ConfigTree::Kind::kNothing, place(mark)});
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t, const std::string& value) override {
    reject_tag(mark, tag);
    reject_open_quote(mark, tag);
    if (awaits_key()) return take_key(mark, value);
    put(ConfigTree{ConfigTree::Kind::kText, place(mark), value, tag == "!"});
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    reject_tag(mark, tag);
    reject_key(mark, "a list");
    open(mark, ConfigTree::Kind::kList);
  }
  void OnSequenceEnd() override { open_.pop_back(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t, YAML::EmitterStyle::value) override {
    reject_tag(mark, tag);
    reject_key(mark, "a section");
    open(mark, ConfigTree::Kind::kSection);
  }
  void OnMapEnd() override { open_.pop_back(); }

 private:
  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& message) const {
    throw InputError(place(mark), message);
  }
  void reject_anchor(const YAML::Mark& mark, const std::string& what) const {
    fail(mark, what + "; expected a value without an anchor");
  }
  void reject_tag(const YAML::Mark& mark, const std::string& tag) const {
    if (tag.size() > 1) fail(mark, "tag " + in_quotes(tag) + "; expected a value without a tag");
  }
  /// yaml-cpp takes a quoted text that runs to the end of the file for complete.
  void reject_open_quote(const YAML::Mark& mark, const std::string& tag) const {
    const auto start = static_cast<std::size_t>(mark.pos);
    if (tag != "!" || start >= text_.size() || (text_[start] != '"' && text_[start] != '\'')) return;
    const char quote = text_[start];
    std::size_t i = start + 1;
    while (i < text_.size() && text_[i] != quote) i += quote == '"' && text_[i] == '\\' ? 2 : 1;
    if (i >= text_.size()) fail(mark, "quote is never closed");
  }
  void reject_key(const YAML::Mark& mark, const std::string& found) const {
    if (awaits_key()) fail(mark, "expected a name as key, found " + found);
  }

  /// Inside a section, the next event is a key unless the last entry still waits for its value.
  [[nodiscard]] bool awaits_key() const {
    if (open_.empty() || open_.back()->kind != ConfigTree::Kind::kSection) return false;
    const auto& entries = open_.back()->entries;
    return entries.empty() || entries.back().value != nullptr;
  }

  void take_key(const YAML::Mark& mark, const std::string& key) {
    ConfigTree& section = *open_.back();
    if (!is_key(key)) fail(mark, "expected a name as key, found " + in_quotes(key));
    if (const ConfigTree::Entry* first = section.find(key)) {
      const bool known = first->place.line > 0;
      fail(mark,
           "duplicate key " + in_quotes(key) + (known ? ", first on line " + std::to_string(first->place.line) : ""));
    }
    if (section.entries.size() == kMaxKeys) fail(mark, "too many keys, expected at most 1000 in one section");
    section.entries.push_back({key, place(mark), nullptr});
  }

  ConfigTreePtr put(ConfigTree&& value) {
    auto node = std::make_shared<ConfigTree>(std::move(value));
    if (open_.empty()) {
      root = node;
    } else if (open_.back()->kind == ConfigTree::Kind::kList) {
      open_.back()->items.push_back(node);
    } else {
      ConfigTree::Entry& entry = open_.back()->entries.back();
      // A block section begins at its first key; its own key is the place that a reader looks for.
      if (node->kind == ConfigTree::Kind::kSection) node->place = entry.place;
      entry.value = node;
    }
    return node;
  }

  void open(const YAML::Mark& mark, ConfigTree::Kind kind) {
    if (open_.size() == kMaxDepth) fail(mark, kTooDeep);
    open_.push_back(put(ConfigTree{kind, place(mark)}));
  }

  const std::string& text_;
  std::string name_;
  bool with_lines_;
  bool started_ = false;
  std::vector<ConfigTreePtr> open_;
};

/// Hears everything and keeps nothing but the place.
class SyntaxCheck : public YAML::EventHandler {
 public:
  /// Where no document begins, at a comma for instance, yaml-cpp hands out empty ones without end.
  void OnDocumentStart(const YAML::Mark& mark) override {
    if (mark.pos == last_document_) throw YAML::Exception(mark, "expected `key: value` lines");
    last_document_ = mark.pos;
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}

 private:
  int last_document_ = -1;
};

void send_events(const std::string& text, YAML::EventHandler& handler) {
  std::istringstream stream(text + "\n");  // without a last line end, yaml-cpp loses the place of what is not closed
  YAML::Parser parser(stream);
  while (parser.HandleNextDocument(handler)) {
  }
}

/// Rejects what is no text, and tabs in an indent, for which yaml-cpp has no clear words.
void check_characters(const std::string& text, const std::string& name) {
  SourcePlace place{name, 1, 1};
  bool indent = true;
  for (std::size_t i = 0, size = 0; i < text.size(); i += size) {
    const char c = text[i];
    if (c == '\t' && indent) throw InputError(place, "tab in the indent, expected spaces");
    const bool blank = c == '\t' || c == '\n' || c == '\r';
    size = blank ? 1 : printable_size(std::string_view(text).substr(i));
    if (size == 0) throw InputError(place, "expected a text file in UTF-8, found binary content");
    indent = c == '\n' || (indent && c == ' ');
    ++place.column;
    if (c == '\n') place = {name, place.line + 1, 1};
  }
}

}  // namespace

const ConfigTree::Entry* ConfigTree::find(const std::string& key) const {
  const auto at = std::find_if(entries.begin(), entries.end(), [&](const Entry& e) { return e.key == key; });
  return at == entries.end() ? nullptr : &*at;
}

const ConfigNote* ConfigTree::find_note(const std::string& key) const {
  const auto at = std::find_if(notes.begin(), notes.end(), [&](const ConfigNote& n) { return n.key == key; });
  return at == notes.end() ? nullptr : &*at;
}

void ConfigTree::note(const std::string& key, decltype(ConfigNote::got) got) {
  const auto at = std::find_if(notes.begin(), notes.end(), [&](const ConfigNote& n) { return n.key == key; });
  if (at != notes.end()) {
    at->got = std::move(got);
  } else {
    notes.push_back({key, std::move(got)});
  }
}

ConfigTreePtr parse_config_tree(const std::string& text, const std::string& name, bool with_lines) {
  check_characters(text, name);
  TreeBuilder builder(text, name, with_lines);
  try {
    // Before it notices a bracket that is never closed, yaml-cpp sends events that the text does not say.
    SyntaxCheck check;
    send_events(text, check);
    send_events(text, builder);
  } catch (const YAML::DeepRecursion& error) {
    throw InputError(builder.place(error.mark), kTooDeep);
  } catch (const YAML::Exception& error) {
    throw InputError(builder.place(error.mark), "not valid YAML: " + printable(error.msg));
  }
  return builder.root;
}

}  // namespace cogslam
