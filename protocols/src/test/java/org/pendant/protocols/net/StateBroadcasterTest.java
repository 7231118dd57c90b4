package org.pendant.protocols.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;

class StateBroadcasterTest {
  private static final long GIVE_UP_S = 20;

  private final Controller controller = new Controller(ControllerOptions.headless());
  private final BlockingQueue<String> logged = new LinkedBlockingQueue<>();
  private final StateBroadcaster fan =
      new StateBroadcaster(controller.feed(), new PeerLog((level, text) -> logged.add(text)));

  @AfterEach
  void close() {
    fan.close();
  }

  @Test
  void framesMustComeOnTimeUnlessNobodyNeedsThat() {
    assertTrue(controller.feed().followed());
    fan.onTimeWhile(() -> false);
    assertFalse(controller.feed().followed());
  }

  @Test
  void aListenerThatFailsIsLoggedAndDisturbsNoOther() throws Exception {
    BlockingQueue<Long> seen = new LinkedBlockingQueue<>();
    fan.add(
        state -> {
          throw new IllegalStateException("broken");
        });
    fan.add(state -> seen.add(state.frame()));
    controller.advance();
    controller.advance();
    assertEquals(1, seen.poll(GIVE_UP_S, TimeUnit.SECONDS));
    assertEquals(2, seen.poll(GIVE_UP_S, TimeUnit.SECONDS));
    assertTrue(logged.poll(GIVE_UP_S, TimeUnit.SECONDS).contains("broken"));
  }
}
