package org.pendant.desktop.scene.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Point;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.Picked;
import org.pendant.desktop.scene.mesh.Link;

final class HoverTrackerTest {
  private static final Vector3 ORIGIN = new Vector3(0, 0, 0);
  private static final Picked FOREARM = new Picked.OnLink(Link.FOREARM, ORIGIN, 1);

  private final List<Point> asked = new ArrayList<>();
  private final List<CompletableFuture<Optional<Picked>>> answers = new ArrayList<>();
  private int changes;
  private final HoverTracker hover =
      new HoverTracker(
          (x, y) -> {
            asked.add(new Point(x, y));
            answers.add(new CompletableFuture<>());
            return answers.getLast();
          },
          Runnable::run,
          () -> changes++);

  private void move(int x, int y) {
    hover.mouseMoved(event(MouseEvent.MOUSE_MOVED, x, y));
  }

  private static MouseEvent event(int id, int x, int y) {
    return new MouseEvent(new JLabel(), id, 0, 0, x, y, 0, false);
  }

  @Test
  void namesWhatThePointerIsOn() {
    move(3, 4);
    answers.getLast().complete(Optional.of(FOREARM));

    assertEquals(Optional.of("Forearm"), hover.name());
    assertEquals(Optional.of(new Point(3, 4)), hover.pointer());
    assertEquals(1, changes);
  }

  @Test
  void namesObjectsAndTheToolToo() {
    move(1, 1);
    answers.getLast().complete(Optional.of(new Picked.OnObject("table", ORIGIN, 1)));
    assertEquals(Optional.of("table"), hover.name());

    hover.look();
    answers.getLast().complete(Optional.of(new Picked.OnTcp(ORIGIN, 1)));
    assertEquals(Optional.of("Tool centre point"), hover.name());
  }

  @Test
  void asksOnceAtATimeAndThenForTheNewestPlace() {
    move(1, 1);
    move(2, 2);
    move(3, 3);
    assertEquals(List.of(new Point(1, 1)), asked);

    answers.getLast().complete(Optional.empty());

    assertEquals(List.of(new Point(1, 1), new Point(3, 3)), asked);
  }

  @Test
  void asksNothingWhileThePointerIsElsewhere() {
    hover.look();
    move(1, 1);
    answers.getLast().complete(Optional.of(FOREARM));
    hover.mouseExited(event(MouseEvent.MOUSE_EXITED, 1, 1));
    hover.look();

    assertEquals(1, asked.size());
    assertTrue(hover.name().isEmpty());
  }

  @Test
  void anAnswerAfterThePointerHasLeftShowsNothing() {
    move(1, 1);
    hover.mousePressed(event(MouseEvent.MOUSE_PRESSED, 1, 1));
    answers.getLast().complete(Optional.of(FOREARM));

    assertTrue(hover.name().isEmpty());
  }
}
