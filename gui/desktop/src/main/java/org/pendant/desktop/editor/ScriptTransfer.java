package org.pendant.desktop.editor;

import java.awt.datatransfer.DataFlavor;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JRootPane;
import javax.swing.SwingUtilities;
import javax.swing.TransferHandler;
import org.fife.ui.rtextarea.RTATextTransferHandler;

/**
 * Script transfer: takes text that is dropped or pasted into a script, and leaves files that are
 * dropped on it to the window, which opens them. A text would take their addresses.
 */
@SuppressWarnings("serial") // never written to a stream
final class ScriptTransfer extends RTATextTransferHandler {
  @Override
  public boolean canImport(TransferSupport support) {
    Optional<TransferHandler> window = window(support, support.isDrop());
    return window.isPresent() ? window.get().canImport(support) : super.canImport(support);
  }

  @Override
  public boolean importData(TransferSupport support) {
    Optional<TransferHandler> window = window(support, support.isDrop());
    return window.isPresent() ? window.get().importData(support) : super.importData(support);
  }

  /**
   * The handler of the window that takes what comes; empty where the text takes it.
   *
   * @param dropped whether it is dropped rather than pasted
   */
  static Optional<TransferHandler> window(TransferSupport support, boolean dropped) {
    if (!dropped || !support.isDataFlavorSupported(DataFlavor.javaFileListFlavor)) {
      return Optional.empty();
    }
    JRootPane root = SwingUtilities.getRootPane(support.getComponent());
    return Optional.ofNullable(root).map(JComponent::getTransferHandler);
  }
}
