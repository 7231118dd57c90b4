package org.pendant.kit.action;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.EventQueue;
import java.awt.FlowLayout;
import java.awt.GraphicsEnvironment;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import javax.swing.JFrame;
import org.junit.jupiter.api.Test;
import org.pendant.kit.settings.MemorySettings;

final class ActionButtonsTest {
  private static final int MAX_WAIT_S = 20;

  private final CountDownLatch runHasKeys = new CountDownLatch(1);
  private final CountDownLatch pauseHasKeys = new CountDownLatch(1);
  private boolean loading;
  private boolean running;

  private static ActionButton button(ActionTable actions, String id, BooleanSupplier enabled) {
    actions.add(new Action(id, id, "", enabled, () -> {}));
    return new ActionButton(actions, id, id, null);
  }

  private static void whenFocused(ActionButton button, CountDownLatch has) {
    button.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusGained(FocusEvent event) {
            has.countDown();
          }
        });
  }

  @Test
  void keysOnAButtonThatCanNoLongerBePressedGoToTheOneThatCan() throws Exception {
    assumeFalse(GraphicsEnvironment.isHeadless(), "there is no display");
    ActionTable actions = new ActionTable(new MemorySettings());
    ActionButton run = button(actions, "program.run", () -> !running && !loading);
    ActionButton pause = button(actions, "program.pause", () -> running);
    whenFocused(run, runHasKeys);
    whenFocused(pause, pauseHasKeys);
    ActionButtons buttons = new ActionButtons(List.of(run, pause));
    JFrame frame = new JFrame("Buttons");
    try {
      EventQueue.invokeAndWait(
          () -> {
            frame.setLayout(new FlowLayout());
            frame.add(run);
            frame.add(pause);
            frame.pack();
            frame.setVisible(true);
            run.requestFocusInWindow();
          });
      assumeTrue(runHasKeys.await(MAX_WAIT_S, TimeUnit.SECONDS), "the window gets no keys here");
      EventQueue.invokeAndWait(
          () -> {
            loading = true;
            buttons.refresh();
          });
      EventQueue.invokeAndWait(buttons::refresh);
      EventQueue.invokeAndWait(
          () -> {
            running = true;
            buttons.refresh();
          });
      assertTrue(pauseHasKeys.await(MAX_WAIT_S, TimeUnit.SECONDS));
    } finally {
      EventQueue.invokeAndWait(frame::dispose);
    }
  }
}
