// Seams between flanges and webs of boxes: by hand.

#include "boxbeam/verification/seam_sum.hpp"

#include <cmath>

#include "catch.hpp"

namespace seam_sum_test {

using namespace boxbeam;

namespace {

Box box_with(double height, double throat) {
  Box box =
      symmetric_box(si<Length>(0.2), si<Length>(height), si<Length>(0.016), si<Length>(0.012));
  box.seam_throat = si<Length>(throat);
  return box;
}

TaperedBeam beam_of(const Profile& from, const Profile& to, double length) {
  TaperedBeam beam;
  beam.segments.push_back({"S1", si<Length>(0.0), si<Length>(length), {from, {}}, {to, {}}});
  return beam;
}

}  // namespace

TEST_CASE("four seams of a prismatic box, by length and by the square of their throat") {
  const SeamSum sum = seams_of(beam_of(box_with(0.4, 0.006), box_with(0.4, 0.006), 3.0));
  CHECK(sum.fillets.value() == Approx(4 * 3.0));
  CHECK(sum.full.value() == 0.0);
  // Legs of 6 sqrt(2) mm: their triangle has an area of 36 mm^2.
  CHECK(sum.deposit.value() == Approx(12.0 * 36e-6));
}

TEST_CASE("seams without a throat penetrate fully, those of other profiles are none") {
  TaperedBeam beam = beam_of(box_with(0.4, 0.0), box_with(0.4, 0.0), 2.0);
  const RoundTube tube{si<Length>(0.2), si<Length>(0.01)};
  beam.segments.push_back({"S2", si<Length>(2.0), si<Length>(1.0), {tube, {}}, {tube, {}}});
  const SeamSum sum = seams_of(beam);
  CHECK(sum.full.value() == Approx(8.0));
  CHECK(sum.fillets.value() == 0.0);
  CHECK(sum.deposit.value() == 0.0);
}

TEST_CASE("along a taper seams follow the plates, and the mean square of their throat counts") {
  // Half of a height that grows by 6 m within 4 m: 3, 4, 5.
  const SeamSum sum = seams_of(beam_of(box_with(1.0, 0.003), box_with(7.0, 0.006), 4.0));
  CHECK(sum.fillets.value() == Approx(4 * 5.0));
  // Of a throat from 3 to 6 mm the mean of (3 + 3 x)^2 is 9 (1 + 1 + 1/3) = 21 mm^2.
  CHECK(sum.deposit.value() == Approx(20.0 * 21e-6));
  // The other way round it is the same.
  const SeamSum back = seams_of(beam_of(box_with(7.0, 0.006), box_with(1.0, 0.003), 4.0));
  CHECK(back.deposit.value() == Approx(sum.deposit.value()));
}

}  // namespace seam_sum_test
