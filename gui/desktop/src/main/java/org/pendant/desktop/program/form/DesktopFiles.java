package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import java.awt.Component;
import java.awt.EventQueue;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.function.Consumer;
import javax.swing.JFileChooser;
import javax.swing.filechooser.FileNameExtensionFilter;
import org.pendant.kit.background.WorkQueue;

/** Desktop files: those of this machine. */
final class DesktopFiles implements FormFiles {
  /** Longer ones are no program. */
  private static final long MAX_BYTES = 4_000_000;

  private final Component owner;
  private final WorkQueue background;
  private final FormHost host;

  /**
   * Files by the dialog of the window that {@code owner} is in.
   *
   * @param host says where to begin
   */
  DesktopFiles(Component owner, WorkQueue background, FormHost host) {
    this.owner = owner;
    this.background = background;
    this.host = host;
  }

  @Override
  public void choose(String title, String ending, Consumer<Path> chosen) {
    JFileChooser chooser = new JFileChooser();
    chooser.setDialogTitle(title);
    host.folder().ifPresent(folder -> chooser.setCurrentDirectory(folder.toFile()));
    String plain = ending.substring(1);
    chooser.setFileFilter(
        new FileNameExtensionFilter("*" + ending.toLowerCase(Locale.ROOT), plain));
    if (chooser.showOpenDialog(owner) == JFileChooser.APPROVE_OPTION) {
      chosen.accept(chooser.getSelectedFile().toPath());
    }
  }

  @Override
  public void read(Path file, Consumer<String> text, Consumer<String> failed) {
    background.run(
        0,
        () -> {
          try {
            long size = Files.size(file);
            if (size > MAX_BYTES) {
              later(failed, text("hasBytesMustBeAtMost", file, size, MAX_BYTES));
              return;
            }
            later(
                text,
                StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(ByteBuffer.wrap(Files.readAllBytes(file)))
                    .toString());
          } catch (NoSuchFileException e) {
            later(failed, text("cannotBeReadThereIsNo", file));
          } catch (CharacterCodingException e) {
            later(failed, text("cannotBeReadItIsNo", file));
          } catch (IOException e) {
            later(failed, text("cannotBeRead", file, e.getMessage()));
          }
        });
  }

  private static void later(Consumer<String> receiver, String text) {
    EventQueue.invokeLater(() -> receiver.accept(text));
  }
}
