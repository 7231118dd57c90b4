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
    return PLACES.of(S * newestS, looked).stream().map(each -> each.goal() / S).toList();
  }

  @Test
  void aShortRunHasNone() {
    assertEquals(List.of(), goalsS(100, OptionalLong.empty()));
    assertEquals(List.of(), goalsS(100, OptionalLong.of(15)));
    assertEquals(List.of(), PLACES.of(-1, OptionalLong.of(15 * S)));
  }

  @Test
  void theyAreEverFewerTheLongerAgo() {
    assertEquals(List.of(570L, 480L), goalsS(600, OptionalLong.empty()));
    assertEquals(List.of(9970L, 9880L, 9520L, 8080L), goalsS(10_000, OptionalLong.empty()));
  }

  @Test
  void theFirstIsShortlyBeforeTheMomentThatPeopleLookAt() {
    assertEquals(List.of(297L, 260L, 570L, 480L), goalsS(600, OptionalLong.of(300)));
  }

  @Test
  void theyAreWhatTheirPlacesWant() {
    for (ParkingPlaces.Place each : PLACES.of(12_345_678, OptionalLong.of(9_000_000))) {
      assertTrue(each.fits(each.goal()), each::toString);
    }
    assertEquals(ParkingPlaces.MAX, PLACES.of(12_345_678, OptionalLong.of(9_000_000)).size());
  }
}
