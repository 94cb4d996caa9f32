#include "toile/body/landmarks.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "toile/base/error.hpp"

namespace toile::body {
namespace {

base::Texts make_names() {
  base::Texts names = {"crown", "neck"};
  const auto pair = [&names](const std::string& part) {
    for (const char* side : {"left ", "right ", ""}) {
      names.push_back(side + part);
    }
  };
  for (const char* part : {"shoulder", "shoulder blade", "armpit"}) {
    pair(part);
  }
  names.insert(names.end(), {"left bust point", "right bust point", "bust", "underbust", "waist", "hip", "crotch"});
  for (const char* part : {"thigh", "knee", "calf", "ankle", "upper arm", "elbow", "wrist"}) {
    pair(part);
  }
  return names;
}

std::string without_line(const std::string& name) {
  const std::string line = " line";
  const bool has = name.size() > line.size() && name.compare(name.size() - line.size(), line.size(), line) == 0;
  return has ? name.substr(0, name.size() - line.size()) : name;
}

}  // namespace

const Landmark* Landmarks::find(const std::string& name) const {
  const std::string plain = without_line(name);
  const auto it = std::find_if(found.begin(), found.end(), [&plain](const Landmark& l) { return l.name == plain; });
  return it == found.end() ? nullptr : &*it;
}

const Landmark& Landmarks::at(const std::string& name) const {
  if (const Landmark* landmark = find(name)) {
    return *landmark;
  }
  const std::string plain = without_line(name);
  for (const MissingLandmark& missed : missing) {
    if (missed.name == plain) {
      throw base::InputError("the landmark \"" + plain + "\" was not found on the body: " + missed.reason);
    }
  }
  throw base::InputError("no landmark is named \"" + name + "\"" + base::hint(name, landmark_names()));
}

Landmark Landmarks::place(const std::string& text) const {
  const std::size_t sign = text.find_first_of("+-");
  std::string name = text.substr(0, sign);
  name.erase(name.find_last_not_of(' ') + 1);
  Landmark landmark = at(name);
  if (sign == std::string::npos) {
    return landmark;
  }
  std::string number = text.substr(sign + 1);
  number.erase(0, number.find_first_not_of(' '));
  std::size_t read = 0;
  double offset = 0.0;
  try {
    offset = std::stod(number, &read);
  } catch (const std::logic_error&) {
    read = std::string::npos;
  }
  if (read != number.size() || !std::isfinite(offset) || number.front() == '-' || number.front() == '+') {
    throw base::InputError("\"" + text + "\" is no place: behind the landmark stands + or - and a number of mm");
  }
  landmark.point.z() += text[sign] == '-' ? -offset : offset;
  return landmark;
}

const base::Texts& landmark_names() {
  static const base::Texts names = make_names();
  return names;
}

}  // namespace toile::body
