package org.pendant.gui.export;

import java.awt.Component;
import java.awt.Dialog.ModalityType;
import java.awt.EventQueue;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.SwingUtilities;
import javax.swing.filechooser.FileNameExtensionFilter;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.gui.fault.Faults;

/**
 * Asks where to save and saves there, while the window behind it can be used. A file that exists is
 * replaced only after the button was pressed a second time.
 */
public final class SaveDialog {
  private final JDialog dialog;
  private final JFileChooser chooser;

  private SaveDialog(Component parent, String title) {
    dialog = new JDialog(SwingUtilities.getWindowAncestor(parent), title, ModalityType.MODELESS);
    chooser = new AskingTwice(dialog, title);
  }

  /**
   * Opens the dialog.
   *
   * @param parent something in the window that it belongs to
   * @param fileName what the file is called unless people want otherwise
   * @param endings file name endings that {@code export} knows, such as {@code csv}; the first is
   *     added where there is none
   * @param export writes the file
   * @param told hears in a sentence how it went, on the dispatch thread
   */
  public static void open(
      Component parent,
      String title,
      String fileName,
      String[] endings,
      Export export,
      Consumer<String> told) {
    ask(
        parent,
        title,
        Path.of(fileName),
        endings,
        chosen -> chosen.ifPresent(file -> write(file, export, told)));
  }

  /**
   * Asks for a file and leaves the writing to others.
   *
   * @param parent something in the window that it belongs to
   * @param suggestion the file unless people want otherwise; its folder is the first that is shown
   * @param endings file name endings, such as {@code csv}; the first is added where there is none
   * @param chosen takes the file, or nothing if people do not want to any more
   */
  public static void ask(
      Component parent,
      String title,
      Path suggestion,
      String[] endings,
      Consumer<Optional<Path>> chosen) {
    SaveDialog save = new SaveDialog(parent, title);
    JFileChooser chooser = save.chooser;
    chooser.setFileFilter(
        new FileNameExtensionFilter("*." + String.join(", *.", endings), endings));
    if (suggestion.getParent() != null) {
      chooser.setCurrentDirectory(suggestion.getParent().toFile());
    }
    chooser.setSelectedFile(
        new File(chooser.getCurrentDirectory(), suggestion.getFileName().toString()));
    chooser.addActionListener(
        event -> {
          save.dialog.dispose();
          boolean approved = event.getActionCommand().equals(JFileChooser.APPROVE_SELECTION);
          chosen.accept(
              approved ? Optional.of(chooser.getSelectedFile().toPath()) : Optional.empty());
        });
    save.dialog.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosing(WindowEvent event) {
            chooser.cancelSelection();
          }
        });
    save.dialog.add(chooser);
    save.dialog.pack();
    save.dialog.setLocationRelativeTo(parent);
    save.dialog.setVisible(true);
  }

  private static void write(Path file, Export export, Consumer<String> told) {
    Thread.ofVirtual()
        .name("export")
        .start(
            () -> {
              String outcome = outcome(file, export);
              EventQueue.invokeLater(() -> told.accept(outcome));
            });
  }

  private static String outcome(Path file, Export export) {
    try {
      export.writeTo(file);
      return "Saved " + file.toAbsolutePath();
    } catch (IOException e) {
      return "Not saved: " + file.toAbsolutePath() + ": " + FileTrouble.reason(e);
    } catch (RuntimeException | Error fault) {
      Faults.report(fault);
      return "Not saved: " + file.toAbsolutePath() + ": internal error, " + fault;
    }
  }

  /** A chooser that wants to hear twice that a file shall be replaced. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class AskingTwice extends JFileChooser {
    private final JDialog dialog;
    private final String title;
    private File warned = new File("");

    AskingTwice(JDialog dialog, String title) {
      this.dialog = dialog;
      this.title = title;
      setName("save-dialog");
      setDialogType(SAVE_DIALOG);
      getAccessibleContext().setAccessibleName(title);
    }

    @Override
    public void approveSelection() {
      File file = withEnding(getSelectedFile());
      setSelectedFile(file);
      if (file.exists() && !file.equals(warned)) {
        warned = file;
        dialog.setTitle(title + ": " + file.getName() + " exists already");
        setApproveButtonText("Replace");
        setApproveButtonToolTipText("Replace " + file.getName() + " by the new file");
        return;
      }
      super.approveSelection();
    }

    private File withEnding(File file) {
      if (file.getName().contains(".")
          || !(getFileFilter() instanceof FileNameExtensionFilter known)) {
        return file;
      }
      return new File(file.getParentFile(), file.getName() + "." + known.getExtensions()[0]);
    }
  }
}
