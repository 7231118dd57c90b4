package org.pendant.desktop.shell;

import java.awt.Component;
import java.awt.Dialog.ModalityType;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.File;
import java.nio.file.Path;
import java.util.function.Consumer;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.SwingUtilities;
import javax.swing.filechooser.FileNameExtensionFilter;

/** Open dialog: asks for files to open, while the window behind it can be used. */
final class OpenDialog {
  private OpenDialog() {}

  /** As the other one, with the folder shown first that was used last. */
  static void show(
      Component parent,
      String title,
      String kind,
      String[] endings,
      UsedFolder folder,
      Consumer<Path> chosen) {
    show(parent, title, kind, endings, folder.get(), folder, chosen);
  }

  /**
   * Opens the dialog.
   *
   * @param title what it is called
   * @param kind what the files are called
   * @param endings of their names, such as {@code script}
   * @param first folder that is shown first
   * @param folder learns what was chosen
   * @param chosen takes each file
   */
  static void show(
      Component parent,
      String title,
      String kind,
      String[] endings,
      Path first,
      UsedFolder folder,
      Consumer<Path> chosen) {
    JDialog dialog =
        new JDialog(SwingUtilities.getWindowAncestor(parent), title, ModalityType.MODELESS);
    JFileChooser chooser = new JFileChooser(first.toFile());
    chooser.setName("open-dialog");
    chooser.getAccessibleContext().setAccessibleName(title);
    chooser.setFileFilter(new FileNameExtensionFilter(kind, endings));
    chooser.setMultiSelectionEnabled(true);
    chooser.addActionListener(
        event -> {
          dialog.dispose();
          if (event.getActionCommand().equals(JFileChooser.APPROVE_SELECTION)) {
            for (File each : chooser.getSelectedFiles()) {
              folder.chosen(each.toPath());
              chosen.accept(each.toPath());
            }
          }
        });
    dialog.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosing(WindowEvent event) {
            chooser.cancelSelection();
          }
        });
    dialog.add(chooser);
    dialog.pack();
    dialog.setLocationRelativeTo(parent);
    dialog.setVisible(true);
  }
}
