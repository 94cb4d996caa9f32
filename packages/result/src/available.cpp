#include "toile/result/available.hpp"

namespace toile::result {

bool files_available() {
  return true;
}

}  // namespace toile::result
