#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <regex>
#include <set>

#include "cli/exit_codes.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cogslam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

bool installed(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
}

std::string generated(const std::string& kind) {
  const Outcome outcome = run_program({"generate", kind});
  EXPECT_EQ(outcome.code, kOk) << outcome.err;
  return outcome.out;
}

/// What a command line prints, errors included.
std::string printed(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> out(popen((command + " 2>&1").c_str(), "r"), pclose);
  std::string text;
  std::array<char, 4096> buffer{};
  for (std::size_t n = 0; out && (n = std::fread(buffer.data(), 1, buffer.size(), out.get())) > 0;) {
    text.append(buffer.data(), n);
  }
  return text;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

/// Long options that a help text names at the beginning of a line.
std::set<std::string> options_in(const std::string& help) {
  std::set<std::string> options;
  const std::regex option(R"(\n +(?:-\w,)?(--[a-z-]+))");
  for (std::sregex_iterator at(help.begin(), help.end(), option), end; at != end; ++at) options.insert((*at)[1]);
  return options;
}

TEST(ManPage, NamesEveryCommandAndOptionOfTheHelp) {
  const std::string page = std::regex_replace(generated("man"), std::regex(R"(\\-)"), "-");
  for (const std::vector<std::string>& command : {std::vector<std::string>{"run"},
                                                  {"replay"},
                                                  {"validate"},
                                                  {"gate"},
                                                  {"lab", "signal"},
                                                  {"lab", "map"},
                                                  {"lab", "figures"},
                                                  {"figures"},
                                                  {"sense", "recover"},
                                                  {"sense", "log"},
                                                  {"sweep"},
                                                  {"world", "export"}}) {
    std::vector<std::string> arguments = command;
    arguments.push_back("--help");
    const std::string help = run_program(arguments).out;
    std::string name = ".SS cogslam";
    for (const std::string& word : command) name += " " + word;
    const std::size_t begin = page.find(name + "\n");
    ASSERT_NE(begin, std::string::npos) << name;
    const std::string section = page.substr(begin, page.find("\n.S", begin + 1) - begin);
    EXPECT_GE(options_in(help).size(), 4u) << name;
    for (const std::string& option : options_in(help)) {
      if (option != "--help") EXPECT_THAT(section, HasSubstr(option)) << name;
    }
  }
  EXPECT_THAT(page, Not(HasSubstr("generate"))) << "it is for those who package the program";
}

TEST(ManPage, PassesTheChecksOfMandocAndMan) {
  const TemporaryFolder folder;
  const std::string file = folder.file("cogslam.1", generated("man"));
  if (!installed("mandoc") && !installed("groff")) GTEST_SKIP() << "neither mandoc nor groff is installed";
  if (installed("mandoc")) EXPECT_EQ(printed("mandoc -T lint -W warning " + file), "");
  if (installed("groff")) EXPECT_EQ(printed("groff -man -ww -Tutf8 " + file + " >/dev/null"), "");
}

/// What bash offers for the last of these words.
std::vector<std::string> offered(const std::vector<std::string>& words, const std::string& folder = ".") {
  const TemporaryFolder scripts;
  std::string script = "cd " + folder + "\nsource " + scripts.file("completion", generated("bash")).string() + "\n";
  script += "COMP_WORDS=(cogslam";
  for (const std::string& word : words) script += " '" + word + "'";
  script += ")\nCOMP_CWORD=" + std::to_string(words.size()) + "\n_cogslam\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n";
  return lines_of(printed("bash " + scripts.file("ask", script).string()));
}

TEST(BashCompletion, OffersCommandsOptionsAndNames) {
  EXPECT_THAT(offered({"re"}), ElementsAre("replay"));
  EXPECT_THAT(offered({""}), IsSupersetOf({"run", "replay", "validate", "lab", "sense", "world"}));
  EXPECT_THAT(offered({"lab", "s"}), ElementsAre("signal"));
  EXPECT_THAT(offered({"world", "export", "--s"}), ElementsAre("--svg", "--scale", "--seed", "--set"));
  EXPECT_THAT(offered({"run", "--store", "co"}), ElementsAre("coefficients"));
  EXPECT_THAT(offered({"run", "--store", "=", "ti"}), ElementsAre("tiles")) << "bash takes --store=ti apart";
  EXPECT_THAT(offered({"run", "a.yaml", "--qu"}), ElementsAre("--quiet"));
  EXPECT_THAT(offered({"lab", "map", "--basis", "haar_"}), ElementsAre("haar_standard", "haar_1d"));
  EXPECT_THAT(offered({"run", "--seed", ""}), ElementsAre("")) << "a number: nothing to offer";
  EXPECT_THAT(offered({"fly", ""}), IsSupersetOf({"run", "replay"}));
}

TEST(BashCompletion, OffersFilesAndFolders) {
  const TemporaryFolder folder;
  (void)folder.file("room one.yaml", "");
  (void)folder.file("room.log", "");
  std::filesystem::create_directory(folder.path() / "rooms");
  EXPECT_THAT(offered({"run", "room"}, folder.path()),
              testing::UnorderedElementsAre("room one.yaml", "room.log", "rooms"));
  EXPECT_THAT(offered({"run", "--out", "r"}, folder.path()), ElementsAre("rooms"));
  EXPECT_THAT(offered({"replay", "--relations", "room."}, folder.path()), ElementsAre("room.log"));
}

TEST(FishCompletion, OffersCommandsAndOptions) {
  if (!installed("fish")) GTEST_SKIP() << "fish is not installed";
  const TemporaryFolder folder;
  const std::string source =
      "fish -N -c 'source " + folder.file("c.fish", generated("fish")).string() + "; complete -C ";
  EXPECT_THAT(printed(source + "\"cogslam rep\"'"), HasSubstr("replay\t"));
  EXPECT_THAT(printed(source + "\"cogslam lab sig\"'"), HasSubstr("signal\t"));
  EXPECT_THAT(printed(source + "\"cogslam run --sto\"'"), HasSubstr("--store\t"));
  EXPECT_THAT(printed(source + "\"cogslam run --store co\"'"), HasSubstr("coefficients"));
}

TEST(ZshCompletion, IsAScriptThatLoads) {
  if (!installed("zsh")) GTEST_SKIP() << "zsh is not installed";
  const TemporaryFolder folder;
  const std::string file = folder.file("_cogslam", generated("zsh"));
  EXPECT_EQ(printed("zsh -n " + file), "");
  EXPECT_EQ(
      printed("zsh -f -c 'autoload -U compinit && compinit -D -u; source " + file + "; echo ${_comps[cogslam]:-none}'"),
      "_bash_complete -F _cogslam\n");
}

}  // namespace
}  // namespace cogslam
