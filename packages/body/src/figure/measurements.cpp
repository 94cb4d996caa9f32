#include <algorithm>
#include <cmath>
#include <sstream>

#include "toile/base/error.hpp"
#include "toile/body/mannequin.hpp"

namespace toile::body {
namespace {

/// A measurement of the default body and what it follows if it is not given.
struct Rule {
  const char* name;
  double value;         ///< mm
  const char* follows;  ///< "": only itself
  double power;         ///< of the other's ratio to its default
};

// 158 cm, 83/64/90: an average Japanese woman of 20 years; the others are plausible round values.
const std::vector<Rule> rules = {
    {"height", 1580.0, "", 0.0},  {"neck", 310.0, "bust", 0.5},      {"shoulder width", 370.0, "bust", 0.3},
    {"bust", 830.0, "", 0.0},     {"underbust", 715.0, "bust", 1.0}, {"waist", 640.0, "", 0.0},
    {"hip", 900.0, "", 0.0},      {"thigh", 520.0, "hip", 1.0},      {"knee", 330.0, "hip", 0.7},
    {"calf", 340.0, "hip", 0.7},  {"ankle", 205.0, "hip", 0.5},      {"upper arm", 255.0, "bust", 0.8},
    {"wrist", 150.0, "bust", 0.4}};

const Rule& rule_of(const std::string& name) {
  return *std::find_if(rules.begin(), rules.end(), [&name](const Rule& rule) { return rule.name == name; });
}

/// What holds on any body: the first is smaller than so much of the second.
struct Order {
  const char* smaller;
  const char* larger;
  double share;
  const char* reason;
};

const std::vector<Order> orders = {
    {"waist", "hip", 0.98, "the waist is the smallest girth between hip and armpits"},
    {"waist", "bust", 0.98, "the waist is the smallest girth between hip and armpits"},
    {"waist", "underbust", 0.99, "the waist is the smallest girth between hip and armpits"},
    {"underbust", "bust", 0.99, "the bust stands out over the underbust"},
    {"bust", "underbust", 1.4, "no bust stands out so much over the underbust"},
    {"hip", "waist", 2.0, "no hip is so much wider than the waist"},
    {"bust", "waist", 2.0, "no bust is so much wider than the waist"},
    {"thigh", "hip", 0.70, "two thighs have to fit below the hip"},
    {"hip", "thigh", 2.1, "two thighs carry the hip"},
    {"knee", "thigh", 0.85, "the leg gets thinner from thigh to knee"},
    {"knee", "calf", 0.985, "the calf is the greatest girth below the knee"},
    {"ankle", "calf", 0.85, "the ankle is the smallest girth below the calf"},
    {"calf", "thigh", 0.85, "the leg gets thinner from the thigh down"},
    {"wrist", "upper arm", 0.85, "the arm gets thinner from the shoulder to the wrist"},
    {"upper arm", "bust", 0.45, "the arm leaves the trunk beside the bust"},
    {"neck", "bust", 0.55, "the neck is above the shoulders"}};

std::string cm(double value) {
  std::ostringstream text;
  text << 0.1 * value << " cm";
  return text.str();
}

double value_of(const std::vector<Measurement>& all, const std::string& name) {
  return std::find_if(all.begin(), all.end(), [&name](const Measurement& m) { return m.name == name; })->value;
}

/// Shares of the height that a body's measurement may be.
constexpr double least_part = 0.5, greatest_part = 2.2;  // of the default body's share

void check_sizes(const std::vector<Measurement>& all) {
  constexpr double least_height = 1000.0, greatest_height = 2300.0;
  const double height = value_of(all, "height");
  if (!(height >= least_height && height <= greatest_height)) {
    throw base::InputError("height " + cm(height) + ": allowed are " + cm(least_height) + " to " + cm(greatest_height));
  }
  for (const Measurement& m : all) {
    const double usual = rule_of(m.name).value * height / rule_of("height").value;
    if (!(m.value >= least_part * usual && m.value <= greatest_part * usual)) {
      throw base::InputError(m.name + " " + cm(m.value) + " (" + m.source + "): no body of " + cm(height) +
                             " has it; allowed are " + cm(least_part * usual) + " to " + cm(greatest_part * usual));
    }
  }
}

void check_orders(const std::vector<Measurement>& all) {
  for (const Order& order : orders) {
    const double smaller = value_of(all, order.smaller), larger = value_of(all, order.larger);
    if (smaller <= order.share * larger) {
      continue;
    }
    std::ostringstream text;
    text << order.smaller << ' ' << cm(smaller) << " and " << order.larger << ' ' << cm(larger)
         << " contradict each other: " << order.reason << "; with this " << order.larger << " the " << order.smaller
         << " is at most " << cm(order.share * larger);
    throw base::InputError(text.str());
  }
}

}  // namespace

const base::Texts& measurement_names() {
  static const base::Texts names = [] {
    base::Texts all;
    for (const Rule& rule : rules) {
      all.emplace_back(rule.name);
    }
    return all;
  }();
  return names;
}

std::vector<Measurement> complete_measurements(const std::map<std::string, double>& given) {
  const base::Texts& names = measurement_names();
  for (const auto& [name, value] : given) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      throw base::InputError("no measurement is named \"" + name + "\"" + base::hint(name, names));
    }
  }
  const auto ratio = [&given](const std::string& name) {
    const auto it = given.find(name);
    return it == given.end() ? 1.0 : it->second / rule_of(name).value;
  };
  std::vector<Measurement> all;
  for (const Rule& rule : rules) {
    const auto it = given.find(rule.name);
    if (it != given.end()) {
      all.push_back({rule.name, it->second, "given"});
    } else if (*rule.follows != '\0' && given.count(rule.follows) > 0) {
      all.push_back({rule.name, rule.value * std::pow(ratio(rule.follows), rule.power),
                     std::string("follows the ") + rule.follows});
    } else {
      all.push_back({rule.name, rule.value, "default"});
    }
  }
  check_sizes(all);
  check_orders(all);
  return all;
}

}  // namespace toile::body
