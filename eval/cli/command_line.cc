#include "command_line.h"

#include <gflags/gflags.h>

#include <algorithm>
#include <cstddef>

#include "eval/suggest.h"
#include "eval/usage_error.h"

namespace walkgraph {
namespace {

bool Takes(const Verb& verb, const std::string& flag) {
  return std::find(verb.flags.begin(), verb.flags.end(), flag) != verb.flags.end();
}

bool IsSwitch(const std::string& flag) {
  return gflags::GetCommandLineFlagInfoOrDie(flag.c_str()).type == "bool";
}

void SetFlag(const Verb& verb, const std::string& flag, const std::string& value,
             CommandLine* line) {
  if (!Takes(verb, flag)) {
    throw UsageError("unknown flag --" + flag + DidYouMean(flag, verb.flags) +
                     ", expected one that `walkgraph help " + verb.name + "` lists");
  }
  if (flag == "set") {
    line->assignments.push_back(value);
  } else if (gflags::SetCommandLineOption(flag.c_str(), value.c_str()).empty()) {
    throw UsageError("--" + flag + "=" + value + ": expected a value of type " +
                     gflags::GetCommandLineFlagInfoOrDie(flag.c_str()).type);
  }
}

}  // namespace

CommandLine ParseCommandLine(const Verb& verb, const std::vector<std::string>& words) {
  CommandLine line;
  line.text = "walkgraph " + verb.name;
  for (const std::string& word : words) line.text += " " + word;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == "--help" || word == "-h") {
      line.help = true;
    } else if (word.compare(0, 2, "--") != 0) {
      line.arguments.push_back(word);
    } else if (const std::size_t equals = word.find('='); equals != std::string::npos) {
      SetFlag(verb, word.substr(2, equals - 2), word.substr(equals + 1), &line);
    } else if (const std::string flag = word.substr(2); Takes(verb, flag) && IsSwitch(flag)) {
      SetFlag(verb, flag, "true", &line);
    } else if (flag.compare(0, 2, "no") == 0 && Takes(verb, flag.substr(2)) &&
               IsSwitch(flag.substr(2))) {
      SetFlag(verb, flag.substr(2), "false", &line);
    } else if (i + 1 < words.size() || !Takes(verb, flag)) {
      SetFlag(verb, flag, i + 1 < words.size() ? words[i + 1] : "", &line);
      ++i;
    } else {
      throw UsageError(word + ": expected a value behind it");
    }
  }
  return line;
}

std::string DescribeFlags(const Verb& verb) {
  std::string text;
  for (const std::string& name : verb.flags) {
    const gflags::CommandLineFlagInfo info = gflags::GetCommandLineFlagInfoOrDie(name.c_str());
    std::string flag = "  --" + name;
    flag.resize(std::max<std::size_t>(flag.size() + 2, 18), ' ');
    text += flag + info.description;
    if (!info.default_value.empty()) text += " (default " + info.default_value + ")";
    text += "\n";
  }
  return text;
}

}  // namespace walkgraph
