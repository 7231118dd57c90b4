package org.pendant.kit.export;

import static org.pendant.kit.export.SaveTexts.text;

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
import javax.swing.plaf.basic.BasicFileChooserUI;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.kit.fault.Faults;
import org.pendant.kit.text.Messages;

/**
 * Save dialog: asks where to save and saves there, while the window behind it can be used. A file
 * that exists is replaced only after the button was pressed a second time.
 */
public final class SaveDialog {
  private final JDialog dialog;
  private final AskingTwice chooser;

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
    Path suggestion = request.suggestion();
    if (suggestion.getParent() != null) {
      chooser.setCurrentDirectory(suggestion.getParent().toFile());
    }
    chooser.setSelectedFile(
        new File(chooser.getCurrentDirectory(), suggestion.getFileName().toString()));
    save.chooser.followFilter();
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
      return text("saved", file.toAbsolutePath());
    } catch (IOException e) {
      return text("notSaved", file.toAbsolutePath(), FileTrouble.reason(e));
    } catch (RuntimeException | Error fault) {
      Faults.report(fault);
      return text("notSavedInternalError", file.toAbsolutePath(), fault);
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
      String first = request.ending(request.suggestion().getFileName().toString());
      for (String ending : request.endings()) {
        FileNameExtensionFilter filter = new FileNameExtensionFilter("*." + ending, ending);
        addChoosableFileFilter(filter);
        if (ending.equals(first)) {
          setFileFilter(filter);
        }
      }
    }

    /** Another look would say above the folder that files are to be opened. */
    @Override
    public void updateUI() {
      super.updateUI();
      if (getDialogType() == SAVE_DIALOG) {
        firePropertyChange(DIALOG_TYPE_CHANGED_PROPERTY, OPEN_DIALOG, SAVE_DIALOG);
      }
    }

    /** The name gets the ending of the filter that people choose from now on. */
    void followFilter() {
      addPropertyChangeListener(
          FILE_FILTER_CHANGED_PROPERTY,
          event -> {
            // The chooser forgets the file that its new filter hides, but not what was typed.
            if (getUI() instanceof BasicFileChooserUI ui && !ui.getFileName().isBlank()) {
              String name = new File(ui.getFileName()).getName();
              setSelectedFile(new File(getCurrentDirectory(), request.withEnding(name, ending())));
            }
          });
    }

    /** That of the chosen filter; the first while files of any kind are shown. */
    private String ending() {
      return getFileFilter() instanceof FileNameExtensionFilter chosen
          ? chosen.getExtensions()[0]
          : request.ending(getUI() instanceof BasicFileChooserUI ui ? ui.getFileName() : "");
    }

    @Override
    public void approveSelection() {
      File file = request.file(getSelectedFile().toPath(), ending()).toFile();
      setSelectedFile(file);
      Optional<String> refusal = request.refusal(file.toPath());
      if (refusal.isPresent()) {
        dialog.setTitle(Messages.told(request.title(), refusal.get()));
        return;
      }
      if (file.exists() && !file.equals(warned)) {
        warned = file;
        dialog.setTitle(text("existsAlready", request.title(), file.getName()));
        setApproveButtonText(text("replace"));
        setApproveButtonToolTipText(text("replaceByTheNewFile", file.getName()));
        return;
      }
      super.approveSelection();
    }
  }
}
