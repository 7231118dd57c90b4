package org.pendant.desktop.help;

import static org.pendant.desktop.help.HelpViewTexts.text;

import java.awt.Desktop;
import java.awt.Toolkit;
import java.awt.datatransfer.StringSelection;
import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Consumer;
import org.pendant.kit.background.Background;

/** Other program of the computer: opens what the window does not. */
public final class OtherProgram {
  private OtherProgram() {}

  /** What is to be opened. */
  interface Opening {
    void run() throws IOException;
  }

  /** Opens a page of HTML in the browser. */
  public static void openPage(Path page, Consumer<String> tell) {
    open(page.toString(), () -> Desktop.getDesktop().browse(page.toUri()), tell);
  }

  /** Where nothing opens it, the clipboard has it. */
  static void open(String what, Opening opening, Consumer<String> tell) {
    Background.run(
        () -> {
          if (!Desktop.isDesktopSupported()) {
            throw new IOException(text("noProgramOfThisComputerOpens"));
          }
          try {
            opening.run();
          } catch (IllegalArgumentException | UnsupportedOperationException e) {
            throw new IOException(e.getMessage(), e);
          }
          return what;
        },
        opened -> tell.accept(text("opened", opened)),
        failed -> {
          Toolkit.getDefaultToolkit()
              .getSystemClipboard()
              .setContents(new StringSelection(what), null);
          tell.accept(text("wasCopiedToTheClipboard", what, failed.getMessage()));
        });
  }
}
