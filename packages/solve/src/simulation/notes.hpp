#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "toile/solve/checkpoint.hpp"

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

  NoteMemory memory() const { return {all_, static_cast<int>(first_pin_), static_cast<int>(pins_)}; }
  void resume(const NoteMemory& memory) {
    all_ = memory.all;
    first_pin_ = static_cast<std::size_t>(memory.first_pin);
    pins_ = static_cast<std::size_t>(memory.pins);
  }

 private:
  std::vector<std::string> all_;
  std::size_t first_pin_ = 0, pins_ = 0;
};

}  // namespace toile::solve
