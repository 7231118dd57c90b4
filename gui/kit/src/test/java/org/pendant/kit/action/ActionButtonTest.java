package org.pendant.kit.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.event.MouseEvent;
import java.util.List;
import javax.swing.JToolTip;
import org.junit.jupiter.api.Test;
import org.pendant.kit.dispatch.OnDispatchThread;
import org.pendant.kit.settings.MemorySettings;

@OnDispatchThread
final class ActionButtonTest {
  @Test
  void tipsStandAboveTheButtonAndNotOverItsNeighbours() {
    ActionTable actions = new ActionTable(new MemorySettings());
    actions.add(Action.of("program.run", "Run program", "F5", () -> {}));
    ActionButton button = new ActionButton(actions, "program.run", "Run", null);
    JToolTip tip = button.createToolTip();
    tip.setTipText(button.getToolTipText());
    MouseEvent there = new MouseEvent(button, MouseEvent.MOUSE_MOVED, 0, 0, 5, 5, 0, false);
    int top = button.getToolTipLocation(there).y;
    assertTrue(top + tip.getPreferredSize().height < 0, "at " + top);
  }

  @Test
  void isAsWideAsTheLongestTextThatItHasRoomFor() {
    ActionTable actions = new ActionTable(new MemorySettings());
    ActionButton button = new ActionButton(actions, "program.run", "Resume", null);
    int wide = button.getPreferredSize().width;
    button.setText("Run");
    assertTrue(button.getPreferredSize().width < wide);
    button.reserve(List.of("Run", "Resume"));
    assertEquals(wide, button.getPreferredSize().width);
  }
}
