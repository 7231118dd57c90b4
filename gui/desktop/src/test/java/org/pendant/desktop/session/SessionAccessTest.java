package org.pendant.desktop.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.pendant.command.service.RobotAccess;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.Robot;
import org.pendant.language.source.Source;

final class SessionAccessTest {
  /** Keeps what it is shown. */
  private static final class KeepingAccess implements RobotAccess {
    private final List<String> seen = new ArrayList<>();
    private Optional<Robot> robot = Optional.empty();

    @Override
    public void show(Robot shown, Supplier<Optional<Source>> program) {
      seen.add("shown");
      robot = Optional.of(shown);
    }

    @Override
    public void hide() {
      seen.add("hidden");
      robot = Optional.empty();
    }
  }

  @Test
  void leadsToTheControllerThatTakesThePlaceOfAnother() {
    KeepingAccess access = new KeepingAccess();
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      SessionAccess.lead(access, session);
      assertSame(session.robot(), access.robot.orElseThrow());
      session.restart(ControllerOptions.headless());
      assertSame(session.robot(), access.robot.orElseThrow());
    }
    assertEquals(List.of("shown", "hidden", "shown", "hidden"), access.seen);
  }
}
