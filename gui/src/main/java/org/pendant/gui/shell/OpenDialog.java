package org.pendant.gui.shell;

import java.awt.Component;
import java.awt.Dialog.ModalityType;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.SwingUtilities;
import javax.swing.filechooser.FileNameExtensionFilter;

/** Asks for a program to open, while the window behind it can be used. */
final class OpenDialog {
  private OpenDialog() {}

  static void show(Component parent, Optional<Path> folder, Consumer<Path> chosen) {
    JDialog dialog =
        new JDialog(
            SwingUtilities.getWindowAncestor(parent), "Open program", ModalityType.MODELESS);
    JFileChooser chooser = new JFileChooser(folder.map(Path::toFile).orElse(null));
    chooser.setName("open-dialog");
    chooser.getAccessibleContext().setAccessibleName("Open program");
    chooser.setFileFilter(new FileNameExtensionFilter("URScript programs", "script", "urscript"));
    chooser.addActionListener(
        event -> {
          dialog.dispose();
          if (event.getActionCommand().equals(JFileChooser.APPROVE_SELECTION)) {
            chosen.accept(chooser.getSelectedFile().toPath());
          }
        });
    dialog.add(chooser);
    dialog.pack();
    dialog.setLocationRelativeTo(parent);
    dialog.setVisible(true);
  }
}
