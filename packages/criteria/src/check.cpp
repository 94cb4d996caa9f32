#include "toile/criteria/check.hpp"

#include <algorithm>

#include "toile/criteria/paths.hpp"
#include "toile/criteria/pointwise.hpp"
#include "toile/criteria/polyconvexity.hpp"

namespace toile::criteria {
namespace {

const char* word(const Report& report, const Finding& finding) {
  if (finding.verdict == Verdict::holds) return "holds";
  if (finding.verdict == Verdict::undecided) return "open";
  if (finding.verdict == Verdict::reported) return "";
  const bool counts = std::count(report.failed.begin(), report.failed.end(), finding.criterion) > 0;
  return counts ? "FAILS" : "lost";
}

}  // namespace

Report check(const Fabric& fabric, const Request& request) {
  Report report{fabric, {}, map(fabric, request), {}};
  auto& findings = report.findings;
  findings = {finite_numbers(fabric, request), natural_state(fabric), derivatives(fabric, request),
              material_symmetry(fabric, request), growth(fabric)};
  for (const Finding& finding : judge(report.map)) findings.push_back(finding);
  findings.push_back(polyconvexity_finding(polyconvexity(fabric, request, report.map)));
  for (const Finding& finding : path_findings(fabric, request)) findings.push_back(finding);
  for (const Finding& finding : findings)
    if (finding.verdict == Verdict::fails &&
        std::count(request.required.begin(), request.required.end(), finding.criterion) > 0)
      report.failed.push_back(finding.criterion);
  return report;
}

std::string table(const Report& report) {
  const auto padded = [](std::string text, std::size_t width) {
    text.resize(std::max(width, text.size()), ' ');
    return text;
  };
  std::string text = report.fabric.name + " (" + report.fabric.law->name + "): ";
  text += report.passed() ? "passed\n" : "FAILED\n";
  for (const Finding& finding : report.findings)
    text += "  " + padded(finding.criterion, 24) + padded(word(report, finding), 7) + finding.text + '\n';
  return text;
}

}  // namespace toile::criteria
