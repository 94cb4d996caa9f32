#pragma once

#include <functional>

namespace toile::run {

/// Does `work`, which communicates nothing, on each rank. If it fails on any, every rank throws: those that failed
/// their own exception, the others a base::Error with the exit status and the message of the first that did.
/// Collective.
void alike(const std::function<void()>& work);

/// The same for what only the first rank does.
void on_first_rank(const std::function<void()>& work);

bool is_first_rank();

}  // namespace toile::run
