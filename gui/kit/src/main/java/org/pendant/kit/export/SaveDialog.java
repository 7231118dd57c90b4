package org.pendant.kit.export;

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
import org.pendant.kit.fault.Faults;

/**
 * Save dialog: asks where to save and saves there, while the window behind it can be used. A file
 * that exists is replaced only after the button was pressed a second time.
 */
public final class SaveDialog {
  private final JDialog dialog;
  private final JFileChooser chooser;

  private SaveDialog(Component parent, SaveRequest request) {
    dialog =
        new JDialog(
            SwingUtilities.getWindowAncestor(parent), request.title(), ModalityType.MODELESS);
    chooser = new AskingTwice(dialog, request);
  }

  /**
   * Opens the dialog.
   *
   * @param parent something in the window that it belongs to
   * @param export writes the file
   * @param told hears in a sentence how it went, on the dispatch thread
   */
  public static void open(
      Component parent, SaveRequest request, Export export, Consumer<String> told) {
    ask(parent, request, chosen -> chosen.ifPresent(file -> write(file, export, told)));
  }

  /**
   * Asks for a file and leaves the writing to others.
   *
   * @param parent something in the window that it belongs to
   * @param chosen takes the file, or nothing if people do not want to any more
   */
  public static void ask(Component parent, SaveRequest request, Consumer<Optional<Path>> chosen) {
    SaveDialog save = new SaveDialog(parent, request);
    JFileChooser chooser = save.chooser;
    String[] endings = request.endings().toArray(String[]::new);
    chooser.setFileFilter(
        new FileNameExtensionFilter("*." + String.join(", *.", endings), endings));
    Path suggestion = request.suggestion();
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

  /**
   * A chooser that wants to hear twice that a file shall be replaced, and knows some that never.
   */
  @SuppressWarnings("serial") // never written to a stream
  private static final class AskingTwice extends JFileChooser {
    private final JDialog dialog;
    private final SaveRequest request;
    private File warned = new File("");

    AskingTwice(JDialog dialog, SaveRequest request) {
      this.dialog = dialog;
      this.request = request;
      setName("save-dialog");
      setDialogType(SAVE_DIALOG);
      getAccessibleContext().setAccessibleName(request.title());
    }

    @Override
    public void approveSelection() {
      File file = request.file(getSelectedFile().toPath()).toFile();
      setSelectedFile(file);
      Optional<String> refusal = request.refusal(file.toPath());
      if (refusal.isPresent()) {
        dialog.setTitle(request.title() + ": " + refusal.get());
        return;
      }
      if (file.exists() && !file.equals(warned)) {
        warned = file;
        dialog.setTitle(request.title() + ": " + file.getName() + " exists already");
        setApproveButtonText("Replace");
        setApproveButtonToolTipText("Replace " + file.getName() + " by the new file");
        return;
      }
      super.approveSelection();
    }
  }
}
