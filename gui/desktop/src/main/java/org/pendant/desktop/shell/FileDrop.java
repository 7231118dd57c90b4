package org.pendant.desktop.shell;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.TransferHandler;

/** File drop: takes files that people drag onto the window. */
@SuppressWarnings("serial") // never written to a stream
final class FileDrop extends TransferHandler {
  private final transient Consumer<Path> open;

  FileDrop(Consumer<Path> open) {
    this.open = open;
  }

  @Override
  public boolean canImport(TransferSupport support) {
    return support.isDrop() && support.isDataFlavorSupported(DataFlavor.javaFileListFlavor);
  }

  @Override
  public boolean importData(TransferSupport support) {
    if (!canImport(support)) {
      return false;
    }
    try {
      Object dropped = support.getTransferable().getTransferData(DataFlavor.javaFileListFlavor);
      for (Object each : (List<?>) dropped) {
        open.accept(((File) each).toPath());
      }
      return true;
    } catch (UnsupportedFlavorException | IOException e) {
      // The program that offered the files has taken them back; the drop then shows as not taken.
      return false;
    }
  }
}
