// What a program without rivals links in place of them (scripts/cmake/LiftarmFolders.cmake).
#include "rivals/rivals.h"

namespace liftarm::rivals {

std::vector<std::string_view> rivalNames() {
  return {};
}

std::unique_ptr<search::LayoutSearch> makeRival(std::string_view /*name*/,
                                                const layout::LayoutProblem& /*problem*/,
                                                layout::ConnectionSolver& /*solver*/,
                                                RivalOptions /*options*/) {
  return nullptr;
}

std::vector<std::string_view> scheduleNames() {
  return {};
}

search::MakeCooling coolingOf(std::string_view /*name*/) {
  return {};
}

}  // namespace liftarm::rivals
