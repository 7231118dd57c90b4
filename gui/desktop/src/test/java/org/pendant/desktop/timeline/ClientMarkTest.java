package org.pendant.desktop.timeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.event.ActionEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.Test;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.kit.dispatch.OnDispatchThread;

@OnDispatchThread
final class ClientMarkTest {
  private static final int WIDTH = 800;
  private static final int HEIGHT = 200;

  private final RecordedRun run = new RecordedRun().frames(500);
  private final LookBack lookBack = new LookBack(run.ring::recording, text -> {});
  private final TimelineCanvas canvas = new TimelineCanvas(lookBack, () -> PoseForm.STANDARD);
  private final List<Long> shown = new ArrayList<>();

  ClientMarkTest() {
    lookBack.take(run.state());
    lookBack.showAll();
    canvas.setSize(WIDTH, HEIGHT);
    canvas.markClients(
        () -> List.of(new ClientMark(0.5, 7, "Dashboard client x play")), shown::add);
    canvas.paint(new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB).getGraphics());
  }

  private static MouseEvent at(TimelineCanvas canvas, int id, int x, int y) {
    return new MouseEvent(canvas, id, 0, 0, x, y, 1, false, MouseEvent.BUTTON1);
  }

  private String tip(int x, int y) {
    return canvas.getToolTipText(at(canvas, MouseEvent.MOUSE_MOVED, x, y));
  }

  /** Where the pointer is on the mark. */
  private List<Integer> places(int x) {
    return IntStream.range(0, HEIGHT)
        .filter(y -> tip(x, y).contains("Dashboard client x play"))
        .boxed()
        .toList();
  }

  private int middle() {
    return IntStream.range(0, WIDTH).filter(x -> !places(x).isEmpty()).boxed().toList().get(3);
  }

  @Test
  void thePointerSaysWhatAClientDidAndAClickShowsTheMessage() {
    int x = middle();
    int y = places(x).getFirst();
    assertEquals("0.500 s: Dashboard client x play (click for the message)", tip(x, y));
    canvas.dispatchEvent(at(canvas, MouseEvent.MOUSE_CLICKED, x, y));
    assertEquals(List.of(7L), shown);
  }

  @Test
  void aClickBesideTheMarksShowsNoMessage() {
    int x = middle();
    canvas.dispatchEvent(at(canvas, MouseEvent.MOUSE_CLICKED, x, HEIGHT - 5));
    canvas.dispatchEvent(at(canvas, MouseEvent.MOUSE_CLICKED, x + 50, places(x).getFirst()));
    assertTrue(shown.isEmpty());
  }

  @Test
  void enterShowsTheMessageOfTheMomentThatIsLookedAt() {
    lookBack.scrub(0.5);
    Object action = canvas.getInputMap().get(KeyStroke.getKeyStroke("ENTER"));
    canvas.getActionMap().get(action).actionPerformed(new ActionEvent(canvas, 0, ""));
    assertEquals(List.of(7L), shown);
  }
}
