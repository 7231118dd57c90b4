package org.pendant.desktop.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.recording.RecordingRing;
import org.pendant.recording.lines.RunProfile;

/** Which worst moments there are, and which is the next. */
final class PinsTest {
  private static final Pin EARLY = new Pin(1, "early", 0.1);
  private static final Pin LATE = new Pin(3, "late", 0.9);

  private final Controller controller = new Controller(ControllerOptions.headless());
  private final RecordingRing ring =
      new RecordingRing(controller.state(), controller::programSource);
  private final Pins pins = new Pins(new LookBack(ring::recording, text -> {}));

  PinsTest() {
    pins.from(() -> new RunProfile(1, "a", 0, List.of()), profile -> List.of(LATE, EARLY));
  }

  @Test
  void theyComeInTheOrderOfTime() {
    assertEquals(List.of(EARLY, LATE), pins.all());
  }

  @Test
  void theNextOneIsAfterTheMomentAndTheLastOneBefore() {
    assertEquals(Optional.of(LATE), pins.next(1, true));
    assertEquals(Optional.of(EARLY), pins.next(3, false));
    assertEquals(Optional.empty(), pins.next(3, true));
  }

  @Test
  void thePointerMeansTheNearestOneIfItIsNear() {
    assertEquals(Optional.of(LATE), pins.at(2.9, 0.2));
    assertEquals(Optional.empty(), pins.at(2.5, 0.2));
  }
}
