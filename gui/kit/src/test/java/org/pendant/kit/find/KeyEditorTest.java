package org.pendant.kit.find;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import javax.swing.JPanel;
import javax.swing.JTable;
import org.junit.jupiter.api.Test;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.dispatch.OnDispatchThread;
import org.pendant.kit.settings.MemorySettings;

@OnDispatchThread
final class KeyEditorTest {
  /** Remembers nothing. */
  @Test
  void keysAreWholeBesideTheirTitles() {
    ActionTable actions = new ActionTable(new MemorySettings());
    actions.add(Action.of("all", "Save all programs", "control alt shift F12", () -> {}));
    JTable table = new KeyEditor(actions, new JPanel()).table();
    ((KeyTable) table.getModel()).filter("");
    table.setSize(528, 200);
    table.doLayout();
    Component keys = table.prepareRenderer(table.getCellRenderer(0, 1), 0, 1);
    int room = table.getCellRect(0, 1, false).width;
    int needed = keys.getPreferredSize().width;
    assertTrue(needed <= room, () -> needed + " pixels in " + room);
  }
}
