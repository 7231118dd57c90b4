package org.pendant.gui.timeline;

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
import org.pendant.controller.replay.RerunRefused;
import org.pendant.controller.state.ControllerState;
import org.pendant.gui.session.Branching;
import org.pendant.gui.session.Session;

@Timeout(60)
final class BranchDeskTest {
  private final List<String> told = new ArrayList<>();
  private final LinkedBlockingQueue<Runnable> later = new LinkedBlockingQueue<>();

  private BranchDesk desk(Session session, LookBack lookBack, Optional<String> refusal) {
    return new BranchDesk(
        lookBack,
        new BranchDesk.Branches() {
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
    try (Session session = Session.start(ControllerOptions.headless())) {
      session.setPace(new Pace.Paused());
      LookBack lookBack = new LookBack(session::recording, told::add);
      lookBack.take(session.state());
      BranchDesk desk = desk(session, lookBack, Optional.empty());
      assertEquals("Choose a moment on the timeline first", desk.whyNot());
      lookBack.last();
      long frame = lookBack.past().orElseThrow().frame();

      desk.ask();
      assertTrue(desk.question().orElseThrow().startsWith("Go on from "));
      desk.confirm();
      assertFalse(desk.progress().isEmpty());
      later.poll(30, TimeUnit.SECONDS).run();

      assertFalse(lookBack.back());
      assertEquals(frame, session.state().frame());
      assertTrue(told.getLast().contains("its time is paused"), told::toString);
      assertTrue(desk.progress().isEmpty());
    }
  }

  @Test
  void tellsWhyThereCanBeNone() {
    try (Session session = Session.start(ControllerOptions.headless())) {
      LookBack lookBack = new LookBack(session::recording, told::add);
      BranchDesk desk = desk(session, lookBack, Optional.of("a socket was opened at 1.000 s"));
      lookBack.last();
      desk.ask();
      assertEquals(List.of("No branch from here: a socket was opened at 1.000 s"), told);
      assertTrue(desk.question().isEmpty());
    }
  }

  @Test
  void nothingHappensWhenPeopleThinkBetterOfIt() {
    try (Session session = Session.start(ControllerOptions.headless())) {
      LookBack lookBack = new LookBack(session::recording, told::add);
      BranchDesk desk = desk(session, lookBack, Optional.empty());
      lookBack.last();
      desk.ask();
      desk.cancel();
      assertTrue(desk.question().isEmpty());
      assertTrue(lookBack.back());
      assertTrue(told.isEmpty());
    }
  }
}
