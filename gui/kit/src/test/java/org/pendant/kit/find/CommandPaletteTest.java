package org.pendant.kit.find;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Component;
import java.awt.Container;
import java.awt.GraphicsEnvironment;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JFrame;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.dispatch.OnDispatchThread;
import org.pendant.kit.settings.MemorySettings;

@OnDispatchThread
final class CommandPaletteTest {
  @Test
  void itClosesWhenPeopleGoOnWithSomethingBesideIt() {
    assumeFalse(GraphicsEnvironment.isHeadless(), "there is no display");
    JFrame frame = new JFrame("palette");
    JPanel under = new JPanel();
    JTextField beside = new JTextField(10);
    under.add(beside);
    frame.add(under);
    frame.setSize(600, 400);
    try {
      CommandPalette palette = new CommandPalette(new ActionTable(new MemorySettings()), under);
      palette.open();
      Component query = parts(frame).filter(CommandPaletteTest::isQuery).findAny().orElseThrow();

      lose(query, beside, true);
      assertTrue(parts(frame).anyMatch(CommandPaletteTest::isQuery), "another window is in front");
      lose(query, beside, false);
      assertFalse(parts(frame).anyMatch(CommandPaletteTest::isQuery));
    } finally {
      frame.dispose();
    }
  }

  @Test
  void anActionIsFoundByOtherWordsThanThoseOfItsTitleInAnyOrder() {
    assumeFalse(GraphicsEnvironment.isHeadless(), "there is no display");
    ActionTable actions = new ActionTable(new MemorySettings());
    Action show = Action.of("view.motion", "Show Motion", "", () -> {});
    actions.add(Action.of("view.log", "Show Log", "", () -> {}));
    actions.add(show.foundBy("explain, why, slow"));
    JFrame frame = new JFrame("palette");
    JPanel under = new JPanel();
    frame.add(under);
    try {
      new CommandPalette(actions, under).open();
      assertEquals(List.of("view.motion"), found(frame, "slow motion"));
      assertEquals(List.of("view.motion"), found(frame, "explain"));
      assertEquals(List.of("view.log", "view.motion"), found(frame, "show"));
    } finally {
      frame.dispose();
    }
  }

  @Test
  void anActionThatCannotBeDoneNowComesBeforeOnesThatMerelyBeginWithTheLetters() {
    assumeFalse(GraphicsEnvironment.isHeadless(), "there is no display");
    ActionTable actions = new ActionTable(new MemorySettings());
    actions.add(Action.of("unit.rpy", "Units: roll, pitch, yaw", "", () -> {}));
    actions.add(
        new Action("file.export-urp", "Export as .urp", "", () -> false, () -> {}),
        () -> "the program is a script");
    JFrame frame = new JFrame("palette");
    JPanel under = new JPanel();
    frame.add(under);
    try {
      new CommandPalette(actions, under).open();
      assertEquals(List.of("file.export-urp", "unit.rpy"), found(frame, "urp"));
      assertEquals(List.of("unit.rpy", "file.export-urp"), found(frame, ""));
    } finally {
      frame.dispose();
    }
  }

  /** Ids of what the palette shows for a query. */
  private static List<String> found(JFrame frame, String typed) {
    parts(frame)
        .filter(CommandPaletteTest::isQuery)
        .map(JTextField.class::cast)
        .forEach(query -> query.setText(typed));
    JList<?> list =
        parts(frame)
            .filter(part -> "palette-list".equals(part.getName()))
            .map(JList.class::cast)
            .findAny()
            .orElseThrow();
    List<String> ids = new ArrayList<>();
    for (int i = 0; i < list.getModel().getSize(); i++) {
      ids.add(((Action) list.getModel().getElementAt(i)).id());
    }
    return ids;
  }

  @Test
  void aLongReasonGivesWayToTheTitleAndTheKeys() {
    ActionTable actions = new ActionTable(new MemorySettings());
    Action action =
        new Action(
            "test.show", "Show controller 1 of the cell", "ctrl alt 1", () -> false, () -> {});
    actions.add(action, () -> "the controller is alone; a scene with arms has several of them");
    Component row =
        new PaletteRow(actions)
            .getListCellRendererComponent(new JList<>(), action, 0, false, false);
    row.setSize(480, row.getPreferredSize().height);
    row.doLayout();
    Component[] parts = ((Container) row).getComponents();
    for (int i = 1; i < parts.length; i++) {
      int end = parts[i - 1].getX() + parts[i - 1].getWidth();
      assertTrue(end <= parts[i].getX(), "part " + i + " begins left of " + end);
    }
    assertEquals(parts[0].getPreferredSize().width, parts[0].getWidth());
  }

  private static boolean isQuery(Component part) {
    return "palette-query".equals(part.getName());
  }

  /** Tells that the keys go to another part now. */
  private static void lose(Component query, Component other, boolean temporary) {
    FocusEvent event = new FocusEvent(query, FocusEvent.FOCUS_LOST, temporary, other);
    for (FocusListener each : query.getFocusListeners()) {
      each.focusLost(event);
    }
  }

  private static Stream<Component> parts(Component in) {
    return in instanceof Container inner
        ? Stream.concat(
            Stream.of(in), Stream.of(inner.getComponents()).flatMap(CommandPaletteTest::parts))
        : Stream.of(in);
  }
}
