package org.pendant.desktop.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.pendant.controller.ControllerOptions;

/** Faults in what listens to a session end neither the robot nor its exchange. */
@Timeout(value = 60, unit = TimeUnit.SECONDS)
final class RobotSessionFaultTest {
  private final Thread.UncaughtExceptionHandler before =
      Thread.getDefaultUncaughtExceptionHandler();

  @BeforeEach
  void dropFaults() {
    Thread.setDefaultUncaughtExceptionHandler((thread, fault) -> {});
  }

  @AfterEach
  void stopDropping() {
    Thread.setDefaultUncaughtExceptionHandler(before);
  }

  @Test
  void theRobotGoesOnWhenAListenerThrowsInItsFrames() throws InterruptedException {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      CountDownLatch frames = new CountDownLatch(5);
      session.addFrameListener(
          state -> {
            throw new IllegalStateException("frame " + state.frame());
          });
      session.addFrameListener(state -> frames.countDown());
      assertTrue(frames.await(30, TimeUnit.SECONDS), "the frames have stopped");
      assertEquals(Optional.empty(), session.failure());
    }
  }

  @Test
  void theControllerIsExchangedAlthoughAListenerThrows() throws InterruptedException {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      session.addSwitchListener(
          new SwitchListener() {
            @Override
            public void switchingOff() {
              throw new IllegalStateException("off");
            }

            @Override
            public void switchedOn() {
              throw new IllegalStateException("on");
            }
          });
      session.restart(session.options());
      CountDownLatch frames = new CountDownLatch(5);
      session.addFrameListener(state -> frames.countDown());
      assertTrue(frames.await(30, TimeUnit.SECONDS), "the new controller does not go");
    }
  }
}
