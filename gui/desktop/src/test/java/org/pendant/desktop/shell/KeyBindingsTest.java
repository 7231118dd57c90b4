package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.AWTKeyStroke;
import java.awt.KeyboardFocusManager;
import java.util.Set;
import javax.swing.JButton;
import javax.swing.JRootPane;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.Test;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.settings.MemorySettings;

/** Which keys lead to actions wherever the keyboard is. */
final class KeyBindingsTest {
  @Test
  void tabAloneLeadsFromOnePartToTheNextSoThatCtrlTabIsFreeForAnAction() throws Exception {
    DispatchThread.run(
        () -> {
          JRootPane root = new JRootPane();
          JButton button = new JButton("Apply");
          root.getContentPane().add(button);
          KeyBindings.bind(root, new ActionTable(new MemorySettings()));
          Set<AWTKeyStroke> forward =
              button.getFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS);
          assertEquals(Set.of(KeyStroke.getKeyStroke("TAB")), forward);
        });
  }
}
