#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "toile/base/error.hpp"
#include "toile/pattern/curve.hpp"

namespace toile::pattern::json {

using Json = nlohmann::json;

/// A value of the file with the words that tell where it stands.
class Node {
 public:
  Node(const Json& json, std::string place) : json_(&json), place_(std::move(place)) {}

  [[noreturn]] void fail(const std::string& problem) const { throw base::InputError(place_ + ": " + problem); }
  bool has(const char* key) const { return json_->is_object() && json_->contains(key) && !json_->at(key).is_null(); }
  bool is_list() const { return json_->is_array(); }
  bool is_text() const { return json_->is_string(); }

  Node at(const char* key) const {
    if (!json_->is_object()) fail(std::string("expected an object with \"") + key + "\"");
    if (!json_->contains(key)) fail(std::string("\"") + key + "\" is missing");
    return {json_->at(key), place_ + ", " + key};
  }
  Node at(std::size_t k) const {
    if (!json_->is_array() || k >= json_->size()) fail("expected a list of at least " + std::to_string(k + 1));
    return {json_->at(k), place_ + " " + std::to_string(k)};
  }
  std::size_t size() const {
    if (!json_->is_array()) fail("expected a list");
    return json_->size();
  }
  /// Same value under another name of its place.
  Node called(const std::string& place) const { return {*json_, place}; }
  const std::string& place() const { return place_; }

  double number() const {
    if (!json_->is_number()) fail("expected a number, found " + json_->dump().substr(0, 40));
    return json_->get<double>();
  }
  std::size_t index(std::size_t count) const {
    const bool valid = json_->is_number_integer() && json_->get<long long>() >= 0 &&
                       static_cast<std::size_t>(json_->get<long long>()) < count;
    if (!valid)
      fail("expected a whole number from 0 to " + std::to_string(static_cast<long long>(count) - 1) + ", found " +
           json_->dump().substr(0, 40));
    return json_->get<std::size_t>();
  }
  bool flag() const { return json_->is_boolean() ? json_->get<bool>() : number() != 0.0; }
  std::string text() const {
    if (!json_->is_string()) fail("expected a text");
    return json_->get<std::string>();
  }
  Vec2 point() const { return {coordinate(0), coordinate(1)}; }
  double coordinate(std::size_t k) const { return at(k).number(); }

  template <class Work>
  void for_each_member(const Work& work) const {
    if (!json_->is_object()) fail("expected an object");
    for (const auto& [key, value] : json_->items()) work(key, Node(value, place_));
  }

 private:
  const Json* json_;
  std::string place_;
};

}  // namespace toile::pattern::json
