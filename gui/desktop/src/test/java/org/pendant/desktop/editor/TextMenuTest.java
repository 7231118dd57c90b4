package org.pendant.desktop.editor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.awt.Component;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import org.junit.jupiter.api.Test;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.dispatch.OnDispatchThread;
import org.pendant.kit.settings.MemorySettings;

@OnDispatchThread
final class TextMenuTest {
  private final ActionTable actions = new ActionTable(new MemorySettings());
  private final List<String> done = new ArrayList<>();

  private void add(String id, String title) {
    actions.add(Action.of(id, title, "", () -> done.add(id)));
  }

  private List<String> titles() {
    return Arrays.stream(TextMenu.menu(actions).getComponents()).map(TextMenuTest::title).toList();
  }

  private static String title(Component part) {
    return part instanceof JMenuItem item ? item.getText() : "-";
  }

  @Test
  void actionsStandInGroups() {
    add("editor.rename", "Rename");
    add("edit.copy", "Copy");
    add("edit.paste", "Paste");

    assertEquals(List.of("Copy", "Paste", "-", "Rename"), titles());
  }

  @Test
  void anItemDoesItsAction() {
    add("edit.cut", "Cut");
    JPopupMenu menu = TextMenu.menu(actions);

    ((JMenuItem) menu.getComponent(0)).doClick();

    assertEquals(List.of("edit.cut"), done);
  }

  @Test
  void whatCannotBeDoneNowIsGrey() {
    actions.add(new Action("edit.paste", "Paste", "", () -> false, () -> {}));

    assertFalse(TextMenu.menu(actions).getComponent(0).isEnabled());
  }
}
