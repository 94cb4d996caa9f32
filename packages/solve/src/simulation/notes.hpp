#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace toile::solve {

/// What a run notes, in the order of its stages: of each stage first the motions that it holds, which may be others at
/// its end than at its start, then what happens on its path.
class Notes {
 public:
  void start_stage() {
    first_pin_ = all_.size();
    pins_ = 0;
  }
  /// Replaces those of the stage's start, and nothing else.
  void set_pins(const std::vector<std::string>& pins) {
    const auto first = all_.begin() + static_cast<std::ptrdiff_t>(first_pin_);
    all_.insert(all_.erase(first, first + static_cast<std::ptrdiff_t>(pins_)), pins.begin(), pins.end());
    pins_ = pins.size();
  }
  void add(const std::string& note) { all_.push_back(note); }
  const std::vector<std::string>& all() const { return all_; }

  /// The stage's pins: how many notes are before them, and how many they are.
  int first_pin() const { return static_cast<int>(first_pin_); }
  int pins() const { return static_cast<int>(pins_); }
  void resume(const std::vector<std::string>& all, int first_pin, int pins) {
    all_ = all;
    first_pin_ = static_cast<std::size_t>(first_pin);
    pins_ = static_cast<std::size_t>(pins);
  }

 private:
  std::vector<std::string> all_;
  std::size_t first_pin_ = 0, pins_ = 0;
};

}  // namespace toile::solve
