package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JPanel;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.settings.MemorySettings;

final class ClipboardActionsTest {
  private final ActionTable actions = new ActionTable(new MemorySettings());
  private final List<String> done = new ArrayList<>();
  private Component focus = new JPanel();

  ClipboardActionsTest() {
    ClipboardActions.addTo(actions, () -> focus);
  }

  @Test
  void cutNeedsASelectionInATextThatCanBeChanged() {
    JTextField field = field();
    assertFalse(can("edit.cut"));
    field.selectAll();
    assertTrue(can("edit.cut"));
    field.setEditable(false);
    assertFalse(can("edit.cut"));
  }

  @Test
  void aTextThatCannotBeChangedCanBeCopied() {
    JTextField field = field();
    field.setEditable(false);
    field.selectAll();
    assertTrue(can("edit.copy"));
    assertFalse(can("edit.paste"));
  }

  @Test
  void theTextWithTheKeyboardIsMeant() {
    field();
    for (String each : List.of("edit.paste", "edit.cut", "edit.copy")) {
      ((JTextField) focus).selectAll();
      actions.run(each);
    }
    assertEquals(List.of("paste", "cut", "copy"), done);
  }

  @Test
  void whereNoTextHasTheKeyboardTheNodesAreMeant() {
    assertFalse(can("edit.copy"));
    actions.add(Action.of("tree.copy", "Copy nodes", "control C", () -> done.add("nodes")));
    assertTrue(can("edit.copy"));
    actions.run("edit.copy");
    assertEquals(List.of("nodes"), done);
  }

  /** A field with the keyboard that only notes what it is told. */
  private JTextField field() {
    JTextField field =
        new JTextField("movej") {
          @Override
          public void cut() {
            done.add("cut");
          }

          @Override
          public void copy() {
            done.add("copy");
          }

          @Override
          public void paste() {
            done.add("paste");
          }
        };
    focus = field;
    return field;
  }

  private boolean can(String id) {
    return actions.find(id).orElseThrow().enabled().getAsBoolean();
  }
}
