package org.pendant.desktop.lines;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JComponent;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.desktop.preview.PreviewWorkbench;
import org.pendant.recording.RecordingRing;
import org.pendant.recording.explain.MotionExplanation;

/** The panel, in no window. */
final class MotionViewTest {
  private static final int WIDTH = 900;

  private final ControllerOptions options = ControllerOptions.headless();
  private final Controller controller = new Controller(options);
  private Optional<MotionExplanation> moment = Optional.empty();

  @Test
  void wordsHaveAllRoomUntilThereAreNumbersBesideThem() throws Exception {
    RecordingRing ring = new RecordingRing(controller.state(), controller::programSource);
    controller.advance();
    ring.take(controller.state());
    EventQueue.invokeAndWait(
        () -> {
          MotionView view =
              new MotionView(
                  new PreviewWorkbench(), () -> moment, line -> "line " + line, Optional::empty);
          JComponent content = view.component();
          content.setSize(WIDTH, 200);

          view.refresh(controller.state());
          layOut(content);
          assertEquals(WIDTH, named(content, "motion-text").getWidth());
          assertFalse(named(content, "motion-table").isShowing());

          moment = Optional.of(MotionExplanation.of(ring.recording(), 1, options.safety(), false));
          view.refresh(controller.state());
          layOut(content);
          int words = named(content, "motion-text").getWidth();
          assertTrue(words > 0.35 * WIDTH && words < 0.45 * WIDTH, () -> words + " px");
          int numbers = named(content, "motion-table").getWidth();
          assertTrue(numbers > 0.5 * WIDTH, () -> numbers + " px");
        });
  }

  private static void layOut(Container in) {
    in.doLayout();
    Stream.of(in.getComponents())
        .filter(Container.class::isInstance)
        .forEach(each -> layOut((Container) each));
  }

  private static Component named(Component in, String name) {
    return parts(in).filter(each -> name.equals(each.getName())).findFirst().orElseThrow();
  }

  private static Stream<Component> parts(Component in) {
    return in instanceof Container inner
        ? Stream.concat(
            Stream.of(in), Stream.of(inner.getComponents()).flatMap(MotionViewTest::parts))
        : Stream.of(in);
  }
}
