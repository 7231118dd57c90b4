package org.pendant.recording.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;

final class ParkingPlacesTest {
  private static final long S = 500;
  private static final ParkingPlaces PLACES = new ParkingPlaces(S);

  private static List<Long> goalsS(long newestS, OptionalLong lookedS) {
    OptionalLong looked = lookedS.isPresent() ? OptionalLong.of(S * lookedS.getAsLong()) : lookedS;
    return PLACES.of(0, S * newestS, looked).stream().map(each -> each.goal() / S).toList();
  }

  @Test
  void aShortRunHasNone() {
    assertEquals(List.of(), goalsS(70, OptionalLong.empty()));
    assertEquals(List.of(), goalsS(70, OptionalLong.of(15)));
    assertEquals(List.of(), PLACES.of(0, -1, OptionalLong.of(15 * S)));
  }

  @Test
  void theyStandInARowAllAlongTheRun() {
    assertEquals(List.of(240L, 180L, 120L, 60L), goalsS(260, OptionalLong.empty()));
    assertEquals(List.of(600L, 480L, 360L, 240L, 120L), goalsS(660, OptionalLong.empty()));
    assertEquals(
        List.of(3360L, 2880L, 2400L, 1920L, 1440L, 960L, 480L), goalsS(3600, OptionalLong.empty()));
  }

  @Test
  void whatIsNotRecordedAnyMoreNeedsNone() {
    assertEquals(
        List.of(3540L, 3480L, 3420L, 3360L),
        PLACES.of(3400 * S, 3600 * S, OptionalLong.empty()).stream()
            .map(each -> each.goal() / S)
            .toList());
  }

  @Test
  void theFirstIsShortlyBeforeTheMomentThatPeopleLookAt() {
    assertEquals(List.of(197L, 160L, 240L, 180L, 120L, 60L), goalsS(260, OptionalLong.of(200)));
  }

  @Test
  void theyAreWhatTheirPlacesWant() {
    int most = 0;
    for (long newest = 0; newest < 12_345_678; newest += 54_321) {
      List<ParkingPlaces.Place> all = PLACES.of(90 * S, newest, OptionalLong.of(newest - 50 * S));
      most = Math.max(most, all.size());
      for (ParkingPlaces.Place each : all) {
        assertTrue(each.fits(each.goal()), each::toString);
      }
    }
    assertEquals(ParkingPlaces.MAX, most);
  }
}
