package org.pendant.desktop.timeline;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.pendant.controller.ControllerOptions;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SharedCell;

@Timeout(value = 60, unit = TimeUnit.SECONDS)
final class TimelineCellTest {
  private RobotSession session;

  @BeforeEach
  void switchOn() throws Exception {
    session = RobotSession.start(ControllerOptions.headless());
  }

  @AfterEach
  void switchOff() {
    session.close();
  }

  @Test
  void anotherArmIsSomethingThatLinksCanGetIntoWhereThereAreNoObjects() throws Exception {
    assertFalse(TimelineView.somethingAround(session));
    session.restart(SharedCell.setup(SharedCell.SCENE.replaceFirst("\"objects\": .*,\n", "")));
    assertTrue(TimelineView.somethingAround(session));
  }
}
