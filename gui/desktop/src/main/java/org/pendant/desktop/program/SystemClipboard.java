package org.pendant.desktop.program;

import java.awt.Toolkit;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.IOException;

/** System clipboard, which all programs share. */
final class SystemClipboard implements TreeCommands.Clipboard {
  @Override
  public String get() {
    try {
      return (String)
          Toolkit.getDefaultToolkit().getSystemClipboard().getData(DataFlavor.stringFlavor);
    } catch (UnsupportedFlavorException | IOException | IllegalStateException e) {
      // There is no text, or another program holds on to it: nothing can be pasted.
      return "";
    }
  }

  @Override
  public void put(String wanted) {
    Toolkit.getDefaultToolkit().getSystemClipboard().setContents(new StringSelection(wanted), null);
  }
}
