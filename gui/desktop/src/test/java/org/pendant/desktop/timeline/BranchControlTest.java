package org.pendant.desktop.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.Pace;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.Branching;
import org.pendant.desktop.session.RobotSession;
import org.pendant.recording.replay.RerunRefused;

@Timeout(60)
final class BranchControlTest {
  private final List<String> told = new ArrayList<>();
  private final LinkedBlockingQueue<Runnable> later = new LinkedBlockingQueue<>();

  private BranchControl branchControl(
      RobotSession session, LookBack lookBack, Optional<String> refusal) {
    return new BranchControl(
        lookBack,
        new BranchControl.Branches() {
          @Override
          public Optional<String> refusal(long frame) {
            return refusal;
          }

          @Override
          public Branching begin(ControllerState recorded) throws RerunRefused {
            return session.branch(recorded);
          }
        },
        later::add,
        told::add,
        () -> {});
  }

  @Test
  void asksAndGoesOnFromTheMoment() throws Exception {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      session.setPace(new Pace.Paused());
      LookBack lookBack = new LookBack(session::recording, told::add);
      lookBack.take(session.state());
      BranchControl branchControl = branchControl(session, lookBack, Optional.empty());
      assertEquals("Choose a moment on the timeline first", branchControl.whyNot());
      lookBack.last();
      long frame = lookBack.past().orElseThrow().frame();

      branchControl.ask();
      assertEquals(
          Optional.of(
              "Continue from "
                  + LookBack.text(lookBack.past().orElseThrow().timeS())
                  + ", time paused? What came after is given up."),
          branchControl.question());
      branchControl.confirm();
      assertFalse(branchControl.progress().isEmpty());
      later.poll(30, TimeUnit.SECONDS).run();

      assertFalse(lookBack.back());
      assertEquals(frame, session.state().frame());
      assertTrue(told.getLast().contains("its time is paused"), told::toString);
      assertTrue(branchControl.progress().isEmpty());
    }
  }

  @Test
  void tellsWhyThereCanBeNone() {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      LookBack lookBack = new LookBack(session::recording, told::add);
      BranchControl branchControl =
          branchControl(session, lookBack, Optional.of("a socket was opened at 1.000 s"));
      lookBack.last();
      branchControl.ask();
      assertEquals(List.of("No branch from here: a socket was opened at 1.000 s"), told);
      assertTrue(branchControl.question().isEmpty());
    }
  }

  @Test
  void whoGoesBackToNowIsAskedNoMore() {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      LookBack lookBack = new LookBack(session::recording, told::add);
      BranchControl branchControl = branchControl(session, lookBack, Optional.empty());
      lookBack.last();
      branchControl.ask();
      lookBack.live();
      assertTrue(branchControl.question().isEmpty());
      assertTrue(told.isEmpty());
    }
  }

  @Test
  void nothingHappensWhenPeopleThinkBetterOfIt() {
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      LookBack lookBack = new LookBack(session::recording, told::add);
      BranchControl branchControl = branchControl(session, lookBack, Optional.empty());
      lookBack.last();
      branchControl.ask();
      branchControl.cancel();
      assertTrue(branchControl.question().isEmpty());
      assertTrue(lookBack.back());
      assertTrue(told.isEmpty());
    }
  }
}
