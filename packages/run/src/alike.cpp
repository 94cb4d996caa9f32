#include "alike.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <Tpetra_Core.hpp>
#include <exception>
#include <string>

#include "toile/base/error.hpp"

namespace toile::run {

namespace {

struct Failure {
  std::exception_ptr exception;
  int code = static_cast<int>(base::ExitCode::internal_error);
  std::string message;
};

Failure failure_of(const std::function<void()>& work) {
  Failure failure;
  try {
    work();
  } catch (const base::Error& error) {
    failure = {std::current_exception(), static_cast<int>(error.code()), error.what()};
  } catch (const std::exception& error) {
    failure.exception = std::current_exception();
    failure.message = error.what();
  } catch (...) {
    failure.exception = std::current_exception();
  }
  return failure;
}

}  // namespace

void alike(const std::function<void()>& work) {
  const auto comm = Tpetra::getDefaultComm();
  Failure failure = failure_of(work);
  const int mine = failure.exception ? comm->getRank() : comm->getSize();
  int first = 0;
  Teuchos::reduceAll(*comm, Teuchos::REDUCE_MIN, mine, Teuchos::outArg(first));
  if (first == comm->getSize()) return;
  int size = static_cast<int>(failure.message.size());
  Teuchos::broadcast(*comm, first, Teuchos::outArg(failure.code));
  Teuchos::broadcast(*comm, first, Teuchos::outArg(size));
  std::string message = failure.message;
  message.resize(static_cast<size_t>(size));
  Teuchos::broadcast(*comm, first, size, message.data());
  if (failure.exception) std::rethrow_exception(failure.exception);
  throw base::Error(static_cast<base::ExitCode>(failure.code), message);
}

void on_first_rank(const std::function<void()>& work) {
  alike([&] {
    if (is_first_rank()) work();
  });
}

bool is_first_rank() {
  return Tpetra::getDefaultComm()->getRank() == 0;
}

}  // namespace toile::run
