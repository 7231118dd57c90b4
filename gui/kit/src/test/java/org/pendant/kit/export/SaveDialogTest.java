package org.pendant.kit.export;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Component;
import java.awt.Container;
import java.awt.GraphicsEnvironment;
import java.awt.Window;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.pendant.kit.dispatch.OnDispatchThread;

@OnDispatchThread
final class SaveDialogTest {
  private static final String TITLE = "Save recording as";

  @Test
  void saysThatItSavesInAnotherLookToo() {
    assumeFalse(GraphicsEnvironment.isHeadless(), "there is no display");
    FlatLaf.setup(new FlatLightLaf());
    SaveDialog.ask(
        new JPanel(),
        new SaveRequest(TITLE, Path.of("run.rec"), List.of("rec"), List.of()),
        chosen -> {});
    JDialog dialog = opened();
    try {
      assertTrue(labels(dialog).anyMatch("Save In:"::equals));
      FlatLaf.setup(new FlatDarkLaf());
      SwingUtilities.updateComponentTreeUI(dialog);
      assertTrue(labels(dialog).anyMatch("Save In:"::equals));
    } finally {
      dialog.dispose();
    }
  }

  private static JDialog opened() {
    return Arrays.stream(Window.getWindows())
        .filter(each -> each instanceof JDialog dialog && TITLE.equals(dialog.getTitle()))
        .map(JDialog.class::cast)
        .findFirst()
        .orElseThrow();
  }

  private static Stream<String> labels(Component component) {
    Stream<String> own =
        component instanceof JLabel label && label.getText() != null
            ? Stream.of(label.getText())
            : Stream.empty();
    return component instanceof Container container
        ? Stream.concat(
            own, Arrays.stream(container.getComponents()).flatMap(SaveDialogTest::labels))
        : own;
  }
}
