#include "parts/gear_teeth.h"

#include <cctype>
#include <string>

namespace liftarm::parts {

int teethOf(const Part& part) {
  const std::size_t word = part.name.find(" Tooth");
  if (part.partClass != PartClass::kGear || word == std::string::npos) {
    return 0;
  }
  int teeth = 0;
  int unit = 1;
  for (std::size_t i = word; i-- > 0 && std::isdigit(static_cast<unsigned char>(part.name[i]));) {
    teeth += unit * (part.name[i] - '0');
    unit *= 10;
  }
  return teeth;
}

}  // namespace liftarm::parts
