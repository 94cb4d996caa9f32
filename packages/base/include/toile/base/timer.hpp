#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace toile::base {

/// Wall time of the phases of a run, nested in the order in which they were first entered.
class Timer {
 public:
  using Clock = std::chrono::steady_clock;

  /// Ends its phase when it goes out of scope.
  class Scope {
   public:
    explicit Scope(Timer& timer) : timer_(&timer) {}
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
    ~Scope() { timer_->leave(); }

   private:
    Timer* timer_;
  };

  struct Phase {
    std::string name;
    int depth = 0;  ///< 0: outermost
    int calls = 0;
    double seconds = 0.0;  ///< of finished calls, inner phases included
  };

  Timer();

  /// Enters the phase `name` inside the one that is open. Entering it again adds to it.
  [[nodiscard]] Scope phase(const std::string& name);

  /// Every phase, each followed by those inside it.
  std::vector<Phase> phases() const;
  /// Wall time since the timer was made, s.
  double elapsed() const;
  /// One line a phase: name (indented by depth), seconds, share of elapsed(), calls. The last line is the total.
  std::string table() const;

 private:
  struct Node {
    Phase phase;
    int parent = -1;
    std::vector<int> inner;
    Clock::time_point start;
  };
  void leave();
  void append(int node, std::vector<Phase>& phases) const;

  Clock::time_point start_;
  std::vector<Node> nodes_;  ///< the first is the root, which is not a phase
  int open_ = 0;
};

}  // namespace toile::base
