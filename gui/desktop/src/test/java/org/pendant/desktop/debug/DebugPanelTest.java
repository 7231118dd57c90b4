package org.pendant.desktop.debug;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.lang.reflect.InvocationTargetException;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

final class DebugPanelTest {
  @AfterEach
  void light() throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(FlatLightLaf::setup);
  }

  @Test
  void textsStayWhereTheyAreWhenTheColoursChange()
      throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          FlatLightLaf.setup();
          DebugPanel panel = new DebugPanel("panel", new JPanel());
          FlatDarkLaf.setup();
          SwingUtilities.updateComponentTreeUI(panel);
          List<JTextArea> texts = texts(panel);
          assertEquals(2, texts.size());
          for (JTextArea each : texts) {
            assertEquals(0, each.getInsets().left, each.getName());
          }
        });
  }

  private static List<JTextArea> texts(Container in) {
    List<JTextArea> found = new ArrayList<>();
    for (Component each : in.getComponents()) {
      if (each instanceof JTextArea text) {
        found.add(text);
      } else if (each instanceof Container below) {
        found.addAll(texts(below));
      }
    }
    return found;
  }
}
