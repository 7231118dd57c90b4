package org.pendant.desktop.shell.chrome;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JButton;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.command.Command;
import org.pendant.kit.dispatch.OnDispatchThread;

@OnDispatchThread
final class ReadinessBarTest {
  private final List<Command> sent = new ArrayList<>();
  private final ReadinessBar bar =
      new ReadinessBar(new Controller(ControllerOptions.headless()).state(), sent::add);
  private final JButton remedy =
      Stream.of(bar.getComponents())
          .filter(JButton.class::isInstance)
          .map(JButton.class::cast)
          .findFirst()
          .orElseThrow();

  @Test
  void theSecondClickOfADoubleClickDoesNothing() {
    remedy.setSize(100, 30);
    click(10_000, 1);
    click(10_200, 2);
    assertEquals(1, sent.size(), "as the button may mean something else by then");
    click(12_000, 1);
    assertEquals(2, sent.size());
  }

  private void click(long whenMs, int count) {
    for (int id : List.of(MouseEvent.MOUSE_PRESSED, MouseEvent.MOUSE_RELEASED)) {
      int held = id == MouseEvent.MOUSE_PRESSED ? InputEvent.BUTTON1_DOWN_MASK : 0;
      remedy.dispatchEvent(
          new MouseEvent(remedy, id, whenMs, held, 50, 15, count, false, MouseEvent.BUTTON1));
    }
  }
}
