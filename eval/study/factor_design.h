#ifndef WALKGRAPH_EVAL_STUDY_FACTOR_DESIGN_H_
#define WALKGRAPH_EVAL_STUDY_FACTOR_DESIGN_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "eval/study/study.h"

namespace walkgraph {

// Which subsets of a list of factors a study compares.
enum class FactorDesign : std::uint8_t {
  kAllSubsets,
  kLeaveOneOut,  // all, and all without each one
  kAddOneIn,     // none, each one alone, and all
};

// What `--factors` and a study's `factors` ask for.
struct FactorStudy {
  FactorDesign design = FactorDesign::kAllSubsets;
  std::vector<std::string> factors;
};

// The factors and slow states that can be taken out, by name.
std::vector<std::string> SwitchableFactors();

// The seven of the project's own ablation.
std::vector<std::string> DefaultFactors();

// Reads "all-subsets", "leave-one-out" or "add-one-in" (of the default factors) or a list of
// factors, of which it takes all subsets. Throws UsageError for anything else.
FactorStudy ParseFactorStudy(std::string_view text);

// Throws UsageError unless the names are known, each given once and no more than 16.
void CheckFactors(const std::vector<std::string>& factors);

// Adds a cell of `method` per subset of the design, named "batch:all", "batch:none",
// "batch:all-step" or "batch:step+fingerprint", with the factors that the subset lacks switched
// off; those not on the list stay as configured. Makes "all" the study's reference. Throws
// UsageError where the study's base has a listed factor switched off already.
void AddFactorCells(const FactorStudy& factors, const Method& method, Study* study);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_STUDY_FACTOR_DESIGN_H_
