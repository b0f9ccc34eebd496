// The walkgraph program: finds the verb, runs it and turns errors into exit codes.
#include <glog/logging.h>

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "command_line.h"
#include "data/input_error.h"
#include "eval/evaluate.h"
#include "eval/suggest.h"
#include "eval/usage_error.h"
#include "verbs.h"

namespace walkgraph {
namespace {

std::vector<Verb> Verbs() {
  return {InspectVerb(),  SurveyVerb(), CalibrateVerb(), SmoothVerb(),
          EvaluateVerb(), AblateVerb(), HonestyVerb(),   ReportVerb(),
          SimulateVerb(), ConfigVerb(), MethodsVerb(),   VersionVerb()};
}

std::string Usage() {
  std::string text = "walkgraph VERB [ARGUMENT...] [--FLAG=VALUE...]\n\n";
  for (const Verb& verb : Verbs()) {
    std::string name = "  " + verb.name;
    name.resize(14, ' ');
    text += name + verb.summary + "\n";
  }
  return text + "\n`walkgraph help VERB` lists a verb's flags.\n";
}

std::string UsageOf(const Verb& verb) {
  return "walkgraph " + verb.name + " " + verb.usage + "\n\n" + verb.summary + "\n\n" +
         DescribeFlags(verb);
}

Verb FindVerb(const std::string& name) {
  std::vector<std::string> names;
  for (const Verb& verb : Verbs()) {
    if (verb.name == name) return verb;
    names.push_back(verb.name);
  }
  throw UsageError("unknown verb \"" + name + "\"" + DidYouMean(name, names) +
                   ", expected one that `walkgraph help` lists");
}

int Help(const std::vector<std::string>& words) {
  std::fputs((words.empty() ? Usage() : UsageOf(FindVerb(words.front()))).c_str(), stdout);
  return kExitOk;
}

int Run(std::vector<std::string> words) {
  if (words.empty()) throw UsageError("no verb, expected\n" + Usage());
  const std::string name = words.front();
  words.erase(words.begin());
  if (name == "help" || name == "--help" || name == "-h") return Help(words);
  if (name == "--version") return VersionVerb().run({});
  const Verb verb = FindVerb(name);
  const CommandLine line = ParseCommandLine(verb, words);
  if (line.help) return Help({verb.name});
  return verb.run(line);
}

// Warnings go to standard error, and nothing to files before a run names its folder.
void StartLogging(const char* program) {
  FLAGS_stderrthreshold = google::GLOG_WARNING;
  google::InitGoogleLogging(program);
  for (const auto severity : {google::GLOG_INFO, google::GLOG_WARNING, google::GLOG_ERROR}) {
    google::SetLogDestination(severity, "");
  }
}

int Main(int argc, char** argv) {
  StartLogging(argv[0]);
  try {
    return Run({argv + 1, argv + argc});
  } catch (const UsageError& error) {
    std::fprintf(stderr, "walkgraph: %s\n", error.what());
    return kExitUsage;
  } catch (const InputError& error) {
    std::fprintf(stderr, "walkgraph: %s\n", error.what());
    return kExitBadInput;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "walkgraph: %s\n", error.what());
    return kExitFailure;
  }
}

}  // namespace
}  // namespace walkgraph

int main(int argc, char** argv) { return walkgraph::Main(argc, argv); }
