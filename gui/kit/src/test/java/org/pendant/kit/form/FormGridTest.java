package org.pendant.kit.form;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.event.FocusEvent;
import java.util.List;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import org.junit.jupiter.api.Test;

final class FormGridTest {
  private final PartsForm<String> form =
      new PartsForm<>("limits", value -> value.equals("much") ? "is no number" : "", value -> {});
  private final JScrollPane scroll = new JScrollPane(form.component());

  @Test
  void whatIsWrongIsShownWhereItIsBelowALargeGrid() throws Exception {
    EventQueue.invokeAndWait(
        () -> {
          JPanel grid = new JPanel();
          grid.setPreferredSize(new Dimension(300, 400));
          EntryField power = form.entry("power", "Power", value -> value, (value, text) -> text);
          grid.add(power);
          form.grid(grid, List.of(power));
          form.show("300");
          scroll.setSize(340, 200);
          layOut(scroll);
          power.setText("much");
          leave(power);
          layOut(scroll);
        });
    EventQueue.invokeAndWait(
        () -> {
          JTextArea problem = problem();
          assertEquals("Power: is no number", problem.getText());
          assertTrue(
              scroll.getViewport().getViewRect().contains(problem.getBounds()),
              () -> scroll.getViewport().getViewRect() + " has " + problem.getBounds());
        });
  }

  private static void layOut(Container container) {
    container.doLayout();
    for (Component each : container.getComponents()) {
      if (each instanceof Container inner) {
        layOut(inner);
      }
    }
  }

  private static void leave(EntryField field) {
    for (var each : field.getFocusListeners()) {
      each.focusLost(new FocusEvent(field, FocusEvent.FOCUS_LOST));
    }
  }

  private JTextArea problem() {
    for (var each : form.component().getComponents()) {
      if ("limits-grid-problem".equals(each.getName())) {
        return (JTextArea) each;
      }
    }
    throw new AssertionError("no place for what is wrong");
  }
}
