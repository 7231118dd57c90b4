package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.message.LogEntry;

/** A computer that cannot keep up with robot time. */
final class LostTimeTest {
  private final Controller controller = new Controller(ControllerOptions.headless());

  private void behind(double seconds) {
    var _ = controller.submit(new BoxCommand.NoteLostTime(seconds));
    controller.advance();
  }

  @Test
  void theSnapshotSaysHowFarRobotTimeIsBehind() {
    assertEquals(0, controller.state().behindS());
    behind(0.25);
    assertEquals(0.25, controller.state().behindS());
    behind(0.5);
    assertEquals(0.5, controller.state().behindS());
  }

  @Test
  void theLogSaysSoAtFirstAndWhenItHasGrownMuch() {
    behind(0.25);
    behind(0.5);
    behind(1.25);
    behind(1.5);
    behind(2.5);
    assertEquals(
        List.of(
            "robot time is 0.25 s behind the wall clock: this computer could not keep up",
            "robot time is 1.25 s behind the wall clock: this computer could not keep up",
            "robot time is 2.50 s behind the wall clock: this computer could not keep up"),
        controller.logSince(0).stream().map(LogEntry::text).toList());
  }
}
