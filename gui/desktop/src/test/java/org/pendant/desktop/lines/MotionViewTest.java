package org.pendant.desktop.lines;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.util.Optional;
import javax.swing.JComponent;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.desktop.preview.PreviewWorkbench;
import org.pendant.kit.layout.Parts;
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
          Parts.layOut(content);
          assertEquals(WIDTH, Parts.named(content, "motion-text").getWidth());
          assertFalse(Parts.named(content, "motion-table").isShowing());

          moment = Optional.of(MotionExplanation.of(ring.recording(), 1, options.safety(), false));
          view.refresh(controller.state());
          Parts.layOut(content);
          int words = Parts.named(content, "motion-text").getWidth();
          assertTrue(words > 0.35 * WIDTH && words < 0.45 * WIDTH, () -> words + " px");
          int numbers = Parts.named(content, "motion-table").getWidth();
          assertTrue(numbers > 0.5 * WIDTH, () -> numbers + " px");
        });
  }
}
