package org.pendant.desktop.editor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.io.File;
import java.util.List;
import java.util.Optional;
import javax.swing.JRootPane;
import javax.swing.TransferHandler;
import javax.swing.TransferHandler.TransferSupport;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.desktop.editor.text.LineColours;

final class ScriptTransferTest {
  private final JRootPane window = new JRootPane();
  private final TransferHandler files = new TransferHandler("files");
  private final ScriptArea script =
      new ScriptArea(new LineColours(StandardBuiltins.create()), Optional::empty, stroke -> false);

  /** A file as file managers offer it: as a list, and as a text with its address. */
  private record OfferedFile() implements Transferable {
    @Override
    public DataFlavor[] getTransferDataFlavors() {
      return new DataFlavor[] {DataFlavor.javaFileListFlavor, DataFlavor.stringFlavor};
    }

    @Override
    public boolean isDataFlavorSupported(DataFlavor flavor) {
      return List.of(getTransferDataFlavors()).contains(flavor);
    }

    @Override
    public Object getTransferData(DataFlavor flavor) {
      return flavor.equals(DataFlavor.javaFileListFlavor)
          ? List.of(new File("/programs/weld.script"))
          : "file:///programs/weld.script";
    }
  }

  @BeforeEach
  void putIntoAWindow() {
    window.setTransferHandler(files);
    window.getContentPane().add(script);
  }

  private Optional<TransferHandler> taker(Transferable offer, boolean dropped) {
    return ScriptTransfer.window(new TransferSupport(script, offer), dropped);
  }

  @Test
  void filesThatAreDroppedOnTheScriptAreForTheWindow() {
    assertEquals(Optional.of(files), taker(new OfferedFile(), true));
  }

  @Test
  void textThatIsDroppedOnTheScriptIsForTheScript() {
    assertEquals(Optional.empty(), taker(new StringSelection("movej"), true));
  }

  @Test
  void whatIsPastedIsForTheScript() {
    assertEquals(Optional.empty(), taker(new OfferedFile(), false));
    assertTrue(
        script
            .getTransferHandler()
            .importData(new TransferSupport(script, new StringSelection("halt"))));
    assertEquals("halt", script.getText());
  }
}
