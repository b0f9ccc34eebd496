#include "eval/methods.h"

#include <algorithm>
#include <cstddef>

#include "eval/suggest.h"
#include "eval/usage_error.h"

namespace walkgraph {
namespace {

const Method* FindMethod(const std::string& name) {
  std::vector<std::string> names;
  for (const Method& method : Methods()) {
    if (method.name == name) return &method;
    names.push_back(method.name);
  }
  throw UsageError("unknown method \"" + name + "\"" + DidYouMean(name, names) +
                   ", expected one that `walkgraph methods` lists");
}

}  // namespace

const std::vector<Method>& Methods() {
  static const std::vector<Method>* const kMethods = new std::vector<Method>{};
  return *kMethods;
}

std::vector<const Method*> ParseMethods(std::string_view list) {
  std::vector<const Method*> methods;
  while (true) {
    const std::size_t comma = list.find(',');
    const Method* method = FindMethod(std::string(list.substr(0, comma)));
    if (std::find(methods.begin(), methods.end(), method) != methods.end()) {
      throw UsageError("method \"" + method->name + "\" is given twice");
    }
    methods.push_back(method);
    if (comma == std::string_view::npos) return methods;
    list.remove_prefix(comma + 1);
  }
}

}  // namespace walkgraph
