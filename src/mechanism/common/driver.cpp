#include "boxbeam/mechanism/common/driver.hpp"

#include <cmath>

namespace boxbeam {

DriverState driver_at(const HarmonicDriver& driver, double time) {
  const double angle = driver.omega * time + driver.phase;
  const double swing = driver.amplitude * std::sin(angle);
  return {driver.mean + swing, driver.amplitude * driver.omega * std::cos(angle),
          -driver.omega * driver.omega * swing};
}

}  // namespace boxbeam
