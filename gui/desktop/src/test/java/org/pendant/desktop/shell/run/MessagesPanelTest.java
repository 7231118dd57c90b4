package org.pendant.desktop.shell.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.util.Arrays;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.kit.dispatch.OnDispatchThread;

@OnDispatchThread
final class MessagesPanelTest {
  private static final String LONG = "the tool comes too close to the safety plane ".repeat(5);

  /** A message that is cut shows that it is, and has all of it under the pointer. */
  @Test
  void aLongMessageStaysWithinTheCard() {
    Controller controller = new Controller(ControllerOptions.headless());
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(
                TestController.program(controller, "textmsg(\"" + LONG + "\")\n")));
    controller.runUntil(() -> false, 10);
    MessagesPanel panel = new MessagesPanel();
    panel.refresh(controller.state(), controller, Optional.empty());
    JComponent card = panel.component();
    card.setSize(400, 100);
    card.doLayout();
    Component text =
        Arrays.stream(card.getComponents())
            .filter(each -> each instanceof JLabel label && LONG.equals(label.getText()))
            .findFirst()
            .orElseThrow();
    assertTrue(text.getX() + text.getWidth() < 400, "to " + (text.getX() + text.getWidth()));
    assertEquals(LONG, ((JComponent) text).getToolTipText());
  }
}
