package org.pendant.kit.layout;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.EventQueue;
import java.awt.Font;
import java.lang.reflect.InvocationTargetException;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import javax.swing.plaf.FontUIResource;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

final class CodeAreaTest {
  private static final String KEY = "monospaced.font";

  @BeforeEach
  void chooseAFont() {
    UIManager.put(KEY, new FontUIResource(Font.MONOSPACED, Font.PLAIN, 17));
  }

  @AfterEach
  void forgetIt() {
    UIManager.put(KEY, null);
  }

  @Test
  void itsLettersStayAsWideUnderAnotherLook()
      throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          CodeArea area = new CodeArea();
          JPanel around = new JPanel();
          around.add(area);
          for (int size : new int[] {17, 23}) {
            UIManager.put(KEY, new FontUIResource(Font.MONOSPACED, Font.PLAIN, size));
            SwingUtilities.updateComponentTreeUI(around);
            assertEquals(new Font(Font.MONOSPACED, Font.PLAIN, size), area.getFont());
          }
        });
  }
}
